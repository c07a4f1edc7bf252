/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "contact.H"
#include "neighbours.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{

defineTypeNameAndDebug(contact, 0);
addToRunTimeSelectionTable(effect, contact, entries);

//- Edges of parts of triangles over the radius of a sphere's zone in range
static const scalar finest = 0.15;

//- Of an edge of a body's triangles, whatever the range: 4 096 parts of a triangle
static const label mostDivisions = 64;

//- Part of the distance between surfaces that a way must leave
static const scalar left = 0.3;

//- Ways are looked at in pieces of this part of the smallest body, as surfaces
//  that have passed through each other look as if they were apart
static const scalar piece = 0.5;
static const label mostPieces = 1000;

//- Halvings of the piece in which the way ends
static const label halvings = 12;

//- Friction takes energy out of random ways and, unlike the fluid's resistance,
//  gives none back: there would be no temperature
static void refuseRandomForces(const dictionary& dict)
{
    if (dict.parent().found("thermalMotion"))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'friction' of contact does not go with the effect"
            << " 'thermalMotion', whose random forces are those of the fluid"
            << " alone: remove one of them" << exit(FatalIOError);
    }
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::contact::contact
(
    const dictionary& dict, const effectContext& context
)
:
    effect(context),
    gap_(checkedDictionary(dict).positive("gap")),
    range_(checkedDictionary(dict).positive("range", gap_)),
    pressure_(checkedDictionary(dict).positive("pressure")),
    friction_(checkedDictionary(dict), context_)
{
    const checkedDictionary entries(dict);
    for
    (
        const word key :
        {"gap", "range", "pressure", "friction", "slipSpeed", "libs"}
    )
    {
        entries.found(key);
    }
    entries.finish();
    if (friction_.acts())
    {
        refuseRandomForces(dict);
    }
    reportUnseen("Bodies have no contact with", context_.unseen);
    setDivisions();

    const outcome now(acceptable());
    if (!now)
    {
        FatalIOErrorInFunction(dict)
            << "At the start, " << now.reason.c_str() << exit(FatalIOError);
    }
}


void Foam::fsbi::contact::setDivisions()
{
    divisions_.setSize(context_.bodies.size());
    areas_.setSize(divisions_.size());
    forAll(divisions_, b)
    {
        const immersedBody& body = context_.bodies[b];
        const bodySurface free(body.stressFree());
        divisions_[b] = partsPerEdge(body, range_, finest, mostDivisions);
        for (label i = 0; body.deforms() && i < free.triangles().size(); ++i)
        {
            areas_[b].append(free.triangles()[i].mag(free.points()));
        }
    }
}


Foam::fsbi::loads::spring Foam::fsbi::contact::pressing
(
    const currentSurfaces& now,
    const label body,
    const label other,
    const facing& f
) const
{
    const scalar s = (f.distance - gap_)/range_;
    const scalar k = 0.2*pressure_*f.area;
    const auto site = [&](const label on, const label tri, const point& x)
    {
        const bodySurface& surface = now.surface(on);
        return loads::site
        {
            on, tri, x - now.centre(on),
            tri < 0
          ? vector::one/3
          : materialPoint::nearest
            (
                tri, x, surface.points(), surface.triangles()
            ).weights(),
            areas_[on].size() > 0
        };
    };
    return
    {
        site(body, f.triangle, f.site),
        now.isWall(other)
      ? loads::site() : site(other, f.otherTriangle, f.nearest - f.way),
        k*(1 - 3/sqr(s) + 2/pow3(s))*f.normal,
        6*k*(1 - s)/(pow4(s)*range_)*tensor(sqr(f.normal))
    };
}


void Foam::fsbi::contact::visitAll
(
    const currentSurfaces& now,
    const std::function<void(const label, const label, const facing&)>& visit
) const
{
    forAll(context_.bodies, a)
    {
        for (label b = 0; b < now.size(); ++b)
        {
            const scalar part = now.share(a, b);
            const auto found = [&](facing f)
            {
                f.area *= part;
                visit(a, b, f);
            };
            if (part > 0)
            {
                search(now, a, b, gap_ + range_, found);
            }
        }
    }
}


void Foam::fsbi::contact::apply(loads& l) const
{
    const currentSurfaces now(context_);
    const List<CoulombFriction::motion> moved(friction_.motions());
    visitAll
    (
        now, [&](const label a, const label b, const facing& f)
        {
            const loads::spring normal(pressing(now, a, b, f));
            l.add(normal);
            if (moved.size())
            {
                vector slip;
                l.add(friction_.between(now, moved, b, normal, slip));
            }
        }
    );
}


