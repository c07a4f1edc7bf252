/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "elasticStencil.H"
#include "syncTools.H"

namespace Foam
{
namespace fsbi
{

//- Smallest over mean variance of the points around a vertex, below which
//  they do not determine a plane
static const scalar planeBelow = 1e-6;

//- Weight, its first and its second moments
static const int nMoments = 10;

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::elasticStencil::elasticStencil
(
    const fvMesh& mesh,
    const UList<solidBoundary::kind>& kinds,
    const labelUList& parts,
    const scalarUList& stiffness
)
:
    mesh_(mesh),
    halo_(mesh),
    vertices_(mesh, halo_.size(), parts),
    stiffness_(stiffness),
    ghostOf_(kinds.size(), -1)
{
    DynamicList<label> ghosts;
    forAll(kinds, i)
    {
        if (kinds[i] != solidBoundary::coupled)
        {
            ghostOf_[i] = ghosts.size();
            ghosts.append(i);
        }
    }
    ghostFaces_.transfer(ghosts);
    setFaces();
    setColumns();
    update();
}


void Foam::fsbi::elasticStencil::addFace
(
    const label facei, const label neighbour, const label neighbourPart,
    DynamicList<label>& between
)
{
    const label part = vertices_.ofCell(mesh_.faceOwner()[facei]);
    const labelUList& corners = mesh_.faces()[facei];
    const auto addVertices = [&](const label ofPart)
    {
        for (const label v : corners)
        {
            faceVertex_.append(vertices_.of(ofPart, v));
        }
    };
    addVertices(part);
    if (part != neighbourPart)
    {
        between.append(face_.size());
        addVertices(neighbourPart);
    }
    face_.append(facei);
    owner_.append(mesh_.faceOwner()[facei]);
    neighbour_.append(neighbour);
    faceStart_.append(faceVertex_.size());
}


void Foam::fsbi::elasticStencil::setFaces()
{
    const label nInternal = mesh_.nInternalFaces();
    labelList parts(mesh_.nFaces() - nInternal);
    forAll(parts, i)
    {
        parts[i] = vertices_.ofCell(mesh_.faceOwner()[nInternal + i]);
    }
    labelList beyond(parts);
    syncTools::swapBoundaryFaceList(mesh_, beyond);
    DynamicList<label> between;
    faceStart_.append(0);
    for (label facei = 0; facei < nInternal; ++facei)
    {
        const label N = mesh_.faceNeighbour()[facei];
        addFace(facei, N, vertices_.ofCell(N), between);
    }
    label halo = mesh_.nCells();
    for (const label patchi : halo_.patches())
    {
        const polyPatch& pp = mesh_.boundaryMesh()[patchi];
        forAll(pp, i)
        {
            const label facei = pp.start() + i;
            addFace(facei, halo++, beyond[facei - nInternal], between);
        }
    }
    forAll(ghostFaces_, g)
    {
        const label b = ghostFaces_[g];
        addFace(nInternal + b, firstGhost() + g, parts[b], between);
    }
    setJoints(between);
}


void Foam::fsbi::elasticStencil::setJoints(const labelUList& faces)
{
    if (vertices_.several())
    {
        jointOf_ = labelList(nFaces(), -1);
    }
    labelList inMesh(faces.size());
    forAll(faces, j)
    {
        jointOf_[faces[j]] = j;
        inMesh[j] = face_[faces[j]];
    }
    joints_.reset(new partJoints(mesh_, vertices_, stiffness_, inMesh));
    ownerShare_ = scalarField(faces.size(), Zero);
}


void Foam::fsbi::elasticStencil::setColumns()
{
    List<DynamicList<label>> columns(vertices_.size());
    forAll(mesh_.pointCells(), v)
    {
        for (const label celli : mesh_.pointCells()[v])
        {
            columns[vertices_.of(vertices_.ofCell(celli), v)].append(celli);
        }
    }
    forAll(ghostFaces_, g)
    {
        for (const label v : mesh_.faces()[face_[firstBoundary() + g]])
        {
            const label part = vertices_.ofCell(owner_[firstBoundary() + g]);
            columns[vertices_.of(part, v)].append(firstGhost() + g);
        }
    }
    forAll(joints_->halves(), i)
    {
        for (const label v : joints_->halves()[i].vertices)
        {
            columns[v].append(firstHalf() + i);
        }
    }
    vertexStart_.setSize(columns.size() + 1);
    vertexStart_[0] = 0;
    forAll(columns, v)
    {
        vertexStart_[v + 1] = vertexStart_[v] + columns[v].size();
    }
    vertexColumn_.setSize(vertexStart_.last());
    forAll(columns, v)
    {
        std::copy
        (
            columns[v].begin(), columns[v].end(),
            vertexColumn_.begin() + vertexStart_[v]
        );
    }
}


Foam::vectorField Foam::fsbi::elasticStencil::centres() const
{
    vectorField result(nColumns());
    std::copy
    (
        mesh_.cellCentres().begin(), mesh_.cellCentres().end(), result.begin()
    );
    for (label i = mesh_.nInternalFaces(); i < nFaces(); ++i)
    {
        result[neighbour_[i]] = result[owner_[i]] + delta_[i];
    }
    forAll(joints_->halves(), i)
    {
        const partJoints::half& h = joints_->halves()[i];
        result[firstHalf() + i] = result[h.cell] + 2*h.delta;
    }
    return result;
}


void Foam::fsbi::elasticStencil::update()
{
    const vectorField& C = mesh_.cellCentres();
    const vectorField& Cf = mesh_.faceCentres();
    const vectorField& Sf = mesh_.faceAreas();
    const label nInternal = mesh_.nInternalFaces();

    area_.setSize(nFaces());
    delta_.setSize(nFaces());
    compact_.setSize(nFaces());
    label i = nInternal;
    for (const label patchi : halo_.patches())
    {
        const vectorField delta(mesh_.boundary()[patchi].delta());
        for (const vector& d : delta)
        {
            delta_[i++] = d;
        }
    }
    forAll(face_, i)
    {
        const label facei = face_[i];
        area_[i] = Sf[facei];
        if (i < nInternal)
        {
            delta_[i] = C[neighbour_[i]] - C[owner_[i]];
        }
        else if (i >= firstBoundary())
        {
            const vector n(normalised(Sf[facei]));
            delta_[i] = 2*(n & (Cf[facei] - C[owner_[i]]))*n;
        }
        compact_[i] = magSqr(area_[i])/(area_[i] & delta_[i]);
    }
    if (vertices_.several())
    {
        updateJoints();
    }
    setVolumes();
    setWeights();
}


void Foam::fsbi::elasticStencil::updateJoints()
{
    joints_->update();
    forAll(compact_, i)
    {
        if (!between(i))
        {
            compact_[i] *= stiffness_[vertices_.ofCell(owner_[i])];
        }
    }
    scalarField series(joints_->joined());
    for (const partJoints::half& h : joints_->halves())
    {
        const label facei = joints_->faces()[h.joint];
        if (mesh_.faceOwner()[facei] == h.cell)
        {
            ownerShare_[h.joint] = 1 - h.share;
            series[h.joint] *= h.share*(1 - h.share);
        }
    }
    forAll(compact_, i)
    {
        if (between(i))
        {
            compact_[i] = series[jointOf_[i]];
        }
    }
}


Foam::scalarField Foam::fsbi::elasticStencil::moments
(
    const vectorField& C
) const
{
    const pointField& x = mesh_.points();
    scalarField result(nMoments*vertices_.size(), Zero);
    for (label v = 0; v < vertices_.size(); ++v)
    {
        scalar* m = result.begin() + nMoments*v;
        for (label j = vertexStart_[v]; j < vertexStart_[v + 1]; ++j)
        {
            const vector d(C[vertexColumn_[j]] - x[vertices_.point(v)]);
            const scalar w = 1/magSqr(d);
            const symmTensor second(w*sqr(d));
            m[0] += w;
            for (direction k = 0; k < 3; ++k)
            {
                m[1 + k] += w*d[k];
            }
            for (direction k = 0; k < 6; ++k)
            {
                m[4 + k] += second[k];
            }
        }
    }
    vertices_.sum<nMoments>(result.begin());
    return result;
}


void Foam::fsbi::elasticStencil::setVolumes()
{
    vertexVolume_.setSize(vertices_.size());
    vertexVolume_ = Zero;
    forAll(mesh_.cells(), celli)
    {
        const labelList& points = vertices_.ofCells()[celli];
        for (const label v : points)
        {
            vertexVolume_[v] += mesh_.cellVolumes()[celli]/points.size();
        }
    }
    vertices_.sum<1>(vertexVolume_.begin());
}


void Foam::fsbi::elasticStencil::setWeights()
{
    const pointField& x = mesh_.points();
    const vectorField C(centres());
    const scalarField sums(moments(C));
    valueWeight_.setSize(vertexColumn_.size());
    gradientWeight_.setSize(vertexColumn_.size());
    for (label v = 0; v < vertices_.size(); ++v)
    {
        const scalar* m = sums.begin() + nMoments*v;
        const vector mean(vector(m[1], m[2], m[3])/m[0]);
        const symmTensor covariance
        (
            symmTensor(m[4], m[5], m[6], m[7], m[8], m[9])/m[0] - sqr(mean)
        );
        if (det(covariance) < planeBelow*pow3(tr(covariance)))
        {
            FatalErrorInFunction
                << "The cells around the point " << x[vertices_.point(v)]
                << " of region "
                << mesh_.name() << " lie in a plane: the gradient there is not"
                << " determined. Refine the mesh there: a body needs two cells"
                << " in every direction" << exit(FatalError);
        }
        const symmTensor inverse(inv(covariance));
        for (label j = vertexStart_[v]; j < vertexStart_[v + 1]; ++j)
        {
            const vector d(C[vertexColumn_[j]] - x[vertices_.point(v)]);
            const scalar w = 1/(magSqr(d)*m[0]);
            gradientWeight_[j] = w*(inverse & (d - mean));
            valueWeight_[j] = w - (gradientWeight_[j] & mean);
        }
    }
}


Foam::tensor Foam::fsbi::elasticStencil::cellMean
(
    const label celli, const tensorField& vertices
) const
{
    const labelList& points = vertices_.ofCells()[celli];
    tensor sum(Zero);
    for (const label v : points)
    {
        sum += vertices[v];
    }
    return sum/points.size();
}
