/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "runNotes.H"
#include "clock.H"
#include "stringOps.H"

#include <ctime>
#include <fstream>
#include <hdf5.h>
#include <petscsys.h>
#include <unistd.h>

namespace Foam
{
namespace fsbi
{

//- Beside the folder of the program; Allwmake writes it
static List<string> builtCommit()
{
    char path[4096];
    const ssize_t n = readlink("/proc/self/exe", path, sizeof(path));
    const fileName program(std::string(path, n > 0 ? n : 0));
    std::ifstream is(program.path().path()/"version");
    std::string line;
    return {std::getline(is, line) ? string(line) : string("unknown")};
}


static List<string> libraries()
{
    unsigned major = 0, minor = 0, release = 0;
    H5get_libversion(&major, &minor, &release);
    char petsc[256] = "";
    PetscGetVersion(petsc, sizeof(petsc));
    return
    {
        "OpenFOAM v" + name(label(OPENFOAM)), stringOps::trim(petsc),
        "HDF5 " + name(label(major)) + '.' + name(label(minor)) + '.'
      + name(label(release))
    };
}


static List<string> processor()
{
    std::ifstream is("/proc/cpuinfo");
    for (std::string line; std::getline(is, line);)
    {
        const auto colon = line.find(": ");
        if (line.compare(0, 10, "model name") == 0 && colon != line.npos)
        {
            return {string(line.substr(colon + 2))};
        }
    }
    return {string("unknown")};
}


static List<string> bodies(const scene& scene)
{
    DynamicList<string> all;
    const auto add = [&](const char* kind, const auto& list)
    {
        for (const auto& body : list)
        {
            all.append(string(kind) + body.name());
        }
    };
    add("rigid ", scene.bodies().rigid);
    add("elastic ", scene.bodies().elastic);
    add("prescribed ", scene.bodies().prescribed);
    return List<string>(std::move(all));
}


static string nowUTC()
{
    const std::time_t now = std::time(nullptr);
    char text[40];
    std::strftime(text, sizeof(text), "%Y-%m-%d %H:%M:%S", std::gmtime(&now));
    return text;
}

} // End namespace fsbi
} // End namespace Foam


std::map<Foam::word, Foam::List<Foam::string>> Foam::fsbi::runNotes
(
    const scene& scene, const UList<string>& defaults
)
{
    std::map<word, List<string>> notes;
    notes["begun"] = {nowUTC()};
    notes["program"] = builtCommit();
    notes["libraries"] = libraries();
    notes["processes"] = {string(name(Pstream::nProcs()))};
    notes["processor"] = processor();
    notes["cells"] = {string(name(scene.nCells()))};
    notes["bodies"] = bodies(scene);
    if (scene.effects())
    {
        for (const word& effect : scene.effects()->names())
        {
            notes["effects"].append(effect);
        }
    }
    notes["defaults"] = defaults;
    return notes;
}
