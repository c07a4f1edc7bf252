/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "neighbourhood.H"

Foam::fsbi::neighbourhood::neighbourhood(const surroundings& around)
:
    around_(around),
    surfaces_(around.bodies.size()),
    distances_(around.bodies.size())
{
    forAll(surfaces_, b)
    {
        surfaces_.set(b, new bodySurface(around.bodies[b].placedSurface()));
    }
}


const Foam::fsbi::surfaceDistance& Foam::fsbi::neighbourhood::distance
(
    const label b
) const
{
    if (!distances_.set(b))
    {
        distances_.set
        (
            b,
            new surfaceDistance
            (
                surfaces_[b].points(), surfaces_[b].triangles()
            )
        );
    }
    return distances_[b];
}


Foam::fsbi::neighbourhood::neighbour Foam::fsbi::neighbourhood::centreOf
(
    const label b, const label t
) const
{
    const triFace& f = surfaces_[b].triangles()[t];
    const pointField& x = surfaces_[b].points();
    neighbour n;
    n.triangle = t;
    n.centre = (x[f[0]] + x[f[1]] + x[f[2]])/3;
    n.area = 0.5*((x[f[1]] - x[f[0]]) ^ (x[f[2]] - x[f[0]]));
    n.otherTriangle = -1;
    return n;
}


Foam::DynamicList<Foam::fsbi::neighbourhood::neighbour>
Foam::fsbi::neighbourhood::between
(
    const label a, const label b, const scalar reach
) const
{
    DynamicList<neighbour> found;
    boundBox box(surfaces_[b].bounds());
    box.min() -= reach*vector::one;
    box.max() += reach*vector::one;
    if (!box.overlaps(surfaces_[a].bounds()))
    {
        return found;
    }
    const pointField& x = surfaces_[b].points();
    forAll(surfaces_[a].triangles(), t)
    {
        neighbour n(centreOf(a, t));
        if
        (
            !box.contains(n.centre)
         || !distance(b).find
            (
                n.centre, reach, n.nearest, n.otherTriangle
            )
        )
        {
            continue;
        }
        // which side: by the nearest triangle's own normal
        const triFace& f = surfaces_[b].triangles()[n.otherTriangle];
        const vector outwards
        (
            (x[f[1]] - x[f[0]]) ^ (x[f[2]] - x[f[0]])
        );
        const vector apart(n.centre - n.nearest);
        const bool inside = (apart & outwards) < 0;
        n.gap = inside ? -mag(apart) : mag(apart);
        n.normal =
            mag(apart) > SMALL*mag(n.centre - x[f[0]])
          ? apart/n.gap
          : outwards/mag(outwards);
        found.append(n);
    }
    return found;
}


Foam::DynamicList<Foam::fsbi::neighbourhood::neighbour>
Foam::fsbi::neighbourhood::toWall
(
    const label a, const label w, const scalar reach
) const
{
    const planeWall& wall = around_.walls[w];
    DynamicList<neighbour> found;
    forAll(surfaces_[a].triangles(), t)
    {
        neighbour n(centreOf(a, t));
        n.gap = wall.distance(n.centre);
        if (n.gap < reach)
        {
            n.normal = wall.normal;
            n.nearest = n.centre - n.gap*wall.normal;
            found.append(n);
        }
    }
    return found;
}
