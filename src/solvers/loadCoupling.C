/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "loadCoupling.H"

Foam::fsbi::loadCoupling::loadCoupling
(
    const loads& l,
    const UList<bodyRows>& bodies,
    const List<sixVector>& resistance
)
:
    loads_(l),
    bodies_(bodies),
    resistance_(resistance)
{
    factorise();
}


void Foam::fsbi::loadCoupling::factorise()
{
    // those on corners are cornerSprings'
    const loads crude(loads_.onCorners() ? loads_.others() : loads_);
    bool stiff = false;
    forAll(bodies_, b)
    {
        stiff = stiff || crude.stiff(b);
    }
    if (!stiff)
    {
        return;
    }
    const label n = 6*bodies_.size();
    factors_ = scalarSquareMatrix(n, n, Zero);
    pivots_.setSize(n);
    loads::ofBodies u(loads_.atRest());
    for (label j = 0; j < n; ++j)
    {
        scalar& unit = u.whole[j/6][j % 6];
        unit = bodies_[j/6].gain;
        const loads::onBodies f(crude.changes(u));
        unit = 0;
        for (label i = 0; i < n; ++i)
        {
            if (bodies_[i/6].free[i % 6])
            {
                factors_(i, j) = -f.whole[i/6][i % 6];
            }
        }
        factors_(j, j) += resistance_[j/6][j % 6];
    }
    LUDecompose(factors_, pivots_);
}


Foam::fsbi::loads::onBodies Foam::fsbi::loadCoupling::forces
(
    const loads& l,
    const UList<bodyRows>& bodies,
    const UList<sixVector>& v
)
{
    loads::ofBodies u(l.atRest());
    forAll(bodies, b)
    {
        forAll(v[b], k)
        {
            u.whole[b][k] = bodies[b].gain*v[b][k] - bodies[b].offset[k];
        }
    }
    loads::onBodies sum(l.forces());
    const loads::onBodies change(l.changes(u));
    forAll(sum.whole, b)
    {
        forAll(sum.whole[b], k)
        {
            sum.whole[b][k] += change.whole[b][k];
        }
        sum.triangles[b] += change.triangles[b];
        sum.points[b] += change.points[b];
    }
    return sum;
}


Foam::fsbi::loads::ofBodies Foam::fsbi::loadCoupling::displacements
(
    const UList<sixVector>& v, const UList<vectorField>& points
) const
{
    loads::ofBodies u(loads_.atRest());
    forAll(bodies_, b)
    {
        forAll(v[b], k)
        {
            u.whole[b][k] = bodies_[b].gain*v[b][k];
        }
    }
    forAll(points, e)
    {
        u.points[bodies_.size() + e] = points[e];
    }
    return u;
}


void Foam::fsbi::loadCoupling::precondition(List<sixVector>& v) const
{
    if (pivots_.empty())
    {
        return;
    }
    scalarField flat(pivots_.size());
    forAll(flat, i)
    {
        flat[i] = resistance_[i/6][i % 6]*v[i/6][i % 6];
    }
    LUBacksubstitute(factors_, pivots_, flat);
    forAll(flat, i)
    {
        v[i/6][i % 6] = flat[i];
    }
}
