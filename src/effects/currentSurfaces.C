/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "currentSurfaces.H"
#include "smoothedFacets.H"
#include "wallFacets.H"

Foam::fsbi::currentSurfaces::currentSurfaces
(
    const effectContext& context
)
:
    context_(context),
    surfaces_(context.bodies.size()),
    searches_(context.bodies.size()),
    velocities_(context.bodies.size()),
    sizes_(context.bodies.size(), Zero),
    standsOut_(context.bodies.size(), -1)
{}


Foam::fsbi::currentSurfaces::currentSurfaces
(
    const effectContext& context, const UList<bodySurface>& cut
)
:
    currentSurfaces(context)
{
    forAll(cut, b)
    {
        const pointField& x = cut[b].points();
        if (x.size())
        {
            const sixVector v(context.bodies[b].motion());
            surfaces_.set(b, new bodySurface(cut[b]));
            velocities_.set
            (
                b, new vectorField(linear(v) + (angular(v) ^ (x - centre(b))))
            );
        }
    }
}


const Foam::word& Foam::fsbi::currentSurfaces::name(const label surface) const
{
    return
        isWall(surface)
      ? wall(surface).name
      : context_.bodies[surface].name();
}


const Foam::fsbi::bodySurface& Foam::fsbi::currentSurfaces::surface
(
    const label surface
) const
{
    if (isWall(surface))
    {
        return wall(surface).facets->surface;
    }
    const label body = surface;
    if (!surfaces_.set(body))
    {
        const immersedBody& there = context_.bodies[body];
        surfaces_.set
        (
            body,
            new bodySurface(there.atImage(there.placedSurface()))
        );
    }
    return surfaces_[body];
}


Foam::List<Foam::vector> Foam::fsbi::currentSurfaces::ways
(
    const bool same
) const
{
    List<vector> all(context_.images);
    if (!same)
    {
        all.append(vector(Zero));
    }
    return all;
}


Foam::scalar Foam::fsbi::currentSurfaces::period
(
    const vector& direction
) const
{
    scalar shortest = GREAT;
    for (const vector& way : context_.images)
    {
        if (mag(way ^ direction) < 1e-6*mag(way)*mag(direction))
        {
            shortest = min(shortest, mag(way));
        }
    }
    return shortest < GREAT ? shortest : 0;
}


Foam::vector Foam::fsbi::currentSurfaces::alongPeriod
(
    const vector& normal
) const
{
    vector shortest(Zero);
    for (const vector& way : context_.images)
    {
        const bool across = mag(way & normal) < 1e-6*mag(way);
        if (across && (!mag(shortest) || mag(way) < 0.999*mag(shortest)))
        {
            shortest = way;
        }
    }
    return mag(shortest) ? normalised(shortest) : along(normal);
}


const Foam::fsbi::surfaceDistance& Foam::fsbi::currentSurfaces::search
(
    const label surface
) const
{
    if (isWall(surface))
    {
        return wall(surface).facets->search;
    }
    if (!searches_.set(surface))
    {
        const bodySurface& s = this->surface(surface);
        searches_.set(surface, new surfaceDistance(s.points(), s.triangles()));
    }
    return searches_[surface];
}


Foam::scalar Foam::fsbi::currentSurfaces::share
(
    const label body, const label other
) const
{
    return
        isWall(other) || deforms(body) > deforms(other) ? 1
      : deforms(body) < deforms(other) ? 0
      : 0.5;
}


Foam::scalar Foam::fsbi::currentSurfaces::depth
(
    const label body, const label surface
) const
{
    if (!isWall(surface))
    {
        return 0;
    }
    if (sizes_[body] == 0)
    {
        sizes_[body] = this->surface(body).bounds().mag();
    }
    return sizes_[body];
}


Foam::point Foam::fsbi::currentSurfaces::position
(
    const label surface, const materialPoint& p
) const
{
    const bodySurface& s = this->surface(surface);
    const point flat(p.on(s.points(), s.triangles()));
    if (isWall(surface))
    {
        return flat;
    }
    const immersedBody& body = context_.bodies[surface];
    if (body.hasShape())
    {
        return body.onMeshedShape(flat);
    }
    if (!body.smooth())
    {
        return flat;
    }
    return
        body.smooth()->position({s.triangles()[p.triangle], p.weights()}, s.points());
}


Foam::vector Foam::fsbi::currentSurfaces::normal
(
    const label surface, const materialPoint& p
) const
{
    // so little that it hardly jumps from triangle to triangle, and away from the
    // nearest corner, which stays within this one
    static const scalar step = 1e-5;

    const vector shares(p.weights());
    const label k = findMax(shares);
    const point here(position(surface, p));
    const auto towards = [&](const label corner)
    {
        vector moved(shares);
        moved[k] -= step;
        moved[corner] += step;
        return position(surface, {p.triangle, moved[1], moved[2]}) - here;
    };
    return normalised(vector(towards((k + 1) % 3) ^ towards((k + 2) % 3)));
}


Foam::scalar Foam::fsbi::currentSurfaces::longestEdge
(
    const label body, const label triangle
) const
{
    const bodySurface& s = surface(body);
    const triFace& t = s.triangles()[triangle];
    const point& a = s.points()[t[0]];
    const point& b = s.points()[t[1]];
    const point& c = s.points()[t[2]];
    return Foam::sqrt(max(magSqr(a - b), max(magSqr(b - c), magSqr(c - a))));
}


