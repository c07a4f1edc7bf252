/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fluidRegion.H"
#include "bodyCoupling.H"
#include "wettedSurface.H"

Foam::fsbi::surfaceSide Foam::fsbi::fluidRegion::sideOf(const label b) const
{
    if (mesh_.bodyPatch(b) < 0)
    {
        surfaceSide none;
        const bodySurface surface(mesh_.bodies()[b].placedSurface());
        none.nFaces = surface.triangles().size();
        none.nPoints = surface.points().size();
        return none;
    }
    surfaceSide side
    (
        wettedSurface::sideOf
        (
            mesh(), mesh().boundaryMesh()[mesh_.bodyPatch(b)],
            mesh_.cut(b).surface(mesh_.bodies()[b].meshedSurface())
        )
    );
    // points as positions in the list of wall vertices
    const labelList& wall = stokes().wallVertices();
    labelList position(mesh().nPoints(), -1);
    forAll(wall, i)
    {
        position[wall[i]] = i;
    }
    for (label& v : side.points)
    {
        v = position[v];
    }
    return side;
}


void Foam::fsbi::fluidRegion::linkSurfaces
(
    const UList<elasticRows*>& elastic
)
{
    given_.facePoints.clear();
    forAll(elastic, e)
    {
        if (elastic[e]->generation != mesh_.generation())
        {
            elastic[e]->fluid = sideOf(rigidBodies_.size() + e);
            elastic[e]->cut = mesh_.cut(rigidBodies_.size() + e);
            elastic[e]->fluidPatch = mesh_.bodyPatch(rigidBodies_.size() + e);
            elastic[e]->generation = mesh_.generation();
        }
        elastic[e]->setFacePoints(stokes(), given_);
    }
}


Foam::fsbi::solverReport Foam::fsbi::fluidRegion::solve
(
    UList<bodyRows>& rows,
    const UList<elasticRows*>& elastic,
    const UList<vectorField>& displacements
)
{
    evaluateEffects(elastic);
    auto timer = timings_.measure("solve");
    const flowProblem wanted(problem(rows, {}));
    linkSurfaces(elastic);
    forAll(elastic, e)
    {
        const elasticRows& body = *elastic[e];
        body.setVelocity
        (
            stokes(),
            surfaceDisplacement::split(displacements[e], body.solid),
            given_
        );
    }
    return solver_->solve(wanted, x_, traction_);
}


Foam::fsbi::solverReport Foam::fsbi::fluidRegion::correct
(
    UList<bodyRows>& rows,
    const UList<elasticRows*>& elastic,
    const bool first
)
{
    evaluateEffects(elastic);
    auto timer = timings_.measure("solve");
    linkSurfaces(elastic);
    return solver_->correct(problem(rows, elastic), first, x_, traction_);
}


void Foam::fsbi::fluidRegion::finish
(
    const UList<bodyRows>& rows,
    const UList<elasticRows*>& elastic,
    List<sixVector>& loads
)
{
    loads = bodyLoads(stokes(), rows, traction_);
    setFields(rows);
    for (const elasticRows* body : elastic)
    {
        body->setVelocity(stokes(), body->surface(), given_);
    }
    forAll(elastic, e)
    {
        if (mesh_.bodyPatch(rows.size() + e) < 0)
        {
            continue;
        }
        fvPatchVectorField& Up =
            U_->boundaryFieldRef()[mesh_.bodyPatch(rows.size() + e)];
        Up ==
            SubField<vector>
            (
                given_.faces, Up.size(),
                Up.patch().start() - mesh().nInternalFaces()
            );
    }
}
