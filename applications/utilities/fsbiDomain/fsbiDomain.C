/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Application
    fsbiDomain

Description
    The domain of a scene from surfaces of any shape, a vessel, a bifurcation, a
    device: what blockMesh does from blocks. The surface is given triangles of one size,
    or less in boxes, whose facets lie on it on average, and filled with
    tetrahedra; fsbiFoam puts the bodies in it.

Usage
    system/domainDict
    \table
        keyword      | meaning                                       | default
        files        | surface files; solids or zones are patches    |
        scale        | factor on their coordinates, 1e6: from metres to um | 1
        size         | edge length of the walls' triangles           |
        finer        | boxes in which walls have shorter edges       |
        farSize      | of cells away from walls                      | size
        open         | patches that are no walls                     | ()
        featureAngle | degrees; edges that are sharper stay          | 40
    \endtable
    \code
    files   ("constant/triSurface/vessel.stl");
    size    1;
    open    (inlet outlet);
    \endcode
    \code
    fsbiDomain && fsbiFoam
    \endcode
    Writes constant/polyMesh.

Limitations
    Walls keep these triangles for the whole run: their size is to fit the
    gaps that cells leave. A patch whose border is no edge of the surface, nor
    sharper than featureAngle, has a jagged one.

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "caseInput.H"
#include "checkedDictionary.H"
#include "domainSurface.H"
#include "IOdictionary.H"
#include "polyMesh.H"
#include "spelling.H"
#include "wallSizes.H"

using namespace Foam;

static void checkOpen
(
    const dictionary& dict, const wordList& open, const wordList& patches
)
{
    for (const word& name : open)
    {
        if (!patches.found(name))
        {
            const word meant(fsbi::nearest(name, patches));
            FatalIOErrorInFunction(dict)
                << "Entry 'open' names '" << name << "', but the patches of"
                << " the surface files are " << flatOutput(patches)
                << (meant.size() ? ": is it " + meant + "?" : string()).c_str()
                << exit(FatalIOError);
        }
    }
}


static void report
(
    const fsbi::domainSurface& given, const fsbi::domainSurface& walls
)
{
    const boundBox box(walls.surface().bounds());
    Info<< "Domain from " << box.min() << " to " << box.max() << nl;
    forAll(given.patchNames(), i)
    {
        Info<< "    " << given.patchNames()[i] << ": area " << given.area(i)
            << ", in triangles " << walls.area(i) << nl;
    }
    Info<< "Volume " << given.surface().volume() << ", in triangles "
        << walls.surface().volume() << nl;
}


int main(int argc, char *argv[])
{
    argList::noParallel();
    argList::addNote
    (
        "The domain of a scene from surface files, where blockMesh makes it"
        " from blocks.\n\n"
        "    system/domainDict:\n"
        "        files   (\"constant/triSurface/vessel.stl\");\n"
        "        size    1;                  // edges of the walls' triangles\n"
        "        open    (inlet outlet);     // all others are walls\n\n"
        "Solids of the files are patches. All keywords:"
        " etc/dictionaries/domainDict.\nWrites constant/polyMesh."
    );
    #include "setRootCase.H"
    fsbi::caseInput::checkAlone
    (
        args, "domainDict", "it names the surface files (etc/dictionaries)"
    );
    #include "createTime.H"
    runTime.setTime(scalar(0), 0);

    const IOdictionary dict
    (
        IOobject
        (
            "domainDict", runTime.system(), runTime, IOobject::MUST_READ,
            IOobject::NO_WRITE, false
        )
    );
    const fsbi::checkedDictionary entries(dict);
    const List<fileName> files(entries.get<List<fileName>>("files"));
    const scalar scale = entries.positive("scale", 1);
    const fsbi::wallSizes sizes(entries);
    const scalar featureAngle = entries.positive("featureAngle", 40);
    dictionary inside;
    inside.set("farSize", entries.positive("farSize", sizes.size()));
    // nothing is solved on these cells: sharp wedges may have poor ones
    inside.set("maxNonOrthogonality", 85);
    inside.set("maxSkewness", 20);
    const wordList open(entries.getOrDefault<wordList>("open", wordList()));
    entries.finish();

    const fsbi::domainSurface given(files, scale);
    checkOpen(dict, open, given.patchNames());
    sizes.check(dict, given.surface());
    const fsbi::domainSurface walls(given.retriangulated(sizes, featureAngle));
    report(given, walls);

    const fsbi::meshLists mesh(walls.fill(fsbi::bodyMesher(inside), open));
    if (!mesh.valid())
    {
        FatalErrorInFunction << mesh.failure.c_str() << exit(FatalError);
    }
    autoPtr<polyMesh> domain
    (
        mesh.makePolyMesh
        (
            IOobject(polyMesh::defaultRegion, runTime.constant(), runTime)
        )
    );
    domain->setInstance(runTime.constant());
    domain->removeFiles();
    domain->write();
    Info<< "Cells: " << mesh.nCells() << nl << "Written: "
        << runTime.constant()/polyMesh::meshSubDir << nl << nl << "End" << nl
        << endl;
    return 0;
}
