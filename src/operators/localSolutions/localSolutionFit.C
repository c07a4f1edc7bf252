/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "localSolutionStencil.H"
#include "localSolutionGram.H"
#include "vertexFit.H"

namespace Foam
{
namespace fsbi
{

//- b/mu [1/(L T)] around a vertex by least squares, b_0 + d.gradient, lengths in h
static void fitForce
(
    const vertexFit& f,
    const scalar* rows,
    const vector* force,
    vector& atVertex,
    tensor& gradient
)
{
    scalar a[nCubic], weights = 0;
    vector centre(Zero), mean(Zero);
    symmTensor spread(Zero);
    tensor product(Zero);
    forAll(f.cells, i)
    {
        copyRow(rows, i, a);
        const vector d(a[1], a[2], a[3]);
        const scalar w = cellWeight(magSqr(d));
        weights += w;
        centre += w*d;
        mean += w*force[f.cells[i]];
        spread += w*sqr(d);
        product += w*d*force[f.cells[i]];
    }
    centre /= weights;
    mean /= weights;
    spread -= weights*sqr(centre);
    product -= weights*centre*mean;
    gradient = inv(spread) & product;
    atVertex = mean - (centre & gradient);
}


//- Coefficients of a solution with that force
static void setForced
(
    const scalar h, const vector& atVertex, const tensor& gradient, scalar* c
)
{
    std::fill_n(c, stokesPolynomials::nCoefficients, scalar(0));
    const vector b(sqr(h)*atVertex);
    const tensor B(sqr(h)*gradient);
    for (direction i = 0; i < 3; ++i)
    {
        c[4*(1 + i) + 3] = b[i];
    }
    c[4*4 + 3] = B.xx()/2;
    c[4*5 + 3] = (B.xy() + B.yx())/2;
    c[4*6 + 3] = (B.xz() + B.zx())/2;
    c[4*7 + 3] = B.yy()/2;
    c[4*8 + 3] = (B.yz() + B.zy())/2;
    c[4*9 + 3] = B.zz()/2;
    const vector w(vector(B.yz() - B.zy(), B.zx() - B.xz(), B.xy() - B.yx())/2);
    // |x|^2 times x, y and z
    const label cubic[3][3] = {{10, 13, 15}, {11, 16, 18}, {12, 17, 19}};
    for (direction i = 0; i < 3; ++i)
    {
        const direction j = (i + 1) % 3, k = (i + 2) % 3;
        for (label m = 0; m < 3; ++m)
        {
            c[4*cubic[k][m] + i] = -w[j]/10;
            c[4*cubic[j][m] + i] = w[k]/10;
        }
    }
}


//- Take off b what a solution's coefficients c would add to it
static void subtractForced
(
    const vertexFit& f,
    const UList<point>& around,
    const scalar* rows,
    const scalar* c,
    scalar* b
)
{
    scalar a[nCubic];
    const auto subtract = [&](const scalar weight, const bool pressure)
    {
        fourNumbers sum = {0, 0, 0, 0};
        addProducts<nCubic>(a, c, sum);
        sum *= weight;
        sum[3] *= pressure;
        for (label k = 0; k < nCubic; ++k)
        {
            four(b + 4*k) -= a[k]*sum;
        }
    };
    forAll(f.cells, i)
    {
        copyRow(rows, i, a);
        subtract(cellWeight(a[1]*a[1] + a[2]*a[2] + a[3]*a[3]), true);
    }
    for (const point& x : around)
    {
        const vector d(f.perLength*(x - f.origin));
        setMonomials(d, a);
        subtract(pointWeight(magSqr(d)), false);
    }
}

} // End namespace fsbi
} // End namespace Foam


void Foam::fsbi::localSolutionStencil::addModes
(
    const vertexFit& f, const label v, const scalar* rows,
    const vectorField& onWall, scalar* c, scalar* defects
) const
{
    const label nCells = f.cells.size();
    if (consecutive_.size() < nCells)
    {
        consecutive_ = identity(2*nCells);
    }
    residuals_.setSize(4*nCells);
    setDefects
    (
        f, rows, c, SubList<label>(consecutive_, nCells), residuals_.begin()
    );
    if (f.onWall)
    {
        const labelList& ring = wall_.around(wall_.number(v));
        residuals_.setSize(4*nCells + 3*(ring.size() - 1));
        for (label j = 1; j < ring.size(); ++j)
        {
            const vector x(f.perLength*(wall_.points()[ring[j]] - f.origin));
            const vector left(onWall[ring[j]] - velocityOf(c, x));
            std::copy_n(left.cdata(), 3, &residuals_[4*nCells + 3*(j - 1)]);
        }
    }
    wedges_.add(wedges_.number(v), residuals_, place_[v], c, defects);
}


void Foam::fsbi::localSolutionStencil::fit
(
    List<FixedList<scalar, 4>>& x, vectorField& onWall, vectorField& force,
    scalar* coefficients, scalar* defects
) const
{
    cells_.fill(x);
    wall_.fill(onWall);
    const bool forced = returnReduce(force.size() > 0, orOp<bool>());
    if (forced)
    {
        cells_.fill(force);
    }
    DynamicList<scalar> rows;
    DynamicList<point> around;
    scalar forcedSolution[stokesPolynomials::nCoefficients];
    forAll(perLength_, v)
    {
        const label number = wall_.number(v);
        const vector u(number < 0 ? vector::zero : onWall[number]);
        const vertexFit f(fitAt(v, x.cdata()->cdata(), u));
        rows.setSize(nCubic*(f.cells.size() + 3));
        scalar b[stokesPolynomials::nCoefficients] = {};
        addCells(f, rows.begin(), b);
        around.clear();
        if (f.onWall)
        {
            const labelList& ring = wall_.around(number);
            for (label i = 1; i < ring.size(); ++i)
            {
                around.append(wall_.points()[ring[i]]);
                addPoint(f, around.last(), onWall[ring[i]], b);
            }
        }
        if (forced)
        {
            vector atVertex;
            tensor gradient;
            fitForce(f, rows.cdata(), force.cdata(), atVertex, gradient);
            setForced(1/f.perLength, atVertex, gradient, forcedSolution);
            subtractForced(f, around, rows.cdata(), forcedSolution, b);
        }
        scalar* c = coefficients + stokesPolynomials::nCoefficients*v;
        solve(f, b, c);
        for (label k = 0; forced && k < nCubic; ++k)
        {
            four(c + 4*k) +=
                fourNumbers{1, 1, 1, f.perLength}*four(forcedSolution + 4*k);
        }
        setDefects(f, rows.cdata(), c, place_[v], defects);
        if (wedges_.number(v) >= 0)
        {
            addModes(f, v, rows.cdata(), onWall, c, defects);
        }
    }
}
