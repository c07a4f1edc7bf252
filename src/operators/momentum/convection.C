/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "convection.H"

#include <cmath>

namespace Foam
{
namespace fsbi
{

//- Below this Peclet number series are as good as the functions, and do not
//  lose digits
static const scalar smallPeclet = 0.05;

//- Viscosity's flux per velocity between the cells of every inner face,
//  mu |S|/|d| [M/T], by faces of the mesh; zero on the boundary
static scalarField links(const stokesOperator& viscous)
{
    const meshStencil& stencil = viscous.stencil();
    const labelList faces(stencil.meshFaces());
    scalarField result(stencil.mesh().nFaces(), Zero);
    forAll(faces, i)
    {
        const faceGradient face
        (
            stencil.area()[i], stencil.fromOwner()[i],
            stencil.fromNeighbour()[i]
        );
        result[faces[i]] = viscous.mu()*face.compact();
    }
    return result;
}

} // End namespace fsbi
} // End namespace Foam


Foam::scalar Foam::fsbi::convection::upwinding(const scalar Peclet)
{
    return
        mag(Peclet) < smallPeclet
      ? sqr(Peclet)/6*(1 - sqr(Peclet)/60)
      : Peclet/std::tanh(Peclet/2) - 2;
}


Foam::scalar Foam::fsbi::convection::upwindingSlope(const scalar Peclet)
{
    if (mag(Peclet) < smallPeclet)
    {
        return Peclet/3*(1 - sqr(Peclet)/30);
    }
    // beyond, sinh is large enough to overflow, and its part nothing
    const scalar half = max(min(Peclet/2, 300), -300);
    return 1/std::tanh(half) - half/sqr(std::sinh(half));
}


void Foam::fsbi::convection::addOut
(
    const fvMesh& mesh, const vectorField& through, scalar* r
)
{
    const auto add = [r](const label celli, const vector& momentum)
    {
        r[4*celli] += momentum.x();
        r[4*celli + 1] += momentum.y();
        r[4*celli + 2] += momentum.z();
    };
    forAll(through, facei)
    {
        add(mesh.faceOwner()[facei], through[facei]);
        if (mesh.isInternalFace(facei))
        {
            add(mesh.faceNeighbour()[facei], -through[facei]);
        }
    }
}


void Foam::fsbi::convection::add
(
    const stokesOperator& viscous,
    const boundaryValues& given,
    const scalarField& ofMesh,
    scalar* r
) const
{
    const faceVelocities on(viscous.onFaces(given));
    massFlux_ = density_*on.flux;
    if (ofMesh.size())
    {
        massFlux_ += ofMesh;
    }
    const scalarField link(links(viscous));
    upwinding_.setSize(link.size());
    carried_ = on.mean;
    forAll(link, facei)
    {
        const scalar Pe = link[facei] ? massFlux_[facei]/link[facei] : 0;
        upwinding_[facei] = link[facei]*upwinding(Pe);
        carried_[facei] += upwindingSlope(Pe)*on.jump[facei];
    }
    addOut
    (
        viscous.stencil().mesh(), massFlux_*on.mean + upwinding_*on.jump, r
    );
}


void Foam::fsbi::convection::addChanges
(
    const stokesOperator& viscous, const boundaryValues& given, scalar* r
) const
{
    const faceVelocities on(viscous.onFaces(given));
    addOut
    (
        viscous.stencil().mesh(),
        massFlux_*on.mean + upwinding_*on.jump + density_*on.flux*carried_,
        r
    );
}