Foam::scalar Foam::fsbi::currentSurfaces::standsOut(const label surface) const
{
    // an eighth of edge^2/radius, and edges are shorter than radii
    static const scalar part = 0.2;

    if (isWall(surface))
    {
        return 0;
    }
    if (standsOut_[surface] < 0)
    {
        const immersedBody& body = context_.bodies[surface];
        standsOut_[surface] =
            body.hasShape() || body.smooth()
          ? part*this->surface(surface).meanEdge() : 0;
    }
    return standsOut_[surface];
}


void Foam::fsbi::currentSurfaces::takeOut
(
    const label surface, const point& x, nearestPoint& c
) const
{
    if (standsOut(surface) == 0)
    {
        return;
    }
    // a triangle's own normal is that of its middle, and so its nearest point is off
    // by gap edge/radius; once more, and it is by gap/radius of that
    for (label n = 0; n < 2; ++n)
    {
        nearestPoint at(c);
        if (n > 0)
        {
            findImage(surface, c.way, c.nearest, GREAT, at);
        }
        const materialPoint p(there(surface, at));
        const vector up(normal(surface, p));
        c.triangle = at.triangle;
        c.normal = (up & c.normal) < 0 ? -up : up;
        c.gap = (x - c.way - position(surface, p)) & c.normal;
        c.nearest = x - c.gap*c.normal;
    }
}


const Foam::vectorField& Foam::fsbi::currentSurfaces::velocity
(
    const label body
) const
{
    if (!velocities_.set(body))
    {
        velocities_.set
        (
            body, new vectorField(context_.bodies[body].pointVelocity())
        );
    }
    return velocities_[body];
}


Foam::vector Foam::fsbi::currentSurfaces::velocity
(
    const label surface, const materialPoint& p
) const
{
    return
        isWall(surface)
      ? wall(surface).velocity
      : p.on(velocity(surface), this->surface(surface).triangles());
}


Foam::scalar Foam::fsbi::currentSurfaces::fastest(const label surface) const
{
    return
        isWall(surface)
      ? mag(wall(surface).velocity)
      : Foam::sqrt(max(magSqr(velocity(surface))));
}


bool Foam::fsbi::currentSurfaces::find
(
    const label surface, const point& x, const scalar reach, nearestPoint& c
) const
{
    if (isPlane(surface))
    {
        const domainWall& plane = wall(surface);
        const scalar height = plane.distance(x);
        c = {mag(height), x - height*plane.normal, plane.normal, -1};
        return c.gap <= reach;
    }
    if (!present(surface))
    {
        return false;
    }
    bool some = false;
    const auto look = [&](const vector& way)
    {
        const scalar within = some ? c.gap : reach;
        nearestPoint at;
        if (!findImage(surface, way, x, within + standsOut(surface), at))
        {
            return;
        }
        takeOut(surface, x, at);
        if (at.gap < 0)
        {
            at.gap *= -1;
            at.normal *= -1;
        }
        if (at.gap <= within)
        {
            c = at;
            some = true;
        }
    };
    look(Zero);
    for (const vector& way : context_.images)
    {
        look(way);
    }
    return some;
}


bool Foam::fsbi::currentSurfaces::findImage
(
    const label surface,
    const vector& way,
    const point& x,
    const scalar reach,
    nearestPoint& c
) const
{
    const vector to(way + shift(surface));
    const point p(x - to);
    if (!search(surface).find(p, reach, c.gap, c.triangle))
    {
        return false;
    }
    const bodySurface& s = this->surface(surface);
    const triPointRef corners(s.triangles()[c.triangle].tri(s.points()));
    const point on(corners.nearestPoint(p).rawPoint());
    c.nearest = on + to;
    c.way = way;
    // on the surface itself the direction is lost in round-off
    c.normal =
        c.gap > 1e-9*boundBox(s.points(), false).mag()
      ? (p - on)/c.gap : corners.unitNormal();
    return true;
}


bool Foam::fsbi::currentSurfaces::findSide
(
    const label body,
    const label surface,
    const vector& way,
    const point& x,
    const scalar reach,
    nearestPoint& c
) const
{
    if (!findImage(surface, way, x, reach + depth(body, surface), c))
    {
        return false;
    }
    if (search(surface).behind(x - way - shift(surface), c.triangle))
    {
        c.gap *= -1;
        c.normal *= -1;
    }
    return c.gap < reach;
}


Foam::fsbi::materialPoint Foam::fsbi::currentSurfaces::there
(
    const label surface, const nearestPoint& c
) const
{
    if (isPlane(surface))
    {
        return materialPoint();
    }
    const bodySurface& s = this->surface(surface);
    return materialPoint::nearest
    (
        c.triangle, c.nearest - c.way, s.points(), s.triangles()
    );
}


Foam::fsbi::materialPoint Foam::fsbi::currentSurfaces::away
(
    const label surface,
    const point& x,
    const nearestPoint& c,
    const vector& direction,
    const scalar distance
) const
{
    nearestPoint at;
    const auto project = [&](const scalar rho)
    {
        findImage(surface, c.way, c.nearest + rho*direction, GREAT, at);
        return mag(position(surface, there(surface, at)) + c.way - x);
    };

    // a plane would have it at high; curved surfaces nearer or further
    scalar low = 0;
    scalar high = Foam::sqrt(max(sqr(distance) - sqr(c.gap), scalar(0)));
    for (label n = 0; n < 20 && project(high) < distance; ++n)
    {
        low = high;
        high *= 1.1;
    }
    for (label n = 0; n < 40 && high - low > 1e-9*distance; ++n)
    {
        const scalar middle = 0.5*(low + high);
        (project(middle) < distance ? low : high) = middle;
    }
    project(low);
    return there(surface, at);
}
