/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "smoothedFacets.H"
#include "EdgeMap.H"
#include "HashSet.H"

#include <Eigen/Dense>

namespace Foam
{
namespace fsbi
{

//- Neighbours count with this power of their distance: the nearest decide, those
//  behind them make the fit one even where there are only three or four
static const scalar decay = -4;

//- Cosine of the angle between triangles from which on the edge is a sharp one
static const scalar sharp = 0.5;

//- 1, u, v ... without the 1
static FixedList<scalar, 5> powers(const scalar u, const scalar v)
{
    return {u, v, u*u, u*v, v*v};
}

//- Corners that share a triangle with each
static labelListList neighboursOf(const bodySurface& surface)
{
    List<labelHashSet> sets(surface.points().size());
    for (const triFace& t : surface.triangles())
    {
        for (label i = 0; i < 3; ++i)
        {
            sets[t[i]].insert(t[(i + 1) % 3]);
            sets[t[i]].insert(t[(i + 2) % 3]);
        }
    }
    labelListList lists(sets.size());
    forAll(sets, i)
    {
        lists[i] = sets[i].sortedToc();
    }
    return lists;
}

//- Is a corner at a sharp edge?
static boolList atSharpEdges(const bodySurface& surface)
{
    boolList result(surface.points().size(), false);
    EdgeMap<vector> normals;
    for (const triFace& t : surface.triangles())
    {
        const vector n(t.unitNormal(surface.points()));
        for (const edge& e : t.edges())
        {
            const auto other = normals.cfind(e);
            if (!other.found())
            {
                normals.insert(e, n);
            }
            else if ((n & *other) < sharp)
            {
                result[e[0]] = result[e[1]] = true;
            }
        }
    }
    return result;
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::facetPlace Foam::fsbi::facetPlace::between
(
    const facetPlace& a, const facetPlace& b
)
{
    facetPlace middle;
    label n = 0;
    for (const facetPlace* place : {&a, &b})
    {
        for (label k = 0; k < 3; ++k)
        {
            if (place->shares[k] > 0)
            {
                label i = 0;
                while (i < n && middle.corners[i] != place->corners[k])
                {
                    ++i;
                }
                if (i == n)
                {
                    middle.corners[i] = place->corners[k];
                    middle.shares[i] = 0;
                    ++n;
                }
                middle.shares[i] += 0.5*place->shares[k];
            }
        }
    }
    for (; n < 3; ++n)
    {
        middle.corners[n] = middle.corners[0];
        middle.shares[n] = 0;
    }
    return middle;
}


Foam::scalar Foam::fsbi::facetPlace::share(const label corner) const
{
    scalar sum = 0;
    for (label k = 0; k < 3; ++k)
    {
        sum += corners[k] == corner ? shares[k] : 0;
    }
    return sum;
}


void Foam::fsbi::pointWeights::add
(
    const label point, const scalar weight
)
{
    const label i = points.find(point);
    if (i >= 0)
    {
        weights[i] += weight;
    }
    else if (weight != 0)
    {
        points.append(point);
        weights.append(weight);
    }
}


Foam::fsbi::smoothedFacets::smoothedFacets
(
    const bodySurface& reference, const bool cornersStandOut
)
:
    reference_(reference),
    quadratics_(reference.points().size())
{
    const labelListList neighbours(neighboursOf(reference_));
    const vectorField areas(reference_.pointAreas());
    const boolList flat(atSharpEdges(reference_));
    forAll(quadratics_, k)
    {
        if (flat[k])
        {
            continue;
        }
        const vector n(normalised(areas[k]));
        quadratic& q = quadratics_[k];
        q.e1 = n ^ (mag(n.x()) < 0.6 ? vector(1, 0, 0) : vector(0, 1, 0));
        q.e1 /= mag(q.e1);
        q.e2 = n ^ q.e1;
        labelHashSet two(neighbours[k]);
        for (const label i : neighbours[k])
        {
            if (!flat[i])
            {
                two.insert(neighbours[i]);
            }
        }
        two.erase(k);
        q.neighbours = two.sortedToc();
        fit(k);
    }
    if (cornersStandOut)
    {
        setOutstanding();
    }
}


void Foam::fsbi::smoothedFacets::fit(const label corner)
{
    quadratic& q = quadratics_[corner];
    const label n = q.neighbours.size();
    Eigen::MatrixXd A(n, 5);
    Eigen::VectorXd weight(n);
    scalar unit = 0;
    for (const label i : q.neighbours)
    {
        unit = max(unit, mag(reference_.points()[i] - reference_.points()[corner]));
    }
    for (label i = 0; i < n; ++i)
    {
        const vector r
        (
            (
                reference_.points()[q.neighbours[i]]
              - reference_.points()[corner]
            )/unit
        );
        weight[i] = pow(mag(r), decay/2);
        const auto p = powers(r & q.e1, r & q.e2);
        for (label j = 0; j < 5; ++j)
        {
            A(i, j) = weight[i]*p[j];
        }
    }
    const Eigen::MatrixXd inverse
    (
        A.completeOrthogonalDecomposition().pseudoInverse()
    );
    for (label j = 0; j < 5; ++j)
    {
        q.coeffs[j].setSize(n);
        for (label i = 0; i < n; ++i)
        {
            q.coeffs[j][i] =
                inverse(j, i)*weight[i]/(j < 2 ? unit : sqr(unit));
        }
    }
}


void Foam::fsbi::smoothedFacets::setOutstanding()
{
    // H = ((2c d) (d 2e)), mean over the triangles at a corner
    labelList n(quadratics_.size(), Zero);
    for (const triFace& t : reference_.triangles())
    {
        for (const label k : t)
        {
            quadratic& q = quadratics_[k];
            ++n[k];
            for (label i = 0; i < 3; ++i)
            {
                const vector e
                (
                    reference_.points()[t[(i + 1) % 3]]
                  - reference_.points()[t[i]]
                );
                const scalar u = e & q.e1, v = e & q.e2;
                q.outstanding += vector(2*u*u, 2*u*v, 2*v*v)/24;
            }
        }
    }
    forAll(quadratics_, k)
    {
        quadratics_[k].outstanding /= n[k];
    }
}


template<class Add>
void Foam::fsbi::smoothedFacets::visit
(
    const facetPlace& place, const scalar out, const Add& add
) const
{
    const point flat(place.of(reference_.points()));
    for (label c = 0; c < 3; ++c)
    {
        const scalar beta = place.shares[c];
        if (!(beta > 0))
        {
            continue;
        }
        const label k = place.corners[c];
        const quadratic& q = quadratics_[k];
        if (q.flat())
        {
            for (label i = 0; i < 3; ++i)
            {
                add(place.corners[i], beta*place.shares[i]);
            }
            continue;
        }
        const vector r(flat - reference_.points()[k]);
        auto terms = powers(r & q.e1, r & q.e2);
        for (label j = 0; j < 3; ++j)
        {
            terms[2 + j] += (1 - out)*q.outstanding[j];
        }
        scalar sum = 0;
        forAll(q.neighbours, i)
        {
            scalar w = 0;
            for (label j = 0; j < 5; ++j)
            {
                w += terms[j]*q.coeffs[j][i];
            }
            add(q.neighbours[i], beta*w);
            sum += w;
        }
        add(k, beta*(1 - sum));
    }
}


Foam::fsbi::pointWeights Foam::fsbi::smoothedFacets::at
(
    const facetPlace& place, const scalar out
) const
{
    pointWeights result;
    visit
    (
        place, out, [&](const label corner, const scalar weight)
        {
            result.add(corner, weight);
        }
    );
    return result;
}


Foam::point Foam::fsbi::smoothedFacets::position
(
    const facetPlace& place, const UList<point>& corners
) const
{
    point sum(Zero);
    visit
    (
        place, 0, [&](const label corner, const scalar weight)
        {
            sum += weight*corners[corner];
        }
    );
    return sum;
}
