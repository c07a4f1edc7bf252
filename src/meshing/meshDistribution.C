/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshDistribution.H"
#include "Pstream.H"
#include "boundBox.H"
#include "ListOps.H"
#include "IStringStream.H"
#include "OStringStream.H"

#include <algorithm>
#include <map>

namespace Foam
{
namespace fsbi
{

static void halve
(
    const pointField& centres,
    SubList<label> cells,
    const label firstRank,
    const label nRanks,
    labelList& rank
)
{
    if (nRanks == 1)
    {
        for (const label c : cells)
        {
            rank[c] = firstRank;
        }
        return;
    }
    boundBox box;
    for (const label c : cells)
    {
        box.add(centres[c]);
    }
    const vector span(box.span());
    direction d = span.x() >= span.y() ? 0 : 1;
    d = span[d] >= span.z() ? d : 2;

    const label left = nRanks/2;
    const label n = label(scalar(cells.size())*left/nRanks);
    std::nth_element
    (
        cells.begin(), cells.begin() + n, cells.end(),
        [&](const label a, const label b)
        {
            return
                centres[a][d] < centres[b][d]
             || (centres[a][d] == centres[b][d] && a < b);
        }
    );
    halve(centres, SubList<label>(cells, n), firstRank, left, rank);
    halve
    (
        centres, SubList<label>(cells, cells.size() - n, n),
        firstRank + left, nRanks - left, rank
    );
}


// The smallest cell of those that cyclic faces join, directly or by others
static label first(labelList& joined, label cell)
{
    while (joined[cell] != cell)
    {
        joined[cell] = joined[joined[cell]];
        cell = joined[cell];
    }
    return cell;
}


// Both halves of a pair of cyclic patches are local then, in the same order
static void keepCyclicTogether(const meshLists& whole, labelList& rank)
{
    labelList joined(identity(rank.size()));
    forAll(whole.patchDicts, patchi)
    {
        if (whole.patchDicts[patchi].get<word>("type") != "cyclic")
        {
            continue;
        }
        const label other = whole.patchNames.find
        (
            whole.patchDicts[patchi].get<word>("neighbourPatch")
        );
        for (label i = 0; i < whole.patchSizes[patchi]; ++i)
        {
            const label a =
                first(joined, whole.owner[whole.patchStarts[patchi] + i]);
            const label b =
                first(joined, whole.owner[whole.patchStarts[other] + i]);
            joined[max(a, b)] = min(a, b);
        }
    }
    forAll(rank, c)
    {
        rank[c] = rank[first(joined, c)];
    }
}

} // End namespace fsbi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsbi::meshDistribution::selectCells
(
    const meshLists& whole,
    const labelList& cellRank,
    const label me,
    labelList& localCell,
    labelList& localPoint
)
{
    localCell = labelList(cellRank.size(), -1);
    DynamicList<label> mine;
    forAll(cellRank, c)
    {
        if (cellRank[c] == me)
        {
            localCell[c] = mine.size();
            mine.append(c);
        }
    }
    cells.transfer(mine);

    boolList used(whole.points.size(), false);
    const label nInternal = whole.neighbour.size();
    forAll(whole.faces, f)
    {
        if
        (
            localCell[whole.owner[f]] >= 0
         || (f < nInternal && localCell[whole.neighbour[f]] >= 0)
        )
        {
            for (const label p : whole.faces[f])
            {
                used[p] = true;
            }
        }
    }
    localPoint = labelList(whole.points.size(), -1);
    DynamicList<label> kept;
    forAll(used, p)
    {
        if (used[p])
        {
            localPoint[p] = kept.size();
            kept.append(p);
        }
    }
    points.transfer(kept);
    mesh.points = pointField(whole.points, points);
}


void Foam::fsbi::meshDistribution::selectFaces
(
    const meshLists& whole,
    const labelList& localCell,
    const labelList& localPoint,
    growingFaces& part
)
{
    const label nInternal = whole.neighbour.size();
    for (label f = 0; f < nInternal; ++f)
    {
        const label o = localCell[whole.owner[f]];
        const label n = localCell[whole.neighbour[f]];
        if (o >= 0 && n >= 0)
        {
            part.faces.append(renumber(localPoint, whole.faces[f]));
            part.owner.append(o);
            part.neighbour.append(n);
            part.numbers.append(f);
        }
    }
    forAll(whole.patchStarts, patchi)
    {
        mesh.patchStarts.append(part.faces.size());
        const label start = whole.patchStarts[patchi];
        for (label f = start; f < start + whole.patchSizes[patchi]; ++f)
        {
            if (localCell[whole.owner[f]] >= 0)
            {
                part.faces.append(renumber(localPoint, whole.faces[f]));
                part.owner.append(localCell[whole.owner[f]]);
                part.numbers.append(f);
            }
        }
        mesh.patchSizes.append(part.faces.size() - mesh.patchStarts[patchi]);
    }
}


void Foam::fsbi::meshDistribution::select
(
    const meshLists& whole, const labelList& cellRank, const label me
)
{
    wholePatchStarts = whole.patchStarts;
    mesh.patchNames = whole.patchNames;
    mesh.patchDicts = whole.patchDicts;
    mesh.bodyPoints = whole.bodyPoints;
    mesh.failure = whole.failure;
    labelList localCell, localPoint;
    selectCells(whole, cellRank, me, localCell, localPoint);
    growingFaces part;
    selectFaces(whole, localCell, localPoint, part);
    addProcessorPatches(whole, cellRank, me, localCell, localPoint, part);
    mesh.faces.transfer(part.faces);
    mesh.owner.transfer(part.owner);
    mesh.neighbour.transfer(part.neighbour);
    faces.transfer(part.numbers);
}


void Foam::fsbi::meshDistribution::addProcessorPatches
(
    const meshLists& whole,
    const labelList& cellRank,
    const label me,
    const labelList& localCell,
    const labelList& localPoint,
    growingFaces& part
)
{
    std::map<label, DynamicList<label>> shared;
    forAll(whole.neighbour, f)
    {
        const label o = cellRank[whole.owner[f]];
        const label n = cellRank[whole.neighbour[f]];
        if (o != n && (o == me || n == me))
        {
            shared[o == me ? n : o].append(f);
        }
    }

    for (const auto& other : shared)
    {
        const word rank(Foam::name(me)), otherRank(Foam::name(other.first));
        dictionary dict;
        dict.set("type", "processor");
        dict.set("inGroups", wordList({"processor"}));
        dict.set("matchTolerance", 1e-4);
        dict.set("transform", "unknown");
        dict.set("myProcNo", me);
        dict.set("neighbProcNo", other.first);
        mesh.patchNames.append("procBoundary" + rank + "to" + otherRank);
        mesh.patchDicts.append(dict);
        mesh.patchStarts.append(part.faces.size());
        mesh.patchSizes.append(other.second.size());
        for (const label f : other.second)
        {
            const bool owner = cellRank[whole.owner[f]] == me;
            const face local(renumber(localPoint, whole.faces[f]));
            part.faces.append(owner ? local : local.reverseFace());
            part.owner.append
            (
                localCell[owner ? whole.owner[f] : whole.neighbour[f]]
            );
            part.numbers.append(f);
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::meshDistribution::meshDistribution
(
    const meshLists& whole, const labelList& cellRank
)
{
    if (!Pstream::parRun())
    {
        mesh = whole;
        cells = identity(whole.nCells());
        faces = identity(whole.faces.size());
        points = identity(whole.points.size());
        wholePatchStarts = whole.patchStarts;
        return;
    }

    meshLists all;
    labelList ranks;
    if (Pstream::master())
    {
        all = whole;
        ranks = cellRank;
    }
    Pstream::scatter(all);
    Pstream::scatter(ranks);
    select(all, ranks, Pstream::myProcNo());
}


Foam::fsbi::meshDistribution::meshDistribution
(
    const meshLists& whole, const labelList& cellRank, const label rank
)
{
    select(whole, cellRank, rank);
}


// * * * * * * * * * * * * * * * Static Functions  * * * * * * * * * * * * * //

Foam::labelList Foam::fsbi::meshDistribution::bisect
(
    const meshLists& whole, const label nRanks
)
{
    pointField centres(whole.nCells(), Zero);
    labelList n(centres.size(), Zero);
    forAll(whole.faces, f)
    {
        const point c(whole.faces[f].centre(whole.points));
        centres[whole.owner[f]] += c;
        ++n[whole.owner[f]];
        if (f < whole.neighbour.size())
        {
            centres[whole.neighbour[f]] += c;
            ++n[whole.neighbour[f]];
        }
    }
    forAll(centres, c)
    {
        centres[c] /= n[c];
    }
    labelList rank(centres.size(), Zero);
    labelList order(identity(centres.size()));
    if (order.size())
    {
        halve
        (
            centres, SubList<label>(order, order.size()), 0, nRanks, rank
        );
    }
    keepCyclicTogether(whole, rank);
    return rank;
}
