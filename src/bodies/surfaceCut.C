/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceCut.H"

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
    const vectorField& triangles, const vectorField& points
) const
{
    if (empty())
    {
        return triangles;
    }
    const vectorField corners(this->points(points));
    vectorField result(cut_.triangles.size());
    forAll(result, i)
    {
        const label t = cut_.parents[i];
        result[i] =
            cut_.triangles[i].average(corners, corners)
          + triangles[t] - own_[t].average(points, points);
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
    vectorField result(own_.size(), Zero);
    forAll(parts, i)
    {
        result[cut_.parents[i]] += parts[i];
    }
    return result;
}


Foam::vectorField Foam::fsbi::surfaceCut::onPoints
(
    const vectorField& parts
) const
{
    vectorField result;
    if (empty())
    {
        return result;
    }
    vectorField corners(weights_.size(), Zero);
    result.setSize(nPoints_, Zero);
    forAll(parts, i)
    {
        for (const label p : cut_.triangles[i])
        {
            corners[p] += parts[i]/3;
        }
        for (const label p : own_[cut_.parents[i]])
        {
            result[p] -= parts[i]/3;
        }
    }
    forAll(corners, p)
    {
        const pointWeights& w = weights_[p];
        forAll(w.points, i)
        {
            result[w.points[i]] += w.weights[i]*corners[p];
        }
    }
    return result;
}
