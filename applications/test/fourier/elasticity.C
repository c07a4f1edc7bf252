/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "elasticSymbol.H"
#include "fourierChecks.H"
#include "mathematicalConstants.H"

#include <array>
#include <random>

namespace Foam
{
namespace fsbi
{

static const scalar pi = constant::mathematical::pi;

// Relaxed Jacobi on displacements in a periodic box, cell by cell
// (Gaskin 2018, 3.79)
class periodicBox
{
    const label n_;
    const scalar nu_;
    const vector spacing_;
    std::vector<vector> u_;

    label index(const std::array<label, 3>& at) const
    {
        return (at[0] % n_) + n_*((at[1] % n_) + n_*(at[2] % n_));
    }

    vector at(std::array<label, 3> cell, direction i, label a, direction j, label b) const
    {
        cell[i] += n_ + a;
        cell[j] += n_ + b;
        return u_[index(cell)];
    }

    vector stepped(const std::array<label, 3>& c, const scalar omega) const
    {
        const scalar mu = 1, lambda = 2*nu_/(1 - 2*nu_);
        vector result;
        for (direction i = 0; i < 3; ++i)
        {
            scalar sum = 0, diagonal = 0;
            for (direction j = 0; j < 3; ++j)
            {
                const scalar k = (i == j ? 2*mu + lambda : mu)/sqr(spacing_[j]);
                diagonal += 2*k;
                sum += k*(at(c, j, 1, j, 0)[i] + at(c, j, -1, j, 0)[i]);
                if (j != i)
                {
                    sum += (mu + lambda)/(4*spacing_[i]*spacing_[j])
                       *(at(c, i, 1, j, 1)[j] - at(c, i, 1, j, -1)[j]
                       - at(c, i, -1, j, 1)[j] + at(c, i, -1, j, -1)[j]);
                }
            }
            result[i] = omega*sum/diagonal + (1 - omega)*u_[index(c)][i];
        }
        return result;
    }

public:

    periodicBox(const label n, const scalar nu, const vector& spacing)
    :
        n_(n), nu_(nu), spacing_(spacing), u_(n*n*n)
    {
        std::mt19937 random(1);
        std::uniform_real_distribution<scalar> any(-1, 1);
        for (vector& u : u_)
        {
            u = vector(any(random), any(random), any(random));
        }
        removeMean();
    }

    void removeMean()
    {
        vector mean(Zero);
        for (const vector& u : u_) { mean += u/scalar(u_.size()); }
        for (vector& u : u_) { u -= mean; }
    }

    void step(const scalar omega)
    {
        std::vector<vector> next(u_.size());
        for (label i = 0; i < n_; ++i)
        for (label j = 0; j < n_; ++j)
        for (label k = 0; k < n_; ++k)
        {
            next[index({i, j, k})] = stepped({i, j, k}, omega);
        }
        u_.swap(next);
    }

