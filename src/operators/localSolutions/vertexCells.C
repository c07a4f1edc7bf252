/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "vertexCells.H"
#include "noTurn.H"
#include "syncTools.H"

namespace Foam
{
namespace fsbi
{

struct joinLists
{
    void operator()(labelList& a, const labelList& b) const
    {
        for (const label i : b)
        {
            if (!a.found(i))
            {
                a.append(i);
            }
        }
    }
};

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::vertexCells::vertexCells(const fvMesh& mesh)
:
    mesh_(mesh),
    number_(mesh.nCells())
{
    reset();
}


void Foam::fsbi::vertexCells::reset()
{
    setTouching();
    setMap();
}


void Foam::fsbi::vertexCells::setTouching()
{
    global_ = mesh_.pointCells();
    for (labelList& cells : global_)
    {
        for (label& celli : cells)
        {
            celli = number_.toGlobal(celli);
        }
    }
    syncTools::syncPointList
    (
        mesh_, global_, joinLists(), labelList(), noTurn()
    );
    nTouching_.setSize(global_.size());
    forAll(global_, v)
    {
        sort(global_[v]);
        nTouching_[v] = global_[v].size();
    }
}


void Foam::fsbi::vertexCells::setMap()
{
    cells_ = global_;
    if (UPstream::parRun())
    {
        List<Map<label>> compact;
        map_.reset(new mapDistribute(number_, cells_, compact));
    }
}


Foam::List<Foam::FixedList<Foam::label, 4>>
Foam::fsbi::vertexCells::neighbours() const
{
    List<FixedList<label, 4>> result
    (
        mesh_.nCells(), FixedList<label, 4>(label(-1))
    );
    labelList behind;
    syncTools::swapBoundaryCellList
    (
        mesh_, identity(mesh_.nCells(), number_.localStart()), behind
    );
    labelList n(mesh_.nCells(), Zero);
    const auto add = [&](const label celli, const label other)
    {
        if (n[celli] < 4)
        {
            result[celli][n[celli]++] = other;
        }
    };
    for (label facei = 0; facei < mesh_.nInternalFaces(); ++facei)
    {
        const label P = mesh_.faceOwner()[facei];
        const label N = mesh_.faceNeighbour()[facei];
        add(P, number_.toGlobal(N));
        add(N, number_.toGlobal(P));
    }
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        for (label i = 0; pp.coupled() && i < pp.size(); ++i)
        {
            add
            (
                pp.faceCells()[i],
                behind[pp.start() + i - mesh_.nInternalFaces()]
            );
        }
    }
    return result;
}


void Foam::fsbi::vertexCells::widen(const boolList& vertices)
{
    List<FixedList<label, 4>> beside(neighbours());
    fill(beside);
    forAll(vertices, v)
    {
        if (!vertices[v])
        {
            continue;
        }
        DynamicList<label> ring;
        for (const label celli : cells_[v])
        {
            for (const label other : beside[celli])
            {
                if
                (
                    other >= 0 && !global_[v].found(other)
                 && !ring.found(other)
                )
                {
                    ring.append(other);
                }
            }
        }
        sort(ring);
        global_[v].append(ring);
    }
    setMap();
}
