/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidRegion.H"
#include "untrapped.H"
#include "Time.H"

Foam::scalar Foam::fsbi::solidRegion::fastestFrequency() const
{
    scalar modulus = 0;
    for (const solidMaterial* law : elastic_->parts().laws)
    {
        modulus = max(modulus, law->lambda() + 2*law->mu());
    }
    const scalar speed =
        Foam::sqrt(modulus/max(material_->density(), VSMALL));
    return 2*speed/Foam::cbrt(gMin(volumes_));
}


Foam::vector Foam::fsbi::solidRegion::volumeForce() const
{
    return body_.force(time_.value(), material_->density());
}


Foam::vectorField Foam::fsbi::solidRegion::cells() const
{
    const vector* u = reinterpret_cast<const vector*>(x_.cdata());
    vectorField field(mesh().nCells());
    std::copy_n(u, field.size(), field.begin());
    return field;
}


Foam::fsbi::outcome Foam::fsbi::solidRegion::judged
(
    const solverReport& report
) const
{
    const scalar sum = returnReduce(Foam::sum(mag(x_)), sumOp<scalar>());
    const string body("body '" + name() + "': ");
    if (!std::isfinite(report.residual) || !std::isfinite(sum))
    {
        return outcome::failed
        (
            body + "the solution is not finite: the loads are too large, or"
            " cells too thin"
        );
    }
    if (!report.converged)
    {
        return outcome::failed
        (
            body + "the solver reached a residual of "
          + Foam::name(report.residual) + " only, in "
          + Foam::name(report.corrections) + " corrections"
          + (report.failure.empty() ? string() : ": " + report.failure)
        );
    }
    return outcome();
}


bool Foam::fsbi::solidRegion::evaluate()
{
    scalarField r(x_.size());
    elastic_->residual(x_.cdata(), conditions_->given(), r.data());
    const vector* rows = reinterpret_cast<const vector*>(r.cdata());
    const vector b(volumeForce());
    forces_.setSize(mesh().nCells());
    forAll(forces_, celli)
    {
        forces_[celli] = rows[celli] - volumes_[celli]*b;
    }
    if (rows_.tethered())
    {
        forces_ -= rows_.constraintWeight*rows_.multiplier;
    }
    if (rows_.acting.size())
    {
        forces_ -= rows_.acting;
    }
    return elastic_->valid();
}


Foam::scalarField Foam::fsbi::solidRegion::inertia() const
{
    // rho V a + (1 - w) R + w R_old = 0, a = coefficient u + known
    const scalar share = 1/(1 - motion_->oldWeight());
    return
        share*motion_->accelerationCoeff()*material_->density()*volumes_;
}


Foam::vectorField Foam::fsbi::solidRegion::loads() const
{
    const scalar share = 1/(1 - motion_->oldWeight());
    const scalarField masses(share*material_->density()*volumes_);
    return
        volumeForce()*volumes_
      - masses*motion_->knownAcceleration()
      - inertia()*movedCells_
      - share*motion_->weighted(vectorField(mesh().nCells(), Zero));
}


Foam::fsbi::outcome Foam::fsbi::solidRegion::solve(solverReport& report)
{
    auto timer = timings_.measure("solve");
    const untrapped scope;
    conditions_->evaluate(movedFaces_);
    report = solver_->solve({conditions_->given(), loads(), inertia()}, x_);
    const outcome solved(judged(report));
    return solved ? take() : solved;
}


Foam::fsbi::outcome Foam::fsbi::solidRegion::solve
(
    const boundarySpring& spring, solverReport& report
)
{
    auto timer = timings_.measure("solve");
    const untrapped scope;
    if (!solver_)
    {
        solver_ = solidSolver::New(mesh(), elastic_(), material_(), controls());
    }
    report = solver_->solve
    (
        {conditions_->given(), rows_.cellForce(), rows_.mass, &spring}, x_
    );
    return judged(report);
}


Foam::fsbi::outcome Foam::fsbi::solidRegion::take()
{
    if (!evaluate())
    {
        return outcome::failed
        (
            "body '" + name() + "' is turned inside out: the load of the step"
            " is too large"
        );
    }
    setFields();
    setMeasures();
    return outcome();
}


void Foam::fsbi::solidRegion::setRows()
{
    conditions_->evaluate(movedFaces_);
    rows_.mass = inertia();
    rows_.force = loads();
    rows_.acting.clear();
    rows_.centres = centres_ + movedCells_;
    if (!wetted_->present())
    {
        setStill();
    }
    if (rows_.tethered())
    {
        rows_.targetDisplacement =
            tethered_ - gSum(vectorField(rows_.constraintWeight*movedCells_));
    }
    wetted_->setVelocity(rows_);
}


void Foam::fsbi::solidRegion::setStill()
{
    // as if a spring held every cell, as stiff as the body itself
    const scalar k =
        elastic_->state().stiffness()/sqr(wetted_->radius());
    rows_.mass = k*volumes_;
    rows_.force = rows_.mass*cells();
    increment_ = 0;
}


bool Foam::fsbi::solidRegion::follow()
{
    const bool valid = evaluate();
    wetted_->follow(rows_);
    return valid;
}


