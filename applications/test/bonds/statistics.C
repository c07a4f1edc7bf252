/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bondChecks.H"
#include "bonds.H"
#include "caps.H"
#include "mathematicalConstants.H"

using Foam::constant::mathematical::twoPi;

namespace Foam
{
namespace fsbi
{

static const scalar on = 2e-5, off = 1e-3, rest = 0.05, stiffness = 2;

// Exact mean number of bonds on a sphere's cap in equilibrium: every receptor
// is a two-state process with the ratio that the energy alone decides
static scalar expected
(
    const scalar receptors,
    const scalar ligands,
    const std::function<scalar(scalar)>& gap
)
{
    const label n = 4000;
    const scalar a = 0.5*stiffness/kT(310), top = 0.1;
    scalar sum = 0;
    for (label i = 0; i < n; ++i)
    {
        const scalar z = (i + 0.5)*top/n;
        const scalar x = gap(z) - rest;
        const scalar ratio = ligands*on/off*twoPi
           *(
                exp(-a*x*x)/(2*a)
              + 0.5*rest*sqrt(constant::mathematical::pi/a)
               *std::erfc(sqrt(a)*x)
            );
        sum += ratio/(1 + ratio);
    }
    return receptors*twoPi*4*top/n*sum;     // zones of a sphere of radius 4
}


//- Mean of some seeds after a time in some steps, and its deviation
static scalar meanNumber
(
    testScene& scene, const std::string& what, const label steps,
    scalar& deviation
)
{
    const label seeds = 12;
    scalar sum = 0, squares = 0;
    for (label seed = 0; seed < seeds; ++seed)
    {
        scene.restartClock();
        autoPtr<bonds> b(scene.make(what, seed));
        for (label i = 0; i < steps; ++i)
        {
            scene.step(b(), 8e3/steps);
        }
        sum += b->all().size();
        squares += sqr(scalar(b->all().size()));
    }
    deviation = sqrt((squares/seeds - sqr(sum/seeds))/(seeds - 1));
    return sum/seeds;
}


static void checkNumbers(checks& c)
{
    const std::string onWall
    (
        "molecules { cap { A { density 1000; } } floor { B { density 1e5; } } }"
        " pairs { " + pairText("(A B)", "", on) + "}"
    );
    const scalar g0 = 0.03;
    const scalar exact = expected(1000, 1e5, [=](scalar z){ return g0 + z; });
    scalar deviation;
    scalarList errors, deviations;
    for (const scalar size : {0.4, 0.2, 0.1})
    {
        testScene scene(size, g0);
        scene.addWall();
        errors.append(meanNumber(scene, onWall, 1, deviation) - exact);
        deviations.append(deviation);
        Info<< "    " << exact << " bonds expected, triangles of " << size
            << ": " << errors.last() << " more, deviation " << deviation
            << endl;
    }
    c.check
    (
        "bonds in equilibrium: triangles converge at second order",
        mag(errors[0]) > 2.5*mag(errors[1])
     && mag(errors[1]/4 - errors[2]) <= 3*deviations[2]
    );
    testScene scene(0.025, g0);
    scene.addWall();
    scalar once = 0;
    for (const label steps : {1, 10})
    {
        const scalar mean = meanNumber(scene, onWall, steps, deviation);
        checkSigma
        (
            c, "bonds in equilibrium, steps: " + std::to_string(steps), mean,
            exact, deviation
        );
        once = steps == 1 ? mean : once;
    }
    c.check
    (
        "a density wrong by a tenth would be noticed",
        !agrees(expected(1100, 1e5, [=](scalar z){ return g0 + z; }),
            exact, deviation)
    );

    // the wall's molecules named first: the same sites bind
    const scalar turned = meanNumber
    (
        scene,
        "molecules { cap { A { density 1000; } } floor { B { density 1e5; } } }"
        " pairs { " + pairText("(B A)", "", on) + "}", 1, deviation
    );
    c.check("kinds turned: the same bonds", turned == once);

    // over a sphere of radius 8: distance from a point at height z
    testScene spheres(0.025, g0, 0.6);
    spheres.addSphere(0.05, point::max, 0.6);
    const std::string onSphere
    (
        "molecules { cap { A { density 1000; } } ball { B { density 1e5; } } }"
        " pairs { " + pairText("(A B)", "", on) + "}"
    );
    const scalar two = meanNumber(spheres, onSphere, 1, deviation);
    const scalar between = expected
    (
        1000, 1e5, [=](scalar z)
        {
            // axis distance squared is 2 4 z - z^2
            return sqrt(sqr(8 + g0 + z) + 8*z - z*z) - 8;
        }
    );
    // the other surface bends away over a bond's length
    checkSigma
    (
        c, "bonds between two spheres", two, between,
        sqrt(sqr(deviation) + sqr(between*rest/8/3))
    );

    // bound: of the statistics alone, with edges at which triangles lose a third
    for (const auto as : {sphereCap::sphere, sphereCap::smoothed})
    {
        const std::string name =
            as == sphereCap::sphere ? ", by its shape" : ", by its smooth surface";
        testScene coarse(0.4, g0);
        coarse.cap->as = as;
        coarse.addWall();
        const scalar onPlane = meanNumber(coarse, onWall, 1, deviation);
        checkSigma
        (
            c, "bonds of a coarse sphere" + name, onPlane, exact, deviation
        );
        testScene both(0.4, g0);
        both.addSphere(0.4);
        both.cap->as = as;
        both.ball->as = as;
        const scalar onBall = meanNumber(both, onSphere, 1, deviation);
        checkSigma
        (
            c, "bonds between two coarse spheres" + name, onBall, between,
            sqrt(sqr(deviation) + sqr(between*rest/8/3))
        );
    }

    testScene post(0.025, g0, 0.6);
    post.addRoundWall(0.05, 0.6);
    const scalar onRound = meanNumber
    (
        post,
        "molecules { cap { A { density 1000; } } round { B { density 1e5; } } }"
        " pairs { " + pairText("(A B)", "", on) + "}", 1, deviation
    );
    checkSigma
    (
        c, "bonds with a wall that is not plane", onRound, between,
        sqrt(sqr(deviation) + sqr(between*rest/8/3))
    );
}


// Bonds that are pulled at a constant speed: the mean extension at which they
// rupture, exactly, from a table of the survival
static scalar ruptureExtension(const scalar from, const scalar speed)
{
    const scalar dx = 1e-6;
    scalar hazard = 0, mean = from;
    for (scalar x = from; x < 0.03; x += dx)
    {
        mean += dx*std::exp(-hazard);
        hazard += dx/speed*3e-7*std::exp(0.5*sqr(x + 0.5*dx)/kT(310));
    }
    return mean;
}


static void checkRupture(checks& c)
{
    const scalar sigma = sqrt(kT(310)/2), speed = 1e-4;
    scalar mean[2];
    for (const label perSigma : {1, 4})
    {
        // bonds stand upright where the gap is their length
        testScene scene(0.05, 0.0495, 0.3);
        scene.addWall();
        autoPtr<bonds> b
        (
            scene.make
            (
                "molecules { cap { A { density 30000; } } floor { B { density"
                " 1e5; blocked table ((0 0) (1000 0) (1000.1 1) (1e6 1)); } } }"
                " pairs { pair { kinds (A B); law Dembo; k0on 3e-3;"
                " k0off 3e-7; lambda 0.05; s 2; sts 1; } }", 1
            )
        );
        scene.step(b(), 1000);
        std::map<label, scalar> starts;
        for (const auto& entry : b->all())
        {
            const point x
            (
                b->molecules().sets()[0].sites[entry.first.second].on
                (
                    scene.cap->placedSurface().points(),
                    scene.cap->placedSurface().triangles()
                )
            );
            const scalar length = mag(x - entry.second.anchor);
            if (length - x.z() < 1e-4)
            {
                starts[entry.first.second] = length - rest;
            }
        }
        const scalar dt = sigma/speed/perSigma;
        scalar sum = 0, squares = 0, exact = 0;
        label n = 0;
        for (label i = 0; i < 20*perSigma; ++i)
        {
            scene.begin(b(), dt);
            for (const bondEvent& e : b->events())
            {
                if (!e.formed && starts.count(e.site))
                {
                    const scalar x = e.length - rest;
                    sum += x;
                    squares += x*x;
                    exact += ruptureExtension(starts[e.site], speed);
                    ++n;
                }
            }
            scene.cap->centre.z() += speed*dt;
            b->endStep();
        }
        const scalar deviation = sqrt((squares/n - sqr(sum/n))/n);
        mean[perSigma == 4] = (sum - exact)/n;
        char line[160];
        snprintf
        (
            line, sizeof(line), "    %d bonds pulled apart at %.2f thermal "
            "lengths, steps of 1/%d: %.3f more than exact, deviation %.3f",
            n, exact/n/sigma, perSigma, mean[perSigma == 4]/sigma,
            deviation/sigma
        );
        Info<< line << endl;
        c.check
        (
            "all upright bonds rupture", n > 100 && n == label(starts.size())
        );
        if (perSigma == 1)
        {
            c.checkBelow
            (
                "length at rupture, steps of a thermal length",
                mag(mean[0])/sigma, 0.2
            );
        }
        else
        {
            checkSigma
            (
                c, "length at rupture, short steps", sum/n, exact/n, deviation
            );
        }
    }
}


//- Rates of all receptors over that of all pairs at the gap: sums over faces of
//  pairs' rates [2.62], corrected to a mean over all faces [2.64-2.66] or over
//  receptors
static scalar onFaces
(
    const adhesion& a, const currentSurfaces& now, const std::string& correction
)
{
    const labelList& receptors = a.populations()[0].numbers;
    const labelList& ligands = a.populations()[1].numbers;
    const auto exponent = [&](const label i, const label j)
    {
        const scalar d = mag(now.centroid(0, i) - now.centroid(1, j));
        return 0.5*(sqr(0.005) - sqr(d - rest))/kT(310);
    };
    scalar largest = 0;         // coarse faces: what underflows cancels out
    if (correction != "none")
    {
        largest = -GREAT;
        forAll(receptors, i)
        {
            forAll(ligands, j)
            {
                largest = max(largest, exponent(i, j));
            }
        }
    }
    const scalar all = sum(receptors);
    scalar ofFaces = 0, ofReceptors = 0;
    forAll(receptors, i)
    {
        scalar rate = 0;
        forAll(ligands, j)
        {
            rate += ligands[j]*exp(exponent(i, j) - largest);
        }
        ofFaces += rate/receptors.size();
        ofReceptors += receptors[i]*rate/all;
    }
    return
        correction == "none" ? ofReceptors/sum(ligands)
      : correction == "global" ? ofReceptors/ofFaces
      : 1;
}


static void checkFaces(checks& c)
{
    const scalar one = 0.02*exp(-0.5*sqr(0.005)/kT(310));
    for (const std::string correction : {"none", "global", "conserving"})
    {
        scalarList totals;
        for (const scalar size : {0.3, 0.15, 0.02})
        {
            const scalar half = size < 0.1 ? 0.3 : 1.2;
            testScene scene(size, 0.045, half);
            scene.addSphere(size, point::max, half);
            autoPtr<bonds> b
            (
                scene.make
                (
                    "molecules { cap { A { density 200; } }"
                    " ball { B { density 200; } } } pairs { "
                  + pairText
                    (
                        "(A B)",
                        "sites faces; faceCorrection " + correction + ";"
                    ) + "}", 5
                )
            );
            const adhesion& a = b->molecules();
            const currentSurfaces now(scene.context());
            bondState state;
            DynamicList<bondEvent> events;
            bondStep step(a, now, state, events, 0);
            scalar total = 0;
            for (label i = 0; i < step.size(); ++i)
            {
                total += step.rate(i);
            }
            total /=
                one*a.populations()[0].molecules.size()
               *a.populations()[1].molecules.size();
            totals.append(total);
            const scalar exact = onFaces(a, now, correction);
            c.checkBelow
            (
                "faces " + correction + ", edges of " + std::to_string(size)
              + ": sum of rates",
                mag(total - exact)/max(exact, VSMALL), 1e-9
            );

            step.advance(1e5);
            List<labelList> bound(2);
            bool fits = state.bonds.size() > 0 || correction == "none";
            for (label p = 0; p < 2; ++p)
            {
                bound[p] = a.populations()[p].numbers;
            }
            for (const auto& entry : state.bonds)
            {
                const label from =
                    a.sets()[0].sites[entry.first.second].triangle;
                fits = fits && --bound[0][from] >= 0
                 && --bound[1][entry.second.end.triangle] >= 0;
            }
            c.check
            (
                "faces " + correction + ": no more bonds than molecules on any",
                fits
            );
        }
        Info<< "    rates of all receptors over that of all pairs, "
            << correction.c_str() << ": " << totals << endl;
    }
}


void checkStatistics(checks& c)
{
    checkRupture(c);
    checkFaces(c);
    checkNumbers(c);
}

} // End namespace fsbi
} // End namespace Foam
