/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "scene.H"
#include "Time.H"
#include "proximity.H"
#include "untrapped.H"

namespace Foam
{
namespace fsbi
{

//- Force and torque about the centre of all that acts on a body that deforms
static sixVector total
(
    const loads::onBodies& acted, const label bodyi, const immersedBody& body
)
{
    const bodySurface surface(body.placedSurface());
    const point centre(body.placed().centre);
    const vectorField& pulls = acted.triangles[bodyi];
    vector force(linear(acted.whole[bodyi]));
    vector torque(angular(acted.whole[bodyi]));
    forAll(pulls, i)
    {
        const point x(surface.triangles()[i].centre(surface.points()));
        force += pulls[i];
        torque += (x - centre) ^ pulls[i];
    }
    const vectorField& onPoints = acted.points[bodyi];
    forAll(onPoints, i)
    {
        force += onPoints[i];
        torque += (surface.points()[i] - centre) ^ onPoints[i];
    }
    return join(force, torque);
}


//- Did it converge, in so many iterations?
static outcome converged(const solverReport& report, const label iterations)
{
    return
        report.converged
      ? outcome()
      : outcome::failed
        (
            "the solver reached a residual of " + name(report.residual)
          + " only, in " + name(iterations)
          + " iterations (maxIterations of system/fluid/fvSolution)"
        );
}

} // End namespace fsbi
} // End namespace Foam


Foam::List<Foam::fsbi::bodyRows> Foam::fsbi::scene::bodyRowsNow() const
{
    List<bodyRows> rows(bodies_.rigid.size());
    forAll(rows, b)
    {
        rows[b] = bodies_.rigid[b].rows(time_.value());
        if (!bodies_.rigid[b].present())
        {
            rows[b].free = FixedList<bool, 6>(false);
            rows[b].velocity = sixVector(scalar(0));
        }
    }
    return rows;
}


Foam::fsbi::outcome Foam::fsbi::scene::solveRows(List<bodyRows>& rows)
{
    List<sixVector> loads;
    const label before = report_.iterations;
    report_ = fluid_->solve(rows, loads);
    report_.iterations += before;
    bool finite = std::isfinite(report_.residual);
    take(rows, loads);
    for (const sixVector& load : loads)
    {
        for (const scalar component : load)
        {
            finite = finite && std::isfinite(component);
        }
    }
    if (!finite)
    {
        return outcome::failed
        (
            "the solution is not finite: the scene has numbers that are"
            " too large, or cells that are too thin"
        );
    }
    return converged(report_, report_.iterations - before);
}


void Foam::fsbi::scene::take
(
    const UList<bodyRows>& rows, const UList<sixVector>& loads
)
{
    takeEffects(rows);
    forAll(rows, b)
    {
        bodies_.rigid[b].set(rows[b].velocity, loads[b]);
        if
        (
            (steep() && !coupling_) || fluctuates()
         || (effects_ && fluid_->acting().stiff(b))
        )
        {
            bodies_.rigid[b].settle();
        }
    }
}


void Foam::fsbi::scene::takeEffects(const UList<bodyRows>& rows)
{
    if (!effects_)
    {
        return;
    }
    const loads::onBodies acted(fluid_->effectForces(rows));
    effectLoads_ = acted.whole;
    forAll(bodies_.elastic, e)
    {
        const label b = bodies_.rigid.size() + e;
        effectLoads_[b] = total(acted, b, bodies_.immersed[b]);
    }
}


Foam::fsbi::outcome Foam::fsbi::scene::advance()
{
    report_ = solverReport();
    const outcome solved(fluid_ ? advanceFlow() : advanceSolids());
    if (effects_ && effects_->culprit().size())
    {
        return outcome::failed
        (
            "the load of effect '" + effects_->culprit()
          + "' is infinite or no number"
        );
    }
    outcome accepted(solved && effects_ ? effects_->acceptable() : solved);
    // without effects bodies end where the mesh is
    if (accepted && effects_)
    {
        accepted = fluid_->holdsBodies();
    }
    return accepted && carried_ ? advanceCarried() : accepted;
}


Foam::fsbi::outcome Foam::fsbi::scene::advanceCarried()
{
    auto timer = timings_.profileMemory(carried_->type());
    return carried_->advance();
}


Foam::fsbi::outcome Foam::fsbi::scene::loadsAt
(
    const UList<sixVector>& velocities, List<sixVector>& loads
)
{
    const untrapped scope;
    List<bodyRows> rows(bodyRowsNow());
    forAll(rows, b)
    {
        rows[b].free = FixedList<bool, 6>(false);
        rows[b].velocity = velocities[b];
    }
    report_ = fluid_->solve(rows, loads);
    return converged(report_, report_.iterations);
}


Foam::fsbi::outcome Foam::fsbi::scene::solveCoupled()
{
    const untrapped scope;
    List<bodyRows> rows(bodyRowsNow());
    List<sixVector> loads(rows.size());
    const label before = report_.iterations;
    const outcome agreed(coupling_->advance(rows, loads));
    report_ = coupling_->report();
    report_.iterations += before;
    if (agreed)
    {
        take(rows, loads);
    }
    return agreed;
}


