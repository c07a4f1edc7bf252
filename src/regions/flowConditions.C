/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "flowConditions.H"
#include "startField.H"
#include "tractionCondition.H"
#include "wallPolyPatch.H"
#include "IStringStream.H"
#include "OStringStream.H"

namespace Foam
{
namespace fsbi
{

//- Deviation of normals or velocities of a patch that is round-off
static const scalar roundOff = 1e-6;

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::flowConditions::flowConditions
(
    const Time& time,
    const fluidMesh& mesh
)
:
    time_(time),
    mesh_(mesh)
{}


void Foam::fsbi::flowConditions::read()
{
    dictionary dict(startField(time_, mesh_.name(), "U", dimVelocity));
    checkPatches(dict, mesh_.mesh());
    checkBodies(dict.subDict("boundaryField"));

    // values of an earlier mesh, where the condition knows better
    for (entry& e : dict.subDict("boundaryField"))
    {
        const entry* value =
            e.isDict() ? e.dict().findEntry("value") : nullptr;
        if
        (
            value && value->isStream()
         && value->stream().size()
         && value->stream()[0] == token(word("nonuniform"))
         && e.dict().getOrDefault<word>("type", "") != "fixedValue"
        )
        {
            e.dict().remove("value");
        }
    }
    conditions_ = dict;
}


void Foam::fsbi::flowConditions::checkBodies(const dictionary& patches) const
{
    for (const word& name : namesOf(mesh_.bodies()))
    {
        const entry* e = patches.findEntry(name, keyType::LITERAL);
        if (!e)
        {
            continue;
        }
        // as a state at time 0 has it
        const dictionary& given = e->isDict() ? e->dict() : dictionary::null;
        const entry* value = given.findEntry("value");
        const bool ours =
            given.getOrDefault<word>("type", "")
         == fixedValueFvPatchVectorField::typeName
         && value && value->isStream() && value->stream().size()
         && (
                value->stream()[0] == token(word("nonuniform"))
             || vectorField("value", given, 1)[0] == vector(Zero)
            );
        if (!ours)
        {
            FatalIOErrorInFunction(patches)
                << "Patch '" << name << "' is the surface of a body, whose"
                << " velocity is that of its motion (constant/bodies): remove"
                << " its entry" << exit(FatalIOError);
        }
    }
}


Foam::vector Foam::fsbi::flowConditions::startVelocity() const
{
    ITstream& is = conditions_.lookup("internalField");
    return word(is) == "uniform" ? vector(is) : vector::zero;
}


void Foam::fsbi::flowConditions::keep
(
    const volVectorField& U, const vector& startVelocity
)
{
    dictionary patches;
    for (const fvPatchVectorField& pf : U.boundaryField())
    {
        if (pf.coupled() || mesh_.isBody(pf.patch().name()))
        {
            continue;
        }
        OStringStream os;
        os.precision(17);
        pf.write(os);
        dictionary entry(IStringStream(os.str())());
        entry.remove("value");
        if (pf.type() == fixedValueFvPatchVectorField::typeName)
        {
            // a plain value lasts through remeshing where it is uniform, to
            // the last bit: an average would not
            const vector least(gMin(pf)), most(gMax(pf));
            OStringStream value;
            value.precision(17);
            value << "value uniform "
                << (least == most ? least : gAverage(pf)) << ";";
            entry.read(IStringStream(value.str())(), false);
        }
        patches.set(pf.patch().name(), entry);
    }
    OStringStream start;
    start.precision(17);
    start << "dimensions [0 1 -1 0 0 0 0]; internalField uniform "
        << startVelocity << ";";
    dictionary dict(IStringStream(start.str())());
    dict.set("boundaryField", patches);
    conditions_ = dict;
}


Foam::dictionary Foam::fsbi::flowConditions::fieldDictionary() const
{
    dictionary dict(conditions_);
    addMeshPatches(dict.subDict("boundaryField"));
    return dict;
}


void Foam::fsbi::flowConditions::addMeshPatches(dictionary& patches) const
{
    for (const polyPatch& pp : mesh_.mesh().boundaryMesh())
    {
        const bool body = mesh_.isBody(pp.name());
        if (body || pp.coupled())
        {
            setPatch
            (
                patches, pp.name(), body ? word("fixedValue") : pp.type()
            );
        }
    }
}


void Foam::fsbi::flowConditions::check(const volVectorField& U)
{
    for (const fvPatchVectorField& pf : U.boundaryField())
    {
        if (!pf.fixesValue() && !pf.coupled())
        {
            FatalErrorInFunction
                << "Patch '" << pf.patch().name() << "' of field U in region "
                << U.mesh().name() << " has the boundary condition '"
                << pf.type()
                << "'; give a velocity (fixedValue, uniformFixedValue,"
                << " linearShear, linearFlow, Poiseuille, developedFlow,"
                << " StokesSphere), 'traction' or"
                << " 'cyclic'" << exit(FatalError);
        }
    }
}


Foam::boolList Foam::fsbi::flowConditions::velocityGiven
(
    const volVectorField& U
) const
{
    check(U);
    boolList given(mesh_.mesh().nFaces() - mesh_.mesh().nInternalFaces(), false);
    bool any = false;
    for (const fvPatchVectorField& pf : U.boundaryField())
    {
        const fvPatch& patch = pf.patch();
        const label start = patch.start() - mesh_.mesh().nInternalFaces();
        if (!patch.coupled() && !isA<tractionCondition>(pf))
        {
            any = true;
            SubList<bool>(given, patch.size(), start) = true;
        }
    }
    if (!any)
    {
        FatalErrorInFunction
            << "No patch of field U in region " << mesh_.name()
            << " gives a velocity: the flow is not determined"
            << exit(FatalError);
    }
    return given;
}


Foam::scalarList Foam::fsbi::flowConditions::resistances
(
    const volVectorField& U
) const
{
    scalarList found(mesh_.mesh().boundaryMesh().nNonProcessor(), Zero);
    forAll(found, patchi)
    {
        const fvPatchVectorField& pf = U.boundaryField()[patchi];
        if (isA<tractionCondition>(pf))
        {
            found[patchi] =
                refCast<const tractionCondition>(pf).resistance();
        }
    }
    return found;
}


Foam::string Foam::fsbi::flowConditions::asWall
(
    const fvPatchVectorField& pf, domainWall& wall
) const
{
    const scalar area = gSum(pf.patch().magSf());
    const vector S(gSum(pf.patch().Sf()));
    const vector u(gSum(vectorField(pf.patch().magSf()*pf))/area);
    const scalar fastest = gMax(mag(pf)());
    const scalar uneven = gMax(mag(pf - u)());
    wall =
    {
        pf.patch().name(),
        gSum(vectorField(pf.patch().magSf()*pf.patch().Cf()))/area,
        -S/max(mag(S), VSMALL), u
    };
    if (isA<tractionCondition>(pf))
    {
        return "its traction is given";
    }
    if (mag(S) <= (1 - roundOff)*area)
    {
        if (fastest > 0 || !isA<wallPolyPatch>(pf.patch().patch()))
        {
            return
                fastest > 0
              ? "not plane, and its velocity in 0/fluid/U is not zero"
              : "not plane, and not of type wall";
        }
        wall.facets = mesh_.facets(wall.name);
        wall.follows = mesh_.follows();
        wall.shift = mesh_.shift();
        return "";
    }
    if (mag(u & S) > roundOff*fastest*area)
    {
        return "fluid passes through it";
    }
    return uneven > roundOff*fastest ? "its velocity in 0/fluid/U varies" : "";
}


template<class Visitor>
void Foam::fsbi::flowConditions::visitOutside
(
    const volVectorField& U, const Visitor& visitor
) const
{
    for (const fvPatchVectorField& pf : U.boundaryField())
    {
        if
        (
            !pf.coupled() && !mesh_.isBody(pf.patch().name())
         && gSum(pf.patch().magSf())
        )
        {
            domainWall wall;
            const string why(asWall(pf, wall));
            visitor(wall, why);
        }
    }
}


Foam::List<Foam::fsbi::domainWall> Foam::fsbi::flowConditions::walls
(
    const volVectorField& U
) const
{
    DynamicList<domainWall> found;
    visitOutside(U, [&](const domainWall& wall, const string& why)
    {
        if (why.empty())
        {
            found.append(wall);
        }
    });
    return List<domainWall>(found);
}


Foam::wordList Foam::fsbi::flowConditions::open(const volVectorField& U) const
{
    // reduced once: processes do not have the same number of patches
    scalar fastest = 0;
    for (const fvPatchVectorField& pf : U.boundaryField())
    {
        for (const vector& u : pf)
        {
            fastest = max(fastest, mag(u));
        }
    }
    reduce(fastest, maxOp<scalar>());
    DynamicList<word> found;
    for (const fvPatchVectorField& pf : U.boundaryField())
    {
        const word& name = pf.patch().name();
        if (pf.coupled() || mesh_.isBody(name))
        {
            continue;
        }
        const scalar through = gMax(mag(pf & pf.patch().nf())());
        if
        (
            isA<tractionCondition>(pf)
         || (fastest > 0 && through > roundOff*fastest)
        )
        {
            found.append(name);
        }
    }
    return wordList(std::move(found));
}


Foam::wordList Foam::fsbi::flowConditions::ends(const volVectorField& U) const
{
    DynamicList<word> found;
    for (const fvPatchVectorField& pf : U.boundaryField())
    {
        const word& name = pf.patch().name();
        if
        (
            !pf.coupled() && !mesh_.isBody(name)
         && (
                isA<tractionCondition>(pf)
             || !isA<wallPolyPatch>(pf.patch().patch())
            )
        )
        {
            found.append(name);
        }
    }
    return wordList(std::move(found));
}


Foam::List<Foam::fsbi::unseenPatch> Foam::fsbi::flowConditions::unseen
(
    const volVectorField& U
) const
{
    DynamicList<unseenPatch> found;
    visitOutside(U, [&](const domainWall& wall, const string& why)
    {
        if (why.size())
        {
            found.append({wall.name, why});
        }
    });
    return List<unseenPatch>(found);
}
