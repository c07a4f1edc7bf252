/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// Bodies that come to a patch where they may leave, or into the domain, and images
// of those that cross cyclic patches

#include "fluidMesh.H"
#include "imageChoice.H"

namespace Foam
{
namespace fsbi
{

//- Parts of a step's way that are looked at, at most
static const label mostPieces = 100;

//- Smallest distance of points, moved, from a surface; GREAT beyond the reach
static scalar distanceOf
(
    const triangleTree& surface, const pointField& points, const vector& by,
    const scalar reach
)
{
    scalar nearest = reach;
    bool some = false;
    for (const point& p : points)
    {
        scalar distance;
        if (surface.find(p + by, nearest, distance))
        {
            nearest = min(nearest, distance);
            some = true;
        }
    }
    return some ? nearest : GREAT;
}

} // End namespace fsbi
} // End namespace Foam


Foam::word Foam::fsbi::fluidMesh::reached
(
    const label bodyi, const wordList& open, const scalar dt
) const
{
    if (bodyi == followed_)
    {
        return word();
    }
    const immersedBody& body = bodies_[bodyi];
    vector way(dt*linear(body.motion()));
    if (followed_ >= 0)
    {
        way -= dt*direction_*(direction_ & linear(bodies_[followed_].motion()));
    }
    const bodySurface surface(body.meshedSurface());
    const scalar edge = surface.meanEdge();
    const label pieces =
        1 + label(min(mag(way)/edge, scalar(mostPieces - 1)));
    const pointField points(surface.points() + (referenceShift_ - shift()));
    for (const word& patch : open)
    {
        const triangleTree* tree = patchTree(patch);
        const scalar now =
            tree ? distanceOf(*tree, points, Zero, edge + mag(way)) : GREAT;
        for (label i = 1; now < GREAT && i <= pieces; ++i)
        {
            const scalar then =
                distanceOf(*tree, points, i*way/pieces, edge);
            if (then < min(edge, now))
            {
                return patch;
            }
        }
    }
    return word();
}


bool Foam::fsbi::fluidMesh::hasRoom(const immersedBody& body) const
{
    const bodySurface surface(body.meshedSurface());
    const scalar edge = surface.meanEdge();
    const vector moved(shift() - referenceShift_);
    DynamicList<vector> ways(images_);
    ways.append(Zero);
    bool room =
        distanceOf(boundary_(), surface.points(), -moved, edge) == GREAT;
    for (const immersedBody& other : bodies_)
    {
        if (!room || &other == &body || !other.present())
        {
            continue;
        }
        for (const vector& way : ways)
        {
            const bodySurface there
            (
                other.meshedSurface().transformed(tensor::I, way)
            );
            room =
                room
             && distanceOf(triangleTree(there), surface.points(), Zero, edge)
             == GREAT
             && distanceOf(triangleTree(surface), there.points(), Zero, edge)
             == GREAT
             && there.winding(surface.points()[0]) < 0.5
             && surface.winding(there.points()[0]) < 0.5;
        }
    }
    return room;
}


void Foam::fsbi::fluidMesh::chooseImages()
{
    List<vector> taken;
    if (Pstream::master())
    {
        const List<period> periods(mesher_->periods());
        images_ = imagesOf(periods);
        DynamicList<point> centres;
        DynamicList<scalar> radii;
        DynamicList<boundBox> boxes;
        for (const immersedBody& body : present_)
        {
            centres.append(body.placed().centre);
            radii.append(body.radius());
            boxes.append(body.placedSurface().bounds());
        }
        const vectorField ways
        (
            imageChoice(periods, centres, radii, boxes, shift())
        );
        label b = 0;
        for (const vector& way : ways)
        {
            present_[b++].setImage(way);
        }
        taken = imagesTaken();
    }
    Pstream::scatter(images_);
    Pstream::scatter(taken);
    takeImages(taken);
}


Foam::List<Foam::vector> Foam::fsbi::fluidMesh::imagesTaken() const
{
    List<vector> taken(bodies_.size());
    forAll(bodies_, b)
    {
        taken[b] = bodies_[b].toImage();
    }
    return taken;
}


void Foam::fsbi::fluidMesh::takeImages(const UList<vector>& images)
{
    forAll(bodies_, b)
    {
        bodies_[b].setImage(images[b]);
    }
}


void Foam::fsbi::fluidMesh::confine(const string& why)
{
    confined_ = confined_.empty() ? why : confined_;
    if (images_.empty())
    {
        return;
    }
    images_.clear();
    readDomain();
    outcome inCell;
    if (Pstream::master())
    {
        mesher_->close();
        inCell = mesher_->placed
        (
            namesOf(present_), meshedSurfaces(present_), shift()
        );
    }
    string reason(inCell.reason);
    Pstream::scatter(reason);
    if (reason.size() || max(mag(vectorField(imagesTaken()))) > 0)
    {
        FatalErrorInFunction
            << (reason.size() ? reason : string("A body is out of the cell"))
            .c_str() << ". Bodies cross cyclic patches in other scenes, but here"
            << " they may not, as " << confined_.c_str() << exit(FatalError);
    }
    setReference();
}
