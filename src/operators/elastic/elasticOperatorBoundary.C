/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "elasticOperator.H"

namespace Foam
{
namespace fsbi
{

//- J F^-T, which turns areas
inline tensor cofactor(const tensor& F)
{
    return det(F)*inv(F).T();
}

inline tensor cofactorTangent(const tensor& F, const tensor& dF)
{
    const tensor inverse(inv(F));
    const tensor turned(inverse & dF);
    return det(F)*(tr(turned)*inverse - (turned & inverse)).T();
}

} // End namespace fsbi
} // End namespace Foam


Foam::scalar Foam::fsbi::elasticOperator::normalStiffness() const
{
    return 2*material_.mu() + (mixed_ ? 0 : material_.lambda());
}


Foam::vector Foam::fsbi::elasticOperator::footToFace(const label ghost) const
{
    const label i = stencil_.firstBoundary() + ghost;
    const label facei = stencil_.face()[i];
    return
        mesh_.faceCentres()[facei]
      - mesh_.cellCentres()[stencil_.owner()[i]]
      - 0.5*stencil_.delta()[i];
}


Foam::vector Foam::fsbi::elasticOperator::load(const label ghost) const
{
    const label i = stencil_.firstBoundary() + ghost;
    const label b = stencil_.ghostFaces()[ghost];
    const vector& S = stencil_.area()[i];
    vector t(mag(S)*given_->faces[b]);
    if (given_->pressure[b] != 0 || given_->follower[b] != vector::zero)
    {
        const vector A(cofactor(tensor::I + faceMean(i, gradient_)) & S);
        t += mag(A)*given_->follower[b] - given_->pressure[b]*A;
    }
    return t;
}


Foam::vector Foam::fsbi::elasticOperator::loadTangent
(
    const label ghost, const tensor& dGradient
) const
{
    const label i = stencil_.firstBoundary() + ghost;
    const label b = stencil_.ghostFaces()[ghost];
    if (given_->pressure[b] == 0 && given_->follower[b] == vector::zero)
    {
        return Zero;
    }
    const vector& S = stencil_.area()[i];
    const tensor F(tensor::I + faceMean(i, gradient_));
    const vector A(cofactor(F) & S);
    const vector dA(cofactorTangent(F, dGradient) & S);
    return
        (A & dA)/mag(A)*given_->follower[b] - given_->pressure[b]*dA;
}


void Foam::fsbi::elasticOperator::addBoundary
(
    const vectorField& values,
    const tensorField& gradient,
    const vectorField& force,
    const vectorField& load,
    const bool homogeneous,
    scalar* r
) const
{
    vector* row = reinterpret_cast<vector*>(r);
    vector* ghostRow = row + mesh_.nCells();
    forAll(force, g)
    {
        const label i = stencil_.firstBoundary() + g;
        const label P = stencil_.owner()[i];
        const vector& uP = values[P];
        const vector& uG = values[stencil_.neighbour()[i]];
        const label b = stencil_.ghostFaces()[g];
        switch (kinds_[b])
        {
            case solidBoundary::displacement:
            {
                // parabola through the cell, with its slope, and the face
                const tensor slope(cellMean(P, gradient));
                const vector uFoot(uP + (slope & footToFace(g)));
                const vector uB
                (
                    homogeneous ? vector::zero : given_->faces[b]
                );
                row[P] -= force[g];
                ghostRow[g] =
                    0.5*(uG - uP) - 2*(uB - uFoot)
                  + 0.5*(slope & stencil_.delta()[i]);
                break;
            }
            case solidBoundary::traction:
            {
                const vector n(normalised(stencil_.area()[i]));
                const vector excess
                (
                    (force[g] - load[g])/stencil_.compact()[i]
                );
                row[P] -= load[g];
                ghostRow[g] =
                    (excess - n*(n & excess))/material_.mu()
                  + n*(n & excess)/normalStiffness();
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


Foam::tmp<Foam::vectorField> Foam::fsbi::elasticOperator::boundaryForce() const
{
    auto result = tmp<vectorField>::New(kinds_.size(), Zero);
    forAll(boundaryForce_, g)
    {
        result.ref()[stencil_.ghostFaces()[g]] = boundaryForce_[g];
    }
    return result;
}


Foam::tmp<Foam::vectorField>
Foam::fsbi::elasticOperator::boundaryDisplacement() const
{
    auto result = tmp<vectorField>::New(kinds_.size(), Zero);
    for (label g = 0; g < nGhosts(); ++g)
    {
        const label i = stencil_.firstBoundary() + g;
        const label P = stencil_.owner()[i];
        const vector& uP = values_[P];
        const vector& uG = values_[stencil_.neighbour()[i]];
        const tensor slope(cellMean(P, gradient_));
        result.ref()[stencil_.ghostFaces()[g]] =
            0.25*(3*uP + uG) + (slope & footToFace(g))
          + 0.25*(slope & stencil_.delta()[i]);
    }
    return result;
}


void Foam::fsbi::elasticOperator::followCells(vector* du) const
{
    for (label g = 0; g < nGhosts(); ++g)
    {
        const label i = stencil_.firstBoundary() + g;
        const vector& cell = du[stencil_.owner()[i]];
        vector& ghost = du[mesh_.nCells() + g];
        switch (kinds_[stencil_.ghostFaces()[g]])
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
