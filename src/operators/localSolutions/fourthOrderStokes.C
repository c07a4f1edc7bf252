/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fourthOrderStokes.H"
#include "processorPolyPatch.H"
#include "syncTools.H"

namespace Foam
{
namespace fsbi
{

//- Fluxes through the inner faces, [momentum, mass], added to r
fsbiWide static void addFluxes
(
    const faceSolutions& faces, const meshStencil& stencil,
    const labelList& innerFaces, const label nCells, const scalar mu,
    const scalar* stabilisation, const scalar stabilisationScale, scalar* r
)
{
    const label* owner = stencil.owner().cdata();
    const label* neighbour = stencil.neighbour().cdata();
    const vector* fromOwner = stencil.fromOwner().cdata();
    const vector* fromNeighbour = stencil.fromNeighbour().cdata();
    const label nFaces = stencil.owner().size();
    for (label i = 0; i < nFaces; ++i)
    {
        const label facei = innerFaces[i];
        const vector& S = faces.areas[facei];
        const scalar k = magSqr(S)/(S & (fromOwner[i] - fromNeighbour[i]));
        const label P = owner[i], N = neighbour[i];
        const scalar D =
            stabilisationScale*0.5*(stabilisation[P] + stabilisation[N]);
        fourNumbers mean, slope, eP, eN;
        faces.evaluate(facei, mean, slope);
        faces.setDefect(facei, &faceCorner::owner, eP);
        faces.setDefect(facei, &faceCorner::neighbour, eN);
        mean += 0.5*(eP + eN);
        slope += k*(eN - eP);

        const fourNumbers area = {S.x(), S.y(), S.z(), 0};
        fourNumbers flux = mu*(mean[3]*area - slope);
        flux[3] = (velocity(mean) & S) - D*mu*k*(eN[3] - eP[3]);
        four(r + 4*P) += flux;
        if (N < nCells)
        {
            four(r + 4*N) -= flux;
        }
    }
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::fourthOrderStokes::fourthOrderStokes
(
    const fvMesh& mesh,
    const scalar mu,
    const boolList& velocityGiven,
    const schemes& s
)
:
    stokesOperator(mesh, mu, velocityGiven),
    fits_(mesh, velocityGiven_, wallVertices_, s.onSurface),
    curvedPatches_(s.curvedPatches)
{
    check();
    setCorners();
    wallEdges_ = fits_.wall().edges();
    wallPoints_ = fits_.wall().ownPoints();
    coefficients_.setSize(stokesPolynomials::nCoefficients*mesh_.nPoints());
    defects_.setSize(4*fits_.nPlaces());
    wallFlux_.setSize(nBoundaryFaces());
    setFaceMoments();
    setBalanced();
}


void Foam::fsbi::fourthOrderStokes::check() const
{
    const char* missing = nullptr;
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        if (pp.coupled() && !isA<processorPolyPatch>(pp))
        {
            missing = "cyclic patches";
        }
    }
    if (missing)
    {
        FatalErrorInFunction
            << "Order 4 of the fluid is not there for " << missing
            << ". Give 'order 2' in 'coupling' of system/fluid/fvSolution"
            << exit(FatalError);
    }
}


void Foam::fsbi::fourthOrderStokes::setCorners()
{
    const vertexCells& cells = fits_.cells();
    const labelList other(cells.otherSides());
    innerFaces_ = identity(mesh_.nInternalFaces());
    for (const label patchi : stencil_.halo().patches())
    {
        const polyPatch& pp = mesh_.boundaryMesh()[patchi];
        innerFaces_.append(identity(pp.size(), pp.start()));
    }
    corners_.setSize(mesh_.nFaces());
    forAll(corners_, facei)
    {
        const label P = cells.toGlobal(mesh_.faceOwner()[facei]);
        const label N = other[facei];
        forAll(corners_[facei], k)
        {
            const label v = mesh_.faces()[facei][k];
            corners_[facei][k] =
            {
                v, fits_.place(v, P), N >= 0 ? fits_.place(v, N) : -1
            };
        }
    }
}


void Foam::fsbi::fourthOrderStokes::setFaceMoments()
{
    faceMoments_.setSize(mesh_.nFaces());
    forAll(faceMoments_, facei)
    {
        FixedList<point, 3> x;
        forAll(x, k)
        {
            x[k] = mesh_.points()[corners_[facei][k].vertex];
        }
        faceMoments_[facei] = simplexMoments(x, mesh_.faceCentres()[facei]);
    }
}


void Foam::fsbi::fourthOrderStokes::update()
{
    stencil_.update();
    setStabilisation();
    fits_.update();
    wallPoints_ = fits_.wall().ownPoints();
    setFaceMoments();
}


Foam::fsbi::faceSolutions Foam::fsbi::fourthOrderStokes::faces() const
{
    return
    {
        coefficients_.cdata(), fits_.perLength().cdata(),
        fits_.origins().cdata(), corners_.cdata(), faceMoments_.cdata(),
        mesh_.faceCentres().cdata(), mesh_.faceAreas().cdata(),
        defects_.cdata(), fits_.wedges()
    };
}


void Foam::fsbi::fourthOrderStokes::residual
(
    const scalar* x,
    const boundaryValues& b,
    const vectorField& force,
    scalar* r,
    vectorField& traction
) const
{
    values_.setSize(mesh_.nCells());
    forAll(values_, i)
    {
        four(values_[i].begin()) = four(x + 4*i)/fourNumbers{1, 1, 1, mu_};
    }
    wallValues_ = b.vertices;
    force_ = force/mu_;
    fits_.fit
    (
        values_, wallValues_, force_, coefficients_.begin(), defects_.begin()
    );
    std::fill_n(r, 4*mesh_.nCells(), scalar(0));
    addFluxes
    (
        faces(), stencil_, innerFaces_, mesh_.nCells(), mu_,
        stabilisation_.cdata(), stabilisationScale, r
    );
    addBoundaryFaces(b, r, traction);
    for (const label patchi : curvedPatches_)
    {
        addStrips(patchi, traction);
    }
}


void Foam::fsbi::fourthOrderStokes::setOnEdges
(
    const label patchi, vectorField& onWall
) const
{
    if (patchi >= 0)
    {
        fits_.wall().setOnEdges(patchi, onWall);
    }
}


Foam::fsbi::faceVelocities Foam::fsbi::fourthOrderStokes::onFaces
(
    const boundaryValues&
) const
{
    FatalErrorInFunction
        << "Order 4 of the fluid is not there for inertia. Give 'order 2' in"
        << " 'coupling' of system/fluid/fvSolution" << exit(FatalError);
    return faceVelocities();
}


Foam::tmp<Foam::tensorField>
Foam::fsbi::fourthOrderStokes::velocityGradients() const
{
    auto result = tmp<tensorField>::New(mesh_.nCells(), Zero);
    forAll(result(), celli)
    {
        tensor& gradient = result.ref()[celli];
        for (const label v : mesh_.cellPoints()[celli])
        {
            const scalar s = fits_.perLength()[v];
            const scalar* c =
                coefficients_.cdata() + stokesPolynomials::nCoefficients*v;
            scalar a[nCubic], g[nCubic];
            const point& centre = mesh_.cellCentres()[celli];
            const vector d(centre - fits_.origins()[v]);
            gradient += 0.25*fits_.wedges().gradient(v, s, centre);
            setMonomials(s*d, a);
            for (direction i = 0; i < 3; ++i)
            {
                vector e(Zero);
                e[i] = 0.25*s;
                setGradientMeans(e, a, g);
                fourNumbers sum = {0, 0, 0, 0};
                addProducts<nCubic>(g, c, sum);
                gradient(i, 0) += sum[0];
                gradient(i, 1) += sum[1];
                gradient(i, 2) += sum[2];
            }
        }
    }
    return result;
}


Foam::tmp<Foam::scalarField>
Foam::fsbi::fourthOrderStokes::defectPower() const
{
    auto result = tmp<scalarField>::New(mesh_.nCells(), Zero);
    scalarField& power = result.ref();
    const faceSolutions solutions(faces());
    forAll(innerFaces_, i)
    {
        const faceGradient face
        (
            stencil_.area()[i], stencil_.fromOwner()[i],
            stencil_.fromNeighbour()[i]
        );
        fourNumbers eP, eN;
        solutions.setDefect(innerFaces_[i], &faceCorner::owner, eP);
        solutions.setDefect(innerFaces_[i], &faceCorner::neighbour, eN);
        const scalar half =
            0.5*mu_*face.compact()*magSqr(velocity(eN - eP));
        power[stencil_.owner()[i]] += half;
        if (stencil_.neighbour()[i] < mesh_.nCells())
        {
            power[stencil_.neighbour()[i]] += half;
        }
    }
    forAll(velocityGiven_, i)
    {
        if (velocityGiven_[i])
        {
            const label facei = mesh_.nInternalFaces() + i;
            fourNumbers e;
            solutions.setDefect(facei, &faceCorner::owner, e);
            power[mesh_.faceOwner()[facei]] +=
                wallCoeff(i)*magSqr(velocity(e));
        }
    }
    return result;
}
