/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "elasticOperator.H"

Foam::tensor Foam::fsbi::elasticOperator::lawStress(const label v) const
{
    if (material_.linear())
    {
        // 1 + grad u would lose the digits of small strains
        const tensor P
        (
            lawTangent(v, gradient_[v], mixed_ ? pressure_[v] : 0)
        );
        return
            material_.viscosity() > 0
          ? P - material_.viscousStress(F_[v], rate(before_[v] - tensor::I))
          : P;
    }
    const tensor& F = F_[v];
    tensor P
    (
        mixed_
      ? material_.shearStress(F) - pressure_[v]*material_.thetaGradient(F)
      : material_.stress(F)
    );
    if (material_.viscosity() > 0)
    {
        P += material_.viscousStress(F, rate(F - before_[v]));
    }
    return P;
}


Foam::tensor Foam::fsbi::elasticOperator::lawTangent
(
    const label v, const tensor& dF, const scalar dp
) const
{
    const tensor& F = F_[v];
    tensor dP
    (
        mixed_
      ? material_.shearTangent(F, dF)
      - pressure_[v]*material_.thetaTangent(F, dF)
      - dp*material_.thetaGradient(F)
      : material_.tangent(F, dF)
    );
    if (material_.viscosity() > 0)
    {
        dP += material_.viscousTangent
        (
            F, rate(F - before_[v]), dF, rate(dF)
        );
    }
    return dP;
}


Foam::tensor Foam::fsbi::elasticOperator::pushed
(
    const label v, const tensor& P
) const
{
    switch (formulation_)
    {
        case formulation::totalLagrangian:
            return P;
        case formulation::updatedLagrangian:
            return (P & prior_[v].T())/det(prior_[v]);
        default:
            return (tensor::I + gradient_[v]) & inv(F_[v]) & P;
    }
}


Foam::tensor Foam::fsbi::elasticOperator::pushedTangent
(
    const label v, const tensor& dF, const tensor& dP
) const
{
    if (formulation_ != formulation::slowProcess)
    {
        return pushed(v, dP);
    }
    // of F'' S, S = F^-1 P
    const tensor inverse(inv(F_[v]));
    const tensor S(inverse & lawStress(v));
    const tensor dS(inverse & (dP - (dF & S)));
    return (dGradient_[v] & S) + ((tensor::I + gradient_[v]) & dS);
}


void Foam::fsbi::elasticOperator::setStress()
{
    valid_ = true;
    forAll(F_, v)
    {
        F_[v] = (tensor::I + gradient_[v]) & prior_[v];
        if (!material_.defined(F_[v]))
        {
            valid_ = false;
            F_[v] = prior_[v];
        }
        stress_[v] = pushed(v, lawStress(v));
    }
}


Foam::tmp<Foam::symmTensorField>
Foam::fsbi::elasticOperator::vertexStress() const
{
    auto result = tmp<symmTensorField>::New(mesh_.nPoints());
    forAll(result(), v)
    {
        result.ref()[v] = material_.Cauchy(lawStress(v), F_[v]);
    }
    return result;
}
