/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Application
    fsbiTestMagnetics

Description
    Checks of magnetics: fields against quadrature, closed forms and Maxwell's
    equations, magnetisations against tables, forces and torques against the
    derivatives of energies, steps against the fall of the energy, what a
    controller orders against what bodies do, designed fields against closed
    forms and the loads of the effect.

\*---------------------------------------------------------------------------*/

#include "magneticChecks.H"

int main()
{
    Foam::fsbi::checks c;
    Foam::fsbi::checkFields(c);
    Foam::fsbi::checkMagnetisations(c);
    Foam::fsbi::checkEffect(c);
    Foam::fsbi::checkSteps(c);
    Foam::fsbi::checkSteering(c);
    Foam::fsbi::checkLeastSquares(c);
    Foam::fsbi::checkDesign(c);
    return c.finish();
}
