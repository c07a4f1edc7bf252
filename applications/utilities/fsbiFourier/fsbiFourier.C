/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Application
    fsbiFourier

Description
    How fast do relaxed Jacobi and SOR converge, with which factors? Fourier
    analysis on a uniform grid (src/fourier). Needs no case.

Usage
    fsbiFourier [-dict fourierDict]

    \code
    equation        elasticity;     // or Laplace
    method          Jacobi;         // or SOR: Laplace, one direction
    E               1;              // elasticity
    nu              0.3;
    spacing         (1 1 1);        // 0: no such direction (Laplace)
    phiMin          0.0490873852;   // smallest wave, pi/64
    zeroComponents  no;             // waves along axes and planes, too
    steps           (1 2 3 4 5 8);  // numbers of factors to find the best of
    highestFactor   2.95;           // default: no limit
    factors         ((0.6 2.9));    // further ones to be judged
    show            (0.6 0.8 1);    // factors of the curves over waves
    \endcode

    Writes to the folder `fourier`:
        schedules.csv   best factors, their radius, gain per step
        factors.csv     radius over the relaxation factor
        waves.csv       radius over the wave, all components equal
        planes.csv      over two components, phix = phiMin and pi (elasticity)
        pairs.csv       gain per step over two factors (Jacobi)

\*---------------------------------------------------------------------------*/

#include "analysis.H"
#include "argList.H"
#include "IFstream.H"
#include "OSspecific.H"

int main(int argc, char *argv[])
{
    using namespace Foam;

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
            << "There is no file " << name << exit(FatalError);
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
