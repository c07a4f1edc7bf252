/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "shapeDerivative.H"
#include "PstreamReduceOps.H"

namespace Foam
{
namespace fsbi
{

//- Sum over all processors
template<class Type>
static void sumAll(Field<Type>& values)
{
    Pstream::listCombineGather(values, plusEqOp<Type>());
    Pstream::listCombineScatter(values);
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::shapeDerivative::shapeDerivative
(
    const stokesOperator& stokes, const elasticRows& body
)
:
    stokes_(stokes),
    body_(body),
    corners_(body.fluid.faces.size()),
    faceGradients_(body.fluid.faces.size()),
    gradients_(body.fluid.nPoints, Zero),
    stresses_(body.fluid.nPoints, Zero)
{
    setCorners();
    const fvMesh& mesh = stokes_.stencil().mesh();
    const tensorField cells(stokes_.velocityGradients());
    const scalarField p(stokes_.boundaryPressure());
    scalarField shares(body_.fluid.nPoints, Zero);
    forAll(corners_, i)
    {
        const label facei = body_.fluid.faces[i];
        const label P = mesh.faceOwner()[mesh.nInternalFaces() + facei];
        const tensor& grad = cells[P];
        faceGradients_[i] = grad;
        for (const label number : corners_[i])
        {
            gradients_[number] += grad;
            stresses_[number] +=
                2*stokes_.viscosity(P)*symm(grad) - p[facei]*symmTensor::I;
            shares[number] += 1;
        }
    }
    sumAll(gradients_);
    sumAll(stresses_);
    sumAll(shares);
    // none of a body that is not in the domain
    shares = max(shares, scalar(1));
    gradients_ /= shares;
    stresses_ /= shares;
}


void Foam::fsbi::shapeDerivative::setCorners()
{
    const surfaceSide& side = body_.fluid;
    Map<label> numbers(2*side.points.size());
    forAll(side.points, i)
    {
        numbers.insert
        (
            stokes_.wallVertices()[side.points[i]], side.pointNumbers[i]
        );
    }
    const fvMesh& mesh = stokes_.stencil().mesh();
    forAll(corners_, i)
    {
        const face& f = mesh.faces()[mesh.nInternalFaces() + side.faces[i]];
        forAll(corners_[i], k)
        {
            corners_[i][k] = numbers[f[k]];
        }
    }
}


void Foam::fsbi::shapeDerivative::addVelocity
(
    const surfaceDisplacement& d, boundaryValues& values
) const
{
    const surfaceSide& side = body_.fluid;
    forAll(side.faces, i)
    {
        values.faces[side.faces[i]] -=
            d.faces[side.faceNumbers[i]] & faceGradients_[i];
    }
    forAll(side.points, i)
    {
        const label number = side.pointNumbers[i];
        values.vertices[side.points[i]] -=
            d.points[number] & gradients_[number];
    }
    stokes_.setOnEdges(body_.fluidPatch, values.vertices);
}


void Foam::fsbi::shapeDerivative::addTraction
(
    const surfaceDisplacement& d, vectorField& traction
) const
{
    const fvMesh& mesh = stokes_.stencil().mesh();
    forAll(corners_, i)
    {
        const label facei = body_.fluid.faces[i];
        const face& f = mesh.faces()[mesh.nInternalFaces() + facei];
        forAll(corners_[i], k)
        {
            const label a = corners_[i][k];
            const label b = corners_[i][corners_[i].fcIndex(k)];
            const vector edge(mesh.points()[f.nextLabel(k)] - mesh.points()[f[k]]);
            traction[facei] +=
                0.25*(stresses_[a] + stresses_[b])
              & ((d.points[a] + d.points[b]) ^ edge);
        }
    }
}
