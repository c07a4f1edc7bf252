/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cellMatrix.H"
#include "zeroGradientFvPatchFields.H"

Foam::fsbi::cellMatrix::cellMatrix
(
    const meshStencil& stencil, const bool symmetric
)
:
    stencil_(stencil),
    symmetric_(symmetric),
    matrix_(stencil.mesh()),
    field_
    (
        IOobject
        (
            "ofMatrix", stencil.mesh().time().timeName(), stencil.mesh(),
            IOobject::NO_READ, IOobject::NO_WRITE, false
        ),
        stencil.mesh(),
        dimensionedScalar(dimless, Zero),
        zeroGradientFvPatchScalarField::typeName
    ),
    here_(stencil.mesh().boundary().size()),
    there_(here_.size())
{
    matrix_.diag() = 0;
    matrix_.upper() = 0;
    if (!symmetric_)
    {
        matrix_.lower() = 0;
    }
    forAll(here_, patchi)
    {
        const label n = stencil.mesh().boundary()[patchi].size();
        here_.set(patchi, new scalarField(n, Zero));
        there_.set(patchi, new scalarField(n, Zero));
    }
}


Foam::label Foam::fsbi::cellMatrix::patchOf
(
    const label i, label& place
) const
{
    const haloExchange& halo = stencil_.halo();
    const label k = i - stencil_.mesh().nInternalFaces();
    label p = halo.patches().size() - 1;
    while (halo.start(p) > k)
    {
        --p;
    }
    place = k - halo.start(p);
    return halo.patches()[p];
}


void Foam::fsbi::cellMatrix::setFace
(
    const label i,
    const scalar a, const scalar b, const scalar c, const scalar d
)
{
    if (i < stencil_.mesh().nInternalFaces())
    {
        matrix_.diag()[stencil_.owner()[i]] += a;
        matrix_.diag()[stencil_.neighbour()[i]] += d;
        matrix_.upper()[i] = b;
        if (!symmetric_)
        {
            matrix_.lower()[i] = c;
        }
        return;
    }
    label place = 0;
    const label patchi = patchOf(i, place);
    matrix_.diag()[stencil_.owner()[i]] += a;
    here_[patchi][place] = a;
    there_[patchi][place] = -b;
}


void Foam::fsbi::cellMatrix::solve
(
    scalarField& x,
    const scalarField& rhs,
    const scalar fall,
    const label maxIterations
) const
{
    dictionary controls;
    controls.set("solver", word(symmetric_ ? "PCG" : "PBiCGStab"));
    controls.set("preconditioner", word(symmetric_ ? "DIC" : "DILU"));
    controls.set("tolerance", scalar(0));
    controls.set("relTol", fall);
    controls.set("maxIter", maxIterations);
    const lduInterfaceFieldPtrsList interfaces
    (
        field_.boundaryField().scalarInterfaces()
    );
    lduMatrix::solver::New
    (
        field_.name(), matrix_, there_, here_, interfaces, controls
    )->solve(x, rhs);
}
