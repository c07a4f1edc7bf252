/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceCurvature.H"

Foam::fsbi::surfaceCurvature::surfaceCurvature
(
    const derivatives& x,
    const scalar modulus,
    const scalar rest,
    const scalar restArea
)
:
    x_(x),
    modulus_(modulus),
    rest_(rest),
    restArea_(restArea),
    N_(x[0] ^ x[1]),
    J_(mag(N_)),
    a11_(magSqr(x[0])),
    a12_(x[0] & x[1]),
    a22_(magSqr(x[1])),
    P_(a22_*x[2] - 2*a12_*x[3] + a11_*x[4])
{}


Foam::fsbi::surfaceCurvature::derivatives
Foam::fsbi::surfaceCurvature::slope() const
{
    const scalar K = sum();
    const scalar bent = modulus_*(K - rest_)/restArea_;

    // of the energy by P.N and by J
    const scalar s = -bent/sqr(J_);
    const scalar t = bent*(0.5*(K - rest_) - 3*K);
    const vector n(N_/J_);
    const vector byN(s*P_ + t*n);
    const scalar c11 = s*(x_[2] & N_), c12 = s*(x_[3] & N_);
    const scalar c22 = s*(x_[4] & N_);

    derivatives by;
    by[0] = 2*(c22*x_[0] - c12*x_[1]) + (x_[1] ^ byN);
    by[1] = 2*(c11*x_[1] - c12*x_[0]) + (byN ^ x_[0]);
    by[2] = s*a22_*N_;
    by[3] = -2*s*a12_*N_;
    by[4] = s*a11_*N_;
    return by;
}


Foam::fsbi::surfaceCurvature::derivatives
Foam::fsbi::surfaceCurvature::slopeTangent
(
    const derivatives& dx
) const
{
    const scalar K = sum();
    const vector n(N_/J_);
    const vector dN((dx[0] ^ x_[1]) + (x_[0] ^ dx[1]));
    const scalar dJ = n & dN;
    const vector dn((dN - n*dJ)/J_);
    const scalar da11 = 2*(x_[0] & dx[0]), da22 = 2*(x_[1] & dx[1]);
    const scalar da12 = (dx[0] & x_[1]) + (x_[0] & dx[1]);
    const vector dP
    (
        da22*x_[2] + a22_*dx[2] - 2*(da12*x_[3] + a12_*dx[3])
      + da11*x_[4] + a11_*dx[4]
    );
    const scalar dK = -((dP & N_) + (P_ & dN))/pow3(J_) - 3*K*dJ/J_;

    const scalar stiff = modulus_/restArea_;
    const scalar bent = stiff*(K - rest_);
    const scalar s = -bent/sqr(J_);
    const scalar t = bent*(0.5*(K - rest_) - 3*K);
    const scalar ds = -stiff*dK/sqr(J_) - 2*s*dJ/J_;
    const scalar dt = stiff*dK*(2*rest_ - 5*K);
    const vector byN(s*P_ + t*n);
    const vector dByN(ds*P_ + s*dP + dt*n + t*dn);

    const auto c = [&](const label i){ return s*(x_[i] & N_); };
    const auto dc = [&](const label i)
    {
        return ds*(x_[i] & N_) + s*((dx[i] & N_) + (x_[i] & dN));
    };
    const vector dsN(ds*N_ + s*dN);

    derivatives by;
    by[0] =
        2*(dc(4)*x_[0] + c(4)*dx[0] - dc(3)*x_[1] - c(3)*dx[1])
      + (dx[1] ^ byN) + (x_[1] ^ dByN);
    by[1] =
        2*(dc(2)*x_[1] + c(2)*dx[1] - dc(3)*x_[0] - c(3)*dx[0])
      + (dByN ^ x_[0]) + (byN ^ dx[0]);
    by[2] = da22*s*N_ + a22_*dsN;
    by[3] = -2*(da12*s*N_ + a12_*dsN);
    by[4] = da11*s*N_ + a11_*dsN;
    return by;
}
