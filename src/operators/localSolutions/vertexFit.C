/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "vertexFit.H"
#include "localSolutionGram.H"

namespace Foam
{
namespace fsbi
{

fsbiWide void addCells(const vertexFit& f, scalar* rows, scalar* b)
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


fsbiWide void addPoint
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


fsbiWide void solve(const vertexFit& f, const scalar* b, scalar* c)
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


fsbiWide void setDefects
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
