/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "partJoints.H"
#include "processorPolyPatch.H"
#include "syncTools.H"

Foam::fsbi::partJoints::partJoints
(
    const fvMesh& mesh,
    const partVertices& vertices,
    const scalarList& stiffness,
    const labelUList& faces
)
:
    mesh_(mesh),
    vertices_(vertices),
    stiffness_(stiffness),
    faces_(faces),
    joined_(faces.size(), Zero)
{
    DynamicList<label> owned, sent, received;
    forAll(faces_, j)
    {
        const label facei = faces_[j];
        addHalf(mesh.faceOwner()[facei], j);
        if (facei < mesh.nInternalFaces())
        {
            addHalf(mesh.faceNeighbour()[facei], j);
            owned.append(j);
            continue;
        }
        const polyPatch& pp =
            mesh.boundaryMesh()[mesh.boundaryMesh().whichPatch(facei)];
        if (refCast<const coupledPolyPatch>(pp).owner())
        {
            owned.append(j);
            sent.append(j);
        }
        else
        {
            received.append(j);
        }
    }
    owned_.transfer(owned);
    sent_.transfer(sent);
    received_.transfer(received);
    betweenProcessors_ =
        returnReduce(sent_.size() + received_.size(), sumOp<label>()) > 0;
}


void Foam::fsbi::partJoints::addHalf(const label celli, const label joint)
{
    half h;
    h.cell = celli;
    h.joint = joint;
    for (const label v : mesh_.faces()[faces_[joint]])
    {
        h.vertices.append(vertices_.of(vertices_.ofCell(celli), v));
    }
    halves_.append(h);
}


void Foam::fsbi::partJoints::update()
{
    vectorField compact(size(), Zero);
    for (half& h : halves_)
    {
        const label facei = faces_[h.joint];
        const bool owner = mesh_.faceOwner()[facei] == h.cell;
        h.area = (owner ? 1 : -1)*mesh_.faceAreas()[facei];
        h.delta = mesh_.faceCentres()[facei] - mesh_.cellCentres()[h.cell];
        h.compact =
            stiffness_[vertices_.ofCell(h.cell)]*magSqr(h.area)
           /(h.area & h.delta);
        compact[h.joint].x() += h.compact;
    }
    if (betweenProcessors_)
    {
        vectorField beyond(size(), Zero);
        exchange(compact, received_, beyond);
        exchange(compact, sent_, beyond);
        compact += beyond;
    }
    joined_ = compact.component(vector::X);
    for (half& h : halves_)
    {
        h.share = h.compact/joined_[h.joint];
    }
}


void Foam::fsbi::partJoints::exchange
(
    const vectorField& values, const labelList& from, vectorField& result
) const
{
    const label first = mesh_.nInternalFaces();
    vectorField faces(mesh_.nFaces() - first, Zero);
    for (const label j : from)
    {
        faces[faces_[j] - first] = values[j];
    }
    syncTools::swapBoundaryFaceList(mesh_, faces);
    for (const label j : &from == &sent_ ? received_ : sent_)
    {
        result[j] = faces[faces_[j] - first];
    }
}


void Foam::fsbi::partJoints::scatter
(
    const UList<vector>& owned, vectorField& all
) const
{
    all.setSize(size());
    forAll(owned_, i)
    {
        all[owned_[i]] = owned[i];
    }
    if (betweenProcessors_)
    {
        exchange(all, sent_, all);
    }
}


void Foam::fsbi::partJoints::sum
(
    const vectorField& all, UList<vector>& owned
) const
{
    vectorField beyond(size(), Zero);
    if (betweenProcessors_)
    {
        exchange(all, received_, beyond);
    }
    forAll(owned_, i)
    {
        owned[i] = all[owned_[i]] + beyond[owned_[i]];
    }
}
