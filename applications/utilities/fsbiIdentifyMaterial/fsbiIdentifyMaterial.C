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
    \endcode
    Entries of system/identifyDict: etc/dictionaries/identifyDict. Writes to
    postProcessing/identification: material (as found), constants.csv,
    misfits.csv.

Limitations
    One process. One elastic body at rest, without viscosity. Volume forces
    other than a uniform one are not known to it.

\*---------------------------------------------------------------------------*/

#include "identification.H"
#include "elasticBody.H"
#include "petscObjects.H"
#include "argList.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "IOdictionary.H"

#include <gsl/gsl_cdf.h>

using namespace Foam;
using namespace Foam::fsbi;

//- Springs that give the displacement
static const scalar stiff = 1e3;

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


static void report
(
    identification& found,
    const List<identification::constant>& constants,
    const List<scalarList>& covariance,
    const scalar confidence,
    const fileName& folder
)
{
    const scalar t = gsl_cdf_tdist_Pinv
    (
        0.5 + 0.5*confidence, found.freedom()
    );
    mkDir(folder);
    OFstream os(folder/"constants.csv");
    os.precision(10);
    os << "constant,value,lowest,highest,deviation,atLimit" << nl;
    forAll(constants, k)
    {
        const auto& c = constants[k];
        const scalar deviation = Foam::sqrt(covariance[k][k]);
        const scalar half = t*deviation, value = found.value(k);
        const bool sure = covariance[k][k] < GREAT;
        const scalar low = sure ? c.value(found.at()[k] - half) : -GREAT;
        const scalar high = sure ? c.value(found.at()[k] + half) : GREAT;
        os << c.name << ',' << value << ',' << low << ',' << high << ','
            << (sure ? (c.powers() ? value*deviation : deviation) : GREAT)
            << ',' << found.limited(k) << nl;
        Info<< "    " << c.name << " = " << value << "    ";
        if (sure)
        {
            Info<< 100*confidence << " % sure: " << low << " to " << high << nl;
        }
        else
        {
            Info<< "not sure at all: the body found cannot bear small further"
                << " forces" << nl;
        }
        if (found.limited(k))
        {
            Info<< "    " << c.name << " is at the limit of its range: widen"
                << " it in 'find'; or the data do not determine it" << nl;
        }
    }
    for (label k = 1; k < constants.size(); ++k)
    {
        for (label l = 0; l < k; ++l)
        {
            Info<< "    correlation of " << constants[l].name << " and "
                << constants[k].name << ": "
                << covariance[k][l]
                  /Foam::sqrt(covariance[k][k]*covariance[l][l]) << nl;
        }
    }
    OFstream law(folder/"material");
    IOobject::writeBanner(law)
        << "FoamFile { version 2.0; format ascii; class dictionary;"
        << " object material; }" << nl;
    found.law().write(law, false);
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
    #include "setRootCase.H"
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
            runTime, bodies.size() == 1
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
    const bool deformed = fromFile && entries.choice
    (
        "areas", {"stressFree", "deformed"}, "stressFree"
    ) == "deformed";
    const scalar springs = entries.positive("springs", 0.1);
    const scalar confidence = entries.positive("confidence", 0.95);
    const bool roughness = !entries.found("tractionError");
    const scalar given = entries.getOrDefault<scalar>("tractionError", 0);
    entries.finish();

    loadedBody body(mesh(), data, deformed, needsPressure(law, constants));
    identification found(body, data, law, constants);

    found.find(springs);

    const scalar tractionError = roughness ? found.tractionError() : given;
    const List<scalarList> covariance(found.covariance(tractionError));
    const fileName folder
    (
        runTime.path()/"postProcessing"/"identification"
    );
    report(found, constants, covariance, confidence, folder);
    const scalar misfit = found.misfit(), noise = found.noise();
    const scalar ratio = found.springs();

    // with the surface as observed, what does the law's traction lack?
    body.setSprings(stiff, found.modulus());
    body.setLaw(found.law());
    vectorField u;
    const scalar lack = body.solve(u) ? body.springShare() : GREAT;
    Info<< "    standard deviations: displacement "
        << found.displacementError() << ", traction " << tractionError << nl
        << "    relative misfit of displacement " << misfit << ", of this noise "
        << noise << ", model error "
        << Foam::sqrt(max(0, sqr(misfit) - sqr(noise))) << nl
        << "    misfit of traction over that of no stress " << lack << nl
        << "    springs " << ratio << nl;
    OFstream os(folder/"misfits.csv");
    os.precision(10);
    os << "displacement,noise,modelError,traction,springs" << nl << misfit << ','
        << noise << ',' << Foam::sqrt(max(0, sqr(misfit) - sqr(noise))) << ','
        << lack << ',' << ratio << nl;
    Info<< "    " << body.solutions() << " solutions, "
        << runTime.elapsedCpuTime() << " s" << nl << endl;
    return 0;
}
