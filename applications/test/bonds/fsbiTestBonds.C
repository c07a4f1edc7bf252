/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Application
    fsbiTestBonds

Description
    Checks of the bonds: random numbers against published vectors, rate laws
    against tables, rates over a plane against closed forms, and the events
    against exact stochastic processes, also of molecules that are used up,
    within three standard deviations of samples with fixed seeds.

    fsbiTestBonds -meshes 24 40     # no checks: the table of bondRates, for
                                    # meshes of up to 24 cells, 40 seeds

\*---------------------------------------------------------------------------*/

#include "bondChecks.H"

int main(int argc, char* argv[])
{
    if (argc == 4 && std::string(argv[1]) == "-meshes")
    {
        Foam::fsbi::numbersByMesh(std::stoi(argv[2]), std::stoi(argv[3]));
        return 0;
    }
    Foam::fsbi::checks c;
    Foam::fsbi::checkRandom(c);
    Foam::fsbi::checkLaws(c);
    Foam::fsbi::checkContact(c);
    Foam::fsbi::checkKinetics(c);
    Foam::fsbi::checkSpread(c);
    Foam::fsbi::checkEffect(c);
    Foam::fsbi::checkImages(c);
    Foam::fsbi::checkDepletion(c);
    Foam::fsbi::checkStatistics(c);
    return c.finish();
}
