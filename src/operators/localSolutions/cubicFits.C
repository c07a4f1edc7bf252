/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cubicFits.H"
#include "cellMoments.H"
#include <Eigen/Dense>

namespace Foam
{
namespace fsbi
{

//- Fewest cells of a fit, inside and at the boundary
static const label fewestInside = 40;
static const label fewestAtBoundary = 36;

//- How often face neighbours join
static const label mostRings = 4;

//- Smallest over largest pivot of the rows, below which more values join; usual
//  ones have 1e-3
static const scalar illConditioned = 1e-5;

//- Largest sum of a coefficient's weights, above which more values join, if there
//  are any: what a fit makes of noise. Next to edges usual ones have 130; where
//  three hexahedra across are all there are, 440, with all faces 55
static const scalar mostAmplified = 200;


//- sum_i W_i value_i
fsbiWide static void addValues
(
    const label n, const label* items, const scalar* values,
    const scalar* weights, scalar* c
)
{
    for (label i = 0; i < n; ++i)
    {
        const fourNumbers value = four(values + 4*items[i]);
        for (label k = 0; k < nCubic; ++k)
        {
            four(c + 4*k) += weights[nCubic*i + k]*value;
        }
    }
}


//- What a value has beyond that of the fit whose row is a
fsbiWide static void setDefect
(
    const scalar* a, const scalar* c, const scalar* value, scalar* defect
)
{
    fourNumbers sum = {0, 0, 0, 0};
    addProducts<nCubic>(a, c, sum);
    four(defect) = four(value) - sum;
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::cubicFits::cubicFits
(
    const fvMesh& mesh, const labelList& boundary
)
:
    mesh_(mesh),
    boundary_(boundary),
    cells_(mesh),
    faces_(mesh, boundary)
{
    setColumns();
    update();
}


void Foam::fsbi::cubicFits::setColumns()
{
    labelList fewest(mesh_.nPoints());
    placeStart_.setSize(mesh_.nPoints() + 1);
    placeStart_[0] = 0;
    forAll(fewest, v)
    {
        fewest[v] = faces_[v].size() ? fewestAtBoundary : fewestInside;
        placeStart_[v + 1] =
            placeStart_[v] + cells_.nTouching(v) + faces_.nTouching(v);
    }
    cells_.widen(fewest, mostRings);
}


void Foam::fsbi::cubicFits::setGeometry()
{
    centres_.setSize(mesh_.nCells());
    moments_.setSize(mesh_.nCells());
    forAll(moments_, celli)
    {
        const cellShape shape(mesh_, celli);
        centres_[celli] = shape.centre;
        moments_[celli] = shape.moments;
    }
    faceCentres_ = pointField(mesh_.faceCentres(), boundary_);
    cells_.fill(centres_);
    cells_.fill(moments_);
    faces_.fill(faceCentres_);
}


void Foam::fsbi::cubicFits::setRows
(
    const label v, scalarList& rows, scalarList& weights
) const
{
    const point& x = mesh_.points()[v];
    const scalar s = perLength_[v];
    const label nCells = cells_[v].size();
    weights.setSize(nCells + faces_[v].size());
    rows.setSize(nCubic*weights.size());
    forAll(cells_[v], i)
    {
        const label celli = cells_[v][i];
        const vector d(centres_[celli] - x);
        setMonomialMeans(d, moments_[celli], s, rows.begin() + nCubic*i);
        weights[i] = 1/(sqr(s)*magSqr(d));
    }
    forAll(faces_[v], i)
    {
        const vector d(s*(faceCentres_[faces_[v][i]] - x));
        setMonomials(d, rows.begin() + nCubic*(nCells + i));
        weights[nCells + i] = 1/mag(d);
    }
}


bool Foam::fsbi::cubicFits::setWeights(const label v, const bool strictly)
{
    scalar sum = 0;
    for (const label celli : cells_[v])
    {
        sum += magSqr(centres_[celli] - mesh_.points()[v]);
    }
    perLength_[v] = 1/Foam::sqrt(sum/cells_[v].size());

    scalarList rows, weights;
    setRows(v, rows, weights);
    const label n = weights.size();
    typedef Eigen::Matrix<scalar, Eigen::Dynamic, Eigen::Dynamic> matrix;
    const Eigen::Map<const Eigen::VectorXd> w(weights.cdata(), n);
    const matrix A
    (
        w.asDiagonal()
       *Eigen::Map<const matrix>(rows.cdata(), nCubic, n).transpose()
    );
    const Eigen::ColPivHouseholderQR<matrix> factor(A);
    const auto pivots = factor.matrixR().diagonal().head(min(n, nCubic));
    const bool sound =
        n >= nCubic
     && mag(pivots.tail(1)[0]) > illConditioned*mag(pivots[0]);
    if (!sound)
    {
        return false;
    }
    weights_[v].setSize(nCubic*n);
    Eigen::Map<matrix> W(weights_[v].begin(), nCubic, n);
    W = factor.solve(matrix(w.asDiagonal()));
    return
        !strictly
     || W.cwiseAbs().rowwise().sum().maxCoeff() < mostAmplified;
}


void Foam::fsbi::cubicFits::setWeights()
{
    perLength_.setSize(mesh_.nPoints());
    weights_.setSize(mesh_.nPoints());
    boolList wanted(mesh_.nPoints(), true);
    for (label ring = 0; ring <= mostRings; ++ring)
    {
        label worst = -1;
        forAll(wanted, v)
        {
            wanted[v] = wanted[v] && !setWeights(v, ring == 0);
            worst = wanted[v] ? v : worst;
        }
        if (!returnReduce(worst >= 0, orOp<bool>()))
        {
            return;
        }
        if (ring == mostRings && worst >= 0)
        {
            FatalErrorInFunction
                << "Around the point " << mesh_.points()[worst] << " of region "
                << mesh_.name() << " there are too few cells in a row for"
                << " order 4. Refine the mesh there, or give 'order 2' in"
                << " 'solid' of system/" << mesh_.name() << "/fvSolution"
                << exit(FatalError);
        }
        if (ring > 0)
        {
            cells_.widen(wanted);
        }
        faces_.widen(wanted, cells_);
        setGeometry();
    }
}


void Foam::fsbi::cubicFits::update()
{
    setGeometry();
    setWeights();
}


Foam::label Foam::fsbi::cubicFits::cellPlace
(
    const label v, const label globalCell
) const
{
    label i = 0;
    while (!cells_.is(v, i, globalCell))
    {
        ++i;
    }
    return placeStart_[v] + i;
}


Foam::label Foam::fsbi::cubicFits::facePlace
(
    const label v, const label own
) const
{
    label i = 0;
    while (!faces_.is(v, i, faces_.toGlobal(own)))
    {
        ++i;
    }
    return placeStart_[v] + cells_.nTouching(v) + i;
}


void Foam::fsbi::cubicFits::fit
(
    List<FixedList<scalar, 4>>& onCells,
    List<FixedList<scalar, 4>>& onFaces,
    scalar* coefficients,
    scalar* defects
) const
{
    cells_.fill(onCells);
    faces_.fill(onFaces);
    const scalar* cellValues = onCells.cdata()->cdata();
    const scalar* faceValues = onFaces.cdata()->cdata();
    std::fill_n(coefficients, nCoefficients*mesh_.nPoints(), scalar(0));
    forAll(weights_, v)
    {
        const labelList& cells = cells_[v];
        const labelList& faces = faces_[v];
        const scalar* W = weights_[v].cdata();
        scalar* c = coefficients + nCoefficients*v;
        addValues(cells.size(), cells.cdata(), cellValues, W, c);
        addValues
        (
            faces.size(), faces.cdata(), faceValues, W + nCubic*cells.size(), c
        );

        const point& x = mesh_.points()[v];
        const scalar s = perLength_[v];
        scalar* defect = defects + 4*placeStart_[v];
        scalar a[nCubic];
        for (label i = 0; i < cells_.nTouching(v); ++i, defect += 4)
        {
            const label celli = cells[i];
            setMonomialMeans(centres_[celli] - x, moments_[celli], s, a);
            setDefect(a, c, cellValues + 4*celli, defect);
        }
        for (label i = 0; i < faces_.nTouching(v); ++i, defect += 4)
        {
            setMonomials(s*(faceCentres_[faces[i]] - x), a);
            setDefect(a, c, faceValues + 4*faces[i], defect);
        }
    }
}
