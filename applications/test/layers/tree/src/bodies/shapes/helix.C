/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "helix.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"

using Foam::constant::mathematical::pi;
using Foam::constant::mathematical::twoPi;

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(helix, 0);
    addToRunTimeSelectionTable(bodyShape, helix, dictionary);
}
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsbi::helix::tube::stitch(const ring& a, const ring& b)
{
    // start at the points of b and a that are nearest in angle
    const label start =
        label(std::lround((a.offset - b.offset)*b.n/twoPi));
    const auto angleA = [&](const label i)
    {
        return a.offset + twoPi*i/a.n;
    };
    const auto angleB = [&](const label j)
    {
        return b.offset + twoPi*j/b.n;
    };
    const auto pointA = [&](const label i)
    {
        return a.first + i % a.n;
    };
    const auto pointB = [&](const label j)
    {
        return b.first + (j % b.n + b.n) % b.n;
    };

    label i = 0, j = start;
    while (i < a.n || j < start + b.n)
    {
        const bool onA =
            j == start + b.n
         || (
                i < a.n
             && mag(angleA(i + 1) - angleB(j)) <= mag(angleA(i) - angleB(j + 1))
            );
        // a ring of one point is a pole: it has no edges
        if (onA)
        {
            if (a.n > 1)
            {
                triangles.append(triFace(pointA(i), pointA(i + 1), pointB(j)));
            }
            ++i;
        }
        else
        {
            if (b.n > 1)
            {
                triangles.append(triFace(pointA(i), pointB(j + 1), pointB(j)));
            }
            ++j;
        }
    }
}


void Foam::fsbi::helix::tube::add
(
    const point& centre, const tensor& axes,
    const scalar radius, const label n, const scalar turn
)
{
    const ring next{points.size(), n, turn};
    for (label i = 0; i < n; ++i)
    {
        const scalar angle = turn + twoPi*i/n;
        points.append
        (
            centre
          + radius*(Foam::cos(angle)*axes.x() + Foam::sin(angle)*axes.y())
        );
    }
    if (next.first > 0)
    {
        stitch(last, next);
    }
    last = next;
}


Foam::scalar Foam::fsbi::helix::arc() const
{
    return turns_*Foam::sqrt(sqr(twoPi*radius_) + sqr(pitch_));
}


Foam::point Foam::fsbi::helix::centreline(const scalar s) const
{
    const scalar sign = right_ ? 1 : -1;
    return point
    (
        radius_*Foam::cos(s),
        sign*radius_*Foam::sin(s),
        pitch_*(s/twoPi - turns_/2)
    );
}


Foam::tensor Foam::fsbi::helix::axes(const scalar s) const
{
    const scalar sign = right_ ? 1 : -1;
    const vector normal(Foam::cos(s), sign*Foam::sin(s), 0);
    vector tangent
    (
        -radius_*Foam::sin(s), sign*radius_*Foam::cos(s), pitch_/twoPi
    );
    tangent /= mag(tangent);
    return tensor(normal, tangent ^ normal, tangent);
}


Foam::fsbi::bodySurface Foam::fsbi::helix::sweep
(
    const scalar size, const scalar filament
) const
{
    // rows of equilateral triangles are sqrt(3)/2 edges apart
    const scalar row = Foam::sqrt(3.0)/2;
    const label around =
        max(label(8), label(std::lround(twoPi*filamentRadius_/size)));
    const scalar edge = twoPi*filamentRadius_/around;
    const label along = max(1, label(std::lround(arc()/(row*edge))));
    const label cap =
        max(2, label(std::lround(pi/2*filamentRadius_/(row*edge))));
    const scalar end = twoPi*turns_;

    tube t;
    scalar turn = 0;
    const auto capRing = [&](const scalar s, const scalar latitude)
    {
        const tensor frame(axes(s));
        const label n =
            mag(latitude) > 0.999*pi/2
          ? 1 : max(3, label(std::lround(around*Foam::cos(latitude))));
        t.add
        (
            centreline(s) + filament*Foam::sin(latitude)*frame.z(),
            frame, filament*Foam::cos(latitude), n, turn
        );
        turn += pi/around;
    };
    for (label i = 0; i < cap; ++i)
    {
        capRing(0, -pi/2*(1 - scalar(i)/cap));
    }
    for (label i = 0; i <= along; ++i)
    {
        const scalar s = end*i/along;
        t.add(centreline(s), axes(s), filament, around, turn);
        turn += pi/around;
    }
    for (label i = 1; i <= cap; ++i)
    {
        capRing(end, pi/2*scalar(i)/cap);
    }
    return bodySurface
    (
        pointField(std::move(t.points)), List<triFace>(std::move(t.triangles))
    );
}


Foam::fsbi::bodySurface Foam::fsbi::helix::make(const scalar size) const
{
    checkNumber(twoPi*filamentRadius_*(arc() + 2*filamentRadius_), size);
    const scalar exact =
        pi*sqr(filamentRadius_)*(arc() + 4*filamentRadius_/3);
    scalar filament = filamentRadius_;
    bodySurface surface(sweep(size, filament));
    for (label i = 0; i < 4; ++i)
    {
        filament *= Foam::sqrt(exact/surface.volume());
        surface = sweep(size, filament);
    }
    return surface.standingFor(1, filament - filamentRadius_);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::helix::helix(const dictionary& dict)
:
    bodyShape(dict),
    radius_(entries_.positive("radius")),
    pitch_(entries_.positive("pitch")),
    filamentRadius_(entries_.positive("filamentRadius")),
    turns_(entries_.positive("turns")),
    right_(entries_.choice("handedness", {"right", "left"}, "right") == "right")
{
    entries_.finish();
    if (filamentRadius_ >= radius_)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'filamentRadius' must be below 'radius'"
            << exit(FatalIOError);
    }
}
