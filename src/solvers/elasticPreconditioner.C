/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "elasticPreconditioner.H"
#include "asVectors.H"
#include "compactPressures.H"

Foam::fsbi::elasticPreconditioner::elasticPreconditioner
(
    const fvMesh& mesh,
    const elasticOperator& elastic
)
:
    mesh_(mesh),
    elastic_(elastic),
    stencil_(elastic.stencil()),
    vertices_(mesh, elastic),
    pressure_(elastic.state().mixed() ? elastic.stencil().vertices().size() : 0, Zero),
    rhs_(mesh.nCells(), Zero),
    z_(mesh.nCells() + stencil_.nGhosts(), Zero)
{}


void Foam::fsbi::elasticPreconditioner::setRows()
{
    const label nCells = mesh_.nCells();
    const label nInner = mesh_.nInternalFaces();
    labelList fill(nCells, 0);
    for (label i = 0; i < nInner; ++i)
    {
        ++fill[stencil_.owner()[i]];
        ++fill[stencil_.neighbour()[i]];
    }
    rowStart_.setSize(nCells + 1);
    rowStart_[0] = 0;
    forAll(fill, celli)
    {
        rowStart_[celli + 1] = rowStart_[celli] + fill[celli];
        fill[celli] = rowStart_[celli];
    }
    rowCell_.setSize(rowStart_.last());
    rowCoeff_.setSize(rowStart_.last());
    for (label i = 0; i < stencil_.nFaces(); ++i)
    {
        const label P = stencil_.owner()[i];
        const label N = stencil_.neighbour()[i];
        const scalar k = elastic_.state().stiffness()*stencil_.compact()[i];
        if (i < nInner)
        {
            rowCell_[fill[P]] = N;
            rowCoeff_[fill[P]++] = k;
            rowCell_[fill[N]] = P;
            rowCoeff_[fill[N]++] = k;
            diagonal_[N] += k;
        }
        if (i < stencil_.firstBoundary())
        {
            diagonal_[P] += k;
        }
        else
        {
            const label g = i - stencil_.firstBoundary();
            const auto kind = elastic_.boundary().kindOf(g);
            diagonal_[P] +=
                kind == solidBoundary::displacement ? 2*k
              : kind == solidBoundary::symmetry ? 2*k/3
              : 0;
        }
    }
}


void Foam::fsbi::elasticPreconditioner::setDiagonal(const scalarField& mass)
{
    diagonal_ = mass;
    setRows();
}


void Foam::fsbi::elasticPreconditioner::rebuild(const scalarField& mass)
{
    vertices_.rebuild(mass);
}


void Foam::fsbi::elasticPreconditioner::sweep
(
    const vectorField& r, vectorField& z
) const
{
    const auto relax = [&](const label celli)
    {
        vector sum(r[celli]);
        for (label j = rowStart_[celli]; j < rowStart_[celli + 1]; ++j)
        {
            sum += rowCoeff_[j]*z[rowCell_[j]];
        }
        z[celli] = sum/diagonal_[celli];
    };
    z = Zero;
    for (label celli = 0; celli < r.size(); ++celli)
    {
        relax(celli);
    }
    for (label celli = r.size() - 1; celli >= 0; --celli)
    {
        relax(celli);
    }
}


void Foam::fsbi::elasticPreconditioner::addGhosts(const scalar* r) const
{
    const vector* ghostRow =
        asVectors(r) + mesh_.nCells();
    for (label g = 0; g < stencil_.nGhosts(); ++g)
    {
        const label i = stencil_.firstBoundary() + g;
        if
        (
            elastic_.boundary().kindOf(g)
         == solidBoundary::displacement
        )
        {
            rhs_[stencil_.owner()[i]] +=
                elastic_.state().stiffness()*stencil_.compact()[i]*ghostRow[g];
        }
    }
}


void Foam::fsbi::elasticPreconditioner::addPressures
(
    const scalar* r, scalar* z
) const
{
    const auto add = [this](const label i, const vector& pull)
    {
        if (elastic_.boundary().kindAt(i) == solidBoundary::traction)
        {
            return;
        }
        rhs_[stencil_.owner()[i]] -= pull;
        if (stencil_.neighbour()[i] < mesh_.nCells())
        {
            rhs_[stencil_.neighbour()[i]] += pull;
        }
    };
    compactPressures(elastic_, r, z, pressure_, add);
}


void Foam::fsbi::elasticPreconditioner::apply
(
    const scalar* r, scalar* z
) const
{
    std::copy_n
    (
        asVectors(r), mesh_.nCells(), rhs_.begin()
    );
    elastic_.shareJoints(r, rhs_);
    addGhosts(r);
    addPressures(r, z);
    sweep(rhs_, z_);
    const label nCells = mesh_.nCells();
    std::copy_n
    (
        asVectors(r) + nCells, stencil_.nGhosts(),
        z_.begin() + nCells
    );
    elastic_.boundary().followCells(z_.begin());
    elastic_.followCells(r, z_, z);
    vertices_.addCorrection
    (
        rhs_, z_,
        UList<vector>
        (
            asVectors(z + elastic_.firstJointRow()),
            stencil_.joints().owned().size()
        )
    );
    std::copy_n(z_.begin()->v_, 3*z_.size(), z);
}
