/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fourthOrderStokes.H"

Foam::fsbi::fourthOrderStokes::fourthOrderStokes
(
    const fvMesh& mesh, const scalar mu, const boolList& velocityGiven
)
:
    stokesOperator(mesh, mu, velocityGiven),
    fits_(mesh, velocityGiven_, wallVertices_)
{
    check();
    setCorners();
    wallEdges_ = fits_.wall().edges();
    wallPoints_ = fits_.wall().points();
    values_.setSize(4*mesh_.nCells());
    coefficients_.setSize(stokesPolynomials::nCoefficients*mesh_.nPoints());
    defects_.setSize(4*fits_.cellVertex().size());
    wallFlux_.setSize(nBoundaryFaces());
    setFaceMoments();
    setBalanced();
}


void Foam::fsbi::fourthOrderStokes::check() const
{
    const char* missing = nullptr;
    if (UPstream::parRun())
    {
        missing = "several processors";
    }
    else if (stencil_.halo().size())
    {
        missing = "cyclic patches";
    }
    else if (!closed())
    {
        missing = "patches of given traction";
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
    const label nInternal = mesh_.nInternalFaces();
    const auto place = [&](const label celli, const label v)
    {
        label k = 4*celli;
        while (fits_.cellVertex()[k] != v)
        {
            ++k;
        }
        return k;
    };
    corners_.setSize(mesh_.nFaces());
    forAll(corners_, facei)
    {
        forAll(corners_[facei], k)
        {
            const label v = mesh_.faces()[facei][k];
            corners_[facei][k] =
            {
                v,
                place(mesh_.faceOwner()[facei], v),
                facei < nInternal ? place(mesh_.faceNeighbour()[facei], v) : -1
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
    wallPoints_ = fits_.wall().points();
    setFaceMoments();
}


void Foam::fsbi::fourthOrderStokes::evaluate
(
    const label facei, faceValue& q
) const
{
    const point& Cf = mesh_.faceCentres()[facei];
    const vector S(mesh_.faceAreas()[facei]/3);
    fourNumbers mean = {0, 0, 0, 0}, slope = mean;
    for (const corner& at : corners_[facei])
    {
        const scalar s = fits_.perLength()[at.vertex];
        const scalar* c =
            coefficients_.cdata() + stokesPolynomials::nCoefficients*at.vertex;
        scalar a[nCubic], g[nCubic];
        setMonomialMeans
        (
            Cf - mesh_.points()[at.vertex], faceMoments_[facei], s, a
        );
        setGradientMeans(s*S, a, g);
        for (label k = 0; k < nCubic; ++k)
        {
            const fourNumbers ck = four(c + 4*k);
            mean += a[k]*ck;
            slope += g[k]*ck;
        }
    }
    q.mean = mean/3.0;
    q.slope = slope;
}


Foam::fsbi::fourNumbers Foam::fsbi::fourthOrderStokes::defect
(
    const label facei, label corner::* side
) const
{
    fourNumbers sum = {0, 0, 0, 0};
    for (const corner& at : corners_[facei])
    {
        sum += four(defects_.cdata() + 4*(at.*side));
    }
    return sum/3.0;
}


void Foam::fsbi::fourthOrderStokes::addInnerFaces(scalar* r) const
{
    const label* owner = stencil_.owner().cdata();
    const label* neighbour = stencil_.neighbour().cdata();
    for (label facei = 0; facei < mesh_.nInternalFaces(); ++facei)
    {
        const vector& S = stencil_.area()[facei];
        const scalar k =
            magSqr(S)
           /(
                S
              & (
                    stencil_.fromOwner()[facei]
                  - stencil_.fromNeighbour()[facei]
                )
            );
        const label P = owner[facei], N = neighbour[facei];
        faceValue q;
        evaluate(facei, q);
        const fourNumbers eP = defect(facei, &corner::owner);
        const fourNumbers eN = defect(facei, &corner::neighbour);
        const fourNumbers value = q.mean + 0.5*(eP + eN);
        const fourNumbers slope = q.slope + k*(eN - eP);
        const scalar D = 0.5*(stabilisation_[P] + stabilisation_[N]);
        const vector t(mu_*(velocity(slope) - value[3]*S));
        const scalar flux = (velocity(value) & S) - D*mu_*k*(eN[3] - eP[3]);
        const fourNumbers out = {-t.x(), -t.y(), -t.z(), flux};
        four(r + 4*P) += out;
        four(r + 4*N) -= out;
    }
}


void Foam::fsbi::fourthOrderStokes::residual
(
    const scalar* x,
    const boundaryValues& b,
    scalar* r,
    vectorField& traction
) const
{
    for (label i = 0; i < mesh_.nCells(); ++i)
    {
        four(values_.begin() + 4*i) =
            four(x + 4*i)/fourNumbers{1, 1, 1, mu_};
    }
    fits_.fit
    (
        values_.cdata(), b.vertices, coefficients_.begin(), defects_.begin()
    );
    std::fill_n(r, 4*mesh_.nCells(), scalar(0));
    addInnerFaces(r);
    addBoundaryFaces(b, r, traction);
}


void Foam::fsbi::fourthOrderStokes::addAdvection
(
    const scalarField&, const boundaryValues&, scalar*
) const
{
    FatalErrorInFunction
        << "Order 4 of the fluid is not there for inertia. Give 'order 2' in"
        << " 'coupling' of system/fluid/fvSolution" << exit(FatalError);
}


Foam::tmp<Foam::tensorField>
Foam::fsbi::fourthOrderStokes::velocityGradients() const
{
    auto result = tmp<tensorField>::New(mesh_.nCells(), Zero);
    const labelList& vertices = fits_.cellVertex();
    forAll(vertices, place)
    {
        const label v = vertices[place], celli = place/4;
        const scalar s = fits_.perLength()[v];
        const scalar* c =
            coefficients_.cdata() + stokesPolynomials::nCoefficients*v;
        scalar a[nCubic], g[nCubic];
        setMonomials(s*(mesh_.cellCentres()[celli] - mesh_.points()[v]), a);
        for (direction i = 0; i < 3; ++i)
        {
            vector e(Zero);
            e[i] = 0.25*s;
            setGradientMeans(e, a, g);
            for (label k = 0; k < nCubic; ++k)
            {
                for (direction j = 0; j < 3; ++j)
                {
                    result.ref()[celli](i, j) += g[k]*c[4*k + j];
                }
            }
        }
    }
    return result;
}
