/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Application
    fsbiIdentifyMaterial

Description
    Constants of an elastic body's law from observations of its surface: the
    stress-free one, displacement and traction in equilibrium [3.30-3.33]. See
    README.md beside this file.

Usage
    \code
    fsbiIdentifyMaterial                    // system/identifyDict
    fsbiIdentifyMaterial -export surface.csv
    fsbiIdentifyMaterial -shape observed.stl
    \endcode
    Entries of system/identifyDict: etc/dictionaries/identifyDict. Writes to
    postProcessing/identification: material (as found), constants.csv,
    misfits.csv.

Limitations
    One process. One elastic body at rest, without viscosity. Volume forces
    other than a uniform one are not known to it.

\*---------------------------------------------------------------------------*/

#include "report.H"
#include "caseInput.H"
#include "elasticBody.H"
#include "petscObjects.H"
#include "argList.H"
#include "OSspecific.H"
#include "IOdictionary.H"
#include "MeshedSurface.H"

using namespace Foam;
using namespace Foam::fsbi;

//- Springs that hardly know of single displacements
static const scalar softer = 1e-3;

static IOdictionary caseDictionary
(
    const Time& time, const word& name, const fileName& folder,
    const fileName& local, const IOobject::readOption option
)
{
    return IOdictionary
    (
        IOobject
        (
            name, folder, local, time, option, IOobject::NO_WRITE, false
        )
    );
}


//- The elastic body that is meant
static word bodyName(const checkedDictionary& entries, const dictionary& bodies)
{
    DynamicList<word> elastic;
    for (const entry& e : bodies)
    {
        if
        (
            e.isDict()
         && e.dict().getOrDefault<word>("type", word::null) == "elasticBody"
        )
        {
            elastic.append(e.keyword());
        }
    }
    if (elastic.empty())
    {
        FatalIOErrorInFunction(bodies)
            << "There is no elastic body" << exit(FatalIOError);
    }
    return
        elastic.size() == 1
      ? entries.choice("body", elastic, elastic[0])
      : entries.choice("body", elastic);
}


//- What is sought, with ranges
static List<identification::constant> readConstants(const dictionary& find)
{
    DynamicList<identification::constant> constants;
    for (const entry& e : find)
    {
        const FixedList<scalar, 2> range
        (
            find.get<FixedList<scalar, 2>>(e.keyword())
        );
        if (!(range[0] < range[1]))
        {
            FatalIOErrorInFunction(find)
                << "Range of '" << e.keyword() << "' must be (lowest highest)"
                << exit(FatalIOError);
        }
        constants.append({e.keyword(), range[0], range[1]});
    }
    if (constants.empty())
    {
        FatalIOErrorInFunction(find)
            << "Say which constants to find, with their ranges, e.g."
            << " find { E (1e-4 1e-2); nu (0 0.45); }" << exit(FatalIOError);
    }
    return List<identification::constant>(std::move(constants));
}


//- The body's surface as observed, of its own mesh, as STL or OBJ
static void writeShape
(
    const fvMesh& mesh, const surfaceData& data, const fileName& file
)
{
    const label n = mesh.nFaces() - mesh.nInternalFaces();
    const MeshedSurface<face> surface
    (
        surfaceTransfer(mesh, data.x).moved(data.u),
        faceList(SubList<face>(mesh.faces(), n, mesh.nInternalFaces())),
        surfZoneList()
    );
    surface.write(file);
}


//- Must pressure be an unknown of its own? The same for all trials
static bool needsPressure
(
    const dictionary& law, const List<identification::constant>& constants
)
{
    scalar lowest = law.getOrDefault<scalar>("nu", 0), highest = lowest;
    for (const auto& c : constants)
    {
        if (c.name == "nu")
        {
            lowest = c.lowest;
            highest = c.highest;
        }
    }
    if (highest >= 0.47 && lowest < 0.05)
    {
        FatalErrorInFunction
            << "The range of nu, " << lowest << " to " << highest
            << ", is too wide for one method: nearly incompressible bodies"
            << " (0.47 and above) have a pressure of their own, which needs nu"
            << " of 0.05 at least. Try (0 0.46), then (0.4 0.4999)"
            << exit(FatalError);
    }
    return highest >= 0.47;
}


