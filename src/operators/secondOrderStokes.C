/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "secondOrderStokes.H"
#include "sharedVertices.H"

Foam::fsbi::secondOrderStokes::secondOrderStokes
(
    const fvMesh& mesh,
    const scalar mu,
    const boolList& velocityGiven,
    const schemes& s
)
:
    stokesOperator(mesh, mu, velocityGiven),
    schemes_(s)
{
    const label nCells = mesh.nCells() + stencil_.halo().size();
    vertexValues_.setSize(4*mesh.nPoints());
    values_.setSize(4*nCells);
    gradients_.setSize(12*nCells);
    if (schemes_.gradients != gradientScheme::vertex)
    {
        const bool squares = schemes_.gradients == gradientScheme::leastSquares;
        velocityGradient_.reset(new neighbourGradient(stencil_, squares));
        pressureGradient_.reset(new neighbourGradient(stencil_, squares));
    }
    setGeometry();
}


void Foam::fsbi::secondOrderStokes::update()
{
    stencil_.update();
    setStabilisation();
    setGeometry();
}


void Foam::fsbi::secondOrderStokes::setGeometry()
{
    wallPoints_ = pointField(mesh_.points(), wallVertices_);
    if (velocityGradient_)
    {
        // the weights of the walls are those of gradients through vertices
        stencil_.setFirstOrderWalls();
        velocityGradient_->update(velocityGiven_);
        pressureGradient_->update(boolList(velocityGiven_.size(), false));
    }
}


void Foam::fsbi::secondOrderStokes::setVertexValues
(
    const scalar* x,
    const boundaryValues& b
) const
{
    std::copy_n(x, 4*mesh_.nCells(), values_.begin());
    stencil_.halo().fill(values_.data(), 4);

    const label* start = stencil_.vertexStart().cdata();
    const label* cell = stencil_.vertexCell().cdata();
    const scalar* weight = stencil_.vertexWeight().cdata();
    const label nPoints = mesh_.nPoints();

    for (label v = 0; v < nPoints; ++v)
    {
        scalar sum[4] = {0, 0, 0, 0};
        for (label i = start[v]; i < start[v + 1]; ++i)
        {
            const scalar* xi = values_.cdata() + 4*cell[i];
            const scalar w = weight[i];
            sum[0] += w*xi[0];
            sum[1] += w*xi[1];
            sum[2] += w*xi[2];
            sum[3] += w*xi[3];
        }
        std::copy_n(sum, 4, vertexValues_.begin() + 4*v);
    }

    sharedVertices::sum<4>
    (
        mesh_, vertexValues_.begin(), stencil_.halo().size()
    );

    forAll(wallVertices_, i)
    {
        scalar* value = vertexValues_.begin() + 4*wallVertices_[i];
        value[0] = b.vertices[i].x();
        value[1] = b.vertices[i].y();
        value[2] = b.vertices[i].z();
    }
}


void Foam::fsbi::secondOrderStokes::setVertexGradients() const
{
    const label* start = stencil_.cellStart().cdata();
    const label* vertex = stencil_.cellVertex().cdata();
    const vector* coeff = stencil_.cellCoeff().cdata();
    const label nCells = mesh_.nCells();

    for (label celli = 0; celli < nCells; ++celli)
    {
        scalar g[12] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
        for (label i = start[celli]; i < start[celli + 1]; ++i)
        {
            const scalar* phi = vertexValues_.cdata() + 4*vertex[i];
            const vector& c = coeff[i];
            for (label k = 0; k < 4; ++k)
            {
                g[3*k] += c.x()*phi[k];
                g[3*k + 1] += c.y()*phi[k];
                g[3*k + 2] += c.z()*phi[k];
            }
        }
        std::copy_n(g, 12, gradients_.begin() + 12*celli);
    }
}


void Foam::fsbi::secondOrderStokes::setGradients(const boundaryValues& b) const
{
    if (velocityGradient_)
    {
        velocityGradient_->set
        (
            values_.cdata(), 0, 3, b.faces, gradients_.data()
        );
        pressureGradient_->set
        (
            values_.cdata(), 3, 1, UList<vector>(), gradients_.data()
        );
    }
    else
    {
        setVertexGradients();
    }
    stencil_.halo().fill(gradients_.data(), 12);
}


