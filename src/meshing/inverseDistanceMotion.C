/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "inverseDistanceMotion.H"
#include "triangleTree.H"
#include "polyMesh.H"
#include "cyclicPolyPatch.H"
#include "processorPolyPatch.H"
#include "syncTools.H"
#include "PtrList.H"

namespace Foam
{
namespace fsbi
{

//- Surfaces this many times as far as the nearest have no weight
static const scalar furthest = 10;


// The rotation from one orientation to another as a vector
static vector rotation(const quaternion& from, const quaternion& to)
{
    quaternion q(to*conjugate(from));
    // q and -q are the same rotation: take the short way
    const scalar sign = q.w() < 0 ? -1 : 1;
    const scalar sine = mag(q.v());
    if (sine < SMALL)
    {
        return 2*sign*q.v();
    }
    return sign*2*Foam::atan2(sine, sign*q.w())/sine*q.v();
}


// R(theta) r - r, by Rodrigues
static vector turned(const vector& theta, const vector& r)
{
    const scalar angle = mag(theta);
    if (angle < SMALL)
    {
        return theta ^ r;
    }
    const vector axis(theta/angle);
    const vector across(axis ^ r);
    return
        Foam::sin(angle)*across
      + 2*sqr(Foam::sin(angle/2))*(axis ^ across);
}

} // End namespace fsbi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsbi::inverseDistanceMotion::place
(
    const UList<bodySurface>& surfaces, const UList<vector>& images
)
{
    const boundBox mesh(reference_, true);
    forAll(surfaces, b)
    {
        standing_.append(standing{b, Zero});
        for (const vector& image : images)
        {
            // as far as it is large it matters
            boundBox there(surfaces[b].bounds());
            const vector span(there.span());
            there.min() += image - span;
            there.max() += image + span;
            if (there.overlaps(mesh))
            {
                standing_.append(standing{b, image});
            }
        }
    }
    shares_.setSize(standing_.size());
}


void Foam::fsbi::inverseDistanceMotion::distances
(
    const PtrList<triangleTree>& surfaces,
    const point& p, const scalar step, const scalar touching, scalarField& d
) const
{
    const auto surface = [&](const label i) -> const triangleTree&
    {
        return i < standing_.size() ? surfaces[standing_[i].body] : surfaces.last();
    };
    const auto from = [&](const label i)
    {
        return i < standing_.size() ? point(p - standing_[i].off) : p;
    };

    // the nearest goes first, by bounding boxes: what is ten times as far then
    // spares most of the search, and so does that no surface is further than it
    // was by more than the step
    label guess = 0;
    scalar bound = GREAT;
    forAll(d, i)
    {
        const scalar least = surface(i).atLeast(from(i));
        if (least < bound)
        {
            bound = least;
            guess = i;
        }
    }
    const auto find = [&](const label i, const scalar reach)
    {
        const scalar farthest = (1 + SMALL)*(d[i] + step) + touching;
        d[i] = GREAT;
        surface(i).find(from(i), min(reach, farthest), d[i]);
    };
    find(guess, ROOTVGREAT);
    scalar nearest = d[guess];
    forAll(d, i)
    {
        if (i != guess)
        {
            find(i, furthest*nearest + touching);
            nearest = min(nearest, d[i]);
        }
    }
}


void Foam::fsbi::inverseDistanceMotion::weigh
(
    const UList<scalar>& d, const scalar touching, scalarField& w
) const
{
    // relative to the nearest: no overflow however near it is
    const scalar nearest = min(d);
    forAll(w, i)
    {
        w[i] =
            nearest < touching
          ? (d[i] == nearest ? 1 : 0)
          : max(Foam::pow(nearest/d[i], power_) - Foam::pow(furthest, -power_), 0);
    }
    w /= sum(w);
}


void Foam::fsbi::inverseDistanceMotion::setWeights
(
    const UList<bodySurface>& surfaces, const bodySurface& walls
)
{
    PtrList<triangleTree> trees;
    for (const bodySurface& s : surfaces)
    {
        trees.append(new triangleTree(s));
    }
    trees.append(new triangleTree(walls));

    // of the mesh: where all sides are cyclic there are no walls
    const scalar touching = 1e-9*boundBox(reference_, true).mag();
    scalarField d(standing_.size() + 1, GREAT), w(d.size());
    forAll(reference_, p)
    {
        const point& last = reference_[max(p - 1, 0)];
        distances(trees, reference_[p], mag(reference_[p] - last), touching, d);
        weigh(d, touching, w);
        domainWeight_[p] = w.last();
        forAll(shares_, i)
        {
            if (w[i] > 0)
            {
                shares_[i].append({p, w[i]});
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::inverseDistanceMotion::inverseDistanceMotion
(
    const polyMesh& mesh,
    const wordList& bodyPatches,
    const UList<bodySurface>& surfaces,
    const UList<placement>& placements,
    const UList<vector>& images,
    const scalar power
)
:
    mesh_(mesh),
    reference_(mesh.points()),
    bodies_(placements),
    periodic_(images.size()),
    power_(power),
    domainWeight_(mesh.nPoints())
{
    place(surfaces, images);
    setWeights(surfaces, domainBoundary(mesh, bodyPatches, periodic_));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::pointField Foam::fsbi::inverseDistanceMotion::move
(
    const UList<placement>& now, const vector& frameShift
) const
{
    vectorField moved(domainWeight_*frameShift);
    forAll(shares_, i)
    {
        const label b = standing_[i].body;
        const vector theta
        (
            rotation(bodies_[b].orientation, now[b].orientation)
        );
        const vector shift(now[b].centre - bodies_[b].centre);
        const point centre(bodies_[b].centre + standing_[i].off);
        for (const share& s : shares_[i])
        {
            const vector r(reference_[s.point] - centre);
            moved[s.point] += turned(s.weight*theta, r) + s.weight*shift;
        }
    }
    if (periodic_)
    {
        // the same but for round-off and images that are far
        syncTools::syncPointList
        (
            mesh_, moved, maxMagSqrEqOp<vector>(), vector::zero
        );
    }
    return reference_ + moved;
}


Foam::scalar Foam::fsbi::inverseDistanceMotion::twist
(
    const UList<placement>& now
) const
{
    scalar largest = 0;
    forAll(bodies_, b)
    {
        largest = max
        (
            largest,
            mag(rotation(bodies_[b].orientation, now[b].orientation))
        );
    }
    return largest;
}


Foam::fsbi::bodySurface Foam::fsbi::inverseDistanceMotion::domainBoundary
(
    const polyMesh& mesh, const wordList& bodyPatches, const bool periodic
)
{
    // three corners of every triangle, unmerged: distances need no more
    List<List<point>> corners(Pstream::nProcs());
    DynamicList<point> mine;
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if
        (
            isA<processorPolyPatch>(patch) || bodyPatches.found(patch.name())
         || (periodic && isA<cyclicPolyPatch>(patch))
        )
        {
            continue;
        }
        for (const face& f : patch)
        {
            for (label i = 1; i + 1 < f.size(); ++i)
            {
                for (const label p : {f[0], f[i], f[i + 1]})
                {
                    mine.append(mesh.points()[p]);
                }
            }
        }
    }
    corners[Pstream::myProcNo()] = mine;
    Pstream::gatherList(corners);
    Pstream::scatterList(corners);

    DynamicList<point> points;
    for (const List<point>& part : corners)
    {
        points.append(part);
    }
    List<triFace> triangles(points.size()/3);
    forAll(triangles, i)
    {
        triangles[i] = triFace(3*i, 3*i + 1, 3*i + 2);
    }
    return bodySurface::open(pointField(std::move(points)), triangles);
}
