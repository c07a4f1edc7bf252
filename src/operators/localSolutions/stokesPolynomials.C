/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stokesPolynomials.H"
#include "error.H"
#include <Eigen/Dense>
#include <map>

namespace Foam
{
namespace fsbi
{

//- Monomial with these exponents
static label monomial(const label x, const label y, const label z)
{
    for (label k = 0; k < nCubic; ++k)
    {
        const label* e = cubicExponents[k];
        if (e[0] == x && e[1] == y && e[2] == z)
        {
            return k;
        }
    }
    return -1;
}


//- Equations of coefficients: one row for every monomial of every equation
static Eigen::MatrixXd stokesEquations()
{
    Eigen::MatrixXd A
    (
        Eigen::MatrixXd::Zero(nQuadratic + 3*4, 4*nCubic)
    );
    const auto raised = [](const label m, const label i, const label by)
    {
        label e[3] =
        {
            cubicExponents[m][0], cubicExponents[m][1], cubicExponents[m][2]
        };
        e[i] += by;
        return monomial(e[0], e[1], e[2]);
    };
    for (label m = 0; m < nQuadratic; ++m)
    {
        for (label i = 0; i < 3; ++i)
        {
            A(m, 4*raised(m, i, 1) + i) = cubicExponents[m][i] + 1;
        }
    }
    for (label m = 0; m < 4; ++m)
    {
        for (label i = 0; i < 3; ++i)
        {
            const label row = nQuadratic + 3*m + i;
            for (label k = 0; k < 3; ++k)
            {
                const label e = cubicExponents[m][k];
                A(row, 4*raised(m, k, 2) + i) = (e + 2)*(e + 1);
            }
            A(row, 4*raised(m, i, 1) + 3) = -(cubicExponents[m][i] + 1);
        }
    }
    return A;
}


//- Coefficients that equations may link have the same: degree as a velocity,
//  and symmetry
static label classOf(const label coefficient)
{
    const label m = coefficient/4, i = coefficient % 4;
    label degree = i == 3 ? 1 : 0, symmetry = 0;
    for (label k = 0; k < 3; ++k)
    {
        const label e = cubicExponents[m][k];
        degree += e;
        symmetry = 2*symmetry + (e + (i == k)) % 2;
    }
    return m ? 8*degree + symmetry : coefficient;
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::stokesPolynomials::stokesPolynomials()
:
    start_(1, Zero)
{
    std::map<label, DynamicList<label>> classes;
    for (label c = 0; c < nCoefficients; ++c)
    {
        if (c % 4 < 3 || c/4 < nQuadratic)
        {
            classes[classOf(c)].append(c);
        }
    }
    for (const auto& members : classes)
    {
        addClass(members.second);
    }
    if (start_.size() != nSolutions + 1)
    {
        FatalErrorInFunction
            << "Stokes' equations have " << start_.size() - 1
            << " polynomial solutions instead of " << nSolutions
            << abort(FatalError);
    }
}


void Foam::fsbi::stokesPolynomials::addClass(const UList<label>& coefficients)
{
    const label n = coefficients.size();
    const Eigen::MatrixXd equations(stokesEquations());
    Eigen::MatrixXd A(equations.rows(), n);
    for (label i = 0; i < n; ++i)
    {
        A.col(i) = equations.col(coefficients[i]);
    }
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(A, Eigen::ComputeFullV);
    // whole numbers up to 6: singular values are of order 1, or zero
    label rank = 0;
    while
    (
        rank < svd.singularValues().size() && svd.singularValues()[rank] > 1e-9
    )
    {
        ++rank;
    }
    for (label j = rank; j < n; ++j)
    {
        for (label i = 0; i < n; ++i)
        {
            const scalar z = svd.matrixV()(i, j);
            if (mag(z) > 1e-12)
            {
                coefficient_.append(coefficients[i]);
                value_.append(z);
            }
        }
        start_.append(coefficient_.size());
    }
}
