/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Application
    fsbiFoam

Description
    Cells and microrobots in microvascular flow: Stokes flow, rigid and elastic
    bodies on a conformal moving mesh, the effects of constant/effects, and what
    is dissolved (constant/species).

\*---------------------------------------------------------------------------*/

#include "petscObjects.H"
#include "argList.H"
#include "caseInput.H"
#include "checkpoint.H"
#include "dryRun.H"
#include "functionRunner.H"
#include "recorder.H"
#include "runLock.H"
#include "savedProcesses.H"
#include "toolFiles.H"

using namespace Foam;

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Cells and microrobots in microvascular flow: rigid and elastic bodies"
        " in Stokes\nflow on a conformal moving mesh, bonds, magnets.\n\n"
        "    blockMesh && fsbiFoam                  in a case folder\n"
        "    blockMesh && mpirun -np 2 fsbiFoam -parallel\n\n"
        "The run divides its meshes itself. decomposePar may do it before, by"
        " 'method\nhierarchical;' or 'simple' (Debian's OpenFOAM comes without"
        " scotch). fsbiRedistribute\njoins the parts or divides them"
        " otherwise.\n\n"
        "Reads constant/bodies, constant/fluid/material, 0/fluid/U and\n"
        "system/{controlDict,remeshDict,fluid/fvSolution}; if there are any"
        " constant/effects,\nconstant/species; of an elastic body"
        " constant/<body>/material,\n0/<body>/D, system/<body>/{fvSchemes,"
        "fvSolution}. Writes time folders with the regions\n(fluid: U, p;"
        " <body>: D, sigma ...), postProcessing/history.h5 and"
        " postProcessing/bodies.\n"
        "Ctrl-C, SIGTERM or SIGUSR1 ends the run after the step in hand with a"
        " saved state;\n'startFrom latestTime' continues."
    );

    argList::addBoolOption
    (
        "dry-run",
        "Check the case, list its effects and every default taken, estimate"
        " time and memory from two steps; write nothing"
    );

    argList::addOption
    (
        "maxWallTime",
        "time",
        "End with a saved state before this time is over: seconds, or"
        " [days-][hours:]minutes:seconds as a cluster's queue tells it"
    );

    // its own check says what to type
    argList::noCheckProcessorDirectories();
    argList args(argc, argv);
    const fsbi::runLock lock(args);
    fsbi::caseInput::check(args);
    fsbi::stepControl::check(args);
    fsbi::stateFolder::recover(args.path());
    fsbi::savedProcesses::check(args);
    if (!args.checkRootCase())
    {
        FatalError.exit();
    }
    #include "foamDlOpenLibs.H"
    #include "createTime.H"

    const fsbi::defaultsTaken defaults(runTime.globalPath());
    fsbi::stepControl steps(runTime, args);
    fsbi::checkpoint states(runTime);
    const dictionary saved(states.read());
    const bool restarted = saved.size();

    fsbi::petscSession petsc;
    if (args.found("dry-run"))
    {
        fsbi::dryRun(runTime, steps, defaults).run(saved);
        return 0;
    }

    fsbi::scene scene(runTime, saved);
    if (restarted)
    {
        steps.restore(saved.subDict("stepControl"));
    }
    fsbi::functionRunner functions(runTime, scene, restarted);
    if (!restarted)
    {
        states.write(scene, steps);
    }
    fsbi::writeToolFiles(runTime, scene);
    fsbi::recorder history(runTime, scene, restarted, defaults.lines());

    while (steps.next(scene))
    {
        scene.beginStep();

        const fsbi::outcome step(scene.advance());
        if (!step)
        {
            scene.rewind();
            history.reject(step);
            steps.reject(scene, step);
            continue;
        }

        scene.endStep();
        steps.accept(scene);
        history.append(steps);
        states.writeWhenDue(scene, steps);
        functions.execute(steps.saveDue());
    }

    functions.end();
    steps.conclude();
    scene.clocks().report(Info);
    runTime.printExecutionTime(Info);
    Info<< "End" << nl << endl;

    return 0;
}
