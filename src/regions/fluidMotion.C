/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "laplacianMotion.H"
#include "fluidMotion.H"
#include "surfaceMap.H"
#include "polyMesh.H"
#include "syncTools.H"

Foam::wordList Foam::fsbi::namesOf(const UPtrList<immersedBody>& bodies)
{
    wordList names(bodies.size());
    forAll(bodies, b)
    {
        names[b] = bodies[b].name();
    }
    return names;
}


Foam::List<Foam::fsbi::bodySurface> Foam::fsbi::meshedSurfaces
(
    const UPtrList<immersedBody>& bodies
)
{
    List<bodySurface> surfaces(bodies.size());
    forAll(bodies, b)
    {
        surfaces[b] = bodies[b].meshedSurface();
    }
    return surfaces;
}


Foam::List<Foam::fsbi::surfaceInGaps> Foam::fsbi::ownSurfaces
(
    const UPtrList<immersedBody>& bodies
)
{
    List<surfaceInGaps> surfaces(bodies.size());
    forAll(bodies, b)
    {
        surfaces[b].surface = bodies[b].meshedSurface();
    }
    return surfaces;
}


Foam::fsbi::fluidMotion::fluidMotion
(
    const polyMesh& mesh,
    const UPtrList<immersedBody>& bodies,
    const UList<surfaceInGaps>& surfaces,
    const UList<vector>& images
)
:
    mesh_(mesh),
    bodies_(bodies),
    surfaces_(bodies.size()),
    placements_(placementsNow()),
    cuts_(bodies.size())
{
    forAll(bodies_, b)
    {
        surfaces_[b] = surfaces[b].surface;
        setCut(b, surfaces[b].cut);
    }
    create(images);
}


Foam::fsbi::fluidMotion::fluidMotion
(
    const polyMesh& mesh,
    const UPtrList<immersedBody>& bodies,
    const dictionary& saved,
    const UList<vector>& images
)
:
    mesh_(mesh),
    bodies_(bodies),
    surfaces_(bodies.size()),
    placements_(bodies.size()),
    cuts_(bodies.size())
{
    const auto points = saved.get<List<pointField>>("referenceSurfaces");
    const auto centres = saved.get<List<vector>>("referenceCentres");
    const auto orientations =
        saved.get<List<quaternion>>("referenceOrientations");
    const auto triangles =
        saved.getOrDefault<List<List<triFace>>>("referenceTriangles", {});
    const auto cuts =
        saved.getOrDefault<List<cutTriangles>>("referenceCuts", {});
    forAll(bodies_, b)
    {
        surfaces_[b] = bodySurface
        (
            points[b],
            triangles.size() && triangles[b].size()
          ? triangles[b]
          : bodies_[b].meshedSurface().triangles()
        );
        placements_[b] = {centres[b], orientations[b]};
        if (cuts.size())
        {
            setCut(b, cuts[b]);
        }
    }
    create(images);
}


Foam::fsbi::fluidMotion::~fluidMotion()
{}


void Foam::fsbi::fluidMotion::setCut
(
    const label bodyi, const cutTriangles& cut
)
{
    if (cut.empty())
    {
        return;
    }
    if (!bodies_[bodyi].mayBeCut())
    {
        FatalErrorInFunction
            << "In the saved state the fluid's mesh cuts triangles of body '"
            << bodies_[bodyi].name() << "' in gaps. To go on from it takes order"
            << " 2 and the scheme monolithic in 'coupling' of"
            << " system/fluid/fvSolution, as before" << exit(FatalError);
    }
    cuts_[bodyi] = surfaceCut(cut, *bodies_[bodyi].smooth());
}


void Foam::fsbi::fluidMotion::create(const UList<vector>& images)
{
    inverseDistance_.reset
    (
        new inverseDistanceMotion
        (
            mesh_, namesOf(bodies_), surfaces_, placements_, images
        )
    );
    meshPoints_.setSize(bodies_.size());
    surfacePoints_.setSize(bodies_.size());
    forAll(bodies_, b)
    {
        if (bodies_[b].deforms())
        {
            const polyPatch& patch = mesh_.boundaryMesh()[bodies_[b].name()];
            meshPoints_[b] = patch.meshPoints();
            surfacePoints_[b] = surfaceMap(patch, surfaces_[b]).points();
            if (!laplacian_)
            {
                laplacian_.reset(new laplacianMotion(mesh_));
            }
        }
    }
}


Foam::List<Foam::fsbi::placement> Foam::fsbi::fluidMotion::placementsNow() const
{
    List<placement> result(bodies_.size());
    forAll(bodies_, b)
    {
        result[b] = bodies_[b].meshedPlacement();
    }
    return result;
}


Foam::pointField Foam::fsbi::fluidMotion::points(const vector& frameShift) const
{
    pointField x(inverseDistance_->move(placementsNow(), frameShift));
    if (!laplacian_)
    {
        return x;
    }
    vectorField r(x.size(), Zero);
    forAll(bodies_, b)
    {
        if (bodies_[b].deforms())
        {
            const bodySurface now(surface(b));
            forAll(meshPoints_[b], i)
            {
                const label p = meshPoints_[b][i];
                r[p] = now.points()[surfacePoints_[b][i]] - x[p];
            }
        }
    }
    // processors with a point of the patch, but no face of it
    syncTools::syncPointList(mesh_, r, maxMagSqrEqOp<vector>(), vector::zero);
    laplacian_->fill(r);
    x += r;
    return x;
}


bool Foam::fsbi::fluidMotion::refined(const label bodyi) const
{
    return
        surfaces_[bodyi].triangles().size()
     != bodies_[bodyi].meshedSurface().triangles().size();
}


Foam::fsbi::bodySurface Foam::fsbi::fluidMotion::surface
(
    const label bodyi
) const
{
    if (!refined(bodyi))
    {
        return bodies_[bodyi].meshedSurface();
    }
    if (bodies_[bodyi].deforms())
    {
        return cuts_[bodyi].surface(bodies_[bodyi].meshedSurface());
    }
    const placement& then = placements_[bodyi];
    const placement now(bodies_[bodyi].meshedPlacement());
    const tensor R(now.orientation.R() & then.orientation.R().T());
    return surfaces_[bodyi].transformed(R, now.centre - (R & then.centre));
}


Foam::List<Foam::fsbi::surfaceInGaps> Foam::fsbi::fluidMotion::surfaces() const
{
    List<surfaceInGaps> result(bodies_.size());
    forAll(result, b)
    {
        result[b] = {surface(b), cuts_[b].triangles()};
    }
    return result;
}


Foam::scalar Foam::fsbi::fluidMotion::twist() const
{
    return inverseDistance_->twist(placementsNow());
}


void Foam::fsbi::fluidMotion::save(dictionary& state) const
{
    List<pointField> points(bodies_.size());
    List<vector> centres(bodies_.size());
    List<quaternion> orientations(bodies_.size());
    List<List<triFace>> triangles(bodies_.size());
    List<cutTriangles> cuts(bodies_.size());
    forAll(bodies_, b)
    {
        points[b] = surfaces_[b].points();
        if (refined(b))
        {
            triangles[b] = surfaces_[b].triangles();
            cuts[b] = cuts_[b].triangles();
        }
        centres[b] = placements_[b].centre;
        orientations[b] = placements_[b].orientation;
    }
    state.set("referenceSurfaces", points);
    state.set("referenceTriangles", triangles);
    state.set("referenceCuts", cuts);
    state.set("referenceCentres", centres);
    state.set("referenceOrientations", orientations);
}
