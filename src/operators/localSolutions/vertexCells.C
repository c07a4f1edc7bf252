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


Foam::labelListList Foam::fsbi::vertexCells::neighbours() const
{
    labelListList result(mesh_.nCells());
    labelList behind;
    syncTools::swapBoundaryCellList
    (
        mesh_, identity(mesh_.nCells(), number_.localStart()), behind
    );
    for (label facei = 0; facei < mesh_.nInternalFaces(); ++facei)
    {
        const label P = mesh_.faceOwner()[facei];
        const label N = mesh_.faceNeighbour()[facei];
        result[P].append(number_.toGlobal(N));
        result[N].append(number_.toGlobal(P));
    }
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        for (label i = 0; pp.coupled() && i < pp.size(); ++i)
        {
            result[pp.faceCells()[i]].append
            (
                behind[pp.start() + i - mesh_.nInternalFaces()]
            );
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
