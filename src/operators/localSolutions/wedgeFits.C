/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wedgeFits.H"
#include "noTurn.H"
#include "simplexRules.H"
#include "syncTools.H"

namespace Foam
{
namespace fsbi
{

static constexpr label nModes = wedgeModes::n;
static constexpr label nCoefficients = stokesPolynomials::nCoefficients;

struct nearestWedge
{
    void operator()(wedge& a, const wedge& b) const
    {
        if (b.nearer(a))
        {
            a = b;
        }
    }
};

} // End namespace fsbi
} // End namespace Foam


void Foam::fsbi::wedgeFits::findEdges()
{
    wedges_.clear();
    const sharpEdges& sharp = wall_.sharp();
    const bool any = sharp.vertices().size() || sharp.corners().size();
    if (!returnReduce(any, orOp<bool>()))
    {
        return;
    }
    const pointField& x = mesh_.points();
    wedges_.setSize(mesh_.nPoints());
    for (const labelList& vertices : mesh_.cellPoints())
    {
        for (const label e : vertices)
        {
            const auto found = sharp.vertices().cfind(e);
            for (label k = 0; found.found() && k < vertices.size(); ++k)
            {
                const label v = vertices[k];
                nearestWedge()
                (
                    wedges_[v], wedge(x[e], found.val(), x[v])
                );
            }
        }
    }
    syncTools::syncPointList(mesh_, wedges_, nearestWedge(), wedge(), noTurn());
    for (const label v : sharp.corners())
    {
        wedges_[v] = wedge();
    }
}


void Foam::fsbi::wedgeFits::setCells(const vertexCells& cells)
{
    const sharpEdges& sharp = wall_.sharp();
    List<FixedList<point, 4>> corners(mesh_.nCells());
    labelList bits(mesh_.nCells(), Zero);
    forAll(corners, celli)
    {
        for (label k = 0; k < 4; ++k)
        {
            const label v = mesh_.cellPoints()[celli][k];
            corners[celli][k] = mesh_.points()[v];
            bits[celli] |= label(sharp.found(v)) << k;
        }
    }
    cells.fill(corners);
    cells.fill(bits);
    cells_.setSize(corners.size());
    forAll(cells_, celli)
    {
        cells_[celli].corners = corners[celli];
        for (label k = 0; k < 4; ++k)
        {
            cells_[celli].onEdge[k] = bits[celli] >> k & 1;
        }
    }
}


void Foam::fsbi::wedgeFits::addVertex
(
    const label v, const vertexFit& f, const label nTouching
)
{
    DynamicList<point> ring, onFacets;
    const label onWall = wall_.number(v);
    for (label j = 1; onWall >= 0 && j < wall_.around(onWall).size(); ++j)
    {
        const label pointi = wall_.around(onWall)[j];
        ring.append(wall_.points()[pointi]);
        onFacets.append(wall_.onFacets()[pointi]);
    }
    modeFit fitted(f, wedges_[v], modes(v), ring, onFacets, cells_);
    const Eigen::MatrixXd weights(fitted.toAmplitudes());
    weightStart_.append(weights_.size());
    reducedStart_.append(reduced_.size());
    for (label k = 0; k < nModes; ++k)
    {
        for (label i = 0; i < weights.rows(); ++i)
        {
            weights_.append(weights(i, k));
        }
        for (label i = 0; i < 4*nTouching; ++i)
        {
            reduced_.append(fitted.rest()(i, k));
        }
    }
    fitted_.append(fitted.coefficients());
}


void Foam::fsbi::wedgeFits::addFace
(
    const label facei, const label v, const scalar perLength
)
{
    const face& f = mesh_.faces()[facei];
    const vector& S = mesh_.faceAreas()[facei];
    FixedList<point, 3> corners;
    FixedList<bool, 3> onEdge;
    forAll(corners, i)
    {
        corners[i] = mesh_.points()[f[i]];
        onEdge[i] = wall_.sharp().found(f[i]);
    }
    FixedList<modeOnFace, nModes> sums{};
    const weightedPoints rule(triangleRule(corners, onEdge));
    forAll(rule.x, q)
    {
        const auto flows(wedges_[v].flowsAt(rule.x[q], modes(v), perLength));
        const vector arm(rule.x[q] - mesh_.faceCentres()[facei]);
        const scalar w = rule.weights[q]/3;
        forAll(flows, k)
        {
            const auto& flow = flows[k];
            const vector t(S & flow.gradient);
            sums[k].mean +=
                w*fourNumbers{flow.u.x(), flow.u.y(), flow.u.z(), flow.p};
            sums[k].slope += w*fourNumbers{t.x(), t.y(), t.z(), 0};
            sums[k].moment +=
                w*arm*(t + (flow.gradient & S) - flow.p*S);
        }
    }
    forAll(sums, k)
    {
        sums[k].mode = nModes*number_[v] + k;
        sums[k].transposed = Zero;
        onFaces_.append(sums[k]);
    }
}


