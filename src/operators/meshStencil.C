/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshStencil.H"
#include "globalIndex.H"
#include "noTurn.H"
#include "syncTools.H"
#include "tensor.H"

namespace Foam
{
namespace fsbi
{

//- Moment of a face that counts as plane, over its area^1.5
static const scalar planeBelow = 1e-9;

//- How far outside the cloud of its cells, in its own standard deviations
//  squared, a vertex may lie before more cells are asked for, and before the
//  plane is given up for the mean
static const scalar extendAbove = 10;
static const scalar averageAbove = 100;

//- Global numbers of cells and of the point that takes them, -1: around the
//  vertex anyway
typedef List<labelPair> claimList;

//- The vertex that claims a cell, by the cell's number; null: none
static label* claimOf(UList<labelPair>& claims, const label number)
{
    for (labelPair& claim : claims)
    {
        if (claim.first() == number)
        {
            return &claim.second();
        }
    }
    return nullptr;
}

struct lowestClaim
{
    void operator()(claimList& a, const claimList& b) const
    {
        for (const labelPair& claim : b)
        {
            label* own = claimOf(a, claim.first());
            if (own)
            {
                *own = min(*own, claim.second());
            }
            else
            {
                a.append(claim);
            }
        }
    }
};

//- Moments of the cells around a vertex, relative to the vertex
struct meshStencil::moments
{
    scalar weight = 0;
    vector mean = Zero;
    symmTensor covariance = Zero;

    //- Regularised: cells may be coplanar
    symmTensor inverseCovariance = Zero;

    //- covariance^-1 mean; refined, since a regularised inverse is not exact
    vector slope() const
    {
        vector s(Zero);
        for (label i = 0; i < 3; ++i)
        {
            s += inverseCovariance & (mean - (covariance & s));
        }
        return s;
    }

