/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "exactChecks.H"
#include "tables.H"
#include "Random.H"
#include "boundBox.H"

#include <functional>

namespace Foam
{
namespace fsbi
{

static const std::string steel("type linearElastic; E 200e9; nu 0.3;");

static const std::string flexure
(
    "type beamFlexure; width 0.3; height 0.3; length 2.4; force 90;"
);

static const std::string selfWeight
(
    "type beamSelfWeight; length 2.4; bodyForce 77e3;"
);

//- Derivative along x_d of fourth order
template<class Type>
static Type slope
(
    const std::function<Type(const point&)>& f,
    const point& x, const direction d, const scalar h
)
{
    vector e(Zero);
    e[d] = h;
    return (8*(f(x + e) - f(x - e)) - (f(x + 2*e) - f(x - 2*e)))/(12*h);
}


//- div P + b = 0 and P = P(I + du/dX) at random points of a box
static void checkEquations
(
    checks& c, const std::string& name, const std::string& text,
    const std::string& material, const boundBox& box, const scalar bound
)
{
    const auto s = solution(text, material);
    const auto law = solidMaterial::New(entries(material));
    const scalar h = 2e-3*cmptMin(box.span());
    const std::function<tensor(const point&)> P =
        [&](const point& X) { return s->stress(X, 0); };
    const std::function<vector(const point&)> u =
        [&](const point& X) { return s->displacement(X, 0); };
    Random random(1);
    scalar balance = 0, forces = VSMALL, stresses = 0, largest = 0;
    for (label i = 0; i < 50; ++i)
    {
        const point X
        (
            box.min() + vector::uniform(2*h)
          + cmptMultiply
            (
                random.sample01<vector>(), box.span() - vector::uniform(4*h)
            )
        );
        vector divergence(Zero);
        tensor F(I);
        for (direction d = 0; d < 3; ++d)
        {
            const tensor dP(slope(P, X, d, h));
            divergence += dP.col(d);
            F.col(d, F.col(d) + slope(u, X, d, h));
            forces = max(forces, mag(dP.col(d)));
        }
        balance = max(balance, mag(divergence + s->bodyForce(X, 0)));
        stresses = max(stresses, mag(law->stress(F) - P(X)));
        largest = max(largest, mag(P(X)));
    }
    c.checkBelow(name + ": equilibrium", balance/forces, bound);
    c.checkBelow(name + ": stress of the strain", stresses/largest, bound);
}


static void checkAllEquations(checks& c)
{
    // strains near 1 lose no digits in F - I, and are as good: it is linear
    const std::string soft("type linearElastic; E 1e4; nu 0.3;");
    const boundBox beam(point(-0.15, -0.15, 0), point(0.15, 0.15, 2.4));
    checkEquations(c, "self-weight", selfWeight, soft, beam, 1e-8);
    for (const std::string nu : {"0", "0.3", "-0.4", "0.499"})
    {
        checkEquations
        (
            c, "flexure, nu " + nu, flexure,
            "type linearElastic; E 1e4; nu " + nu + ";", beam, 1e-8
        );
    }
    checkEquations
    (
        c, "flat flexure",
        "type beamFlexure; width 2; height 0.2; length 5; force -3;", soft,
        boundBox(point(-1, -0.1, 0), point(1, 0.1, 5)), 1e-8
    );
    checkEquations
    (
        c, "high flexure elsewhere",
        "type beamFlexure; width 0.2; height 2; length 5; force 3;"
        "origin (7 8 9);", soft,
        boundBox(point(6.9, 7, 9), point(7.1, 9, 14)), 1e-8
    );
    for (const std::string nu : {"0", "0.3", "0.49"})
    {
        checkEquations
        (
            c, "plate with a hole, nu " + nu,
            "type plateWithHole; radius 0.5; tension 3; origin (4 0 0);",
            "type linearElastic; E 1e4; nu " + nu + ";",
            boundBox(point(3.5, 0.5, 0), point(4.5, 1.5, 1)), 1e-7
        );
    }
    for
    (
        const std::string law :
        {"linearElastic", "StVenantKirchhoff", "neoHookean", "MooneyRivlin"}
    )
    {
        checkEquations
        (
            c, "manufactured " + law,
            "type manufactured; amplitude 0.1; length 2; origin (3 0 0);",
            "type " + law + "; E 3; nu 0.3;",
            boundBox(point(3, 0, 0), point(5, 2, 2)), 1e-7
        );
        checkEquations
        (
            c, "homogeneous " + law,
            "type homogeneous; deformation (1.1 0.3 0  0.1 0.9 0  0 -0.2 1.2);"
            "origin (3 0 0);", "type " + law + "; E 3; nu 0.3;",
            boundBox(point(3, 0, 0), point(5, 2, 2)), 1e-8
        );
    }
}


static void checkSides(checks& c)
{
    const auto beam = solution(flexure, steel);
    const auto bar = solution(selfWeight, steel);
    const scalar mean = 90/sqr(0.3), weight = 77e3*2.4;
    scalar sides = 0, barSides = 0;
    for (scalar s = -1; s < 1.001; s += 0.05)
    {
        for (const scalar z : {0.0, 0.7, 2.4})
        {
            for (const scalar end : {-0.15, 0.15})
            {
                const point X(end, 0.15*s, z), Y(0.15*s, end, z);
                sides = max(sides, mag(beam->stress(X, 0) & vector(1, 0, 0)));
                sides = max(sides, mag(beam->stress(Y, 0) & vector(0, 1, 0)));
                barSides = max
                (
                    barSides, mag(bar->stress(X, 0) & vector(1, 1, 0))
                );
            }
        }
    }
    c.checkBelow("flexure: free sides", sides/mean, 1e-13);
    c.checkBelow("self-weight: free sides", barSides, 0);
    c.checkBelow
    (
        "self-weight: free end",
        mag(bar->stress(point(0.1, 0.1, 2.4), 0)), 1e-13*weight
    );
    c.checkClose
    (
        "self-weight: the root carries all",
        bar->stress(point(0.1, -0.1, 0), 0).zz(), weight, 1e-14
    );
    c.checkClose
    (
        "self-weight: the end moves by f l^2/2E",
        bar->displacement(point(0, 0, 2.4), 0).z(), weight*2.4/2/200e9, 1e-13
    );
    c.checkBelow
    (
        "both: the origin stays",
        mag(bar->displacement(Zero, 0)) + mag(beam->displacement(Zero, 0)), 1e-20
    );
    c.checkClose
    (
        "flexure: deflection P l^3/3EI of the axis",
        beam->displacement(point(0, 0, 2.4), 0).y(),
        90*pow3(2.4)/(3*200e9*pow4(0.3)/12), 1e-12
    );
}


static void checkHole(checks& c)
{
    const auto plate = solution
    (
        "type plateWithHole; radius 0.5; tension 3;", steel
    );
    scalar edge = 0;
    for (scalar angle = 0; angle < 6.3; angle += 0.1)
    {
        const vector n(Foam::cos(angle), Foam::sin(angle), 0);
        edge = max(edge, mag(plate->stress(0.5*n, 0) & n));
    }
    c.checkBelow("plate with a hole: its edge is free", edge, 1e-14);
    c.checkClose
    (
        "plate with a hole: three times the tension",
        plate->stress(point(0, 0.5, 7), 0).xx(), 9, 1e-13
    );
    c.checkBelow
    (
        "plate with a hole: the tension far away",
        mag(plate->stress(point(400, 300, 0), 0) - tensor(3, 0, 0, 0, 0, 0, 0, 0, 0.9)),
        3e-5
    );
}


static void checkResultants(checks& c)
{
    const auto beam = solution
    (
        "type beamFlexure; width 0.4; height 0.2; length 2; force 90;", steel
    );
    const label n = 120;
    vector force(Zero), moment(Zero), rootMoment(Zero);
    for (label i = 0; i < n; ++i)
    for (label j = 0; j < n; ++j)
    {
        const vector r(0.4*((i + 0.5)/n - 0.5), 0.2*((j + 0.5)/n - 0.5), 0);
        const vector end(0, 0, 2);
        const scalar area = 0.08/(n*n);
        const vector t(area*(beam->stress(r + end, 0).col(2)));
        force += t;
        moment += r ^ t;
        rootMoment += r ^ (area*beam->stress(r, 0).col(2));
    }
    c.checkBelow
    (
        "flexure: resultant of the end", mag(force - vector(0, 90, 0)), 90e-5
    );
    c.checkBelow("flexure: no torsion", mag(moment), 1e-10);
    c.checkBelow
    (
        "flexure: moment of the root", mag(rootMoment - vector(-180, 0, 0)),
        180e-4
    );
}


static void checkFlexureTable(checks& c)
{
    scalar worst = 0;
    for (const auto& row : flexureTable)
    {
        const scalar a = row[0], b = row[1];
        const auto beam = solution
        (
            "type beamFlexure; length 1; force 1; width " + name(2*a)
          + "; height " + name(2*b) + ";",
            "type linearElastic; E 1; nu " + name(row[2]) + ";"
        );
        const auto tau = [&](const scalar x, const scalar y)
        {
            return beam->stress(point(x, y, 0.3), 0)*(8*a*b/3);
        };
        const scalar value[] =
        {
            tau(0, 0).yz(), tau(a, 0).yz(), tau(a/2, b/2).xz(),
            tau(a/2, b/2).yz(), tau(0, b/2).yz()
        };
        for (label i = 0; i < 5; ++i)
        {
            worst = max(worst, mag(value[i] - row[3 + i]));
        }
    }
    c.checkBelow("flexure: shear stresses of the table", worst, 6e-8);
}


//- P = J sigma F^-T
static void checkCauchyStress(checks& c, const exactSolution& s)
{
    const point X(0.3, 0.4, 0.2);
    const std::function<vector(const point&)> u =
        [&](const point& x) { return s.displacement(x, 0); };
    tensor F(I);
    for (direction d = 0; d < 3; ++d)
    {
        F.col(d, F.col(d) + slope(u, X, d, 1e-3));
    }
    const tensor P(det(F)*(s.CauchyStress(X, 0) & inv(F.T())));
    c.checkBelow("manufactured: Cauchy stress", mag(P - s.stress(X, 0)), 1e-10);
}


static void checkManufacturedTable(checks& c)
{
    const auto SVK = solution
    (
        "type manufactured; amplitude 0.05;",
        "type StVenantKirchhoff; E 1; nu 0.3;"
    );
    const auto neoHooke = solution
    (
        "type manufactured; amplitude 0.05;", "type neoHookean; E 1; nu 0.3;"
    );
    scalar u = 0, P = 0, b = 0;
    for (label row = 0; row < 4; ++row)
    {
        const exactSolution& s = row < 2 ? *SVK : *neoHooke;
        const scalar* v = manufacturedTable[row];
        const point X(v[0], v[1], v[2]);
        u = max(u, mag(s.displacement(X, 0) - vector(v[3], v[4], v[5])));
        const tensor stress
        (
            v[6], v[7], v[8], v[9], v[10], v[11], v[12], v[13], v[14]
        );
        P = max(P, mag(s.stress(X, 0) - stress));
        b = max(b, mag(s.bodyForce(X, 0) - vector(v[15], v[16], v[17])));
    }
    c.checkBelow("manufactured: displacements of the table", u, 1e-11);
    c.checkBelow("manufactured: stresses of the table", P, 1e-10);
    c.checkBelow("manufactured: body forces of the table", b, 5e-9);
    checkCauchyStress(c, *neoHooke);
}


static void checkTime(checks& c)
{
    const std::string ramp("table ((0 0) (2 4));");
    const auto doubled = [&]
    (
        const std::string& text, const std::string& key, const std::string& law
    )
    {
        const auto s = solution(text + key + ' ' + ramp, law);
        const auto reference = solution(text + key + " 2;", law);
        const point X(0.11, 0.07, 0.3);
        return
            mag(s->stress(X, 1) - reference->stress(X, 0))
           /mag(reference->stress(X, 0))
          + mag(s->displacement(X, 1) - reference->displacement(X, 0))
           /mag(reference->displacement(X, 0))
          + mag(s->stress(X, 0));
    };
    c.checkBelow
    (
        "loads follow the time",
        doubled("type beamSelfWeight; length 2;", "bodyForce", steel)
      + doubled
        (
            "type beamFlexure; width 1; height 1; length 1;", "force", steel
        )
      + doubled
        (
            "type manufactured; length 80;", "amplitude",
            "type neoHookean; E 1; nu 0.2;"
        ), 1e-12
    );
}


static void checkErrors(checks& c)
{
    const auto refused = [&]
    (
        const std::string& what, const std::string& text,
        const std::string& message
    )
    {
        c.checkFatal(what, [&]{ solution(text, steel); }, message);
    };
    refused("an unknown solution", "type beam;", "beamFlexure");
    refused
    (
        "an unknown keyword",
        "type beamSelfWeight; length 1; bodyForce 1; gravity 9.81;", "gravity"
    );
    refused("a missing load", "type beamSelfWeight; length 1;", "bodyForce");
    refused
    (
        "a negative width",
        "type beamFlexure; width -1; height 1; length 1; force 1;",
        "'width' must be above zero"
    );
    c.checkFatal
    (
        "a wrong material", [&]{ solution(selfWeight, "type steel;"); }, "steel"
    );
    c.checkFatal
    (
        "a point outside the beam",
        [&]{ solution(flexure, steel)->stress(point(0.2, 0, 1), 0); }, "outside"
    );
    c.checkFatal
    (
        "too large an amplitude",
        [&]
        {
            solution
            (
                "type manufactured; amplitude 0.5;",
                "type neoHookean; E 1; nu 0.3;"
            )->stress(point(0.5, 0.5, 0), 0);
        },
        "reduce 'amplitude'"
    );
}


void checkSolutions(checks& c)
{
    checkAllEquations(c);
    checkSides(c);
    checkHole(c);
    checkResultants(c);
    checkFlexureTable(c);
    checkManufacturedTable(c);
    checkTime(c);
    checkErrors(c);
}

} // End namespace fsbi
} // End namespace Foam
