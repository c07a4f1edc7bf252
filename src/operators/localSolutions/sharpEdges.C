/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sharpEdges.H"
#include "noTurn.H"
#include "syncTools.H"
#include "unitConversion.H"

namespace Foam
{
namespace fsbi
{

//- Between the normals of facets beside a sharp edge
static const scalar sharpAbove = degToRad(70.0);

//- Of points that several processors have, the facets of all
struct joinFacets
{
    void operator()
    (
        List<wallFacet>& a, const List<wallFacet>& b
    ) const
    {
        for (const wallFacet& f : b)
        {
            if (!a.found(f))
            {
                a.append(f);
            }
        }
    }
};


//- Put facets around a vertex in order, each one sharing the last vertex of the
//  one before; false: they do not close
static bool setInOrder(List<wallFacet>& facets)
{
    sort(facets);
    const label n = facets.size();
    for (label i = 0; i + 1 < n; ++i)
    {
        label j = i + 1;
        while (j < n && facets[j].ends[0] != facets[i].ends[1])
        {
            ++j;
        }
        if (j == n)
        {
            return false;
        }
        Swap(facets[i + 1], facets[j]);
    }
    return n > 2 && facets[n - 1].ends[1] == facets[0].ends[0];
}

} // End namespace fsbi
} // End namespace Foam


Foam::vector Foam::fsbi::sharpVertex::lift
(
    const label neighbour, const vector& e
) const
{
    if (along.found(neighbour))
    {
        return e - (e & tangent)*tangent;
    }
    for (label side = 0; side < 2; ++side)
    {
        if (beside[side].found(neighbour))
        {
            return (e & normals[side])*normals[side];
        }
    }
    return Zero;
}


Foam::List<Foam::List<Foam::fsbi::wallFacet>> Foam::fsbi::sharpEdges::facets
(
    const labelUList& number
) const
{
    List<List<wallFacet>> result(mesh_.nPoints());
    const pointField& x = mesh_.points();
    forAll(faces_, i)
    {
        const label facei = mesh_.nInternalFaces() + i;
        const face& f = mesh_.faces()[facei];
        for (label k = 0; faces_[i] && k < f.size(); ++k)
        {
            const label next = f.nextLabel(k), last = f.prevLabel(k);
            result[f[k]].append
            (
                wallFacet
                {
                    FixedList<label, 2>({number[next], number[last]}),
                    FixedList<point, 2>({x[next], x[last]}),
                    normalised(mesh_.faceAreas()[facei])
                }
            );
        }
    }
    syncTools::syncPointList
    (
        mesh_, result, joinFacets(), List<wallFacet>(), noTurn()
    );
    return result;
}


void Foam::fsbi::sharpEdges::add
(
    const label v, const UList<wallFacet>& facets
)
{
    const label n = facets.size();
    DynamicList<label> sharp;
    forAll(facets, i)
    {
        const wallFacet &a = facets[i], &b = facets[(i + 1) % n];
        const scalar cosine = min(max(a.normal & b.normal, -1), 1);
        // outwards from the body's edge the fluid has more than half of the space
        if
        (
            Foam::acos(cosine) > sharpAbove
         && ((a.places[0] - mesh_.points()[v]) & b.normal) > 0
        )
        {
            sharp.append(i);
        }
    }
    if (sharp.size() != 2)
    {
        if (sharp.size())
        {
            corners_.insert(v);
        }
        return;
    }
    sharpVertex s;
    FixedList<point, 2> x;
    for (label side = 0; side < 2; ++side)
    {
        const label first = sharp[side], last = sharp[1 - side];
        s.along[side] = facets[first].ends[1];
        x[side] = facets[first].places[1];
        vector sum(Zero);
        for (label i = (first + 1) % n; ; i = (i + 1) % n)
        {
            sum += facets[i].angleAt(mesh_.points()[v])*facets[i].normal;
            if (i == last)
            {
                break;
            }
            s.beside[side].insert(facets[i].ends[1]);
        }
        s.normals[side] = sum;
    }
    const vector before(mesh_.points()[v] - x[0]);
    const vector after(x[1] - mesh_.points()[v]);
    const scalar a = mag(before), b = mag(after);
    s.lengths[0] = a;
    s.lengths[1] = b;
    s.tangent = normalised(b/a*before + a/b*after);
    s.curvature = 2*(after/b - before/a)/(a + b);
    s.curvature -= (s.curvature & s.tangent)*s.tangent;
    for (vector& normal : s.normals)
    {
        normal = normalised(normal - (normal & s.tangent)*s.tangent);
    }
    s.angle =
        constant::mathematical::pi
      + Foam::acos(min(max(s.normals[0] & s.normals[1], -1), 1));
    vertices_.insert(v, s);
}


void Foam::fsbi::sharpEdges::update(const labelUList& number)
{
    vertices_.clear();
    corners_.clear();
    List<List<wallFacet>> around(facets(number));
    forAll(around, v)
    {
        if (setInOrder(around[v]))
        {
            add(v, around[v]);
        }
    }
}
