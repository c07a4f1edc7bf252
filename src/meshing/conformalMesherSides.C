/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// The boundary of the domain: what of it bodies may not cross, and where it is bent

#include "conformalMesher.H"
#include "volumeMesher.H"
#include "sideClearance.H"
#include "sizeField.H"
#include "mergePoints.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::List<Foam::vector> Foam::fsbi::conformalMesher::images() const
{
    return open_ ? imagesOf(cyclics_.periods()) : cyclics_.translations();
}


Foam::fsbi::bodySurface Foam::fsbi::conformalMesher::barriersAt
(
    const vector& shift
) const
{
    return (open_ ? barriers_ : walls_.surface).transformed(tensor::I, shift);
}


Foam::boundBox Foam::fsbi::conformalMesher::room(const vector& shift) const
{
    boundBox room(walls_.surface.bounds());
    room.min() += shift;
    room.max() += shift;
    for (const period& p : periods())
    {
        room.min() -= cmptMag(p.translation);
        room.max() += cmptMag(p.translation);
    }
    return room;
}


void Foam::fsbi::conformalMesher::pairPoints
(
    const UList<point>& points,
    const UList<triFace>& triangles,
    const labelUList& patches,
    const vector& shift,
    labelList& alike,
    List<DynamicList<vector>>& normals
) const
{
    alike = labelList(points.size(), -1);
    normals.setSize(points.size());
    DynamicList<label> onSides;
    forAll(triangles, i)
    {
        const triFace& t = triangles[i];
        const vector normal(t.unitNormal(points));
        for (const label p : t)
        {
            if (!cyclics_.found(patches[i]))
            {
                bool known = false;
                for (const vector& other : normals[p])
                {
                    known = known || mag(normal & other) > 0.999;
                }
                if (!known)
                {
                    normals[p].append(normal);
                }
            }
            else if (alike[p] < 0)
            {
                alike[p] = onSides.size();
                onSides.append(p);
            }
        }
    }

    // all in the cell's first sides
    const scalar tolerance = 1e-6*walls_.surface.bounds().mag();
    pointField first(points, onSides);
    for (point& x : first)
    {
        for (const period& along : periods())
        {
            if (along.from(x - shift) > along.length() - tolerance)
            {
                x -= along.translation;
            }
        }
    }
    labelList merged;
    Foam::mergePoints(first, tolerance, false, merged);
    forAll(onSides, i)
    {
        alike[onSides[i]] = merged[i];
    }
}


Foam::fsbi::domainBoundary Foam::fsbi::conformalMesher::bentBoundary
(
    const UList<bodySurface>& bodies,
    const bentCell& cell,
    const vector& shift,
    const sizeField& size,
    const meshingAttempt& settings,
    string& failure
) const
{
    autoPtr<volumeMesher> model(volumeMesher::New(walls_.surface.bounds().mag()));
    addPieces([&](const point& p) { return cell.corner(p + shift); }, model());
    pointField points;
    failure = model->generateSurfaces
    (
        [&](const point& p) { return size(cell(p))/cell.stretch(p); },
        settings, points
    );
    if (failure.size())
    {
        return {};
    }
    DynamicList<triFace> triangles;
    DynamicList<label> patches;
    for (label piece = 0; piece < outline_.nPieces(); ++piece)
    {
        for (const triFace& t : model->pieceTriangles(piece))
        {
            triangles.append(t);
            patches.append(outline_.patch(piece));
        }
    }
    labelList alike;
    List<DynamicList<vector>> normals;
    pairPoints
    (
        points, triangles, patches, shift + cell.shift(), alike, normals
    );
    DynamicList<edge> lines;
    forAll(triangles, i)
    {
        for (const edge& line : triangles[i].edges())
        {
            if (cyclics_.found(patches[i]))
            {
                lines.append(line);
            }
        }
    }
    for (point& p : points)
    {
        p = cell(p);
    }
    sideClearance(bodies, imagesOf(periods()), boundBox(points, false)).apply
    (
        points, lines, alike, normals
    );
    return {bodySurface(points, triangles), labelList(patches)};
}


Foam::fsbi::domainBoundary Foam::fsbi::conformalMesher::givenBoundary
(
    const UList<bodySurface>& bodies,
    const bodySurface& walls,
    const vector& shift,
    const sizeField& size,
    const meshingAttempt& settings,
    string& failure
) const
{
    if (!outline_.inPieces())
    {
        // far away they are as the background has them
        return refinedFor
        (
            [&](const point& p) { return size.besideBodies(p); },
            {walls, walls_.patches}
        );
    }
    const bentCell cell(periods(), bodies, shift);
    failure = cell.failure();
    if (failure.size() || !cell.bent())
    {
        return domainBoundary();
    }
    return bentBoundary(bodies, cell, shift, size, settings, failure);
}


void Foam::fsbi::conformalMesher::addPieces
(
    const std::function<point(const point&)>& place, volumeMesher& model
) const
{
    model.addOutline(outline_, place);
    cyclics_.forPieces
    (
        [&](const label piece, const label copy, const vector& translation)
        {
            model.addCopy(piece, copy, translation);
        }
    );
}
