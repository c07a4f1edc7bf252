/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "magneticChecks.H"
#include "soft.H"

namespace Foam
{
namespace fsbi
{

static void checkFactors(checks& c)
{
    // c/a, polar, equatorial: closed forms of Osborn (Phys. Rev. 67, 1945),
    // of which the polar ones were checked by quadrature
    const List<FixedList<scalar, 3>> spheroids
    ({
        {0.05, 0.926181453, 0.0369092735},
        {0.1, 0.860804277, 0.0695978617},
        {0.2, 0.750483912, 0.124758044},
        {0.5, 0.527200283, 0.236399859},
        {0.8, 0.394440338, 0.302779831},
        {1, 0.333333333, 0.333333333},
        {1.1, 0.308284834, 0.345857583},
        {1.25, 0.275991646, 0.362004177},
        {1.5, 0.232981458, 0.383509271},
        {2, 0.173563998, 0.413218001},
        {3, 0.108709465, 0.445645267},
        {5, 0.0558209698, 0.472089515},
        {10, 0.0202858803, 0.48985706},
        {20, 0.00674905475, 0.496625473},
        {50, 0.00144297377, 0.499278513},
        {100, 0.00042989872, 0.499785051}
    });
    scalar worst = 0;
    for (const auto& s : spheroids)
    {
        const vector N(demagnetisingFactors(vector(3, 3, 3*s[0])));
        worst = max(worst, mag(N.z()/s[1] - 1));
        worst = max(worst, max(mag(N.x()/s[2] - 1), mag(N.y()/s[2] - 1)));
    }
    c.checkBelow("demagnetising factors of spheroids", worst, 5e-8);

    // by quadrature of the integral, s = a^2 q/(1-q)
    const vector a(1, 2, 5);
    const vector N(demagnetisingFactors(a));
    vector sum(Zero);
    const label n = 20000;
    for (label i = 0; i < n; ++i)
    {
        // q = p^2, so that the integrand is smooth at both ends
        const scalar p = (i + 0.5)/n, q = 1 - p*p;
        const scalar s = q/(1 - q), ds = 2*p/sqr(1 - q)/n;
        const scalar root = sqrt((s + 1)*(s + 4)*(s + 25));
        sum += 5*ds/root*vector(1/(s + 1), 1/(s + 4), 1/(s + 25));
    }
    c.checkBelow
    (
        "demagnetising factors of an ellipsoid of three axes",
        mag(N - sum), 1e-7
    );
    c.checkClose("their sum", N.x() + N.y() + N.z(), 1, 1e-14);
}


static autoPtr<magnetisation> law(const std::string& text)
{
    return magnetisation::New(dictOf(text));
}


void checkMagnetisations(checks& c)
{
    checkFactors(c);
    const vector B(1e-3, -2e-3, 0.5e-3);
    const tensor R(quaternion(vector(1, 2, 2)/3, 0.7).R());

    const auto iron(law
    (
        "type saturated; atoms { moment 2.22; density 7874;"
        " molarMass 0.055845; }"
    ));
    const vector m(iron->moment(2e-18, R, B));
    c.checkClose("saturated iron, A/m", mag(m)/2e-18, 1.748e6, 2e-4);
    c.checkBelow("saturated: along the field", mag(m ^ B)/(m & B), 1e-15);
    c.check
    (
        "saturated: nothing in no field", mag(iron->moment(1, R, Zero)) == 0
    );

    const auto magnet(law("type permanent; direction (0 3 4); moment 5e-12;"));
    c.checkBelow
    (
        "permanent: turns with the body, whatever the field",
        mag(magnet->moment(2e-18, R, B) - 1e-12*(R & vector(0, 3, 4))), 1e-26
    );
    const auto part
    (
        law("type permanent; direction (1 0 0); magnetisation 8e5;")
    );
    c.checkClose
    (
        "permanent: per volume", mag(part->moment(2e-18, R, B)), 1.6e-12, 1e-14
    );

    const auto sphere(law("type soft; susceptibility 4; semiAxes (2 2 2);"));
    c.checkBelow
    (
        "soft sphere: 3 V chi/(mu0 (3 + chi)) B",
        mag(sphere->moment(7, R, B) - 7*12/(7*mu0SI)*B)/mag(B)*mu0SI, 1e-13
    );
    const auto rod(law("type soft; susceptibility 1e6; semiAxes (1 1 10);"));
    const vector along(R & vector(0, 0, 1)), across(R & vector(0, 1, 0));
    c.checkClose
    (
        "soft rod: 1/N of the field along it",
        (rod->moment(1, R, along) & along)*mu0SI, 1/0.0202858803, 1e-4
    );
    c.checkClose
    (
        "soft rod: 1/N of the field across",
        (rod->moment(1, R, across) & across)*mu0SI, 1/0.48985706, 1e-5
    );

    const auto wrong = [&]
    (
        const std::string& name, const std::string& text,
        const std::string& message
    )
    {
        c.checkFatal(name, [&]{ law(text); }, message);
    };
    wrong("unknown magnetisation", "type hard;", "(permanent saturated soft)");
    wrong("no size", "type saturated;", "there are 0");
    wrong("two sizes", "type saturated; moment 1; magnetisation 1;",
        "there are 2");
    wrong("a negative moment", "type saturated; moment -1;", "must be above");
    wrong("no direction", "type permanent; moment 1;", "direction");
    wrong("a flat body", "type soft; susceptibility 1; semiAxes (1 0 1);",
        "'semiAxes' must be above zero");
    wrong("unknown keyword of atoms", "type saturated; atoms { moment 1;"
        " density 1; molarMass 1; number 26; }", "'number'");
}

} // End namespace fsbi
} // End namespace Foam
