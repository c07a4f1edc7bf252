/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "repulsion.H"
#include "addToRunTimeSelectionTable.H"
#include <algorithm>

namespace Foam
{
namespace fsbi
{

defineTypeNameAndDebug(repulsion, 0);
addToRunTimeSelectionTable(effect, repulsion, entries);

//- Part of the range below which the law goes on along its tangent: a guess of
//  the end of a step may lie beyond the minimum gap
static const scalar nearest = 0.01;

//- Edges of parts of triangles, in radii of the zone within the range
static const scalar finest = 0.25;

static const label mostDivisions = 16;

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::repulsion::repulsion
(
    const dictionary& dict, const effectContext& context
)
:
    effect(context),
    perTriangle_
    (
        checkedDictionary(dict).choice
        (
            "form", {"pressure", "pointForce"}, "pressure"
        ) == "pointForce"
    ),
    strength_(checkedDictionary(dict).get<scalar>("strength")),
    range_(checkedDictionary(dict).positive("range")),
    minimumGap_(dict.getOrDefault<scalar>("minimumGap", 0))
{
    const checkedDictionary entries(dict);
    for (const word key : {"form", "strength", "range", "minimumGap", "libs"})
    {
        entries.found(key);
    }
    if (strength_ < 0 || minimumGap_ < 0)
    {
        FatalIOErrorInFunction(dict)
            << "Entries 'strength' and 'minimumGap' must not be negative"
            << exit(FatalIOError);
    }
    entries.found("between") ? readPairs(dict) : findAll();
    entries.finish();
    reportUnseen("Nothing is repelled from", unrepelled());
    for (const immersedBody& body : context_.bodies)
    {
        divisions_.append(partsPerEdge(body, range_, finest, mostDivisions));
    }

    const outcome now(acceptable());
    if (!now)
    {
        FatalIOErrorInFunction(dict)
            << "At the start, " << now.reason.c_str() << exit(FatalIOError);
    }
}


void Foam::fsbi::repulsion::findAll()
{
    const currentSurfaces now(context_);
    forAll(context_.bodies, a)
    {
        // itself: its images
        const label first = context_.images.empty() ? a + 1 : a;
        for (label b = first; b < now.size(); ++b)
        {
            pairs_.append(pair({a, b}));
        }
    }
}


void Foam::fsbi::repulsion::readPairs(const dictionary& dict)
{
    const wordList valid(context_.names());
    for (const wordList& names : dict.get<List<wordList>>("between"))
    {
        labelList numbers;
        for (const word& name : names)
        {
            numbers.append(valid.find(name));
            if (numbers.last() < 0)
            {
                FatalIOErrorInFunction(dict)
                    << "There is no body (constant/bodies) or wall '"
                    << name << "' for 'between'"
                    << context_.unseenReason(name).c_str() << "; valid are "
                    << flatOutput(valid) << exit(FatalIOError);
            }
        }
        sort(numbers);      // bodies before walls
        if
        (
            numbers.size() != 2 || numbers[0] == numbers[1]
         || numbers[0] >= context_.bodies.size()
        )
        {
            FatalIOErrorInFunction(dict)
                << flatOutput(names) << " in 'between' is no pair of two"
                << " bodies, or of a body and a wall" << exit(FatalIOError);
        }
        pairs_.append(pair({numbers[0], numbers[1]}));
    }
}


Foam::label Foam::fsbi::repulsion::divisions
(
    const currentSurfaces& now, const label body, const label other
) const
{
    return perTriangle_ || now.deforms(other) ? 1 : divisions_[body];
}


Foam::List<Foam::fsbi::unseenPatch> Foam::fsbi::repulsion::unrepelled() const
{
    List<unseenPatch> others(context_.unseen);
    forAll(context_.walls, w)
    {
        const label wall = context_.bodies.size() + w;
        const auto has = [=](const pair& p) { return p[1] == wall; };
        if (std::none_of(pairs_.begin(), pairs_.end(), has))
        {
            others.append({context_.walls[w].name, "not in 'between'"});
        }
    }
    return others;
}


template<class Visitor>
void Foam::fsbi::repulsion::visit(const Visitor& visitor) const
{
    const currentSurfaces now(context_);
    const scalar reach = minimumGap_ + range_;
    const auto from = [&](const label body, const label other)
    {
        const scalar part = now.share(body, other);
        if (part == 0)
        {
            return;
        }
        const label parts = divisions(now, body, other);
        for (const neighbour& n : neighbours(now, body, other, reach, parts))
        {
            visitor(now, n, body, other, part);
        }
    };
    for (const pair& p : pairs_)
    {
        from(p[0], p[1]);
        if (!now.isWall(p[1]) && p[0] != p[1])  // images see each other from both
        {
            from(p[1], p[0]);
        }
    }
}


void Foam::fsbi::repulsion::push
(
    const currentSurfaces& now,
    const neighbour& n,
    const label body,
    const label other,
    const scalar part,
    loads& l
) const
{
    const scalar area =
        now.area(body, n.place.triangle)/sqr(scalar(divisions(now, body, other)));
    const scalar k = part*strength_*(perTriangle_ ? 1 : area);
    const scalar gap = n.gap - minimumGap_;
    const scalar d = max(gap, nearest*range_);
    const scalar slope = 3/pow4(d);
    const auto site = [&](const label on, const materialPoint& p, const point& x)
    {
        return
            loads::site{on, p.triangle, x - now.centre(on), p.weights()};
    };
    const auto there = [&]
    {
        const point x(n.nearest - n.way);
        const bodySurface& s = now.surface(other);
        return site
        (
            other,
            materialPoint::nearest
            (
                n.otherTriangle, x, s.points(), s.triangles()
            ),
            x
        );
    };
    l.add
    (
        {
            site(body, n.place, n.centre),
            now.isWall(other) ? loads::site() : there(),
            k*(1/pow3(d) - 1/pow3(range_) + slope*(d - gap))*n.normal,
            k*slope*tensor(sqr(n.normal))
        }
    );
}


void Foam::fsbi::repulsion::apply(loads& l) const
{
    if (strength_ == 0)
    {
        return;
    }
    visit
    (
        [&]
        (
            const currentSurfaces& now, const neighbour& n,
            const label a, const label b, const scalar part
        )
        {
            push(now, n, a, b, part, l);
        }
    );
}


bool Foam::fsbi::repulsion::steep() const
{
    bool rigid = true;
    for (const immersedBody& body : context_.bodies)
    {
        rigid = rigid && !body.deforms();
    }
    return rigid && strength_ > 0;
}


Foam::scalar Foam::fsbi::repulsion::smallestGap(string& names) const
{
    const wordList all(context_.names());
    scalar smallest = GREAT;
    visit
    (
        [&]
        (
            const currentSurfaces&, const neighbour& n,
            const label a, const label b, scalar
        )
        {
            if (n.gap < smallest)
            {
                smallest = n.gap;
                names = "'" + all[a] + "' and '" + all[b] + "'";
            }
        }
    );
    return smallest;
}


Foam::fsbi::outcome Foam::fsbi::repulsion::acceptable() const
{
    string names;
    const scalar gap = smallestGap(names);
    return
        gap > minimumGap_
      ? outcome()
      : outcome::failed
        (
            "the gap between " + names + " is " + name(gap)
          + ", less than minimumGap " + name(minimumGap_) + " of repulsion"
        );
}


void Foam::fsbi::repulsion::declare(recording& history) const
{
    history.declare("repulsion/gap", {"smallest"}, "L; range if larger");
}


void Foam::fsbi::repulsion::record(recording& history) const
{
    string names;
    const scalar reach = minimumGap_ + range_;
    history.append
    (
        "repulsion/gap", scalarList(1, min(smallestGap(names), reach))
    );
}
