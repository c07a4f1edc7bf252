/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "localSolutionStencil.H"
#include "cellMoments.H"
#include "localSolutionGram.H"

namespace Foam
{
namespace fsbi
{

//- Fewest cells of a fit, inside and on walls. The 48 coefficients are found
//  from four numbers a cell. 16 do for a sphere on a good mesh, but a helix takes 289
//  iterations with them, with 24 80; where vertices were moved until faces are 70
//  degrees off the solver stalls even with 20 (validation/poorMeshes), and with 24
//  for a helix on a mesh that grows by 0.7, where 28 take 67. 28 take 5 % more
//  seconds than 16; with 32 the drag of a sphere is half as far off again
static const label fewestInside = 28;
static const label fewestOnWall = 14;

//- How often face neighbours join
static const label mostRings = 3;

//- Reciprocal condition of the normal equations below which they join; usual
//  ones have 1e-5
static const scalar illConditioned = 1e-9;

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::localSolutionStencil::localSolutionStencil
(
    const fvMesh& mesh, const boolList& wall, const labelList& vertices,
    const curvedWall::surface& onSurface
)
:
    mesh_(mesh),
    wall_(mesh, wall, vertices, onSurface),
    cells_(mesh),
    wedges_(mesh, wall_)
{
    checkCells();
    setCells();
    setPlaces();
    update();
}


void Foam::fsbi::localSolutionStencil::checkCells() const
{
    forAll(mesh_.cells(), celli)
    {
        const label n = mesh_.cellPoints()[celli].size();
        if (n != 4 || mesh_.cells()[celli].size() != 4)
        {
            FatalErrorInFunction
                << "Order 4 of the fluid needs tetrahedra, but cell " << celli
                << " at " << mesh_.cellCentres()[celli] << " has " << n
                << " vertices. Give 'order 2' in 'coupling' of"
                << " system/fluid/fvSolution" << exit(FatalError);
        }
    }
}


void Foam::fsbi::localSolutionStencil::setCells()
{
    labelList fewest(mesh_.nPoints());
    forAll(fewest, v)
    {
        fewest[v] = wall_.number(v) < 0 ? fewestInside : fewestOnWall;
    }
    cells_.widen(fewest, mostRings);
}


void Foam::fsbi::localSolutionStencil::setPlaces()
{
    nPlaces_ = 4*mesh_.nCells();
    labelList used(mesh_.nCells(), Zero);
    place_.setSize(mesh_.nPoints());
    forAll(place_, v)
    {
        place_[v].setSize(cells_.nTouching(v));
        forAll(place_[v], i)
        {
            const label celli = cells_[v][i];
            place_[v][i] =
                celli < mesh_.nCells() ? 4*celli + used[celli]++ : nPlaces_++;
        }
    }
}


Foam::label Foam::fsbi::localSolutionStencil::place
(
    const label v, const label globalCell
) const
{
    label i = 0;
    while (!cells_.is(v, i, globalCell))
    {
        ++i;
    }
    return place_[v][i];
}


void Foam::fsbi::localSolutionStencil::setGeometry()
{
    centres_ = mesh_.cellCentres();
    moments_.setSize(mesh_.nCells());
    forAll(moments_, celli)
    {
        moments_[celli] = cellShape(mesh_, celli).moments;
    }
    cells_.fill(centres_);
    cells_.fill(moments_);
    origin_ = mesh_.points();
    forAll(origin_, v)
    {
        if (wall_.number(v) >= 0)
        {
            origin_[v] = wall_.points()[wall_.number(v)];
        }
    }
}


bool Foam::fsbi::localSolutionStencil::factorise(const label v)
{
    const point& x = origin_[v];
    const label onWall = wall_.number(v);
    scalar sum = 0;
    for (const label celli : cells_[v])
    {
        sum += magSqr(centres_[celli] - x);
    }
    const scalar s = 1/Foam::sqrt(sum/cells_[v].size());
    perLength_[v] = s;

    localSolutionGram gram(solutions_);
    scalar a[nCubic];
    for (const label celli : cells_[v])
    {
        const vector d(centres_[celli] - x);
        setMonomialMeans(d, moments_[celli], s, a);
        gram.addCell(a, cellWeight(sqr(s)*magSqr(d)));
    }
    for (label i = 1; onWall >= 0 && i < wall_.around(onWall).size(); ++i)
    {
        const vector d(s*(wall_.points()[wall_.around(onWall)[i]] - x));
        setMonomials(d, a);
        gram.addPoint(a, pointWeight(magSqr(d)));
    }
    const bool sound =
        gram.factorise(onWall >= 0, wedges_.lowDegree(v), illConditioned);
    gram.inverseFactor(factor_.begin() + v*localSolutionGram::factorSize);
    return sound;
}


Foam::fsbi::vertexFit Foam::fsbi::localSolutionStencil::fitAt
(
    const label v, const scalar* values, const vector& u
) const
{
    return vertexFit
    {
        solutions_,
        factor_.cdata() + v*localSolutionGram::factorSize,
        perLength_[v],
        origin_[v],
        wall_.number(v) >= 0,
        fourNumbers{u.x(), u.y(), u.z(), 0},
        cells_[v],
        centres_.cdata(),
        moments_.cdata(),
        values
    };
}


void Foam::fsbi::localSolutionStencil::update()
{
    wall_.update();
    if (joined_)
    {
        // fits are a matter of where the mesh is, not of where it was: a restart,
        // or a step that is given up, has the same
        cells_.reset();
        setCells();
        joined_ = false;
    }
    setGeometry();
    wedges_.findEdges();
    factorise();
    const auto withoutValues = [this](const label v)
    {
        return fitAt(v, nullptr, Zero);
    };
    wedges_.update(cells_, perLength_, withoutValues);
}


void Foam::fsbi::localSolutionStencil::factorise()
{
    perLength_.setSize(mesh_.nPoints());
    factor_.setSize(mesh_.nPoints()*localSolutionGram::factorSize);
    boolList wanted(mesh_.nPoints(), true);
    for (label ring = 0; ring <= mostRings; ++ring)
    {
        bool any = false;
        forAll(wanted, v)
        {
            wanted[v] = wanted[v] && !factorise(v);
            any = any || wanted[v];
        }
        if (!returnReduce(any, orOp<bool>()) || ring == mostRings)
        {
            return;
        }
        cells_.widen(wanted);
        joined_ = true;
        setGeometry();
    }
}
