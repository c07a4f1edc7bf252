/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "identification.H"
#include "untrapped.H"

#include <gsl/gsl_multifit_nlinear.h>
#include <gsl/gsl_errno.h>

namespace Foam
{
namespace fsbi
{

//- Difference quotients, over the width of a range
static const scalar relativeStep = 1e-4;

static const int maxIterations = 60;

//- Of other norms than least squares: steps, the smallest part of a step, a step
//  that is none, over the width of a range, and a gain that is none
static const label maxRefinements = 30;
static const scalar smallestPart = 1e-3, converged = 1e-6, noGain = 1e-6;

static identification& of(void* p)
{
    return *static_cast<identification*>(p);
}

static scalarList coordinates(const gsl_vector* c)
{
    scalarList list(c->size);
    forAll(list, k)
    {
        list[k] = gsl_vector_get(c, k);
    }
    return list;
}

static int residualOf(const gsl_vector* c, void* p, gsl_vector* f)
{
    vectorField r;
    of(p).residual(coordinates(c), r);
    std::copy_n(r.cdata()->v_, 3*r.size(), f->data);
    return GSL_SUCCESS;
}

static int jacobianOf(const gsl_vector* c, void* p, gsl_matrix* J)
{
    List<vectorField> jacobian;
    of(p).jacobian(coordinates(c), jacobian);
    forAll(jacobian, k)
    {
        for (label i = 0; i < 3*jacobian[k].size(); ++i)
        {
            gsl_matrix_set(J, i, k, jacobian[k][i/3][i % 3]);
        }
    }
    return GSL_SUCCESS;
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::identification::identification
(
    loadedBody& body,
    const surfaceData& data,
    const dictionary& law,
    const List<constant>& constants,
    const bool tractions,
    const residualNorm& norm
)
:
    body_(body),
    data_(data),
    law_(law),
    constants_(constants),
    tractions_(tractions),
    norm_(norm),
    at_(constants.size()),
    jacobian_(constants.size())
{
    forAll(at_, k)
    {
        at_[k] =
            constants_[k].coordinate(constants_[k].lowest)
          + 0.5*constants_[k].width();
    }
    if (!body.held())
    {
        setRigid();
    }
}


void Foam::fsbi::identification::setRigid()
{
    const pointField x(data_.x + data_.u);
    const vectorField about(x - average(x));
    for (direction k = 0; k < 6; ++k)
    {
        vector axis(Zero);
        axis[k % 3] = 1;
        vectorField motion(x.size(), axis);
        if (k > 2)
        {
            motion = axis ^ about;
        }
        removeRigid(motion);
        const scalar size = Foam::sqrt(sum(magSqr(motion)));
        if (size > 1e-6*Foam::sqrt(sum(magSqr(about))))
        {
            motion /= size;
            rigid_.append(motion);
        }
    }
}


void Foam::fsbi::identification::removeRigid(vectorField& r) const
{
    for (const vectorField& motion : rigid_)
    {
        r -= sum(r & motion)*motion;
    }
}


Foam::dictionary Foam::fsbi::identification::law(const scalarList& c) const
{
    dictionary result(law_);
    const unsigned precision = IOstream::defaultPrecision(17);
    forAll(c, k)
    {
        result.set(constants_[k].name, constants_[k].within(c[k]));
    }
    IOstream::defaultPrecision(precision);
    return result;
}


bool Foam::fsbi::identification::displacementResidual(vectorField& r)
{
    if (!body_.solve(r))
    {
        return false;
    }
    r -= data_.u;
    removeRigid(r);
    return true;
}


void Foam::fsbi::identification::residual
(
    const scalarList& c, vectorField& r
)
{
    scalar beyond = 0;
    forAll(c, k)
    {
        const constant& of = constants_[k];
        beyond += mag(c[k] - of.coordinate(of.within(c[k])))/of.width();
    }
    body_.setLaw(law(c));
    if (!displacementResidual(r))
    {
        const scalar unit = tractions_ ? body_.stiffness() : 1;
        r = vectorField(nResiduals()/3, vector::one*10*unit*body_.radius());
        return;
    }
    if (tractions_)
    {
        r = body_.springTraction();
    }
    r *= 1 + 10*beyond;
}


Foam::scalar Foam::fsbi::identification::step(const label k) const
{
    const scalar middle =
        constants_[k].coordinate(constants_[k].lowest)
      + 0.5*constants_[k].width();
    return (at_[k] > middle ? -relativeStep : relativeStep)
       *constants_[k].width();
}


void Foam::fsbi::identification::jacobian
(
    const scalarList& c, List<vectorField>& J
)
{
    at_ = c;
    vectorField r;
    residual(c, r);
    J.setSize(c.size());
    forAll(c, k)
    {
        scalarList moved(c);
        moved[k] += step(k);
        residual(moved, J[k]);
        J[k] = (J[k] - r)/step(k);
    }
}


void Foam::fsbi::identification::collapsed() const
{
    FatalErrorInFunction
        << "There is no equilibrium of the body with the observed displacement"
        << " and traction of its surface and the law" << nl << law()
        << "Give other ranges, check the units of traction, or take another"
        << " law: StVenantKirchhoff has no stiffness in compression below 0.58"
        << exit(FatalError);
}


void Foam::fsbi::identification::start()
{
    // stiffer and stiffer, for a body too soft collapses
    vectorField u;
    for (const scalar part : {0.5, 0.7, 0.9, 1.0})
    {
        forAll(at_, k)
        {
            const constant& c = constants_[k];
            at_[k] =
                c.coordinate(c.lowest)
              + (c.name == "E" ? part : 0.5)*c.width();
        }
        body_.setSprings(1, modulus());
        body_.setLaw(law());
        if (body_.solve(u))
        {
            return;
        }
    }
    collapsed();
}


void Foam::fsbi::identification::find(const scalar springs)
{
    start();
    fit();
    scalar ratio = springs;
    for (label i = 0; i < 5; ++i)
    {
        const scalar E = modulus();
        ratio = continuation(ratio);
        fit();
        if (mag(modulus() - E) < 0.3*E)
        {
            break;
        }
    }
    if (!norm_.leastSquares())
    {
        refine();
    }
    if (tractions_)
    {
        // for the misfit of displacement
        body_.setSprings(loadedBody::soft, modulus());
        body_.setLaw(law());
        if (!displacementResidual(residual_))
        {
            collapsed();
        }
    }
}


Foam::scalar Foam::fsbi::identification::settle(vectorField& r) const
{
    if (!tractions_)
    {
        r = moved(r, rigid_, norm_.lowest(r, rigid_));
    }
    return norm_.cost(r);
}


bool Foam::fsbi::identification::lower(const scalarList& step, scalar& cost)
{
    const scalarList from(at_);
    for (scalar part = 1; part > smallestPart; part /= 2)
    {
        scalarList to(from);
        forAll(to, k)
        {
            to[k] += part*step[k];
        }
        vectorField r;
        residual(to, r);
        const scalar now = settle(r);
        if (now < cost)
        {
            cost = now;
            at_ = to;
            residual_ = r;
            return true;
        }
    }
    return false;
}


void Foam::fsbi::identification::refine()
{
    scalar cost = settle(residual_);
    for (label i = 0; i < maxRefinements; ++i)
    {
        List<vectorField> J(jacobian_);
        if (!tractions_)
        {
            J.append(rigid_);
        }
        const scalarList d(norm_.lowest(residual_, J));
        scalar largest = 0;
        forAll(at_, k)
        {
            largest = max(largest, mag(d[k])/constants_[k].width());
        }
        const scalar before = cost;
        if
        (
            largest < converged
         || !lower(d, cost)
         || before - cost < noGain*before
        )
        {
            break;
        }
        jacobian(scalarList(at_), jacobian_);
    }
    evaluate();
    settle(residual_);
}


void Foam::fsbi::identification::evaluate()
{
    const scalarList found(at_);
    jacobian(found, jacobian_);
    residual(found, residual_);
    vectorField u;
    if (!body_.solve(u))
    {
        collapsed();
    }
}


Foam::scalar Foam::fsbi::identification::continuation(const scalar springs)
{
    // a wrong law may not be able to bear the traction without
    vectorField u;
    for (scalar ratio = springs; ; ratio *= 2)
    {
        body_.setSprings(ratio, modulus());
        body_.setLaw(law());
        if (body_.solve(u) || ratio > 1e3)
        {
            return ratio;
        }
    }
}


void Foam::fsbi::identification::fit()
{
    const untrapped scope;          // GSL takes logarithms of zero
    gsl_set_error_handler_off();
    const label n = nResiduals(), p = nConstants();
    gsl_multifit_nlinear_parameters parameters =
        gsl_multifit_nlinear_default_parameters();
    gsl_multifit_nlinear_fdf system{};
    system.f = residualOf;
    system.df = jacobianOf;
    system.n = n;
    system.p = p;
    system.params = this;
    gsl_multifit_nlinear_workspace* work = gsl_multifit_nlinear_alloc
    (
        gsl_multifit_nlinear_trust, &parameters, n, p
    );
    const gsl_vector_view from = gsl_vector_view_array(at_.data(), p);
    int info = 0;
    gsl_multifit_nlinear_init(&from.vector, &system, work);
    gsl_multifit_nlinear_driver
    (
        maxIterations, 1e-7, 1e-10, 0, nullptr, nullptr, &info, work
    );
    at_ = coordinates(gsl_multifit_nlinear_position(work));
    gsl_multifit_nlinear_free(work);
    evaluate();
}