void Foam::fsbi::wedgeFits::addLoop
(
    const label facei, const label v, const scalar perLength
)
{
    const face& f = mesh_.faces()[facei];
    const pointField& x = mesh_.points();
    const label i = f.find(v);
    const point &next = x[f.nextLabel(i)], &last = x[f.prevLabel(i)];
    const auto flows = [&](const point& at)
    {
        return wedges_[v].flowsAt(at, modes(v), perLength);
    };
    const auto here(flows(x[v]));
    const auto ahead(flows(0.5*(x[v] + next)));
    const auto behind(flows(0.5*(x[v] + last)));
    const label first = onFaces_.size() - nModes;
    forAll(here, k)
    {
        onFaces_[first + k].transposed =
            (
                ((next - x[v]) ^ (here[k].u + 2*ahead[k].u))
              + ((x[v] - last) ^ (here[k].u + 2*behind[k].u))
            )/6;
    }
}


void Foam::fsbi::wedgeFits::setFaces(const scalarList& perLength)
{
    faceStart_.setSize(mesh_.nFaces() + 1);
    onFaces_.clear();
    forAll(mesh_.faces(), facei)
    {
        faceStart_[facei] = onFaces_.size();
        for (const label v : mesh_.faces()[facei])
        {
            if (number_[v] >= 0)
            {
                addFace(facei, v, perLength[v]);
                if (facei >= mesh_.nInternalFaces())
                {
                    addLoop(facei, v, perLength[v]);
                }
            }
        }
    }
    faceStart_.last() = onFaces_.size();
}


const Foam::fsbi::wedgeModes& Foam::fsbi::wedgeFits::modes(const label v) const
{
    const label angle = wedges_[v].angle();
    if (!modes_.found(angle))
    {
        modes_.set(angle, new wedgeModes(1e-6*angle));
    }
    return *modes_[angle];
}


void Foam::fsbi::wedgeFits::update
(
    const vertexCells& cells,
    const scalarList& perLength,
    const std::function<vertexFit(const label v)>& fitAt
)
{
    number_.clear();
    faceStart_.clear();
    weights_.clear();
    weightStart_.clear();
    reduced_.clear();
    reducedStart_.clear();
    fitted_.clear();
    modes_.clear();
    // the same on all processors
    if (wedges_.empty())
    {
        return;
    }
    setCells(cells);
    number_.setSize(mesh_.nPoints(), -1);
    label n = 0;
    forAll(wedges_, v)
    {
        if (wedges_[v].exists())
        {
            number_[v] = n++;
            addVertex(v, fitAt(v), cells.nTouching(v));
        }
    }
    amplitudes_.setSize(nModes*n);
    setFaces(perLength);
}


void Foam::fsbi::wedgeFits::add
(
    const label number,
    const UList<scalar>& residuals,
    const UList<label>& places,
    scalar* c,
    scalar* defects
) const
{
    const scalar* weights = weights_.cdata() + weightStart_[number];
    const scalar* fitted = fitted_.cdata() + number*nModes*nCoefficients;
    const scalar* reduced = reduced_.cdata() + reducedStart_[number];
    for (label k = 0; k < nModes; ++k)
    {
        scalar amplitude = 0;
        for (const scalar r : residuals)
        {
            amplitude += *weights++*r;
        }
        amplitudes_[nModes*number + k] = amplitude;
        for (label i = 0; i < nCoefficients; ++i)
        {
            c[i] -= amplitude**fitted++;
        }
        for (const label place : places)
        {
            four(defects + 4*place) -= amplitude*four(reduced);
            reduced += 4;
        }
    }
}


Foam::tensor Foam::fsbi::wedgeFits::gradient
(
    const label v, const scalar perLength, const point& x
) const
{
    tensor sum(Zero);
    if (number(v) >= 0)
    {
        const auto flows(wedges_[v].flowsAt(x, modes(v), perLength));
        forAll(flows, k)
        {
            sum += amplitudes_[nModes*number(v) + k]*flows[k].gradient;
        }
    }
    return sum;
}
