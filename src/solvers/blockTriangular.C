/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "blockTriangular.H"
#include "addToRunTimeSelectionTable.H"
#include "bodyCoupling.H"
#include "mathematicalConstants.H"

namespace Foam
{
namespace fsbi
{

defineTypeNameAndDebug(blockTriangular, 0);
addToRunTimeSelectionTable
(
    coupledPreconditioner, blockTriangular, coupledSystem
);

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::blockTriangular::blockTriangular(const coupledSystem& system)
:
    coupledPreconditioner(system),
    cells_
    (
        system.momentum().viscous().stencil().mesh(), system.momentum(),
        system.elastic()
    ),
    rows_(system.layout().nDistributed())
{
    const stokesOperator& stokes = system.momentum().viscous();
    values_.faces.setSize(stokes.nBoundaryFaces());
    values_.vertices.setSize(stokes.wallPoints().size());
}


void Foam::fsbi::blockTriangular::relaxBodies(List<sixVector>& v) const
{
    // rows are scaled by the inverse of a crude diagonal: only torques, which
    // stand as velocities at the surface, change
    forAll(v, b)
    {
        for (label k = 3; k < 6; ++k)
        {
            v[b][k] /= system_.bodies()[b].radius;
        }
    }
    if (system_.effects())
    {
        system_.effects()->precondition(v);
    }
}


void Foam::fsbi::blockTriangular::addWalls(const UList<sixVector>& v) const
{
    const stokesOperator& stokes = system_.momentum().viscous();
    const fvMesh& mesh = stokes.stencil().mesh();
    setBodyVelocities(stokes, system_.bodies(), v, values_);
    for (const bodyRows& body : system_.bodies())
    {
        for (const label i : body.faces)
        {
            const label facei = mesh.nInternalFaces() + i;
            const scalar k = stokes.wallCoeff(i);
            const vector& u = values_.faces[i];
            scalar* row = rows_.begin() + 4*mesh.faceOwner()[facei];
            row[0] += k*u.x();
            row[1] += k*u.y();
            row[2] += k*u.z();
            row[3] -= u & mesh.faceAreas()[facei];
        }
    }
}


void Foam::fsbi::blockTriangular::relaxTethers(UList<vector>& tethers) const
{
    // a tether's residual is a velocity, which the drag of a sphere resists
    const scalar mu = system_.momentum().viscous().mu();
    forAll(tethers, e)
    {
        const elasticRows& body = *system_.elastic()[e];
        tethers[e] *= 6*constant::mathematical::pi*mu*body.radius;
        vector* row = system_.layout().displacement(e, rows_.begin());
        forAll(body.constraintWeight, i)
        {
            row[i] += body.constraintWeight[i]*tethers[e];
        }
    }
}


void Foam::fsbi::blockTriangular::apply(const scalar* r, scalar* z) const
{
    system_.scales().undo(r, rows_.begin());
    systemLayout::whole bodies(system_.layout().read(r));
    relaxBodies(bodies.velocities);
    addWalls(bodies.velocities);
    relaxTethers(bodies.tethers);
    cells_.apply(rows_.cdata(), z);
    system_.layout().write(bodies, z);
}
