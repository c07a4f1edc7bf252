/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "proximity.H"
#include "neighbourhood.H"

namespace Foam
{
namespace fsbi
{

//- Mean over the corners of a triangle
static vector atTriangle
(
    const bodySurface& surface, const vectorField& v, const label t
)
{
    const triFace& f = surface.triangles()[t];
    return (v[f[0]] + v[f[1]] + v[f[2]])/3;
}

} // End namespace fsbi
} // End namespace Foam


Foam::scalar Foam::fsbi::timeToContact
(
    const surroundings& around, const scalar reach, string& names
)
{
    const neighbourhood near(around);
    scalar shortest = GREAT;
    const auto approach = [&]
    (
        const neighbourhood::neighbour& n, const vector& v,
        const word& a, const word& b
    )
    {
        const scalar speed = -(v & n.normal);
        if (speed > 0 && n.gap < shortest*speed)
        {
            shortest = max(n.gap, scalar(0))/speed;
            names = "'" + a + "' and '" + b + "'";
        }
    };
    forAll(around.bodies, a)
    {
        const immersedBody& body = around.bodies[a];
        const vectorField va(body.pointVelocity());
        forAll(around.bodies, b)
        {
            if (a == b)
            {
                continue;
            }
            const vectorField vb(around.bodies[b].pointVelocity());
            for (const auto& n : near.between(a, b, reach))
            {
                const vector v
                (
                    atTriangle(near.surface(a), va, n.triangle)
                  - atTriangle(near.surface(b), vb, n.otherTriangle)
                );
                approach(n, v, body.name(), around.bodies[b].name());
            }
        }
        forAll(around.walls, w)
        {
            for (const auto& n : near.toWall(a, w, reach))
            {
                const vector v
                (
                    atTriangle(near.surface(a), va, n.triangle)
                  - around.walls[w].velocity
                );
                approach(n, v, body.name(), around.walls[w].name);
            }
        }
    }
    return shortest;
}
