/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "Casson.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(Casson, 0);
    addToRunTimeSelectionTable(viscosityLaw, Casson, entries);
}
}


Foam::fsbi::Casson::Casson(const checkedDictionary& entries)
:
    viscosity_(entries.positive("viscosity")),
    yieldStress_(entries.positive("yieldStress")),
    smallestSqr_(sqr(entries.positive("smallestRate")))
{}


Foam::scalar Foam::fsbi::Casson::viscosity(const scalar rateSqr) const
{
    const scalar rate = Foam::sqrt(rateSqr + smallestSqr_);
    return sqr(Foam::sqrt(viscosity_) + Foam::sqrt(yieldStress_/rate));
}


Foam::scalar Foam::fsbi::Casson::slope(const scalar rateSqr) const
{
    // rate = (rateSqr + e^2)^(1/2): d(rate^(-1/2)) = -rate^(-5/2)/4
    const scalar rate = Foam::sqrt(rateSqr + smallestSqr_);
    const scalar root = Foam::sqrt(yieldStress_/rate);
    return -(Foam::sqrt(viscosity_) + root)*root/(2*sqr(rate));
}
