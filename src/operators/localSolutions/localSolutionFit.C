/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "localSolutionStencil.H"
#include "localSolutionGram.H"

namespace Foam
{
namespace fsbi
{

//- What the fit at a vertex is made of; lengths in h
struct vertexFit
{
    const stokesPolynomials& solutions;

    //- Rows of L^-1
    const scalar* factor;

    //- 1/h, and the vertex
    scalar perLength;
    point origin;

    //- Is the velocity known here, and what is it? Otherwise zero
    bool onWall;
    fourNumbers uniform;

    const labelList& cells;
    const vector* centres;
    const centralMoments* moments;

    //- [u v w p/mu]
    const scalar* values;
};


//- The rows of the cells, four of them side by side: monomial k of cell i of
//  four is rows[80*(i/4) + 4*k + i % 4]; and the products with the cells' means
//  added to b. Behind the last cell it stands again with no weight
fsbiWide static void addCells(const vertexFit& f, scalar* rows, scalar* b)
{
    const label n = f.cells.size();
    const scalar s = f.perLength;
    const fourNumbers scale = {1, 1, 1, 1/s};
    for (label i = 0; i < n; i += 4, rows += 4*nCubic)
    {
        label cells[4];
        fourNumbers x, y, z, weight, m[nCubic - 4], a[nCubic], u[4];
        for (label j = 0; j < 4; ++j)
        {
            cells[j] = f.cells[min(i + j, n - 1)];
            const vector d(f.centres[cells[j]] - f.origin);
            x[j] = s*d.x();
            y[j] = s*d.y();
            z[j] = s*d.z();
            for (label k = 0; k < nCubic - 4; ++k)
            {
                m[k][j] = f.moments[cells[j]][k];
            }
        }
        for (label k = 0; k < nCubic - 4; ++k)
        {
            m[k] *= k < 6 ? s*s : s*s*s;
        }
        setMonomialMeans<fourNumbers>(x, y, z, m, a);
        for (label j = 0; j < 4; ++j)
        {
            const scalar d2 = x[j]*x[j] + y[j]*y[j] + z[j]*z[j];
            weight[j] = i + j < n ? cellWeight(d2) : 0;
            u[j] = weight[j]*scale*(four(f.values + 4*cells[j]) - f.uniform);
        }
        for (label k = 0; k < nCubic; ++k)
        {
            four(rows + 4*k) = a[k];
            four(b + 4*k) +=
                (a[k][0]*u[0] + a[k][1]*u[1]) + (a[k][2]*u[2] + a[k][3]*u[3]);
        }
    }
}


//- The row of a point of the wall with velocity u, times that, added to b
fsbiWide static void addPoint
(
    const vertexFit& f, const point& x, const vector& u, scalar* b
)
{
    scalar a[nCubic];
    const vector d(f.perLength*(x - f.origin));
    setMonomials(d, a);
    const fourNumbers value = {u.x(), u.y(), u.z(), 0};
    const fourNumbers weighted = pointWeight(magSqr(d))*(value - f.uniform);
    for (label k = 0; k < nCubic; ++k)
    {
        four(b + 4*k) += a[k]*weighted;
    }
}


//- y = L^-T L^-1 y
fsbiInlined static void applyInverse(const scalar* row, scalar* y)
{
    constexpr label n = stokesPolynomials::nSolutions;
    scalar z[n] = {};
    for (label i = 0; i < n; ++i)
    {
        const label end = 4*(i/4 + 1);
        fourNumbers sums = {0, 0, 0, 0};
        for (label j = 0; j < end; j += 4)
        {
            sums += four(row + j)*four(y + j);
        }
        const scalar sum = (sums[0] + sums[1]) + (sums[2] + sums[3]);
        for (label j = 0; j < end; j += 4)
        {
            four(z + j) += sum*four(row + j);
        }
        row += end;
    }
    std::copy_n(z, n, y);
}


//- Coefficients c of the best fit
fsbiWide static void solve(const vertexFit& f, const scalar* b, scalar* c)
{
    scalar y[stokesPolynomials::nSolutions];
    f.solutions.project(b, y);
    if (f.onWall)
    {
        std::fill_n(y, 3, scalar(0));
    }
    applyInverse(f.factor, y);
    f.solutions.expand(y, c);
    four(c) += f.uniform;
    for (label k = 0; k < nQuadratic; ++k)
    {
        c[4*k + 3] *= f.perLength;
    }
}


//- The row of a cell among those of four side by side
fsbiInlined static void copyRow(const scalar* rows, const label i, scalar* a)
{
    for (label k = 0; k < nCubic; ++k)
    {
        a[k] = rows[4*nCubic*(i/4) + 4*k + i % 4];
    }
}


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


//- What the first cells' means have beyond those of the fit
fsbiWide static void setDefects
(
    const vertexFit& f,
    const scalar* rows,
    const scalar* c,
    const UList<label>& places,
    scalar* defects
)
{
    const label n = places.size();
    for (label i = 0; i < n; i += 4, rows += 4*nCubic)
    {
        fourNumbers sum[4] = {};
        for (label k = 0; k < nCubic; ++k)
        {
            const fourNumbers& ck = four(c + 4*k);
            for (label j = 0; j < 4; ++j)
            {
                sum[j] += rows[4*k + j]*ck;
            }
        }
        for (label j = 0; j < min(label(4), n - i); ++j)
        {
            four(defects + 4*places[i + j]) =
                four(f.values + 4*f.cells[i + j]) - sum[j];
        }
    }
}

} // End namespace fsbi
} // End namespace Foam


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
        vertexFit f
        {
            solutions_,
            factor_.cdata() + v*localSolutionGram::factorSize,
            perLength_[v],
            origin_[v],
            number >= 0,
            {u.x(), u.y(), u.z(), 0},
            cells_[v],
            centres_.cdata(),
            moments_.cdata(),
            x.cdata()->cdata()
        };
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
    }
}
