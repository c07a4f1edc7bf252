/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "domainOutline.H"
#include "straddling.H"
#include "cyclicPolyPatch.H"
#include "unitConversion.H"
#include "Map.H"

namespace Foam
{
namespace fsbi
{

//- Patches are bent where faces meet at less, in degrees
static const scalar featureAngle = 30;


//- Where the first of the triangles of a face has its first corner. One of four
//  points is cut so that a cell of these four would lie outside; along its shorter
//  diagonal if it is plane
static label firstCorner(const face& f, const pointField& p)
{
    if (f.size() != 4)
    {
        return 0;
    }
    const vector a(p[f[2]] - p[f[0]]), b(p[f[3]] - p[f[1]]);
    const vector n(a ^ b);
    const scalar fold = ((p[f[1]] - p[f[0]]) ^ a) & (p[f[3]] - p[f[0]]);
    if (mag(fold) > 1e-4*mag(n)*sqrt(mag(n)))
    {
        return fold > 0 ? 0 : 1;
    }
    return mag(b) < mag(a) ? 1 : 0;
}


static List<triFace> cutFaces(const faceList& faces, const pointField& p)
{
    DynamicList<triFace> triangles;
    for (const face& f : faces)
    {
        const label n = f.size();
        const label first = firstCorner(f, p);
        for (label i = 1; i + 1 < n; ++i)
        {
            triangles.append
            (
                triFace(f[first], f[(first + i) % n], f[(first + i + 1) % n])
            );
        }
    }
    return List<triFace>(std::move(triangles));
}


// The edges of the boundary between different pieces
struct outlineEdges
{
    const ownedPatch& boundary;
    const labelList& facePiece;

    //- At every point the edges that meet there
    List<DynamicList<label>> meeting;

    outlineEdges(const ownedPatch& patch, const labelList& pieces)
    :
        boundary(patch),
        facePiece(pieces),
        meeting(patch.nPoints())
    {
        forAll(patch.edges(), e)
        {
            const labelList& f = patch.edgeFaces()[e];
            if (f.size() != 2 || facePiece[f[0]] != facePiece[f[1]])
            {
                meeting[patch.edges()[e][0]].append(e);
                meeting[patch.edges()[e][1]].append(e);
            }
        }
    }

    //- Other than two edges between the same pieces that go straight on
    bool isCorner(const label p) const
    {
        if (meeting[p].size() != 2)
        {
            return meeting[p].size();
        }
        labelHashSet sides;
        vector away[2];
        for (label i = 0; i < 2; ++i)
        {
            const label e = meeting[p][i];
            const label end = boundary.edges()[e].otherVertex(p);
            away[i] =
                normalised
                (
                    boundary.localPoints()[end] - boundary.localPoints()[p]
                );
            for (const label f : boundary.edgeFaces()[e])
            {
                sides.insert(facePiece[f]);
            }
        }
        return sides.size() != 2 || (away[0] & away[1]) > -(1 - 1e-10);
    }

    //- Along the edges from a corner to the next
    label follow
    (
        const label start, label e, const Map<label>& corner, boolList& used
    ) const
    {
        used[e] = true;
        label p = boundary.edges()[e].otherVertex(start);
        while (!corner.found(p))
        {
            e = meeting[p][0] == e ? meeting[p][1] : meeting[p][0];
            used[e] = true;
            p = boundary.edges()[e].otherVertex(p);
        }
        return p;
    }
};


// The boundary of a mesh, and the patch of every face
static ownedPatch boundaryOf(const polyMesh& mesh)
{
    const SubList<face> faces
    (
        mesh.faces(), mesh.nBoundaryFaces(), mesh.nInternalFaces()
    );
    const primitivePatch boundary(faces, mesh.points());
    return ownedPatch(boundary.localFaces(), boundary.localPoints());
}


static labelList patchesOf(const polyMesh& mesh)
{
    labelList patches(mesh.nBoundaryFaces());
    forAll(patches, i)
    {
        patches[i] =
            mesh.boundaryMesh().whichPatch(i + mesh.nInternalFaces());
    }
    return patches;
}


static bool isPeriodic(const polyMesh& mesh)
{
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (isA<cyclicPolyPatch>(patch))
        {
            return true;
        }
    }
    return false;
}

} // End namespace fsbi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsbi::domainOutline::joinAcross
(
    const ownedPatch& faces,
    const labelUList& patches,
    const label piece,
    DynamicList<label>& front
)
{
    const vectorField& normals = faces.faceNormals();
    const scalar almostFlat = Foam::cos(degToRad(1e-4));
    const scalar feature = Foam::cos(degToRad(featureAngle));

    while (front.size())
    {
        const label facei = front.remove();
        for (const label other : faces.faceFaces()[facei])
        {
            if (patches[other] != patches[facei])
            {
                continue;
            }
            const scalar c = normals[facei] & normals[other];
            curved_ = curved_ || (c < almostFlat && c > feature);
            if (c >= almostFlat && facePiece_[other] < 0)
            {
                facePiece_[other] = piece;
                front.append(other);
            }
        }
    }
}


