/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "interfaceLeastSquares.H"
#include "untrapped.H"

#include <Eigen/Core>
#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsbi::interfaceLeastSquares::append
(
    const label number, const scalarField& column, const scalar filter
)
{
    const scalar norm = product_.norm(column);
    if (!std::isfinite(norm) || !(norm > VSMALL))
    {
        return;
    }
    scalarField q(column/norm);
    scalarList r(Q_.size(), Zero);
    for (label sweep = 0; sweep < 2; ++sweep)
    {
        const scalarList parts(product_.products(Q_, q));
        forAll(Q_, j)
        {
            q -= parts[j]*Q_[j];
            r[j] += parts[j];
        }
    }
    const scalar left = product_.norm(q);
    if (left < filter)
    {
        return;
    }
    r.append(left);
    q /= left;
    Q_.append(q);
    R_.append(r);
    kept_.append(number);
    norms_.append(norm);
}


void Foam::fsbi::interfaceLeastSquares::solve(const scalarField& b)
{
    const label n = rank();
    const scalarList parts(product_.products(Q_, b));
    Eigen::MatrixXd R(Eigen::MatrixXd::Zero(n, n));
    Eigen::VectorXd y(n);
    for (label j = 0; j < n; ++j)
    {
        y[j] = parts[j];
        for (label i = 0; i <= j; ++i)
        {
            R(i, j) = R_[j][i];
        }
    }
    R.triangularView<Eigen::Upper>().solveInPlace(y);
    for (label j = 0; j < n; ++j)
    {
        coefficients_[kept_[j]] = y[j]/norms_[j];
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::interfaceLeastSquares::interfaceLeastSquares
(
    const interfaceProduct& product,
    const UList<const scalarField*>& columns,
    const scalarField& b,
    const scalar filter
)
:
    product_(product),
    coefficients_(columns.size(), Zero)
{
    // a column that overflows is left out
    const untrapped scope;
    forAll(columns, j)
    {
        append(j, *columns[j], filter);
    }
    if (rank())
    {
        solve(b);
    }
}
