/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "vertexCells.H"
#include "syncTools.H"

Foam::fsbi::vertexCells::vertexCells(const fvMesh& mesh)
:
    vertexMembers(mesh, mesh.nCells())
{
    reset();
}


void Foam::fsbi::vertexCells::reset()
{
    global_ = mesh_.pointCells();
    for (labelList& cells : global_)
    {
        for (label& celli : cells)
        {
            celli = number_.toGlobal(celli);
        }
    }
    setTouching();
}


Foam::labelList Foam::fsbi::vertexCells::otherSides() const
{
    const label nInternal = mesh_.nInternalFaces();
    labelList result(mesh_.nFaces(), -1);
    for (label facei = 0; facei < nInternal; ++facei)
    {
        result[facei] = number_.toGlobal(mesh_.faceNeighbour()[facei]);
    }
    labelList behind;
    syncTools::swapBoundaryCellList
    (
        mesh_, identity(mesh_.nCells(), number_.localStart()), behind
    );
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        if (pp.coupled())
        {
            SubList<label>(result, pp.size(), pp.start()) =
                SubList<label>(behind, pp.size(), pp.start() - nInternal);
        }
    }
    return result;
}


Foam::labelListList Foam::fsbi::vertexCells::neighbours() const
{
    labelListList result(mesh_.nCells());
    const labelList other(otherSides());
    forAll(other, facei)
    {
        const label P = mesh_.faceOwner()[facei];
        if (other[facei] >= 0)
        {
            result[P].append(other[facei]);
        }
        if (facei < mesh_.nInternalFaces())
        {
            result[mesh_.faceNeighbour()[facei]].append(number_.toGlobal(P));
        }
    }
    return result;
}


void Foam::fsbi::vertexCells::widen(const boolList& vertices)
{
    labelListList beside(neighbours());
    fill(beside);
    forAll(vertices, v)
    {
        if (vertices[v])
        {
            DynamicList<label> ring;
            for (const label celli : operator[](v))
            {
                ring.append(beside[celli]);
            }
            append(v, ring);
        }
    }
    setMap();
}


void Foam::fsbi::vertexCells::widen
(
    const labelList& fewest, const label mostRings
)
{
    for (label ring = 0; ring < mostRings; ++ring)
    {
        boolList few(fewest.size(), false);
        forAll(few, v)
        {
            few[v] = operator[](v).size() < fewest[v];
        }
        if (!returnReduce(few.found(true), orOp<bool>()))
        {
            return;
        }
        widen(few);
    }
}
