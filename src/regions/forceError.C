/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "forceError.H"
#include "equivalentEllipsoid.H"

namespace Foam
{
namespace fsbi
{

//- Found by the drag of a sphere and of an ellipsoid in uniform flow, the stresslet
//  of a sphere in shear, forces on spheres a radius and a fifth of it from a wall
//  and each other, 23 meshes: 1.8 times the error, from 0.64 to 3.2 times it
static const scalar margin = 3;

//- What is added to the squares of the semi-axes, in squares of the radius: around
//  a sphere of radius 1, near reaches to 1.5
static const scalar around = 1.25;

//- The inside of an ellipsoid around a body
class surroundings
{
    point centre_;

    //- Inside: less than 1 for the square of a distance
    symmTensor perSquare_;

public:

    //- Without the axes' directions, which a sphere does not have
    explicit surroundings(const immersedBody& body)
    :
        centre_(body.meshedPlacement().centre)
    {
        const equivalentEllipsoid shape(body.meshedSurface());
        perSquare_ =
            inv(5*shape.moments + around*sqr(body.radius())*symmTensor::I);
    }

    bool contain(const point& x) const
    {
        const vector r(x - centre_);
        return (r & (perSquare_ & r)) < 1;
    }
};

} // End namespace fsbi
} // End namespace Foam


Foam::List<Foam::scalarList> Foam::fsbi::forceError::nearBodies
(
    const scalarField& power, const scalarField& dissipation
) const
{
    const UPtrList<immersedBody>& bodies = mesh_.bodies();
    const fvMesh& mesh = mesh_.mesh();
    List<scalarList> sums(bodies.size(), scalarList(3, Zero));
    forAll(bodies, b)
    {
        const surroundings near(bodies[b]);
        forAll(power, i)
        {
            if (bodies[b].present() && near.contain(mesh.cellCentres()[i]))
            {
                sums[b][0] += power[i];
                sums[b][1] += dissipation[i];
                sums[b][2] += mesh.cellVolumes()[i];
            }
        }
    }
    for (scalarList& sum : sums)
    {
        reduce(sum, sumOp<scalarList>());
    }
    return sums;
}


bool Foam::fsbi::forceError::expected(const stokesOperator& stokes) const
{
    return stokes.knowsDefects() && mesh_.bodies().size();
}


void Foam::fsbi::forceError::evaluate
(
    const stokesOperator& stokes, const tensorField& gradients
)
{
    if (!expected(stokes))
    {
        return;
    }
    const scalarField power(stokes.defectPower());
    const scalarField& V = mesh_.mesh().cellVolumes();
    const scalarField dissipation
    (
        2*stokes.mu()*magSqr(symm(gradients))*V
    );
    relative_ = 0;
    scalar perPower = 0;
    for (const scalarList& near : nearBodies(power, dissipation))
    {
        const scalar relative = margin*near[0]/max(near[1], VSMALL);
        if (relative > relative_)
        {
            relative_ = relative;
            perPower = margin*near[2]/near[1];
        }
    }
    setField(perPower*power/V);
}


void Foam::fsbi::forceError::setField(const scalarField& values)
{
    const fvMesh& mesh = mesh_.mesh();
    if (!field_)
    {
        field_.reset
        (
            new volScalarField
            (
                IOobject("forceError", mesh.time().timeName(), mesh),
                mesh, dimensionedScalar(dimless, Zero)
            )
        );
    }
    field_->primitiveFieldRef() = values;
    field_->instance() = mesh.time().timeName();
}
