/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dryRun.H"
#include "functionRunner.H"
#include "OSspecific.H"

namespace
{

//- The second one starts from the flow of the first
const Foam::label stepsTried = 2;

//- Where files may be opened that are gone when the program ends, however
class scratchFolder
{
    Foam::fileName path_;

public:

    scratchFolder()
    {
        const Foam::string folder(Foam::getEnv("TMPDIR"));
        std::string name
        (
            (folder.empty() ? "/tmp" : folder) + "/fsbiFoam-dry-run-XXXXXX"
        );
        if (Foam::Pstream::master() && mkdtemp(&name[0]))
        {
            path_ = name;
        }
        Foam::Pstream::scatter(path_);
    }

    ~scratchFolder()
    {
        if (Foam::Pstream::master())
        {
            Foam::rmDir(path_, true);
        }
    }

    //- Its name as it is relative to an absolute path
    Foam::word from(const Foam::fileName& path) const
    {
        std::string up;
        for (Foam::label i = path.components().size(); i > 0; --i)
        {
            up += "../";
        }
        return Foam::word(up + path_.substr(path_.size() > 0), false);
    }
};

} // End anonymous namespace


void Foam::fsbi::dryRun::tryFunctions
(
    const scene& scene, const dictionary& saved
)
{
    // they open their files when they are made
    static const scratchFolder scratch;
    const word usual(functionObject::outputPrefix);
    functionObject::outputPrefix = scratch.from(time_.globalPath());
    functionRunner(time_, scene, saved.size());
    time_.functionObjects().clear();
    functionObject::outputPrefix = usual;
}


void Foam::fsbi::dryRun::tryStep(scene& scene)
{
    const clockTime clock;
    const scalar meshing = scene.clocks().seconds("meshing");
    scene.beginStep();
    const outcome step(scene.advance());
    if (!step)
    {
        scene.rewind();
        control_.reject(scene, step);
        return;
    }
    scene.endStep();
    secondsPerStep_ = clock.elapsedTime()
      - (scene.clocks().seconds("meshing") - meshing);
    control_.accept(scene);
    ++steps_;
}


void Foam::fsbi::dryRun::reportScene(const scene& scene) const
{
    const auto report = [](const char* kind, const auto& bodies)
    {
        for (const auto& body : bodies)
        {
            Info<< "    " << kind << ' ' << body.name() << nl;
        }
    };
    Info<< nl << "Scene" << nl;
    report("rigid body  ", scene.bodies().rigid);
    report("elastic body", scene.bodies().elastic);
    report("rolling body", scene.bodies().prescribed);
    Info<< "    cells        " << scene.nCells() << nl
        << "    effects      ";
    if (scene.effects())
    {
        scene.effects()->reportNames(Info);
    }
    else
    {
        Info<< "none";
    }
    Info<< nl;
    if (scene.carried())
    {
        Info<< "    species      ";
        scene.carried()->reportNames(Info);
        Info<< nl;
    }
    if (scene.hasFluid() && scene.fluid().momentum().terms().size())
    {
        Info<< "    momentum     ";
        scene.fluid().momentum().reportNames(Info);
        Info<< nl;
    }
}


void Foam::fsbi::dryRun::reportDefaults() const
{
    Info<< nl << "Defaults taken" << nl;
    for (const string& line : defaults_.lines())
    {
        Info<< "    " << line.c_str() << nl;
    }
}


void Foam::fsbi::dryRun::reportCost(scene& scene) const
{
    const scalar left = time_.endTime().value() - time_.value();
    const scalar steps = steps_ + max(left/time_.deltaTValue(), scalar(0));
    Info<< nl << "Estimate for this machine" << nl
        << "    steps        " << std::round(steps) << " of "
        << time_.deltaTValue() << ", " << secondsPerStep_ << " s each" << nl
        << "    new meshes   " << scene.clocks().seconds("meshing")
        << " s each, as the body moves" << nl
        << "    time         " << steps*secondsPerStep_ << " s and new meshes"
        << nl
        << "    memory       " << returnReduce
           (
               timings::peakMemory(), sumOp<scalar>()
           )
        << " MB" << nl << nl << "Nothing was written" << nl << endl;
}


void Foam::fsbi::dryRun::run(const dictionary& saved)
{
    scene scene(time_, saved);
    if (saved.size())
    {
        control_.restore(saved.subDict("stepControl"));
    }
    reportScene(scene);
    reportDefaults();
    tryFunctions(scene, saved);
    Info<< nl << "Steps tried" << endl;
    while (steps_ < stepsTried && control_.next(scene))
    {
        tryStep(scene);
    }
    reportCost(scene);
}
