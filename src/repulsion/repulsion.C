/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "repulsion.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{

defineTypeNameAndDebug(repulsion, 0);
addToRunTimeSelectionTable(effect, repulsion, entries);

//- Part of the range at which the pressure stops to grow: a guess of the end of
//  a step may lie beyond the minimum gap, a step that stands may not
static const scalar nearest = 0.01;

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::repulsion::repulsion
(
    const dictionary& dict, const surroundings& around
)
:
    effect(around),
    strength_(checkedDictionary(dict).get<scalar>("strength")),
    range_(checkedDictionary(dict).positive("range")),
    minimumGap_(dict.getOrDefault<scalar>("minimumGap", 0))
{
    const checkedDictionary entries(dict);
    for (const word key : {"strength", "range", "minimumGap", "libs"})
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

    string reason;
    if (!acceptable(reason))
    {
        FatalIOErrorInFunction(dict)
            << "At the start, " << reason.c_str() << exit(FatalIOError);
    }
}


void Foam::fsbi::repulsion::findAll()
{
    forAll(around_.bodies, a)
    {
        for (label b = a + 1; b < around_.bodies.size(); ++b)
        {
            pairs_.append(pair{a, b, -1});
        }
        forAll(around_.walls, w)
        {
            pairs_.append(pair{a, -1, w});
        }
    }
}


void Foam::fsbi::repulsion::readPairs(const dictionary& dict)
{
    for (const wordList& names : dict.get<List<wordList>>("between"))
    {
        pair p{-1, -1, -1};
        for (const word& name : names)
        {
            const label b = around_.findBody(name);
            const label w = around_.findWall(name);
            if (b < 0 && w < 0)
            {
                FatalIOErrorInFunction(dict)
                    << "There is no body or plane wall '" << name
                    << "' for 'between'; valid are "
                    << flatOutput(around_.names()) << exit(FatalIOError);
            }
            label& place = b < 0 ? p.wall : p.a < 0 ? p.a : p.b;
            place = b < 0 ? w : b;
        }
        if (names.size() != 2 || p.a < 0 || p.a == p.b)
        {
            FatalIOErrorInFunction(dict)
                << flatOutput(names) << " in 'between' is no pair of two"
                << " bodies, or of a body and a wall" << exit(FatalIOError);
        }
        pairs_.append(p);
    }
}


Foam::DynamicList<Foam::fsbi::neighbourhood::neighbour>
Foam::fsbi::repulsion::near
(
    const neighbourhood& n, const pair& p, const bool fromFirst
) const
{
    const scalar reach = minimumGap_ + range_;
    return
        p.b < 0 ? n.toWall(p.a, p.wall, reach)
      : fromFirst ? n.between(p.a, p.b, reach)
      : n.between(p.b, p.a, reach);
}


template<class Visitor>
void Foam::fsbi::repulsion::visit(const Visitor& visitor) const
{
    const neighbourhood all(around_);
    for (const pair& p : pairs_)
    {
        for (const bool fromFirst : {true, false})
        {
            if (!fromFirst && p.b < 0)
            {
                continue;
            }
            for (const auto& n : near(all, p, fromFirst))
            {
                visitor(n, p, fromFirst);
            }
        }
    }
}


void Foam::fsbi::repulsion::push
(
    const neighbourhood::neighbour& n,
    const pair& p,
    const bool fromFirst,
    loads& l
) const
{
    const scalar d = max(n.gap - minimumGap_, nearest*range_);
    const scalar k = part(p)*strength_*mag(n.area);
    const label self = fromFirst ? p.a : p.b;
    const label other = fromFirst ? p.b : p.a;
    const auto site = [&](const label body, const label tri, const point& x)
    {
        return
            body < 0
          ? loads::site()
          : loads::site
            {
                body, tri, x - around_.bodies[body].placed().centre
            };
    };
    l.add
    (
        {
            site(self, n.triangle, n.centre),
            site(p.b < 0 ? loads::fixed : other, n.otherTriangle, n.nearest),
            k*(1/pow3(d) - 1/pow3(range_))*n.normal,
            (3*k/pow4(d))*tensor(sqr(n.normal))
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
        [&](const neighbourhood::neighbour& n, const pair& p, const bool first)
        {
            push(n, p, first, l);
        }
    );
}


Foam::scalar Foam::fsbi::repulsion::smallestGap(string& names) const
{
    scalar smallest = GREAT;
    visit
    (
        [&](const neighbourhood::neighbour& n, const pair& p, bool)
        {
            if (n.gap < smallest)
            {
                smallest = n.gap;
                names =
                    "'" + around_.bodies[p.a].name() + "' and '"
                  + (
                        p.b < 0 ? around_.walls[p.wall].name
                      : around_.bodies[p.b].name()
                    )
                  + "'";
            }
        }
    );
    return smallest;
}


bool Foam::fsbi::repulsion::acceptable(string& reason) const
{
    string names;
    const scalar gap = smallestGap(names);
    if (gap > minimumGap_)
    {
        return true;
    }
    reason =
        "the gap between " + names + " is " + name(gap)
      + ", less than minimumGap " + name(minimumGap_) + " of repulsion";
    return false;
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
