/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "tetrahedra.H"
#include "meshAssembly.H"

#include <algorithm>

namespace Foam
{
namespace fsbi
{

static label placeOf(const tetPoints& t, const label pointi)
{
    return std::find(t.begin(), t.end(), pointi) - t.begin();
}

} // End namespace fsbi
} // End namespace Foam

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsbi::tetrahedra::readCells(const meshLists& mesh)
{
    const tetPoints none{-1, -1, -1, -1};
    cells_.assign(mesh.nCells(), none);
    const auto add = [&](const label celli, const face& f, const bool outward)
    {
        tetPoints& t = cells_[celli];
        if (f.size() != 3)
        {
            valid_ = false;
        }
        else if (t[1] < 0)
        {
            t = {-1, f[0], f[outward ? 1 : 2], f[outward ? 2 : 1]};
        }
        else
        {
            for (const label p : f)
            {
                if (p != t[1] && p != t[2] && p != t[3] && p != t[0])
                {
                    valid_ = valid_ && t[0] < 0;
                    t[0] = p;
                }
            }
        }
    };
    forAll(mesh.faces, f)
    {
        add(mesh.owner[f], mesh.faces[f], true);
        if (f < mesh.neighbour.size())
        {
            add(mesh.neighbour[f], mesh.faces[f], false);
        }
    }
    for (const tetPoints& t : cells_)
    {
        valid_ = valid_ && t[0] >= 0;
    }
}


void Foam::fsbi::tetrahedra::readFaces(const meshLists& mesh)
{
    // the side opposite the point that is not of the face
    const auto sideAt = [&](const label celli, const face& f)
    {
        const tetPoints& t = cells_[celli];
        label i = 0;
        while (t[i] == f[0] || t[i] == f[1] || t[i] == f[2])
        {
            ++i;
        }
        return i;
    };
    across_.resize(cells_.size());
    forAll(mesh.faces, f)
    {
        const label P = mesh.owner[f];
        const label i = sideAt(P, mesh.faces[f]);
        if (f < nInternalFaces_)
        {
            const label N = mesh.neighbour[f];
            const label j = sideAt(N, mesh.faces[f]);
            across_[P][i] = 4*N + j;
            across_[N][j] = 4*P + i;
        }
        else
        {
            across_[P][i] = -1 - (f - nInternalFaces_);
        }
    }
}


Foam::fsbi::tetrahedra::halfFace Foam::fsbi::tetrahedra::half
(
    const tetPoints& t, const label sidei
)
{
    halfFace h;
    for (label i = 0; i < 3; ++i)
    {
        h.key[i] = t[tetSides[sidei][i]];
    }
    std::sort(h.key.begin(), h.key.end());
    return h;
}


void Foam::fsbi::tetrahedra::stamp(const std::vector<label>& cells) const
{
    stamp_.resize(cells_.size(), 0);
    ++stampNow_;
    for (const label c : cells)
    {
        stamp_[c] = stampNow_;
    }
}


template<class Pair>
bool Foam::fsbi::tetrahedra::matched
(
    const std::vector<label>& old,
    const std::vector<tetPoints>& anew,
    const Pair& pair
) const
{
    stamp(old);
    halves_.clear();
    for (const label c : old)
    {
        for (label i = 0; i < 4; ++i)
        {
            const label code = across_[c][i];
            if (code < 0 || stamp_[code/4] != stampNow_)
            {
                halfFace h(half(cells_[c], i));
                h.code = code;
                h.inside = false;
                halves_.push_back(h);
            }
        }
    }
    for (std::size_t k = 0; k < anew.size(); ++k)
    {
        for (label i = 0; i < 4; ++i)
        {
            halfFace h(half(anew[k], i));
            h.code = 4*k + i;
            h.inside = true;
            halves_.push_back(h);
        }
    }
    if (halves_.size() % 2)
    {
        return false;
    }
    std::sort(halves_.begin(), halves_.end());
    for (std::size_t k = 0; k < halves_.size(); k += 2)
    {
        const halfFace& a = halves_[k];
        const halfFace& b = halves_[k + 1];
        const bool crowded = k > 1 && halves_[k - 1].key == a.key;
        if (crowded || a.key != b.key || !(a.inside || b.inside))
        {
            return false;
        }
        a.inside ? pair(a, b) : pair(b, a);
    }
    return true;
}


