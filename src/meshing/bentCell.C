/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bentCell.H"

#include <cmath>

namespace Foam
{
namespace fsbi
{

//- Distance of a side from a body's surface, in its edges
static const scalar clearance = 1;

//- Points of a grid along a side at most
static const label mostPoints = 200;

//- Distance from a side of what is on it, in lengths of the cell
static const scalar onSide = 1e-6;

//- Heights change by no more than this, in spacings of the grid, when they are taken
static const scalar rest = 1e-4;

static const label mostSweeps = 4000;

//- Heights at where a point goes depend on where it goes: rounds until they agree
static const label mostRounds = 100;

//- Part of the room between a side and what stands in the cell that heights may take
static const scalar mostOfRoom = 0.7;


// The surface taken out by its edges
static pointField takenOut(const bodySurface& body, const vector& by)
{
    const scalarField edges(body.pointEdges());
    const pointField& x = body.points();
    const vectorField normals(body.pointAreas());
    pointField out(x.size());
    forAll(out, p)
    {
        out[p] = x[p] + by
          + clearance*edges[p]*normals[p]/max(mag(normals[p]), VSMALL);
    }
    return out;
}


static label wrapped(const label i, const label n, const bool periodic)
{
    return periodic ? (i % n + n) % n : max(label(0), min(n - 1, i));
}

} // End namespace fsbi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::fsbi::bentCell::side::index
(
    const label i, const label j
) const
{
    return wrapped(i, n[0], periodic[0]) + n[0]*wrapped(j, n[1], periodic[1]);
}


Foam::FixedList<Foam::scalar, 2> Foam::fsbi::bentCell::side::place
(
    const point& p
) const
{
    FixedList<scalar, 2> at;
    for (label k = 0; k < 2; ++k)
    {
        at[k] = ((p - origin) & axes[k])/lengths[k]*pieces(k);
    }
    return at;
}


Foam::scalar Foam::fsbi::bentCell::side::part(const point& p) const
{
    if (room[0] == GREAT)
    {
        return 1;
    }
    const scalar way = min(from(p)/room[0], (length - from(p))/room[1]);
    return max(scalar(0), 1 - max(scalar(0), way));
}


Foam::fsbi::bentCell::side Foam::fsbi::bentCell::sideOf
(
    const UList<period>& periods, const label i, const vector& shift,
    const scalar spacing
)
{
    side s;
    s.direction = periods[i].direction();
    s.length = periods[i].length();
    s.room = periods[i].room;
    DynamicList<vector> axes;
    for (const period& other : periods)
    {
        if (&other != &periods[i])
        {
            axes.append(other.direction());
        }
    }
    const label nPeriodic = axes.size();
    if (axes.empty())
    {
        // any in the plane: along its first edge
        const pointField& x = periods[i].side;
        axes.append((x[1] - x[0])/mag(x[1] - x[0]));
    }
    if (axes.size() == 1)
    {
        axes.append(s.direction ^ axes[0]);
    }
    s.origin = periods[i].side[0] + shift;
    for (label k = 0; k < 2; ++k)
    {
        s.axes[k] = axes[k];
        s.periodic[k] = k < nPeriodic;
        const scalarField along((periods[i].side - periods[i].side[0]) & axes[k]);
        s.origin += min(along)*axes[k];
        s.lengths[k] = max(along) - min(along);
        const label pieces = std::ceil(s.lengths[k]/spacing);
        s.n[k] = min(mostPoints, pieces) + (s.periodic[k] ? 0 : 1);
    }
    s.h = scalarField(s.n[0]*s.n[1], Zero);
    return s;
}


void Foam::fsbi::bentCell::bound
(
    const side& s, const bodySurface& body, const vector& image,
    const bool above, scalarField& limit
)
{
    const pointField x(takenOut(body, image));
    for (const triFace& t : body.triangles())
    {
        const auto a = s.place(x[t[0]]), b = s.place(x[t[1]]), c = s.place(x[t[2]]);
        const auto height = [&](const label corner)
        {
            return (x[t[corner]] - s.origin) & s.direction;
        };
        const scalar area =
            (b[0] - a[0])*(c[1] - a[1]) - (c[0] - a[0])*(b[1] - a[1]);
        if (mag(area) < SMALL)
        {
            continue;   // seen from the side
        }
        FixedList<label, 2> first, last;
        for (label k = 0; k < 2; ++k)
        {
            first[k] = std::ceil(min(a[k], min(b[k], c[k])));
            last[k] = std::floor(max(a[k], max(b[k], c[k])));
            if (!s.periodic[k])
            {
                first[k] = max(first[k], label(0));
                last[k] = min(last[k], s.n[k] - 1);
            }
        }
        for (label j = first[1]; j <= last[1]; ++j)
        {
            for (label i = first[0]; i <= last[0]; ++i)
            {
                const scalar u =
                    (
                        (i - a[0])*(c[1] - a[1]) - (c[0] - a[0])*(j - a[1])
                    )/area;
                const scalar v =
                    (
                        (b[0] - a[0])*(j - a[1]) - (i - a[0])*(b[1] - a[1])
                    )/area;
                if (u < 0 || v < 0 || u + v > 1)
                {
                    continue;
                }
                const scalar h =
                    (1 - u - v)*height(0) + u*height(1) + v*height(2);
                scalar& most = limit[s.index(i, j)];
                most = above ? min(most, h) : max(most, h);
            }
        }
    }
}


void Foam::fsbi::bentCell::relax
(
    side& s, const scalarField& low, const scalarField& high,
    const scalar tolerance
)
{
    const auto between = [&](const label p, const scalar h)
    {
        return
            low[p] > high[p]
          ? 0.5*(low[p] + high[p])
          : max(low[p], min(high[p], h));
    };
    forAll(s.h, p)
    {
        s.h[p] = between(p, 0);
    }
    FixedList<scalar, 2> k;
    for (label a = 0; a < 2; ++a)
    {
        k[a] = sqr(s.pieces(a)/s.lengths[a]);
    }
    const scalar over =
        2/(1 + std::sin(constant::mathematical::pi/max(s.n[0], s.n[1])));
    scalar change = GREAT;
    for (label sweep = 0; sweep < mostSweeps && change > tolerance; ++sweep)
    {
        change = 0;
        for (label j = 0; j < s.n[1]; ++j)
        {
            for (label i = 0; i < s.n[0]; ++i)
            {
                const label p = s.index(i, j);
                const scalar mean =
                    (
                        k[0]*(s.h[s.index(i - 1, j)] + s.h[s.index(i + 1, j)])
                      + k[1]*(s.h[s.index(i, j - 1)] + s.h[s.index(i, j + 1)])
                    )/(2*(k[0] + k[1]));
                const scalar h = between(p, s.h[p] + over*(mean - s.h[p]));
                change = max(change, mag(h - s.h[p]));
                s.h[p] = h;
            }
        }
    }
}


Foam::scalar Foam::fsbi::bentCell::height(const side& s, const point& p)
{
    FixedList<scalar, 2> at(s.place(p));
    for (label k = 0; k < 2; ++k)
    {
        if (!s.periodic[k])
        {
            at[k] = max(scalar(0), min(scalar(s.pieces(k)), at[k]));
        }
    }
    const label i = std::floor(at[0]), j = std::floor(at[1]);
    const scalar a = at[0] - i, b = at[1] - j;
    return
        (1 - a)*(1 - b)*s.h[s.index(i, j)]
      + a*(1 - b)*s.h[s.index(i + 1, j)]
      + (1 - a)*b*s.h[s.index(i, j + 1)]
      + a*b*s.h[s.index(i + 1, j + 1)];
}


void Foam::fsbi::bentCell::centre(side& s)
{
    s.moved = 0.5*(min(s.h) + max(s.h));
    s.h -= s.moved;
    s.origin += s.moved*s.direction;
    s.room[0] -= s.moved;
    s.room[1] += s.moved;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::bentCell::bentCell
(
    const UList<period>& periods,
    const UList<bodySurface>& bodies,
    const vector& shift
)
:
    sides_(periods.size()),
    largest_(0)
{
    scalar edge = GREAT;
    for (const bodySurface& body : bodies)
    {
        edge = min(edge, body.meanEdge());
    }
    for (label i = 0; bodies.size() && i < periods.size(); ++i)
    {
        side& s = sides_[i];
        s = sideOf(periods, i, shift, 0.5*edge);
        scalarField low(s.h.size(), -GREAT), high(s.h.size(), GREAT);
        for (const bodySurface& body : bodies)
        {
            bound(s, body, Zero, true, high);
            bound(s, body, -periods[i].translation, false, low);
        }
        const scalar spacing = s.lengths[0]/s.n[0];
        relax(s, low, high, rest*spacing);
        largest_ = max(largest_, max(mag(s.h)));
        if (s.room[0] < GREAT)
        {
            centre(s);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::string Foam::fsbi::bentCell::failure() const
{
    for (const side& s : sides_)
    {
        if (max(mag(s.h)) > mostOfRoom*min(s.room[0], s.room[1]))
        {
            return
                "a periodic side finds no way between bodies and what stands in"
                " the domain";
        }
    }
    return string();
}


Foam::vector Foam::fsbi::bentCell::shift() const
{
    vector sum(Zero);
    for (const side& s : sides_)
    {
        sum += s.moved*s.direction;
    }
    return sum;
}


Foam::point Foam::fsbi::bentCell::corner(const point& p) const
{
    point x(p);
    for (const side& s : sides_)
    {
        const scalar there = s.from(p) + s.moved;
        if (min(mag(there), mag(there - s.length)) < onSide*s.length)
        {
            x += s.moved*s.direction;
        }
    }
    return x;
}


Foam::point Foam::fsbi::bentCell::operator()(const point& p) const
{
    point x(p);
    for (label round = 0; round < mostRounds; ++round)
    {
        point next(p);
        for (const side& s : sides_)
        {
            next += s.part(p)*height(s, x)*s.direction;
        }
        const scalar change = magSqr(next - x);
        x = next;
        if (change <= sqr(SMALL)*magSqr(x))
        {
            break;
        }
    }
    return x;
}


Foam::scalar Foam::fsbi::bentCell::stretch(const point& p) const
{
    const point x(operator()(p));
    scalar steepest = 0;
    for (const side& s : sides_)
    {
        vector slope(Zero);
        for (label k = 0; k < 2; ++k)
        {
            const vector d(s.lengths[k]/s.n[k]*s.axes[k]);
            slope[k] =
                (height(s, x + d) - height(s, x - d))/(2*mag(d));
        }
        steepest = max(steepest, mag(slope));
    }
    return std::sqrt(1 + sqr(steepest));
}
