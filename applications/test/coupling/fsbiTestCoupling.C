/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Application
    fsbiTestCoupling

Description
    Checks of partitioned coupling with fake partners, whose contraction is
    known: factors of fixed relaxation, passes of all methods for one unknown
    and for an added-mass spectrum, dependent columns, rewind and restart to
    the last bit, failures and bad entries.

Usage
    \b fsbiTestCoupling [OPTION]

      - \par -table \<file\>
        Write measured and theoretical contraction factors as CSV

\*---------------------------------------------------------------------------*/

#include "partner.H"
#include "argList.H"

using namespace Foam;
using namespace Foam::fsbi;

int main(int argc, char *argv[])
{
    argList::noBanner();
    argList::noCheckProcessorDirectories();
    argList::addOption
    (
        "table", "file", "Write contraction factors as CSV"
    );
    argList args(argc, argv, false, true, true);
    checks c;
    checkContraction
    (
        c, args.found("table") ? args.get<fileName>("table") : fileName()
    );
    checkExplicit(c);
    checkSpectrum(c);
    checkSuperlinear(c);
    checkNonlinear(c);
    checkLeastSquares(c);
    checkDependent(c);
    checkSamePass(c);
    checkMemory(c);
    checkRefused(c);
    checkFailures(c);
    return c.finish();
}
