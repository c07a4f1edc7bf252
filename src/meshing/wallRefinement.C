/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallRefinement.H"
#include "redGreen.H"
#include "UIndirectList.H"

namespace Foam
{
namespace fsbi
{

//- Longest edge over what is wanted
static const scalar longest = 1.5;

static bool tooLarge
(
    const triFace& t, const UList<point>& points, const sizeFunction& size
)
{
    const point& a = points[t[0]];
    const point& b = points[t[1]];
    const point& c = points[t[2]];
    const scalar edge = max(mag(a - b), max(mag(b - c), mag(c - a)));
    return edge > longest*size((a + b + c)/3);
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::domainBoundary Foam::fsbi::refinedFor
(
    const sizeFunction& size, const domainBoundary& walls
)
{
    redGreen fine
    (
        walls.surface.points(), walls.surface.triangles(),
        [](const point& middle) { return middle; }
    );
    for (label cuts = 0; cuts < redGreen::mostCuts; ++cuts)
    {
        boolList marked(fine.triangles().size(), false);
        bool any = false;
        forAll(marked, i)
        {
            marked[i] = tooLarge(fine.triangles()[i], fine.points(), size);
            any = any || marked[i];
        }
        if (!any)
        {
            break;
        }
        fine.split(marked);
    }
    labelList origins;
    const List<triFace> triangles(fine.conforming(&origins));
    return
    {
        bodySurface(pointField(fine.points()), triangles),
        labelList(UIndirectList<label>(walls.patches, origins))
    };
}
