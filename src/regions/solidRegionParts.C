/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidRegion.H"

Foam::fsbi::materialParts Foam::fsbi::solidRegion::readParts()
{
    materialParts parts(material_());
    const dictionary& laws = materialEntries_.subOrEmptyDict("parts");
    const wordList& names = body_.parts().names();
    if (names.empty() && laws.empty())
    {
        return parts;
    }
    if (HashSet<word>(names) != HashSet<word>(laws.toc()))
    {
        FatalIOErrorInFunction(materialEntries_)
            << "Body '" << name() << "' has, in constant/bodies, the parts "
            << flatOutput(names) << ", but 'parts' has the materials of "
            << flatOutput(laws.toc()) << exit(FatalIOError);
    }
    for (const word& part : names)
    {
        partMaterials_.append(solidMaterial::New(laws.subDict(part)));
        parts.laws.append(&partMaterials_.last());
        checkPart(laws.subDict(part), partMaterials_.last());
    }
    parts.ofCells = body_.partsOf(mesh());
    fields_->setParts(parts.ofCells);
    return parts;
}


void Foam::fsbi::solidRegion::checkPart
(
    const dictionary& entries, const solidMaterial& law
) const
{
    if
    (
        order_ != 2
     || formulation_ != constitutiveState::formulation::totalLagrangian
    )
    {
        FatalIOErrorInFunction(entries)
            << "Body '" << name() << "' has parts, which want, in 'solid' of"
            << " system/" << name() << "/fvSolution, order 2 and formulation"
            << " totalLagrangian, as they are by default" << exit(FatalIOError);
    }
    if (law.flows() || law.linear() != material_->linear() || material_->flows())
    {
        FatalIOErrorInFunction(entries)
            << "Body '" << name() << "' is of " << material_->type()
            << ", its part of " << law.type() << ": no part may be of a liquid,"
            << " and all or none of linearElastic" << exit(FatalIOError);
    }
    if (entries.found("density"))
    {
        FatalIOErrorInFunction(entries)
            << "Entry 'density': the parts of body '" << name() << "' have the"
            << " density of the body; leave it out" << exit(FatalIOError);
    }
}


void Foam::fsbi::solidRegion::checkPressures
(
    const bool mixed, const materialParts& parts
) const
{
    for (const solidMaterial* law : parts.laws)
    {
        if (mixed && !(law->nu() > 0))
        {
            FatalIOErrorInFunction(materialEntries_)
                << "Body '" << name() << "' has a pressure of its own (mixed"
                << " yes, the default where a nu is 0.45 or more), which needs"
                << " nu above 0 in all its parts; one has " << law->nu()
                << exit(FatalIOError);
        }
    }
}


Foam::scalar Foam::fsbi::solidRegion::mostIncompressible() const
{
    scalar nu = material_->nu();
    for (const solidMaterial& law : partMaterials_)
    {
        nu = max(nu, law.nu());
    }
    return nu;
}


bool Foam::fsbi::solidRegion::viscous() const
{
    bool result = material_->viscosity() > 0;
    for (const solidMaterial& law : partMaterials_)
    {
        result = result || law.viscosity() > 0;
    }
    return result;
}