    //- Length, which is set to one
    scalar normalise()
    {
        removeMean();
        scalar sum = 0;
        for (const vector& u : u_) { sum += magSqr(u); }
        for (vector& u : u_) { u /= sqrt(sum); }
        return sqrt(sum);
    }
};


static void checkSymbol(checks& test)
{
    scalar worst = 0, stiffness = 0;
    const elasticSymbol body(1, 0.3, vector(1, 1, 1));
    const elasticSymbol stiffer(7e9, 0.3, vector(1, 1, 1));
    for (label k = 1; k <= 64; ++k)
    {
        const scalar p = k*pi/64;
        const vector phi(p, p, p);
        const vector kappa = body.eigenvalues(phi);
        const scalar o = 2.5/11*sqr(sin(p));    // (mu + l)/(2 (4 mu + l)), l/mu 1.5
        worst = max(worst, mag(kappa.x() - (1 - cos(p) - o)));
        worst = max(worst, mag(kappa.y() - (1 - cos(p) - o)));
        worst = max(worst, mag(kappa.z() - (1 - cos(p) + 2*o)));
        stiffness = max(stiffness, mag(kappa - stiffer.eigenvalues(phi)));
    }
    test.checkBelow("eigenvalues on the diagonal", worst, 1e-12);
    test.checkBelow("Young's modulus does not matter", stiffness, 1e-14);

    // eigenvalues of G itself, for unequal cells: trace of powers
    const elasticSymbol flat(1, 0.4, vector(1, 2, 5));
    const vector phi(0.3, 1.7, 2.2);
    const tensor G = flat.step(phi, 0.8);
    vector g;
    for (direction i = 0; i < 3; ++i)
    {
        g[i] = 1 - 0.8*flat.eigenvalues(phi)[i];
    }
    test.checkClose("trace of G, unequal cells", tr(G), cmptSum(g), 1e-13);
    test.checkClose("its determinant", det(G), g.x()*g.y()*g.z(), 1e-12);
    test.checkClose
    (
        "trace of its square", tr(G & G), magSqr(g), 1e-13
    );
}


static void checkRange(checks& test)
{
    const scalar wave = pi/64;
    const eigenvalueRange r = elasticSymbol(1, 0.3, vector::one).range(wave, false);
    test.checkClose
    (
        "lowest eigenvalue, nu 0.3", r.lowest,
        2*sqr(sin(wave/2)) - 2.5/11*sqr(sin(wave)), 1e-11
    );
    test.checkClose("highest", r.highest, 2, 1e-13);
    test.checkBelow("certain", r.uncertainty, 1e-12);
    const eigenvalueRange s = elasticSymbol(1, 0.4, vector::one).range(wave, false);
    test.checkClose("highest, inside, nu 0.4", s.highest, 2.025, 1e-13);
    test.checkBelow("certain", s.uncertainty, 1e-12);

    // a box no formula knows: against sampling of all waves
    const elasticSymbol body(1, 0.45, vector(1, 1.7, 0.6));
    const eigenvalueRange t = body.range(pi/8, false);
    scalar low = GREAT, high = 0;
    const label n = 48;
    for (label i = 0; i <= n; ++i)
    for (label j = 0; j <= n; ++j)
    for (label k = 0; k <= n; ++k)
    {
        const vector phi = (pi/8)*vector::one + (7*pi/8/n)*vector(i, j, k);
        const vector kappa = body.eigenvalues(phi);
        low = min(low, kappa.x());
        high = max(high, kappa.z());
    }
    test.checkBelow("no sampled wave is below the range", t.lowest - low, 1e-12);
    test.checkBelow("none above", high - t.highest, 1e-12);
    test.checkClose("its ends are met", high - low, t.highest - t.lowest, 2e-3);
}


// Asymptotic factor of the iteration itself against that of the symbol
static void checkIteration(checks& test)
{
    const label n = 8;
    const vector spacing(1, 1.5, 0.8);
    const elasticSymbol body(1, 0.3, spacing);
    const scalarList waves = body.ofPeriodicBox(Vector<label>(n, n, n));
    const eigenvalueRange range{min(waves), max(waves)};
    for (const label m : {1, 2, 3, 4, 8})
    {
        const scalarList factors = bestFactors(m, range);
        periodicBox box(n, 0.3, spacing);
        // the wave that decays slowest must outlast the others
        const label passes = 1200/m;
        scalar factor = 0;
        for (label pass = 0; pass < passes; ++pass)
        {
            for (const scalar omega : factors) { box.step(omega); }
            const scalar length = box.normalise();
            factor += 2*pass >= passes ? log(length) : 0;
        }
        factor /= passes - (passes + 1)/2;
        test.checkClose
        (
            "rate of " + std::to_string(m) + " steps on a periodic elastic box",
            factor, log(spectralRadius(factors, waves)), 0.01
        );
    }
}

} // End namespace fsbi
} // End namespace Foam


void Foam::fsbi::checkElasticity(checks& test)
{
    checkSymbol(test);
    checkRange(test);
    checkIteration(test);
}
