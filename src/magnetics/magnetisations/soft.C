/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "soft.H"
#include "dipole.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(soft, 0);
    addToRunTimeSelectionTable(magnetisation, soft, entries);
}
}

namespace Foam
{
namespace fsbi
{

//- Carlson's R_D(x, y, z) by duplication (B.C. Carlson, Numer. Math. 33, 1979)
static scalar RD(scalar x, scalar y, scalar z)
{
    scalar sum = 0, factor = 1, mean = 0;
    for (label n = 0; n < 100; ++n)
    {
        mean = (x + y + 3*z)/5;
        if (max(mag(mean - x), max(mag(mean - y), mag(mean - z))) < 1e-3*mean)
        {
            break;
        }
        const scalar lambda = sqrt(x*y) + sqrt(x*z) + sqrt(y*z);
        sum += factor/(sqrt(z)*(z + lambda));
        factor /= 4;
        x = (x + lambda)/4;
        y = (y + lambda)/4;
        z = (z + lambda)/4;
    }
    const scalar X = 1 - x/mean, Y = 1 - y/mean, Z = 1 - z/mean;
    const scalar a = X*Y, b = Z*Z, c = a - b, d = a - 6*b, e = d + 2*c;
    const scalar series =
        1 + d*(-3.0/14 + 9.0/88*d - 4.5/26*Z*e)
      + Z*(e/6 + Z*(-9.0/22*c + 3.0/26*Z*a));
    return 3*sum + factor*series/(mean*sqrt(mean));
}

} // End namespace fsbi
} // End namespace Foam


Foam::vector Foam::fsbi::demagnetisingFactors(const vector& semiAxes)
{
    const vector a(semiAxes/cmptMax(semiAxes));
    const vector s(cmptMultiply(a, a));
    return
        a.x()*a.y()*a.z()/3
       *vector
        (
            RD(s.y(), s.z(), s.x()),
            RD(s.z(), s.x(), s.y()),
            RD(s.x(), s.y(), s.z())
        );
}


Foam::fsbi::soft::soft(const checkedDictionary& entries)
{
    const scalar chi = entries.positive("susceptibility");
    const vector semiAxes(entries.get<vector>("semiAxes"));
    if (cmptMin(semiAxes) <= 0)
    {
        FatalIOErrorInFunction(entries.dict())
            << "Entry 'semiAxes' must be above zero, but is " << semiAxes
            << exit(FatalIOError);
    }
    const vector N(demagnetisingFactors(semiAxes));
    for (direction d = 0; d < 3; ++d)
    {
        response_[d] = chi/(mu0*(1 + chi*N[d]));
    }
}


Foam::tensor Foam::fsbi::soft::polarisability
(
    const scalar volume, const tensor& R
) const
{
    const tensor inBody
    (
        response_.x(), 0, 0, 0, response_.y(), 0, 0, 0, response_.z()
    );
    return volume*(R & inBody & R.T());
}


Foam::vector Foam::fsbi::soft::moment
(
    const scalar volume, const tensor& R, const vector& B
) const
{
    return polarisability(volume, R) & B;
}


Foam::tensor Foam::fsbi::soft::torqueStiffness
(
    const scalar volume, const tensor&, const vector& B
) const
{
    const scalar spread = cmptMax(response_) - cmptMin(response_);
    return volume*spread*magSqr(B)*tensor::I;
}
