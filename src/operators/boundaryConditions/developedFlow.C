/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "developedFlow.H"
#include "profileFvPatchVectorField.H"
#include "addToRunTimeSelectionTable.H"
#include "volFields.H"

namespace Foam
{
namespace fsbi
{

//- Part of its area by which a plane patch may be smaller seen from the front
static const scalar unevenness = 1e-6;

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::developedFlow::developedFlow
(
    const checkedDictionary& dict, const fvPatch& patch
)
:
    rate_(dict, "flowRate")
{
    setDirections(patch);
    List<List<ductProfile::triangle>> all(Pstream::nProcs());
    DynamicList<ductProfile::triangle> own;
    for (const face& f : patch.patch())
    {
        for (label i = 1; i + 1 < f.size(); ++i)
        {
            ductProfile::triangle t;
            t[0] = inPlane(patch.patch().points()[f[0]]);
            t[1] = inPlane(patch.patch().points()[f[i]]);
            t[2] = inPlane(patch.patch().points()[f[i + 1]]);
            own.append(t);
        }
    }
    all[Pstream::myProcNo()].transfer(own);
    Pstream::gatherList(all);
    Pstream::scatterList(all);
    DynamicList<ductProfile::triangle> triangles;
    for (const auto& part : all)
    {
        triangles.append(part);
    }
    profile_ = std::make_shared<const ductProfile>(triangles);
    if (!(profile_->flow() > 0))
    {
        FatalIOErrorInFunction(dict.dict())
            << "Patch '" << patch.name() << "' is too coarse for a profile: all"
            << " its vertices are on its rim; make it of more faces"
            << exit(FatalIOError);
    }
}


void Foam::fsbi::developedFlow::setDirections(const fvPatch& patch)
{
    const vector S(gSum(patch.Sf()));
    const scalar area = gSum(patch.magSf());
    if (!(mag(S) > (1 - unevenness)*area))
    {
        FatalErrorInFunction
            << "Patch '" << patch.name() << "' of field U is not plane: its area"
            << " is " << area << ", seen from the front " << mag(S) << ". Only"
            << " plane patches can have 'developedFlow'; give 'traction'"
            << exit(FatalError);
    }
    normal_ = -S/mag(S);
    const vector other
    (
        mag(normal_.x()) < 0.6 ? vector(1, 0, 0) : vector(0, 1, 0)
    );
    first_ = normal_ ^ other;
    first_ /= mag(first_);
    second_ = normal_ ^ first_;
}


Foam::vector Foam::fsbi::developedFlow::operator()
(
    const point& x, const scalar time
) const
{
    return rate_.value(time)/profile_->flow()*(*profile_)(inPlane(x))*normal_;
}


Foam::tmp<Foam::vectorField> Foam::fsbi::developedFlow::onFaces
(
    const fvPatch& patch, const scalar time
) const
{
    auto u = tmp<vectorField>::New(patch.size());
    forAll(u.ref(), i)
    {
        u.ref()[i] = (*profile_)(inPlane(patch.Cf()[i]))*normal_;
    }
    // the rule of the centres is of second order only
    u.ref() *= -rate_.value(time)/gSum(u() & patch.Sf());
    return u;
}


void Foam::fsbi::developedFlow::write(Ostream& os) const
{
    rate_.write(os);
}


namespace Foam
{
namespace fsbi
{

typedef profileFvPatchVectorField<developedFlow>
    developedFlowFvPatchVectorField;

defineTemplateTypeNameAndDebugWithName
(
    developedFlowFvPatchVectorField, Foam::fsbi::developedFlow::name, 0
);

addToPatchFieldRunTimeSelection
(
    fvPatchVectorField, developedFlowFvPatchVectorField
)

} // End namespace fsbi
} // End namespace Foam