Foam::labelList Foam::fsbi::tetrahedra::numbers(label& n) const
{
    labelList number(cells_.size());
    n = 0;
    forAll(number, c)
    {
        number[c] = exists(c) ? c : -1;
        n += exists(c);
    }
    label hole = 0;
    for (label c = n; c < number.size(); ++c)
    {
        if (number[c] >= 0)
        {
            while (number[hole] >= 0)
            {
                ++hole;
            }
            number[c] = hole++;
        }
    }
    return number;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::tetrahedra::tetrahedra(const meshLists& mesh)
:
    cellOf_(mesh.points.size(), -1),
    nInternalFaces_(mesh.neighbour.size()),
    valid_(true),
    stampNow_(0)
{
    readCells(mesh);
    if (!valid_)
    {
        return;
    }
    readFaces(mesh);
    for (label c = 0; c < size(); ++c)
    {
        for (const label p : cells_[c])
        {
            cellOf_[p] = c;
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::fsbi::tetrahedra::side Foam::fsbi::tetrahedra::sideOf
(
    const label celli, const label sidei
) const
{
    const tetPoints& t = cells_[celli];
    const label code = across_[celli][sidei];
    side s;
    for (label i = 0; i < 3; ++i)
    {
        s.points[i] = t[tetSides[sidei][i]];
    }
    s.in = t[sidei];
    s.out = code < 0 ? -1 : cells_[code/4][code % 4];
    return s;
}


void Foam::fsbi::tetrahedra::star
(
    const label pointi, std::vector<label>& cells
) const
{
    cells.assign(1, cellOf_[pointi]);
    stamp(cells);
    for (std::size_t k = 0; k < cells.size(); ++k)
    {
        const label c = cells[k];
        for (label i = 0; i < 4; ++i)
        {
            const label n = neighbour(c, i);
            if (n >= 0 && cells_[c][i] != pointi && stamp_[n] != stampNow_)
            {
                stamp_[n] = stampNow_;
                cells.push_back(n);
            }
        }
    }
}


bool Foam::fsbi::tetrahedra::ring
(
    const label celli, const label a, const label b, const label limit,
    std::vector<label>& cells, std::vector<label>& points
) const
{
    // (a b u v) is positive: of the side opposite a, the two that follow b
    const tetPoints& t = cells_[celli];
    const label i = placeOf(t, a);
    label at = 0;
    while (t[tetSides[i][at]] != b)
    {
        ++at;
    }
    label u = tetSides[i][(at + 1) % 3];
    const label first = t[u];
    label v = t[tetSides[i][(at + 2) % 3]];

    cells.assign(1, celli);
    points.assign(1, first);
    label c = celli;
    while (v != first)
    {
        const label code = across_[c][u];
        if (code < 0 || label(points.size()) >= limit)
        {
            return false;
        }
        points.push_back(v);
        c = code/4;
        cells.push_back(c);
        // across the side of a, b and v: there v is what u was
        u = placeOf(cells_[c], v);
        v = cells_[c][code % 4];
    }
    return true;
}


void Foam::fsbi::tetrahedra::sides
(
    const std::vector<label>& cells, std::vector<side>& result
) const
{
    stamp(cells);
    result.clear();
    for (const label c : cells)
    {
        for (label i = 0; i < 4; ++i)
        {
            const label code = across_[c][i];
            const bool inside = code >= 0 && stamp_[code/4] == stampNow_;
            if (!inside || c < code/4)
            {
                result.push_back(sideOf(c, i));
            }
        }
    }
}


bool Foam::fsbi::tetrahedra::sides
(
    const std::vector<label>& old,
    const std::vector<tetPoints>& anew,
    std::vector<side>& result
) const
{
    result.clear();
    return matched
    (
        old, anew,
        [&](const halfFace& a, const halfFace& b)
        {
            const tetPoints& t = anew[a.code/4];
            side s;
            for (label i = 0; i < 3; ++i)
            {
                s.points[i] = t[tetSides[a.code % 4][i]];
            }
            s.in = t[a.code % 4];
            s.out =
                b.inside ? anew[b.code/4][b.code % 4]
              : b.code < 0 ? -1 : cells_[b.code/4][b.code % 4];
            result.push_back(s);
        }
    );
}


void Foam::fsbi::tetrahedra::replace
(
    const std::vector<label>& old,
    const std::vector<tetPoints>& anew,
    std::vector<label>& numbers
)
{
    numbers.clear();
    for (std::size_t k = 0; k < anew.size(); ++k)
    {
        numbers.push_back
        (
            k < old.size() ? old[k] : label(cells_.size() + k - old.size())
        );
    }
    std::vector<std::array<label, 4>> across(anew.size());
    matched
    (
        old, anew,
        [&](const halfFace& a, const halfFace& b)
        {
            const label here = 4*numbers[a.code/4] + a.code % 4;
            const label there =
                b.inside ? 4*numbers[b.code/4] + b.code % 4 : b.code;
            across[a.code/4][a.code % 4] = there;
            if (b.inside)
            {
                across[b.code/4][b.code % 4] = here;
            }
            else if (there >= 0)
            {
                across_[there/4][there % 4] = here;
            }
        }
    );
    for (std::size_t k = anew.size(); k < old.size(); ++k)
    {
        cells_[old[k]] = {-1, -1, -1, -1};
    }
    if (anew.size() > old.size())
    {
        cells_.resize(cells_.size() + anew.size() - old.size());
    }
    across_.resize(cells_.size());
    for (std::size_t k = 0; k < anew.size(); ++k)
    {
        cells_[numbers[k]] = anew[k];
        across_[numbers[k]] = across[k];
        for (const label p : anew[k])
        {
            cellOf_[p] = numbers[k];
        }
    }
}


void Foam::fsbi::tetrahedra::putInto(meshLists& mesh) const
{
    label nCells;
    const labelList number(numbers(nCells));
    labelList cellAt(nCells);
    forAll(number, c)
    {
        if (number[c] >= 0)
        {
            cellAt[number[c]] = c;
        }
    }
    const label nBoundary = mesh.faces.size() - nInternalFaces_;
    const label nInner = (4*nCells - nBoundary)/2;
    faceList faces(nInner + nBoundary);
    labelList owner(faces.size()), neighbour(nInner);
    label facei = 0;
    forAll(cellAt, celli)
    {
        const label c = cellAt[celli];
        std::array<std::pair<label, label>, 4> above;
        label n = 0;
        for (label i = 0; i < 4; ++i)
        {
            const label code = across_[c][i];
            if (code < 0)
            {
                owner[nInner - 1 - code] = celli;
            }
            else if (number[code/4] > celli)
            {
                above[n++] = {number[code/4], i};
            }
        }
        std::sort(above.begin(), above.begin() + n);
        for (label k = 0; k < n; ++k)
        {
            const side s(sideOf(c, above[k].second));
            faces[facei] =
                firstPointLowest(triFace(s.points[0], s.points[1], s.points[2]));
            owner[facei] = celli;
            neighbour[facei++] = above[k].first;
        }
    }
    for (label b = 0; b < nBoundary; ++b)
    {
        faces[nInner + b] = mesh.faces[nInternalFaces_ + b];
    }
    for (label& start : mesh.patchStarts)
    {
        start += nInner - nInternalFaces_;
    }
    mesh.faces.transfer(faces);
    mesh.owner.transfer(owner);
    mesh.neighbour.transfer(neighbour);
}
