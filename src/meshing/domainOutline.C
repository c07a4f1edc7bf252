/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "domainOutline.H"
#include "primitivePatch.H"
#include "unitConversion.H"
#include "Map.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsbi::domainOutline::joinAcross
(
    const label piece, DynamicList<label>& front
)
{
    const polyPatch& patch = mesh_.boundaryMesh()[piecePatch_[piece]];
    const label offset = patch.start() - mesh_.nInternalFaces();
    const vectorField& normals = patch.faceNormals();
    const scalar almostFlat = Foam::cos(degToRad(1e-4));
    const scalar feature = Foam::cos(degToRad(30.0));

    while (front.size())
    {
        const label facei = front.remove();
        for (const label other : patch.faceFaces()[facei])
        {
            const scalar c = normals[facei] & normals[other];
            curved_ = curved_ || (c < almostFlat && c > feature);
            if (c >= almostFlat && facePiece_[offset + other] < 0)
            {
                facePiece_[offset + other] = piece;
                front.append(other);
            }
        }
    }
}


void Foam::fsbi::domainOutline::findPieces()
{
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        const label offset = patch.start() - mesh_.nInternalFaces();
        forAll(patch, facei)
        {
            const face& f = patch[facei];
            const vector n(f.unitNormal(mesh_.points()));
            const point& p0 = mesh_.points()[f[0]];
            for (const label p : f)
            {
                const vector d(mesh_.points()[p] - p0);
                curved_ = curved_ || mag(d & n) > 1e-6*mag(d);
            }
            if (facePiece_[offset + facei] < 0)
            {
                facePiece_[offset + facei] = piecePatch_.size();
                DynamicList<label> front(1, facei);
                piecePatch_.append(patch.index());
                joinAcross(piecePatch_.size() - 1, front);
            }
        }
    }
}


void Foam::fsbi::domainOutline::findLines()
{
    const label nInternal = mesh_.nInternalFaces();
    const primitivePatch boundary
    (
        SubList<face>(mesh_.faces(), mesh_.nBoundaryFaces(), nInternal),
        mesh_.points()
    );
    const edgeList& edges = boundary.edges();
    const labelListList& edgeFaces = boundary.edgeFaces();
    const pointField& points = boundary.localPoints();

    // the edges between pieces, and at their points the edges that meet
    boolList between(edges.size(), false);
    List<DynamicList<label>> meeting(points.size());
    forAll(edges, e)
    {
        const labelList& f = edgeFaces[e];
        if (f.size() != 2 || facePiece_[f[0]] != facePiece_[f[1]])
        {
            between[e] = true;
            meeting[edges[e][0]].append(e);
            meeting[edges[e][1]].append(e);
        }
    }

    // a corner is where other than two edges between the same pieces go
    // straight on
    Map<label> corner;
    forAll(meeting, p)
    {
        if (meeting[p].empty())
        {
            continue;
        }
        bool straight = meeting[p].size() == 2;
        if (straight)
        {
            const label e0 = meeting[p][0], e1 = meeting[p][1];
            vector a(points[edges[e0].otherVertex(p)] - points[p]);
            vector b(points[edges[e1].otherVertex(p)] - points[p]);
            labelHashSet sides;
            for (const label e : {e0, e1})
            {
                for (const label f : edgeFaces[e])
                {
                    sides.insert(facePiece_[f]);
                }
            }
            straight =
                sides.size() == 2 && (a & b) < -(1 - 1e-10)*mag(a)*mag(b);
        }
        if (!straight)
        {
            corner.insert(p, corners_.size());
            corners_.append(boundary.meshPoints()[p]);
        }
    }

    loops_.setSize(piecePatch_.size());
    boolList used(edges.size(), false);
    forAll(meeting, start)
    {
        if (!corner.found(start))
        {
            continue;
        }
        for (label e : meeting[start])
        {
            if (used[e])
            {
                continue;
            }
            const labelList& f = edgeFaces[e];
            label p = start;
            used[e] = true;
            p = edges[e].otherVertex(p);
            while (!corner.found(p))
            {
                e = meeting[p][0] == e ? meeting[p][1] : meeting[p][0];
                used[e] = true;
                p = edges[e].otherVertex(p);
            }
            lines_.append(labelPair(corner[start], corner[p]));
            for (const label facei : f)
            {
                DynamicList<DynamicList<label>>& loops =
                    loops_[facePiece_[facei]];
                if (loops.empty())
                {
                    loops.append(DynamicList<label>());
                }
                loops[0].append(lines_.size());
            }
        }
    }
}


void Foam::fsbi::domainOutline::orderLoops()
{
    for (DynamicList<DynamicList<label>>& loops : loops_)
    {
        if (loops.empty())
        {
            curved_ = true;
            return;
        }
        DynamicList<label> left(loops[0]);
        loops.clear();
        scalarField areas;
        while (left.size())
        {
            DynamicList<label> loop(1, left.remove());
            const label first = lines_[mag(loop[0]) - 1].first();
            label last = lines_[mag(loop[0]) - 1].second();
            vector area(Zero);
            const point& p0 = mesh_.points()[corners_[first]];
            while (last != first)
            {
                label next = -1;
                forAll(left, i)
                {
                    const labelPair& line = lines_[left[i] - 1];
                    if (line.first() == last || line.second() == last)
                    {
                        next = i;
                        break;
                    }
                }
                if (next < 0)
                {
                    curved_ = true;
                    return;
                }
                const labelPair& line = lines_[left[next] - 1];
                const bool forward = line.first() == last;
                const label to = forward ? line.second() : line.first();
                area +=
                    (mesh_.points()[corners_[last]] - p0)
                  ^ (mesh_.points()[corners_[to]] - p0);
                loop.append(forward ? left[next] : -left[next]);
                last = to;
                for (label i = next; i + 1 < left.size(); ++i)
                {
                    left[i] = left[i + 1];
                }
                left.remove();
            }
            areas.append(mag(area));
            loops.append(loop);
        }
        const label outer = findMax(areas);
        if (outer > 0)
        {
            loops[0].swap(loops[outer]);
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::domainOutline::domainOutline(const polyMesh& mesh)
:
    mesh_(mesh),
    facePiece_(mesh.nBoundaryFaces(), -1),
    curved_(false)
{
    findPieces();
    if (!curved_)
    {
        findLines();
        orderLoops();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::fsbi::bodySurface Foam::fsbi::domainOutline::triangulation
(
    labelList& patches
) const
{
    const primitivePatch boundary
    (
        SubList<face>
        (
            mesh_.faces(), mesh_.nBoundaryFaces(), mesh_.nInternalFaces()
        ),
        mesh_.points()
    );
    DynamicList<triFace> triangles;
    DynamicList<label> patchOf;
    forAll(boundary, facei)
    {
        const label patchi =
            mesh_.boundaryMesh().whichPatch(facei + mesh_.nInternalFaces());
        const face& f = boundary.localFaces()[facei];
        // a quadrilateral along its shorter diagonal
        const pointField& p = boundary.localPoints();
        const label n = f.size();
        const label first =
            n == 4 && mag(p[f[1]] - p[f[3]]) < mag(p[f[0]] - p[f[2]]) ? 1 : 0;
        for (label i = 1; i + 1 < n; ++i)
        {
            triangles.append
            (
                triFace(f[first], f[(first + i) % n], f[(first + i + 1) % n])
            );
            patchOf.append(patchi);
        }
    }
    patches.transfer(patchOf);
    return bodySurface(boundary.localPoints(), triangles);
}
