/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "couplingLoop.H"

#include <cmath>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::couplingLoop::couplingLoop(const checkedDictionary& entries)
:
    accelerator_(accelerator::New(entries)),
    tolerance_(entries.tolerance("tolerance", 1e-6)),
    maxIterations_(entries.count("maxIterations", 50))
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::fsbi::outcome Foam::fsbi::couplingLoop::hopeful
(
    const scalar residual, const scalar first
) const
{
    if (!std::isfinite(residual))
    {
        return outcome::failed("the coupling's residual is not a number");
    }
    if (residual > 1e12*max(first, tolerance_))
    {
        return outcome::failed
        (
            "coupling by " + accelerator_->type() + " diverges"
        );
    }
    return outcome();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::fsbi::solverReport Foam::fsbi::couplingLoop::solve
(
    const pass& H, const scalar scale, scalarField& x
)
{
    if (!(scale > 0))
    {
        FatalErrorInFunction
            << "The coupling's residual is measured by a scale of " << scale
            << abort(FatalError);
    }
    solverReport report;
    scalarField Hx(x.size());
    scalar first = 0;
    outcome passed;
    while (passed && !report.converged && report.iterations < maxIterations_)
    {
        ++report.iterations;
        passed = H(x, Hx);
        if (passed)
        {
            report.residual = accelerator_->next(x, Hx)/scale;
            first = report.iterations == 1 ? report.residual : first;
            passed = hopeful(report.residual, first);
            report.converged = passed
             && (report.residual <= tolerance_ || !accelerator_->iterates());
        }
    }
    report.failure = passed.reason;
    if (report.converged)
    {
        x = Hx;
    }
    return report;
}
