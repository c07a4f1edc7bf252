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
    List<const meshPiece*> pieces(parts.size());
    forAll(parts, i)
    {
        pieces[i] = &parts[i];
    }
    whole = joined(pieces);
    if (!whole.valid())
    {
        FatalErrorInFunction
            << "The mesh of region " << region << ": " << whole.failure.c_str()
            << exit(FatalError);
    }
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
