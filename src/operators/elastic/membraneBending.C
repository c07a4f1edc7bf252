/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "membraneBending.H"
#include "sharedVertices.H"
#include <Eigen/Eigenvalues>

namespace Foam
{
namespace fsbi
{

typedef Eigen::Matrix<double, 5, 5> square;
typedef Eigen::Matrix<double, 5, 1> column;

//- Functions of the fit at the end of an edge, times a weight of 1/distance.
//  Isotropic curvature is one of them, so that a fit which does not see all has
//  no part of what it does not see
static column fitted(const vector& e, const vector& normal)
{
    const bool alongX = mag(normal.x()) > 0.7;
    const vector across
    (
        normalised(normal ^ vector(alongX ? 0 : 1, alongX ? 1 : 0, 0))
    );
    const scalar a = e & across, b = e & (normal ^ across);
    column f;
    f << a, b, 0.5*(a*a + b*b), 0.5*(a*a - b*b), a*b;
    return f/mag(e);
}


//- Without what is seen a hundred times less than the rest: on regular
//  triangles eigenvalues differ by 4
static square pseudoInverse(const square& M)
{
    const Eigen::SelfAdjointEigenSolver<square> of(M);
    column values(of.eigenvalues());
    const double least = 0.01*values.maxCoeff();
    for (double& value : values)
    {
        value = value > least ? 1/value : 0;
    }
    return
        of.eigenvectors()*values.asDiagonal()*of.eigenvectors().transpose();
}


static scalar product
(
    const surfaceCurvature::derivatives& a,
    const surfaceCurvature::derivatives& b
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
    at(mesh.points(), x_);
    forAll(area_, v)
    {
        if (area_[v] > 0)
        {
            const surfaceCurvature c(x_[v], 0, 0, 1);
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
    // of each vertex: normal, sum of the edges opposite to it and of their
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
    const pointField& x = mesh_.points();
    List<FixedList<scalar, 25>> sums(x.size(), FixedList<scalar, 25>(Zero));
    const auto fit = [&](const triFace& t, const label i, const label step)
    {
        const vector e(edge(x, t, i, step)/Foam::sqrt(area_[t[i]]));
        return fitted(e, normals[t[i]]);
    };
    // an edge inside the membrane is one of two triangles
    for (const triFace& t : triangles_)
    {
        forAll(t, i)
        {
            for (const label step : {1, 2})
            {
                const column f(fit(t, i, step));
                Eigen::Map<square>(sums[t[i]].begin()) += 0.5*f*f.transpose();
            }
        }
    }
    sharedVertices::sum<25>(mesh_, sums.begin()->begin(), nHalo_);

    weights_.setSize(triangles_.size());
    forAll(triangles_, k)
    {
        const triFace& t = triangles_[k];
        forAll(t, i)
        {
            const scalar r = Foam::sqrt(area_[t[i]]);
            const square inverse
            (
                pseudoInverse(Eigen::Map<square>(sums[t[i]].begin()))
            );
            for (const label step : {1, 2})
            {
                const scalar length = mag(edge(x, t, i, step))/r;
                const column c(inverse*fit(t, i, step)*(0.5/length));
                (step == 1 ? weights_[k][i].next : weights_[k][i].last) =
                {
                    c[0]/r, c[1]/r, (c[2] + c[3])/sqr(r), c[4]/sqr(r),
                    (c[2] - c[3])/sqr(r)
                };
            }
        }
    }
}


void Foam::fsbi::membraneBending::at
(
    const vectorField& x, List<derivatives>& values
) const
{
    values.setSize(x.size());
    values = derivatives(vector::zero);
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
    at(x, x_);
    now_.setSize(x.size());
    slopes_.setSize(x.size());
    slopes_ = derivatives(vector::zero);
    valid_ = true;
    scalar work = 0;
    forAll(area_, v)
    {
        if (area_[v] > 0)
        {
            now_[v] =
                surfaceCurvature(x_[v], modulus_, rest_[v], restArea_[v]);
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
    at(dx, dx_);
    dSlopes_.setSize(dx.size());
    dSlopes_ = derivatives(vector::zero);
    scalar work = 0;
    forAll(area_, v)
    {
        if (area_[v] > 0 && now_[v].area() > SMALL)
        {
            dSlopes_[v] = now_[v].slopeTangent(dx_[v]);
            for (vector& by : dSlopes_[v])
            {
                by *= area_[v];
            }
            work +=
                counted_[v]/area_[v]
               *(
                    product(dSlopes_[v], x_[v]) + product(slopes_[v], dx_[v])
                );
        }
    }
    scatter(dSlopes_, forces);
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