Foam::fsbi::outcome Foam::fsbi::scene::advanceFlow()
{
    if (fluctuates())
    {
        return advanceByMidpoint();
    }
    // what contact stops is not where the first pass would place it
    bool extrapolated = true;
    for (const rigidBody& body : bodies_.rigid)
    {
        extrapolated &= body.hasHistory() || (steep() && !coupling_);
    }
    // without a history the first pass only finds the velocity to place with
    for (label pass = extrapolated ? 1 : 0; pass < 2; ++pass)
    {
        placeBodies();
        outcome solved(coupling_ ? solveCoupled() : fluid_->follow());
        if (solved && !coupling_)
        {
            solved = solveFluid();
        }
        if (!solved)
        {
            return solved;
        }
    }
    takePrescribedLoads();
    return outcome();
}


void Foam::fsbi::scene::placeBodies()
{
    for (rigidBody& body : bodies_.rigid)
    {
        body.advance(time_.deltaTValue());
    }
    placePrescribed(1);
    // drag beside a wall is not that of the way there
    keepClear(true);
}


void Foam::fsbi::scene::takePrescribedLoads()
{
    forAll(bodies_.prescribed, b)
    {
        bodies_.prescribed[b].set
        (
            fluid_->load(bodies_.rigid.size() + bodies_.elastic.size() + b)
        );
    }
}


Foam::fsbi::outcome Foam::fsbi::scene::advanceSolids()
{
    for (solidRegion& solid : bodies_.elastic)
    {
        solverReport report;
        const outcome solved(solid.solve(report));
        report_.iterations += report.iterations;
        report_.corrections = max(report_.corrections, report.corrections);
        report_.residual = max(report_.residual, report.residual);
        if (!solved)
        {
            return solved;
        }
    }
    return outcome();
}


void Foam::fsbi::scene::beginStep()
{
    if (effects_)
    {
        effects_->setWalls(fluid_->walls());
    }
    traffic_.beginStep();
    for (const auto& participant : participants_)
    {
        participant.second->beginStep();
    }
}


void Foam::fsbi::scene::rewind()
{
    for (const auto& participant : participants_)
    {
        participant.second->rewind();
    }
}


void Foam::fsbi::scene::endStep()
{
    if (steep() || fluctuates())
    {
        const boolList stopped(effects_->stopped());
        forAll(bodies_.rigid, b)
        {
            bodies_.rigid[b].stop(stopped[b]);
        }
        forAll(bodies_.elastic, e)
        {
            bodies_.elastic[e].stop(stopped[bodies_.rigid.size() + e]);
        }
    }
    for (const auto& participant : participants_)
    {
        participant.second->endStep();
    }
}


void Foam::fsbi::scene::save(dictionary& state) const
{
    dictionary bodies;
    for (std::size_t i = 0; i < participants_.size(); ++i)
    {
        dictionary dict;
        participants_[i].second->save(dict);
        (label(i) < bodies_.all().size() ? bodies : state).set
        (
            participants_[i].first, dict
        );
    }
    state.set("bodies", bodies);
    dictionary traffic;
    traffic_.save(traffic);
    state.set("traffic", traffic);
}


void Foam::fsbi::scene::write
(
    const std::function<void(const regIOobject&)>& add
)
{
    if (fluid_)
    {
        fluid_->write(add);
    }
    if (carried_)
    {
        carried_->write(add);
    }
    for (solidRegion& solid : bodies_.elastic)
    {
        solid.write(add);
    }
}


void Foam::fsbi::scene::renewSolvers()
{
    if (fluid_)
    {
        fluid_->renewSolver();
    }
    for (solidRegion& solid : bodies_.elastic)
    {
        solid.renewSolver();
    }
}


Foam::scalar Foam::fsbi::scene::smallestGap() const
{
    return fluid_ ? fluid_->smallestGap() : GREAT;
}


Foam::scalar Foam::fsbi::scene::timeToContact
(
    const scalar reach, string& names
) const
{
    return
        fluid_
      ? fsbi::timeToContact
        (
            {
                time_, bodies_.immersed, fluid_->walls(), {}, {},
                fluid_->meshing().images()
            },
            fluid_->meshing().cutSurfaces(), reach, names
        )
      : GREAT;
}


Foam::List<Foam::fsbi::unseenPatch> Foam::fsbi::scene::unseen() const
{
    return fluid_ ? fluid_->unseen() : List<unseenPatch>();
}


Foam::string Foam::fsbi::scene::unresolved(const scalar gap) const
{
    return fluid_ ? fluid_->unresolved(gap) : string();
}


Foam::string Foam::fsbi::scene::warning() const
{
    string text;
    for (const solidRegion& solid : bodies_.elastic)
    {
        if (solid.warning().size())
        {
            text += "  " + solid.name() + ": " + solid.warning();
        }
    }
    return text;
}


Foam::label Foam::fsbi::scene::nCells() const
{
    label n = fluid_ ? fluid_->mesh().globalData().nTotalCells() : 0;
    for (const solidRegion& solid : bodies_.elastic)
    {
        n += solid.mesh().globalData().nTotalCells();
    }
    return n;
}