void Foam::fsbi::domainOutline::findPieces
(
    const ownedPatch& faces, const labelUList& patches
)
{
    facePiece_ = labelList(faces.size(), -1);
    piecePatch_.clear();
    forAll(faces, facei)
    {
        const face& f = faces.localFaces()[facei];
        const vector n(f.unitNormal(faces.localPoints()));
        const point& p0 = faces.localPoints()[f[0]];
        for (const label p : f)
        {
            const vector d(faces.localPoints()[p] - p0);
            curved_ = curved_ || mag(d & n) > 1e-6*mag(d);
        }
        if (facePiece_[facei] < 0)
        {
            facePiece_[facei] = piecePatch_.size();
            DynamicList<label> front(1, facei);
            piecePatch_.append(patches[facei]);
            joinAcross(faces, patches, piecePatch_.size() - 1, front);
        }
    }
}


void Foam::fsbi::domainOutline::findLines(const ownedPatch& boundary)
{
    const outlineEdges outline(boundary, facePiece_);

    Map<label> corner;
    forAll(outline.meeting, p)
    {
        if (outline.isCorner(p))
        {
            corner.insert(p, corners_.size());
            corners_.append(boundary.localPoints()[p]);
        }
    }

    lineLists_.setSize(piecePatch_.size());
    boolList used(boundary.nEdges(), false);
    for (const label start : corner.sortedToc())
    {
        for (const label e : outline.meeting[start])
        {
            if (!used[e])
            {
                const label end = outline.follow(start, e, corner, used);
                lines_.append(labelPair(corner[start], corner[end]));
                for (const label facei : boundary.edgeFaces()[e])
                {
                    lineLists_[facePiece_[facei]].append(lines_.size());
                }
            }
        }
    }
}


Foam::label Foam::fsbi::domainOutline::takeNext
(
    const label corner, DynamicList<label>& left
) const
{
    forAll(left, i)
    {
        const label l = left[i];
        const labelPair& line = lines_[l - 1];
        if (line.first() == corner || line.second() == corner)
        {
            left[i] = left.last();
            left.remove();
            return line.first() == corner ? l : -l;
        }
    }
    return 0;
}


bool Foam::fsbi::domainOutline::closeLoops
(
    DynamicList<label> left, DynamicList<DynamicList<label>>& loops
) const
{
    scalar largest = 0;
    while (left.size())
    {
        DynamicList<label> loop(1, left.remove());
        const label first = lines_[loop[0] - 1].first();
        label last = lines_[loop[0] - 1].second();
        vector area(Zero);
        while (last != first)
        {
            const label l = takeNext(last, left);
            if (l == 0)
            {
                return false;
            }
            const labelPair& line = lines_[mag(l) - 1];
            const label to = l > 0 ? line.second() : line.first();
            area +=
                (corners_[last] - corners_[first])
              ^ (corners_[to] - corners_[first]);
            loop.append(l);
            last = to;
        }
        loops.append(loop);
        if (mag(area) > largest)
        {
            largest = mag(area);
            loops.last().swap(loops.first());
        }
    }
    return loops.size();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::domainOutline::domainOutline(const polyMesh& mesh)
:
    mesh_(mesh),
    curved_(false),
    inPieces_(false)
{
    const ownedPatch faces(boundaryOf(mesh));
    findPieces(faces, patchesOf(mesh));
    if (!curved_)
    {
        findLines(faces);
    }
    else if (isPeriodic(mesh))
    {
        const domainBoundary walls(triangulation());
        faceList triangles(walls.patches.size());
        forAll(triangles, i)
        {
            triangles[i] = face(walls.surface.triangles()[i]);
        }
        const ownedPatch facets(triangles, walls.surface.points());
        findPieces(facets, walls.patches);
        findLines(facets);
    }
    inPieces_ = lines_.size();
    loops_.setSize(lineLists_.size());
    forAll(loops_, i)
    {
        // an outline that does not close is none: keep the faces
        inPieces_ = inPieces_ && closeLoops(lineLists_[i], loops_[i]);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::fsbi::bodySurface Foam::fsbi::domainBoundary::part
(
    const std::function<bool(const label)>& chosen
) const
{
    DynamicList<face> faces;
    forAll(patches, i)
    {
        if (chosen(patches[i]))
        {
            faces.append(face(surface.triangles()[i]));
        }
    }
    const ownedPatch connected(faces, surface.points());
    List<triFace> triangles(connected.size());
    forAll(triangles, i)
    {
        triangles[i] = triFace(connected.localFaces()[i]);
    }
    return bodySurface::open(connected.localPoints(), triangles);
}


Foam::fsbi::domainBoundary Foam::fsbi::domainOutline::triangulation() const
{
    const ownedPatch boundary(boundaryOf(mesh_));
    const labelList patchOf(patchesOf(mesh_));
    labelList patches;
    bool quadrilaterals = true;
    forAll(boundary, facei)
    {
        const label n = boundary.localFaces()[facei].size();
        quadrilaterals = quadrilaterals && n == 4;
        patches.append(labelList(n - 2, patchOf[facei]));
    }
    const faceList& faces = boundary.localFaces();
    bodySurface surface
    (
        boundary.localPoints(), cutFaces(faces, boundary.localPoints())
    );
    if (curved_ && quadrilaterals)
    {
        const bodySurface moved(straddling(surface, patches, featureAngle));
        surface = bodySurface(moved.points(), cutFaces(faces, moved.points()));
    }
    return {surface, patches};
}
