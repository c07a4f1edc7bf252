/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidMaterial.H"
#include "FlatOutput.H"

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(solidMaterial, 0);
    defineRunTimeSelectionTable(solidMaterial, entries);
}
}

//- Part of its volume below which no cell is meant to be pressed
static const Foam::scalar crushed = 0.3;

Foam::scalar Foam::fsbi::solidMaterial::densityOf
(
    const checkedDictionary& entries
)
{
    return entries.found("density") ? entries.positive("density") : 0;
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::solidMaterial::solidMaterial(const scalar density)
:
    E_(0),
    nu_(0.5),
    mu_(0),
    lambda_(GREAT),
    density_(density),
    viscosity_(0)
{}


Foam::fsbi::solidMaterial::solidMaterial(const checkedDictionary& entries)
:
    E_(entries.positive("E")),
    nu_(entries.get<scalar>("nu")),
    mu_(0),
    lambda_(0),
    density_(densityOf(entries)),
    viscosity_(entries.getOrDefault<scalar>("viscosity", 0))
{
    if (!(nu_ > -1 && nu_ < 0.5))
    {
        FatalIOErrorInFunction(entries.dict())
            << "Entry 'nu' is " << nu_ << ", but nu must lie in (-1, 0.5); "
            << "0.499 is fine: nearly incompressible solids are solved with "
            << "a pressure of their own" << exit(FatalIOError);
    }
    if (!(viscosity_ >= 0))
    {
        FatalIOErrorInFunction(entries.dict())
            << "Entry 'viscosity' must not be negative, but is " << viscosity_
            << exit(FatalIOError);
    }
    mu_ = 0.5*E_/(1 + nu_);
    lambda_ = E_*nu_/((1 + nu_)*(1 - 2*nu_));
}


Foam::autoPtr<Foam::fsbi::solidMaterial> Foam::fsbi::solidMaterial::New
(
    const dictionary& dict, const wordList& others
)
{
    const checkedDictionary entries(dict);
    const word type(entries.get<word>("type"));
    auto constructor = entriesConstructorTablePtr_->cfind(type);
    if (!constructor.found())
    {
        FatalIOErrorInFunction(dict)
            << "Unknown solid material '" << type
            << "'; valid solid materials are "
            << flatOutput(entriesConstructorTablePtr_->sortedToc())
            << exit(FatalIOError);
    }
    autoPtr<solidMaterial> law(constructor()(entries));
    for (const word& other : others)
    {
        entries.found(other);
    }
    entries.finish();
    return law;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsbi::solidMaterial::energy(const tensor& F) const
{
    return shearEnergy(F) + 0.5*lambda_*sqr(theta(F));
}


Foam::tensor Foam::fsbi::solidMaterial::stress(const tensor& F) const
{
    return shearStress(F) + (lambda_*theta(F))*thetaGradient(F);
}


Foam::tensor Foam::fsbi::solidMaterial::tangent
(
    const tensor& F, const tensor& dF
) const
{
    const tensor gradient(thetaGradient(F));
    return shearTangent(F, dF)
      + (lambda_*(gradient && dF))*gradient
      + (lambda_*theta(F))*thetaTangent(F, dF);
}


Foam::tensor Foam::fsbi::solidMaterial::viscousStress
(
    const tensor& F, const tensor& Fdot
) const
{
    return (2*viscosity_)*(F & symm(F.T() & Fdot));
}


Foam::tensor Foam::fsbi::solidMaterial::viscousTangent
(
    const tensor& F,
    const tensor& Fdot,
    const tensor& dF,
    const tensor& dFdot
) const
{
    return (2*viscosity_)
       *(
            (dF & symm(F.T() & Fdot))
          + (F & symm((dF.T() & Fdot) + (F.T() & dFdot)))
        );
}


Foam::string Foam::fsbi::solidMaterial::warning
(
    const scalar minJ, const scalar minStretch
) const
{
    if (minJ > crushed || flows())
    {
        return string();
    }
    char text[200];
    snprintf
    (
        text, sizeof(text),
        "pressed together to %.2g of its volume in places, against a bulk "
        "modulus of %.3g, which a nu nearer to 0.5 makes larger",
        minJ, lambda_ + 2*mu_/3
    );
    return text;
}
