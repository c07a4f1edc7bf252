/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "contact.H"

namespace Foam
{
namespace fsbi
{

//- Step of the difference for a shape's normal, in radii: an error of 1e-8
static const scalar small = 1e-4;

//- Normal of a body's described shape at a point of it
static vector normalOf(const immersedBody& body, const point& on)
{
    const vector out(on - body.placed().centre);
    const scalar h = small*body.radius();
    const vector a(currentSurfaces::along(out/mag(out)));
    const vector b(vector(normalised(out)) ^ a);
    const vector n
    (
        (body.onShape(on + h*a) - body.onShape(on - h*a))
      ^ (body.onShape(on + h*b) - body.onShape(on - h*b))
    );
    return normalised((n & out) < 0 ? -n : n);
}

} // End namespace fsbi
} // End namespace Foam


bool Foam::fsbi::contact::face
(
    const currentSurfaces& now,
    const label body,
    const label other,
    const scalar reach,
    facing& f
) const
{
    f.otherTriangle = -1;
    if (now.isPlane(other))
    {
        f.distance = now.wall(other).distance(f.site);
        f.normal = now.wall(other).normal;
    }
    else if (!now.isWall(other) && context_.bodies[other].hasShape())
    {
        const immersedBody& shaped = context_.bodies[other];
        const point site(f.site - f.way - shaped.toImage());
        const point on(shaped.onShape(site));
        f.normal = normalOf(shaped, on);
        f.distance = (site - on) & f.normal;
    }
    else
    {
        currentSurfaces::nearestPoint c;
        if (!now.findSide(body, other, f.way, f.site, reach, c))
        {
            return false;
        }
        f.distance = c.gap;
        f.normal = c.normal;
        f.otherTriangle = c.triangle;
    }
    f.nearest = f.site - f.distance*f.normal;
    return f.distance < reach;
}


void Foam::fsbi::contact::divide
(
    const currentSurfaces& now,
    const label body,
    const label other,
    const label triangle,
    const vector& way,
    const scalar reach,
    const visitor& visit
) const
{
    const immersedBody& b = context_.bodies[body];
    const bodySurface& s = now.surface(body);
    const triFace& t = s.triangles()[triangle];
    const point& origin = s.points()[t[0]];
    const label n = divisions_[body];
    const vector u((s.points()[t[1]] - origin)/n);
    const vector v((s.points()[t[2]] - origin)/n);
    const auto part = [&](const scalar i, const scalar j, const scalar side)
    {
        const auto place = [&](const scalar k, const scalar m)
        {
            const point flat(origin + k*u + m*v);
            return b.hasShape() ? b.onMeshedShape(flat) : flat;
        };
        facing f;
        f.triangle = triangle;
        f.way = way;
        f.site = place(i + side/3, j + side/3);
        if (!face(now, body, other, reach, f))
        {
            return;
        }
        if (areas_[body].size())
        {
            f.area = areas_[body][triangle]/sqr(scalar(n));
        }
        else
        {
            const point corner(place(i, j));
            f.area =
                0.5*mag
                (
                    (place(i + side, j) - corner)
                  ^ (place(i, j + side) - corner)
                );
        }
        visit(f);
    };
    materialPoint::visitParts(n, part);
}


void Foam::fsbi::contact::search
(
    const currentSurfaces& now,
    const label body,
    const label other,
    const scalar reach,
    const visitor& visit
) const
{
    if (!now.present(body) || !now.present(other))
    {
        return;
    }
    // no point of a triangle is farther from its centre than two thirds of
    // its longest edge, nor is the shape above it
    const bodySurface& s = now.surface(body);
    scalarField near(s.triangles().size());
    forAll(near, t)
    {
        near[t] = reach + now.longestEdge(body, t);
    }
    const auto searchImage = [&](const vector& way, const boundBox& around)
    {
        forAll(near, t)
        {
            facing f;
            f.way = way;
            f.site = now.centroid(body, t);
            if (around.contains(f.site) && face(now, body, other, near[t], f))
            {
                divide(now, body, other, t, way, reach, visit);
            }
        }
    };
    if (now.isPlane(other))
    {
        searchImage(Zero, boundBox::greatBox);
        return;
    }
    for (const vector& way : now.ways(body == other))
    {
        const boundBox around
        (
            now.bounds(other, way, max(near) + now.depth(body, other))
        );
        if (around.overlaps(s.bounds()))
        {
            searchImage(way, around);
        }
    }
}
