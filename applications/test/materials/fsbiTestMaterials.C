/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Application
    fsbiTestMaterials

Description
    Checks of the solid materials: stress and tangent against differences of
    energy and stress, objectivity, symmetry, Hooke's law at small strain,
    closed forms, and the refusal of wrong entries.

\*---------------------------------------------------------------------------*/

#include "checks.H"
#include "testMaterial.H"
#include "quaternion.H"
#include "Random.H"
#include "IFstream.H"
#include "clockTime.H"
#include "OSspecific.H"

#include <functional>

using namespace Foam;
using namespace Foam::fsbi;

// In closedForms.C
void checkClosedForms(checks& c);

static const char* const laws[] =
{
    "linearElastic",
    "corotationalElastic",
    "StVenantKirchhoff",
    "neoHookean",
    "MooneyRivlin",
    "MooneyRivlin; share 1"
};

constexpr label nSamples = 20;

// Step of the central differences: their error is about its square
constexpr scalar step = 1e-5;
constexpr scalar differenceError = 1e-8;


static bool isLinear(const std::string& law)
{
    return law == "linearElastic";
}


static tensor randomTensor(Random& random)
{
    tensor t;
    for (direction d = 0; d < tensor::nComponents; ++d)
    {
        t[d] = 2*random.sample01<scalar>() - 1;
    }
    return t;
}


// Large strain and rotation, volume ratio of 0.3 and more
static tensor randomF(Random& random)
{
    tensor F(Zero);
    while (det(F) < 0.3)
    {
        F = tensor::I + 0.5*randomTensor(random);
    }
    return F;
}


static tensor randomRotation(Random& random)
{
    const scalar a = random.sample01<scalar>(), b = random.sample01<scalar>();
    const vector axis(0.3, a, b);
    return quaternion(axis/mag(axis), 3*random.sample01<scalar>()).R();
}


static void checkDerivatives(checks& c, const std::string& law)
{
    const autoPtr<solidMaterial> m(material(law, 0.4));
    Random random(1);
    scalar energy = 0, shear = 0, volume = 0;
    scalar tangent = 0, shearTangent = 0, volumeTangent = 0, symmetry = 0;
    for (label i = 0; i < nSamples; ++i)
    {
        const tensor F(randomF(random));
        const tensor dF(randomTensor(random)), other(randomTensor(random));
        auto worst = [](scalar& w, const auto& a, const auto& b)
        {
            w = max(w, mag(a - b)/(1 + mag(b)));
        };
        // slope along dF, by a central difference
        auto slope = [&](auto function)
        {
            return
                (std::invoke(function, *m, F + step*dF)
               - std::invoke(function, *m, F - step*dF))/(2*step);
        };
        using type = solidMaterial;
        worst(energy, slope(&type::energy), m->stress(F) && dF);
        worst(shear, slope(&type::shearEnergy), m->shearStress(F) && dF);
        worst(volume, slope(&type::theta), m->thetaGradient(F) && dF);
        worst(tangent, slope(&type::stress), m->tangent(F, dF));
        worst(shearTangent, slope(&type::shearStress), m->shearTangent(F, dF));
        worst(volumeTangent, slope(&type::thetaGradient), m->thetaTangent(F, dF));
        worst(symmetry, m->tangent(F, dF) && other, m->tangent(F, other) && dF);
    }
    const std::string is = law + ": ";
    constexpr scalar bound = differenceError;
    c.checkBelow(is + "stress is the slope of the energy", energy, bound);
    c.checkBelow(is + "shear stress is that of W_mu", shear, bound);
    c.checkBelow(is + "gradient of theta", volume, bound);
    c.checkBelow(is + "tangent is the slope of the stress", tangent, bound);
    c.checkBelow(is + "shear tangent", shearTangent, bound);
    c.checkBelow(is + "tangent of theta", volumeTangent, bound);
    c.checkBelow(is + "tangent is symmetric", symmetry, 1e-12);
}


static void checkInvariance(checks& c, const std::string& law)
{
    const autoPtr<solidMaterial> m(material(law, 0.4));
    Random random(2);
    scalar turned = 0, rigid = 0, moment = 0, isotropy = 0;
    for (label i = 0; i < nSamples; ++i)
    {
        const tensor F(randomF(random));
        const tensor Q(randomRotation(random));
        const tensor P(m->stress(F));
        turned = max(turned, mag(m->stress(Q & F) - (Q & P)));
        rigid = max(rigid, mag(m->stress(Q)));
        moment = max(moment, mag(skew(P & F.T())));
        isotropy = max(isotropy, mag(m->stress(F & Q) - (P & Q)));
    }
    const std::string is = law + ": ";
    if (isLinear(law))
    {
        c.checkBelow
        (
            is + "stress is symmetric",
            mag(skew(m->stress(randomF(random)))), 1e-14
        );
        return;
    }
    c.checkBelow(is + "P(QF) = Q P(F)", turned, 1e-12);
    c.checkBelow(is + "P(FQ) = P(F) Q", isotropy, 1e-12);
    c.checkBelow(is + "no stress when turned", rigid, 1e-13);
    c.checkBelow(is + "Cauchy stress is symmetric", moment, 1e-12);
    c.check
    (
        is + "not defined inside out",
        m->defined(tensor::I) && !m->defined(-tensor::I)
    );
}


