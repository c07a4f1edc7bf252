/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wettedSurface.H"
#include "surfaceMap.H"
#include "PatchTools.H"
#include "primitiveFacePatch.H"
#include "syncTools.H"
#include "mathematicalConstants.H"

namespace Foam
{
namespace fsbi
{

//- An order of points that does not depend on how the mesh is distributed: the
//  fluid's mesh is made from it
static labelList orderOf(const pointField& points)
{
    labelList order(identity(points.size()));
    std::sort
    (
        order.begin(), order.end(), [&](const label a, const label b)
        {
            return std::lexicographical_compare
            (
                points[a].begin(), points[a].end(),
                points[b].begin(), points[b].end()
            );
        }
    );
    return order;
}

} // End namespace fsbi
} // End namespace Foam


const Foam::polyPatch& Foam::fsbi::wettedSurface::patchOf(const fvMesh& mesh)
{
    label found = -1;
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (!pp.coupled())
        {
            if (found >= 0)
            {
                FatalErrorInFunction
                    << "Body '" << mesh.name() << "' has more than one patch: "
                    << flatOutput(mesh.boundaryMesh().names()) << ". In a flow"
                    << " its surface is one patch; give it a 'shape', or a mesh"
                    << " with one patch" << exit(FatalError);
            }
            found = pp.index();
        }
    }
    return mesh.boundaryMesh()[found];
}


Foam::fsbi::bodySurface Foam::fsbi::wettedSurface::surfaceOf
(
    const fvMesh& mesh
)
{
    const polyPatch& pp = patchOf(mesh);
    pointField points;
    faceList faces;
    if (Pstream::parRun())
    {
        // of the points of the patch: those of a polyPatch are all of the mesh
        const primitiveFacePatch surface(pp.localFaces(), pp.localPoints());
        labelList merged;
        PatchTools::gatherAndMerge
        (
            1e-9*mesh.bounds().mag(), surface, points, faces, merged
        );
        Pstream::scatter(points);
        Pstream::scatter(faces);
    }
    else
    {
        points = pp.localPoints();
        faces = pp.localFaces();
    }
    const labelList order(orderOf(points));
    const labelList number(invert(order.size(), order));
    List<triFace> triangles(faces.size());
    forAll(faces, i)
    {
        if (faces[i].size() != 3)
        {
            FatalErrorInFunction
                << "The surface of body '" << mesh.name() << "' has a face"
                << " with " << faces[i].size() << " corners, but the fluid's"
                << " mesh needs triangles there: make a mesh of tetrahedra"
                << exit(FatalError);
        }
        triFace& f = triangles[i];
        f = triFace
        (
            number[faces[i][0]], number[faces[i][1]], number[faces[i][2]]
        );
        std::rotate(f.begin(), std::min_element(f.begin(), f.end()), f.end());
    }
    std::sort
    (
        triangles.begin(), triangles.end(),
        [](const triFace& a, const triFace& b)
        {
            return std::lexicographical_compare
            (
                a.begin(), a.end(), b.begin(), b.end()
            );
        }
    );
    return bodySurface(pointField(points, order), triangles);
}


Foam::fsbi::surfaceSide Foam::fsbi::wettedSurface::sideOf
(
    const fvMesh& mesh, const polyPatch& patch, const bodySurface& surface
)
{
    const surfaceMap map(patch, surface);
    surfaceSide side;
    side.nFaces = surface.triangles().size();
    side.nPoints = surface.points().size();
    side.faces = identity(patch.size(), patch.start() - mesh.nInternalFaces());
    side.faceNumbers = map.triangles();

    // also points of processors that have no face there
    labelList number(mesh.nPoints(), -1);
    UIndirectList<label>(number, patch.meshPoints()) = map.points();
    syncTools::syncPointList(mesh, number, maxEqOp<label>(), label(-1));
    const bitSet master(syncTools::getMasterPoints(mesh));
    DynamicList<label> points, numbers;
    DynamicList<bool> contributes;
    forAll(number, v)
    {
        if (number[v] >= 0)
        {
            points.append(v);
            numbers.append(number[v]);
            contributes.append(master[v]);
        }
    }
    side.points.transfer(points);
    side.pointNumbers.transfer(numbers);
    side.contributes.transfer(contributes);
    return side;
}


