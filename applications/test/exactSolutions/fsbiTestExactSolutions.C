/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Application
    fsbiTestExactSolutions

Description
    Checks of the exact solutions of elastic solids: equilibrium and the law by
    finite differences, free sides, resultants, values computed independently;
    boundary conditions and errors on meshes, also on several processors
    (mpirun -np 2 fsbiTestExactSolutions -parallel); refusal of mistakes.

\*---------------------------------------------------------------------------*/

#include "exactChecks.H"
#include "argList.H"

using namespace Foam;
using namespace Foam::fsbi;

int main(int argc, char *argv[])
{
    argList::noBanner();
    argList::noCheckProcessorDirectories();
    argList args(argc, argv, false, false, true);
    checks c;
    if (Pstream::parRun())
    {
        checkInParallel(c);
    }
    else
    {
        checkPolylogarithm(c);
        checkSolutions(c);
        checkOnMeshes(c);
    }
    return c.finish();
}