template<bool linear>
void Foam::fsbi::secondOrderStokes::addInnerFaces(scalar* r) const
{
    const label* owner = stencil_.owner().cdata();
    const label* neighbour = stencil_.neighbour().cdata();
    const vector* area = stencil_.area().cdata();
    const vector* fromOwner = stencil_.fromOwner().cdata();
    const vector* fromNeighbour = stencil_.fromNeighbour().cdata();
    const label nFaces = stencil_.owner().size();
    const label nCells = mesh_.nCells();

    for (label i = 0; i < nFaces; ++i)
    {
        const vector& S = area[i];
        const faceGradient face(S, fromOwner[i], fromNeighbour[i]);
        const label P = owner[i];
        const label N = neighbour[i];
        const scalar* xP = values_.cdata() + 4*P;
        const scalar* xN = values_.cdata() + 4*N;
        const scalar* gP = gradients_.cdata() + 12*P;
        const scalar* gN = gradients_.cdata() + 12*N;

        const scalar p = face.value<linear>(xP[3], xN[3], gP + 9, gN + 9);
        const vector Hu(face.gradient(xP[0], xN[0], gP, gN));
        const vector Hv(face.gradient(xP[1], xN[1], gP + 3, gN + 3));
        const vector Hw(face.gradient(xP[2], xN[2], gP + 6, gN + 6));

        const vector t
        (
            mu_*(Hu & S) - p*S.x(), mu_*(Hv & S) - p*S.y(),
            mu_*(Hw & S) - p*S.z()
        );

        const scalar w = face.weight();
        const scalar D = w*stabilisation_[P] + (1 - w)*stabilisation_[N];
        const scalar flux =
            S.x()*face.value<linear>(xP[0], xN[0], gP, gN)
          + S.y()*face.value<linear>(xP[1], xN[1], gP + 3, gN + 3)
          + S.z()*face.value<linear>(xP[2], xN[2], gP + 6, gN + 6)
          - D*face.compact()*face.jump(xP[3], xN[3], gP + 9, gN + 9);

        scalar* rP = r + 4*P;
        rP[0] -= t.x();
        rP[1] -= t.y();
        rP[2] -= t.z();
        rP[3] += flux;
        if (N < nCells)
        {
            scalar* rN = r + 4*N;
            rN[0] += t.x();
            rN[1] += t.y();
            rN[2] += t.z();
            rN[3] -= flux;
        }
    }
}


Foam::fsbi::faceGradient Foam::fsbi::secondOrderStokes::faceOf
(
    const label i
) const
{
    return faceGradient
    (
        stencil_.area()[i], stencil_.fromOwner()[i], stencil_.fromNeighbour()[i]
    );
}


Foam::fsbi::secondOrderStokes::throughFace
Foam::fsbi::secondOrderStokes::throughWarp
(
    const label k, const faceGradient& face
) const
{
    const label i = stencil_.warpedFaces()[k];
    const tensor& M = stencil_.warp()[k];
    const scalar* gP = gradients_.cdata() + 12*stencil_.owner()[i];
    const scalar* gN = gradients_.cdata() + 12*stencil_.neighbour()[i];
    return
    {
        -(face.mean(gP + 9, gN + 9) & M),
        (face.mean(gP, gN) & M).x()
      + (face.mean(gP + 3, gN + 3) & M).y()
      + (face.mean(gP + 6, gN + 6) & M).z()
    };
}


void Foam::fsbi::secondOrderStokes::addWarp(scalar* r) const
{
    forAll(stencil_.warpedFaces(), k)
    {
        const label i = stencil_.warpedFaces()[k];
        const label P = stencil_.owner()[i];
        const label N = stencil_.neighbour()[i];
        const throughFace out(throughWarp(k, faceOf(i)));
        for (label side = 0; side < (N < mesh_.nCells() ? 2 : 1); ++side)
        {
            scalar* row = r + 4*(side ? N : P);
            const scalar sign = side ? -1 : 1;
            row[0] -= sign*out.force.x();
            row[1] -= sign*out.force.y();
            row[2] -= sign*out.force.z();
            row[3] += sign*out.flux;
        }
    }
}


