/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Application
    fsbiTestCompilerFlags

Description
    Nonlinear tensor code gives with the shipped compiler flags what it gives
    at -O1. g++ 12's vectoriser breaks such code over OpenFOAM v1912's headers.

\*---------------------------------------------------------------------------*/

#include "checks.H"
#include "tensorField.H"

namespace Foam
{
namespace fsbi
{

namespace plain { List<scalarList> all(const tensorField& F); }
namespace shipped { List<scalarList> all(const tensorField& F); }

} // End namespace fsbi
} // End namespace Foam

using namespace Foam;
using namespace Foam::fsbi;

int main()
{
    checks c;
    tensorField F(20000);
    forAll(F, i)
    {
        tensor H;
        for (direction k = 0; k < 9; ++k)
        {
            H[k] = 0.35*Foam::sin(12.9898*(9*i + k + 1.0));
        }
        F[i] = tensor::I + H;
    }
    const List<scalarList> a(plain::all(F)), b(shipped::all(F));
    const wordList names
    ({
        "invariants", "inverse and cofactors", "eigenvalues",
        "polar decomposition", "neo-Hooke", "StVenantKirchhoff"
    });
    forAll(names, k)
    {
        scalar error = 0;
        bool finite = true;
        forAll(F, i)
        {
            const scalar d = mag(a[k][i] - b[k][i]);
            finite = finite && d < GREAT;
            error = max(error, d/(1 + mag(a[k][i])));
        }
        c.check(names[k] + ": finite", finite);
        c.checkBelow(names[k] + ": as at -O1", error, 1e-10);
    }
    return c.finish();
}
