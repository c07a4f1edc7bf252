/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceParts.H"
#include "edgeHashes.H"
#include "unitConversion.H"

namespace Foam
{
namespace fsbi
{

//- The triangles on both sides of every edge of a closed surface
static EdgeMap<labelPair> sidesOfEdges(const List<triFace>& triangles)
{
    EdgeMap<labelPair> sides(2*triangles.size());
    forAll(triangles, i)
    {
        for (label j = 0; j < 3; ++j)
        {
            const edge e(triangles[i][j], triangles[i][(j + 1) % 3]);
            auto found = sides.find(e);
            if (found.found())
            {
                found.val().second() = i;
            }
            else
            {
                sides.insert(e, labelPair(i, -1));
            }
        }
    }
    return sides;
}


static point nearestOn(const point& a, const point& b, const point& x)
{
    const vector d(b - a);
    return a + max(0, min(1, ((x - a) & d)/(magSqr(d) + VSMALL)))*d;
}

} // End namespace fsbi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsbi::surfaceParts::findParts
(
    const labelUList& patches, const scalar cosFeature
)
{
    const List<triFace>& triangles = surface_.triangles();
    const EdgeMap<labelPair> sides(sidesOfEdges(triangles));
    const auto smooth = [&](const label a, const label b)
    {
        const vector na(triangles[a].areaNormal(surface_.points()));
        const vector nb(triangles[b].areaNormal(surface_.points()));
        return
            patches[a] == patches[b]
         && (na & nb) >= cosFeature*mag(na)*mag(nb);
    };
    forAll(triangles, start)
    {
        if (parts_[start] >= 0)
        {
            continue;
        }
        const label part = patches_.size();
        patches_.append(patches[start]);
        parts_[start] = part;
        DynamicList<label> front(1, start);
        while (front.size())
        {
            const label i = front.remove();
            for (label j = 0; j < 3; ++j)
            {
                const triFace& t = triangles[i];
                const labelPair& both = sides[edge(t[j], t[(j + 1) % 3])];
                const label k = both.first() == i ? both.second() : both.first();
                if (parts_[k] < 0 && smooth(i, k))
                {
                    parts_[k] = part;
                    front.append(k);
                }
            }
        }
    }
}


void Foam::fsbi::surfaceParts::findLines(const scalar cosFeature)
{
    const pointField& x = surface_.points();
    List<DynamicList<label>> along(x.size());
    const EdgeMap<labelPair> sides(sidesOfEdges(surface_.triangles()));
    forAllConstIters(sides, e)
    {
        const label a = parts_[e.val().first()], b = parts_[e.val().second()];
        if (a != b)
        {
            const edge& ends = e.key();
            lines_[labelPair(min(a, b), max(a, b))].append(ends);
            along[ends.start()].append(ends.end());
            along[ends.end()].append(ends.start());
        }
    }
    for (auto& line : lines_)
    {
        // a hash table's order is none
        std::sort(line.second.begin(), line.second.end());
    }
    forAll(corners_, p)
    {
        const label n = along[p].size();
        corners_[p] = n == 1 || n > 2;
        if (n == 2)
        {
            const vector in(normalised(x[p] - x[along[p][0]]));
            const vector out(normalised(x[along[p][1]] - x[p]));
            corners_[p] = (in & out) < cosFeature;
        }
    }
}


Foam::autoPtr<Foam::fsbi::surfaceDistance>
Foam::fsbi::surfaceParts::distanceTo(const label part) const
{
    labelList number(surface_.points().size(), -1);
    DynamicList<point> points;
    DynamicList<triFace> triangles;
    forAll(parts_, i)
    {
        if (parts_[i] != part)
        {
            continue;
        }
        triFace t(surface_.triangles()[i]);
        for (label& p : t)
        {
            if (number[p] < 0)
            {
                number[p] = points.size();
                points.append(surface_.points()[p]);
            }
            p = number[p];
        }
        triangles.append(t);
    }
    return autoPtr<surfaceDistance>::New
    (
        pointField(std::move(points)), triangles
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::surfaceParts::surfaceParts
(
    const bodySurface& surface,
    const labelUList& patches,
    const scalar featureAngle
)
:
    surface_(surface),
    parts_(surface.triangles().size(), -1),
    corners_(surface.points().size(), false)
{
    const scalar cosFeature = Foam::cos(degToRad(featureAngle));
    findParts(patches, cosFeature);
    findLines(cosFeature);

    distances_.setSize(patches_.size());
    forAll(distances_, part)
    {
        distances_.set(part, distanceTo(part).ptr());
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::point Foam::fsbi::surfaceParts::nearest
(
    const point& x, const labelPair& parts
) const
{
    point found(x);
    if (parts.first() == parts.second())
    {
        label triangle;
        distances_[parts.first()].find(x, ROOTVGREAT, found, triangle);
        return found;
    }
    const auto line = lines_.find
    (
        labelPair
        (
            min(parts.first(), parts.second()),
            max(parts.first(), parts.second())
        )
    );
    if (line == lines_.end())
    {
        return x;
    }
    scalar least = GREAT;
    for (const labelPair& e : line->second)
    {
        const point p
        (
            nearestOn(surface_.points()[e.first()], surface_.points()[e.second()], x)
        );
        if (magSqr(p - x) < least)
        {
            least = magSqr(p - x);
            found = p;
        }
    }
    return found;
}
