/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "membraneBending.H"
#include "sharedVertices.H"
#include <Eigen/Eigenvalues>

// * * * * * * * * * * * * * * * * Of a vertex * * * * * * * * * * * * * * * //

Foam::fsbi::membraneBending::curvature::curvature
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


Foam::fsbi::membraneBending::derivatives
Foam::fsbi::membraneBending::curvature::slope() const
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


Foam::fsbi::membraneBending::derivatives
Foam::fsbi::membraneBending::curvature::slopeTangent
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


// * * * * * * * * * * * * * * * Of a membrane * * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsbi
{

static vector oneAcross(const vector& n)
{
    const bool alongX = mag(n.x()) > 0.7;
    return normalised(n ^ vector(alongX ? 0 : 1, alongX ? 1 : 0, 0));
}


static scalar product
(
    const membraneBending::derivatives& a,
    const membraneBending::derivatives& b
)
{
    scalar s = 0;
    forAll(a, m)
    {
        s += a[m] & b[m];
    }
    return s;
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::membraneBending::membraneBending
(
    const fvMesh& mesh,
    const label nHalo,
    const List<triFace>& triangles,
    const checkedDictionary& entries
)
:
    mesh_(mesh),
    nHalo_(nHalo),
    triangles_(triangles),
    modulus_(entries.positive("bendingModulus")),
    rest_(mesh.nPoints(), Zero),
    restArea_(mesh.nPoints(), 1)
{
    vectorField normals;
    boolList inside;
    setAreas(normals, inside);
    setWeights(normals);
    forAll(inside, v)
    {
        if (!inside[v])
        {
            area_[v] = counted_[v] = 0;
        }
    }
    const List<derivatives> x(at(mesh.points()));
    forAll(area_, v)
    {
        if (area_[v] > 0)
        {
            const curvature c(x[v], 0, 0, 1);
            restArea_[v] = c.area();
            rest_[v] = c.sum();
        }
    }
    if (entries.found("spontaneousCurvature"))
    {
        rest_ = entries.get<scalar>("spontaneousCurvature");
    }
}


void Foam::fsbi::membraneBending::setAreas
(
    vectorField& normals, boolList& inside
)
{
    const pointField& x = mesh_.points();
    const label n = x.size();
    // of each vertex: normal, sum of the edges opposite to it, number of edges'
    // lengths, area, processors
    typedef FixedList<scalar, 9> sums;
    List<sums> of(n, sums(Zero));
    for (const triFace& t : triangles_)
    {
        const vector S(0.5*((x[t[1]] - x[t[0]]) ^ (x[t[2]] - x[t[0]])));
        forAll(t, i)
        {
            const vector across(x[t[(i + 2) % 3]] - x[t[(i + 1) % 3]]);
            sums& s = of[t[i]];
            for (direction d = 0; d < 3; ++d)
            {
                s[d] += S[d];
                s[3 + d] += across[d];
            }
            s[6] += mag(across);
            s[7] += mag(S)/3;
            s[8] = 1;
        }
    }
    sharedVertices::sum<9>(mesh_, of.begin()->begin(), nHalo_);
    normals.setSize(n, Zero);
    inside.setSize(n, false);
    area_.setSize(n, 0);
    counted_.setSize(n, 0);
    forAll(of, v)
    {
        const sums& s = of[v];
        if (s[8] > 0)
        {
            normals[v] = normalised(vector(s[0], s[1], s[2]));
            // edges opposite to a vertex inside the membrane are a polygon
            inside[v] = mag(vector(s[3], s[4], s[5])) < 1e-6*s[6];
            area_[v] = s[7];
            counted_[v] = s[7]/s[8];
        }
    }
}


void Foam::fsbi::membraneBending::setWeights(const vectorField& normals)
{
    typedef Eigen::Matrix<double, 5, 5> square;
    typedef Eigen::Matrix<double, 5, 1> column;
    const pointField& x = mesh_.points();

    // functions of the fit, of a length of the vertex: isotropic curvature is
    // apart, so that a fit which does not see all has no part of what it does
    // not see. Weight: 1/distance^2
    const auto functions = [&](const triFace& t, const label i, const label step)
    {
        const label v = t[i];
        const scalar r = Foam::sqrt(area_[v]);
        const vector n(normals[v]);
        const vector t1(oneAcross(n));
        const vector e(edge(x, t, i, step)/r);
        const scalar a = e & t1, b = e & (n ^ t1);
        column f;
        f << a, b, 0.5*(a*a + b*b), 0.5*(a*a - b*b), a*b;
        return column(f/mag(e));
    };
    const auto length = [&](const triFace& t, const label i, const label step)
    {
        return mag(edge(x, t, i, step))/Foam::sqrt(area_[t[i]]);
    };

    List<FixedList<scalar, 25>> normal
    (
        x.size(), FixedList<scalar, 25>(Zero)
    );
    for (const triFace& t : triangles_)
    {
        forAll(t, i)
        {
            Eigen::Map<square> M(normal[t[i]].begin());
            for (const label step : {1, 2})
            {
                const column f(functions(t, i, step));
                M += 0.5*f*f.transpose();
            }
        }
    }
    sharedVertices::sum<25>(mesh_, normal.begin()->begin(), nHalo_);

    weights_.setSize(triangles_.size());
    forAll(triangles_, k)
    {
        const triFace& t = triangles_[k];
        forAll(t, i)
        {
            const scalar r = Foam::sqrt(area_[t[i]]);
            const Eigen::SelfAdjointEigenSolver<square> of
            (
                square(Eigen::Map<square>(normal[t[i]].begin()))
            );
            column overValues(of.eigenvalues());
            for (double& value : overValues)
            {
                value =
                    value > 0.01*of.eigenvalues().maxCoeff() ? 1/value : 0;
            }
            const square inverse
            (
                of.eigenvectors()*overValues.asDiagonal()
               *of.eigenvectors().transpose()
            );
            for (const label step : {1, 2})
            {
                const column c
                (
                    inverse*functions(t, i, step)*0.5/length(t, i, step)
                );
                FixedList<scalar, 5>& w =
                    step == 1 ? weights_[k][i].next : weights_[k][i].last;
                w[0] = c[0]/r;
                w[1] = c[1]/r;
                w[2] = (c[2] + c[3])/sqr(r);
                w[3] = c[4]/sqr(r);
                w[4] = (c[2] - c[3])/sqr(r);
            }
        }
    }
}


Foam::List<Foam::fsbi::membraneBending::derivatives>
Foam::fsbi::membraneBending::at(const vectorField& x) const
{
    List<derivatives> values(x.size(), derivatives(vector::zero));
    forAll(triangles_, k)
    {
        const triFace& t = triangles_[k];
        forAll(t, i)
        {
            const vector next(edge(x, t, i, 1)), last(edge(x, t, i, 2));
            const coefficients& w = weights_[k][i];
            derivatives& d = values[t[i]];
            forAll(d, m)
            {
                d[m] += w.next[m]*next + w.last[m]*last;
            }
        }
    }
    sharedVertices::sum<15>(mesh_, values.begin()->begin()->v_, nHalo_);
    return values;
}


void Foam::fsbi::membraneBending::scatter
(
    const List<derivatives>& slopes, vectorField& forces
) const
{
    forAll(triangles_, k)
    {
        const triFace& t = triangles_[k];
        forAll(t, i)
        {
            const coefficients& w = weights_[k][i];
            const derivatives& by = slopes[t[i]];
            vector next(Zero), last(Zero);
            forAll(by, m)
            {
                next += w.next[m]*by[m];
                last += w.last[m]*by[m];
            }
            forces[t[i]] += next + last;
            forces[t[(i + 1) % 3]] -= next;
            forces[t[(i + 2) % 3]] -= last;
        }
    }
}


Foam::scalar Foam::fsbi::membraneBending::addForces
(
    const vectorField& x, vectorField& forces
)
{
    x_ = at(x);
    now_.setSize(x.size());
    slopes_.setSize(x.size());
    slopes_ = derivatives(vector::zero);
    valid_ = true;
    scalar work = 0;
    forAll(area_, v)
    {
        if (area_[v] > 0)
        {
            now_[v] = curvature(x_[v], modulus_, rest_[v], restArea_[v]);
            if (!(now_[v].area() > SMALL))
            {
                valid_ = false;
                continue;
            }
            slopes_[v] = now_[v].slope();
            for (vector& by : slopes_[v])
            {
                by *= area_[v];
            }
            work += counted_[v]/area_[v]*product(slopes_[v], x_[v]);
        }
    }
    scatter(slopes_, forces);
    return work;
}


Foam::scalar Foam::fsbi::membraneBending::addTangent
(
    const vectorField& dx, vectorField& forces
) const
{
    const List<derivatives> change(at(dx));
    List<derivatives> dSlopes(dx.size(), derivatives(vector::zero));
    scalar work = 0;
    forAll(area_, v)
    {
        if (area_[v] > 0 && now_[v].area() > SMALL)
        {
            dSlopes[v] = now_[v].slopeTangent(change[v]);
            for (vector& by : dSlopes[v])
            {
                by *= area_[v];
            }
            work +=
                counted_[v]/area_[v]
               *(
                    product(dSlopes[v], x_[v]) + product(slopes_[v], change[v])
                );
        }
    }
    scatter(dSlopes, forces);
    return work;
}


Foam::scalar Foam::fsbi::membraneBending::energy() const
{
    scalar E = 0;
    forAll(counted_, v)
    {
        if (counted_[v] > 0 && now_[v].area() > SMALL)
        {
            E += counted_[v]*now_[v].energy();
        }
    }
    return E;
}
