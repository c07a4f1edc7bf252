/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fourthOrderElastic.H"
#include "asVectors.H"
#include "cofactor.H"
#include "cubicSlopes.H"
#include "strainStiffening.H"

namespace Foam
{
namespace fsbi
{

//- Of what the fits do not explain, over mu
static const scalar stabilisation = 4;

//- Viscosity of the same, over sqrt(mu rho) and the distance of cells
static const scalar jumpViscosity = 1;

} // End namespace fsbi
} // End namespace Foam


Foam::vector Foam::fsbi::fourthOrderElastic::unexplained
(
    const label i, const fitted& values
) const
{
    fourNumbers sum = {0, 0, 0, 0};
    const label end = stencil_.faceStart()[i + 1];
    for (label j = stencil_.faceStart()[i]; j < end; ++j)
    {
        sum +=
            four(values.defects.cdata() + 4*neighbourPlace_[j])
          - four(values.defects.cdata() + 4*ownerPlace_[j]);
    }
    return velocity(sum)/(end - stencil_.faceStart()[i]);
}


Foam::tensor Foam::fsbi::fourthOrderElastic::meanGradient
(
    const label i, const fitted& values
) const
{
    tensor sum(Zero);
    for (label p = pointStart_[i]; p < pointStart_[i + 1]; ++p)
    {
        sum += values.gradient[p];
    }
    return sum/(pointStart_[i + 1] - pointStart_[i]);
}


void Foam::fsbi::fourthOrderElastic::setJumps()
{
    jumps_.setSize(stencil_.nFaces());
    forAll(jumps_, i)
    {
        const tensor F(tensor::I + meanGradient(i, now_));
        const vector n(normalised(stencil_.area()[i]));
        jumps_[i] = {unexplained(i, now_), F, cofactor(F) & n};
    }
}


Foam::scalar Foam::fsbi::fourthOrderElastic::stiffness(const label i) const
{
    return
        stabilisation
      + (material_.linear() ? 0 : strainStiffening(jumps_[i].F));
}


Foam::vector Foam::fsbi::fourthOrderElastic::held(const label i) const
{
    const vector& e = jumps_[i].e;
    const vector& a = jumps_[i].normal;
    return
        stiffness(i)*material_.mu()*e
      + material_.lambda()*a*(a & e)
      + damped(i);
}


void Foam::fsbi::fourthOrderElastic::beginStep
(
    const scalar deltaT, const scalar oldDeltaT, const bool inertia
)
{
    elasticOperator::beginStep(deltaT, oldDeltaT, inertia);
    damping_ =
        inertia
      ? jumpViscosity*sqrt(material_.mu()*material_.density())/deltaT
      : 0;
}


Foam::tensor Foam::fsbi::fourthOrderElastic::turn(const label i) const
{
    return material_.linear() ? tensor::I : jumps_[i].F;
}


Foam::vector Foam::fsbi::fourthOrderElastic::damped(const label i) const
{
    if (!damping_)
    {
        return Zero;
    }
    const tensor F(turn(i));
    const vector change((F.T() & jumps_[i].e) - jumpHistory_[i]);
    return damping_*mag(stencil_.delta()[i])*(F & change);
}


Foam::vector Foam::fsbi::fourthOrderElastic::dampedTangent
(
    const label i, const tensor& dF, const vector& de
) const
{
    if (!damping_)
    {
        return Zero;
    }
    const tensor F(turn(i));
    const vector& e = jumps_[i].e;
    vector along(F & (F.T() & de));
    if (!material_.linear())
    {
        along +=
            (dF & ((F.T() & e) - jumpHistory_[i])) + (F & (dF.T() & e));
    }
    return damping_*mag(stencil_.delta()[i])*along;
}


