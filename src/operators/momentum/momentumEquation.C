/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "momentumEquation.H"
#include "Newtonian.H"
#include <algorithm>

Foam::fsbi::momentumEquation::momentumEquation
(
    const fvMesh& mesh,
    autoPtr<viscosityLaw>&& law,
    PtrList<momentumTerm>&& terms
)
:
    mesh_(mesh),
    law_(std::move(law)),
    terms_(std::move(terms))
{}


Foam::fsbi::momentumEquation::momentumEquation
(
    const fvMesh& mesh,
    const scalar mu,
    const boolList& velocityGiven,
    const stokesOperator::schemes& s
)
:
    momentumEquation
    (
        mesh, autoPtr<viscosityLaw>(new Newtonian(mu)), PtrList<momentumTerm>()
    )
{
    set(velocityGiven, s);
}


Foam::fsbi::momentumEquation::~momentumEquation() = default;


void Foam::fsbi::momentumEquation::set
(
    const boolList& velocityGiven,
    const stokesOperator::schemes& s,
    const scalarList& resistances
)
{
    viscous_ = stokesOperator::New(mesh_, law_(), velocityGiven, s);
    ends_.reset(new endResistances(mesh_, resistances));
    for (momentumTerm& term : terms_)
    {
        term.renew();
    }
    setMassRate();
}


void Foam::fsbi::momentumEquation::release()
{
    for (momentumTerm& term : terms_)
    {
        term.release();
    }
    viscous_.clear();
}


void Foam::fsbi::momentumEquation::setMassRate()
{
    if (terms_.empty())
    {
        return;
    }
    rows_.setSize(4*mesh_.nCells());
    massRate_.setSize(mesh_.nCells());
    massRate_ = 0;
    for (momentumTerm& term : terms_)
    {
        term.update();
        term.addMassRate(massRate_);
    }
    densityRate_ = gSum(massRate_)/gSum(mesh_.cellVolumes());
    if (!densityRate_)
    {
        massRate_.clear();
    }
    viscous_->limitStabilisation(massRate_);
}


void Foam::fsbi::momentumEquation::update()
{
    viscous_->update();
    setMassRate();
}


bool Foam::fsbi::momentumEquation::remembers() const
{
    return std::any_of
    (
        terms_.begin(), terms_.end(),
        [](const momentumTerm& term) { return term.remembers(); }
    );
}


bool Foam::fsbi::momentumEquation::linear() const
{
    return law_->constant() && std::all_of
    (
        terms_.begin(), terms_.end(),
        [](const momentumTerm& term) { return term.linear(); }
    );
}


Foam::scalarField Foam::fsbi::momentumEquation::massFlux() const
{
    scalarField flux;
    for (const momentumTerm& term : terms_)
    {
        if (!term.linear())
        {
            flux.setSize(mesh_.nFaces(), 0);
            term.addMassFlux(flux);
        }
    }
    return flux;
}


void Foam::fsbi::momentumEquation::setForce() const
{
    const bool any = returnReduce
    (
        std::any_of
        (
            rows_.begin(), rows_.end(),
            [](const scalar row) { return row != 0; }
        ),
        orOp<bool>()
    );
    const scalarField& V = mesh_.cellVolumes();
    force_.setSize(any ? V.size() : 0);
    forAll(force_, i)
    {
        force_[i] = -vector(rows_[4*i], rows_[4*i + 1], rows_[4*i + 2])/V[i];
    }
}


void Foam::fsbi::momentumEquation::applyInCells
(
    const bool derivative,
    const scalar* x,
    const boundaryValues& given,
    scalar* r,
    vectorField& traction
) const
{
    if (terms_.size() && viscous_->needsForce())
    {
        setForce();
    }
    derivative
  ? viscous_->applyDerivative(x, given, force_, r, traction)
  : viscous_->residual(x, given, force_, r, traction);
    ends_->add(viscous_(), r, traction);
    forAll(rows_, i)
    {
        r[i] += rows_[i];
    }
}


void Foam::fsbi::momentumEquation::residual
(
    const scalar* x,
    const boundaryValues& given,
    scalar* r,
    vectorField& traction
) const
{
    rows_ = 0;
    for (const momentumTerm& term : terms_)
    {
        term.addResidual(x, rows_.data());
    }
    applyInCells(false, x, given, r, traction);
    for (const momentumTerm& term : terms_)
    {
        term.addFluxes(viscous_(), given, r);
        term.addTraction(viscous_(), traction);
    }
}


void Foam::fsbi::momentumEquation::applyJacobian
(
    const scalar* dx,
    const boundaryValues& dgiven,
    scalar* dr,
    vectorField& dtraction
) const
{
    rows_ = 0;
    for (const momentumTerm& term : terms_)
    {
        term.addJacobian(dx, rows_.data());
    }
    applyInCells(true, dx, dgiven, dr, dtraction);
    for (const momentumTerm& term : terms_)
    {
        term.addFluxChanges(viscous_(), dgiven, dr);
    }
}


void Foam::fsbi::momentumEquation::reportNames(Ostream& os) const
{
    forAll(terms_, i)
    {
        os << (i ? " " : "") << terms_[i].type().c_str();
    }
}


void Foam::fsbi::momentumEquation::beginStep()
{
    for (momentumTerm& term : terms_)
    {
        term.beginStep();
    }
}


void Foam::fsbi::momentumEquation::endStep(const scalarList& x)
{
    for (momentumTerm& term : terms_)
    {
        term.endStep(viscous_(), x);
    }
}


void Foam::fsbi::momentumEquation::write
(
    const std::function<void(const regIOobject&)>& add
) const
{
    for (const momentumTerm& term : terms_)
    {
        term.write(add);
    }
}


void Foam::fsbi::momentumEquation::save(dictionary& state) const
{
    for (const momentumTerm& term : terms_)
    {
        dictionary dict;
        term.save(dict);
        if (dict.size())
        {
            state.set(term.type(), dict);
        }
    }
}


void Foam::fsbi::momentumEquation::restore
(
    const dictionary& state, const scalarList& x, const boundaryValues& given
)
{
    if (terms_.empty())
    {
        return;
    }
    scalarList r(x.size());
    vectorField traction(viscous_->nBoundaryFaces());
    viscous_->residual(x.cdata(), given, vectorField(), r.begin(), traction);
    ends_->add(viscous_(), r.begin(), traction);
    for (momentumTerm& term : terms_)
    {
        term.restore(viscous_(), state.subOrEmptyDict(term.type()), x);
    }
}
