/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "Carreau.H"
#include "addToRunTimeSelectionTable.H"

#include <cmath>

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(Carreau, 0);
    addToRunTimeSelectionTable(viscosityLaw, Carreau, entries);
}
}


Foam::fsbi::Carreau::Carreau(const checkedDictionary& entries)
:
    atRest_(entries.positive("viscosityAtRest")),
    atHighRates_(entries.getOrDefault<scalar>("viscosityAtHighRates", 0)),
    timeSqr_(sqr(entries.positive("time"))),
    power_((entries.positive("exponent") - 1)/2)
{
    if (!(atHighRates_ >= 0))
    {
        FatalIOErrorInFunction(entries.dict())
            << "Entry 'viscosityAtHighRates' must not be negative, but is "
            << atHighRates_ << exit(FatalIOError);
    }
}


Foam::scalar Foam::fsbi::Carreau::viscosity(const scalar rateSqr) const
{
    return
        atHighRates_
      + (atRest_ - atHighRates_)*std::pow(1 + timeSqr_*rateSqr, power_);
}


Foam::scalar Foam::fsbi::Carreau::slope(const scalar rateSqr) const
{
    return
        (atRest_ - atHighRates_)*power_*timeSqr_
       *std::pow(1 + timeSqr_*rateSqr, power_ - 1);
}
