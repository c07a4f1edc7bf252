/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// Steps by a table of resistances (reducedFlow): the mesh is the domain's own, as
// nobody solves on it; where the table is checked it is one around the body

#include "fluidRegion.H"
#include "bodyCoupling.H"
#include "resistance.H"
#include "untrapped.H"

void Foam::fsbi::fluidRegion::checkReduced() const
{
    if (!reduced_)
    {
        return;
    }
    checkResistance(momentum_(), "Tables of method 'reduced'");
    for (const momentumTerm& term : momentum_->terms())
    {
        if (term.remembers())
        {
            FatalErrorInFunction
                << "Method 'reduced' (system/fluid/fvSolution) is for a fluid"
                << " without memory: it does not go with '"
                << term.type().c_str() << "' of constant/fluid/material"
                << exit(FatalError);
        }
    }
}


Foam::scalar Foam::fsbi::fluidRegion::smallestGap() const
{
    return reduced_ ? reduced_->gap() : mesh_.smallestGap();
}


Foam::string Foam::fsbi::fluidRegion::unresolved(const scalar gap) const
{
    return reduced_ ? string() : mesh_.unresolved(gap);
}


void Foam::fsbi::fluidRegion::endStep()
{
    momentum_->endStep(x_);
    if (reduced_ && reduced_->due())
    {
        checkTable();
    }
}


void Foam::fsbi::fluidRegion::checkTable()
{
    mesh_.surround();
    const rigidBody& body = rigidBodies_[0];
    const outcome placed(reduced_->place(body.placed()));
    const outcome followed(placed ? followMesh() : placed);
    if (!followed)
    {
        Info<< "No check: " << followed.reason.c_str() << endl;
        return;
    }
    List<bodyRows> rows(1, body.rows(time_.value()));
    rows[0].free = FixedList<bool, 6>(false);
    rows[0].velocity = body.now().velocity;

    const untrapped scope;
    auto timer = timings_.measure("checks");
    const solverReport report
    (
        solver_->solve(problem(rows, {}), x_, traction_)
    );
    if (!report.converged)
    {
        Info<< "No check: the full solution did not converge" << endl;
        return;
    }
    setFields(rows);
    reduced_->compare(rows[0], bodyLoads(stokes(), rows, traction_)[0]);
}