int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Constants of an elastic body's law from the displacement of its"
        " surface and the\ntraction on it, from a saved state or a file; see"
        " system/identifyDict.\n\n    fsbiIdentifyMaterial"
    );
    argList::noParallel();
    argList::addOption
    (
        "export", "file", "Write a saved state's surface as text; no more"
    );
    argList::addOption
    (
        "shape", "file", "Write the observed surface as STL or OBJ; no more"
    );
    #include "setRootCase.H"
    fsbi::caseInput::check(args, {"identifyDict"});
    #include "createTime.H"

    petscSession petsc;
    const dictionary bodies
    (
        caseDictionary
        (
            runTime, "bodies", runTime.constant(), "", IOobject::MUST_READ
        )
    );
    const bool exporting = args.found("export");
    const IOdictionary control
    (
        caseDictionary
        (
            runTime, "identifyDict", runTime.system(), "",
            exporting ? IOobject::READ_IF_PRESENT : IOobject::MUST_READ
        )
    );
    const checkedDictionary entries(control);
    const word name(bodyName(entries, bodies));
    const bool fromFile = entries.found("file") && !exporting;
    if (!fromFile && !(runTime.value() > 0))
    {
        FatalErrorInFunction
            << "There is no saved state at the start time: run the case and"
            << " set 'startFrom latestTime' in system/controlDict, or give"
            << " 'file' in system/identifyDict" << exit(FatalError);
    }
    autoPtr<fvMesh> mesh
    (
        fromFile
      ? elasticBody(name, bodies.subDict(name)).makeMesh
        (
            runTime, bodies.size() == 1, false
        )
      : readRegionMesh(runTime, name, runTime.timeName())
    );
    surfaceData data
    (
        fromFile
      ? surfaceData::read(entries.get<fileName>("file").expand())
      : surfaceData::saved(mesh())
    );
    if (exporting)
    {
        data.write(args["export"]);
        return 0;
    }
    if (args.found("shape"))
    {
        writeShape(mesh(), data, args["shape"]);
        return 0;
    }
    const bool fromFlow = fromFile && entries.found("traction");
    if (fromFlow)
    {
        data.readTractions(entries.get<fileName>("traction").expand());
    }

    dictionary law
    (
        caseDictionary
        (
            runTime, "material", runTime.constant(), name,
            IOobject::READ_IF_PRESENT
        )
    );
    law.remove("FoamFile");
    if (entries.found("material"))
    {
        law = entries.subDict("material");
    }
    law.remove("viscosity");        // at rest
    const List<identification::constant> constants
    (
        readConstants(entries.subDict("find"))
    );
    const bool deformed = fromFlow || (fromFile && entries.choice
    (
        "areas", {"stressFree", "deformed"}, "stressFree"
    ) == "deformed");
    const bool tractions = entries.choice
    (
        "objective", {"displacement", "traction"}, "displacement"
    ) == "traction";
    const residualNorm norm(entries);
    const scalar springs =
        entries.positive
        (
            "springs",
            tractions ? loadedBody::stiff
          : norm.robust() ? softer : loadedBody::soft
        );
    const scalar confidence = entries.positive("confidence", 0.95);
    const bool roughness = !entries.found("tractionError");
    const scalar given = entries.getOrDefault<scalar>("tractionError", 0);
    entries.finish();

    loadedBody body(mesh(), data, deformed, needsPressure(law, constants));
    identification found(body, data, law, constants, tractions, norm);
    found.find(springs);

    const fileName folder
    (
        runTime.path()/"postProcessing"/"identification"
    );
    mkDir(folder);
    reportConstants
    (
        found, constants, roughness ? found.tractionError() : given, confidence,
        folder
    );
    reportMisfits(found, body, norm, folder);
    Info<< "    " << body.solutions() << " solutions, "
        << runTime.elapsedCpuTime() << " s" << nl << endl;
    return 0;
}
