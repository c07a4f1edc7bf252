/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cyclicPairs.H"
#include "SubField.H"
#include "cyclicPolyPatch.H"
#include "matchPoints.H"

namespace Foam
{
namespace fsbi
{

//- Sine of an angle, or a part of a length, that is none
static const scalar right = 1e-6;

static point centre(const polyPatch& patch)
{
    point sum(Zero);
    scalar area = 0;
    forAll(patch, f)
    {
        sum += mag(patch.faceAreas()[f])*patch.faceCentres()[f];
        area += mag(patch.faceAreas()[f]);
    }
    return sum/area;
}


// Mean of the corners of a piece: tells the copies of pieces apart
static point middle(const domainOutline& outline, const label piece)
{
    point sum(Zero);
    label n = 0;
    for (const DynamicList<label>& loop : outline.loops(piece))
    {
        for (const label line : loop)
        {
            const labelPair& ends = outline.lines()[mag(line) - 1];
            sum += outline.corners()[ends.first()];
            sum += outline.corners()[ends.second()];
            n += 2;
        }
    }
    return sum/n;
}

} // End namespace fsbi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsbi::cyclicPairs::matchPieces
(
    const polyMesh& domain, const domainOutline& outline, pair& p
) const
{
    const scalar tolerance = 1e-6*domain.bounds().mag();
    for (label i = 0; i < outline.nPieces(); ++i)
    {
        if (outline.patch(i) != p.patch)
        {
            continue;
        }
        const point copy(middle(outline, i) + p.translation);
        for (label j = 0; j < outline.nPieces(); ++j)
        {
            if
            (
                outline.patch(j) == p.neighbour
             && mag(middle(outline, j) - copy) < tolerance
            )
            {
                p.pieces.append(i);
                p.neighbourPieces.append(j);
            }
        }
    }
    label wanted = 0;
    for (label i = 0; i < outline.nPieces(); ++i)
    {
        wanted += outline.patch(i) == p.patch;
    }
    if (p.pieces.size() != wanted)
    {
        FatalErrorInFunction
            << "Cyclic patch '" << domain.boundaryMesh()[p.neighbour].name()
            << "' is no translated copy of '"
            << domain.boundaryMesh()[p.patch].name() << "'"
            << exit(FatalError);
    }
}


Foam::boolList Foam::fsbi::cyclicPairs::between
(
    const domainOutline& outline
) const
{
    boolList result(outline.lines().size(), true);
    for (label piece = 0; piece < outline.nPieces(); ++piece)
    {
        if (found(outline.patch(piece)))
        {
            for (const DynamicList<label>& loop : outline.loops(piece))
            {
                for (const label line : loop)
                {
                    result[mag(line) - 1] = false;
                }
            }
        }
    }
    return result;
}


Foam::FixedList<Foam::scalar, 2> Foam::fsbi::cyclicPairs::roomOf
(
    const period& along, const domainOutline& outline, const boolList& lines
)
{
    const scalar nothing = right*along.length();
    FixedList<scalar, 2> room(GREAT);
    forAll(lines, l)
    {
        const point& a = outline.corners()[outline.lines()[l].first()];
        const point& b = outline.corners()[outline.lines()[l].second()];
        const vector way(b - a);
        if (!lines[l] || mag(way ^ along.direction()) <= right*mag(way))
        {
            continue;
        }
        for (const point& p : {a, b})
        {
            const scalar from = along.from(p);
            room[0] = min(room[0], from - nothing);
            room[1] = min(room[1], along.length() - from - nothing);
        }
    }
    return room;
}


bool Foam::fsbi::cyclicPairs::straight(const polyMesh& domain) const
{
    forAll(periods_, i)
    {
        const vector along(periods_[i].direction());
        if (min(periods_[i].room[0], periods_[i].room[1]) <= 0)
        {
            return false;
        }
        forAll(periods_, j)
        {
            if (j != i && mag(along & periods_[j].direction()) > right)
            {
                return false;
            }
        }
        const polyPatch& side = domain.boundaryMesh()[pairs_[i].patch];
        forAll(side, f)
        {
            const vector& S = side.faceAreas()[f];
            if
            (
                mag((S & along) + mag(S)) > right*mag(S)
             || mag(periods_[i].from(side.faceCentres()[f]))
              > right*periods_[i].length()
            )
            {
                return false;
            }
        }
    }
    return true;
}


void Foam::fsbi::cyclicPairs::findPeriods
(
    const polyMesh& domain, const domainOutline& outline
)
{
    const boolList lines(between(outline));
    periods_.setSize(pairs_.size());
    forAll(pairs_, i)
    {
        period& along = periods_[i];
        along.side = domain.boundaryMesh()[pairs_[i].patch].localPoints();
        along.translation = pairs_[i].translation;
        along.room = roomOf(along, outline, lines);
    }
    if (!straight(domain))
    {
        periods_.clear();
    }
}


void Foam::fsbi::cyclicPairs::order(const pair& p, meshLists& mesh)
{
    const label n = mesh.patchSizes[p.patch];
    const label start = mesh.patchStarts[p.patch];
    const label copyStart = mesh.patchStarts[p.neighbour];
    if (n != mesh.patchSizes[p.neighbour])
    {
        mesh.failure = "cyclic patches were meshed differently";
        return;
    }
    pointField wanted(n), given(n);
    for (label i = 0; i < n; ++i)
    {
        wanted[i] =
            mesh.faces[start + i].centre(mesh.points) + p.translation;
        given[i] = mesh.faces[copyStart + i].centre(mesh.points);
    }
    const scalarField tolerance
    (
        n, 1e-6*boundBox(mesh.points, false).mag()
    );
    labelList from;
    if (!matchPoints(wanted, given, tolerance, false, from))
    {
        mesh.failure = "cyclic patches were meshed differently";
        return;
    }

    const faceList faces
    (
        SubList<face>(mesh.faces, n, copyStart)
    );
    const labelList owner(SubList<label>(mesh.owner, n, copyStart));
    for (label i = 0; i < n; ++i)
    {
        // the first points are opposite each other, the sense is reversed
        const face& f = faces[from[i]];
        const point anchor
        (
            mesh.points[mesh.faces[start + i][0]] + p.translation
        );
        label nearest = 0;
        forAll(f, j)
        {
            if
            (
                mag(mesh.points[f[j]] - anchor)
              < mag(mesh.points[f[nearest]] - anchor)
            )
            {
                nearest = j;
            }
        }
        face& g = mesh.faces[copyStart + i];
        forAll(f, j)
        {
            g[j] = f[(nearest + j) % f.size()];
        }
        mesh.owner[copyStart + i] = owner[from[i]];
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::cyclicPairs::cyclicPairs
(
    const polyMesh& domain, const domainOutline& outline
)
{
    for (const polyPatch& patch : domain.boundaryMesh())
    {
        const cyclicPolyPatch* half = isA<cyclicPolyPatch>(patch);
        if (!half || !half->owner())
        {
            continue;
        }
        if (!outline.inPieces())
        {
            FatalErrorInFunction
                << "Cyclic patch '" << patch.name() << "' needs a domain whose"
                << " boundary is closed: lines around some patch end nowhere"
                << exit(FatalError);
        }
        pair p;
        p.patch = patch.index();
        p.neighbour = half->neighbPatchID();
        p.translation =
            centre(domain.boundaryMesh()[p.neighbour]) - centre(patch);
        matchPieces(domain, outline, p);
        pairs_.append(p);
    }
    findPeriods(domain, outline);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::fsbi::cyclicPairs::found(const label patch) const
{
    return translation(patch) != vector(Zero);
}


Foam::vector Foam::fsbi::cyclicPairs::translation(const label patch) const
{
    for (const pair& p : pairs_)
    {
        if (patch == p.patch || patch == p.neighbour)
        {
            return patch == p.patch ? p.translation : -p.translation;
        }
    }
    return Zero;
}


Foam::List<Foam::vector> Foam::fsbi::cyclicPairs::translations() const
{
    DynamicList<vector> result;
    for (const pair& p : pairs_)
    {
        result.append(p.translation);
        result.append(-p.translation);
    }
    return List<vector>(std::move(result));
}


void Foam::fsbi::cyclicPairs::order(meshLists& mesh) const
{
    for (const pair& p : pairs_)
    {
        if (mesh.valid())
        {
            order(p, mesh);
        }
    }
}
