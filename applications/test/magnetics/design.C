/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "magneticChecks.H"
#include "fieldDesign.H"
#include "OSspecific.H"
#include "SubField.H"

#include <functional>

namespace Foam
{
namespace fsbi
{

//- Uniform field and gradient, as in constant/effects
static const std::string freeFields
(
    "hold { type uniform; B (0 0 0); }"
    " pull { type gradient; centre (3 -2 1); axis (1 0 0); axial 0; }"
);

//- Eight coils around the origin
static std::string coils()
{
    std::string text;
    for (label i = 0; i < 8; ++i)
    {
        const std::string signs[] = {"", "-"};
        const std::string at
        (
            "(" + signs[i & 1] + "3e4 " + signs[i >> 1 & 1] + "4e4 "
          + signs[i >> 2] + "5e4)"
        );
        // no symmetry
        text += "c" + std::to_string(i) + " { type coil; centre " + at
          + "; axis (" + std::to_string(1 + i % 3) + " "
          + std::to_string(i % 2 - 2*(i/4)) + " "
          + std::to_string(2 - i % 4) + "); radius 2e4; turns 300;"
            " current 0; } ";
    }
    return text;
}


struct trial
{
    units u = unitsOf("microvascular");
    dictionary fields;
    PtrList<drivenField> driven;
    autoPtr<magnetisation> law;
    fieldDesign::task task;

    trial
    (
        const std::string& magnet, const std::string& given, const point& x,
        const std::string& design = ""
    )
    :
        fields(dictOf(given)),
        law(magnetisation::New(dictOf(magnet)))
    {
        const dictionary limits(dictOf(design));
        for (const entry& e : fields)
        {
            driven.append
            (
                new drivenField
                (
                    e.keyword(), limits.subOrEmptyDict(e.keyword()), e.dict(), u
                )
            );
            const drivenField& f = driven.last();
            for (label i = 0; i < f.size(); ++i)
            {
                task.sources.append({f.unit(i, x), f.limit(), f.scale()});
            }
        }
    }

