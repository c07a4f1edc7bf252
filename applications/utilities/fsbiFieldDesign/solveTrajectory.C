/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solveTrajectory.H"

namespace Foam
{
namespace fsbi
{

//- Halvings of the time between two of the trajectory's
static const label maxHalvings = 12;

static fieldDesign::task taskOf
(
    const designEntries& entries, const wantedLoad& w
)
{
    fieldDesign::task t;
    for (const drivenField& field : entries.driven())
    {
        for (label i = 0; i < field.size(); ++i)
        {
            t.sources.append
            (
                {field.unit(i, w.x), field.limit(), field.scale()}
            );
        }
    }
    t.given = entries.given(w.x, w.time);
    t.R = w.R;
    t.force = w.force;
    t.torque = w.torque;
    return t;
}


static void checkAttained
(
    const designEntries& entries, const wantedLoad& w,
    const fieldDesign::solution& s
)
{
    if (s.residual > entries.tolerance() && !entries.report())
    {
        FatalIOErrorInFunction(entries.dict())
            << "At time " << w.time << " the fields cannot make the load"
            << " within their limits: wanted are the force " << w.force
            << " and torque " << w.torque << ", made are " << s.force
            << " and " << s.torque << ", " << s.residual
            << " of the largest load are missing, more than the tolerance "
            << entries.tolerance() << ". More or other coils, higher limits,"
            << " a 'bias', or 'unattainable report;' to do what can be done"
            << exit(FatalIOError);
    }
}


static wantedLoad halfway(const wantedLoad& a, const wantedLoad& b)
{
    return
    {
        0.5*(a.time + b.time), 0.5*(a.x + b.x),
        slerp(quaternion(a.R), quaternion(b.R), 0.5).R(),
        0.5*(a.force + b.force), 0.5*(a.torque + b.torque)
    };
}


//- Appends what is needed between the last time and the next, and the next
static void goOn
(
    const designEntries& entries, const fieldDesign& design,
    const wantedLoad& next, const fieldDesign::solution& there,
    const label halvings, solvedTrajectory& solved
)
{
    const wantedLoad middle(halfway(solved.wanted.last(), next));
    const fieldDesign::solution& last = solved.solutions.last();
    const fieldDesign::task task(taskOf(entries, middle));
    const scalar off = design.madeBy
    (
        task, 0.5*(last.strengths + there.strengths)
    ).residual;
    if (off > max(entries.tolerance(), max(last.residual, there.residual)))
    {
        if (halvings < maxHalvings)
        {
            const fieldDesign::solution s(design.solve(task, last.strengths));
            goOn(entries, design, middle, s, halvings + 1, solved);
            goOn(entries, design, next, there, halvings + 1, solved);
            return;
        }
        solved.switches.append(middle.time);
    }
    checkAttained(entries, next, there);
    solved.wanted.append(next);
    solved.solutions.append(there);
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::solvedTrajectory Foam::fsbi::solveTrajectory
(
    const designEntries& entries, const fieldDesign& design,
    const loadTrajectory& wanted
)
{
    solvedTrajectory solved;
    for (const wantedLoad& w : wanted)
    {
        const bool first = solved.wanted.empty();
        const fieldDesign::solution s
        (
            design.solve
            (
                taskOf(entries, w),
                first ? scalarField() : solved.solutions.last().strengths
            )
        );
        if (first)
        {
            checkAttained(entries, w, s);
            solved.wanted.append(w);
            solved.solutions.append(s);
        }
        else
        {
            goOn(entries, design, w, s, 0, solved);
        }
    }
    return solved;
}
