/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Application
    fsbiTestBonds

Description
    Checks of the bonds: random numbers against published vectors, rate laws
    against tables, rates over a plane against closed forms, and the events
    against exact stochastic processes, within three standard deviations of
    samples with fixed seeds.

\*---------------------------------------------------------------------------*/

#include "bondChecks.H"

int main()
{
    Foam::fsbi::checks c;
    Foam::fsbi::checkRandom(c);
    Foam::fsbi::checkLaws(c);
    Foam::fsbi::checkContact(c);
    Foam::fsbi::checkKinetics(c);
    Foam::fsbi::checkSpread(c);
    Foam::fsbi::checkEffect(c);
    Foam::fsbi::checkStatistics(c);
    return c.finish();
}
