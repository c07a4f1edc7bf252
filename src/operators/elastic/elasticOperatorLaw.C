/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "elasticOperator.H"

Foam::tensor Foam::fsbi::elasticOperator::lawStress(const strained& s) const
{
    tensor P
    (
        mixed_
      ? material_.shearStress(s.F) - s.p*material_.thetaGradient(s.F)
      : material_.stress(s.F)
    );
    if (material_.viscosity() > 0)
    {
        P += material_.viscousStress(s.F, rate(s.F - s.oldF));
    }
    return P;
}


Foam::tensor Foam::fsbi::elasticOperator::lawTangent
(
    const strained& s, const tensor& dF, const scalar dp
) const
{
    tensor dP
    (
        mixed_
      ? material_.shearTangent(s.F, dF)
      - s.p*material_.thetaTangent(s.F, dF)
      - dp*material_.thetaGradient(s.F)
      : material_.tangent(s.F, dF)
    );
    if (material_.viscosity() > 0)
    {
        dP += material_.viscousTangent
        (
            s.F, rate(s.F - s.oldF), dF, rate(dF)
        );
    }
    return dP;
}


Foam::fsbi::elasticOperator::strained Foam::fsbi::elasticOperator::total
(
    const label v
) const
{
    return {F_[v], oldF_[v], mixed_ ? pressure_[v] : 0};
}


Foam::fsbi::elasticOperator::strained Foam::fsbi::elasticOperator::step
(
    const label v
) const
{
    // of the pressure only what S(F') does not have
    return
    {
        tensor::I + gradient_[v], tensor::I,
        mixed_
      ? pressure_[v] + material_.lambda()*material_.theta(referenceF_[v])
      : 0
    };
}


Foam::tensor Foam::fsbi::elasticOperator::linearStress(const label v) const
{
    // 1 + grad u would lose the digits of small strains
    const strained s(total(v));
    const tensor P(lawTangent(s, gradient_[v], s.p));
    return
        material_.viscosity() > 0
      ? P - material_.viscousStress(s.F, rate(s.oldF - tensor::I))
      : P;
}


Foam::tensor Foam::fsbi::elasticOperator::referenceStress(const label v) const
{
    return inv(referenceF_[v]) & material_.stress(referenceF_[v]);
}


Foam::tensor Foam::fsbi::elasticOperator::pushForward
(
    const label v, const tensor& P
) const
{
    switch (formulation_)
    {
        case formulation::totalLagrangian:
            return P;
        case formulation::updatedLagrangian:
            return (P & referenceF_[v].T())/det(referenceF_[v]);
        default:
            return (tensor::I + gradient_[v]) & inv(F_[v]) & P;
    }
}


Foam::tensor Foam::fsbi::elasticOperator::meshStress(const label v) const
{
    if (formulation_ == formulation::slowProcess)
    {
        const strained s(step(v));
        return (s.F & referenceStress(v)) + lawStress(s);
    }
    return pushForward
    (
        v, material_.linear() ? linearStress(v) : lawStress(total(v))
    );
}


Foam::tensor Foam::fsbi::elasticOperator::meshTangent
(
    const label v, const tensor& dH, const scalar dp
) const
{
    if (formulation_ == formulation::slowProcess)
    {
        return (dH & referenceStress(v)) + lawTangent(step(v), dH, dp);
    }
    const strained s(total(v));
    const tensor dF(dH & referenceF_[v]);
    const tensor dP(lawTangent(s, dF, dp));
    if (formulation_ != formulation::slowProcessTotalStrain)
    {
        return pushForward(v, dP);
    }
    // of F'' S, S = F^-1 P
    const tensor inverse(inv(s.F));
    const tensor S(inverse & lawStress(s));
    const tensor dS(inverse & (dP - (dF & S)));
    return (dH & S) + ((tensor::I + gradient_[v]) & dS);
}


Foam::tensor Foam::fsbi::elasticOperator::stressOfPressure
(
    const label v
) const
{
    return
        formulation_ == formulation::slowProcess
      ? material_.thetaGradient(tensor::I + gradient_[v])
      : pushForward(v, material_.thetaGradient(F_[v]));
}


Foam::scalar Foam::fsbi::elasticOperator::volumeChange(const label v) const
{
    if (formulation_ == formulation::slowProcess)
    {
        return material_.theta(referenceF_[v]) + material_.theta(step(v).F);
    }
    return
        material_.linear()
      ? material_.thetaGradient(F_[v]) && gradient_[v]
      : material_.theta(F_[v]);
}


Foam::scalar Foam::fsbi::elasticOperator::volumeTangent
(
    const label v, const tensor& dH
) const
{
    return
        formulation_ == formulation::slowProcess
      ? material_.thetaGradient(step(v).F) && dH
      : material_.thetaGradient(F_[v]) && (dH & referenceF_[v]);
}


void Foam::fsbi::elasticOperator::setStress()
{
    valid_ = true;
    forAll(F_, v)
    {
        F_[v] = (tensor::I + gradient_[v]) & referenceF_[v];
        if (!material_.defined(F_[v]))
        {
            // so that the law can be asked; nobody uses the answer
            valid_ = false;
            gradient_[v] = Zero;
            F_[v] = referenceF_[v];
        }
        stress_[v] = meshStress(v);
    }
}


Foam::tmp<Foam::symmTensorField>
Foam::fsbi::elasticOperator::vertexStress() const
{
    auto result = tmp<symmTensorField>::New(mesh_.nPoints());
    forAll(result(), v)
    {
        result.ref()[v] =
            material_.Cauchy(stress_[v], tensor::I + gradient_[v]);
    }
    return result;
}
