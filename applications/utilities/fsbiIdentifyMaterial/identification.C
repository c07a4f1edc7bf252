/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "identification.H"
#include "untrapped.H"

#include <gsl/gsl_multifit_nlinear.h>
#include <gsl/gsl_errno.h>
#include <Eigen/Dense>

namespace Foam
{
namespace fsbi
{

//- Difference quotients, over the width of a range
static const scalar relativeStep = 1e-4;

static const int maxIterations = 60;

//- Neighbours for the roughness, of a surface with six coefficients
static const label neighbours = 14;

//- Of normal errors, over the median of their magnitude
static const scalar deviationOverMedian = 1.4826;

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

static int slopesOf(const gsl_vector* c, void* p, gsl_matrix* J)
{
    List<vectorField> slopes;
    of(p).slopes(coordinates(c), slopes);
    forAll(slopes, k)
    {
        for (label i = 0; i < 3*slopes[k].size(); ++i)
        {
            gsl_matrix_set(J, i, k, slopes[k][i/3][i % 3]);
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
    const List<constant>& constants
)
:
    body_(body),
    data_(data),
    law_(law),
    constants_(constants),
    at_(constants.size()),
    slopes_(constants.size())
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
    if (!body_.solve(r))
    {
        r = vectorField(data_.size(), vector::one*10*body_.radius());
        return;
    }
    r -= data_.u;
    removeRigid(r);
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


void Foam::fsbi::identification::slopes
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
        ratio = soften(ratio);
        fit();
        if (mag(modulus() - E) < 0.3*E)
        {
            return;
        }
    }
}


Foam::scalar Foam::fsbi::identification::soften(const scalar springs)
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
    const label n = 3*nPoints(), p = nConstants();
    gsl_multifit_nlinear_parameters parameters =
        gsl_multifit_nlinear_default_parameters();
    gsl_multifit_nlinear_fdf system{};
    system.f = residualOf;
    system.df = slopesOf;
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
    const scalarList found(at_);
    slopes(found, slopes_);
    residual(found, residual_);
    vectorField u;
    if (!body_.solve(u))
    {
        collapsed();
    }
}


bool Foam::fsbi::identification::limited(const label k) const
{
    const scalar part =
        (at_[k] - constants_[k].coordinate(constants_[k].lowest))
       /constants_[k].width();
    return part < 1e-3 || part > 1 - 1e-3;
}


Foam::label Foam::fsbi::identification::freedom() const
{
    return 3*nPoints() - nConstants() - rigid_.size();
}


Foam::scalar Foam::fsbi::identification::displacementError() const
{
    return Foam::sqrt(sum(magSqr(residual_))/freedom());
}


Foam::scalar Foam::fsbi::identification::roughness
(
    const vectorField& values
) const
{
    DynamicList<scalar> off;
    forAll(data_.x, i)
    {
        const labelList near
        (
            surfaceTransfer::nearest(data_.x, data_.x[i], neighbours + 1)
        );
        const labelList others(SubList<label>(near, near.size() - 1, 1));
        const scalarList weights
        (
            surfaceTransfer::fit(data_.x, others, data_.x[i], true)
        );
        vector e(values[i]);
        scalar square = 1;
        forAll(others, j)
        {
            e -= weights[j]*values[others[j]];
            square += sqr(weights[j]);
        }
        for (direction k = 0; k < 3 && std::isfinite(mag(e)); ++k)
        {
            off.append(mag(e[k])/Foam::sqrt(square));
        }
    }
    if (off.empty())
    {
        return 0;
    }
    sort(off);
    return deviationOverMedian*off[off.size()/2];
}


Foam::scalar Foam::fsbi::identification::misfit() const
{
    vectorField u(data_.u);
    removeRigid(u);
    return Foam::sqrt(sum(magSqr(residual_))/sum(magSqr(u)));
}


Foam::scalar Foam::fsbi::identification::noise() const
{
    vectorField u(data_.u);
    removeRigid(u);
    return min
    (
        misfit(),
        roughness(data_.u)*Foam::sqrt(scalar(freedom())/sum(magSqr(u)))
    );
}


Foam::List<Foam::scalarList> Foam::fsbi::identification::inverse() const
{
    const label p = nConstants();
    Eigen::MatrixXd JJ(p, p);
    for (label k = 0; k < p; ++k)
    {
        for (label l = 0; l < p; ++l)
        {
            JJ(k, l) = sum(slopes_[k] & slopes_[l]);
        }
    }
    const untrapped scope;          // Eigen computes with what it discards
    const Eigen::MatrixXd inverse(JJ.inverse());
    List<scalarList> result(p, scalarList(p));
    for (label k = 0; k < p; ++k)
    {
        for (label l = 0; l < p; ++l)
        {
            result[k][l] = inverse(k, l);
        }
    }
    return result;
}


Foam::List<Foam::scalarList> Foam::fsbi::identification::covariance
(
    const scalar tractionError
)
{
    const label p = nConstants();
    const List<scalarList> weights(inverse());
    const surfaceTransfer& transfer = body_.transfer();
    List<vectorField> byU(p), byT(p);
    for (label k = 0; k < p; ++k)
    {
        byU[k].setSize(nPoints(), Zero);
        for (label l = 0; l < p; ++l)
        {
            byU[k] += weights[k][l]*slopes_[l];
        }
        vectorField response, reaction;
        if (!body_.respond(transfer.fromPoints(byU[k]), response, reaction))
        {
            return List<scalarList>(p, scalarList(p, GREAT));
        }
        byT[k] = transfer.fromFaces(body_.areas()*response);
        byU[k] += transfer.fromFaces(reaction) - body_.stiffness()*byT[k];
    }
    List<scalarList> result(p, scalarList(p));
    for (label k = 0; k < p; ++k)
    {
        for (label l = 0; l < p; ++l)
        {
            result[k][l] =
                sqr(displacementError())*sum(byU[k] & byU[l])
              + sqr(tractionError)*sum(byT[k] & byT[l]);
        }
    }
    return result;
}
