/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "analysis.H"
#include "annealing.H"
#include "checkedDictionary.H"
#include "elasticSymbol.H"
#include "laplaceSymbol.H"
#include "mathematicalConstants.H"
#include "SORSymbol.H"

static const Foam::scalar pi = Foam::constant::mathematical::pi;

namespace Foam
{
namespace fsbi
{

//- A file of a table, its header written
class table
:
    public OFstream
{
public:

    table(const fileName& name, const char* header)
    :
        OFstream(name)
    {
        precision(16);
        *this << header << nl;
    }
};

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::analysis::analysis(const dictionary& dict)
{
    read(dict);
    if (symbol_)
    {
        range_ = symbol_->range(phiMin_, zeroComponents_);
        Info<< "Eigenvalues of D^-1 A: " << range_.lowest << " to "
            << range_.highest << ", certain within "
            << max(range_.uncertainty, 1e-14) << endl;
    }
    singleRadius_ = radius(best(1));
}


void Foam::fsbi::analysis::read(const dictionary& dict)
{
    const checkedDictionary entries(dict);
    const word equation(entries.choice("equation", {"Laplace", "elasticity"}));
    const word method(entries.choice("method", {"Jacobi", "SOR"}, "Jacobi"));
    const vector spacing =
        entries.getOrDefault<vector>("spacing", vector::one);
    phiMin_ = entries.positive("phiMin");
    zeroComponents_ = entries.getOrDefault("zeroComponents", false);
    steps_ = entries.getOrDefault<labelList>("steps", {1, 2, 3, 4});
    limited_ = entries.found("highestFactor");
    // beyond 2 a sweep of SOR cannot converge
    const scalar highest = method == "SOR" ? 2 : 2/(1 - cos(phiMin_));
    limits_ = scalarMinMax(0.01, entries.positive("highestFactor", highest));
    given_ = entries.getOrDefault<List<scalarList>>("factors", {});
    shown_ = entries.getOrDefault<scalarList>("show", {0.6, 0.8, 1});
    if (equation == "elasticity")
    {
        symbol_.reset
        (
            new elasticSymbol
            (
                entries.positive("E", 1), entries.get<scalar>("nu"), spacing
            )
        );
    }
    else if (method == "Jacobi")
    {
        symbol_.reset(new laplaceSymbol(spacing));
    }
    entries.finish();
    if ((method == "SOR" && equation != "Laplace") || phiMin_ >= pi || min(steps_) < 1)
    {
        FatalIOErrorInFunction(dict)
            << "SOR is for equation Laplace; phiMin must be below pi, steps"
            << " at least 1" << exit(FatalIOError);
    }
}


Foam::scalar Foam::fsbi::analysis::radius(const scalarList& factors) const
{
    return
        symbol_
      ? spectralRadius(factors, range_)
      : SORSymbol::spectralRadius(factors, phiMin_);
}


Foam::scalarList Foam::fsbi::analysis::best(const label steps) const
{
    if (symbol_)
    {
        const scalarList factors = bestFactors(steps, range_);
        if (!limited_ || max(factors) <= limits_.max())
        {
            return factors;
        }
    }
    const scalarList factors = annealed
    (
        scalarList(steps, 1.0),
        [this](const scalarList& w) { return log(radius(w))/w.size(); },
        limits_
    );
    return symbol_ ? tamed(factors, range_) : factors;
}


void Foam::fsbi::analysis::judge
(
    Ostream& os, const word& name, const scalarList& factors
) const
{
    const scalar rho = radius(factors);
    const scalar gain = speedUp(rho, singleRadius_)/factors.size() - 1;
    os  << name.c_str() << ',' << factors.size() << ',' << rho << ','
        << pow(rho, 1/scalar(factors.size())) << ',' << 1 + gain << ',';
    forAll(factors, i)
    {
        os << (i ? " " : "") << factors[i];
    }
    os << nl;
    Info<< name << ' ' << factors << ": radius " << rho;
    if (rho < 1)
    {
        Info<< ", " << 100*gain << " % faster per step than one factor" << endl;
    }
    else
    {
        Info<< ", diverges" << endl;
    }
}


void Foam::fsbi::analysis::writeSchedules(const fileName& folder) const
{
    table os
    (
        folder/"schedules.csv", "kind,steps,radius,radius_per_step,gain,factors"
    );
    for (const label m : steps_)
    {
        judge(os, "best", best(m));
    }
    for (const scalarList& factors : given_)
    {
        judge(os, "given", factors);
    }
}


void Foam::fsbi::analysis::writeFactors(const fileName& folder) const
{
    table os(folder/"factors.csv", "omega,radius");
    for (label i = 1; i <= 400; ++i)
    {
        const scalar omega = symbol_ ? 0.003*i : 0.005*i - 1e-6;
        os << omega << ',' << radius(scalarList(1, omega)) << nl;
    }
}


void Foam::fsbi::analysis::writeWaves(const fileName& folder) const
{
    const auto of = [this](const scalar omega, const vector& phi)
    {
        return
            symbol_
          ? symbol_->spectralRadius(scalarList(1, omega), phi)
          : std::abs(SORSymbol::step(phi.x(), omega));
    };
    table line(folder/"waves.csv", "omega,phi,radius");
    for (const scalar omega : shown_)
    {
        for (label i = 0; i <= 200; ++i)
        {
            const scalar phi = phiMin_ + (pi - phiMin_)*i/200;
            line<< omega << ',' << phi << ',' << of(omega, phi*vector::one)
                << nl;
        }
    }
    if (!dynamic_cast<const elasticSymbol*>(symbol_.get()))
    {
        return;
    }
    table planes(folder/"planes.csv", "phix,phiy,phiz,radius");
    for (const scalar x : {phiMin_, pi})
    {
        for (label i = 0; i < 101*101; ++i)
        {
            const vector phi
            (
                x,
                phiMin_ + (pi - phiMin_)*(i/101)/100,
                phiMin_ + (pi - phiMin_)*(i % 101)/100
            );
            planes<< phi.x() << ',' << phi.y() << ',' << phi.z() << ','
                << of(shown_.last(), phi) << nl;
        }
    }
}


void Foam::fsbi::analysis::writePairs(const fileName& folder) const
{
    if (!symbol_)
    {
        return;
    }
    table os(folder/"pairs.csv", "omega1,omega2,gain");
    const label n = 180;
    for (label i = 1; i <= n; ++i)
    {
        for (label j = 1; j <= n; ++j)
        {
            const scalarList pair({3.6*i/n, 3.6*j/n});
            os  << pair[0] << ',' << pair[1] << ','
                << speedUp(radius(pair), singleRadius_)/2 << nl;
        }
    }
}
