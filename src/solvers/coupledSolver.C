/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coupledSolver.H"

namespace Foam
{
namespace fsbi
{

//- Vectors that GMRES keeps. An elastic body that contact holds in the direction of
//  its normal only is held in others by the fluid, in long steps by so little that
//  none of the digits may be lost by a restart: a sphere of E dt/mu = 20 000 on a
//  wall takes 90 iterations a correction, with 60 vectors it was not solved in 300
static const label kept = 60;
static const label keptInContact = 300;

//- Residual over the tolerance above which a guess from previous solutions costs
//  less than the iterations that it saves
static const scalar worthwhile = 10;

//- Newton's corrections of a flow with convection or a viscosity that depends on
//  it before it is taken for one that does not converge
static const label maxCorrections = 25;

//- Of a correction of a flow that makes its residual larger
static const label maxHalvings = 6;

//- Residual at rest over that where springs were evaluated beyond which the first
//  says nothing but how far a body has gone: springs as stiff as contact's would
//  pull it back with many times the loads
static const scalar farAway = 100;

//- Residual over that at rest below which the flow's gradients are worth to be
//  known by the derivative: those between a fluid at rest and a surface that
//  moves are not
static const scalar flows = 0.5;

//- The unknowns at rest, but for bodies with springs, which go to where these were
//  evaluated
static scalarList whereEvaluated
(
    const flowProblem& problem, const systemLayout& layout, scalarList x
)
{
    systemLayout::whole bodies(layout.read(x.cdata()));
    forAll(problem.bodies, b)
    {
        const bodyRows& rows = problem.bodies[b];
        if (problem.acting.stiff(b) && rows.gain > 0)
        {
            forAll(rows.offset, k)
            {
                bodies.velocities[b][k] = rows.offset[k]/rows.gain;
            }
        }
    }
    layout.write(bodies, x.begin());
    return x;
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::coupledSolver::coupledSolver
(
    const momentumEquation& momentum, const dictionary& dict
)
:
    closed_(momentum.viscous().closed()),
    lagged_(dict.getOrDefault<word>("geometry", "implicit") == "lagged")
{
    const checkedDictionary entries(dict);
    knowOthers(entries);
    tolerance_ = entries.tolerance("tolerance", 1e-6);
    maxIterations_ = entries.count("maxIterations", 300);
    system_.reset
    (
        new coupledSystem
        (
            momentum,
            entries.choice
            (
                "preconditioner", coupledPreconditioner::types(),
                "blockTriangular"
            )
        )
    );
    entries.finish();
}


void Foam::fsbi::coupledSolver::createNewton(const bool mayTouch)
{
    newton_.reset
    (
        new NewtonKrylov
        (
            system_(), "fsbiKrylov_", mayTouch ? keptInContact : kept,
            maxIterations_
        )
    );
    // the pressure on an elastic body, held all around or not, is felt
    if (!closed_ || !withoutElastic())
    {
        return;
    }
    newton_->setNullVector([this](scalar* values)
    {
        std::fill_n(values, system_->size(), scalar(0));
        for (label i = 3; i < system_->layout().nFluid(); i += 4)
        {
            values[i] = 1;
        }
    });
}


Foam::scalar Foam::fsbi::coupledSolver::evaluate(const scalarList& x)
{
    rows_.setSize(x.size());
    system_->residual(x.cdata(), rows_.begin());
    return coupledSystem::norm(rows_);
}


void Foam::fsbi::coupledSolver::setScale
(
    const flowProblem& problem, scalarList& x
)
{
    const scalarList rest(system_->atRest(x));
    scale_ = evaluate(rest);
    if (system_->linear() && !problem.acting.empty())
    {
        const scalar there = evaluate
        (
            whereEvaluated(problem, system_->layout(), rest)
        );
        scale_ = scale_ > farAway*there ? there : scale_;
    }
    if (problem.acting.onCorners())
    {
        // at rest on each other nothing but what presses bodies together
        // says what is small
        scale_ = max(scale_, system_->normOfEffects());
    }
    if (!withoutElastic())
    {
        // where nothing moves no digit beyond the last is asked for
        scale_ = max(scale_, system_->roundOff(x)/tolerance_);
    }
    if (system_->linear() && scale_ < VSMALL)
    {
        // nothing moves: from another guess no tolerance would be
        // reached, as it is relative to nothing
        x = rest;
    }
}


Foam::scalar Foam::fsbi::coupledSolver::startFromPrevious
(
    scalarList& x, const scalar norm
)
{
    if (!withoutElastic() || !(norm > worthwhile*tolerance_*scale_))
    {
        return norm;
    }
    const auto apply = [this](const scalar* dx, scalar* dr)
    {
        system_->applyJacobian(dx, dr);
    };
    previous_.improve(apply, x, rows_);
    return evaluate(x);
}


void Foam::fsbi::coupledSolver::takeSecants
(
    const scalarList& before, scalarList& x
)
{
    scalarList better;
    if (secants_.better(before, x, better) && system_->admissible(better))
    {
        x = better;
    }
}


void Foam::fsbi::coupledSolver::shorten
(
    const scalarList& before, const scalar norm, scalarList& x
)
{
    for (label h = 0; h < maxHalvings && !(evaluate(x) < norm); ++h)
    {
        forAll(x, i)
        {
            x[i] = 0.5*(before[i] + x[i]);
        }
    }
}


Foam::fsbi::solverReport Foam::fsbi::coupledSolver::improve
(
    const bool first, scalarList& x
)
{
    solverReport report;
    report.corrections = 0;
    scalar norm = evaluate(x);
    if (first)
    {
        norm = startFromPrevious(x, norm);
    }
    report.residual = norm/max(scale_, VSMALL);
    report.converged = report.residual <= tolerance_;
    if (report.converged || !std::isfinite(report.residual))
    {
        return report;
    }
    if (!withoutElastic() && !still_ && report.residual < flows)
    {
        system_->followShapes();
    }
    const scalarList before(system_->linear() ? scalarList() : x);
    const bool solved =
        newton_->correct(rows_, norm, tolerance_*scale_, x, report);
    if (system_->linear())
    {
        report.residual = evaluate(x)/scale_;
        report.converged = solved;
    }
    else
    {
        system_->finishRotations(before, x);
        takeSecants(before, x);
        if (withoutElastic())
        {
            shorten(before, norm, x);
        }
        report.last = system_->largestChange(before, x);
    }
    return report;
}


Foam::fsbi::solverReport Foam::fsbi::coupledSolver::solve
(
    const flowProblem& problem, scalarList& cells, vectorField& traction
)
{
    solverReport report(correct(problem, true, cells, traction));
    label corrections = 1, iterations = report.iterations;
    while
    (
        !system_->linear() && !report.converged && report.failure.empty()
     && std::isfinite(report.residual) && corrections < maxCorrections
    )
    {
        report = correct(problem, false, cells, traction);
        iterations += report.iterations;
        ++corrections;
    }
    report.corrections = corrections;
    report.iterations = iterations;
    return report;
}


Foam::fsbi::solverReport Foam::fsbi::coupledSolver::correct
(
    const flowProblem& problem,
    const bool first,
    scalarList& cells,
    vectorField& traction
)
{
    const bool stale = system_->set(problem, cells);
    still_ = lagged_ || problem.still;
    if (!newton_)
    {
        createNewton(problem.mayTouch);
    }
    const bool anew = first && problem.mayTouch;
    if (anew)
    {
        // where bodies may touch steps fail more often than elsewhere: what a
        // failed one has left, as multigrid keeps of earlier matrices, is not to
        // show in the next, not even in digits beyond the tolerance
        system_->forgetPreconditioner();
    }
    if (anew || stale)
    {
        newton_->renewPreconditioner();
    }
    scalarList x(system_->packed(cells));
    if (first || problem.mayTouch)
    {
        // corrections that bodies' touching cuts short have nothing to teach
        const systemLayout& layout = system_->layout();
        secants_.start(layout.nFluid(), layout.nDistributed());
    }
    if (first)
    {
        setScale(problem, x);
    }
    const solverReport report(improve(first, x));
    if (withoutElastic() && report.converged)
    {
        previous_.add(x);
    }
    traction = system_->traction();
    system_->unpack(x, cells);
    return report;
}
