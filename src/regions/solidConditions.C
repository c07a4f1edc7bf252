/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidConditions.H"
#include "startField.H"
#include "IStringStream.H"
#include "supports.H"
#include "tractionCondition.H"
#include "symmetryFvPatchFields.H"
#include "symmetryPlaneFvPatchFields.H"

Foam::fsbi::solidConditions::solidConditions
(
    fvMesh& mesh,
    volVectorField& D,
    const pointField& reference
)
:
    mesh_(mesh),
    D_(D),
    reference_(reference)
{
    const label n = mesh.nFaces() - mesh.nInternalFaces();
    given_.kinds.setSize(n, solidBoundary::coupled);
    given_.faces.setSize(n, Zero);
    given_.follower.setSize(n, Zero);
    given_.pressure.setSize(n, Zero);
    setKinds();
}


Foam::dictionary Foam::fsbi::solidConditions::fieldDictionary
(
    const fvMesh& mesh, const bool optional
)
{
    dictionary dict
    (
        optional && !hasStartField(mesh.time(), mesh.name(), "D")
      ? dictionary
        (
            IStringStream
            (
                "dimensions [0 1 0 0 0 0 0]; internalField uniform (0 0 0);"
                "boundaryField"
                "{ \".*\" { type traction; value uniform (0 0 0); } }"
            )()
        )
      : startField(mesh.time(), mesh.name(), "D", dimLength)
    );
    checkPatches(dict, mesh);
    dictionary& patches = dict.subDict("boundaryField");
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (pp.coupled())
        {
            setPatch(patches, pp.name(), pp.type());
        }
    }
    return dict;
}


Foam::fsbi::solidBoundary::kind Foam::fsbi::solidConditions::kindOf
(
    const fvPatchVectorField& pf
)
{
    if (pf.coupled())
    {
        return solidBoundary::coupled;
    }
    if (const auto* load = isA<tractionCondition>(pf))
    {
        if (load->resistance())
        {
            FatalErrorInFunction
                << "Patch '" << pf.patch().name() << "' of field D of body '"
                << pf.patch().boundaryMesh().mesh().name() << "' has the entry"
                << " 'resistance': nothing flows out of a solid. Give a"
                << " 'pressure'" << exit(FatalError);
        }
        return solidBoundary::traction;
    }
    if
    (
        isA<symmetryFvPatchVectorField>(pf)
     || isA<symmetryPlaneFvPatchVectorField>(pf)
    )
    {
        return solidBoundary::symmetry;
    }
    if (!pf.fixesValue())
    {
        FatalErrorInFunction
            << "Patch '" << pf.patch().name() << "' of field D of body '"
            << pf.patch().boundaryMesh().mesh().name() << "' has the boundary"
            << " condition '" << pf.type() << "'; give a displacement"
            << " (fixedValue, uniformFixedValue, prescribedRotation), a force"
            << " ('traction', without entries a free surface; 'patchForce'),"
            << " 'symmetryPlane' or 'cyclic'" << exit(FatalError);
    }
    return solidBoundary::displacement;
}


Foam::label Foam::fsbi::solidConditions::startOf
(
    const fvPatchVectorField& pf
) const
{
    return pf.patch().start() - mesh_.nInternalFaces();
}


void Foam::fsbi::solidConditions::setKinds()
{
    for (const fvPatchVectorField& pf : D_.boundaryField())
    {
        const solidBoundary::kind kind = kindOf(pf);
        for (label i = 0; i < pf.size(); ++i)
        {
            given_.kinds[startOf(pf) + i] = kind;
        }
    }
}


void Foam::fsbi::solidConditions::collect()
{
    // not updateCoeffs(): that does nothing the second time, at a later time
    D_.boundaryFieldRef().evaluate();
    for (const fvPatchVectorField& pf : D_.boundaryField())
    {
        SubField<vector> faces(given_.faces, pf.size(), startOf(pf));
        const solidBoundary::kind kind = kindOf(pf);
        if (kind == solidBoundary::displacement)
        {
            faces = pf;
        }
        else if (kind == solidBoundary::traction)
        {
            const auto& load = refCast<const tractionCondition>(pf);
            faces = load.dead();
            SubField<vector>(given_.follower, pf.size(), startOf(pf)) =
                load.follower();
            SubField<scalar>(given_.pressure, pf.size(), startOf(pf)) =
                load.pressure();
        }
    }
    forAll(held_, i)
    {
        if (held_[i])
        {
            given_.faces[i] = heldAt_[i];
            given_.follower[i] = Zero;
            given_.pressure[i] = 0;
        }
    }
}


void Foam::fsbi::solidConditions::hold
(
    const boolList& faces, const vectorField& displacement
)
{
    held_ = faces;
    heldAt_ = displacement;
    forAll(held_, i)
    {
        if (held_[i])
        {
            given_.kinds[i] = solidBoundary::displacement;
        }
    }
}


void Foam::fsbi::solidConditions::addForce(const vectorField& force)
{
    forAll(force, i)
    {
        if (given_.kinds[i] == solidBoundary::traction)
        {
            given_.faces[i] +=
                force[i]/mag(mesh_.faceAreas()[mesh_.nInternalFaces() + i]);
        }
    }
}


void Foam::fsbi::solidConditions::evaluate(const vectorField& moved)
{
    if (reference_.empty())
    {
        collect();
        return;
    }
    const pointField now(mesh_.points());
    const label first = mesh_.nInternalFaces();
    mesh_.movePoints(reference_);
    collect();
    forAll(given_.kinds, i)
    {
        if (given_.kinds[i] == solidBoundary::traction)
        {
            given_.faces[i] *= mag(mesh_.faceAreas()[first + i]);
        }
    }
    mesh_.movePoints(now);
    forAll(given_.kinds, i)
    {
        if (given_.kinds[i] == solidBoundary::traction)
        {
            given_.faces[i] /= mag(mesh_.faceAreas()[first + i]);
        }
        else if (given_.kinds[i] == solidBoundary::displacement)
        {
            given_.faces[i] -= moved[i];
        }
    }
    mesh_.moving(false);
}


void Foam::fsbi::solidConditions::checkSupports() const
{
    supports held(mesh_.bounds());
    forAll(given_.kinds, i)
    {
        const label facei = mesh_.nInternalFaces() + i;
        if (given_.kinds[i] == solidBoundary::displacement)
        {
            for (const vector& axis : {vector(1, 0, 0), vector(0, 1, 0),
                vector(0, 0, 1)})
            {
                held.hold(mesh_.faceCentres()[facei], axis);
            }
        }
        else if (given_.kinds[i] == solidBoundary::symmetry)
        {
            const vector& S = mesh_.faceAreas()[facei];
            for (const label v : mesh_.faces()[facei])
            {
                held.hold(mesh_.points()[v], S/mag(S));
            }
        }
    }
    const auto motions(held.freeMotions());
    if (motions.size())
    {
        FatalErrorInFunction
            << "The supports of body '" << mesh_.name() << "' (patches with a"
            << " given displacement, planes of symmetry) leave it free to move"
            << " as a whole, which statics cannot answer: "
            << flatOutput(motions) << ". Hold a patch in 0/" << mesh_.name()
            << "/D, or take another scheme than steadyState"
            << exit(FatalError);
    }
}
