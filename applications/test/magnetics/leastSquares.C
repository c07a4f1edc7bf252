/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "magneticChecks.H"
#include "boundedLeastSquares.H"
#include "SubField.H"

#include <functional>

namespace Foam
{
namespace fsbi
{

static scalarField randomField(Random& random, const label n)
{
    scalarField x(n);
    for (scalar& v : x)
    {
        v = random.GaussNormal<scalar>();
    }
    return x;
}


//- |A x - b|^2
static scalar cost
(
    const scalarRectangularMatrix& A, const scalarField& b, const scalarField& x
)
{
    scalar sum = 0;
    for (label i = 0; i < A.m(); ++i)
    {
        scalar r = -b[i];
        for (label j = 0; j < A.n(); ++j)
        {
            r += A(i, j)*x[j];
        }
        sum += sqr(r);
    }
    return sum;
}


//- Least squares over some variables by the normal equations and LU
static scalarField overFree
(
    const scalarRectangularMatrix& A, const scalarField& b, scalarField x,
    const labelList& free
)
{
    const label n = free.size();
    scalarSquareMatrix N(n, n, Zero);
    scalarField rhs(n, Zero);
    for (label i = 0; i < A.m(); ++i)
    {
        scalar rest = b[i];
        for (label j = 0; j < A.n(); ++j)
        {
            rest -= free.found(j) ? 0 : A(i, j)*x[j];
        }
        for (label k = 0; k < n; ++k)
        {
            rhs[k] += A(i, free[k])*rest;
            for (label l = 0; l < n; ++l)
            {
                N(k, l) += A(i, free[k])*A(i, free[l]);
            }
        }
    }
    if (n)
    {
        LUsolve(N, rhs);
    }
    for (label k = 0; k < n; ++k)
    {
        x[free[k]] = rhs[k];
    }
    return x;
}


//- The best of all 3^n choices of what lies at which bound
static scalar bruteForce
(
    const scalarRectangularMatrix& A, const scalarField& b,
    const scalarField& lower, const scalarField& upper
)
{
    scalar best = VGREAT;
    label choices = 1;
    forAll(lower, i)
    {
        choices *= 3;
    }
    for (label choice = 0; choice < choices; ++choice)
    {
        scalarField x(lower.size());
        labelList free;
        bool inside = true;
        for (label i = 0, rest = choice; i < x.size(); ++i, rest /= 3)
        {
            x[i] = rest % 3 == 1 ? lower[i] : upper[i];
            inside = inside && mag(x[i]) < VGREAT;
            if (rest % 3 == 0)
            {
                free.append(i);
                x[i] = 0;
                inside = true;
            }
        }
        x = overFree(A, b, x, free);
        forAll(x, i)
        {
            inside = inside && x[i] >= lower[i] && x[i] <= upper[i];
        }
        best = inside ? min(best, cost(A, b, x)) : best;
    }
    return best;
}


void checkLeastSquares(checks& c)
{
    Random random(11);
    const label m = 8, n = 6;
    scalar worst = 0, slopes = 0;
    label bound = 0;
    for (label k = 0; k < 200; ++k)
    {
        scalarRectangularMatrix A(m, n);
        for (label i = 0; i < m*n; ++i)
        {
            // columns from alike to independent
            A(i/n, i % n) =
                random.GaussNormal<scalar>() + 3*(k % 3)*(i/n == 1);
        }
        const scalarField b(3*randomField(random, m));
        const scalarField lower(-mag(randomField(random, n)));
        const scalarField upper(mag(randomField(random, n)));
        const scalarField x(boundedLeastSquares(A, b, lower, upper));
        const scalar best = bruteForce(A, b, lower, upper);
        worst = max(worst, mag(cost(A, b, x)/best - 1));
        for (label j = 0; j < n; ++j)
        {
            // Karush, Kuhn and Tucker: no slope where free, outwards at bounds
            scalar slope = 0, size = 0;
            for (label i = 0; i < m; ++i)
            {
                scalar r = b[i];
                for (label l = 0; l < n; ++l)
                {
                    r -= A(i, l)*x[l];
                }
                slope += A(i, j)*r;
                size += sqr(A(i, j));
            }
            const bool low = x[j] <= lower[j], high = x[j] >= upper[j];
            const scalar wrong =
                low ? max(slope, 0) : high ? max(-slope, 0) : mag(slope);
            slopes = max(slopes, wrong/(sqrt(size)*mag(b[0]) + size));
            bound += low || high;
        }
    }
    c.checkBelow
    (
        "bounded least squares: the least of all 3^6 choices", worst, 1e-10
    );
    c.checkBelow
    (
        "bounded least squares: Karush-Kuhn-Tucker conditions", slopes, 1e-12
    );
    c.check
    (
        "bounded least squares: bounds were met, and not by all",
        bound > 200 && bound < 1000, std::to_string(bound)
    );
}

} // End namespace fsbi
} // End namespace Foam