Foam::fsbi::wettedSurface::wettedSurface
(
    const fvMesh& mesh, const boolList& held, const elasticBody& body,
    const scalar density, const bool curved, const bool mayBeCut
)
:
    name_(mesh.name()),
    curved_(curved),
    mayBeCut_(mayBeCut),
    cornersStandOut_(body.cornersStandOut(curved)),
    density_(density),
    reference_(surfaceOf(mesh)),
    fit_(reference_),
    solid_(sideOf(mesh, patchOf(mesh), reference_)),
    heldPoints_(solid_.nPoints, false),
    heldAt_(solid_.nPoints, Zero),
    displacement_(solid_.nPoints + solid_.nFaces, Zero),
    motion_(1)
{
    vectorField flags(held.size(), Zero);
    forAll(held, i)
    {
        flags[i].x() = held[i];
    }
    const vectorField heldFaces(solid_.collectFaces(flags));
    forAll(heldFaces, i)
    {
        for (const label v : reference_.triangles()[i])
        {
            heldPoints_[v] = heldPoints_[v] || heldFaces[i].x() > 0;
        }
    }
    forAll(heldAt_, i)
    {
        heldAt_[i] = body.displacement(reference_.points()[i]);
    }
    motion_.start(displacement_);
}


void Foam::fsbi::wettedSurface::start(const elasticRows& rows)
{
    follow(rows);
    motion_.start(displacement_);
}


Foam::vectorField Foam::fsbi::wettedSurface::part
(
    const vectorField& both, const bool points
) const
{
    return vectorField
    (
        SubField<vector>
        (
            both, points ? solid_.nPoints : solid_.nFaces,
            points ? 0 : solid_.nPoints
        )
    );
}


void Foam::fsbi::wettedSurface::hold(vectorField& vertices) const
{
    forAll(solid_.points, i)
    {
        const label p = solid_.pointNumbers[i];
        if (heldPoints_[p])
        {
            vertices[solid_.points[i]] = heldAt_[p];
        }
    }
}


void Foam::fsbi::wettedSurface::setSurface(elasticRows& rows) const
{
    rows.heldPoints = heldPoints_;
    rows.heldAt = heldAt_;
    rows.solid = solid_;
}


void Foam::fsbi::wettedSurface::setVelocity(elasticRows& rows) const
{
    rows.velocityCoeff = motion_.velocityCoeff();
    rows.knownPoints = part(motion_.knownVelocity(), true);
    rows.knownFaces = part(motion_.knownVelocity(), false);
}


void Foam::fsbi::wettedSurface::follow(const elasticRows& rows)
{
    const surfaceDisplacement now(rows.surface());
    SubList<vector>(displacement_, solid_.nPoints) = now.points;
    SubList<vector>(displacement_, solid_.nFaces, solid_.nPoints) = now.faces;
}


Foam::vectorField Foam::fsbi::wettedSurface::pointVelocity() const
{
    return
        motion_.knownVelocity().size()
      ? part(vectorField(motion_.velocity(displacement_)), true)
      : vectorField(solid_.nPoints, Zero);
}


const Foam::fsbi::smoothedFacets* Foam::fsbi::wettedSurface::smooth() const
{
    if (!smooth_)
    {
        smooth_.reset(new smoothedFacets(reference_, cornersStandOut_));
    }
    return smooth_.get();
}


Foam::scalar Foam::fsbi::wettedSurface::radius() const
{
    return sqrt(reference_.area()/(4*constant::mathematical::pi));
}


Foam::fsbi::bodySurface Foam::fsbi::wettedSurface::placedSurface() const
{
    return bodySurface
    (
        pointField(reference_.points() + pointDisplacement()),
        reference_.triangles()
    );
}


Foam::fsbi::placement Foam::fsbi::wettedSurface::placed() const
{
    return fit_(pointField(reference_.points() + pointDisplacement()));
}


Foam::point Foam::fsbi::wettedSurface::start() const
{
    return fit_(reference_.points()).centre;
}


void Foam::fsbi::wettedSurface::endStep(const bool stopped)
{
    motion_.endStep(displacement_, vectorField());
    if (stopped)
    {
        motion_.start(displacement_);
    }
}


void Foam::fsbi::wettedSurface::fields(const motionScheme::visitor& visit)
{
    visit("displacement", displacement_);
    motion_.fields(visit);
}
