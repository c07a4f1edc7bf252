/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cellEstimate.H"
#include "OStringStream.H"

namespace
{

//- gmsh's tetrahedra in a cube as wide as the size it is asked for, measured
const Foam::scalar perCube = 6.5;

//- A box is halved until it is this many edges wide
const Foam::scalar widest = 3;

} // End anonymous namespace


Foam::scalar Foam::fsbi::cellsIn
(
    const boundBox& box,
    const UList<extent>& bodies,
    const std::function<scalar(const point&)>& size,
    const std::function<bool(const point&)>& counts,
    const scalar most
)
{
    const point centre(box.midpoint());
    const scalar h = size(centre);
    scalar width = cmptMax(box.span())/widest;
    bool halve = width > h;
    for (const extent& body : bodies)
    {
        halve = halve || (width > body.edge && box.overlaps(body.box));
    }
    if (!halve)
    {
        return counts(centre) ? perCube*box.volume()/pow3(h) : 0;
    }
    scalar sum = 0;
    const pointField corners(box.points());
    for (const point& corner : corners)
    {
        if (sum <= most)
        {
            boundBox part(centre);
            part.add(corner);
            sum += cellsIn(part, bodies, size, counts, most - sum);
        }
    }
    return sum;
}


Foam::string Foam::fsbi::tooManyCells
(
    const scalar cells, const remeshControls& controls
)
{
    if (cells <= controls.maxCells)
    {
        return "";
    }
    OStringStream os;
    os  << "it would have more than maxCells " << controls.maxCells
        << " cells (" << controls.name.c_str() << "). Longer edges: 'size' in"
        << " constant/bodies, farSize, minSize, fewer cellsPerGap; if you have"
        << " the memory, raise maxCells";
    return os.str();
}
