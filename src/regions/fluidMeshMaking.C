/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// How the fluid's mesh is made, and healed where it has become bad

#include "fluidMesh.H"

Foam::List<Foam::fsbi::surfaceInGaps> Foam::fsbi::fluidMesh::refinedSurfaces
(
    const bool deforming
) const
{
    List<shapeInGap> shapes(present_.size());
    forAll(present_, b)
    {
        const immersedBody& body = present_[b];
        shapes[b].smooth =
            deforming && body.mayBeCut() ? body.smooth() : nullptr;
        if (body.hasShape())
        {
            shapes[b].onto = [&body](const point& p)
            {
                return body.onMeshedShape(p);
            };
        }
    }
    return mesher_->refined(meshedSurfaces(present_), shapes, shift());
}


Foam::fsbi::outcome Foam::fsbi::fluidMesh::generate
(
    const std::function<void()>& release
)
{
    readDomain();
    if (withoutBodies_)
    {
        const bool here = Pstream::master();
        replace(here ? domain_->lists() : meshLists(), {}, release);
        return outcome();
    }
    const List<vector> before(imagesTaken());
    chooseImages();
    meshLists whole;
    List<surfaceInGaps> surfaces(ownSurfaces(present_));
    if (Pstream::master())
    {
        const auto attempt = [&](const bool deforming)
        {
            surfaces = refinedSurfaces(deforming);
            whole = mesher_->generate
            (
                namesOf(present_), surfacesOf(surfaces), shift(), finestEdge()
            );
        };
        attempt(true);
        if (!whole.valid() && anyCut(surfaces))
        {
            Info<< "Triangles of elastic bodies are not cut in gaps: "
                << whole.failure.c_str() << endl;
            attempt(false);
        }
    }
    string reason(whole.failure);
    Pstream::scatter(reason);
    Pstream::scatter(whole.apart);
    if (!reason.empty())
    {
        takeImages(before);
        return outcome::failed(reason + narrowGap(whole.apart));
    }
    if (Pstream::master())
    {
        fresh_ = freshMesh
        (
            whole, mesher_->sizes(surfacesOf(surfaces), shift(), finestEdge())
        );
    }
    Pstream::scatter(fresh_);
    for (surfaceInGaps& body : surfaces)
    {
        Pstream::scatter(body.surface);
        Pstream::scatter(body.cut);
    }
    replace(whole, std::move(surfaces), release);
    return outcome();
}


void Foam::fsbi::fluidMesh::replace
(
    const meshLists& whole,
    List<surfaceInGaps>&& surfaces,
    const std::function<void()>& release
)
{
    release();
    if (mesh_)
    {
        replaceRegionMesh(mesh_(), whole);
    }
    else
    {
        mesh_ = makeRegionMesh(time_, name_, whole);
    }
    ++generation_;
    surfaces_ = std::move(surfaces);
}


Foam::fsbi::outcome Foam::fsbi::fluidMesh::heal
(
    const remeshControls& limits,
    const std::function<void()>& release
)
{
    readDomain();
    meshLists whole(wholeLists(mesh()));
    List<surfaceInGaps> cut(motion_->surfaces());
    const List<bodySurface> surfaces(surfacesOf(cut));
    if (Pstream::master() && whole.valid())
    {
        whole.failure =
            mesher_->placed(namesOf(present_), surfaces, shift()).reason;
    }
    if (Pstream::master() && whole.valid())
    {
        whole.failure = fsbi::heal
        (
            whole, limits, fresh_,
            mesher_->sizes(surfaces, shift(), finestEdge()), namesOf(present_)
        ).reason;
    }
    string reason(whole.failure);
    Pstream::scatter(reason);
    if (!reason.empty())
    {
        return outcome::failed(reason);
    }
    replace(whole, std::move(cut), release);
    return outcome();
}
