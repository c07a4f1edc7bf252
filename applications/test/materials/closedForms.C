/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Description
    Checks of the solid materials against closed forms.

\*---------------------------------------------------------------------------*/

#include "checks.H"
#include "references.H"
#include "testMaterial.H"
#include "mathematicalConstants.H"
#include "quaternion.H"

#include <algorithm>

using namespace Foam;
using namespace Foam::fsbi;
using constant::mathematical::pi;

static void checkBars(checks& c)
{
    scalar stress = 0, sides = 0, change = 0, slope = 0;
    for (const references::bar& r : references::bars)
    {
        const autoPtr<solidMaterial> m(material("StVenantKirchhoff", r.nu));
        const scalar lateral = Foam::sqrt(1 - r.nu*(sqr(r.stretch) - 1));
        const tensor F(r.stretch, 0, 0, 0, lateral, 0, 0, 0, lateral);
        const tensor P(m->stress(F));
        stress = max(stress, mag(P.xx() - r.P));
        stress = max(stress, mag(P.xx()*r.stretch/r.J - r.cauchy));
        sides = max(sides, mag(P.yy()) + mag(P.zz()));
        change = max(change, mag(lateral - r.lateral) + mag(det(F) - r.J));

        // lateral stretch that keeps the sides free of stress
        const tensor along(m->tangent(F, tensor(1, 0, 0, 0, 0, 0, 0, 0, 0)));
        const tensor across(m->tangent(F, tensor(0, 0, 0, 0, 1, 0, 0, 0, 1)));
        slope = max
        (
            slope,
            mag(along.xx() - across.xx()*along.yy()/across.yy() - r.slope)
        );
    }
    c.checkBelow("St. Venant-Kirchhoff bar: stress", stress, 5e-9);
    c.checkBelow("St. Venant-Kirchhoff bar: free sides", sides, 1e-14);
    c.checkBelow("St. Venant-Kirchhoff bar: lateral stretch", change, 1e-8);
    c.checkBelow("St. Venant-Kirchhoff bar: slope, 0 at 0.577", slope, 2e-9);
}


static void checkShears(checks& c)
{
    scalar worst = 0;
    for (const references::shear& r : references::shears)
    {
        const autoPtr<solidMaterial> m(material("StVenantKirchhoff", r.nu));
        const tensor P(m->stress(tensor(1, r.k, 0, 0, 1, 0, 0, 0, 1)));
        worst = max
        (
            worst,
            mag(P - tensor(r.P11, r.P12, 0, r.P21, r.P22, 0, 0, 0, r.P33))
        );
    }
    c.checkBelow("St. Venant-Kirchhoff in simple shear: stress", worst, 5e-9);
}


// A bar's P = E (L - 1) and simple shear, both turned: Hooke's line for Biot's
// strain, whose stretch and rotation have closed forms here
static void checkTurned(checks& c)
{
    const tensor Q(quaternion(normalised(vector(1, -2, 3)), 2.5).R());
    scalar bar = 0, shear = 0;
    for (const scalar nu : {-0.2, 0.0, 0.3, 0.45})
    {
        const autoPtr<solidMaterial> m(material("corotationalElastic", nu));
        for (const scalar e : {-0.3, -0.01, 1e-6, 0.05, 0.4})
        {
            const tensor F(1 + e, 0, 0, 0, 1 - nu*e, 0, 0, 0, 1 - nu*e);
            const tensor P(Q.T() & m->stress(Q & F));
            bar = max(bar, mag(P - tensor(e, 0, 0, 0, 0, 0, 0, 0, 0)));

            // the angle of R is -atan(e/2), the trace of U 1 + sqrt(4 + e^2)
            const scalar length = Foam::sqrt(4 + sqr(e));
            const tensor R
            (
                2/length, e/length, 0, -e/length, 2/length, 0, 0, 0, 1
            );
            const tensor H(tensor(1, e, 0, 0, 1, 0, 0, 0, 1));
            const tensor exact
            (
                2*m->mu()*(H - R) + m->lambda()*(length - 2)*R
            );
            shear = max(shear, mag((Q.T() & m->stress(Q & H)) - exact));
        }
    }
    c.checkBelow("corotationalElastic, turned bar: P = E (L - 1)", bar, 1e-14);
    c.checkBelow("corotationalElastic, turned simple shear", shear, 1e-14);
}


// Deformation gradient of the manufactured displacement
static tensor manufacturedF(const references::manufactured& r)
{
    const vector s(Foam::sin(pi*r.X), Foam::sin(pi*r.Y), Foam::sin(pi*r.Z));
    const vector k(Foam::cos(pi*r.X), Foam::cos(pi*r.Y), Foam::cos(pi*r.Z));
    const vector s2(Foam::sin(2*pi*r.X), Foam::sin(2*pi*r.Y), Foam::sin(2*pi*r.Z));
    const vector k2(Foam::cos(2*pi*r.X), Foam::cos(2*pi*r.Y), Foam::cos(2*pi*r.Z));
    return tensor::I + r.A*pi*tensor
    (
        2*k2.x()*s.y()*k.z(), s2.x()*k.y()*k.z(), -s2.x()*s.y()*s.z(),
        -s.x()*s2.y()*s.z(), 2*k.x()*k2.y()*s.z(), k.x()*s2.y()*k.z(),
        k.x()*k.y()*s2.z(), -s.x()*s.y()*s2.z(), 2*s.x()*k.y()*k2.z()
    );
}


static void checkManufactured(checks& c)
{
    for (const references::manufactured& r : references::manufactureds)
    {
        const tensor F(manufacturedF(r));
        tensor P;
        std::copy(std::begin(r.P), std::end(r.P), P.begin());
        const std::string is
        (
            std::string(r.law) + ": manufactured stress at J "
          + Foam::name(r.J)
        );
        c.checkBelow(is, mag(material(r.law, 0.3)->stress(F) - P), 2e-10);
    }
}


static void checkMooneyRivlin(checks& c)
{
    const tensor F(manufacturedF(references::manufactureds[1]));
    c.checkBelow
    (
        "MooneyRivlin with share 0 is neoHookean",
        mag
        (
            material("MooneyRivlin; share 0", 0.3)->stress(F)
          - material("neoHookean", 0.3)->stress(F)
        ),
        1e-15
    );

    // The incompressible law in pure shear, J = 1: the differences of its
    // Cauchy stresses, 2 (C10 + C01)(L2 - 1/L2) and 2 (C10 + C01/L2)(L2 - 1)
    const scalar L = 1.7;
    const tensor stretch(L, 0, 0, 0, 1/L, 0, 0, 0, 1);
    const autoPtr<solidMaterial> m(material("MooneyRivlin; share 0.3", 0.4));
    const tensor sigma(m->stress(stretch) & stretch);
    c.checkClose
    (
        "MooneyRivlin in pure shear: in-plane difference",
        sigma.xx() - sigma.yy(), m->mu()*(L*L - 1/(L*L)), 1e-12
    );
    c.checkClose
    (
        "MooneyRivlin in pure shear: out-of-plane difference",
        sigma.xx() - sigma.zz(),
        m->mu()*(L*L - 1)*(0.7 + 0.3/(L*L)), 1e-12
    );
}


void checkClosedForms(checks& c)
{
    checkBars(c);
    checkShears(c);
    checkTurned(c);
    checkManufactured(c);
    checkMooneyRivlin(c);
}
