/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceRetriangulation.H"
#include "straddling.H"
#include "surfaceParts.H"
#include "surfaceRemesher.H"

namespace Foam
{
namespace fsbi
{

//- How far a part of the described surface lies outside of a facet, on average:
//  exact for one that is quadratic over it
static scalar outsideOf
(
    const pointField& p,
    const triFace& t,
    const label part,
    const surfaceParts& described
)
{
    const vector n(t.unitNormal(p));
    scalar sum = 0;
    for (label i = 0; i < 3; ++i)
    {
        const point middle(0.5*(p[t[i]] + p[t[(i + 1) % 3]]));
        sum +=
            (described.nearest(middle, labelPair(part, part)) - middle) & n;
    }
    return sum/3;
}

} // End namespace fsbi
} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::fsbi::bodySurface Foam::fsbi::retriangulated
(
    const bodySurface& given,
    const labelUList& patches,
    const scalar featureAngle,
    const sizeFunction& size,
    labelList& newPatches
)
{
    const label sweeps = 3;             // each leaves a small part of the rest
    const surfaceParts described(given, patches, featureAngle);
    surfaceRemesher remesher
    (
        given, described.parts(), described.corners(), size,
        [&](const point& x, const labelPair& parts)
        {
            return described.nearest(x, parts);
        }
    );
    const bodySurface even(remesher.run());
    pointField points(even.points());
    for (label sweep = 0; sweep < sweeps; ++sweep)
    {
        const pointField now(points);
        straddle
        (
            points, even.triangles(), remesher.parts(), [&](const label i)
            {
                return outsideOf
                (
                    now, even.triangles()[i], remesher.parts()[i], described
                );
            }
        );
    }
    newPatches.setSize(remesher.parts().size());
    forAll(newPatches, i)
    {
        newPatches[i] = described.patch(remesher.parts()[i]);
    }
    return bodySurface(points, even.triangles());
}
