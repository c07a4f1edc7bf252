/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bondChecks.H"
#include "bonds.H"
#include "caps.H"
#include "mathematicalConstants.H"

namespace Foam
{
namespace fsbi
{

//- Entries of the two kinds: of the receptors, of the ligands
struct amounts
{
    std::string receptors;
    std::string ligands;
};


static std::string scene
(
    const amounts& a, const std::string& below, const std::string& pair
)
{
    return "molecules { cap { A { " + a.receptors + "} } " + below + " { B { "
      + a.ligands + "} } } pairs { pair { kinds (A B); law Dembo; lambda 0.05; "
      + pair + "} }";
}


// Initial rate and rate of the first bond, over seeds
struct firstBonds
{
    scalar formed = 0;
    scalar first = 0;
    scalar waited = 0;

    firstBonds
    (
        testScene& s, const std::string& what, const label seeds,
        const scalar duration
    )
    {
        for (label seed = 0; seed < seeds; ++seed)
        {
            s.restartClock();
            autoPtr<bonds> b(s.make(what, seed));
            s.begin(b(), duration);
            const auto& events = b->events();
            formed += events.size();
            first += events.size() > 0;
            waited += events.size() ? events[0].time : duration;
        }
    }
};


//- Half of the molecules, half of the rate?
static void checkHalf
(
    checks& c, const std::string& name,
    const firstBonds& all, const firstBonds& half
)
{
    const scalar initial = half.formed/all.formed;
    checkSigma
    (
        c, name + ": initial rate", initial, 0.5,
        0.5*sqrt(1/all.formed + 2/all.formed)
    );
    const scalar first = half.first/half.waited*all.waited/all.first;
    checkSigma
    (
        c, name + ": rate of the first bond", first, 0.5,
        0.5*sqrt(1/all.first + 1/all.first)
    );
}


// Bonds so soft that faces of 0.1 resolve them, and so slow that few form
static void checkHalves(checks& c)
{
    testScene s(0.1, 0.045, 0.3);
    s.addSphere(0.1, point::max, 0.3);
    const std::string full("density 2000; ");
    const amounts less[] =
    {
        {full + "blocked 0.5; ", full}, {full, full + "blocked 0.5; "},
        {"density 1000; ", full}, {full, "density 1000; "}
    };
    const std::string names[] =
        {"receptors blocked", "ligands blocked", "receptors", "ligands"};
    for (const std::string sites : {"molecules", "faces"})
    for (const std::string correction : {"none", "global", "conserving"})
    {
        const std::string pair
        (
            "k0on 1e-9; k0off 1e-12; s 0.02; sts 0.02; sites " + sites
          + "; faceCorrection " + correction + "; "
        );
        const std::string what(scene({full, full}, "ball", pair));
        autoPtr<bonds> b(s.make(what, 1));
        const currentSurfaces now(s.context());
        bondState none;
        DynamicList<bondEvent> events;
        const bondStep step(b->molecules(), now, none, events, 0);
        scalar sum = 0;
        for (label i = 0; i < step.size(); ++i)
        {
            sum += step.rate(i);
        }
        const label seeds = 150;
        const firstBonds all(s, what, seeds, 8/sum);
        for (label i = 0; i < 4; ++i)
        {
            const firstBonds half
            (
                s, scene(less[i], "ball", pair), seeds, 8/sum
            );
            checkHalf
            (
                c, sites + " " + correction + ", half of the " + names[i], all,
                half
            );
        }
    }
}


//- Does every molecule have one bond at most?
static bool conserved(const bonds& b)
{
    std::set<molecule> bound;
    for (const auto& entry : b.all())
    {
        const auto& set = b.molecules().sets()[entry.first.first];
        bound.insert({set.receptors, entry.first.second, 0});
        bound.insert(entry.second.ligand);
    }
    return bound.size() == 2*b.all().size();
}


// A strong association: all molecules of the scarcer kind are bound
static void checkSaturation(checks& c)
{
    const std::string many("density 20000; "), few("density 500; ");
    for (const std::string sites : {"molecules", "faces"})
    for (const bool scarceLigands : {true, false})
    for (const scalar size : {0.2, 0.05, 0.01})
    {
        testScene s(size, 0.045, 0.1);
        s.addSphere(size, point::max, 0.1);
        autoPtr<bonds> b
        (
            s.make
            (
                scene
                (
                    scarceLigands ? amounts{many, few} : amounts{few, many},
                    "ball",
                    "k0on 0.02; k0off 1e-12; s 2; sts 2; sites " + sites + "; "
                ), 3
            )
        );
        // a half of the time also leaves some free
        bool always = true;
        for (const scalar dt : {1.0, 4.0, 400.0})
        {
            s.step(b(), dt);
            always = always && conserved(b());
        }
        const auto& populations = b->molecules().populations();
        const label scarce = populations[scarceLigands].molecules.size();
        c.check
        (
            sites + ", triangles of " + std::to_string(size)
          + ": as many bonds as " + (scarceLigands ? "ligands" : "receptors"),
            always && scarce > 15 && label(b->all().size()) == scarce,
            std::to_string(b->all().size()) + " bonds of "
          + std::to_string(scarce)
        );
    }
}


// Mean number of bonds of R and L molecules, x being the ratio of rates of one
// pair: the stationary state of the one-step process is
// R!/(R - b)! L!/(L - b)! x^b/b!
static scalar wellMixed(const label R, const label L, const scalar x)
{
    scalar weight = 1, sum = 1, mean = 0;
    for (label b = 1; b <= min(R, L); ++b)
    {
        weight *= x*(R - b + 1)*(L - b + 1)/b;
        sum += weight;
        mean += b*weight;
    }
    return mean/sum;
}


// Two triangles over two others, molecules lumped at their centroids
static void checkWellMixed(checks& c)
{
    for (const std::string part : {"", "blocked 0.5; "})
    {
        testScene s(1, 0.0175, 0.3);
        s.addSphere(1, point::max, 0.3);
        autoPtr<bonds> b
        (
            s.make
            (
                scene
                (
                    {"density 170; " + part, "density 110; " + part}, "ball",
                    "k0on 0.02; k0off 0.4; s 2; sts 2; sites faces; "
                ), 7
            )
        );
        const currentSurfaces now(s.context());
        scalar exact = 0;
        for (label t = 0; t < 2; ++t)
        {
            label n[2] = {0, 0};
            for (label p = 0; p < 2; ++p)
            {
                const auto& kind = b->molecules().populations()[p];
                forAll(kind.molecules, i)
                {
                    n[p] += kind.molecules[i].triangle == t
                     && kind.unblocked(i, 0, part.empty() ? 0 : 0.5);
                }
            }
            const scalar x =
                mag(now.centroid(0, t) - now.centroid(1, t)) - 0.05;
            exact += wellMixed(n[0], n[1], 0.05*exp(-x*x/kT(310)));
            Info<< "    receptors, ligands on a triangle: " << n[0] << ", "
                << n[1] << endl;
        }
        const label samples = 4000;
        scalar sum = 0, squares = 0;
        for (label i = 0; i <= samples; ++i)
        {
            s.step(b(), 12);
            sum += i ? b->all().size() : 0;
            squares += i ? sqr(scalar(b->all().size())) : 0;
        }
        const scalar mean = sum/samples;
        checkSigma
        (
            c, "bonds of two scarce kinds " + part, mean, exact,
            sqrt((squares/samples - sqr(mean))/samples)
        );
    }
}


// Mean number of bonds when receptor i and ligand j bind with the ratio of
// rates a[i][j] and each has one bond at most: the sum over all matchings, over
// sets of bound ligands
static scalar matchings(const std::vector<std::map<label, scalar>>& a, label n)
{
    std::vector<scalar> weights(1 << n, 0.0);
    weights[0] = 1;
    for (const auto& ways : a)
    {
        std::vector<scalar> more(weights);
        for (label set = 0; set < (1 << n); ++set)
        {
            for (const auto& way : ways)
            {
                if (!(set & (1 << way.first)))
                {
                    more[set | (1 << way.first)] += weights[set]*way.second;
                }
            }
        }
        weights = more;
    }
    scalar sum = 0, mean = 0;
    for (label set = 0; set < (1 << n); ++set)
    {
        sum += weights[set];
        mean += weights[set]*__builtin_popcount(set);
    }
    return mean/sum;
}


// The same of receptors where they are, over ligands whose parts of the surface
// are far larger than a bond's reach; rate: of one receptor, over k_off
static scalar exactNumber(const bonds& b, const currentSurfaces& now)
{
    const adhesion& a = b.molecules();
    const auto& set = a.sets()[0];
    const label ligands = set.targets[0].ligands;
    const label below = a.populations()[ligands].surface;
    const contactRate& rate = a.pairs()[0].rate();
    const List<vector> slid(now.size(), Zero);
    freeMolecules parts(a, now, slid, 0);

    std::map<molecule, label> number;
    std::vector<std::map<label, scalar>> ratios;
    currentSurfaces::nearestPoint at;
    for (const materialPoint& site : set.sites)
    {
        const point x(now.position(set.body, site));
        if (!now.find(below, x, rate.reach(), at))
        {
            continue;
        }
        ratios.push_back({});
        const label rings = 12, rays = 48;
        const vector e1(currentSurfaces::along(at.normal)), e2(at.normal ^ e1);
        const scalar part =
            parts.density(ligands)*rate(at.gap)/a.pairs()[0].law->kOff(0)
           /(rings*rays);
        for (label ring = 0; ring < rings; ++ring)
        {
            const scalar r = rate.distance(at.gap, (ring + 0.5)/rings);
            const scalar aside = sqrt(max(r*r - sqr(at.gap), scalar(0)));
            for (label ray = 0; ray < rays; ++ray)
            {
                const scalar angle =
                    constant::mathematical::twoPi*(ray + 0.5)/rays;
                const molecule ligand = parts.at
                (
                    ligands,
                    at.nearest
                  + aside*(Foam::cos(angle)*e1 + Foam::sin(angle)*e2)
                );
                const label j =
                    number.insert({ligand, number.size()}).first->second;
                ratios.back()[j] += part;
            }
        }
    }
    return number.size() > 16 ? -1 : matchings(ratios, number.size());
}


// Many receptors over a few ligands
static void checkParts(checks& c)
{
    const label seeds = 40, samples = 30;
    scalarList means, deviations;
    for (const std::string below : {"floor", "ball"})
    for (const scalar size : {0.8, 0.2, 0.05})
    {
        if (below == "floor" && size < 0.8)
        {
            continue;
        }
        testScene s(0.1, 0.0495, 0.8);
        s.addWall();
        s.addPlate(size, 0.8);
        scalar sum = 0, squares = 0, exact = 0, exacts = 0;
        for (label seed = 0; seed < seeds; ++seed)
        {
            s.restartClock();
            autoPtr<bonds> b
            (
                s.make
                (
                    scene
                    (
                        {"density 200; ", "density 4; "}, below,
                        "k0on 0.2; k0off 1e-3; s 2; sts 2; "
                    ), seed
                )
            );
            const scalar expected =
                exactNumber(b(), currentSurfaces(s.context()));
            scalar off = 0;
            for (label i = 0; i <= samples; ++i)
            {
                s.step(b(), 4000);
                off += i ? (b->all().size() - expected)/samples : 0;
            }
            sum += off/seeds;
            squares += off*off/seeds;
            exact += expected/seeds;
            exacts += sqr(expected + off)/seeds;
        }
        means.append(exact + sum);
        deviations.append(sqrt((exacts - sqr(exact + sum))/(seeds - 1)));
        checkSigma
        (
            c, "bonds that share few ligands, " + below + ", triangles of "
          + std::to_string(size), exact + sum, exact,
            sqrt((squares - sum*sum)/(seeds - 1))
        );
    }
    checkSigma
    (
        c, "bonds that share few ligands: do not depend on the triangles",
        means[3], means[1], sqrt(sqr(deviations[1]) + sqr(deviations[3]))
    );
}


static void checkBlocked(checks& c)
{
    testScene s(0.4, 0.04);
    s.addWall();
    const auto make = [&](const std::string& blocked)
    {
        return s.make
        (
            scene
            (
                {"density 10; ", "density 10; blocked " + blocked + "; "},
                "floor", "k0on 1; k0off 1; s 2; sts 2; "
            ), 1
        );
    };
    for (const std::string wrong : {"1.01", "-0.1", "table ((0 2) (1 0))"})
    {
        c.checkFatal
        (
            "blocked " + wrong + " is refused", [&]{ make(wrong); },
            "Entry 'blocked' is the part"
        );
    }
    autoPtr<bonds> b(make("table ((0 1) (10 1) (20 2))"));
    s.step(b(), 10);
    s.step(b(), 5);
    c.checkFatal
    (
        "blocked is refused when it leaves 0 to 1", [&]{ s.step(b(), 5); },
        "but is 1.5 at the time 15"
    );
    s.restartClock();
}


void checkDepletion(checks& c)
{
    checkBlocked(c);
    checkSaturation(c);
    checkWellMixed(c);
    checkParts(c);
    checkHalves(c);
}

} // End namespace fsbi
} // End namespace Foam
