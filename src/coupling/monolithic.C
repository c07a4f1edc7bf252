/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "monolithic.H"
#include "solidSolver.H"
#include "addToRunTimeSelectionTable.H"

#include <cmath>

namespace Foam
{
namespace fsbi
{

defineTypeNameAndDebug(monolithic, 0);
addToRunTimeSelectionTable(couplingScheme, monolithic, entries);

//- Corrections of a step before it is taken for one that does not converge
static const label maxCorrections = 15;

//- The same where bodies touch: corrections may be shortened then
static const label maxInContact = 60;

//- Part of the residual of two corrections before above which they go back and
//  forth, where what touches changes from one to the next and back
static const scalar returns = 0.5;

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::monolithic::monolithic
(
    fluidRegion& fluid,
    UPtrList<solidRegion>& solids,
    const dictionary& dict
)
:
    couplingScheme(fluid, solids, dict)
{
    for (const solidRegion& solid : solids)
    {
        solidSolver::reportUnused
        (
            solid.mesh().solutionDict().subOrEmptyDict("solid"), solid.name()
        );
    }
}


Foam::fsbi::outcome Foam::fsbi::monolithic::corrected() const
{
    if (!std::isfinite(report_.residual))
    {
        return outcome::failed
        (
            "the solution is not finite: the scene has numbers that are"
            " too large, or cells that are too thin"
        );
    }
    return
        report_.failure.empty() ? outcome() : outcome::failed(report_.failure);
}


Foam::fsbi::outcome Foam::fsbi::monolithic::solve(List<bodyRows>& rows)
{
    label iterations = 0;
    const label most = apart_ ? maxInContact : maxCorrections;
    FixedList<scalar, 2> residuals(GREAT);
    for (label i = 0; i <= most; ++i)
    {
        if (apart_)
        {
            apart_->begin();
        }
        report_ = fluid_.correct(rows, elastic_, i == 0);
        iterations += report_.iterations;
        report_.iterations = iterations;
        report_.corrections = i;
        if (report_.converged)
        {
            return outcome();
        }
        const outcome good(corrected());
        if (!good)
        {
            return good;
        }
        for (solidRegion& solid : solids_)
        {
            solid.follow();
        }
        const bool back = report_.residual > returns*residuals[i % 2];
        residuals[i % 2] = report_.residual;
        const outcome apart
        (
            apart_ ? keepApart(back ? 0.5 : 1, rows) : outcome()
        );
        if (!apart)
        {
            return apart;
        }
        const outcome moved(moveMesh());
        if (!moved)
        {
            return moved;
        }
    }
    return outcome::failed
    (
        "fluid and bodies do not agree after " + name(most)
      + " Newton iterations: the residual is " + name(report_.residual)
      + ", body '" + solids_[report_.last.body].name() + "' still moves by "
      + name(report_.last.distance)
    );
}
