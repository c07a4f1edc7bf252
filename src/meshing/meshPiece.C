/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshPiece.H"
#include "ListOps.H"

namespace Foam
{
namespace fsbi
{

static bool isProcessor(const dictionary& patch)
{
    return patch.get<word>("type") == "processor";
}


static void joinPart(const meshPiece& part, meshLists& whole)
{
    const meshLists& mesh = part.mesh;
    UIndirectList<point>(whole.points, part.points) = mesh.points;
    forAll(mesh.faces, facei)
    {
        const label g = part.faces[facei];
        const label c = part.cells[mesh.owner[facei]];
        const bool inner = facei < mesh.neighbour.size();
        label& owner = whole.owner[g];
        label& neighbour = whole.neighbour[g];
        if (owner < 0 || c < owner)
        {
            // of a cut face the owner's side comes from the owner's part
            neighbour = inner ? part.cells[mesh.neighbour[facei]] : owner;
            owner = c;
            whole.faces[g] = renumber(part.points, mesh.faces[facei]);
        }
        else
        {
            neighbour = c;
        }
    }
}


static void joinPatches(const UList<const meshPiece*>& parts, meshLists& whole)
{
    const meshLists& first = parts[0]->mesh;
    label start = whole.neighbour.size();
    forAll(first.patchNames, patchi)
    {
        if (isProcessor(first.patchDicts[patchi]))
        {
            break;
        }
        label size = 0;
        for (const meshPiece* part : parts)
        {
            size += part->mesh.patchSizes[patchi];
        }
        whole.patchNames.append(first.patchNames[patchi]);
        whole.patchDicts.append(first.patchDicts[patchi]);
        whole.patchStarts.append(start);
        whole.patchSizes.append(size);
        start += size;
    }
}


static bool complete
(
    const UList<const meshPiece*>& parts, const meshLists& whole
)
{
    const label last = whole.patchNames.size() - 1;
    label nCells = 0;
    for (const meshPiece* part : parts)
    {
        nCells += part->cells.size();
    }
    return
        !whole.owner.found(-1) && !whole.neighbour.found(-1)
     && last >= 0
     && whole.patchStarts[last] + whole.patchSizes[last] == whole.faces.size()
     && nCells == whole.nCells();
}

} // End namespace fsbi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Functions * * * * * * * * * * * * * * * * //

Foam::fsbi::meshLists Foam::fsbi::joined(const UList<const meshPiece*>& parts)
{
    meshLists whole;
    label nPoints = 0, nFaces = 0;
    for (const meshPiece* part : parts)
    {
        nPoints = max(nPoints, max(part->points) + 1);
        nFaces = max(nFaces, max(part->faces) + 1);
    }
    whole.points.setSize(nPoints);
    whole.faces.setSize(nFaces);
    whole.owner.setSize(nFaces, -1);
    whole.neighbour.setSize(nFaces, -1);
    for (const meshPiece* part : parts)
    {
        joinPart(*part, whole);
    }
    label nInternal = 0;
    while (nInternal < nFaces && whole.neighbour[nInternal] >= 0)
    {
        ++nInternal;
    }
    whole.neighbour.setSize(nInternal);
    joinPatches(parts, whole);
    if (!complete(parts, whole))
    {
        whole.failure =
            "the parts do not fit together: cells or faces are missing";
    }
    return whole;
}


// * * * * * * * * * * * * * * * Friend Operators  * * * * * * * * * * * * * //

Foam::Ostream& Foam::fsbi::operator<<(Ostream& os, const meshPiece& p)
{
    return os << p.mesh << p.cells << p.faces << p.points;
}


Foam::Istream& Foam::fsbi::operator>>(Istream& is, meshPiece& p)
{
    return is >> p.mesh >> p.cells >> p.faces >> p.points;
}