Foam::vector Foam::fsbi::fourthOrderElastic::heldTangent(const label i) const
{
    const vector& e = jumps_[i].e;
    const vector& a = jumps_[i].normal;
    const vector de(unexplained(i, along_));
    const vector n(normalised(stencil_.area()[i]));
    const tensor dF(meanGradient(i, along_));
    const vector da(cofactorTangent(jumps_[i].F, dF) & n);
    const scalar dStiffness =
        material_.linear() ? 0 : strainStiffeningTangent(jumps_[i].F, dF);
    return
        material_.mu()*(stiffness(i)*de + dStiffness*e)
      + material_.lambda()*(da*(a & e) + a*((da & e) + (a & de)))
      + dampedTangent(i, dF, de);
}


template<class Stress, class Held>
void Foam::fsbi::fourthOrderElastic::addFaces
(
    const Stress& stress, const Held& held, vectorField& force, scalar* r
) const
{
    const label nCells = mesh_.nCells();
    const label firstBoundary = stencil_.firstBoundary();
    vector* row = asVectors(r);
    for (label i = 0; i < stencil_.nFaces(); ++i)
    {
        const label P = stencil_.owner()[i];
        const label N = stencil_.neighbour()[i];
        const bool inner = i < firstBoundary;
        vector T((inner ? 1 : 2)*stencil_.compact()[i]*held(i));
        for (label p = pointStart_[i]; p < pointStart_[i + 1]; ++p)
        {
            T += stress(p);
        }
        if (!inner)
        {
            force[i - firstBoundary] = T;
            continue;
        }
        row[P] -= T;
        if (N < nCells)
        {
            row[N] += T;
        }
    }
}


template<class Act>
void Foam::fsbi::fourthOrderElastic::forStrips
(
    const label ghost, const Act& act
) const
{
    if (surface_)
    {
        for (const stripOfFace& strip : strips_[ghost])
        {
            act(pointStart_[strip.number], strip.sign);
        }
    }
}


template<class Stress>
Foam::vector Foam::fsbi::fourthOrderElastic::throughStrips
(
    const label ghost, const Stress& stress
) const
{
    vector sum(Zero);
    forStrips(ghost, [&](const label p, const scalar sign)
    {
        sum += sign*stress(p);
    });
    return sum;
}


template<class Stress>
void Foam::fsbi::fourthOrderElastic::addStrips
(
    const Stress& stress, vectorField& loads
) const
{
    forAll(loads, g)
    {
        if (boundary_.kindOf(g) == solidBoundary::traction)
        {
            loads[g] += throughStrips(g, stress);
        }
    }
}


void Foam::fsbi::fourthOrderElastic::addBoundaryRows
(
    const fitted& values,
    const vectorField& force,
    const vectorField& given,
    scalar* r
) const
{
    vector* row = asVectors(r);
    vector* ghostRow = row + mesh_.nCells();
    forAll(force, g)
    {
        const label i = stencil_.firstBoundary() + g;
        const label P = stencil_.owner()[i];
        const scalar* u = values.faces[g].cdata();
        const vector atFace(u[0], u[1], u[2]);
        switch (boundary_.kindOf(g))
        {
            case solidBoundary::displacement:
                row[P] -= force[g];
                ghostRow[g] = 2*(atFace - given[g]);
                break;
            case solidBoundary::traction:
                row[P] -= given[g];
                ghostRow[g] = boundary_.ghostRow(g, force[g] - given[g]);
                break;
            default:
            {
                const vector n(normalised(stencil_.area()[i]));
                const vector normal(n*(n & force[g]));
                row[P] -= normal;
                ghostRow[g] =
                    2*n*(n & atFace) + boundary_.ghostRow(g, force[g] - normal);
            }
        }
    }
}


Foam::vectorField Foam::fsbi::fourthOrderElastic::givenAtGhosts
(
    const solidBoundary& given
) const
{
    vectorField atGhosts(stencil_.nGhosts(), Zero);
    forAll(atGhosts, g)
    {
        const auto kind = boundary_.kindOf(g);
        if (kind == solidBoundary::displacement)
        {
            atGhosts[g] = given.faces[stencil_.ghostFaces()[g]];
        }
        else if (kind == solidBoundary::traction)
        {
            atGhosts[g] = boundary_.deadLoad(g, given);
            const label i = stencil_.firstBoundary() + g;
            for (label p = pointStart_[i]; p < pointStart_[i + 1]; ++p)
            {
                atGhosts[g] += boundary_.followerLoad
                (
                    g, given, areas_[p], now_.gradient[p]
                );
            }
            forStrips(g, [&](const label p, const scalar sign)
            {
                atGhosts[g] -= sign*boundary_.pressureLoad
                (
                    g, given, areas_[p], now_.gradient[p]
                );
            });
        }
    }
    return atGhosts;
}


