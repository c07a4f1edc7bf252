/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "Aitken.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(Aitken, 0);
    addToRunTimeSelectionTable(accelerator, Aitken, entries);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::Aitken::Aitken(const checkedDictionary& entries)
:
    firstOmega_(entries.positive("omega", 0.1)),
    maxOmega_(entries.positive("maxOmega", max(scalar(1), firstOmega_))),
    stepOmega_(firstOmega_),
    omega_(firstOmega_),
    hasOld_(false)
{
    if (maxOmega_ < firstOmega_)
    {
        FatalIOErrorInFunction(entries.dict())
            << "Entry 'maxOmega' is " << maxOmega_
            << ", below the first relaxation 'omega', " << firstOmega_
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::fsbi::Aitken::secant(const scalarField& residual) const
{
    const scalar minOmega = min(scalar(1e-6), firstOmega_);
    const List<scalarField> change(1, residual - oldResidual_);
    const scalar norm = product().norm(change[0]);
    if (!(norm > VSMALL))
    {
        return omega_;
    }
    // divided twice: the square of a small norm may be zero
    const scalar part = product().products(change, oldResidual_)[0]/norm;
    const scalar omega = -omega_*(part/norm);
    const scalar size = max(minOmega, min(maxOmega_, mag(omega)));
    return omega < 0 ? -size : size;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsbi::Aitken::update(scalarField& x, const scalarField& residual)
{
    if (hasOld_)
    {
        omega_ = secant(residual);
    }
    x += omega_*residual;
    oldResidual_ = residual;
    hasOld_ = true;
}


void Foam::fsbi::Aitken::forgetPasses()
{
    omega_ = stepOmega_;
    oldResidual_.clear();
    hasOld_ = false;
}


void Foam::fsbi::Aitken::learn()
{
    // the sign is that of one direction, no guess for the next step
    stepOmega_ = min(firstOmega_, mag(omega_));
}


void Foam::fsbi::Aitken::forgetSteps()
{
    stepOmega_ = firstOmega_;
}


void Foam::fsbi::Aitken::saveMemory(dictionary& state) const
{
    state.set("omega", stepOmega_);
}


void Foam::fsbi::Aitken::restoreMemory(const dictionary& state)
{
    stepOmega_ = min(firstOmega_, state.get<scalar>("omega"));
}