    //- Of a body of 4/3 um^3
    fieldDesign::solution solve
    (
        const vector& F, const vector& T, const vector& bias = Zero,
        const scalarField& start = scalarField()
    )
    {
        task.force = F;
        task.torque = T;
        const scalar volume = 4.0/3*1e-18;
        const scalar largest =
            fieldDesign::load(F, T, fieldDesign::radius(volume, u));
        return fieldDesign
        (
            law(), volume, u, largest, bias, fields
        ).solve(task, start);
    }
};


//- Least |G|^2 of a symmetric traceless G with G e = f
static symmTensor leastGradient(const vector& e, const vector& f)
{
    const vector across(f - (f & e)*e);
    return
        0.5*(f & e)*(3*sqr(e) - symmTensor::I) + twoSymm(e*across);
}


static void checkLeastNorm(checks& c)
{
    const vector F(2e-4, -1e-4, 3e-4);
    const scalar m = 4.0/3*1e-13, joule = 1e15, metre = 1e6;
    // a permanent magnet: G m = F, m x B = T, both the least
    trial magnet
    (
        "type permanent; direction (2 1 -2); magnetisation 1e5;", freeFields,
        point(3, -2, 1)
    );
    magnet.task.R = quaternion(vector(1, 2, 2)/3, 0.7).R();
    const vector e(magnet.task.R & vector(2, 1, -2)/3);
    const vector T((e ^ vector(1, 2, 3))*1e-4);
    const auto s(magnet.solve(F, T));
    const vector B(T ^ e/(joule*m));
    const symmTensor G(leastGradient(e, F/(joule*m)));
    c.checkBelow
    (
        "permanent: B and its gradient of least norm",
        mag(s.made.B - B)/mag(B) + mag(symm(s.made.gradient) - G)/mag(G), 1e-6
    );
    c.checkBelow("permanent: the load is made", s.residual, 1e-9);
    const auto aligned(magnet.solve(F, T, 0.01*e));
    c.checkBelow
    (
        "permanent: a bias adds along the moment only",
        mag(aligned.made.B - B - 0.01*e)/0.01 + aligned.residual, 1e-6
    );

    // a soft sphere: F = a g B along B, B^2 + (3/2) g^2 the least
    trial soft
    (
        "type soft; susceptibility 3; semiAxes (1 1 1);", freeFields,
        point(3, -2, 1), "pull { scale 50; }"
    );
    const scalar a = joule*4.0/3*1e-18*3/(mu0SI*2)/metre;
    const auto induced(soft.solve(F, Zero));
    const scalar b = sqrt(sqrt(1.5)/50*mag(F)/a);
    c.checkBelow
    (
        "soft sphere: B along the force, of least norm",
        mag(mag(induced.made.B & F)/(mag(F)*b) - 1)
      + mag(induced.made.B ^ F)/(mag(F)*b), 1e-4
    );
    c.checkBelow("soft sphere: the load is made", induced.residual, 1e-6);
    const scalarField turned(-0.9*induced.strengths);
    c.checkBelow
    (
        "soft sphere: of B and -B the nearer to the start",
        mag(soft.solve(F, Zero, Zero, turned).made.B + induced.made.B)/b, 1e-4
    );

    // saturated: any field, the bias decides
    trial iron
    (
        "type saturated; magnetisation 1e5;", freeFields, point(3, -2, 1)
    );
    const vector bias(0.01, 0.03, -0.02);
    const auto strong(iron.solve(F, Zero, bias));
    const symmTensor least(leastGradient(bias/mag(bias), F/(joule*m)));
    c.checkBelow
    (
        "saturated: the bias, and the least gradient",
        mag(strong.made.B - bias)/mag(bias)
      + mag(symm(strong.made.gradient) - least)/mag(least), 1e-5
    );
}


//- Loads of the effect with the fields that were found, as run by fsbiFoam
static sixVector loadsOf
(
    const trial& t, const fieldDesign::solution& s, const std::string& magnet,
    const point& x
)
{
    dictionary fields(t.fields);
    label k = 0;
    for (const drivenField& f : t.driven)
    {
        const fileName file("designed." + f.name());
        const scalarField now(SubField<scalar>(s.strengths, f.size(), k));
        k += f.size();
        f.writeTable(file, scalarList({0, 1}), List<scalarField>(2, now));
        dictionary& dict = fields.subDict(f.name());
        const word type(dict.get<word>("type"));
        const word key
        (
            type == "coil" ? "current" : type == "uniform" ? "B" : "components"
        );
        if (type == "gradient")
        {
            dict.remove("axis");
            dict.remove("axial");
        }
        dict.set
        (
            key, dictOf("type tableFile; file \"" + file + "\";")
        );
    }
    magneticScene scene;
    scene[0].at.centre = x;
    OStringStream text;
    text << "fields {";
    for (const entry& e : fields)
    {
        text << e;
    }
    text << "} bodies { first {" << magnet.c_str() << "} }";
    const auto magnets(scene.make(text.str()));
    const sixVector load(scene.at(magnets()).whole(0));
    for (const drivenField& f : t.driven)
    {
        rm(fileName("designed." + f.name()));
    }
    return load;
}


static void checkReplay(checks& c)
{
    const std::string magnets[] =
    {
        "type permanent; direction (1 2 -1); magnetisation 1e5;",
        "type saturated; magnetisation 1e5;",
        "type soft; susceptibility 3; semiAxes (1 1 1);",
        "type soft; susceptibility 100; semiAxes (1 1 4);"
    };
    const point x(700, -400, 200);
    const vector F(2e-4, -1e-4, 3e-4);
    for (const std::string& magnet : magnets)
    {
        const bool permanent = magnet == magnets[0];
        for (const std::string& given : {freeFields, coils()})
        {
            trial t(magnet, given, x);
            const vector T
            (
                permanent ? 1e-4*(vector(1, 2, -1) ^ vector(3, 1, 1)) : Zero
            );
            const auto s
            (
                t.solve(F, T, permanent ? vector(Zero) : vector(0, 0, 0.01))
            );
            const sixVector load(loadsOf(t, s, magnet, x));
            c.checkBelow
            (
                "the effect makes the load designed (" + magnet.substr(5, 9)
              + (given == freeFields ? ", field)" : ", coils)"),
                mag(linear(load) - F)/mag(F) + mag(angular(load) - T)/1e-3,
                1e-6
            );
        }
    }
}


static void checkLimits(checks& c)
{
    const std::string magnet
    (
        "type permanent; direction (1 2 -1); magnetisation 1e5;"
    );
    const point x(700, -400, 200);
    const vector F(2e-4, -1e-4, 3e-4);
    trial free(magnet, coils(), x);
    const auto unlimited(free.solve(F, Zero));
    const scalar most = max(mag(unlimited.strengths));
    std::string text;
    for (label i = 0; i < 8; ++i)
    {
        text += "c" + std::to_string(i) + " { limit "
          + std::to_string(0.9*most) + "; scale 1; } ";
    }
    trial tight(magnet, coils(), x, text);
    const auto limited(tight.solve(F, Zero));
    c.checkBelow
    (
        "currents stay within their limits",
        max(mag(limited.strengths))/(0.9*most), 1 + 1e-12
    );
    c.checkBelow("and still make the load", limited.residual, 1e-6);
    c.check
    (
        "at a larger sum of squares",
        sumSqr(limited.strengths) > sumSqr(unlimited.strengths)
    );

    trial one(magnet, "a { type coil; centre (0 0 3e4); axis (0 0 1);"
        " radius 2e4; turns 300; current 0; }", x);
    c.check
    (
        "what one coil cannot make is in the residual",
        one.solve(F, Zero).residual > 0.1
    );
    trial sphere
    (
        "type soft; susceptibility 3; semiAxes (1 1 1);", freeFields, x
    );
    c.checkClose
    (
        "so is a torque on a soft sphere",
        sphere.solve(Zero, vector(0, 0, 1e-4)).residual, 1, 1e-6
    );
}


static void checkWrongDesigns(checks& c)
{
    const auto wrong = [&]
    (
        const std::string& name, const std::function<void()>& action,
        const std::string& message
    )
    {
        c.checkFatal(name, action, message);
    };
    const std::string iron("type saturated; magnetisation 1e5;");
    const auto field = [&](const std::string& design, const std::string& text)
    {
        drivenField
        (
            "a", dictOf(design), dictOf(text), unitsOf("microvascular")
        );
    };
    const std::string up("type uniform; B (0 0 1);");
    wrong("no limit at all", [&]{ field("limit 0;", up); },
        "'limit' must be above zero");
    wrong("unknown keyword of a field", [&]{ field("max 3;", up); }, "'max'");
    wrong("a field that cannot be driven", [&]{ field("",
        "type dipole; moment (0 0 1); position (0 0 9);"); },
        "(coil uniform gradient)");
    wrong("saturated without a bias", [&]{ trial(iron, freeFields,
        Zero).solve(vector(1, 0, 0), Zero); }, "'bias'");
    const dictionary where(dictOf("type saturated;"));
    const auto law(magnetisation::New(dictOf(iron)));
    wrong("a body without volume", [&]{ fieldDesign(law(), 0,
        unitsOf("microvascular"), 1, vector(0, 0, 1), where); }, "volume 0");
}


void checkDesign(checks& c)
{
    checkLeastNorm(c);
    checkReplay(c);
    checkLimits(c);
    checkWrongDesigns(c);
}

} // End namespace fsbi
} // End namespace Foam
