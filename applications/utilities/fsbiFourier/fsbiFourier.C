/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Application
    fsbiFourier

Description
    How fast do relaxed Jacobi and SOR converge, with which factors? Fourier
    analysis on a uniform grid (src/fourier). Needs no case.

Usage
    fsbiFourier [-dict fourierDict], see its -help for the entries and tables

\*---------------------------------------------------------------------------*/

#include "analysis.H"
#include "argList.H"
#include "IFstream.H"
#include "OSspecific.H"

int main(int argc, char *argv[])
{
    using namespace Foam;

    argList::addNote
    (
        "How fast relaxed Jacobi and SOR converge, and with which factors, by"
        "\nFourier analysis on a uniform grid. Needs no case. fourierDict:\n\n"
        "    equation        elasticity;     // or Laplace\n"
        "    method          Jacobi;         // or SOR: Laplace, one direction\n"
        "    E               1;              // elasticity; default\n"
        "    nu              0.3;            // elasticity\n"
        "    spacing         (1 1 1);        // default; 0: no such direction"
        "\n"
        "    phiMin          0.0490873852;   // smallest wave, pi/64\n"
        "    zeroComponents  no;             // default; yes: waves along axes"
        "\n"
        "    steps           (1 2 3 4);      // default; how many factors in"
        " turn\n"
        "    highestFactor   2.95;           // default: no limit\n"
        "    factors         ((0.6 2.9));    // further ones to be judged\n"
        "    show            (0.6 0.8 1);    // default; factors of waves.csv"
        "\n\n"
        "Writes to the folder fourier: schedules.csv (best factors, their"
        " radius, gain\nper step), factors.csv (radius over the factor),"
        " waves.csv and planes.csv\n(over the wave), pairs.csv (gain over two"
        " factors)."
    );
    argList::noParallel();
    argList::noFunctionObjects();
    argList::noBanner();
    argList::addOption("dict", "file", "What to do (default: fourierDict)");
    const argList args(argc, argv);
    const fileName name = args.getOrDefault<fileName>("dict", "fourierDict");
    IFstream file(name);
    if (!file.good())
    {
        FatalErrorInFunction
            << "There is no file " << name << "; fsbiFourier -help has one"
            << exit(FatalError);
    }
    const fsbi::analysis analysis((dictionary(file)));
    const fileName folder("fourier");
    mkDir(folder);
    analysis.writeSchedules(folder);
    analysis.writeFactors(folder);
    analysis.writeWaves(folder);
    analysis.writePairs(folder);
    return 0;
}