// Largest difference to Hooke's law at strains of this amplitude, relative to
// the stress; the pressure form p = -lambda theta must agree, too
static scalar nonlinearity
(
    const solidMaterial& m, const solidMaterial& hooke, const scalar amplitude
)
{
    Random random(3);
    scalar worst = 0;
    for (label i = 0; i < nSamples; ++i)
    {
        const tensor F(tensor::I + amplitude*randomTensor(random));
        worst = max(worst, mag(m.stress(F) - hooke.stress(F)));
        worst = max(worst, mag(m.shearStress(F) - hooke.shearStress(F)));
        worst = max(worst, mag(m.theta(F) - hooke.theta(F)));
    }
    return worst/amplitude;
}


static void checkSmallStrain(checks& c, const std::string& law)
{
    for (const scalar nu : {-0.3, 0.0, 0.4})
    {
        const autoPtr<solidMaterial> m(material(law, nu));
        const autoPtr<solidMaterial> hooke(material("linearElastic", nu));
        const scalar coarse = nonlinearity(m(), hooke(), 1e-3);
        const scalar fine = nonlinearity(m(), hooke(), 1e-4);
        c.checkClose
        (
            law + ": differs from Hooke by the square of the strain, nu "
          + Foam::name(nu),
            std::log10(coarse/fine), 1, 0.02
        );
        c.checkBelow
        (
            law + ": no stress at rest, nu " + Foam::name(nu),
            mag(m->stress(tensor::I)) + mag(m->energy(tensor::I))
          + mag(m->theta(tensor::I)), 1e-15
        );
    }
}


static void checkViscosity(checks& c, const std::string& law)
{
    const autoPtr<solidMaterial> m
    (
        material("type " + law + "; E 1; nu 0.3; viscosity 0.7;")
    );
    Random random(4);
    scalar tangent = 0, turned = 0, rigid = 0, power = GREAT, moment = 0;
    for (label i = 0; i < nSamples; ++i)
    {
        const tensor F(randomF(random)), Fdot(randomTensor(random));
        const tensor dF(randomTensor(random)), dFdot(randomTensor(random));
        const tensor slope
        (
            (m->viscousStress(F + step*dF, Fdot + step*dFdot)
           - m->viscousStress(F - step*dF, Fdot - step*dFdot))/(2*step)
        );
        tangent = max
        (
            tangent, mag(slope - m->viscousTangent(F, Fdot, dF, dFdot))
        );
        power = min(power, m->viscousStress(F, Fdot) && Fdot);

        // the same motion seen by an observer who turns
        const tensor Q(randomRotation(random));
        const tensor spin(skew(randomTensor(random)));
        const tensor P(m->viscousStress(F, Fdot));
        const tensor Frate((Q & Fdot) + (spin & Q & F));
        turned = max(turned, mag(m->viscousStress(Q & F, Frate) - (Q & P)));
        rigid = max(rigid, mag(m->viscousStress(F, spin & F)));
        moment = max(moment, mag(skew(P & F.T())));
    }
    const std::string is = law + ": viscous ";
    const tensor rate(randomTensor(random));
    c.checkBelow(is + "tangent", tangent, differenceError);
    c.check(is + "power is dissipated", power > 0, Foam::name(power));
    c.checkBelow
    (
        is + "stress at rest is 2 eta sym(rate)",
        mag(m->viscousStress(tensor::I, rate) - 1.4*symm(rate)), 1e-14
    );
    if (!isLinear(law))
    {
        c.checkBelow(is + "stress is objective", turned, 1e-12);
        c.checkBelow(is + "stress vanishes in a rigid motion", rigid, 1e-13);
        c.checkBelow(is + "Cauchy stress is symmetric", moment, 1e-12);
    }
}


static void checkWarnings(checks& c)
{
    const string text(material("StVenantKirchhoff", 0.3)->warning(0.7, 0.57));
    c.check
    (
        "St. Venant-Kirchhoff warns of its softening",
        text.find("0.57") != std::string::npos
     && text.find("neoHookean") != std::string::npos,
        text
    );
    c.check
    (
        "and not above a stretch of 0.577",
        material("StVenantKirchhoff", 0.3)->warning(0.7, 0.58).empty()
    );
    const auto turning = material("corotationalElastic", 0.3);
    c.check
    (
        "corotationalElastic warns of strains from 10 % on",
        turning->warning(1, 0.91).empty()
     && turning->warning(1, 0.89).find("0.89") != std::string::npos
    );
    c.check
    (
        "linearElastic points to corotationalElastic",
        material("linearElastic", 0.3)->warning(1.2, 1).find
        (
            "corotationalElastic"
        ) != std::string::npos
    );
    const auto soft = material("neoHookean", 0.3);
    c.check
    (
        "neoHookean warns of nothing but volumes that are crushed",
        soft->warning(0.4, 0.1).empty()
     && soft->warning(0.2, 0.6).find("0.2 of its volume") != std::string::npos
    );
}


