/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// Effects that are met where a step ends, and ways that they leave to bodies

#include "scene.H"
#include "untrapped.H"
#include "ways.H"

namespace Foam
{
namespace fsbi
{

//- Corrections of a step before it is taken for one that does not converge
static const label mostCorrections = 25;

//- Difference between the loads on a body along their tangent and where it has
//  gone, over the largest of all: Newton's next correction would leave its square
static const scalar sameLoads = 1e-3;

//- Of all that acts, where it cancels: a body pressed from both sides by its images
static const scalar roundOff = 1e-10;

//- Loads as forces: torques over the radius
static scalar size(const sixVector& load, const scalar radius)
{
    return mag(linear(load)) + mag(angular(load))/radius;
}

//- Loads of effects that balance all others on a way: these change with the
//  velocity in proportion, and are known from the balance at both ends
static List<sixVector> between
(
    const UList<sixVector>& from, const UList<sixVector>& to, const scalar part
)
{
    List<sixVector> loads(from);
    forAll(loads, b)
    {
        forAll(loads[b], k)
        {
            loads[b][k] += part*(to[b][k] - from[b][k]);
        }
    }
    return loads;
}

//- Work by length of a way of what loads there are more than wanted: minus the
//  slope of the energy of all, with what friction takes
static scalar along
(
    const UList<sixVector>& way,
    const UList<bodyRows>& rows,
    const UList<sixVector>& loads,
    const UList<sixVector>& wanted
)
{
    scalar work = 0;
    forAll(rows, b)
    {
        forAll(way[b], k)
        {
            work +=
                rows[b].free[k] ? (loads[b][k] - wanted[b][k])*way[b][k] : 0;
        }
    }
    return work;
}

} // End namespace fsbi
} // End namespace Foam


Foam::List<Foam::fsbi::placement> Foam::fsbi::scene::rigidPlacements() const
{
    List<placement> result(bodies_.rigid.size());
    forAll(result, b)
    {
        result[b] = bodies_.rigid[b].placed();
    }
    return result;
}


std::function<void(const Foam::scalar)> Foam::fsbi::scene::wayFrom
(
    const UList<placement>& start, const UList<sixVector>& ways
)
{
    const List<placement> from(start), to(rigidPlacements());
    const List<sixVector> along(ways);
    return [this, from, to, along](const scalar part)
    {
        forAll(to, b)
        {
            const sixVector& way = along[b];
            bodies_.rigid[b].stand
            (
                part == 1
              ? to[b]
              : placement
                {
                    from[b].centre + part*linear(way),
                    rotationBy(part*angular(way))*from[b].orientation
                }
            );
        }
    };
}


void Foam::fsbi::scene::keepClear(const bool hindered)
{
    if (!steep() || coupling_)      // surfacesApart does so there
    {
        return;
    }
    List<placement> before(bodies_.rigid.size());
    List<sixVector> ways(before.size());
    forAll(before, b)
    {
        const placement now(bodies_.rigid[b].placed());
        before[b] = bodies_.rigid[b].before();
        ways[b] = join
        (
            now.centre - before[b].centre,
            angleOf(now.orientation*conjugate(before[b].orientation))
        );
    }
    const auto place = wayFrom(before, ways);
    if (effects_->clearPart(place) < 1 && hindered)
    {
        place(0);
    }
}


bool Foam::fsbi::scene::effectsAgree
(
    const UList<placement>& evaluated, List<bodyRows>& rows, meeting& met
)
{
    const List<sixVector> expected(fluid_->effectForces(rows).whole);
    List<sixVector> way(rows.size()), wanted(expected), there;
    forAll(way, b)
    {
        way[b] = wayOf(rows[b]);
    }
    const auto place = wayFrom(evaluated, way);
    scalar gross = 0;
    const auto force = [&](const scalar part)
    {
        place(part);
        const loads now(effects_->evaluate());
        there = now.forces().whole;
        gross = now.gross();
        return along(way, rows, there, between(wanted, expected, part));
    };
    const scalar clear = effects_->clearPart(place);
    scalar part = clear;
    const bool falls = force(clear) >= 0;
    if (clear == 1 && agree(there, expected, gross, rows, met))
    {
        return true;
    }
    if (clear < 1 || !falls)
    {
        place(0);
        wanted = wantedAtStart(rows, expected);
        part = lowest(force, clear);
    }
    place(part);

    // the flow stays that around the bodies where the mesh has them
    const List<bodyRows> placed(std::move(rows));
    rows = bodyRowsNow();
    forAll(rows, b)
    {
        rows[b].centre = placed[b].centre;
    }
    return false;
}


Foam::List<Foam::fsbi::sixVector> Foam::fsbi::scene::wantedAtStart
(
    const UList<bodyRows>& rows, const UList<sixVector>& expected
)
{
    List<bodyRows> start(rows);
    forAll(start, b)
    {
        start[b].free = FixedList<bool, 6>(false);
        forAll(start[b].velocity, k)
        {
            if (rows[b].free[k])
            {
                start[b].velocity[k] = rows[b].offset[k]/rows[b].gain;
            }
        }
    }
    List<sixVector> loads, wanted(expected);
    report_.iterations += fluid_->solve(start, loads).iterations;
    forAll(rows, b)
    {
        const sixVector& v = rows[b].velocity;
        const sixVector& v0 = start[b].velocity;
        const sixVector inertia
        (
            join
            (
                rows[b].massRate*(linear(v0) - linear(v)),
                rows[b].inertiaRate & (angular(v0) - angular(v))
            )
        );
        forAll(v, k)
        {
            wanted[b][k] +=
                inertia[k] + bodies_.rigid[b].now().load[k] - loads[b][k];
        }
    }
    return wanted;
}


bool Foam::fsbi::scene::agree
(
    const UList<sixVector>& there,
    const UList<sixVector>& expected,
    const scalar gross,
    const UList<bodyRows>& rows,
    meeting& met
) const
{
    scalar largest = 0, difference = -1;
    forAll(rows, b)
    {
        sixVector d(there[b]);
        forAll(d, k)
        {
            d[k] -= expected[b][k];
        }
        largest = max(largest, size(there[b], rows[b].radius));
        if (size(d, rows[b].radius) > difference)
        {
            difference = size(d, rows[b].radius);
            met.body = bodies_.rigid[b].name();
        }
    }
    met.difference = difference/max(largest, VSMALL);
    return difference <= sameLoads*largest + roundOff*gross;
}


Foam::fsbi::outcome Foam::fsbi::scene::solveFluid()
{
    const untrapped scope;
    List<bodyRows> rows(bodyRowsNow());
    meeting met;
    for (label i = 1; i <= mostCorrections; ++i)
    {
        const List<placement> evaluated(rigidPlacements());
        const outcome solved(solveRows(rows));
        report_.corrections = steep() ? i : report_.corrections;
        if (!solved || !steep() || effectsAgree(evaluated, rows, met))
        {
            return solved;
        }
    }
    return outcome::failed
    (
        "effects are not met where bodies end after "
      + name(mostCorrections) + " corrections: "
      + (
            met.body.empty()
          ? "bodies are still on their way"
          : "loads on body '" + met.body + "' differ by "
          + name(met.difference) + " of the largest"
        )
    );
}
