/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "proximity.H"
#include "neighbours.H"

Foam::scalar Foam::fsbi::timeToContact
(
    const effectContext& context,
    const UList<bodySurface>& cut,
    const scalar reach,
    string& names
)
{
    const currentSurfaces now(context, cut);
    const auto velocity = [&](const label surface, const label triangle)
    {
        return now.velocity(surface, materialPoint::centroid(triangle));
    };
    scalar shortest = GREAT;
    forAll(context.bodies, a)
    {
        for (label b = 0; b < now.size(); ++b)
        {
            for (const neighbour& n : neighbours(now, a, b, reach))
            {
                const vector v
                (
                    velocity(a, n.place.triangle) - velocity(b, n.otherTriangle)
                );
                const scalar speed = -(v & n.normal);
                if (speed > 0 && n.gap < shortest*speed)
                {
                    shortest = max(n.gap, scalar(0))/speed;
                    names = "'" + now.name(a) + "' and '" + now.name(b) + "'";
                }
            }
        }
    }
    return shortest;
}
