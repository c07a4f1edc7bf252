/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "pointJacobi.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{

defineTypeNameAndDebug(pointJacobi, 0);
addToRunTimeSelectionTable(coupledPreconditioner, pointJacobi, coupledSystem);

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::pointJacobi::pointJacobi(const coupledSystem& system)
:
    coupledPreconditioner(system),
    rows_(system.layout().nDistributed())
{
    if (!system.linear())
    {
        FatalErrorInFunction
            << "Preconditioner 'pointJacobi' is not for elastic bodies; take"
            << " 'blockTriangular'" << exit(FatalError);
    }
}


void Foam::fsbi::pointJacobi::apply(const scalar* r, scalar* z) const
{
    const stokesOperator& stokes = system_.momentum().viscous();
    const scalarField& V = stokes.stencil().mesh().cellVolumes();
    system_.scales().undo(r, rows_.begin());
    forAll(V, i)
    {
        std::copy_n(r + 4*i, 3, z + 4*i);
        z[4*i + 3] = stokes.mu()*rows_[4*i + 3]/V[i];
    }

    // torques stand in the rows as velocities at the surface
    systemLayout::whole bodies(system_.layout().read(r));
    forAll(bodies.velocities, b)
    {
        for (label k = 3; k < 6; ++k)
        {
            bodies.velocities[b][k] /= system_.bodies()[b].radius;
        }
    }
    system_.layout().write(bodies, z);
}
