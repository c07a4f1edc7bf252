/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "boundedLeastSquares.H"

#include <Eigen/Dense>
#include <vector>

namespace Foam
{
namespace fsbi
{

//- Slopes below this part of |A_i| |b| are rounding
static const scalar smallSlope = 1e-12;

class activeSet
{
    Eigen::MatrixXd A_;
    Eigen::VectorXd b_, lower_, upper_, x_;
    std::vector<bool> free_;

    //- Least squares over the free variables, the others where they are
    Eigen::VectorXd unbounded() const
    {
        std::vector<Eigen::Index> at;
        for (Eigen::Index i = 0; i < x_.size(); ++i)
        {
            if (free_[i])
            {
                at.push_back(i);
            }
        }
        Eigen::VectorXd z = x_;
        if (at.size())
        {
            Eigen::MatrixXd part(A_.rows(), at.size());
            for (size_t k = 0; k < at.size(); ++k)
            {
                part.col(k) = A_.col(at[k]);
            }
            const Eigen::VectorXd dx =
                part.colPivHouseholderQr().solve(b_ - A_*x_);
            for (size_t k = 0; k < at.size(); ++k)
            {
                z[at[k]] += dx[k];
            }
        }
        return z;
    }

    //- Go towards z until a bound is met, which then holds; true: z reached
    bool approach(const Eigen::VectorXd& z)
    {
        double part = 1;
        Eigen::Index first = -1;
        for (Eigen::Index i = 0; i < x_.size(); ++i)
        {
            const double bound = z[i] < x_[i] ? lower_[i] : upper_[i];
            if (free_[i] && (z[i] < lower_[i] || z[i] > upper_[i]))
            {
                const double room = (bound - x_[i])/(z[i] - x_[i]);
                if (room < part || first < 0)
                {
                    part = std::min(part, std::max(room, 0.0));
                    first = i;
                }
            }
        }
        x_ += part*(z - x_);
        if (first >= 0)
        {
            x_[first] =
                z[first] < lower_[first] ? lower_[first] : upper_[first];
            free_[first] = false;
        }
        return first < 0;
    }

    //- The variable at a bound that the slope draws away most strongly
    Eigen::Index drawnAway() const
    {
        const Eigen::VectorXd slope = A_.transpose()*(b_ - A_*x_);
        Eigen::Index best = -1;
        double largest = 0;
        for (Eigen::Index i = 0; i < x_.size(); ++i)
        {
            const double inwards = x_[i] > lower_[i] ? -slope[i] : slope[i];
            const double scale = A_.col(i).norm()*b_.norm();
            if
            (
                !free_[i] && lower_[i] < upper_[i]
             && inwards > smallSlope*scale && inwards > largest*scale
            )
            {
                largest = inwards/scale;
                best = i;
            }
        }
        return best;
    }

public:

    activeSet
    (
        const scalarRectangularMatrix& A, const scalarField& b,
        const scalarField& lower, const scalarField& upper
    )
    :
        A_(A.m(), A.n()), b_(A.m()), lower_(A.n()), upper_(A.n()),
        x_(Eigen::VectorXd::Zero(A.n())), free_(A.n(), true)
    {
        for (label j = 0; j < A.n(); ++j)
        {
            lower_[j] = lower[j];
            upper_[j] = upper[j];
            for (label i = 0; i < A.m(); ++i)
            {
                A_(i, j) = A(i, j);
            }
        }
        for (label i = 0; i < A.m(); ++i)
        {
            b_[i] = b[i];
        }
    }

    //- False: no end
    bool solve(scalarField& x)
    {
        for (label n = 0; n < 100*(x_.size() + 1); ++n)
        {
            if (!approach(unbounded()))
            {
                continue;
            }
            const Eigen::Index i = drawnAway();
            if (i < 0)
            {
                x.setSize(x_.size());
                std::copy(x_.data(), x_.data() + x_.size(), x.begin());
                return true;
            }
            free_[i] = true;
        }
        return false;
    }
};

} // End namespace fsbi
} // End namespace Foam


Foam::scalarField Foam::fsbi::boundedLeastSquares
(
    const scalarRectangularMatrix& A,
    const scalarField& b,
    const scalarField& lower,
    const scalarField& upper
)
{
    scalarField x;
    if (!activeSet(A, b, lower, upper).solve(x))
    {
        FatalErrorInFunction
            << "The bounded least squares of " << A.n() << " variables find no"
            << " end: their matrix has not full rank" << exit(FatalError);
    }
    return x;
}
