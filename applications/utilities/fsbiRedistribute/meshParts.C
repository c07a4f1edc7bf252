/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshParts.H"
#include "ListOps.H"

namespace Foam
{

static labelList places(const labelList& numbers)
{
    labelList result(numbers);
    for (label& i : result)
    {
        ++i;
    }
    return result;
}

static face renumbered(const face& f, const labelList& numbers)
{
    face result(f.size());
    forAll(f, i)
    {
        result[i] = numbers[f[i]];
    }
    return result;
}

static bool isProcessor(const dictionary& patch)
{
    return patch.get<word>("type") == "processor";
}

} // End namespace Foam


void Foam::fsbi::meshPart::setPlaces
(
    const meshLists& whole, const boolList& lower
)
{
    const label nInternal = mesh.neighbour.size();
    const label wholeInternal = whole.neighbour.size();
    nPhysical_ = whole.patchNames.size();
    cellPlaces = places(cells);
    pointPlaces = places(points);
    patchPlaces.setSize(mesh.patchNames.size());
    boundaryPlaces.setSize(mesh.faces.size() - nInternal, 0);

    DynamicList<label> inner(SubList<label>(places(faces), nInternal));
    DynamicList<label> outer;
    forAll(mesh.patchNames, patchi)
    {
        patchPlaces[patchi].setSize(mesh.patchSizes[patchi]);
        forAll(patchPlaces[patchi], i)
        {
            const label facei = mesh.patchStarts[patchi] + i;
            const label g = faces[facei];
            if (isPhysical(patchi))
            {
                patchPlaces[patchi][i] = g - whole.patchStarts[patchi] + 1;
                boundaryPlaces[facei - nInternal] = g - wholeInternal + 1;
                outer.append(g + 1);
            }
            else
            {
                const bool owner = cells[mesh.owner[facei]] == whole.owner[g];
                patchPlaces[patchi][i] =
                    (owner ? whole.neighbour[g] : whole.owner[g]) + 1;
                inner.append(owner ? g + 1 : -g - 1);
            }
        }
    }

    DynamicList<label> unknowns;
    const auto addVector = [&](const label number)
    {
        for (label d = 1; d <= 3; ++d)
        {
            unknowns.append(3*number + d);
        }
    };
    for (const label c : cells)
    {
        addVector(c);
    }
    for (const label g : outer)
    {
        addVector(whole.nCells() + g - 1 - wholeInternal);
    }
    unknownPlaces = unknowns;
    const label nVectors = whole.nCells() + whole.faces.size() - wholeInternal;
    for (const label v : points)
    {
        if (!lower[v])
        {
            unknowns.append(3*nVectors + v + 1);
        }
    }
    mixedPlaces.transfer(unknowns);
    inner.append(outer);
    facePlaces.transfer(inner);
}


void Foam::fsbi::meshParts::setPlaces()
{
    boolList lower(whole.points.size(), false);
    for (meshPart& part : parts)
    {
        part.setPlaces(whole, lower);
        UIndirectList<bool>(lower, part.points) = true;
    }
}


void Foam::fsbi::meshParts::joinPart(const meshPart& part)
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
            whole.faces[g] = renumbered(mesh.faces[facei], part.points);
        }
        else
        {
            neighbour = c;
        }
    }
}


void Foam::fsbi::meshParts::joinPatches()
{
    const meshLists& first = parts[0].mesh;
    label start = whole.neighbour.size();
    forAll(first.patchNames, patchi)
    {
        if (isProcessor(first.patchDicts[patchi]))
        {
            break;
        }
        label size = 0;
        for (const meshPart& part : parts)
        {
            size += part.mesh.patchSizes[patchi];
        }
        whole.patchNames.append(first.patchNames[patchi]);
        whole.patchDicts.append(first.patchDicts[patchi]);
        whole.patchStarts.append(start);
        whole.patchSizes.append(size);
        start += size;
    }
}


void Foam::fsbi::meshParts::check(const word& region) const
{
    const label last = whole.patchNames.size() - 1;
    bool good =
        !whole.owner.found(-1) && !whole.neighbour.found(-1)
     && last >= 0
     && whole.patchStarts[last] + whole.patchSizes[last] == whole.faces.size();
    label nCells = 0;
    for (const meshPart& part : parts)
    {
        nCells += part.cells.size();
    }
    if (!good || nCells != whole.nCells())
    {
        FatalErrorInFunction
            << "The parts of the mesh of region " << region << " do not fit"
            << " together: cells or faces are missing" << exit(FatalError);
    }
}


Foam::fsbi::meshParts::meshParts
(
    PtrList<meshPart>&& given, const word& region
)
:
    parts(std::move(given))
{
    if (parts.size() == 1)
    {
        whole = parts[0].mesh;
        setPlaces();
        return;
    }
    label nPoints = 0, nFaces = 0;
    for (const meshPart& part : parts)
    {
        nPoints = max(nPoints, max(part.points) + 1);
        nFaces = max(nFaces, max(part.faces) + 1);
    }
    whole.points.setSize(nPoints);
    whole.faces.setSize(nFaces);
    whole.owner.setSize(nFaces, -1);
    whole.neighbour.setSize(nFaces, -1);
    for (const meshPart& part : parts)
    {
        joinPart(part);
    }
    label nInternal = 0;
    while (nInternal < nFaces && whole.neighbour[nInternal] >= 0)
    {
        ++nInternal;
    }
    whole.neighbour.setSize(nInternal);
    joinPatches();
    check(region);
    setPlaces();
}


Foam::fsbi::meshParts::meshParts
(
    const meshLists& mesh, const pointField& points, const label number
)
:
    whole(mesh)
{
    meshLists made(mesh);
    made.points = points;
    const labelList rank(meshDistribution::bisect(made, number));
    for (label r = 0; r < number; ++r)
    {
        auto part = autoPtr<meshPart>::New();
        if (number > 1)
        {
            const meshDistribution cut(whole, rank, r);
            part->mesh = cut.mesh;
            part->cells = cut.cells;
            part->faces = cut.faces;
            part->points = cut.points;
        }
        else
        {
            part->mesh = whole;
            part->cells = identity(whole.nCells());
            part->faces = identity(whole.faces.size());
            part->points = identity(whole.points.size());
        }
        parts.append(part.ptr());
    }
    setPlaces();
}