    //- Squared distance from the vertex to the cloud, in its own metric
    scalar outside() const
    {
        return mean & (inverseCovariance & mean);
    }
};

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::meshStencil::meshStencil(const fvMesh& mesh)
:
    mesh_(mesh),
    halo_(mesh)
{
    update();
}


void Foam::fsbi::meshStencil::update()
{
    setFaces();
    setWarp();
    setVertices();
    setCells();
    setWalls();
}


void Foam::fsbi::meshStencil::setFaces()
{
    const label nInternal = mesh_.nInternalFaces();
    const label n = nInternal + halo_.size();
    const vectorField& C = mesh_.cellCentres();
    const vectorField& Cf = mesh_.faceCentres();
    const vectorField& Sf = mesh_.faceAreas();

    owner_.setSize(n);
    neighbour_.setSize(n);
    area_.setSize(n);
    fromOwner_.setSize(n);
    fromNeighbour_.setSize(n);

    for (label facei = 0; facei < nInternal; ++facei)
    {
        owner_[facei] = mesh_.faceOwner()[facei];
        neighbour_[facei] = mesh_.faceNeighbour()[facei];
        area_[facei] = Sf[facei];
        fromOwner_[facei] = Cf[facei] - C[owner_[facei]];
        fromNeighbour_[facei] = Cf[facei] - C[neighbour_[facei]];
    }

    label i = nInternal;
    for (const label patchi : halo_.patches())
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        const vectorField delta(patch.delta());
        forAll(patch, patchFacei)
        {
            const label facei = patch.start() + patchFacei;
            owner_[i] = patch.faceCells()[patchFacei];
            neighbour_[i] = mesh_.nCells() + i - nInternal;
            area_[i] = Sf[facei];
            fromOwner_[i] = Cf[facei] - C[owner_[i]];
            fromNeighbour_[i] = fromOwner_[i] - delta[patchFacei];
            ++i;
        }
    }
}


void Foam::fsbi::meshStencil::setWarp()
{
    const pointField& x = mesh_.points();
    DynamicList<label> faces;
    DynamicList<tensor> moments;
    const auto add = [&](const label i, const label facei)
    {
        const face& f = mesh_.faces()[facei];
        const point& Cf = mesh_.faceCentres()[facei];
        if (f.size() == 3)
        {
            return;
        }
        // triangles as in OpenFOAM's face areas
        point middle(Zero);
        for (const label v : f)
        {
            middle += x[v]/f.size();
        }
        tensor moment(Zero);
        forAll(f, k)
        {
            const point& a = x[f[k]];
            const point& b = x[f.nextLabel(k)];
            moment +=
                ((a + b + middle)/3 - Cf)*(0.5*((b - a) ^ (middle - a)));
        }
        if (mag(moment) > planeBelow*pow(mag(area_[i]), 1.5))
        {
            faces.append(i);
            moments.append(moment);
        }
    };

    label i = 0;
    for (; i < mesh_.nInternalFaces(); ++i)
    {
        add(i, i);
    }
    for (const label patchi : halo_.patches())
    {
        const polyPatch& pp = mesh_.boundaryMesh()[patchi];
        forAll(pp, k)
        {
            add(i++, pp.start() + k);
        }
    }
    warpedFaces_.transfer(faces);
    warp_.transfer(moments);
}


Foam::labelList Foam::fsbi::meshStencil::meshFaces() const
{
    labelList faces(owner_.size());
    label i = 0;
    for (; i < mesh_.nInternalFaces(); ++i)
    {
        faces[i] = i;
    }
    for (const label patchi : halo_.patches())
    {
        const polyPatch& pp = mesh_.boundaryMesh()[patchi];
        forAll(pp, k)
        {
            faces[i++] = pp.start() + k;
        }
    }
    return faces;
}


Foam::vectorField Foam::fsbi::meshStencil::centres() const
{
    vectorField result(mesh_.nCells() + halo_.size());
    std::copy(mesh_.cellCentres().begin(), mesh_.cellCentres().end(), result.begin());
    for (label i = mesh_.nInternalFaces(); i < owner_.size(); ++i)
    {
        result[neighbour_[i]] =
            result[owner_[i]] + fromOwner_[i] - fromNeighbour_[i];
    }
    return result;
}


Foam::List<Foam::fsbi::meshStencil::moments>
Foam::fsbi::meshStencil::vertexMoments
(
    const List<DynamicList<label>>& cells
) const
{
    const pointField& x = mesh_.points();
    const vectorField C(centres());

    scalarField weight(x.size(), Zero);
    vectorField first(x.size(), Zero);
    symmTensorField second(x.size(), Zero);
    forAll(x, v)
    {
        for (const label celli : cells[v])
        {
            const vector d(C[celli] - x[v]);
            const scalar w = 1/magSqr(d);
            weight[v] += w;
            first[v] += w*d;
            second[v] += w*sqr(d);
        }
    }
    syncTools::syncPointList(mesh_, weight, plusEqOp<scalar>(), scalar(0));
    syncTools::syncPointList(mesh_, first, plusEqOp<vector>(), vector::zero);
    syncTools::syncPointList
    (
        mesh_, second, plusEqOp<symmTensor>(), symmTensor::zero
    );

    List<moments> result(x.size());
    forAll(x, v)
    {
        moments& m = result[v];
        m.weight = weight[v];
        m.mean = first[v]/weight[v];
        m.covariance = second[v]/weight[v] - sqr(m.mean);
        const scalar size = magSqr(m.mean) + tr(m.covariance);
        m.inverseCovariance = inv(m.covariance + 1e-8*size*symmTensor::I);
    }
    return result;
}


Foam::List<Foam::DynamicList<Foam::label>>
Foam::fsbi::meshStencil::cellsBeside(const boolList& wanted) const
{
    List<DynamicList<label>> beside(mesh_.nCells());
    forAll(owner_, i)
    {
        if (wanted[owner_[i]])
        {
            beside[owner_[i]].append(neighbour_[i]);
        }
        if (neighbour_[i] < mesh_.nCells() && wanted[neighbour_[i]])
        {
            beside[neighbour_[i]].append(owner_[i]);
        }
    }
    return beside;
}


void Foam::fsbi::meshStencil::extend
(
    const List<moments>& m,
    List<DynamicList<label>>& cells
) const
{
    const pointField& x = mesh_.points();
    const vectorField C(centres());
    const globalIndex globalCell(mesh_.nCells());
    const globalIndex globalPoint(x.size());
    scalarList number(C.size());
    for (label i = 0; i < mesh_.nCells(); ++i)
    {
        number[i] = globalCell.toGlobal(i);
    }
    halo_.fill(number.data(), 1);

    DynamicList<label> outside;
    boolList around(mesh_.nCells(), false);
    forAll(x, v)
    {
        if (m[v].outside() >= extendAbove)
        {
            outside.append(v);
            UIndirectList<bool>(around, cells[v]) = true;
        }
    }
    const List<DynamicList<label>> beside(cellsBeside(around));

    // both sides of a coupled face see the cells that a vertex there lacks:
    // the lower point number takes them
    List<claimList> claims(x.size());
    for (const label v : outside)
    {
        const vector open(normalised(m[v].inverseCovariance & m[v].mean));
        const scalar gap = mag(open & m[v].mean);
        const labelList known(cells[v]);
        for (const label celli : known)
        {
            claims[v].append(labelPair(label(number[celli]), -1));
        }
        for (const label celli : known)
        {
            for (const label other : beside[celli])
            {
                const vector d(C[other] - x[v] - m[v].mean);
                // a cell may be behind several coupled faces
                const label n = label(number[other]);
                if (mag(d & open) > 0.5*gap && !claimOf(claims[v], n))
                {
                    cells[v].append(other);
                    claims[v].append(labelPair(n, globalPoint.toGlobal(v)));
                }
            }
        }
    }
    if (returnReduce(halo_.size(), sumOp<label>()))
    {
        settle(claims, number, cells);
    }
}


void Foam::fsbi::meshStencil::settle
(
    List<claimList>& claims,
    const scalarList& number,
    List<DynamicList<label>>& cells
) const
{
    const globalIndex globalPoint(mesh_.nPoints());
    syncTools::syncPointList
    (
        mesh_, claims, lowestClaim(), claimList(), noTurn()
    );
    forAll(claims, v)
    {
        const labelList all(cells[v]);
        const label nAround = mesh_.pointCells()[v].size();
        cells[v].setSize(nAround);
        for (label i = nAround; i < all.size(); ++i)
        {
            if (*claimOf(claims[v], label(number[all[i]])) == globalPoint.toGlobal(v))
            {
                cells[v].append(all[i]);
            }
        }
    }
}


void Foam::fsbi::meshStencil::setVertices()
{
    const pointField& x = mesh_.points();

    List<DynamicList<label>> cells(x.size());
    forAll(x, v)
    {
        cells[v] = mesh_.pointCells()[v];
    }
    List<moments> m(vertexMoments(cells));
    extend(m, cells);
    m = vertexMoments(cells);

    vertexStart_.setSize(x.size() + 1);
    vertexStart_[0] = 0;
    forAll(x, v)
    {
        vertexStart_[v + 1] = vertexStart_[v] + cells[v].size();
    }
    vertexCell_.setSize(vertexStart_.last());
    vertexWeight_.setSize(vertexStart_.last());

    const vectorField C(centres());
    forAll(x, v)
    {
        const vector slope
        (
            m[v].outside() < averageAbove
          ? m[v].slope()
          : vector::zero
        );
        label at = vertexStart_[v];
        for (const label celli : cells[v])
        {
            const vector d(C[celli] - x[v]);
            vertexCell_[at] = celli;
            vertexWeight_[at] =
                (1 - (slope & (d - m[v].mean)))/(magSqr(d)*m[v].weight);
            ++at;
        }
    }
}


void Foam::fsbi::meshStencil::setCells()
{
    const labelListList& cellPoints = mesh_.cellPoints();
    const pointField& x = mesh_.points();

    cellStart_.setSize(mesh_.nCells() + 1);
    cellStart_[0] = 0;
    forAll(cellPoints, celli)
    {
        cellStart_[celli + 1] = cellStart_[celli] + cellPoints[celli].size();
    }
    cellVertex_.setSize(cellStart_.last());
    cellCoeff_.setSize(cellStart_.last());

    forAll(cellPoints, celli)
    {
        const label start = cellStart_[celli];
        const labelList& vertices = cellPoints[celli];
        forAll(vertices, i)
        {
            cellVertex_[start + i] = vertices[i];
            cellCoeff_[start + i] = Zero;
        }
        for (const label facei : mesh_.cells()[celli])
        {
            const face& f = mesh_.faces()[facei];
            const scalar sign = mesh_.faceOwner()[facei] == celli ? 1 : -1;
            const vector share
            (
                mesh_.faceAreas()[facei]*sign
               /(f.size()*mesh_.cellVolumes()[celli])
            );
            for (const label v : f)
            {
                cellCoeff_[start + vertices.find(v)] += share;
            }
        }

        tensor M(Zero);
        forAll(vertices, i)
        {
            M += cellCoeff_[start + i]*(x[vertices[i]] - mesh_.cellCentres()[celli]);
        }
        const tensor correction(inv(M));
        forAll(vertices, i)
        {
            cellCoeff_[start + i] = correction & cellCoeff_[start + i];
        }
    }
}
