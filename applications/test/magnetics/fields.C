/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "magneticChecks.H"
#include "coil.H"
#include "dipole.H"

namespace Foam
{
namespace fsbi
{

//- Biot and Savart by the trapezoidal rule, which converges exponentially
static vector quadrature(const scalar radius, const vector& x)
{
    const label n = 4000;
    vector sum(Zero);
    for (label i = 0; i < n; ++i)
    {
        const scalar phi = 2*pi*i/n;
        const vector at(radius*cos(phi), radius*sin(phi), 0);
        const vector dl(-at.y()*2*pi/n, at.x()*2*pi/n, 0);
        sum += (dl ^ (x - at))/pow3(mag(x - at));
    }
    return 1e-7*sum;
}


//- Sixth-order differences of a field
template<class Field>
static tensor differences(const Field& B, const point& x, const scalar h)
{
    tensor sum(Zero);
    const scalar weights[] = {0.75, -0.15, 1.0/60};
    for (direction i = 0; i < 3; ++i)
    {
        vector step(Zero);
        step[i] = h;
        vector d(Zero);
        for (label k = 0; k < 3; ++k)
        {
            d += weights[k]/h*(B(x + (k + 1)*step) - B(x - (k + 1)*step));
        }
        for (direction j = 0; j < 3; ++j)
        {
            sum(i, j) = d[j];
        }
    }
    return sum;
}


static void checkLoop(checks& c)
{
    const scalar a = 0.05;
    const currentLoop loop(point(Zero), vector(0, 0, 1), a);
    scalar worst = 0, gradient = 0, source = 0, curl = 0;
    Random random(7);
    // w runs from 1e-12 over the change of formula at 0.05 to 0.9
    for (label n = 0; n < 300; ++n)
    {
        const scalar phi = 2*pi*random.sample01<scalar>();
        const scalar r = a*pow(10, -6 + 6.2*random.sample01<scalar>());
        const scalar z = a*(3*random.sample01<scalar>() - 1.5);
        const vector x(r*cos(phi), r*sin(phi), z);
        const scalar fromWire = sqrt(sqr(r - a) + sqr(z));
        if (fromWire < 0.05*a)
        {
            continue;
        }
        const vector B(loop.B(x));
        const tensor G(loop.gradient(x));
        const tensor d
        (
            differences
            (
                [&](const point& y){ return loop.B(y); }, x, 0.005*fromWire
            )
        );
        worst = max(worst, mag(B - quadrature(a, x))/mag(B));
        gradient = max(gradient, mag(G - d)/mag(G));
        source = max(source, mag(tr(G))/mag(G));
        curl = max(curl, mag(skew(G))/mag(G));
    }
    c.checkBelow("field of a loop: quadrature of Biot-Savart", worst, 1e-12);
    c.checkBelow("field of a loop: gradient", gradient, 1e-9);
    c.checkBelow("field of a loop: no sources", source, 1e-12);
    c.checkBelow("field of a loop: no curl", curl, 1e-12);

    scalar axial = 0;
    for (const scalar z : {-0.1, 0.0, 0.02, 0.3})
    {
        const scalar exact = 0.5*mu0SI*sqr(a)/pow3(sqrt(sqr(a) + sqr(z)));
        axial = max(axial, mag(loop.B({0, 0, z}).z()/exact - 1));
    }
    c.checkBelow("field of a loop: on its axis", axial, 1e-14);

    // a thousandth of a micrometre off the axis of a coil of 5 cm
    const scalar r = 1e-9, z = 0.03;
    const scalar slope =
        1.5*mu0SI*sqr(a)*z/(2*pow5(sqrt(sqr(a) + sqr(z))));
    c.checkClose
    (
        "field of a loop: across, close to its axis",
        loop.B({r, 0, z}).x(), r*slope, 1e-12
    );

    // as a dipole of the moment pi a^2
    const vector far(30*a, -20*a, 45*a);
    const vector m(0, 0, pi*sqr(a));
    const scalar once = mag(loop.B(far) - dipoleB(m, far))/mag(loop.B(far));
    const scalar twice =
        mag(loop.B(2*far) - dipoleB(m, 2*far))/mag(loop.B(2*far));
    c.check
    (
        "field of a loop: a dipole far away, the rest falls with 1/r^2",
        once < 1e-3 && mag(once/twice - 4) < 0.02
    );

    const currentLoop turned
    (
        point(0.1, 0.2, 0.3), vector(1, 2, -2)/3, a
    );
    const tensor R
    (
        quaternion
        (
            vector(-2, 1, 0)/sqrt(5.0), Foam::acos(-2.0/3)
        ).R()
    );
    const vector x(0.01, 0.03, 0.02);
    c.checkBelow
    (
        "a loop elsewhere, in another direction",
        mag(turned.B(point(0.1, 0.2, 0.3) + (R & x)) - (R & loop.B(x)))
       /mag(loop.B(x)),
        1e-13
    );
}


static autoPtr<magneticField> field
(
    const std::string& text, const std::string& system = "microvascular"
)
{
    return magneticField::New(dictOf(text), unitsOf(system));
}


static void checkPairs(checks& c)
{
    const scalar a = 5e4, n = 200, I = 1.5;
    const std::string rest
    (
        "centre (1e3 2e3 3e3); axis (0 2 0); radius 5e4; turns 200;"
        " current 1.5;"
    );
    const point centre(1e3, 2e3, 3e3);
    const auto at = [&](const magneticField& f, const scalar s)
    {
        return f.B(centre + vector(0, s*a, 0), 0).y();
    };
    const auto H(field("type coil; arrangement Helmholtz;" + rest));
    const scalar B0 = pow(0.8, 1.5)*mu0SI*n*I/(a*1e-6);
    c.checkClose("Helmholtz pair: field", at(H(), 0), B0, 1e-13);
    c.checkClose
    (
        "Helmholtz pair: departs with the fourth power, 144/125",
        (at(H(), 0.02)/B0 - 1)/pow4(0.02), -144.0/125, 2e-3
    );
    const auto M(field("type coil; arrangement Maxwell;" + rest));
    const scalar g = 48.0/49*sqrt(3.0/7)*mu0SI*n*I/sqr(a*1e-6);
    const tensor G(M->gradient(centre, 0));
    c.checkBelow("Maxwell pair: no field", mag(M->B(centre, 0)), 1e-15);
    c.checkClose("Maxwell pair: gradient", G.yy()*1e6, g, 1e-13);
    c.checkClose("Maxwell pair: across", G.xx()*1e6, -0.5*g, 1e-12);
    c.checkClose
    (
        "Maxwell pair: uniform to the fourth power",
        (M->gradient(centre + vector(0, 0.08*a, 0), 0).yy()*1e6/g - 1)
       /(M->gradient(centre + vector(0, 0.04*a, 0), 0).yy()*1e6/g - 1),
        16, 0.05
    );
    const coil& one = refCast<const coil>(M());
    const point x(4e3, -7e3, 2e4);
    c.checkBelow
    (
        "a coil is linear in its current",
        mag(I*one.unitB(x) - M->B(x, 0)), 1e-18
    );
}


static void checkGiven(checks& c)
{
    const scalar t = 7e4;
    const point x(3e3, -2e3, 5e3);
    const std::map<std::string, std::string> kinds
    ({
        {
            "uniform",
            "type uniform; B table ((0 (0 0 0)) (1e5 (1e-3 2e-3 3e-3)));"
        },
        {
            "rotating",
            "type rotating; magnitude 5e-3; axis (0 1 1); start (1 0 1);"
            " frequency 1e-5;"
        },
        {
            "gradient",
            "type gradient; centre (1 2 3); axis (1 1 0); axial 0.5;"
        },
        {
            "gradient by components",
            "type gradient; centre (0 0 0); components (1 2 3 -4 5 3);"
        },
        {
            "dipole",
            "type dipole; moment (0 1 2); position table"
            " ((0 (0 0 5e4)) (1e5 (0 5e4 5e4)));"
        },
        {
            "coil",
            "type coil; centre (0 0 1e4); axis (1 1 1); radius 2e4;"
            " current table ((0 0) (1e5 10));"
        }
    });
    for (const auto& kind : kinds)
    {
        const auto f(field(kind.second));
        const tensor G(f->gradient(x, t));
        const tensor d
        (
            differences([&](const point& y){ return f->B(y, t); }, x, 200)
        );
        const scalar scale = max(mag(G), 1e-6*mag(f->B(x, t)));
        c.checkBelow
        (
            kind.first + ": gradient, sources and curl",
            (mag(G - d) + mag(tr(d)) + mag(skew(d)))/scale, 1e-8
        );
        c.check(kind.first + ": there is a field", mag(f->B(x, t)) > 1e-9);
    }
    c.checkBelow
    (
        "uniform field from a table of time",
        mag(field(kinds.at("uniform"))->B(x, t) - vector(7e-4, 1.4e-3, 2.1e-3)),
        1e-18
    );
    const vector G(field(kinds.at("gradient"))->gradient(x, t)
      & vector(1, 1, 0)/sqrt(2.0));
    c.checkBelow
    (
        "gradient along its axis, T/m per um",
        mag(G - 0.5e-6*vector(1, 1, 0)/sqrt(2.0)), 1e-20
    );
    const vector d(1.5, -2.5, 3);
    const vector m(0.3, 0.2, -0.7);
    const auto far(field
    (
        "type dipole; moment (0.3 0.2 -0.7); position (1 1 1);", "SI"
    ));
    c.checkBelow
    (
        "dipole: along its axis twice the field across, 2 mu0 m/(4 pi r^3)",
        mag(far->B(point(1, 1, 1) + 3*m/mag(m), 0) - 2e-7*m/27)
      + mag(far->B(point(1, 1, 1) + 3*(m ^ d)/mag(m ^ d), 0) + 1e-7*m/27),
        1e-22
    );
}


static void checkRotation(checks& c)
{
    const auto f(field
    (
        "type rotating; magnitude table ((0 0) (1e5 1)); axis (0 0 2);"
        " start (3 0 4); frequency 1e-5;"
    ));
    c.checkBelow
    (
        "rotating field: a quarter of a turn on a cone, right-handed",
        mag(f->B(Zero, 2.5e4) - 0.25*vector(0, 0.6, 0.8)), 1e-15
    );
    const auto sweep(field
    (
        "type rotating; magnitude 1; axis (0 0 1); start (1 0 0);"
        " frequency table ((0 0) (1e5 2e-5));"
    ));
    // f = 2e-10 t: t^2 1e-10 turns
    c.checkBelow
    (
        "rotating field: a sweep of frequency counts its turns",
        mag(sweep->B(Zero, 5e4) - vector(0, 1, 0)), 1e-12
    );
    const std::string loop
    (
        "x { type coil; centre (0 0 0); axis (0 0 1); radius 2; current 3; }"
        " y { type uniform; B (0 0 1e-7); }"
    );
    const magneticFields two(dictOf(loop), unitsOf("SI"));
    const point x(0.3, 0.1, 0.7);
    c.check
    (
        "fields add up",
        mag(two.B(x, 0) - two[0].B(x, 0) - vector(0, 0, 1e-7)) < 1e-20
     && two.gradient(x, 0) == two[0].gradient(x, 0)
     && two.names() == wordList({"x", "y"})
    );
}


static void checkWrongFields(checks& c)
{
    const auto wrong = [&]
    (
        const std::string& name, const std::string& text,
        const std::string& message
    )
    {
        c.checkFatal(name, [&]{ field(text); }, message);
    };
    wrong("unknown field", "type magnet;",
        "(coil dipole gradient rotating uniform)");
    wrong("unknown keyword", "type uniform; B (0 0 1); b 2;", "'b'");
    wrong("no current", "type coil; centre (0 0 0); axis (1 0 0); radius 1;",
        "current");
    wrong("negative radius", "type coil; centre (0 0 0); axis (1 0 0); radius"
        " -1; current 1;", "'radius' must be above zero");
    wrong("unknown arrangement", "type coil; arrangement pair; centre (0 0 0);"
        " axis (1 0 0); radius 1; current 1;", "(single Helmholtz Maxwell)");
    wrong("field along its axis of rotation", "type rotating; magnitude 1; axis"
        " (1 0 0); start (2 0 0); frequency 1;", "parallel");
    wrong("gradient with sources", "type gradient; centre (0 0 0); components"
        " (1 0 0 1 0 1);", "trace must be zero");
    wrong("axis without length", "type gradient; centre (0 0 0); axis (0 0 0);"
        " axial 1;", "'axis' has no length");
    c.checkFatal
    (
        "a field that is no dictionary",
        []{ magneticFields(dictOf("earth 3;"), unitsOf("SI")); },
        "'earth' is no dictionary"
    );
}


void checkFields(checks& c)
{
    checkLoop(c);
    checkPairs(c);
    checkGiven(c);
    checkRotation(c);
    checkWrongFields(c);
}

} // End namespace fsbi
} // End namespace Foam
