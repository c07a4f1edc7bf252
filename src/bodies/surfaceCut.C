/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceCut.H"
#include "HashSet.H"

#include <Eigen/Dense>

namespace Foam
{
namespace fsbi
{

//- Of a part in its triangle, both told by the places of corners
static scalar shareOf
(
    const triFace& part, const UList<facetPlace>& places, const triFace& whole
)
{
    const auto at = [&](const label corner)
    {
        const facetPlace& place = places[part[corner]];
        return vector
        (
            place.share(whole[0]), place.share(whole[1]), place.share(whole[2])
        );
    };
    return at(0) & (at(1) ^ at(2));
}

//- Weights of triangles for the value at a point nearby, by a linear fit in which
//  the nearest count most
static pointWeights fitted
(
    const point& x, const labelList& triangles, const pointField& centres
)
{
    const label n = triangles.size();
    scalar unit = 0;
    for (const label t : triangles)
    {
        unit = max(unit, mag(centres[t] - x));
    }
    Eigen::MatrixX4d A(n, 4);
    Eigen::VectorXd counts(n);
    for (label i = 0; i < n; ++i)
    {
        const vector d((centres[triangles[i]] - x)/unit);
        counts[i] = 1/magSqr(d);
        A.row(i) = counts[i]*Eigen::RowVector4d(1, d.x(), d.y(), d.z());
    }
    // of centres in a plane through x nothing is asked beyond it
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> fit;
    fit.setThreshold(1e-8);
    fit.compute(A);
    const Eigen::RowVectorXd row(fit.pseudoInverse().row(0));
    pointWeights result{triangles, scalarList(n)};
    for (label i = 0; i < n; ++i)
    {
        result.weights[i] = row[i]*counts[i];
    }
    return result;
}

} // End namespace fsbi
} // End namespace Foam


Foam::Istream& Foam::fsbi::operator>>(Istream& is, facetPlace& place)
{
    return is >> place.corners >> place.shares;
}


Foam::Ostream& Foam::fsbi::operator<<(Ostream& os, const facetPlace& place)
{
    return os << place.corners << token::SPACE << place.shares;
}


Foam::Istream& Foam::fsbi::operator>>(Istream& is, cutTriangles& cut)
{
    return is >> cut.triangles >> cut.parents >> cut.places;
}


Foam::Ostream& Foam::fsbi::operator<<(Ostream& os, const cutTriangles& cut)
{
    return os
        << cut.triangles << token::SPACE << cut.parents << token::SPACE
        << cut.places;
}


Foam::fsbi::surfaceCut::surfaceCut
(
    const cutTriangles& cut, const smoothedFacets& body
)
:
    cut_(cut),
    own_(body.reference().triangles()),
    nPoints_(body.reference().points().size())
{
    if (!empty())
    {
        setWeights(body);
        setShares();
        setFromTriangles(body.reference());
    }
}


void Foam::fsbi::surfaceCut::setWeights(const smoothedFacets& body)
{
    // corners of small triangles are on the surface, not out of it
    const pointField& X = body.reference().points();
    pointField flat(cut_.places.size());
    forAll(flat, p)
    {
        flat[p] = cut_.places[p].of(X);
    }
    const scalarField edges
    (
        bodySurface::open(flat, cut_.triangles).pointEdges()
    );
    const scalarField whole(body.reference().pointEdges());
    weights_.setSize(cut_.places.size());
    forAll(weights_, p)
    {
        const facetPlace& place = cut_.places[p];
        const scalar out = min(sqr(edges[p]/place.of(whole)), 1);
        weights_[p] = body.at(place, out);
    }
}


void Foam::fsbi::surfaceCut::setShares()
{
    shares_.setSize(cut_.triangles.size());
    forAll(shares_, i)
    {
        shares_[i] =
            shareOf(cut_.triangles[i], cut_.places, own_[cut_.parents[i]]);
    }
}


void Foam::fsbi::surfaceCut::setFromTriangles(const bodySurface& body)
{
    labelHashSet wanted;
    for (const label t : cut_.parents)
    {
        wanted.insert(own_[t]);
    }
    for (const pointWeights& w : weights_)
    {
        wanted.insert(w.points);
    }
    List<DynamicList<label>> around(nPoints_);
    pointField centres(own_.size());
    forAll(own_, t)
    {
        centres[t] = own_[t].centre(body.points());
        for (const label p : own_[t])
        {
            around[p].append(t);
        }
    }
    fromTriangles_.setSize(nPoints_);
    for (const label p : wanted)
    {
        // two rings
        labelHashSet near;
        for (const label t : around[p])
        {
            for (const label q : own_[t])
            {
                near.insert(around[q]);
            }
        }
        fromTriangles_[p] = fitted(body.points()[p], near.sortedToc(), centres);
    }
}


Foam::vectorField Foam::fsbi::surfaceCut::points(const vectorField& body) const
{
    if (empty())
    {
        return body;
    }
    vectorField result(weights_.size());
    forAll(result, p)
    {
        result[p] = weights_[p].of(body);
    }
    return result;
}


Foam::vectorField Foam::fsbi::surfaceCut::faces
(
    const vectorField& triangles
) const
{
    if (empty())
    {
        return triangles;
    }
    vectorField own(nPoints_, Zero);
    forAll(own, p)
    {
        own[p] = fromTriangles_[p].of(triangles);
    }
    const vectorField corners(points(own));
    vectorField result(cut_.triangles.size());
    forAll(result, i)
    {
        const label t = cut_.parents[i];
        result[i] =
            cut_.triangles[i].average(corners, corners)
          + triangles[t] - own_[t].average(own, own);
    }
    return result;
}


Foam::fsbi::bodySurface Foam::fsbi::surfaceCut::surface
(
    const bodySurface& body
) const
{
    return
        empty()
      ? body
      : bodySurface(points(body.points()), cut_.triangles);
}


Foam::vectorField Foam::fsbi::surfaceCut::onTriangles
(
    const vectorField& parts
) const
{
    if (empty())
    {
        return parts;
    }
    vectorField corners(weights_.size(), Zero);
    vectorField own(nPoints_, Zero);
    vectorField result(own_.size(), Zero);
    forAll(parts, i)
    {
        const label t = cut_.parents[i];
        result[t] += parts[i];
        for (label k = 0; k < 3; ++k)
        {
            corners[cut_.triangles[i][k]] += parts[i]/3;
            own[own_[t][k]] -= parts[i]/3;
        }
    }
    forAll(corners, p)
    {
        weights_[p].spread(corners[p], own);
    }
    forAll(own, p)
    {
        fromTriangles_[p].spread(own[p], result);
    }
    return result;
}
