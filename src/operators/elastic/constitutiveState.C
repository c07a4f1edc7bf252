/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "constitutiveState.H"
#include "PstreamReduceOps.H"

const Foam::Enum<Foam::fsbi::constitutiveState::formulation>
Foam::fsbi::constitutiveState::formulationNames
({
    { formulation::totalLagrangian, "totalLagrangian" },
    { formulation::updatedLagrangian, "updatedLagrangian" },
    { formulation::slowProcess, "slowProcess" },
    { formulation::slowProcessTotalStrain, "slowProcessTotalStrain" }
});

namespace Foam
{
namespace fsbi
{

//- Viscous over elastic stiffness that the stabilisation, which is elastic,
//  still holds
static const scalar mostViscous = 50;

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::constitutiveState::constitutiveState
(
    const word& region,
    const label nPoints,
    const solidMaterial& material,
    const formulation form,
    const bool mixed
)
:
    region_(region),
    material_(material),
    formulation_(form),
    mixed_(mixed),
    deltaT_(GREAT),
    rate_{1, -1, 0},
    valid_(true)
{
    setSize(nPoints);
    if (material.linear() && form != formulation::totalLagrangian)
    {
        FatalErrorInFunction
            << "A linear law holds for small displacements of the stress-free"
            << " body: region " << region << " needs formulation"
            << " totalLagrangian, or StVenantKirchhoff instead of "
            << material.type() << exit(FatalError);
    }
}


void Foam::fsbi::constitutiveState::setSize(const label nPoints)
{
    referenceF_ = tensorField(nPoints, tensor::I);
    oldF_ = referenceF_;
    olderF_ = referenceF_;
    F_ = referenceF_;
    gradient_ = tensorField(nPoints, Zero);
    pressure_ = scalarField(mixed_ ? nPoints : 0, Zero);
    stress_ = gradient_;
}


void Foam::fsbi::constitutiveState::setStep
(
    const scalar deltaT, const scalar oldDeltaT
)
{
    deltaT_ = deltaT;
    rate_[0] = 1/deltaT;
    rate_[1] = -rate_[0];
    rate_[2] = 0;
    if (oldDeltaT > 0)
    {
        const scalar r = deltaT/oldDeltaT;
        rate_[0] = (1 + 2*r)/((1 + r)*deltaT);
        rate_[1] = -(1 + r)/deltaT;
        rate_[2] = sqr(r)/((1 + r)*deltaT);
    }
    if (material_.flows())
    {
        return;
    }
    scalar slowest = material_.viscosity()/material_.mu();
    for (const solidMaterial* law : laws_)
    {
        slowest = max(slowest, law->viscosity()/law->mu());
    }
    const scalar least = slowest/mostViscous;
    if (deltaT < least)
    {
        FatalErrorInFunction
            << "A step of " << deltaT << " is too short for the viscosity of"
            << " region " << region_ << ", which needs " << least
            << " at least (viscosity over " << mostViscous << " mu): take"
            << " longer steps, or less viscosity" << exit(FatalError);
    }
}


Foam::symmTensor Foam::fsbi::constitutiveState::rate(const strained& s) const
{
    return rate_[0]*symm(s.F.T() & s.F) + s.knownRate;
}


Foam::scalar Foam::fsbi::constitutiveState::stiffness() const
{
    const scalar mu = shearModulus();
    return mixed_ ? 4*mu/3 : mu + (mu + material_.lambda())/3;
}


Foam::tensor Foam::fsbi::constitutiveState::lawStress(const strained& s) const
{
    tensor P
    (
        mixed_
      ? s.law.shearStress(s.F) - s.p*s.law.thetaGradient(s.F)
      : s.law.stress(s.F)
    );
    if (s.law.viscosity() > 0)
    {
        P += s.law.viscousStress(s.F, rate(s.F - s.oldF));
    }
    if (s.law.flows())
    {
        P += s.law.flowStress(s.F, rate(s));
    }
    return P;
}


Foam::tensor Foam::fsbi::constitutiveState::lawTangent
(
    const strained& s, const tensor& dF, const scalar dp
) const
{
    tensor dP
    (
        mixed_
      ? s.law.shearTangent(s.F, dF)
      - s.p*s.law.thetaTangent(s.F, dF)
      - dp*s.law.thetaGradient(s.F)
      : s.law.tangent(s.F, dF)
    );
    if (s.law.viscosity() > 0)
    {
        dP += s.law.viscousTangent
        (
            s.F, rate(s.F - s.oldF), dF, rate(dF)
        );
    }
    if (s.law.flows())
    {
        dP += s.law.flowTangent
        (
            s.F, rate(s), dF, twoSymm(rate_[0]*(s.F.T() & dF))
        );
    }
    return dP;
}


Foam::fsbi::constitutiveState::strained Foam::fsbi::constitutiveState::total
(
    const label v
) const
{
    strained s{F_[v], oldF_[v], mixed_ ? pressure_[v] : 0, law(v), Zero};
    if (material_.flows())
    {
        s.knownRate =
            rate_[1]*symm(oldF_[v].T() & oldF_[v])
          + rate_[2]*symm(olderF_[v].T() & olderF_[v]);
    }
    return s;
}


Foam::fsbi::constitutiveState::strained Foam::fsbi::constitutiveState::step
(
    const label v
) const
{
    // of the pressure only what S(F') does not have
    return
    {
        tensor::I + gradient_[v], tensor::I,
        mixed_
      ? pressure_[v] + law(v).lambda()*law(v).theta(referenceF_[v])
      : 0,
        law(v), Zero
    };
}


Foam::tensor Foam::fsbi::constitutiveState::linearStress(const label v) const
{
    // 1 + grad u would lose the digits of small strains
    const strained s(total(v));
    const tensor P(lawTangent(s, gradient_[v], s.p));
    return
        s.law.viscosity() > 0
      ? P - s.law.viscousStress(s.F, rate(s.oldF - tensor::I))
      : P;
}


Foam::tensor Foam::fsbi::constitutiveState::referenceStress(const label v) const
{
    return inv(referenceF_[v]) & law(v).stress(referenceF_[v]);
}


Foam::tensor Foam::fsbi::constitutiveState::pushForward
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


Foam::tensor Foam::fsbi::constitutiveState::meshStress(const label v) const
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


Foam::tensor Foam::fsbi::constitutiveState::tangent
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


Foam::tensor Foam::fsbi::constitutiveState::stressOfPressure
(
    const label v
) const
{
    return
        formulation_ == formulation::slowProcess
      ? law(v).thetaGradient(tensor::I + gradient_[v])
      : pushForward(v, law(v).thetaGradient(F_[v]));
}


Foam::scalar Foam::fsbi::constitutiveState::volumeChange(const label v) const
{
    if (formulation_ == formulation::slowProcess)
    {
        return law(v).theta(referenceF_[v]) + law(v).theta(step(v).F);
    }
    return
        law(v).linear()
      ? law(v).thetaGradient(F_[v]) && gradient_[v]
      : law(v).theta(F_[v]);
}


Foam::scalar Foam::fsbi::constitutiveState::volumeTangent
(
    const label v, const tensor& dH
) const
{
    return
        formulation_ == formulation::slowProcess
      ? law(v).thetaGradient(step(v).F) && dH
      : law(v).thetaGradient(F_[v]) && (dH & referenceF_[v]);
}


void Foam::fsbi::constitutiveState::evaluate()
{
    valid_ = true;
    forAll(F_, v)
    {
        F_[v] = (tensor::I + gradient_[v]) & referenceF_[v];
        if (!law(v).defined(F_[v]))
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
Foam::fsbi::constitutiveState::CauchyStress() const
{
    auto result = tmp<symmTensorField>::New(F_.size());
    forAll(result(), v)
    {
        result.ref()[v] =
            law(v).Cauchy(stress_[v], tensor::I + gradient_[v]);
    }
    return result;
}


bool Foam::fsbi::constitutiveState::valid() const
{
    return returnReduce(valid_, andOp<bool>());
}


Foam::scalar Foam::fsbi::constitutiveState::normalStiffness() const
{
    return 2*shearModulus() + (mixed_ ? 0 : material_.lambda());
}


Foam::scalar Foam::fsbi::constitutiveState::compliance(const label v) const
{
    const scalar shear = material_.flows() ? shearModulus() : law(v).mu();
    return 1/law(v).lambda() + 1/(2*shear);
}


void Foam::fsbi::constitutiveState::endStep()
{
    olderF_ = oldF_;
    oldF_ = F_;
    if (carriesOn())
    {
        referenceF_ = F_;
    }
}