Foam::fsbi::outcome Foam::fsbi::solidRegion::finish
(
    const vectorField& fluid,
    const vectorField& effects,
    const vectorField& cells
)
{
    fluidForce_ = gSum(fluid);
    if (cells.size())
    {
        rows_.acting =
            rows_.acting.size() ? vectorField(rows_.acting + cells) : cells;
    }
    conditions_->addForce(fluid + effects);
    return take();
}


void Foam::fsbi::solidRegion::setFields()
{
    const solidBoundary& given = conditions_->given();
    vectorField faces(elastic_->boundaryDisplacement());
    forAll(faces, i)
    {
        // not with the solver's error, which would become the next condition
        if (given.kinds[i] == solidBoundary::displacement)
        {
            faces[i] = given.faces[i];
        }
    }
    vectorField vertices(movedPoints_ + elastic_->vertexDisplacement());
    if (wetted_)
    {
        // where the fluid's mesh has them
        wetted_->hold(vertices);
    }
    fields_->setDisplacement
    (
        movedCells_ + cells(), movedFaces_ + faces, vertices
    );
    fields_->setStress(elastic_(), material_->type() == "linearElastic");
}


void Foam::fsbi::solidRegion::setMeasures()
{
    const vectorField u(fields_->D());
    measures_.setDeformation(volumes_, elastic_());
    measures_.setMotion
    (
        volumes_, material_->density(), centres_ + u, motion_->velocity(u)
    );
    warning_ = warningOf(measures_);
}


Foam::string Foam::fsbi::solidRegion::warningOf
(
    const solidMeasures& measures
) const
{
    for (const solidMaterial* law : elastic_->parts().laws)
    {
        const string text(law->warning(measures.minJ, measures.minStretch));
        if (text.size())
        {
            return text;
        }
    }
    return "";
}


Foam::string Foam::fsbi::solidRegion::failureWarning()
{
    solidMeasures now;
    now.setDeformation(volumes_, elastic_());
    const string text(warningOf(now));
    return
        text.empty()
      ? string()
      : string(" (body '" + name() + "': " + text + ")");
}


Foam::fsbi::workBalance::state Foam::fsbi::solidRegion::working() const
{
    return
    {
        elastic_->boundaryForce(), fields_->boundaryD(), volumeForce(),
        gSum(volumes_*fields_->D())
    };
}


void Foam::fsbi::solidRegion::moveMesh()
{
    if (!moves())
    {
        return;
    }
    movedCells_ = fields_->D();
    movedFaces_ = fields_->boundaryD();
    movedPoints_ = fields_->pointD();
    mesh_->movePoints(reference_ + movedPoints_);
    mesh_->moving(false);
}


void Foam::fsbi::solidRegion::setMoved()
{
    rows_.movedFaces = rows_.solid.collectFaces(movedFaces_);
    rows_.movedPoints = rows_.solid.collectPoints(movedPoints_);
}


Foam::wordList Foam::fsbi::solidRegion::heldPatches() const
{
    DynamicList<word> names;
    for (const polyPatch& pp : mesh().boundaryMesh())
    {
        if (conditions_->held(pp.index()))
        {
            names.append(pp.name());
        }
    }
    return wordList(std::move(names));
}


Foam::vector Foam::fsbi::solidRegion::reaction(const word& patch) const
{
    const polyPatch& pp = mesh().boundaryMesh()[patch];
    return gSum
    (
        vectorField
        (
            SubField<vector>
            (
                balance_.force(), pp.size(), pp.start() - mesh().nInternalFaces()
            )
        )
    );
}


void Foam::fsbi::solidRegion::renewSolver()
{
    solver_.clear();
    if (!inFluid_)      // there made when a scheme needs it
    {
        solver_ = solidSolver::New(mesh(), elastic_(), material_(), controls());
    }
}


void Foam::fsbi::solidRegion::beginStep()
{
    const scalar dt = time_.deltaTValue();
    motion_->beginStep(dt);
    elastic_->beginStep(dt, oldStep_, !isStatic());
    oldX_ = x_;
    if (oldStep_ > 0)
    {
        x_ += (dt/oldStep_)*increment_;
    }
    if (wetted_)
    {
        wetted_->beginStep(dt);
    }
    const string text
    (
        isStatic() ? string() : motion_->warning(dt, fastestFrequency())
    );
    if (text.size() && schemeWarning_.empty())
    {
        Info<< "Body '" << name() << "': " << text.c_str() << endl;
    }
    schemeWarning_ = text;
}


void Foam::fsbi::solidRegion::rewind()
{
    motion_->rewind();
    if (wetted_)
    {
        wetted_->rewind();
    }
    x_ = oldX_;
    // a guess that may have been the reason
    increment_ = 0;
}


void Foam::fsbi::solidRegion::endStep()
{
    motion_->endStep(fields_->D(), forces_);
    increment_ = x_ - oldX_;
    if (stopped_)
    {
        increment_ = 0;
    }
    oldStep_ = time_.deltaTValue();
    balance_.add(working());
    measures_.work = balance_.work();
    if (wetted_)
    {
        wetted_->endStep(stopped_);
    }
    elastic_->endStep();
    if (moves())
    {
        moveMesh();
        if (inFluid_)
        {
            setMoved();
        }
        elastic_->update();
        const label n = 3*(mesh().nCells() + elastic_->stencil().nGhosts());
        std::fill_n(x_.begin(), n, 0);
    }
}