static void checkErrors(checks& c)
{
    struct mistake
    {
        const char* what;
        const char* entries;
        const char* message;
    };
    const mistake mistakes[] =
    {
        {"nu of 0.5", "type neoHookean; E 1; nu 0.5;", "pressure of their own"},
        {"nu of -1", "type neoHookean; E 1; nu -1;", "(-1, 0.5)"},
        {"no nu", "type neoHookean; E 1;", "'nu'"},
        {"E of 0", "type linearElastic; E 0; nu 0.3;", "'E'"},
        {"negative E", "type linearElastic; E -2; nu 0.3;", "'E'"},
        {"no E", "type linearElastic; nu 0.3;", "'E'"},
        {"a density of 0", "type neoHookean; E 1; nu 0; density 0;",
            "'density'"},
        {"a negative density", "type neoHookean; E 1; nu 0; density -1;",
            "'density'"},
        {"a negative viscosity", "type neoHookean; E 1; nu 0; viscosity -1;",
            "'viscosity'"},
        {"an unknown law", "type Hooke; E 1; nu 0.3;", "StVenantKirchhoff"},
        {"no law", "E 1; nu 0.3;", "'type'"},
        {"a misspelt keyword", "type neoHookean; E 1; nu 0.3; densty 1;",
            "Unknown keyword 'densty'"},
        {"a cortex that nobody reads", "type neoHookean; E 1; nu 0; cortex {}",
            "Unknown keyword 'cortex'"},
        {"the stiffness of a liquid", "type liquid; viscosity 1; E 1;",
            "Unknown keyword 'E'"},
        {"a liquid without viscosity", "type liquid;", "'viscosity'"},
        {"the keyword of another law", "type neoHookean; E 1; nu 0; share 0.5;",
            "Unknown keyword 'share'"},
        {"a share above 1", "type MooneyRivlin; E 1; nu 0; share 1.1;",
            "'share'"}
    };
    for (const mistake& m : mistakes)
    {
        c.checkFatal
        (
            std::string(m.what) + " is refused", [&]{ material(m.entries); },
            m.message
        );
    }
}


static void checkExample(checks& c)
{
    const fileName etc(fileName(getEnv("FSBI_DIR"))/"etc");
    IFstream file(etc/"dictionaries/solidMaterial");
    dictionary dict(file);
    dict.remove("FoamFile");
    const autoPtr<solidMaterial> m(solidMaterial::New(dict));
    c.checkClose("the annotated dictionary: mu", m->mu(), m->E()/2.9, 1e-14);
    c.checkClose("the annotated dictionary: lambda", m->lambda(), m->mu()*0.9/0.1, 1e-13);
    c.checkClose("the annotated dictionary: density", m->density(), 1, 0);
    c.checkClose("the annotated dictionary: nu", m->nu(), 0.45, 0);
    c.checkClose("the annotated dictionary: viscosity", m->viscosity(), 0, 0);
    c.checkClose
    (
        "the default of the density", material("neoHookean", 0.3)->density(), 0, 0
    );
}


// The kernels are called per face and Krylov iteration
static void checkSpeed(checks& c, const std::string& law)
{
    const autoPtr<solidMaterial> m(material(law, 0.4));
    Random random(5);
    const tensor F(randomF(random));
    tensor dF(randomTensor(random));
    constexpr label calls = 1000000;
    clockTime time;
    for (label i = 0; i < calls; ++i)
    {
        dF = m->tangent(F, dF)/(1 + mag(dF));
    }
    const scalar whole = time.timeIncrement();
    for (label i = 0; i < calls; ++i)
    {
        dF = m->shearTangent(F, dF)/(1 + mag(dF));
    }
    const scalar shear = time.timeIncrement();
    c.check
    (
        law + ": a tangent takes less than a microsecond",
        whole < 1 && mag(dF) < GREAT, Foam::name(whole) + " us"
    );
    Info<< "    tangent " << 1e3*whole << " ns, shear tangent " << 1e3*shear
        << " ns" << endl;
}


int main()
{
    checks c;
    for (const std::string law : laws)
    {
        checkDerivatives(c, law);
        checkInvariance(c, law);
        checkViscosity(c, law);
        if (!isLinear(law))
        {
            checkSmallStrain(c, law);
        }
        checkSpeed(c, law);
    }
    checkClosedForms(c);
    checkWarnings(c);
    checkErrors(c);
    checkExample(c);
    return c.finish();
}
