/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshAssembly.H"
#include "bandCompression.H"
#include "CompactListList.H"
#include "ListOps.H"

#include <algorithm>
#include <array>
#include <vector>

namespace Foam
{
namespace fsbi
{

typedef std::array<label, 3> triple;

// A side of a tetrahedron: sorted points to find its partner
struct tetSide
{
    triple key;
    label cell;
    triFace outward;

    bool operator<(const tetSide& other) const
    {
        return key < other.key || (key == other.key && cell < other.cell);
    }
};


static triple sorted(const triFace& t)
{
    triple key{t[0], t[1], t[2]};
    std::sort(key.begin(), key.end());
    return key;
}


static std::vector<tetSide> sortedSides
(
    const UList<FixedList<label, 4>>& tetrahedra
)
{
    std::vector<tetSide> sides;
    sides.reserve(4*tetrahedra.size());
    forAll(tetrahedra, c)
    {
        const FixedList<label, 4>& v = tetrahedra[c];
        for
        (
            const triFace& t :
            {
                triFace(v[0], v[2], v[1]), triFace(v[0], v[1], v[3]),
                triFace(v[1], v[2], v[3]), triFace(v[0], v[3], v[2])
            }
        )
        {
            sides.push_back({sorted(t), c, t});
        }
    }
    std::sort(sides.begin(), sides.end());
    return sides;
}


// Cuthill-McKee order of the cells: new number of every cell
static labelList cellOrder
(
    const std::vector<tetSide>& sides, const label nCells
)
{
    List<DynamicList<label, 4>> around(nCells);
    for (size_t i = 0; i + 1 < sides.size(); ++i)
    {
        if (sides[i].key == sides[i + 1].key)
        {
            around[sides[i].cell].append(sides[i + 1].cell);
            around[sides[i + 1].cell].append(sides[i].cell);
        }
    }
    labelListList neighbours(nCells);
    forAll(around, c)
    {
        neighbours[c] = around[c];
    }
    return invert(nCells, bandCompression(neighbours));
}


// Inner points in the order of the cells that have them, in the places that inner
// points have: what is done point by point reads cells that are near in memory
static void orderPoints
(
    const UList<boundaryTriangle>& boundary,
    pointField& points,
    List<FixedList<label, 4>>& tetrahedra
)
{
    boolList placed(points.size(), false);
    for (const boundaryTriangle& t : boundary)
    {
        for (const label v : t.points)
        {
            placed[v] = true;
        }
    }
    labelList number(identity(points.size()));
    const labelList free(findIndices(placed, false));
    label next = 0;
    for (FixedList<label, 4>& t : tetrahedra)
    {
        for (label& v : t)
        {
            if (!placed[v])
            {
                number[v] = free[next++];
                placed[v] = true;
            }
            v = number[v];
        }
    }
    // whatever no cell has
    forAll(placed, v)
    {
        if (!placed[v])
        {
            number[v] = free[next++];
        }
    }
    inplaceReorder(number, points);
}


struct internalFace
{
    label owner, neighbour;
    triFace points;

    bool operator<(const internalFace& b) const
    {
        return owner < b.owner || (owner == b.owner && neighbour < b.neighbour);
    }
};


struct patchFace
{
    label patch, place, owner;
    face points;

    bool operator<(const patchFace& b) const
    {
        return std::tie(patch, place, owner, points[0], points[1])
            < std::tie(b.patch, b.place, b.owner, b.points[0], b.points[1]);
    }
};


// Pair the sides; those left over must be the boundary's triangles
static string matchSides
(
    const std::vector<tetSide>& sides,
    const UList<boundaryTriangle>& boundary,
    std::vector<internalFace>& inner,
    std::vector<patchFace>& outer
)
{
    std::vector<std::pair<triple, label>> marked;
    forAll(boundary, i)
    {
        marked.push_back({sorted(boundary[i].points), i});
    }
    std::sort(marked.begin(), marked.end());

    for (size_t i = 0; i < sides.size(); ++i)
    {
        if (i + 1 < sides.size() && sides[i].key == sides[i + 1].key)
        {
            inner.push_back
            ({
                sides[i].cell, sides[i + 1].cell, sides[i].outward
            });
            ++i;
            continue;
        }
        const auto found = std::lower_bound
        (
            marked.begin(), marked.end(), std::make_pair(sides[i].key, label(-1))
        );
        if (found == marked.end() || found->first != sides[i].key)
        {
            return "a free side of a cell is on no boundary";
        }
        const boundaryTriangle& t = boundary[found->second];
        const face f
        (
            t.place >= 0
          ? face(t.points)
          : firstPointLowest(sides[i].outward)
        );
        outer.push_back({t.patch, t.place, sides[i].cell, f});
    }
    return
        label(outer.size()) == boundary.size()
      ? "" : "boundary triangles are not all sides of exactly one cell";
}

} // End namespace fsbi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Functions * * * * * * * * * * * * * * * * //

Foam::face Foam::fsbi::firstPointLowest(const triFace& t)
{
    const label i = t[0] < t[1] ? (t[0] < t[2] ? 0 : 2) : (t[1] < t[2] ? 1 : 2);
    face f(3);
    f[0] = t[i];
    f[1] = t[(i + 1) % 3];
    f[2] = t[(i + 2) % 3];
    return f;
}


void Foam::fsbi::assembleMesh
(
    meshLists& mesh,
    List<FixedList<label, 4>>&& tetrahedra,
    const UList<boundaryTriangle>& boundary,
    const label nPatches
)
{
    for (FixedList<label, 4>& v : tetrahedra)
    {
        const pointField& p = mesh.points;
        const vector a(p[v[1]] - p[v[0]]), b(p[v[2]] - p[v[0]]);
        if (((a ^ b) & (p[v[3]] - p[v[0]])) < 0)
        {
            Swap(v[0], v[1]);
        }
    }

    inplaceReorder
    (
        cellOrder(sortedSides(tetrahedra), tetrahedra.size()), tetrahedra
    );
    orderPoints(boundary, mesh.points, tetrahedra);
    const std::vector<tetSide> sides(sortedSides(tetrahedra));

    std::vector<internalFace> inner;
    std::vector<patchFace> outer;
    mesh.failure = matchSides(sides, boundary, inner, outer);
    if (!mesh.valid())
    {
        return;
    }
    std::sort(inner.begin(), inner.end());
    std::sort(outer.begin(), outer.end());

    mesh.faces.setSize(inner.size() + outer.size());
    mesh.owner.setSize(mesh.faces.size());
    mesh.neighbour.setSize(inner.size());
    label facei = 0;
    for (const internalFace& f : inner)
    {
        mesh.faces[facei] = firstPointLowest(f.points);
        mesh.owner[facei] = f.owner;
        mesh.neighbour[facei++] = f.neighbour;
    }

    mesh.patchSizes = labelList(nPatches, Zero);
    for (const patchFace& f : outer)
    {
        mesh.faces[facei] = f.points;
        mesh.owner[facei++] = f.owner;
        ++mesh.patchSizes[f.patch];
    }
    mesh.patchStarts.setSize(nPatches);
    label start = inner.size();
    forAll(mesh.patchStarts, i)
    {
        mesh.patchStarts[i] = start;
        start += mesh.patchSizes[i];
    }
}
