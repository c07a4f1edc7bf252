/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fourierChecks.H"

int main()
{
    Foam::fsbi::checks test;
    Foam::fsbi::checkLaplace(test);
    Foam::fsbi::checkElasticity(test);
    Foam::fsbi::checkSchedules(test);
    return test.finish();
}
