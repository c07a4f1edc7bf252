/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cornerSprings.H"

#include <Eigen/Dense>
#include <map>
#include <tuple>

namespace Foam
{
namespace fsbi
{

//- Eigenvalues over the largest that are left out
static const scalar negligible = 1e-6;

//- Most eigenvectors: each costs what an iteration does
static const label mostModes = 120;

//- Component of a body's point, or of a rigid body (point: -1)
typedef std::tuple<label, label, label> coordinate;

//- Derivative of a spring's length along n with regard to coordinates
typedef std::map<coordinate, scalar> gradient;

static void addEnd
(
    const loads& l, const loads::site& s, const vector& n, gradient& g
)
{
    if (s.body < 0)
    {
        return;
    }
    const List<triFace>& triangles = l.triangles(s.body);
    if (triangles.empty())
    {
        const sixVector whole(join(n, s.arm ^ n));
        forAll(whole, k)
        {
            g[coordinate(s.body, -1, k)] += whole[k];
        }
        return;
    }
    forAll(triangles[s.triangle], i)
    {
        for (direction k = 0; k < 3; ++k)
        {
            g[coordinate(s.body, triangles[s.triangle][i], k)] +=
                s.weights[i]*n[k];
        }
    }
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::cornerSprings::cornerSprings
(
    const loads& l,
    const label size,
    const rowsOfLoads& rows,
    const displacementsOf& displacements,
    const preconditioner& P
)
:
    loads_(l),
    displacements_(displacements)
{
    setModes();
    const label n = modes_.size();
    answers_.setSize(n, scalarList(size, Zero));
    factors_ = scalarSquareMatrix(n, n, Zero);
    pivots_.setSize(n);
    scalarList r(size);
    for (label k = 0; k < n; ++k)
    {
        std::fill(r.begin(), r.end(), scalar(0));
        rows(modes_[k], r.begin());
        for (scalar& row : r)
        {
            row = -row;         // springs pull back
        }
        P(r.cdata(), answers_[k].begin());
        const scalarField G(works(answers_[k].cdata()));
        for (label i = 0; i < n; ++i)
        {
            factors_(i, k) = G[i] + (i == k);
        }
    }
    if (n)
    {
        LUDecompose(factors_, pivots_);
    }
}


void Foam::fsbi::cornerSprings::setModes()
{
    std::map<coordinate, label> number;
    DynamicList<gradient> gradients;
    for (const loads::spring& s : loads_.springs())
    {
        // of contact: along one direction
        const scalar k = tr(s.stiffness);
        if (!loads::onCorners(s) || !(k > 0))
        {
            continue;
        }
        const vector n(normalised(s.force));
        gradient g;
        addEnd(loads_, s.a, Foam::sqrt(k)*n, g);
        addEnd(loads_, s.b, -Foam::sqrt(k)*n, g);
        for (const auto& part : g)
        {
            number.insert({part.first, label(number.size())});
        }
        gradients.append(g);
    }
    Eigen::MatrixXd C = Eigen::MatrixXd::Zero(number.size(), number.size());
    for (const gradient& g : gradients)
    {
        for (const auto& i : g)
        {
            for (const auto& j : g)
            {
                C(number[i.first], number[j.first]) += i.second*j.second;
            }
        }
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(C);
    const label n = number.size();
    for (label k = n - 1; k >= 0 && modes_.size() < mostModes; --k)
    {
        const scalar lambda = eigen.eigenvalues()[k];
        if (!(lambda > negligible*eigen.eigenvalues()[n - 1]))
        {
            break;
        }
        modes_.append(loads_.zero());
        for (const auto& c : number)
        {
            const scalar b = Foam::sqrt(lambda)*eigen.eigenvectors()(c.second, k);
            label body, pointi, component;
            std::tie(body, pointi, component) = c.first;
            if (pointi < 0)
            {
                modes_.last().whole[body][component] = b;
            }
            else
            {
                modes_.last().points[body][pointi][component] = b;
            }
        }
    }
}


Foam::scalarField Foam::fsbi::cornerSprings::works(const scalar* z) const
{
    const loads::ofBodies u(displacements_(z));
    scalarField result(modes_.size());
    forAll(result, k)
    {
        result[k] = loads_.work(modes_[k], u);
    }
    return result;
}


void Foam::fsbi::cornerSprings::apply(scalar* z) const
{
    if (modes_.empty())
    {
        return;
    }
    scalarField a(works(z));
    LUBacksubstitute(factors_, pivots_, a);
    forAll(answers_, k)
    {
        const scalarList& Y = answers_[k];
        forAll(Y, i)
        {
            z[i] -= a[k]*Y[i];
        }
    }
}
