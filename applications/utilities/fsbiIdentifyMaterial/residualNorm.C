/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "residualNorm.H"
#include "untrapped.H"

#include <algorithm>
#include <Eigen/Dense>

namespace Foam
{
namespace fsbi
{

//- Floors, over the residual's size: from, to, and how they fall
static const scalar firstFloor = 0.1, lastFloor = 1e-9, fall = 0.1;

static const label stepsPerFloor = 40;

//- Of a step, over what a step may at most bring about
static const scalar settled = 1e-10, shortest = 1e-6;

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::residualNorm::residualNorm(const checkedDictionary& entries)
:
    norm_(entries.positive("norm", 2)),
    power_(entries.positive("power", norm_))
{
    if (norm_ < 1 || power_ < 1)
    {
        FatalIOErrorInFunction(entries.dict())
            << "'norm' and 'power' must be 1 at least: below, the lowest sum of"
            << " residuals has no single place" << exit(FatalIOError);
    }
}


Foam::vectorField Foam::fsbi::moved
(
    const vectorField& r,
    const UList<vectorField>& J,
    const scalarList& d,
    const scalar part
)
{
    vectorField result(r);
    forAll(d, k)
    {
        result += part*d[k]*J[k];
    }
    return result;
}


Foam::scalar Foam::fsbi::residualNorm::cost
(
    const vectorField& r, const scalar floor
) const
{
    scalar sum = 0;
    for (const vector& v : r)
    {
        scalar point = 0;
        for (direction k = 0; k < 3; ++k)
        {
            point += Foam::pow(Foam::sqrt(sqr(v[k]) + sqr(floor)), norm_);
        }
        sum += Foam::pow(point, power_/norm_);
    }
    return sum;
}


Foam::vectorField Foam::fsbi::residualNorm::weights
(
    const vectorField& r, const scalar floor
) const
{
    vectorField result(r.size());
    forAll(r, i)
    {
        scalar point = 0;
        for (direction k = 0; k < 3; ++k)
        {
            const scalar a = Foam::sqrt(sqr(r[i][k]) + sqr(floor));
            point += Foam::pow(a, norm_);
            result[i][k] = Foam::pow(a, norm_ - 2);
        }
        result[i] *= Foam::pow(point, power_/norm_ - 1);
    }
    return result;
}


Foam::scalarList Foam::fsbi::residualNorm::step
(
    const vectorField& r,
    const UList<vectorField>& J,
    const scalar floor
) const
{
    const label p = J.size();
    const vectorField w(weights(r, floor));
    Eigen::MatrixXd A(p, p);
    Eigen::VectorXd b(p);
    for (label k = 0; k < p; ++k)
    {
        const vectorField weighted(cmptMultiply(w, J[k]));
        b[k] = -sum(weighted & r);
        for (label l = 0; l < p; ++l)
        {
            A(k, l) = sum(weighted & J[l]);
        }
    }
    // unknowns of their own sizes
    const Eigen::VectorXd size(A.diagonal().cwiseSqrt());
    if (!(size.minCoeff() > 0))
    {
        return scalarList();
    }
    const Eigen::VectorXd inverse(size.cwiseInverse());
    const Eigen::VectorXd d
    (
        inverse.asDiagonal()
       *(inverse.asDiagonal()*A*inverse.asDiagonal()).ldlt().solve
        (
            inverse.asDiagonal()*b
        )
    );
    if (!d.allFinite())
    {
        return scalarList();
    }
    scalarList step(p);
    std::copy_n(d.data(), p, step.begin());
    return step;
}


Foam::scalarList Foam::fsbi::residualNorm::lowest
(
    const vectorField& given, const UList<vectorField>& J
) const
{
    const untrapped scope;          // Eigen computes with what it discards
    scalarList d(J.size(), Zero);
    const scalar size = Foam::sqrt(sum(magSqr(given))/(3*given.size()));
    if (J.empty() || !(size > 0))
    {
        return d;
    }
    // in units of the residual: high powers of it neither vanish nor overflow
    const vectorField r(given/size);
    for (scalar floor = firstFloor; floor >= 0.99*lastFloor; floor *= fall)
    {
        for (label i = 0; i < stepsPerFloor; ++i)
        {
            const vectorField now(moved(r, J, d));
            const scalarList change(step(now, J, floor));
            const scalar before = cost(now, floor);
            scalar part = 1;
            while
            (
                part > shortest
             && !(cost(moved(now, J, change, part), floor) < before)
            )
            {
                part /= 2;
            }
            if (change.empty() || part <= shortest)
            {
                break;
            }
            scalar largest = 0;
            forAll(d, k)
            {
                d[k] += part*change[k];
                largest = max
                (
                    largest, part*mag(change[k])*Foam::sqrt(max(magSqr(J[k])))
                );
            }
            if (largest < settled)
            {
                break;
            }
        }
    }
    forAll(d, k)
    {
        d[k] *= size;
    }
    return d;
}
