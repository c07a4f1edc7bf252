/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Application
    fsbiTestHealing

Description
    Bodies that move through a box, with a mesh that is healed where it degrades
    and, the same travel again, one that is made anew as a whole each time:
    processor seconds of both, and what the healed mesh is like beside a new one
    around the same bodies.

Usage
    fsbiTestHealing                             checks, of small meshes
    fsbiTestHealing SCENE EDGE FARSIZE WAY STEPS [-only]
                                                one scene, see travel.H; -only: no
                                                whole meshes, also in parallel

\*---------------------------------------------------------------------------*/

#include "travel.H"
#include "wholeMeshes.H"
#include "checks.H"
#include "argList.H"
#include "cpuTime.H"
#include "fluidMesh.H"

using namespace Foam;
using namespace Foam::fsbi;

namespace
{

struct way
{
    word scene;
    scalar edge;
    scalar farSize;
    scalar length;
    label steps;
};


struct record
{
    label cells = 0;
    label events = 0;

    //- Processor seconds of steps that changed the mesh, and of all others
    scalar seconds = 0;
    scalar moving = 0;

    //- Non-orthogonality, degrees: the largest, and the largest mean, after an event
    scalar largest = 0;
    scalar mean = 0;
};


// FNV-1a of all that a mesh is
uint64_t fingerprint(const meshLists& m)
{
    uint64_t h = 1469598103934665603ull;
    const auto add = [&h](const void* p, const std::size_t n)
    {
        const unsigned char* c = static_cast<const unsigned char*>(p);
        for (std::size_t i = 0; i < n; ++i)
        {
            h = (h^c[i])*1099511628211ull;
        }
    };
    add(m.points.cdata(), m.points.size()*sizeof(point));
    add(m.owner.cdata(), m.owner.size()*sizeof(label));
    add(m.neighbour.cdata(), m.neighbour.size()*sizeof(label));
    return h;
}


// Step: does the mesh change?
record travelled
(
    const way& w, travel& s, const fvMesh& mesh,
    const std::function<bool()>& follow
)
{
    record r;
    cpuTime clock;
    for (label i = 1; i <= w.steps; ++i)
    {
        s.go(w.length*i/w.steps);
        clock.cpuTimeIncrement();
        const bool changed = follow();
        const scalar seconds = clock.cpuTimeIncrement();
        (changed ? r.seconds : r.moving) += seconds;
        if (changed)
        {
            ++r.events;
            const meshQuality q(mesh);
            r.largest = max(r.largest, q.maxNonOrthogonality);
            r.mean = max(r.mean, q.meanNonOrthogonality);
            Info<< "    at " << w.length*i/w.steps << ": " << seconds << " s, "
                << q.nCells << " cells, non-orthogonality "
                << q.maxNonOrthogonality << " mean " << q.meanNonOrthogonality
                << endl;
        }
    }
    r.cells = returnReduce(mesh.nCells(), sumOp<label>());
    return r;
}


void print(const char* how, const record& r)
{
    Info<< how << ": events " << r.events << " seconds " << r.seconds
        << " moving " << r.moving << " cells " << r.cells << " largest "
        << r.largest << " mean " << r.mean << endl;
}


// Healed, and in serial the mean non-orthogonality of a new mesh around the same
// bodies
record healed(const way& w, Time& time, travel& s, scalar& newMean)
{
    timings t;
    fluidMesh mesh(time, "fluid", s.bodies, t, dictionary());
    const record r
    (
        travelled
        (
            w, s, mesh.mesh(),
            [&]()
            {
                const label before = mesh.generation();
                const outcome followed(mesh.follow([]{}));
                if (!followed)
                {
                    FatalErrorInFunction << followed.reason << exit(FatalError);
                }
                return mesh.generation() > before;
            }
        )
    );
    const meshLists whole(wholeLists(mesh.mesh()));
    Info<< "fingerprint " << label(fingerprint(whole) >> 34) << endl;
    newMean =
        Pstream::parRun()
      ? 0
      : meshQuality(wholeMeshes(time, s.bodies).mesh()).meanNonOrthogonality;
    return r;
}


record anew(const way& w, Time& time, travel& s)
{
    s.go(0);
    wholeMeshes mesh(time, s.bodies);
    return travelled
    (
        w, s, mesh.mesh(), [&]() { return mesh.follow(time); }
    );
}


autoPtr<Time> clockOf(const way& w)
{
    const fileName folder
    (
        travel::writeCase(cwd()/("case." + w.scene), w.farSize)
    );
    return autoPtr<Time>::New
    (
        Time::controlDictName, folder.path(), folder.name(), "system",
        "constant", false, false
    );
}


void checkWay(checks& c, const way& w)
{
    autoPtr<Time> time(clockOf(w));
    travel s(w.scene, w.edge);
    scalar newMean;
    const record r(healed(w, time(), s, newMean));
    print("healed", r);
    const std::string name(w.scene + ": ");
    c.check(name + "the mesh degrades", r.events > 0);
    // bound: what meshHealing promises
    c.checkBelow(name + "largest non-orthogonality", r.largest, 70);
    c.checkBelow(name + "mean over a new mesh's", r.mean - newMean, 0.7);
}

} // End anonymous namespace


int main(int argc, char* argv[])
{
    argList::noCheckProcessorDirectories();
    argList::noBanner();
    argList::noMandatoryArgs();
    argList::addBoolOption("only", "no whole meshes");
    const argList args(argc, argv, false, true);
    if (args.size() < 6)
    {
        checks c;
        checkWay(c, {"turning", 0.25, 2, 1.2, 24});
        checkWay(c, {"wall", 0.25, 2, 0.8, 16});
        checkWay(c, {"passing", 0.3, 2, 1, 20});
        return c.finish();
    }
    const way w
    {
        args[1], args.read<scalar>(2), args.read<scalar>(3),
        args.read<scalar>(4), args.read<label>(5)
    };
    autoPtr<Time> time(clockOf(w));
    travel s(w.scene, w.edge);
    scalar newMean;
    print("healed", healed(w, time(), s, newMean));
    Info<< "new mean " << newMean << endl;
    if (!args.found("only"))
    {
        print("whole", anew(w, time(), s));
    }
    return 0;
}
