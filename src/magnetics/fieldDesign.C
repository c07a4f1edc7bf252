/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fieldDesign.H"
#include "mathematicalConstants.H"

#include <Eigen/SVD>

namespace Foam
{
namespace fsbi
{

//- Weight of the bias against the load
static const scalar biasWeight = 0.01;

//- Regularisation: first, last, and from one to the next
static const scalar firstLambda = 0.3, lastLambda = 1e-6, lambdaRatio = 0.3;

//- Singular values below this part of the largest are rounding
static const scalar smallSingular = 1e-8;

//- Gauss-Newton steps for each, halvings of a step, and the end
static const label maxSteps = 100, maxHalvings = 30;
static const scalar smallStep = 1e-10;

//- A load this close is made
static const scalar attained = 1e-6;

//- Of |B|, for differences of the moment
static const scalar fieldStep = 0.01;

//- Smallest singular value of the load's six rows that is not zero
static scalar sensitivity(const scalarRectangularMatrix& J)
{
    Eigen::MatrixXd A(6, J.n());
    for (label i = 0; i < 6; ++i)
    {
        for (label k = 0; k < J.n(); ++k)
        {
            A(i, k) = J(i, k);
        }
    }
    const Eigen::VectorXd s = Eigen::JacobiSVD<Eigen::MatrixXd>(A)
        .singularValues();
    scalar smallest = s[0];
    for (Eigen::Index i = 0; i < s.size(); ++i)
    {
        smallest = s[i] > smallSingular*s[0] ? s[i] : smallest;
    }
    return smallest;
}

} // End namespace fsbi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::fieldDesign::fieldDesign
(
    const magnetisation& law, const scalar volume, const units& u,
    const scalar largestLoad, const vector& bias, const dictionary& entries
)
:
    law_(law),
    volume_(volume),
    joule_(u.joule()),
    radius_(radius(volume, u)),
    largest_(largestLoad),
    bias_(bias),
    induced_
    (
        mag
        (
            law.moment(volume, tensor::I, vector(1, 0, 0))
          - law.moment(volume, tensor::I, vector(0, 2, 0))
        ) > 0
    )
{
    const vector one(1, 0, 0);
    const vector m(law.moment(volume, tensor::I, one));
    if (volume <= 0 || mag(m) <= 0)
    {
        FatalIOErrorInFunction(entries)
            << "A body of the volume " << volume << " m3 and the moment "
            << mag(m) << " A m2 in 1 T cannot be moved by magnetic fields"
            << exit(FatalIOError);
    }
    if
    (
        induced_ && mag(bias) == 0
     && mag(law.moment(volume, tensor::I, 2*one) - m) < 1e-6*mag(m)
    )
    {
        FatalIOErrorInFunction(entries)
            << "The body is saturated in any field, so that there is no least"
            << " one: give a 'bias' in system/fieldDesignDict"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::fsbi::fieldHere Foam::fsbi::fieldDesign::fieldOf
(
    const task& t, const scalarField& y
) const
{
    fieldHere sum(t.given);
    forAll(y, k)
    {
        sum.B += y[k]*t.sources[k].unit.B;
        sum.gradient += y[k]*t.sources[k].unit.gradient;
    }
    return sum;
}


Foam::vector Foam::fsbi::fieldDesign::momentChange
(
    const task& t, const vector& B, const vector& change
) const
{
    const scalar size = mag(change);
    if (!induced_ || size == 0)
    {
        return Zero;
    }
    // of fourth order, so that the step may be large and rounding small
    const vector h(fieldStep*(mag(B) > 0 ? mag(B)/size : 1)*change);
    const auto across = [&](const vector& step)
    {
        return
            law_.moment(volume_, t.R, B + step)
          - law_.moment(volume_, t.R, B - step);
    };
    return (8*across(h) - across(2*h))*size/(12*mag(h));
}


//- Force, torque over the radius, and the bias' part, in one list
static Foam::scalarField rowsOf
(
    const Foam::vector& F, const Foam::vector& T, const Foam::vector& B
)
{
    Foam::scalarField rows(9);
    for (Foam::direction d = 0; d < 3; ++d)
    {
        rows[d] = F[d];
        rows[3 + d] = T[d];
        rows[6 + d] = B[d];
    }
    return rows;
}


Foam::scalarField Foam::fsbi::fieldDesign::residual
(
    const task& t, const fieldHere& f
) const
{
    const vector m(law_.moment(volume_, t.R, f.B));
    vector off(Zero);
    if (mag(bias_) > 0)
    {
        off = biasWeight/mag(bias_)*(f.B - bias_);
        off = induced_ ? off : vector((off & m)/magSqr(m)*m);
    }
    return rowsOf
    (
        (joule_*(f.gradient & m) - t.force)/largest_,
        (joule_*(m ^ f.B) - t.torque)/(radius_*largest_),
        off
    );
}


Foam::scalarField Foam::fsbi::fieldDesign::derivative
(
    const task& t, const fieldHere& f, const fieldHere& change
) const
{
    const vector m(law_.moment(volume_, t.R, f.B));
    const vector dm(momentChange(t, f.B, change.B));
    vector off(Zero);
    if (mag(bias_) > 0)
    {
        off = biasWeight/mag(bias_)*change.B;
        off = induced_ ? off : vector((off & m)/magSqr(m)*m);
    }
    return rowsOf
    (
        joule_/largest_*((change.gradient & m) + (f.gradient & dm)),
        joule_/(radius_*largest_)*((m ^ change.B) + (dm ^ f.B)),
        off
    );
}


Foam::scalarRectangularMatrix Foam::fsbi::fieldDesign::matrix
(
    const task& t, const fieldHere& f, const scalar damping
) const
{
    const label n = t.sources.size();
    scalarRectangularMatrix J(9 + n, n, Zero);
    forAll(t.sources, k)
    {
        const source& s = t.sources[k];
        const scalarField column(derivative(t, f, s.unit));
        forAll(column, i)
        {
            J(i, k) = s.scale*column[i];
        }
        J(9 + k, k) = damping;
    }
    return J;
}


Foam::scalarField Foam::fsbi::fieldDesign::start
(
    const task& t, const vector& e
) const
{
    const label n = t.sources.size();
    scalar ofB = 0, ofG = 0;
    for (const source& s : t.sources)
    {
        ofB += sqr(s.scale)*magSqr(s.unit.B);
        ofG += sqr(s.scale)*magSqr(s.unit.gradient);
    }
    // least |B|^2/ofB + |grad(B)|^2/ofG of a force along B
    const scalar slope =
        joule_*mag(law_.moment(volume_, t.R, e))*sqrt(ofG/max(ofB, VSMALL));
    const scalar need = load(t.force, t.torque, radius_);
    const vector B
    (
        mag(bias_) > 0 ? bias_ : sqrt(sqrt(1.5)*need/max(slope, VSMALL))*e
    );
    scalarRectangularMatrix A(3 + n, n, Zero);
    scalarField b(3 + n, Zero), limits(n);
    forAll(t.sources, k)
    {
        const source& s = t.sources[k];
        for (direction d = 0; d < 3; ++d)
        {
            A(d, k) = s.scale*s.unit.B[d];
            b[d] = B[d] - t.given.B[d];
        }
        A(3 + k, k) = lastLambda*sqrt(max(ofB, VSMALL));
        limits[k] = s.limit/s.scale;
    }
    scalarField y(boundedLeastSquares(A, b, -limits, limits));
    forAll(y, k)
    {
        y[k] *= t.sources[k].scale;
    }
    return y;
}


void Foam::fsbi::fieldDesign::gaussNewtonStep
(
    const task& t, const scalar damping, scalarField& y
) const
{
    const label n = y.size();
    const auto rows = [&](const scalarField& at)
    {
        scalarField r(residual(t, fieldOf(t, at)));
        r.setSize(9 + n);
        forAll(at, k)
        {
            r[9 + k] = damping*at[k]/t.sources[k].scale;
        }
        return r;
    };
    scalarField r(rows(y)), lower(n), upper(n);
    for (label step = 0; step < maxSteps; ++step)
    {
        forAll(y, k)
        {
            lower[k] = min((-t.sources[k].limit - y[k])/t.sources[k].scale, 0);
            upper[k] = max((t.sources[k].limit - y[k])/t.sources[k].scale, 0);
        }
        scalarField dy
        (
            boundedLeastSquares
            (
                matrix(t, fieldOf(t, y), damping), -r, lower, upper
            )
        );
        scalar change = 0, size = 0;
        forAll(y, k)
        {
            change += sqr(dy[k]);
            size += sqr(y[k]/t.sources[k].scale);
            dy[k] *= t.sources[k].scale;
        }
        label halvings = 0;
        scalarField tried(y + dy), rTried(rows(tried));
        while (sumSqr(rTried) > sumSqr(r) && ++halvings < maxHalvings)
        {
            dy *= 0.5;
            tried = y + dy;
            rTried = rows(tried);
        }
        if (sumSqr(rTried) > sumSqr(r))
        {
            return;             // nothing but rounding is left
        }
        y = tried;
        r = rTried;
        if (sqrt(change) <= smallStep*sqrt(size))
        {
            return;
        }
    }
}


Foam::fsbi::fieldDesign::solution Foam::fsbi::fieldDesign::from
(
    const task& t, scalarField y
) const
{
    const scalar sigma = sensitivity(matrix(t, fieldOf(t, y), 0));
    if (sigma > 0)
    {
        for (scalar l = firstLambda; l > lastLambda; l *= lambdaRatio)
        {
            gaussNewtonStep(t, l*sigma, y);
        }
    }
    return madeBy(t, y);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsbi::fieldDesign::radius
(
    const scalar volume, const units& u
)
{
    return cbrt(0.75*max(volume, 0)/constant::mathematical::pi)*u.metre();
}


Foam::fsbi::fieldDesign::solution Foam::fsbi::fieldDesign::madeBy
(
    const task& t, const scalarField& y
) const
{
    const fieldHere f(fieldOf(t, y));
    const vector m(law_.moment(volume_, t.R, f.B));
    const vector F(joule_*(f.gradient & m)), T(joule_*(m ^ f.B));
    return
    {
        y, f, F, T, load(F - t.force, T - t.torque, radius_)/largest_
    };
}


Foam::fsbi::fieldDesign::solution Foam::fsbi::fieldDesign::solve
(
    const task& t, const scalarField& startStrengths
) const
{
    const scalarField none(t.sources.size(), Zero);
    const bool wanted =
        load(t.force, t.torque, radius_) > 0 || mag(bias_) > 0;
    if (!induced_ || !wanted)
    {
        return from(t, none);
    }
    const vector along
    (
        mag(t.force) > 0 ? t.force/mag(t.force) : vector(1, 2, 3)/sqrt(14.0)
    );
    const bool fresh =
        startStrengths.empty() || mag(fieldOf(t, startStrengths).B) == 0;
    solution best(from(t, fresh ? start(t, along) : startStrengths));

    // directions of a cube's corners, edges and faces; its centre: the force
    const label directions = mag(bias_) > 0 ? 0 : 27;
    for (label i = 0; i < directions && best.residual > attained; ++i)
    {
        const vector e(i % 3 - 1, i/3 % 3 - 1, i/9 - 1);
        const solution s
        (
            from(t, start(t, mag(e) > 0 ? e/mag(e) : along))
        );
        if (s.residual < 0.9*best.residual)
        {
            best = s;
        }
    }
    if (!fresh && sumProd(best.strengths, startStrengths) < 0)
    {
        const solution turned(madeBy(t, -best.strengths));
        return turned.residual <= max(best.residual, attained) ? turned : best;
    }
    return best;
}
