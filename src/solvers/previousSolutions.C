/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "previousSolutions.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"

namespace Foam
{
namespace fsbi
{

//- More than these bring less than they cost, see src/solvers/README.md
static const size_t mostSolutions = 4;

//- Part of a direction's residual that others must leave of it
static const scalar dependent = 1e-8;

//- Over all processors
static scalar product(const scalarList& a, const scalarList& b)
{
    scalar sum = 0;
    forAll(a, i)
    {
        sum += a[i]*b[i];
    }
    return returnReduce(sum, sumOp<scalar>());
}

static void add(const scalar factor, const scalarList& b, scalarList& a)
{
    forAll(a, i)
    {
        a[i] += factor*b[i];
    }
}

} // End namespace fsbi
} // End namespace Foam


void Foam::fsbi::previousSolutions::add(const scalarList& x)
{
    solutions_.push_front(x);
    if (solutions_.size() > mostSolutions)
    {
        solutions_.pop_back();
    }
}


void Foam::fsbi::previousSolutions::improve
(
    const derivative& apply, scalarList& x, const scalarList& residual
) const
{
    const scalarList start(x);
    scalarList left(residual);
    // directions and their residuals, these orthogonal
    std::deque<scalarList> directions, residuals;
    for (const scalarList& solution : solutions_)
    {
        scalarList d(solution);
        fsbi::add(-1, start, d);
        scalarList r(d.size());
        apply(d.cdata(), r.begin());
        const scalar whole = product(r, r);
        for (size_t k = 0; k < residuals.size(); ++k)
        {
            const scalar part = product(residuals[k], r);
            fsbi::add(-part, residuals[k], r);
            fsbi::add(-part, directions[k], d);
        }
        const scalar square = product(r, r);
        if (square <= sqr(dependent)*whole)
        {
            continue;
        }
        const scalar length = Foam::sqrt(square);
        for (scalarList* v : {&d, &r})
        {
            for (scalar& value : *v)
            {
                value /= length;
            }
        }
        const scalar amount = product(r, left);
        fsbi::add(-amount, r, left);
        fsbi::add(-amount, d, x);
        directions.push_back(std::move(d));
        residuals.push_back(std::move(r));
    }
}