void Foam::fsbi::fourthOrderElastic::residual
(
    const scalar* x, const solidBoundary& given, scalar* r
)
{
    std::fill_n(r, size(), scalar(0));
    given_ = &given;
    tangentsKnown_ = false;
    centresKnown_ = false;
    fit(x, now_);
    forAll(state_.gradient(), v)
    {
        const scalar* s = now_.slopes.cdata() + nSlopes*v;
        state_.gradient()[v] =
            tensor(s[0], s[4], s[8], s[1], s[5], s[9], s[2], s[6], s[10]);
    }
    state_.evaluate();
    pointState_.gradient() = now_.gradient;
    pointState_.evaluate();
    const auto stress = [this](const label p)
    {
        return pointState_.stress()[p] & areas_[p];
    };
    setJumps();
    addFaces(stress, [this](const label i){ return held(i); }, boundaryForce_, r);

    vectorField atGhosts(givenAtGhosts(given));
    const vectorField loads(atGhosts);
    addStrips(stress, atGhosts);
    addBoundaryRows(now_, boundaryForce_, atGhosts, r);
    forAll(atGhosts, g)
    {
        // on the surface, not on facets
        if (boundary_.kindOf(g) == solidBoundary::traction)
        {
            boundaryForce_[g] = loads[g];
        }
        else
        {
            boundaryForce_[g] -= throughStrips(g, stress);
        }
    }
}


void Foam::fsbi::fourthOrderElastic::setTangents() const
{
    tangents_.setSize(9*points_.size());
    forAll(points_, p)
    {
        for (direction j = 0; j < 9; ++j)
        {
            tensor dH(Zero);
            dH[j] = 1;
            tangents_[9*p + j] = pointState_.tangent(p, dH, 0) & areas_[p];
        }
    }
    tangentsKnown_ = true;
}


void Foam::fsbi::fourthOrderElastic::applyJacobian
(
    const scalar* dx, scalar* dr
) const
{
    if (!tangentsKnown_)
    {
        setTangents();
    }
    std::fill_n(dr, size(), scalar(0));
    fit(dx, along_);
    const auto stress = [this](const label p)
    {
        const tensor& dH = along_.gradient[p];
        vector sum(dH[0]*tangents_[9*p]);
        for (direction j = 1; j < 9; ++j)
        {
            sum += dH[j]*tangents_[9*p + j];
        }
        return sum;
    };
    vectorField force(stencil_.nGhosts(), Zero);
    const auto held = [this](const label i){ return heldTangent(i); };
    addFaces(stress, held, force, dr);

    vectorField atGhosts(stencil_.nGhosts(), Zero);
    forAll(atGhosts, g)
    {
        const label i = stencil_.firstBoundary() + g;
        const bool loaded =
            boundary_.kindOf(g) == solidBoundary::traction
         && boundary_.follows(g, *given_);
        for (label p = pointStart_[i]; loaded && p < pointStart_[i + 1]; ++p)
        {
            atGhosts[g] += boundary_.loadTangent
            (
                g, *given_, areas_[p], now_.gradient[p], along_.gradient[p]
            );
        }
        if (loaded)
        {
            forStrips(g, [&](const label p, const scalar sign)
            {
                atGhosts[g] -= sign*boundary_.pressureTangent
                (
                    g, *given_, areas_[p], now_.gradient[p],
                    along_.gradient[p]
                );
            });
        }
    }
    addStrips(stress, atGhosts);
    addBoundaryRows(along_, force, atGhosts, dr);
}
