/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "deforming.H"
#include "fluidMesh.H"
#include "OSspecific.H"
#include "OFstream.H"

namespace Foam
{
namespace fsbi
{

// A case folder with the box as its domain
static fileName boxCase()
{
    const fileName folder(cwd()/"boxCase");
    rmDir(folder, true);
    const autoPtr<Time> clock(testClock(folder));
    const autoPtr<polyMesh> box
    (
        boxMesh
        (
            clock(), boundBox(point(-4, -4, 0), point(4, 4, 6)),
            Vector<label>(10, 10, 8)
        )
    );
    box->polyMesh::write();
    mv
    (
        folder/"constant"/box->name()/polyMesh::meshSubDir,
        folder/"constant"/polyMesh::meshSubDir
    );
    mkDir(folder/"system"/"fluid");
    for
    (
        const fileName file :
        {"controlDict", "fluid/fvSchemes", "fluid/fvSolution"}
    )
    {
        OFstream(folder/"system"/file)()
            << "FoamFile { version 2.0; format ascii; class dictionary;"
            << " object " << file.name() << "; }\n"
            << "deltaT 1; writeInterval 1; startTime 0; endTime 1;\n"
            << "gradSchemes {} divSchemes {} laplacianSchemes {}\n";
    }
    return folder;
}


// What a saved state has of the mesh, as text
static dictionary saved(const fluidMesh& mesh)
{
    mesh.write
    (
        [](const regIOobject& part)
        {
            part.writeObject
            (
                IOstream::BINARY, IOstream::currentVersion,
                IOstream::UNCOMPRESSED, true
            );
        }
    );
    const unsigned precision = IOstream::defaultPrecision(17);
    dictionary state;
    mesh.save(state);
    OStringStream text;
    state.write(text, false);
    IOstream::defaultPrecision(precision);
    return dictionary(IStringStream(text.str())());
}


static pointField moved(fluidMesh& mesh, rubberScene& s, const scalar by)
{
    s.pull(by);
    mesh.move();
    return mesh.mesh().points();
}


// The mesh again from what is saved of it
static void checkRestart
(
    checks& c, const word& name, const Time& time, timings& t, rubberScene& s,
    autoPtr<fluidMesh>& mesh, const scalar at, const scalar further
)
{
    const pointField there(moved(mesh(), s, further));
    const pointField here(moved(mesh(), s, at));
    const dictionary state(saved(mesh()));
    mesh.clear();
    mesh.reset(new fluidMesh(time, "fluid", s.bodies, t, state));
    c.checkBelow
    (
        name + ": restarted where it was",
        max(mag(mesh->mesh().points() - here)), 0
    );
    c.checkBelow
    (
        name + ": moves on as without a restart",
        max(mag(moved(mesh(), s, further) - there)), 1e-10
    );
}


static void checkWithinStep(checks& c, rubberScene& s, fluidMesh& mesh)
{
    const pointField points(moved(mesh, s, 0.3));
    const label n = 10;
    const clockTime time;
    for (label i = 0; i < n; ++i)
    {
        mesh.move();
    }
    Info<< "    " << mesh.mesh().nCells() << " cells: moved in "
        << 1000*time.elapsedTime()/n << " ms" << endl;
    c.check("a moved mesh is usable", mesh.usable().ok, mesh.usable().reason);
    s.soft.centre += vector(2, 0, 0);
    mesh.move();
    c.check
    (
        "a mesh with inverted cells is not, and says so",
        !mesh.usable() && mesh.usable().reason.find("volume") != string::npos
    );
    s.soft.centre = s.stiff.centre;
    const outcome followed(mesh.follow([]{}));
    c.check
    (
        "a step of bodies into each other fails",
        !followed && followed.reason.find("'body0'") != string::npos,
        followed.reason
    );
    c.checkBelow
    (
        "it comes back to where it was",
        max(mag(moved(mesh, s, 0.3) - points)), 0
    );
}


void checkFluidMesh(checks& c)
{
    const fileName folder(boxCase());
    const autoPtr<Time> time(testClock(folder));
    timings t;
    rubberScene s;
    s.pull(0);
    autoPtr<fluidMesh> mesh
    (
        new fluidMesh(time(), "fluid", s.bodies, t, dictionary())
    );
    checkWithinStep(c, s, mesh());
    checkRestart(c, "following", time(), t, s, mesh, 0.3, 0.6);

    const auto follow = [&](const scalar by)
    {
        const label before = mesh->generation();
        bool released = false;
        s.pull(by);
        const outcome followed =
            mesh->follow([&released]() { released = true; });
        c.check
        (
            "what stands on a mesh is released with it",
            released == (mesh->generation() > before)
        );
        return followed.ok;
    };
    c.check("a mesh follows", follow(0.7) && mesh->generation() == 1);
    const label nPoints = mesh->mesh().nPoints();
    for (scalar by = 0.75; mesh->generation() == 1; by += 0.05)
    {
        follow(by);
    }
    // only a whole new mesh would have other points
    c.check("degraded it is healed", mesh->mesh().nPoints() == nPoints);
    checkRestart(c, "healed", time(), t, s, mesh, 1.1, 1.2);
    c.check
    (
        "degraded much it is made anew",
        follow(1.8) && mesh->mesh().nPoints() != nPoints
    );
    for (const immersedBody& body : s.bodies)
    {
        checkMap
        (
            c, "remeshed " + body.name(),
            mesh->mesh().boundaryMesh()[body.name()], body.placedSurface()
        );
    }
    checkRestart(c, "remeshed", time(), t, s, mesh, 1.8, 1.9);
}

} // End namespace fsbi
} // End namespace Foam
