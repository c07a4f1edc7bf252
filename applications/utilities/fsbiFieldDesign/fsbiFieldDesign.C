/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Application
    fsbiFieldDesign

Description
    Which magnetic fields hold a body, or move it along a path: currents of
    coils, a uniform field, a gradient as functions of time, so that the field
    makes the force and torque that the fluid and everything else do not. The
    load comes from a past run, in which a tether or constraints made it, or
    from a path and the resistance of the fluid along it, with walls and flow.

    Of all strengths that make it the least are taken, within limits: see
    fieldDesign for the equations, designEntries for all keywords.

Usage
    system/fieldDesignDict
    \code
    body        microbead;
    tether      { case "../tethered"; }     // or trajectory {...}
    fields      { left { limit 2; } right { limit 2; } }    // A
    bias        (0 0 0.01);                 // T
    \endcode
    constant/effects, with which fsbiFoam is run next
    \code
    left
    {
        type coil; centre (-5e4 0 0); axis (1 0 0); radius 5e4; turns 100;
        current { type tableFile; file "<case>/constant/fieldDesign/left"; }
    }
    \endcode
    Writes constant/fieldDesign/<field>, a table for each field, and
    postProcessing/fieldDesign.csv: everything, with the load that was wanted
    and that which is made.

Limitations
    The load is not fed back: the body is held where the field, the fluid and
    the mesh bring it. Inertia, bonds and other effects are not in the load.

\*---------------------------------------------------------------------------*/

#include "petscObjects.H"
#include "argList.H"
#include "caseInput.H"
#include "designFiles.H"
#include "Time.H"

using namespace Foam;

static scalar largestLoad(const fsbi::loadTrajectory& wanted, const scalar radius)
{
    scalar largest = 0;
    for (const fsbi::wantedLoad& w : wanted)
    {
        largest = max
        (
            largest, fsbi::fieldDesign::load(w.force, w.torque, radius)
        );
    }
    return largest;
}


int main(int argc, char *argv[])
{
    argList::noParallel();
    argList::addNote
    (
        "Magnetic fields that hold a body, or move it along a path.\n\n"
        "    system/fieldDesignDict:\n"
        "        body        microbead;\n"
        "        tether      { case \"../tethered\"; }   // a past run, or\n"
        "        // trajectory { position table (...); end 1e5; }\n"
        "        fields      { left { limit 2; } right { limit 2; } }\n\n"
        "The fields are those of constant/effects: coils, uniform, gradient."
        " All keywords:\netc/dictionaries/fieldDesignDict."
        " Writes constant/fieldDesign/<field>, which\n"
        "constant/effects reads as tableFile, and"
        " postProcessing/fieldDesign.csv."
    );
    #include "setRootCase.H"
    fsbi::caseInput::check(args, {"fieldDesignDict"});
    #include "createTime.H"
    runTime.setTime(scalar(0), 0);
    IOstream::defaultPrecision(16);         // of places on the way as entries

    fsbi::petscSession petsc;
    const fsbi::designEntries entries(runTime);
    const scalar volume = entries.volume();
    const scalar radius = fsbi::fieldDesign::radius(volume, entries.inUnits());
    const fsbi::loadTrajectory wanted(entries.wanted());
    const scalar largest = largestLoad(wanted, radius);
    if (largest == 0)
    {
        FatalIOErrorInFunction(entries.dict())
            << "No force or torque is wanted at any time" << exit(FatalIOError);
    }
    const fsbi::fieldDesign design
    (
        entries.law(), volume, entries.inUnits(), largest, entries.bias(),
        entries.lawEntries()
    );
    const fsbi::designed result
    {
        fsbi::solveTrajectory(entries, design, wanted), entries
    };
    const fileName folder(runTime.globalPath()/"constant"/"fieldDesign");
    const fileName csv
    (
        runTime.globalPath()/"postProcessing"/"fieldDesign.csv"
    );
    result.writeTables(folder);
    result.writeCsv(csv);
    result.summarise(radius);
    Info<< "Written: " << folder << ", " << csv << nl << nl << "End" << nl
        << endl;
    return 0;
}
