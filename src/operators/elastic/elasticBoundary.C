/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "elasticBoundary.H"
#include "asVectors.H"
#include "cofactor.H"

Foam::fsbi::elasticBoundary::elasticBoundary
(
    const elasticStencil& stencil,
    const constitutiveState& state,
    const List<solidBoundary::kind>& kinds
)
:
    stencil_(stencil),
    state_(state),
    kinds_(kinds)
{}


Foam::vector Foam::fsbi::elasticBoundary::footToFace(const label ghost) const
{
    const label i = stencil_.firstBoundary() + ghost;
    const label facei = stencil_.face()[i];
    return
        stencil_.mesh().faceCentres()[facei]
      - stencil_.mesh().cellCentres()[stencil_.owner()[i]]
      - 0.5*stencil_.delta()[i];
}


Foam::vector Foam::fsbi::elasticBoundary::deadLoad
(
    const label ghost, const solidBoundary& given
) const
{
    const vector& S = stencil_.area()[stencil_.firstBoundary() + ghost];
    return mag(S)*given.faces[stencil_.ghostFaces()[ghost]];
}


bool Foam::fsbi::elasticBoundary::follows
(
    const label ghost, const solidBoundary& given
) const
{
    const label b = stencil_.ghostFaces()[ghost];
    return given.pressure[b] != 0 || given.follower[b] != vector::zero;
}


Foam::vector Foam::fsbi::elasticBoundary::followerLoad
(
    const label ghost,
    const solidBoundary& given,
    const vector& S,
    const tensor& gradient
) const
{
    if (!follows(ghost, given))
    {
        return Zero;
    }
    const label b = stencil_.ghostFaces()[ghost];
    const vector A(cofactor(tensor::I + gradient) & S);
    return mag(A)*given.follower[b] + pressureLoad(ghost, given, S, gradient);
}


Foam::vector Foam::fsbi::elasticBoundary::pressureLoad
(
    const label ghost,
    const solidBoundary& given,
    const vector& S,
    const tensor& gradient
) const
{
    const scalar p = given.pressure[stencil_.ghostFaces()[ghost]];
    return p != 0 ? -p*(cofactor(tensor::I + gradient) & S) : vector::zero;
}


Foam::vector Foam::fsbi::elasticBoundary::pressureTangent
(
    const label ghost,
    const solidBoundary& given,
    const vector& S,
    const tensor& gradient,
    const tensor& dGradient
) const
{
    const scalar p = given.pressure[stencil_.ghostFaces()[ghost]];
    return
        p != 0
      ? -p*(cofactorTangent(tensor::I + gradient, dGradient) & S)
      : vector::zero;
}


Foam::vector Foam::fsbi::elasticBoundary::loadTangent
(
    const label ghost,
    const solidBoundary& given,
    const vector& S,
    const tensor& gradient,
    const tensor& dGradient
) const
{
    if (!follows(ghost, given))
    {
        return Zero;
    }
    const label b = stencil_.ghostFaces()[ghost];
    const tensor F(tensor::I + gradient);
    const vector A(cofactor(F) & S);
    const vector dA(cofactorTangent(F, dGradient) & S);
    return
        (A & dA)/mag(A)*given.follower[b]
      + pressureTangent(ghost, given, S, gradient, dGradient);
}


void Foam::fsbi::elasticBoundary::addRows
(
    const vectorField& values,
    const tensorField& gradient,
    const vectorField& force,
    const vectorField& given,
    scalar* r
) const
{
    vector* row = asVectors(r);
    vector* ghostRow = row + stencil_.nCells();
    forAll(force, g)
    {
        const label i = stencil_.firstBoundary() + g;
        const label P = stencil_.owner()[i];
        const vector& uP = values[P];
        const vector& uG = values[stencil_.neighbour()[i]];
        switch (kindOf(g))
        {
            case solidBoundary::displacement:
            {
                // parabola through the cell, with its slope, and the face
                const tensor slope(stencil_.cellMean(P, gradient));
                const vector uFoot(uP + (slope & footToFace(g)));
                row[P] -= force[g];
                ghostRow[g] =
                    0.5*(uG - uP) - 2*(given[g] - uFoot)
                  + 0.5*(slope & stencil_.delta()[i]);
                break;
            }
            case solidBoundary::traction:
            {
                row[P] -= given[g];
                ghostRow[g] = this->ghostRow(g, force[g] - given[g]);
                break;
            }
            default:
            {
                const vector n(normalised(stencil_.area()[i]));
                row[P] -= n*(n & force[g]);
                ghostRow[g] = uG - uP + 2*n*(n & uP);
            }
        }
    }
}


Foam::tmp<Foam::vectorField> Foam::fsbi::elasticBoundary::displacement
(
    const vectorField& values, const tensorField& gradient
) const
{
    auto result = tmp<vectorField>::New(kinds_.size(), Zero);
    for (label g = 0; g < stencil_.nGhosts(); ++g)
    {
        const label i = stencil_.firstBoundary() + g;
        const label P = stencil_.owner()[i];
        const vector& uP = values[P];
        const vector& uG = values[stencil_.neighbour()[i]];
        const tensor slope(stencil_.cellMean(P, gradient));
        result.ref()[stencil_.ghostFaces()[g]] =
            0.25*(3*uP + uG) + (slope & footToFace(g))
          + 0.25*(slope & stencil_.delta()[i]);
    }
    return result;
}


Foam::vector Foam::fsbi::elasticBoundary::ghostRow
(
    const label ghost, const vector& force
) const
{
    const label i = stencil_.firstBoundary() + ghost;
    const vector n(normalised(stencil_.area()[i]));
    const vector excess(force/stencil_.compact()[i]);
    return
        (excess - n*(n & excess))/state_.shearModulus()
      + n*(n & excess)/state_.normalStiffness();
}


Foam::vector Foam::fsbi::elasticBoundary::ghostForce
(
    const label ghost, const vector& row
) const
{
    const label i = stencil_.firstBoundary() + ghost;
    const vector n(normalised(stencil_.area()[i]));
    return
        stencil_.compact()[i]
       *(
            state_.shearModulus()*(row - n*(n & row))
          + state_.normalStiffness()*n*(n & row)
        );
}


void Foam::fsbi::elasticBoundary::addLoad
(
    const vectorField& force, scalar* r
) const
{
    vector* row = asVectors(r);
    for (label g = 0; g < stencil_.nGhosts(); ++g)
    {
        const label b = stencil_.ghostFaces()[g];
        if (kinds_[b] == solidBoundary::traction)
        {
            const label i = stencil_.firstBoundary() + g;
            row[stencil_.owner()[i]] -= force[b];
            row[stencil_.nCells() + g] -= ghostRow(g, force[b]);
        }
    }
}


void Foam::fsbi::elasticBoundary::followCells(vector* du) const
{
    for (label g = 0; g < stencil_.nGhosts(); ++g)
    {
        const label i = stencil_.firstBoundary() + g;
        const vector& cell = du[stencil_.owner()[i]];
        vector& ghost = du[stencil_.nCells() + g];
        switch (kindOf(g))
        {
            case solidBoundary::displacement:
                ghost -= cell;
                break;
            case solidBoundary::traction:
                ghost += cell;
                break;
            default:
            {
                const vector n(normalised(stencil_.area()[i]));
                ghost += cell - 2*n*(n & cell);
            }
        }
    }
}
