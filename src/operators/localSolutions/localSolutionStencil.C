/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "localSolutionStencil.H"
#include "fourNumbers.H"
#include "localSolutionGram.H"

namespace Foam
{
namespace fsbi
{

//- Fewest cells of a fit, inside and on walls. The 48 coefficients are found
//  from four numbers a cell
static const label fewestInside = 16;
static const label fewestOnWall = 14;

//- How often face neighbours join
static const label mostRings = 3;

//- Reciprocal condition of the normal equations below which they join; usual
//  ones have 1e-5
static const scalar illConditioned = 1e-9;

//- Points of the wall do not count more than at this distance over h, squared
static const scalar nearest = 0.04;

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::localSolutionStencil::localSolutionStencil
(
    const fvMesh& mesh, const boolList& wall, const labelList& vertices
)
:
    mesh_(mesh),
    wall_(mesh, wall, vertices)
{
    setCells();
    update();
}


void Foam::fsbi::localSolutionStencil::setCells()
{
    cellVertex_.setSize(4*mesh_.nCells());
    List<DynamicList<label>> places(mesh_.nPoints());
    forAll(mesh_.cells(), celli)
    {
        const labelList& vertices = mesh_.cellPoints()[celli];
        if (vertices.size() != 4 || mesh_.cells()[celli].size() != 4)
        {
            FatalErrorInFunction
                << "Order 4 of the fluid needs tetrahedra, but cell " << celli
                << " at " << mesh_.cellCentres()[celli] << " has "
                << vertices.size() << " vertices. Give 'order 2' in 'coupling'"
                << " of system/fluid/fvSolution" << exit(FatalError);
        }
        forAll(vertices, k)
        {
            cellVertex_[4*celli + k] = vertices[k];
            places[vertices[k]].append(4*celli + k);
        }
    }
    place_.setSize(mesh_.nPoints());
    forAll(places, v)
    {
        place_[v].transfer(places[v]);
    }
}


Foam::labelList Foam::fsbi::localSolutionStencil::widened
(
    const UList<label>& cells
) const
{
    DynamicList<label> result(cells);
    for (const label celli : cells)
    {
        for (const label other : mesh_.cellCells()[celli])
        {
            if (!result.found(other))
            {
                result.append(other);
            }
        }
    }
    return labelList(result);
}


Foam::scalar Foam::fsbi::localSolutionStencil::distance
(
    const point& x, const UList<label>& cells
) const
{
    scalar sum = 0;
    for (const label celli : cells)
    {
        sum += magSqr(mesh_.cellCentres()[celli] - x);
    }
    return Foam::sqrt(sum/cells.size());
}


Foam::labelList Foam::fsbi::localSolutionStencil::fitted(const label v)
{
    const point& x = mesh_.points()[v];
    const label onWall = wall_.number(v);
    labelList cells(place_[v]);
    for (label& celli : cells)
    {
        celli /= 4;
    }
    for (label ring = 0; ; ++ring)
    {
        const bool last = ring == mostRings;
        if
        (
            !last
         && cells.size() < (onWall < 0 ? fewestInside : fewestOnWall)
        )
        {
            cells = widened(cells);
            continue;
        }
        const scalar h = distance(x, cells);
        perLength_[v] = 1/h;
        localSolutionGram gram(solutions_);
        scalar a[nCubic];
        for (const label celli : cells)
        {
            const vector d(mesh_.cellCentres()[celli] - x);
            setMonomialMeans(d, moments_[celli], 1/h, a);
            gram.addCell(a, sqr(sqr(h)/magSqr(d)));
        }
        for (label i = 1; onWall >= 0 && i < wall_.around(onWall).size(); ++i)
        {
            const label pointi = wall_.around(onWall)[i];
            const vector d((wall_.points()[pointi] - x)/h);
            setMonomials(d, a);
            gram.addPoint(a, 1/sqr(max(magSqr(d), nearest)));
        }
        if (gram.factorise(onWall >= 0, illConditioned) || last)
        {
            gram.inverseFactor(factor_.begin() + v*factorSize);
            return cells;
        }
        cells = widened(cells);
    }
}


void Foam::fsbi::localSolutionStencil::update()
{
    const pointField& x = mesh_.points();
    wall_.update();
    moments_.setSize(mesh_.nCells());
    forAll(moments_, celli)
    {
        FixedList<point, 4> corners;
        forAll(corners, k)
        {
            corners[k] = x[cellVertex_[4*celli + k]];
        }
        moments_[celli] =
            simplexMoments(corners, mesh_.cellCentres()[celli]);
    }
    perLength_.setSize(x.size());
    factor_.setSize(x.size()*factorSize);
    start_.setSize(x.size() + 1);
    start_[0] = 0;
    cell_.clear();
    forAll(x, v)
    {
        cell_.append(fitted(v));
        start_[v + 1] = cell_.size();
    }
}


void Foam::fsbi::localSolutionStencil::fit
(
    const scalar* x, const vectorField& onWall,
    scalar* coefficients, scalar* defects
) const
{
    DynamicList<scalar> rows;
    forAll(perLength_, v)
    {
        const point& origin = mesh_.points()[v];
        const scalar s = perLength_[v];
        const label number = wall_.number(v);
        const label nCells = start_[v + 1] - start_[v];
        const label* cells = cell_.cdata() + start_[v];
        rows.setSize(nCubic*nCells);

        fourNumbers uniform = {0, 0, 0, 0};
        if (number >= 0)
        {
            const vector& g = onWall[number];
            uniform = fourNumbers{g.x(), g.y(), g.z(), 0};
        }
        const fourNumbers scaled = {1, 1, 1, 1/s};

        scalar b[stokesPolynomials::nCoefficients] = {};
        const auto add =
            [&b](const scalar* a, const scalar weight, const fourNumbers value)
        {
            const fourNumbers weighted = weight*value;
            for (label k = 0; k < nCubic; ++k)
            {
                four(b + 4*k) += a[k]*weighted;
            }
        };
        for (label i = 0; i < nCells; ++i)
        {
            const vector d(mesh_.cellCentres()[cells[i]] - origin);
            scalar* a = rows.begin() + nCubic*i;
            setMonomialMeans(d, moments_[cells[i]], s, a);
            add
            (
                a, 1/sqr(sqr(s)*magSqr(d)),
                (four(x + 4*cells[i]) - uniform)*scaled
            );
        }
        if (number >= 0)
        {
            const SubList<label> around(wall_.around(number));
            for (label i = 1; i < around.size(); ++i)
            {
                const vector d(s*(wall_.points()[around[i]] - origin));
                const vector& g = onWall[around[i]];
                scalar a[nCubic];
                setMonomials(d, a);
                add
                (
                    a, 1/sqr(max(magSqr(d), nearest)),
                    fourNumbers{g.x(), g.y(), g.z(), 0} - uniform
                );
            }
        }
        scalar y[stokesPolynomials::nSolutions];
        solutions_.project(b, y);
        if (number >= 0)
        {
            std::fill_n(y, 3, scalar(0));
        }
        applyInverse(factor_.cdata() + v*factorSize, y);
        scalar* c = coefficients + stokesPolynomials::nCoefficients*v;
        solutions_.expand(y, c);
        four(c) += uniform;
        for (label k = 0; k < nQuadratic; ++k)
        {
            c[4*k + 3] *= s;
        }
        forAll(place_[v], i)
        {
            const scalar* a = rows.cdata() + nCubic*i;
            fourNumbers defect = four(x + 4*cells[i]);
            for (label k = 0; k < nCubic; ++k)
            {
                defect -= a[k]*four(c + 4*k);
            }
            four(defects + 4*place_[v][i]) = defect;
        }
    }
}
