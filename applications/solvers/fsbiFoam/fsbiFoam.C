/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Application
    fsbiFoam

Description
    Cells and microrobots in microvascular flow: Stokes flow coupled with
    rigid bodies on a conformal moving mesh.

\*---------------------------------------------------------------------------*/

#include "petscObjects.H"
#include "argList.H"
#include "checkpoint.H"
#include "recorder.H"

using namespace Foam;

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Cells and microrobots in microvascular flow: Stokes flow and rigid"
        " bodies\non a conformal moving mesh. Run blockMesh first."
    );

    #include "setRootCase.H"
    #include "createTime.H"

    fsbi::checkpoint::verifyStart(runTime);

    fsbi::petscSession petsc;
    fsbi::scene scene(runTime);
    fsbi::stepControl steps(runTime, scene);
    fsbi::checkpoint saved(runTime, scene, steps);

    const bool restarted = saved.restore();
    fsbi::recorder history(runTime, scene);

    if (!restarted)
    {
        saved.write();
    }

    while (steps.next())
    {
        scene.beginStep();

        if (!scene.advance())
        {
            scene.rewind();
            steps.reject();
            continue;
        }

        scene.endStep();
        history.append();
        saved.writeWhenDue();
        steps.report();
    }

    scene.clocks().report(Info);
    Info<< "End" << nl << endl;

    return 0;
}
