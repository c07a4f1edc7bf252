/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "CoulombFriction.H"
#include "bodyState.H"

namespace Foam
{
namespace fsbi
{

//- The coefficient; a speed is wanted with one
static scalar readCoefficient(const checkedDictionary& entries)
{
    const scalar mu = entries.getOrDefault<scalar>("friction", 0);
    if (mu < 0)
    {
        FatalIOErrorInFunction(entries.dict())
            << "Entry 'friction' must not be negative, but is " << mu
            << exit(FatalIOError);
    }
    return mu;
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::CoulombFriction::CoulombFriction
(
    const checkedDictionary& entries, const effectContext& context
)
:
    context_(context),
    coefficient_(readCoefficient(entries)),
    slipSpeed_
    (
        acts() || entries.found("slipSpeed")
      ? entries.positive("slipSpeed") : VGREAT
    ),
    dt_(0)
{}


void Foam::fsbi::CoulombFriction::beginStep()
{
    if (!acts())
    {
        return;
    }
    dt_ = context_.time.deltaTValue();
    before_.setSize(context_.bodies.size());
    points_.setSize(before_.size());
    forAll(before_, b)
    {
        const immersedBody& body = context_.bodies[b];
        if (!body.present())
        {
            continue;
        }
        before_[b] = body.placed();
        if (body.deforms())
        {
            points_[b] = body.placedSurface().points() - before_[b].centre;
        }
    }
}


Foam::List<Foam::fsbi::CoulombFriction::motion>
Foam::fsbi::CoulombFriction::motions() const
{
    List<motion> moved(before_.size());
    forAll(moved, b)
    {
        if (!context_.bodies[b].present())
        {
            continue;
        }
        const placement now(context_.bodies[b].placed());
        const quaternion turn
        (
            now.orientation*conjugate(before_[b].orientation)
        );
        moved[b] =
        {
            now.centre - before_[b].centre, turn, angleOf(turn)
        };
    }
    return moved;
}


void Foam::fsbi::CoulombFriction::join
(
    const currentSurfaces& now, loads::site& a, loads::site& b
) const
{
    if (b.body < 0)
    {
        return;
    }
    const bool rigidA = !context_.bodies[a.body].deforms();
    const bool rigidB = !context_.bodies[b.body].deforms();
    const point onA(now.centre(a.body) + a.arm);
    const point itself(now.centre(b.body) + b.arm);
    const point onB(now.nearestImage(itself, onA));
    const point at
    (
        rigidA && rigidB ? point(0.5*(onA + onB)) : rigidA ? onB : onA
    );
    if (rigidA)
    {
        a.arm = at - now.centre(a.body);
    }
    if (rigidB)
    {
        b.arm = at - (onB - itself) - now.centre(b.body);
    }
}


Foam::vector Foam::fsbi::CoulombFriction::wayOf
(
    const currentSurfaces& now,
    const UList<motion>& moved,
    const label surface,
    const loads::site& s
) const
{
    if (now.isWall(surface))
    {
        return dt_*now.wall(surface).velocity;
    }
    const motion& m = moved[surface];
    vector way(m.translation + (m.angle ^ s.arm));
    if (context_.bodies[surface].deforms())
    {
        const bodySurface& there = now.surface(surface);
        const triFace& t = there.triangles()[s.triangle];
        forAll(t, k)
        {
            way +=
                s.weights[k]
               *(
                    there.points()[t[k]] - now.centre(surface)
                  - m.turn.transform(points_[surface][t[k]])
                );
        }
    }
    return way;
}


Foam::fsbi::loads::spring Foam::fsbi::CoulombFriction::between
(
    const currentSurfaces& now,
    const UList<motion>& moved,
    const label other,
    const loads::spring& normal,
    vector& slip
) const
{
    loads::spring s(normal);
    join(now, s.a, s.b);
    const scalar pressing = mag(normal.force);
    const vector n(normal.force/max(pressing, VSMALL));
    slip =
        wayOf(now, moved, s.a.body, s.a) - wayOf(now, moved, other, s.b);
    slip -= (slip & n)*n;

    const scalar length = slipSpeed_*dt_;
    const scalar way = mag(slip);
    const scalar y = way/length;
    const scalar largest = coefficient_*pressing;
    const tensor along(y > 0 ? sqr(slip/way) : symmTensor::zero);
    const tensor across(tensor::I - sqr(n) - along);
    const scalar ratio = y < 1 ? (2 - y)/length : 1/way;
    const scalar slope = y < 1 ? 2*(1 - y)/length : 0;
    s.force = -largest*ratio*slip;
    s.stiffness = largest*(ratio*across + slope*along);
    return s;
}
