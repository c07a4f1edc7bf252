/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "endResistances.H"
#include <algorithm>

Foam::fsbi::endResistances::endResistances
(
    const fvMesh& mesh, const scalarList& perFlux
)
:
    mesh_(mesh),
    perFlux_(perFlux),
    any_
    (
        std::any_of
        (
            perFlux.begin(), perFlux.end(), [](const scalar R) { return R > 0; }
        )
    )
{}


template<class Visitor>
void Foam::fsbi::endResistances::forFaces
(
    const label patchi, const Visitor& visitor
) const
{
    const polyPatch& pp = mesh_.boundaryMesh()[patchi];
    const label start = pp.start() - mesh_.nInternalFaces();
    for (label i = start; perFlux_[patchi] > 0 && i < start + pp.size(); ++i)
    {
        visitor(i);
    }
}


void Foam::fsbi::endResistances::add
(
    const stokesOperator& stokes, scalar* r, vectorField& traction
) const
{
    if (!any_)
    {
        return;
    }
    const label n = perFlux_.size();
    scalarList sums(2*n, Zero);
    for (label patchi = 0; patchi < n; ++patchi)
    {
        forFaces(patchi, [&](const label i)
        {
            sums[2*patchi] += stokes.boundaryFlux()[i];
            sums[2*patchi + 1] += stokes.fluxPerPressure(i);
        });
    }
    reduce(sums, sumOp<scalarList>());
    for (label patchi = 0; patchi < n; ++patchi)
    {
        const scalar R = perFlux_[patchi];
        const scalar p = R*sums[2*patchi]/(1 - R*sums[2*patchi + 1]);
        forFaces(patchi, [&](const label i)
        {
            stokes.addPressure(i, p, r, traction[i]);
        });
    }
}
