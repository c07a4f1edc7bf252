/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bondChecks.H"
#include "caps.H"
#include "freeMolecules.H"

namespace Foam
{
namespace fsbi
{

// On the wall 120 patches fit into it, as large as without a period
static const vector period(0, 12, 0);


struct eventDifference
{
    scalar place;
    scalar time;        // of the time itself
};


// The largest; of other events, GREAT
static eventDifference difference
(
    const DynamicList<bondEvent>& a, const DynamicList<bondEvent>& b
)
{
    eventDifference largest{a.size() == b.size() ? 0 : GREAT, 0};
    for (label i = 0; i < a.size() && largest.place < GREAT; ++i)
    {
        const bool same = a[i].pair == b[i].pair && a[i].set == b[i].set
         && a[i].site == b[i].site && a[i].formed == b[i].formed;
        largest.place = same
          ? max(largest.place, max(mag(a[i].a - b[i].a), mag(a[i].b - b[i].b)))
          : GREAT;
        largest.time = max(largest.time, mag(a[i].time - b[i].time)/b[i].time);
    }
    return largest;
}


static scalar difference(const loads& a, const loads& b)
{
    const loads::onBodies with(a.forces()), without(b.forces());
    scalar largest = 0;
    forAll(with.whole, body)
    {
        largest = max
        (
            largest,
            max
            (
                mag(linear(with.whole[body]) - linear(without.whole[body])),
                mag(angular(with.whole[body]) - angular(without.whole[body]))
            )
        );
    }
    return largest/mag(linear(without.whole[0]));
}


// The same run with the ball a period away, and with other images in the mesh later
static void checkRun
(
    checks& c, const std::string& name, const std::string& what, const bool wall
)
{
    testScene plain(0.1, 0.04), there(0.1, 0.04);
    for (testScene* scene : {&plain, &there})
    {
        if (wall)
        {
            scene->addWall(vector(1e-5, 2e-5, 0));
        }
        scene->addSphere(0.2, point(0.3, 0.1, -8));
    }
    there.ball->centre += period;
    there.addImages({period, -period});
    autoPtr<bonds> a(plain.make(what, 3)), b(there.make(what, 3));
    scalar places = 0, times = 0, forces = 0, longest = 0;
    labelList formed(a->molecules().pairs().size(), Zero);
    for (label step = 0; step < 24; ++step)
    {
        if (step == 8)
        {
            there.cap->setImage(period);
        }
        if (step == 16)
        {
            there.ball->centre += 4*period;
            there.ball->setImage(-4*period);
        }
        plain.begin(a(), 40);
        there.begin(b(), 40);
        const eventDifference d(difference(b->events(), a->events()));
        places = max(places, d.place);
        times = max(times, d.time);
        for (const bondEvent& e : a->events())
        {
            ++formed[e.pair];
        }
        for (testScene* scene : {&plain, &there})
        {
            scene->cap->centre += vector(2e-4, 3e-4, 1e-5);
            scene->cap->turn(vector(0, 1, 0), 3e-4);
            scene->cap->velocity = vector(0, 1e-5, -1e-5);
        }
        loads f(List<List<triFace>>(2)), g(List<List<triFace>>(2));
        a->apply(f);
        b->apply(g);
        forces = max(forces, difference(g, f));
        a->endStep();
        b->endStep();
        string why;
        const scalar t = a->longestStep(why);
        longest = max(longest, mag(b->longestStep(why) - t)/t);
    }
    c.check(name + ": bonds form and break", min(formed) > 20);
    // bound: a ligand's place is searched to 1e-9 of a bond's length of 0.05, twice;
    // rates and forces see it as a part of the thermal length, 1.5e-3, from which
    // bonds are some lengths away
    c.checkBelow(name + ": the same events with images", places, 1e-10);
    c.checkBelow(name + ": at the same times", times, 1e-6);
    c.checkBelow(name + ": the same forces", forces, 1e-6);
    c.checkBelow(name + ": the same longest step", longest, 1e-6);
}


// A place on the wall and its image have one molecule, whatever fits into a period
static void checkPatches(checks& c)
{
    testScene scene(0.2, 0.04);
    scene.addWall();
    const vector x(7.31, 0, 0), y(0, 11.17, 0);
    scene.addImages({x, -x, y, -y, x + y, x - y, y - x, -x - y});
    autoPtr<bonds> b
    (
        scene.make
        (
            "molecules { cap { A { density 30; } } floor { C { density 9.7; } } }"
            " pairs { wall" + pairText("(A C)", "") + "}",
            3
        )
    );
    const currentSurfaces now(scene.context());
    const List<vector> slid(now.size(), vector(0.1, 0.2, 0));
    freeMolecules molecules(b->molecules(), now, slid, 0);
    std::set<molecule> all;
    bool same = true;
    for (label i = 0; i < 100; ++i)
    {
        for (label j = 0; j < 100; ++j)
        {
            const point at(i*x/100 + j*y/100);
            const molecule m(molecules.at(1, at));
            const molecule image(molecules.at(1, at - x + y));
            same = same && !(m < image) && !(image < m);
            all.insert(m);
        }
    }
    c.check("a place of the wall and its image have one molecule", same);
    c.checkClose
    (
        "as many as the density says", scalar(all.size()),
        9.7*mag(x)*mag(y), 0.03    // bound: half a patch of 22 and of 35
    );
}


void checkImages(checks& c)
{
    checkRun
    (
        c, "molecules",
        "molecules { cap { A { density 300; } } ball { B { density 200; } }"
        " floor { C { density 100; } } }"
        " pairs { " + pairText("(A B)", "") + "wall" + pairText("(A C)", "") + "}",
        true
    );
    checkRun
    (
        c, "faces",
        "molecules { cap { A { density 300; } } ball { B { density 200; } } }"
        " pairs { "
      + pairText("(A B)", "sites faces; faceCorrection conserving;") + "}",
        false
    );
    checkPatches(c);
}

} // End namespace fsbi
} // End namespace Foam
