/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "endResistances.H"

Foam::fsbi::endResistances::endResistances
(
    const fvMesh& mesh, const scalarList& resistances
)
{
    forAll(resistances, patchi)
    {
        const polyPatch& pp = mesh.boundaryMesh()[patchi];
        if (resistances[patchi] > 0)
        {
            ends_.append
            (
                end
                {
                    resistances[patchi],
                    labelRange(pp.start() - mesh.nInternalFaces(), pp.size())
                }
            );
        }
    }
    sums_.setSize(2*ends_.size());
}


void Foam::fsbi::endResistances::add
(
    const stokesOperator& stokes, scalar* r, vectorField& traction
) const
{
    if (ends_.empty())
    {
        return;
    }
    sums_ = Zero;
    forAll(ends_, e)
    {
        for (const label i : ends_[e].faces)
        {
            sums_[2*e] += stokes.boundaryFlux()[i];
            sums_[2*e + 1] += stokes.fluxPerPressure(i);
        }
    }
    reduce(sums_, sumOp<scalarList>());
    forAll(ends_, e)
    {
        const scalar R = ends_[e].resistance;
        const scalar p = R*sums_[2*e]/(1 - R*sums_[2*e + 1]);
        for (const label i : ends_[e].faces)
        {
            stokes.addPressure(i, p, r, traction[i]);
        }
    }
}
