/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coupledSystem.H"
#include "checkedDictionary.H"
#include "PstreamReduceOps.H"

namespace Foam
{
namespace fsbi
{

//- Growth of the iterations that makes a new hierarchy worth its price
static const scalar renewAbove = 1.3;

//- Accuracy of a correction's linear solution, until the last one needs less
static const scalar forcing = 1e-3;

//- Last linear solution over the tolerance
static const scalar margin = 0.3;

static const label maxHalvings = 8;

//- Factor by which springs may change with the same hierarchy
static const scalar springsChange = 1.5;

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::coupledSystem::coupledSystem
(
    const fvMesh& mesh,
    const momentumEquation& momentum,
    const dictionary& dict
)
:
    mesh_(mesh),
    momentum_(momentum),
    stokes_(momentum.viscous()),
    traction_(stokes_.nBoundaryFaces(), Zero),
    freshRate_(0)
{
    const checkedDictionary entries(dict);
    knowOthers(entries);
    tolerance_ = entries.tolerance("tolerance", 1e-6);
    maxIterations_ = entries.count("maxIterations", 300);
    entries.finish();

    closed_ = stokes_.closed();
}


void Foam::fsbi::coupledSystem::createKrylov()
{
    const label nCells = mesh_.nCells();
    const label nRows = result_.size();
    preconditioner_.reset(new stokesPreconditioner(mesh_, stokes_, elastic_));
    krylov_.reset
    (
        new matrixFreeKrylov
        (
            nRows, "fsbiKrylov_", 60,
            [this](const scalar* x, scalar* y){ residual(x, y, true); },
            [this](const scalar* r, scalar* z){ precondition(r, z); }
        )
    );
    // the pressure on an elastic body, held all around or not, is felt
    if (!closed_ || elastic_.size())
    {
        return;
    }
    krylov_->setNullVector([=](scalar* values)
    {
        std::fill_n(values, nRows, scalar(0));
        for (label i = 0; i < nCells; ++i)
        {
            values[4*i + 3] = 1;
        }
    });
}


void Foam::fsbi::coupledSystem::set
(
    const boundaryValues& given,
    UList<bodyRows>& bodies,
    const UList<elasticRows*>& elastic
)
{
    given_ = &given;
    bodies_ = &bodies;
    elastic_ = elastic;
    values_ = given;
    scales_ = rowScales(stokes_, bodies, elastic);
    layout_ = systemLayout(mesh_.nCells(), elastic_, bodies.size());
    state_.setSize(layout_.nDistributed());
    result_.setSize(layout_.size());
    if (!krylov_)
    {
        createKrylov();
    }
    coupling_.clear();
    if (loads_ && !loads_->empty())
    {
        coupling_.reset
        (
            new loadCoupling(*loads_, bodies, scales_.resistance())
        );
    }
    renewIfStale();
}


void Foam::fsbi::coupledSystem::renewIfStale()
{
    scalar rate = 0, springs = 0;
    forAll(elastic_, e)
    {
        elasticRows& body = *elastic_[e];
        body.springs = scalarField();
        if (coupling_ && coupling_->onElastic())
        {
            body.springs = loads_->springConstants(bodies_->size() + e);
            springs += sum(body.springs);
        }
        rate += body.rate;
    }
    if
    (
        !freshRate_ || mag(rate - rate_) > 0.1*rate_
     || max(springs, springs_) > springsChange*min(springs, springs_)
    )
    {
        preconditioner_->rebuild();
        freshRate_ = 0;
        rate_ = rate;
        springs_ = springs;
    }
}


Foam::scalar Foam::fsbi::coupledSystem::norm(const scalarList& rows)
{
    scalar sum = 0;
    for (const scalar r : rows)
    {
        sum += r*r;
    }
    return sqrt(returnReduce(sum, sumOp<scalar>()));
}


void Foam::fsbi::coupledSystem::watch
(
    const label iterations, const scalar accuracy
)
{
    const scalar rate = max(iterations, 1)/log10(1/accuracy);
    if (!freshRate_)
    {
        freshRate_ = rate;
    }
    else if (rate > renewAbove*freshRate_)
    {
        freshRate_ = 0;                 // the next solution builds a new one
    }
}


Foam::fsbi::solverReport Foam::fsbi::coupledSystem::solve
(
    const boundaryValues& given,
    UList<bodyRows>& bodies,
    scalarList& x,
    vectorField& traction
)
{
    set(given, bodies, UList<elasticRows*>());

    // right-hand side: minus the residual at rest
    scalarList rhs(result_.size());
    result_ = Zero;
    residual(result_.cdata(), rhs.begin(), false);
    forAll(rhs, i)
    {
        rhs[i] = -rhs[i];
    }
    scalarList unknown(packed(x));

    const matrixFreeKrylov::outcome outcome
    (
        krylov_->solve
        (
            rhs.cdata(), unknown.begin(), tolerance_, maxIterations_
        )
    );
    solverReport report;
    report.iterations = outcome.iterations;
    report.residual = outcome.residual;
    report.converged = outcome.converged;

    residual(unknown.cdata(), result_.data(), false);
    unpack(unknown, x);
    traction = traction_;
    watch(report.iterations, tolerance_);
    return report;
}


bool Foam::fsbi::coupledSystem::advance
(
    const scalarList& dx, scalarList& unknown
)
{
    scalar part = 1;
    for (label halving = 0; halving < maxHalvings; ++halving)
    {
        scalarList tried(unknown);
        forAll(tried, i)
        {
            tried[i] -= part*dx[i];
        }
        elasticResiduals(tried.cdata(), result_.begin(), false);
        bool valid = true;
        for (const elasticRows* body : elastic_)
        {
            valid = valid && body->elastic->valid();
        }
        if (valid)
        {
            unknown = tried;
            return true;
        }
        part /= 2;
    }
    return false;
}


Foam::fsbi::solverReport Foam::fsbi::coupledSystem::correct
(
    const boundaryValues& given,
    UList<bodyRows>& bodies,
    const UList<elasticRows*>& elastic,
    const bool first,
    scalarList& x,
    vectorField& traction
)
{
    set(given, bodies, elastic);
    scalarList unknown(packed(x));
    if (first)
    {
        // relative to the fluid and rigid bodies at rest
        scalarList rest(unknown);
        std::fill_n(rest.begin(), layout_.nFluid(), scalar(0));
        systemLayout::whole still(layout_.read(rest.cdata()));
        still.velocities = sixVector(Zero);
        layout_.write(still, rest.begin());
        residual(rest.cdata(), result_.begin(), false);
        scale_ = norm(result_);
    }
    residual(unknown.cdata(), result_.begin(), false);
    traction = traction_;

    solverReport report;
    report.corrections = 0;
    const scalar size = norm(result_);
    report.residual = size/max(scale_, VSMALL);
    report.converged = report.residual <= tolerance_;
    if (report.converged || !std::isfinite(report.residual))
    {
        return report;
    }
    const scalarList rhs(result_);
    scalarList dx(rhs.size(), Zero);
    const scalar accuracy = max(margin*tolerance_*scale_/size, forcing);
    report.iterations = krylov_->solve
    (
        rhs.cdata(), dx.begin(), accuracy, maxIterations_
    ).iterations;
    watch(report.iterations, accuracy);
    report.corrections = 1;
    if (!advance(dx, unknown))
    {
        report.failure = "a cell is turned inside out";
    }
    unpack(unknown, x);
    return report;
}
