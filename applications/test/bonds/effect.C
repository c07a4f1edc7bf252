/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bondChecks.H"
#include "bonds.H"
#include "caps.H"
#include "OStringStream.H"

namespace Foam
{
namespace fsbi
{

static const scalar rest = 0.05;

static const std::string twoKinds
(
    "molecules { cap { A { density 300; } } ball { B { density 200; } }"
    " floor { C { density 100; } } }"
    " pairs { " + pairText("(A B)", "") + "wall" + pairText("(A C)", "") + "}"
);


static bool same(const DynamicList<bondEvent>& a, const DynamicList<bondEvent>& b)
{
    bool equal = a.size() == b.size();
    for (label i = 0; equal && i < a.size(); ++i)
    {
        equal = a[i].time == b[i].time && a[i].site == b[i].site
         && a[i].formed == b[i].formed && a[i].length == b[i].length
         && a[i].a == b[i].a && a[i].b == b[i].b;
    }
    return equal;
}


static bool same(const bondMap& a, const bondMap& b)
{
    bool equal = a.size() == b.size();
    for (auto i = a.begin(), j = b.begin(); equal && i != a.end(); ++i, ++j)
    {
        equal = i->first == j->first && i->second.pair == j->second.pair
         && i->second.end.triangle == j->second.end.triangle
         && i->second.end.b == j->second.end.b
         && i->second.end.c == j->second.end.c
         && i->second.anchor == j->second.anchor;
    }
    return equal;
}


// Save to text, restore into new bonds that see turned bodies from the start
static autoPtr<bonds> restarted
(
    testScene& scene, const bonds& old, const std::string& what
)
{
    const unsigned precision = IOstream::defaultPrecision(17);
    dictionary state;
    old.save(state);
    OStringStream text;
    text<< state;
    IOstream::defaultPrecision(precision);
    autoPtr<bonds> b(scene.make(what, 3));
    const dictionary copy{IStringStream(text.str())()};
    b->restore(copy);
    return b;
}


static void checkMemory(checks& c)
{
    testScene scene(0.1, 0.04);
    scene.addWall(vector(1e-5, 0, 0));
    scene.addSphere(0.2, point(0.3, 0.1, -8.02));
    autoPtr<bonds> a(scene.make(twoKinds, 3));
    autoPtr<bonds> again(scene.make(twoKinds, 3));
    autoPtr<bonds> other(scene.make(twoKinds, 4));
    autoPtr<bonds> saved;
    bool repeated = true, differs = false, restart = true, some = false;
    for (label i = 0; i < 12; ++i)
    {
        // rejected once
        scene.begin(again(), 80);
        scene.cap->centre.z() += 0.01;
        again->rewind();
        scene.cap->centre.z() -= 0.01;
        scene.back();

        scene.begin(a(), 40);
        again->beginStep();
        other->beginStep();
        if (i >= 5)
        {
            saved->beginStep();
            restart = restart && same(a->events(), saved->events())
             && same(a->all(), saved->all());
            some = some || a->events().size();
        }
        repeated = repeated && same(a->events(), again->events())
         && same(a->all(), again->all());
        differs = differs || !same(a->events(), other->events());
        scene.cap->centre += vector(2e-4, 0, 1e-5);
        scene.cap->turn(vector(0, 1, 0), 3e-4);
        a->endStep();
        again->endStep();
        other->endStep();
        if (i == 4)
        {
            saved = restarted(scene, a(), twoKinds);
        }
        else if (i > 4)
        {
            saved->endStep();
        }
    }
    c.check("something happens", a->all().size() > 10 && some);
    c.check("the same seed has the same events, also after a rejected step",
        repeated);
    c.check("another seed has others", differs);
    c.check("restarted is as never stopped", restart);
    string why, whyAgain;
    c.check
    (
        "also the longest step",
        a->longestStep(why) == saved->longestStep(whyAgain) && why == whyAgain
    );
}


static void checkForces(checks& c)
{
    testScene scene(0.1, 0.04);
    scene.addSphere(0.1);
    const std::string what
    (
        "molecules { cap { A { density 300; } } ball { B { density 200; } } }"
        " pairs { " + pairText("(A B)", "") + "}"
    );
    autoPtr<bonds> b(scene.make(what, 5));
    scene.begin(b(), 3000);
    scene.cap->centre += vector(0.003, 0.001, 0.004);
    loads l(List<List<triFace>>(2));
    b->apply(l);
    const loads::onBodies f(l.forces());
    const vector sum(linear(f.whole[0]) + linear(f.whole[1]));
    const vector moment
    (
        angular(f.whole[0]) + angular(f.whole[1])
      + (scene.cap->centre ^ linear(f.whole[0]))
      + (scene.ball->centre ^ linear(f.whole[1]))
    );
    const scalar size = mag(linear(f.whole[0]));
    c.check("bonds pull", b->all().size() > 20 && size > 1e-3);
    c.checkBelow("force is minus that on the partner", mag(sum)/size, 1e-13);
    c.checkBelow("no moment in all", mag(moment)/size, 1e-12);

    loads twice(List<List<triFace>>(2));
    b->apply(twice);
    c.check
    (
        "applied again is the same", twice.forces().whole[0] == f.whole[0]
     && twice.springs().size() == label(b->all().size())
    );

    // force after a small displacement against the springs' stiffness; the
    // part that compression would soften is left out on purpose
    loads::ofBodies u(l.atRest());
    const vector shift(0, 0, 1e-7);
    u.whole[0] = join(shift, vector::zero);
    const vector predicted(linear(l.changes(u).whole[0]));
    scene.cap->centre += shift;
    loads moved(List<List<triFace>>(2));
    b->apply(moved);
    const vector change(linear(moved.forces().whole[0]) - linear(f.whole[0]));
    c.checkBelow
    (
        "stiffness is the force's slope",
        mag(change.z() - predicted.z())/mag(change.z()), 0.02
    );

    // the longest step: no bond may stretch by more than a thermal length
    scene.cap->velocity = vector(1e-4, 0, 3e-4);
    scalar fastest = 0;
    for (const loads::spring& s : l.springs())
    {
        const vector d
        (
            scene.ball->centre + s.b.arm - scene.cap->centre - s.a.arm
        );
        fastest = max(fastest, mag(scene.cap->velocity & d)/mag(d));
    }
    string why;
    c.checkClose
    (
        "bonds limit the step", b->longestStep(why),
        sqrt(kT(310)/2)/fastest, 1e-4
    );

    // every bond by itself
    scalar worst = 0;
    for (const loads::spring& s : l.springs())
    {
        const point x(scene.cap->centre - shift + s.a.arm);
        const point y(scene.ball->centre + s.b.arm);
        const scalar d = mag(y - x);
        worst = max(worst, mag(s.force - 2*(d - rest)*(y - x)/d));
    }
    c.checkBelow("force of each bond", worst, 1e-12);
}


static void checkSearch(checks& c)
{
    testScene scene(0.15, 0.02);
    scene.addSphere(0.13);
    const std::string what
    (
        "molecules { cap { A { density 200; } } ball { B { density 200; } } }"
        " pairs { " + pairText("(A B)", "") + "}"
    );
    autoPtr<bonds> b(scene.make(what, 5));
    const adhesion& a = b->molecules();
    const currentSurfaces now(scene.context());
    bondState none;
    DynamicList<bondEvent> events;
    const bondStep step(a, now, none, events, 0);

    label found = 0, wrong = 0;
    const adhesion::siteSet& set = a.sets()[0];
    const bodySurface& other = now.surface(1);
    const scalar density =
        a.populations()[1].molecules.size()/other.area();
    forAll(set.sites, site)
    {
        const point x(now.position(0, set.sites[site]));
        scalar gap = GREAT;
        for (const triFace& t : other.triangles())
        {
            gap = min(gap, t.nearestPoint(x, other.points()).distance());
        }
        const scalar k = density*a.pairs()[0].rate()(gap);
        const auto channels = step.candidates(0, site);
        found += channels != nullptr;
        wrong += (k > 0) != (channels != nullptr)
         || (channels && mag((*channels)[0].rate - k) > 1e-9*k);
    }
    c.check
    (
        "search finds what all triangles have",
        wrong == 0 && found > 10 && found < set.sites.size()/2,
        std::to_string(wrong) + " wrong of " + std::to_string(found)
    );

    // new bonds have the length that was drawn, or else their force would be
    // off by many thermal lengths
    scene.begin(b(), 20);
    scalar shortest = GREAT, longest = 0;
    for (const bondEvent& e : b->events())
    {
        if (e.formed)
        {
            shortest = min(shortest, e.length);
            longest = max(longest, e.length);
        }
    }
    const scalar sigma = sqrt(kT(310));     // of sts
    c.check
    (
        "new bonds are within five thermal lengths of rest",
        b->events().size() > 5
     && shortest > rest - 5*sigma && longest < rest + 5*sigma
    );
}


//- Keeps what is recorded
class notebook
:
    public recording
{
public:

    std::map<std::string, label> columns;
    std::map<std::string, DynamicList<scalarList>> rows;

    void declare
    (
        const fileName& path, const wordList& names, const string&
    ) override
    {
        columns[path] = names.size();
    }

    void append(const fileName& path, const UList<scalar>& row) override
    {
        rows[path].append(scalarList(row));
    }
};


static void checkRecords(checks& c)
{
    testScene scene(0.1, 0.04);
    scene.addWall();
    IStringStream text
    (
        "bonds { temperature 310; seed 2; molecules { cap { A { density 300; }"
        " } floor { B { density 200; } } } pairs { " + pairText("(A B)", "")
      + "} }"
    );
    const dictionary dict(text);
    autoPtr<effect> e(effect::New(*dict.findEntry("bonds"), scene.context()));
    bonds& b = refCast<bonds>(e());
    notebook book;
    b.declare(book);
    scene.begin(b, 500);
    loads l(List<List<triFace>>(1));
    b.apply(l);
    b.endStep();
    b.record(book);

    bool fits = book.columns.size() == 2;
    for (const auto& table : book.rows)
    {
        for (const scalarList& row : table.second)
        {
            fits = fits && row.size() == book.columns[table.first];
        }
    }
    const scalarList& sums = book.rows["bonds/pair"][0];
    c.check
    (
        "records: all that was declared, a row for each event",
        fits && book.rows["bonds/events"].size() == b.events().size()
    );
    c.check
    (
        "records: formed less broken is the number of bonds",
        sums[0] == scalar(b.all().size()) && sums[0] > 5
     && sums[1] - sums[2] == sums[0]
    );
    const vector force(linear(l.forces().whole[0]));
    c.checkBelow
    (
        "records: force is that on the body",
        mag(vector(sums[4], sums[5], sums[6]) - force)/mag(force), 1e-13
    );

    dictionary state;
    b.save(state);
    autoPtr<bonds> sparse
    (
        scene.make
        (
            "molecules { cap { A { density 300; } } floor { C { density 1; }"
            " B { density 200; } } } pairs { " + pairText("(A B)", "") + "}", 1
        )
    );
    c.checkFatal
    (
        "saved bonds of other molecules are refused",
        [&]{ sparse->restore(state); }, "must not change at a restart"
    );
}


static void checkRest(checks& c)
{
    const auto what = [](const std::string& more)
    {
        return "molecules { cap { A { density 300; } } floor { B { density"
            " 200; " + more + "} } } pairs { " + pairText("(A B)", "") + "}";
    };
    {
        testScene scene(0.1, 0.04);
        scene.addWall(vector(1e-4, 0, 0));
        autoPtr<bonds> all(scene.make(what(""), 1));
        autoPtr<bonds> none(scene.make(what("blocked 1; "), 1));
        scene.begin(all(), 100);
        none->beginStep();
        c.check
        (
            "blocked ligands bind nothing",
            all->events().size() > 10 && none->events().empty()
        );
        const bondMap before(all->all());
        all->endStep();
        scalar worst = 0;
        for (const auto& entry : before)
        {
            worst = max
            (
                worst,
                mag
                (
                    all->all().at(entry.first).anchor - entry.second.anchor
                  - vector(0.01, 0, 0)
                )
            );
        }
        c.checkBelow("bonds move with the wall", worst, 1e-14);

        // a micrometre on, the bonds are still on the patches they took
        const label steps = 100;
        label elsewhere = 0;
        const currentSurfaces now(scene.context());
        List<vector> slid(now.size(), Zero);
        slid[1] = vector(0.01 + steps*0.01, 0, 0);
        for (label i = 0; i < steps; ++i)
        {
            scene.step(all(), 100);
        }
        freeMolecules parts(all->molecules(), now, slid, 0);
        for (const auto& entry : all->all())
        {
            const molecule& m = entry.second.ligand;
            const molecule n(parts.at(m.population, entry.second.anchor));
            elsewhere += m < n || n < m;
        }
        c.check
        (
            "ligands move with the wall",
            elsewhere == 0 && all->all().size() > 5,
            std::to_string(elsewhere) + " elsewhere"
        );
    }
    {
        // still far away: until the reach, then a thermal length
        testScene scene(0.1, 0.1);
        scene.addWall();
        autoPtr<bonds> b(scene.make(what(""), 1));
        scene.step(b(), 10);
        scene.cap->velocity = vector(0.1, 0, -1e-3);
        string why;
        const scalar dt = b->longestStep(why);
        const scalar sigma = sqrt(kT(310)/2);
        const scalar reach = b->molecules().pairs()[0].rate->reach();
        const scalar lowest = 0.1 - reach;     // lowest receptor: above that
        c.check
        (
            "an approach is foreseen",
            dt >= (lowest + sigma)/1e-3 && dt < (lowest + 0.003 + sigma)/1e-3
         && why.find("approach") != std::string::npos,
            "longest step " + std::to_string(dt)
        );
    }
    testScene scene(0.4, 0.04);
    scene.addWall();
    const auto refused = [&](const std::string& text, const std::string& part)
    {
        c.checkFatal
        (
            "refused: " + part, [&]{ scene.make(text, 1); }, part
        );
    };
    refused("molecules { cop { A { density 1; } } } pairs {}", "cop");
    refused
    (
        "molecules { cap { A { density 1; } } } pairs { "
      + pairText("(A D)", "") + "}", "known kinds are"
    );
    refused
    (
        "molecules { cap { A { density 1; } B { density 1; } } } pairs { "
      + pairText("(A B)", "") + "}", "No two surfaces"
    );
    refused
    (
        "molecules { cap { A { density 1; } } floor { B { density 1; } } }"
        " pairs { " + pairText("(A B)", "sites faces; ") + "}", "has no faces"
    );
}


void checkEffect(checks& c)
{
    checkSearch(c);
    checkForces(c);
    checkMemory(c);
    checkRecords(c);
    checkRest(c);
}

} // End namespace fsbi
} // End namespace Foam