Foam::scalar Foam::fsbi::contact::energy() const
{
    const currentSurfaces now(context_);
    scalar sum = 0;
    visitAll
    (
        now, [&](const label, const label, const facing& f)
        {
            const scalar s = (f.distance - gap_)/range_;
            sum += f.area*pow3(1 - s)/sqr(s);
        }
    );
    return 0.2*pressure_*range_*sum;
}


Foam::scalar Foam::fsbi::contact::smallest(string& names) const
{
    const currentSurfaces now(context_);
    scalar nearest = range_;
    forAll(context_.bodies, a)
    {
        for (label b = 0; b < now.size(); ++b)
        {
            search
            (
                now, a, b, gap_ + nearest, [&](const facing& f)
                {
                    if (f.distance - gap_ < nearest)
                    {
                        nearest = f.distance - gap_;
                        names =
                            "'" + now.name(a) + "' and '" + now.name(b) + "'";
                    }
                }
            );
        }
    }
    return nearest;
}


Foam::List<Foam::pointField> Foam::fsbi::contact::positions() const
{
    List<pointField> all(context_.bodies.size());
    forAll(all, b)
    {
        all[b] = context_.bodies[b].placedSurface().points();
    }
    return all;
}


Foam::scalar Foam::fsbi::contact::clearPart
(
    const std::function<void(const scalar)>& place
) const
{
    string names;
    place(1);
    const List<pointField> to(positions());
    place(0);
    const List<pointField> from(positions());
    const scalar least = left*smallest(names);
    scalar farthest = 0, thinnest = GREAT;
    forAll(to, b)
    {
        farthest = max(farthest, Foam::sqrt(gMax(magSqr(to[b] - from[b]))));
        thinnest = min(thinnest, boundBox(from[b], false).minDim());
    }
    const auto clear = [&](const scalar part)
    {
        place(part);
        return smallest(names) >= least;
    };
    const label n =
        min(scalar(mostPieces), 1 + std::floor(farthest/(piece*thinnest)));
    for (label i = 1; i <= n; ++i)
    {
        if (clear(scalar(i)/n))
        {
            continue;
        }
        scalar good = scalar(i - 1)/n, bad = scalar(i)/n;
        for (label k = 0; k < halvings; ++k)
        {
            const scalar middle = 0.5*(good + bad);
            (clear(middle) ? good : bad) = middle;
        }
        place(good);
        return good;
    }
    place(1);
    return 1;
}


Foam::fsbi::outcome Foam::fsbi::contact::acceptable() const
{
    string names;
    const scalar distance = smallest(names);
    return
        distance > 0
      ? outcome()
      : outcome::failed
        (
            "the distance between " + names + " is " + name(distance + gap_)
          + ", less than the gap " + name(gap_) + " of contact"
        );
}


void Foam::fsbi::contact::markStopped(boolList& bodies) const
{
    const currentSurfaces now(context_);
    visitAll
    (
        now, [&](const label a, const label b, const facing&)
        {
            bodies[a] = true;
            if (!now.isWall(b))
            {
                bodies[b] = true;
            }
        }
    );
}


void Foam::fsbi::contact::declare(recording& history) const
{
    history.declare
    (
        "contact/nearest", {"distance", "force", "energy"},
        "L, gap + range if larger; M L/T2, sum of the magnitudes; M L2/T2"
    );
    if (friction_.acts())
    {
        history.declare
        (
            "contact/friction", {"force", "dissipated"},
            "M L/T2, sum of the magnitudes; M L2/T2, in the step"
        );
    }
}


void Foam::fsbi::contact::record(recording& history) const
{
    const currentSurfaces now(context_);
    const List<CoulombFriction::motion> moved(friction_.motions());
    scalar sum = 0, friction = 0, dissipated = 0;
    visitAll
    (
        now, [&](const label a, const label b, const facing& f)
        {
            const loads::spring normal(pressing(now, a, b, f));
            sum += mag(normal.force);
            if (moved.size())
            {
                vector slip;
                const loads::spring s
                (
                    friction_.between(now, moved, b, normal, slip)
                );
                friction += mag(s.force);
                dissipated -= s.force & slip;
            }
        }
    );
    string names;
    history.append
    (
        "contact/nearest", scalarList({smallest(names) + gap_, sum, energy()})
    );
    if (friction_.acts())
    {
        history.append
        (
            "contact/friction", scalarList({friction, dissipated})
        );
    }
}
