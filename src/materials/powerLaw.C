/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "powerLaw.H"
#include "addToRunTimeSelectionTable.H"

#include <cmath>

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(powerLaw, 0);
    addToRunTimeSelectionTable(viscosityLaw, powerLaw, entries);
}
}


Foam::fsbi::powerLaw::powerLaw(const checkedDictionary& entries)
:
    consistency_(entries.positive("consistency")),
    power_((entries.positive("exponent") - 1)/2),
    smallestSqr_(sqr(entries.positive("smallestRate")))
{}


Foam::scalar Foam::fsbi::powerLaw::viscosity(const scalar rateSqr) const
{
    return consistency_*std::pow(rateSqr + smallestSqr_, power_);
}


Foam::scalar Foam::fsbi::powerLaw::slope(const scalar rateSqr) const
{
    return consistency_*power_*std::pow(rateSqr + smallestSqr_, power_ - 1);
}