void Foam::fsbi::secondOrderStokes::residual
(
    const scalar* x,
    const boundaryValues& b,
    const vectorField&,
    scalar* r,
    vectorField& traction
) const
{
    std::fill_n(r, 4*mesh_.nCells(), scalar(0));
    setVertexValues(x, b);
    setGradients(b);
    schemes_.linearFaces ? addInnerFaces<true>(r) : addInnerFaces<false>(r);
    addWarp(r);
    addBoundaryFaces(b, r, traction);
}


Foam::vector Foam::fsbi::secondOrderStokes::velocity
(
    const label celli, const vector& d
) const
{
    const scalar* x = values_.cdata() + 4*celli;
    const scalar* g = gradients_.cdata() + 12*celli;
    return vector
    (
        x[0] + (vector(g[0], g[1], g[2]) & d),
        x[1] + (vector(g[3], g[4], g[5]) & d),
        x[2] + (vector(g[6], g[7], g[8]) & d)
    );
}


Foam::scalar Foam::fsbi::secondOrderStokes::innerFlux
(
    const label i, const vector& meanVelocity
) const
{
    const faceGradient face(faceOf(i));
    const label P = stencil_.owner()[i];
    const label N = stencil_.neighbour()[i];
    const scalar w = face.weight();
    const scalar D = w*stabilisation_[P] + (1 - w)*stabilisation_[N];
    const scalar jump = face.jump
    (
        values_[4*P + 3], values_[4*N + 3],
        gradients_.cdata() + 12*P + 9, gradients_.cdata() + 12*N + 9
    );
    return (stencil_.area()[i] & meanVelocity) - D*face.compact()*jump;
}


Foam::fsbi::faceVelocities Foam::fsbi::secondOrderStokes::onFaces
(
    const boundaryValues& b
) const
{
    const label nFaces = mesh_.nFaces();
    faceVelocities on
    {
        scalarField(nFaces), vectorField(nFaces), vectorField(nFaces, Zero)
    };
    const labelList faces(stencil_.meshFaces());
    forAll(faces, i)
    {
        const vector fromOwner
        (
            velocity(stencil_.owner()[i], stencil_.fromOwner()[i])
        );
        const vector fromNeighbour
        (
            velocity(stencil_.neighbour()[i], stencil_.fromNeighbour()[i])
        );
        on.mean[faces[i]] = 0.5*(fromOwner + fromNeighbour);
        on.jump[faces[i]] = 0.5*(fromOwner - fromNeighbour);
        on.flux[faces[i]] = innerFlux(i, on.mean[faces[i]]);
    }
    forAll(stencil_.warpedFaces(), k)
    {
        const label i = stencil_.warpedFaces()[k];
        on.flux[faces[i]] += throughWarp(k, faceOf(i)).flux;
    }
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        for (label k = 0; !pp.coupled() && k < pp.size(); ++k)
        {
            const label facei = pp.start() + k;
            const label i = facei - mesh_.nInternalFaces();
            const label P = mesh_.faceOwner()[facei];
            const vector d(mesh_.faceCentres()[facei] - mesh_.cellCentres()[P]);
            on.mean[facei] = velocityGiven_[i] ? b.faces[i] : velocity(P, d);
            on.flux[facei] = boundaryFlux_[i];
        }
    }
    return on;
}


Foam::tmp<Foam::tensorField>
Foam::fsbi::secondOrderStokes::velocityGradients() const
{
    auto result = tmp<tensorField>::New(mesh_.nCells());
    forAll(result(), celli)
    {
        const scalar* g = gradients_.cdata() + 12*celli;
        result.ref()[celli] = tensor
        (
            g[0], g[3], g[6], g[1], g[4], g[7], g[2], g[5], g[8]
        );
    }
    return result;
}
