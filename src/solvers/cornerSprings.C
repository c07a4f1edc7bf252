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

//- Directions in which a spring is stiff, times the root of how much
static DynamicList<vector> stiffDirections(const loads::spring& s)
{
    DynamicList<vector> directions;
    const scalar k = tr(s.stiffness);
    if (!(k > 0))
    {
        return directions;
    }
    // of contact: along the force
    const vector n(normalised(s.force));
    if (mag(s.stiffness - k*sqr(n)) < 1e-12*k)
    {
        directions.append(Foam::sqrt(k)*n);
        return directions;
    }
    Eigen::Matrix3d S;
    for (direction i = 0; i < 3; ++i)
    {
        for (direction j = 0; j < 3; ++j)
        {
            S(i, j) = 0.5*(s.stiffness(i, j) + s.stiffness(j, i));
        }
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(S);
    for (direction i = 0; i < 3; ++i)
    {
        const scalar lambda = eigen.eigenvalues()[i];
        if (lambda > negligible*k)
        {
            const auto e = eigen.eigenvectors().col(i);
            directions.append(Foam::sqrt(lambda)*vector(e[0], e[1], e[2]));
        }
    }
    return directions;
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
        if (!loads::onCorners(s))
        {
            continue;
        }
        for (const vector& along : stiffDirections(s))
        {
            gradient g;
            addEnd(loads_, s.a, along, g);
            addEnd(loads_, s.b, -along, g);
            for (const auto& part : g)
            {
                number.insert({part.first, label(number.size())});
            }
            gradients.append(g);
        }
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
