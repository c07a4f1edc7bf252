/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// Effects that are met where a step ends, and ways that they leave to bodies

#include "scene.H"
#include "untrapped.H"

namespace Foam
{
namespace fsbi
{

//- Corrections of a step before it is taken for one that does not converge
static const label mostCorrections = 40;

//- Difference between the loads on a body along their tangent and where it has
//  gone, over the largest of all: Newton's next correction would leave its square
static const scalar sameLoads = 1e-3;

//- Loads as forces: torques over the radius
static scalar size(const sixVector& load, const scalar radius)
{
    return mag(linear(load)) + mag(angular(load))/radius;
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


Foam::scalar Foam::fsbi::scene::keepApart(const UList<placement>& from)
{
    const List<placement> to(rigidPlacements());
    const auto place = [&](const scalar part)
    {
        forAll(to, b)
        {
            const placement& a = from[b];
            const vector turn
            (
                angleOf(to[b].orientation*conjugate(a.orientation))
            );
            bodies_.rigid[b].stand
            (
                part == 1
              ? to[b]
              : placement
                {
                    a.centre + part*(to[b].centre - a.centre),
                    rotationBy(part*turn)*a.orientation
                }
            );
        }
    };
    return effects_->clearPart(place);
}


bool Foam::fsbi::scene::effectsAgree
(
    const UList<placement>& evaluated, List<bodyRows>& rows
)
{
    const List<sixVector> expected(fluid_->effectForces(rows).whole);
    if (keepApart(evaluated) == 1)
    {
        const List<sixVector> there(effects_->evaluate().forces().whole);
        scalar largest = 0, difference = 0;
        forAll(rows, b)
        {
            sixVector d(there[b]);
            forAll(d, k)
            {
                d[k] -= expected[b][k];
            }
            largest = max(largest, size(there[b], rows[b].radius));
            difference = max(difference, size(d, rows[b].radius));
        }
        if (difference <= sameLoads*largest)
        {
            return true;
        }
    }
    // the flow stays that around the bodies where the mesh has them
    const List<bodyRows> placed(std::move(rows));
    rows = bodyRowsNow();
    forAll(rows, b)
    {
        rows[b].centre = placed[b].centre;
    }
    return false;
}


Foam::fsbi::outcome Foam::fsbi::scene::solveFluid()
{
    const untrapped scope;
    List<bodyRows> rows(bodyRowsNow());
    for (label i = 1; i <= mostCorrections; ++i)
    {
        const List<placement> evaluated(rigidPlacements());
        const outcome solved(solveRows(rows));
        report_.corrections = steep() ? i : report_.corrections;
        if (!solved || !steep() || effectsAgree(evaluated, rows))
        {
            return solved;
        }
    }
    return outcome::failed
    (
        "effects are not met where bodies end after "
      + name(mostCorrections) + " corrections"
    );
}
