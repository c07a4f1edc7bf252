/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "exactConditions.H"
#include "profileFvPatchVectorField.H"
#include "loadFvPatchVectorField.H"
#include "addToRunTimeSelectionTable.H"
#include "fvMesh.H"
#include "triPointRef.H"

namespace Foam
{
namespace fsbi
{

static std::shared_ptr<const exactSolution> solutionOf(const fvPatch& patch)
{
    return std::shared_ptr<const exactSolution>
    (
        exactSolution::New(patch.boundaryMesh().mesh()).ptr()
    );
}


//- Integral of P.N over a triangle
static vector force
(
    const exactSolution& solution,
    const scalar time,
    const triPointRef& triangle
)
{
    const point corner[3] = {triangle.a(), triangle.b(), triangle.c()};
    const point sum(corner[0] + corner[1] + corner[2]);
    tensor P(Zero);
    for (const point& x : corner)
    {
        P += solution.stress((sum + 3*x)/6, time)/3;
    }
    return P & triangle.areaNormal();
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::exactDisplacement::exactDisplacement
(
    const checkedDictionary&, const fvPatch& patch
)
:
    solution_(solutionOf(patch))
{}


Foam::fsbi::exactTraction::exactTraction
(
    const checkedDictionary&, const fvPatch& patch
)
:
    solution_(solutionOf(patch))
{}


Foam::tmp<Foam::vectorField> Foam::fsbi::exactTraction::dead
(
    const fvPatch& patch, const scalar time
) const
{
    const pointField& points = patch.patch().points();
    const vectorField& centres = patch.patch().faceCentres();
    const scalarField& areas = patch.magSf();
    auto t = tmp<vectorField>::New(patch.size(), Zero);
    forAll(t(), facei)
    {
        const face& f = patch.patch()[facei];
        vector& total = t.ref()[facei];
        if (f.size() == 3)
        {
            total = force
            (
                *solution_, time,
                triPointRef(points[f[0]], points[f[1]], points[f[2]])
            );
        }
        else
        {
            forAll(f, i)
            {
                total += force
                (
                    *solution_, time,
                    triPointRef
                    (
                        points[f[i]], points[f.nextLabel(i)], centres[facei]
                    )
                );
            }
        }
        total /= areas[facei];
    }
    return t;
}


namespace Foam
{
namespace fsbi
{

typedef profileFvPatchVectorField<exactDisplacement>
    exactDisplacementFvPatchVectorField;
typedef loadFvPatchVectorField<exactTraction>
    exactTractionFvPatchVectorField;

defineTemplateTypeNameAndDebugWithName
(
    exactDisplacementFvPatchVectorField,
    Foam::fsbi::exactDisplacement::name,
    0
);
defineTemplateTypeNameAndDebugWithName
(
    exactTractionFvPatchVectorField, Foam::fsbi::exactTraction::name, 0
);

addToPatchFieldRunTimeSelection
(
    fvPatchVectorField, exactDisplacementFvPatchVectorField
)
addToPatchFieldRunTimeSelection
(
    fvPatchVectorField, exactTractionFvPatchVectorField
)

} // End namespace fsbi
} // End namespace Foam
