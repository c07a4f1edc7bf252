/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshRepairI.H"
#include "mathematicalConstants.H"
#include "unitConversion.H"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace Foam
{
namespace fsbi
{

//- Shape below which a cell is bad
static const scalar badShape = 0.12;

//- Most cells around an edge that is taken away
static const label longestRing = 7;

//- Normals of a plane differ by no more
static const scalar samePlane = 1e-6;

//- Shape of the worst of new cells, over that of the worst they replace, below
//  which they are not looked at further
static const scalar asGood = 0.7;


static void sortUnique(std::vector<label>& numbers)
{
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

} // End namespace fsbi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::fsbi::meshRepair::isBad(const patient& p, const scalar limit) const
{
    if (!cells_.exists(p.cell))
    {
        return false;
    }
    if (p.side < 0)
    {
        return shape(cells_[p.cell]) < badShape;
    }
    return
        cells_.neighbour(p.cell, p.side) >= 0
     && cosine(cells_.sideOf(p.cell, p.side)) < limit;
}


void Foam::fsbi::meshRepair::examine
(
    const std::vector<label>& cells,
    const scalar limit,
    std::vector<patient>& patients
) const
{
    patients.clear();
    const bool all = label(cells.size()) == cells_.size();
    for (const label c : cells)
    {
        if (!cells_.exists(c))
        {
            continue;
        }
        for (label i = 0; i < 4; ++i)
        {
            const label n = cells_.neighbour(c, i);
            if (n < 0 || (n < c && all))
            {
                continue;
            }
            const scalar angle = cosine(cells_.sideOf(c, i));
            const bool first =
                c < n || !std::binary_search(cells.begin(), cells.end(), n);
            if (angle < limit && first)
            {
                // rounded: the order must not depend on round-off
                patients.push_back({std::round((1 - angle)/roundOff), c, i});
            }
        }
        if (shape(cells_[c]) < badShape)
        {
            patients.push_back({0, c, -1});
        }
    }
    std::sort(patients.begin(), patients.end());
}


void Foam::fsbi::meshRepair::touch(const std::vector<label>& cells)
{
    isTouched_.resize(cells_.size(), false);
    for (const label c : cells)
    {
        if (!isTouched_[c])
        {
            isTouched_[c] = true;
            touched_.push_back(c);
        }
    }
}


void Foam::fsbi::meshRepair::forget()
{
    for (const label c : touched_)
    {
        isTouched_[c] = false;
    }
    touched_.clear();
}


void Foam::fsbi::meshRepair::consider(swap&& candidate, swap& best)
{
    cells_.sides(candidate.old, sides_);
    const scalar before = badness(candidate.old, GREAT);
    const scalar wanted =
        before - max(max(worthwhile*before, roundOff), (1 + roundOff)*best.gain);
    if (cells_.sides(candidate.old, candidate.anew, sides_))
    {
        const scalar after = badness(candidate.anew, wanted);
        if (after < wanted)
        {
            candidate.gain = before - after;
            best = std::move(candidate);
        }
    }
}


Foam::scalar Foam::fsbi::meshRepair::worst
(
    const std::vector<label>& cells
) const
{
    scalar q = GREAT;
    for (const label c : cells)
    {
        q = min(q, shape(cells_[c]));
    }
    return max(flat, asGood*q);
}


void Foam::fsbi::meshRepair::considerFace
(
    const label celli, const label sidei, swap& best
)
{
    const label other = cells_.neighbour(celli, sidei);
    if (other < 0)
    {
        return;
    }
    const tetrahedra::side s(cells_.sideOf(celli, sidei));
    ringCells_ = {celli, other};
    const scalar wanted = worst(ringCells_);
    std::array<tetPoints, 3> t;
    for (label i = 0; i < 3; ++i)
    {
        t[i] = {s.in, s.out, s.points[i], s.points[(i + 1) % 3]};
        if (shape(t[i]) <= wanted)
        {
            return;
        }
    }
    consider({ringCells_, {t.begin(), t.end()}, 0}, best);
}


void Foam::fsbi::meshRepair::considerEdge
(
    const label celli, const label a, const label b, swap& best
)
{
    if (!cells_.ring(celli, a, b, longestRing, ringCells_, ring_))
    {
        return;
    }
    std::vector<tetPoints> anew;
    if (withoutEdge(a, b, worst(ringCells_), anew))
    {
        consider({ringCells_, std::move(anew), 0}, best);
    }
}


bool Foam::fsbi::meshRepair::withoutEdge
(
    const label a, const label b, const scalar wanted,
    std::vector<tetPoints>& cells
) const
{
    // the worst cell over the best triangulation of points i to j of the ring, and
    // the third point of its triangle at (i j)
    const label n = ring_.size();
    scalar worst[longestRing][longestRing];
    label third[longestRing][longestRing];
    for (label i = n - 2; i >= 0; --i)
    {
        worst[i][i + 1] = GREAT;
        for (label j = i + 2; j < n; ++j)
        {
            worst[i][j] = -GREAT;
            third[i][j] = i + 1;
            for (label k = i + 1; k < j; ++k)
            {
                const scalar q = min
                (
                    min(worst[i][k], worst[k][j]),
                    min
                    (
                        shape({ring_[i], ring_[k], ring_[j], b}),
                        shape({ring_[k], ring_[i], ring_[j], a})
                    )
                );
                if (q > worst[i][j] + roundOff)
                {
                    worst[i][j] = q;
                    third[i][j] = k;
                }
            }
        }
    }
    if (!(worst[0][n - 1] > wanted))
    {
        return false;
    }
    std::vector<labelPair> open(1, labelPair(0, n - 1));
    while (open.size())
    {
        const label i = open.back().first(), j = open.back().second();
        open.pop_back();
        if (j > i + 1)
        {
            const label k = third[i][j];
            cells.push_back({ring_[i], ring_[k], ring_[j], b});
            cells.push_back({ring_[k], ring_[i], ring_[j], a});
            open.push_back(labelPair(i, k));
            open.push_back(labelPair(k, j));
        }
    }
    return true;
}


std::vector<Foam::label> Foam::fsbi::meshRepair::treat
(
    const patient& p, const bool thorough
)
{
    std::vector<label> cells(1, p.cell);
    if (p.side >= 0)
    {
        cells.push_back(cells_.neighbour(p.cell, p.side));
    }
    swap best{{}, {}, 0};
    const label n = thorough ? cells.size() : 1;
    for (label k = 0; k < n; ++k)
    {
        const label c = cells[k];
        const tetPoints t(cells_[c]);
        for (label i = 0; i < 4; ++i)
        {
            // not thorough: the face alone, and its edges
            for (label j = i + 1; j < 4; ++j)
            {
                if (thorough || (i != p.side && j != p.side))
                {
                    considerEdge(c, t[i], t[j], best);
                }
            }
            if (thorough || i == p.side)
            {
                considerFace(c, i, best);
            }
        }
    }
    if (best.anew.size())
    {
        cells_.replace(best.old, best.anew, cells);
        touch(cells);
    }
    std::vector<label> points;
    for (const label c : cells)
    {
        points.insert(points.end(), cells_[c].begin(), cells_[c].end());
    }
    sortUnique(points);
    return points;
}


void Foam::fsbi::meshRepair::setMobility
(
    const meshLists& mesh, const label patchi, const bool slides
)
{
    const label start = mesh.patchStarts[patchi];
    for (label f = start; f < start + mesh.patchSizes[patchi]; ++f)
    {
        const vector n(mesh.faces[f].unitNormal(points_));
        for (const label p : mesh.faces[f])
        {
            const auto known = normals_.emplace(p, n);
            const bool plane =
                known.second || mag(known.first->second - n) < samePlane;
            mobility_[p] =
                slides && plane && mobility_[p] != FIXED ? SLIDING : FIXED;
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::meshRepair::meshRepair
(
    const meshLists& mesh, const wordList& fixedPatches
)
:
    points_(mesh.points),
    cells_(mesh),
    mobility_(mesh.points.size(), FREE),
    mild_(false)
{
    forAll(mesh.patchNames, patchi)
    {
        const word type(mesh.patchDicts[patchi].get<word>("type"));
        setMobility
        (
            mesh, patchi,
            (type == "wall" || type == "patch")
         && !fixedPatches.found(mesh.patchNames[patchi])
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsbi::meshRepair::meanNonOrthogonality() const
{
    scalar sum = 0;
    label n = 0;
    for (label c = 0; c < cells_.size(); ++c)
    {
        for (label i = 0; i < 4 && cells_.exists(c); ++i)
        {
            if (cells_.neighbour(c, i) > c)
            {
                sum += Foam::acos(max(min(cosine(cells_.sideOf(c, i)), 1), -1));
                ++n;
            }
        }
    }
    return radToDeg(sum/max(n, 1));
}


void Foam::fsbi::meshRepair::sweep(const scalar degrees)
{
    const scalar limit = Foam::cos(degToRad(degrees));
    std::vector<label> cells(cells_.size());
    std::iota(cells.begin(), cells.end(), 0);
    std::vector<patient> patients;
    examine(cells, limit, patients);
    std::vector<bool> done(points_.size(), false);
    mild_ = true;
    for (const patient& p : patients)
    {
        if (isBad(p, limit))
        {
            for (const label v : treat(p, false))
            {
                if (!done[v])
                {
                    done[v] = true;
                    centre(v);
                }
            }
        }
    }
    mild_ = false;
}


void Foam::fsbi::meshRepair::run(const scalar degrees, const label passes)
{
    const scalar limit = Foam::cos(degToRad(degrees));
    std::vector<label> cells(cells_.size());
    std::iota(cells.begin(), cells.end(), 0);
    std::vector<patient> patients;
    for (label pass = 0; pass < passes; ++pass)
    {
        examine(cells, limit, patients);
        if (patients.empty())
        {
            break;
        }
        forget();
        cells.clear();
        for (const patient& p : patients)
        {
            cells.push_back(p.cell);
            if (isBad(p, limit))
            {
                for (const label v : treat(p, true))
                {
                    smooth(v);
                }
            }
        }
        cells.insert(cells.end(), touched_.begin(), touched_.end());
        sortUnique(cells);
    }
}


void Foam::fsbi::meshRepair::putInto(meshLists& mesh) const
{
    mesh.points = points_;
    cells_.putInto(mesh);
}
