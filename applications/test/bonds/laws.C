/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bondChecks.H"
#include "contactRate.H"
#include "counterRandom.H"
#include "units.H"
#include "mathematicalConstants.H"

namespace Foam
{
namespace fsbi
{

static const std::string common("k0on 3e-9; lambda 0.05; s 2; ");

static const std::vector<std::string> laws
({
    "law Dembo; k0off 3e-7; sts 1; ",
    "law Bell; k0off 3e-7; gamma 4e-4; ",
    "law catchSlip; kCatch 2e-6; xCatch 1e-3; kSlip 1e-7; xSlip 3e-4; "
});


// An independent table computed for this project from the formulas of Dembo
// and Bell: T in K, extension in nm, force in pN, Dembo's k_on/k0_on and k_off
// in 1/s, Bell's, and the equilibrium constant over that at rest
static const scalar table[][8] =
{
    {298, -10, -20, 5.2744556e-06, 56877.908, 1.9444951e-10, 2.0968764, 2.7819882e-11},
    {298, -1, -2, 0.88556772, 0.33876574, 0.95255204, 0.36438997, 0.78423018},
    {298, 0, 0, 1, 0.3, 1, 0.3, 1},
    {298, 3, 6, 0.33496234, 0.89562306, 0.20106082, 0.53759687, 0.11219977},
    {298, 20, 40, 7.7394581e-22, 3.8762404e+20, 2.9263365e-41, 14.656302, 5.9899211e-43},
    {310, -5, -10, 0.05390389, 5.565461, 0.007398127, 0.76384074, 0.0029056294},
    {310, -2, -4, 0.62669931, 0.47869847, 0.57078304, 0.43598734, 0.39275203},
    {310, 1, 2, 0.88974346, 0.33717584, 0.95434614, 0.36165758, 0.79164342},
    {310, 6, 12, 0.014911899, 20.118162, 0.00068253322, 0.92082931, 0.00022236474},
    {310, 15, 30, 3.842209e-12, 7.8080083e+10, 2.4367259e-22, 4.9518325, 1.476257e-23}
};


static void checkTable(checks& c)
{
    scalar force = 0, dembo = 0, bell = 0, balance = 0;
    const auto off = [](const scalar a, const scalar b)
    {
        return mag(a - b)/mag(b);
    };
    for (const auto& row : table)
    {
        const scalar l = 0.05 + 1e-3*row[1];
        const auto D(makeLaw(common + laws[0], row[0]));
        const auto B(makeLaw(common + laws[1], row[0]));
        force = max(force, mag(D->force(l) - 1e-3*row[2]));
        dembo = max(dembo, off(D->kOn(l)/3e-9, row[3]));
        dembo = max(dembo, off(1e6*D->kOff(l), row[4]));
        bell = max(bell, off(B->kOn(l)/3e-9, row[5]));
        bell = max(bell, off(1e6*B->kOff(l), row[6]));
        balance = max(balance, off(100*D->kOn(l)/D->kOff(l), row[7]));
        balance = max(balance, off(100*B->kOn(l)/B->kOff(l), row[7]));
    }
    c.checkBelow("force against the table", force, 1e-15);
    // eight digits are printed, and 5e-22 is exp(-47)
    c.checkBelow("Dembo's rates against the table", dembo, 1e-7);
    c.checkBelow("Bell's rates against the table", bell, 1e-7);
    c.checkBelow("equilibrium constants against the table", balance, 1e-7);
}


static void checkBalance(checks& c)
{
    for (const std::string& entry : laws)
    {
        const auto law(makeLaw(common + entry, 310));
        const scalar rest = law->kOn(0.05)/law->kOff(0.05);
        scalar worst = 0, slope = 0;
        for (scalar x = -0.008; x < 0.0081; x += 0.001)
        {
            const scalar l = 0.05 + x, h = 1e-6;
            worst = max
            (
                worst,
                mag
                (
                    law->kOn(l)/law->kOff(l)/rest
                  * std::exp(2*x*x/(2*kT(310))) - 1
                )
            );
            // the force does the work that the equilibrium constant knows of
            const scalar change = std::log
            (
                law->kOn(l + h)*law->kOff(l - h)
               /(law->kOn(l - h)*law->kOff(l + h))
            );
            slope = max(slope, mag(kT(310)*change/(2*h) + law->force(l)));
        }
        const std::string name(law->type());
        c.checkBelow(name + ": detailed balance", worst, 1e-11);
        c.checkBelow(name + ": force is the energy's slope", slope, 1e-8);
        c.check
        (
            name + ": finite far away",
            std::isfinite(law->kOff(100)) && law->kOn(100) >= 0
        );
    }
    const auto catching(makeLaw(common + laws[2], 310));
    const scalar f = 3.0/kT(310);      // of 1.5 nm times s, over kT
    c.checkClose
    (
        "catchSlip: two pathways", catching->kOff(0.0515),
        2e-6*std::exp(-1e-6*f) + 1e-7*std::exp(3e-7*f), 1e-12
    );
    c.check
    (
        "catchSlip: lives longer under some load",
        catching->kOff(0.0515) < catching->kOff(0.05)
     && catching->kOff(0.09) > catching->kOff(0.05)
    );
}


void checkLaws(checks& c)
{
    checkTable(c);
    checkBalance(c);
    c.checkFatal
    (
        "an unknown law is refused",
        []{ makeLaw(common + "law Evans; ", 310); }, "catchSlip"
    );
    c.checkFatal
    (
        "an entry of another law is refused",
        []{ makeLaw(common + laws[0] + "gamma 1;", 310); }, "gamma"
    );
    for (const bool SI : {false, true})
    {
        IStringStream text(SI ? "units SI;" : "");
        const dictionary dict(text);
        const checkedDictionary entries(dict);
        const scalar value = units(entries).Boltzmann();
        entries.finish();
        c.checkClose
        (
            SI ? "Boltzmann's constant, SI" : "Boltzmann's constant, pg um us",
            value, SI ? 1.380649e-23 : 1.380649e-8, 1e-14
        );
    }
}


void checkContact(checks& c)
{
    const scalar a = 0.5*1/kT(310);
    const auto law(makeLaw(common + laws[0], 310));
    for (const scalar roughness : {0.0, 0.3})
    {
        const contactRate rate(law(), roughness);
        const scalar R = 0.05 + roughness;
        const auto exact = [&](const scalar x)
        {
            return constant::mathematical::twoPi*3e-9
               *(
                    exp(-a*x*x)/(2*a)
                  + 0.5*R*sqrt(constant::mathematical::pi/a)
                   *std::erfc(sqrt(a)*x)
                );
        };
        scalar worst = 0, relative = 0;
        for (scalar x = -0.03; x < 0.02; x += 0.0007)
        {
            const scalar error = mag(rate(R + x) - exact(x));
            worst = max(worst, error/exact(0));
            relative = max(relative, x < 0.01 ? error/exact(x) : 0);
        }
        const std::string name(roughness > 0 ? "stalks" : "no stalks");
        c.checkBelow("rate over a plane, " + name, worst, 1e-12);
        c.checkBelow("also in the tail, " + name, relative, 1e-9);
        c.check("none beyond the reach", rate(rate.reach() + 1e-9) == 0);
    }

    // the gradient of the rate is the circumference's share
    const auto slip(makeLaw(common + laws[2], 310));
    const contactRate rate(slip(), 0.1);
    const scalar g = 0.1495, h = 1e-5;
    c.checkClose
    (
        "catchSlip: slope of the rate", (rate(g - h) - rate(g + h))/(2*h),
        constant::mathematical::twoPi*g*slip->kOn(g - 0.1), 1e-4
    );

    // lengths drawn: the fraction beyond some length is K there over K(g)
    const label n = 20000;
    const counterRandom random(1, "lengths");
    scalar nearest = 1;
    labelList beyond(3, 0);
    const scalarList marks({0.1490, 0.1502, 0.1515});
    for (label i = 0; i < n; ++i)
    {
        const scalar r = rate.distance(0.148, random.at(0, i).uniform());
        nearest = min(nearest, r);
        forAll(marks, m)
        {
            beyond[m] += r > marks[m];
        }
    }
    c.check("no bond is shorter than the gap", nearest >= 0.148);
    forAll(marks, m)
    {
        const scalar p = rate(marks[m])/rate(0.148);
        checkSigma
        (
            c, "lengths beyond " + std::to_string(marks[m]),
            beyond[m]/scalar(n), p, sqrt(p*(1 - p)/n)
        );
    }
}

} // End namespace fsbi
} // End namespace Foam
