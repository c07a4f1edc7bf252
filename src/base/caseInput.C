/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "caseInput.H"
#include "dictionaryText.H"
#include "spelling.H"
#include "HashSet.H"
#include "IFstream.H"
#include "OSspecific.H"
#include "PstreamReduceOps.H"
#include <fstream>
#include <sstream>

namespace Foam
{
namespace fsbi
{

//- What makes a folder the one of a region, below constant, system and 0
static const wordList regionFiles
({
    "material", "fvSolution", "fvSchemes", "remeshDict", "U", "D"
});

//- Dictionaries that are read if they are there
static const wordList constantFiles
({
    "bodies", "effects", "species", "regionProperties"
});
static const wordList systemFiles({"controlDict", "remeshDict"});

static std::string contents(const fileName& file)
{
    std::ifstream is(file, std::ios::binary);
    std::ostringstream os;
    os << is.rdbuf();
    return os.str();
}

//- Folders of meshes and surfaces, which are nobody's region
static bool isRegion(const fileName& folder)
{
    for (const word& file : regionFiles)
    {
        if (isFile(folder/file, false))
        {
            return true;
        }
    }
    return false;
}

} // End namespace fsbi
} // End namespace Foam


const Foam::word Foam::fsbi::caseInput::fluid("fluid");


void Foam::fsbi::caseInput::require
(
    const fileName& file, const char* what
) const
{
    if (!isFile(path_/file, false))
    {
        FatalErrorInFunction
            << "There is no file " << file.c_str() << " in " << path_.c_str()
            << ": " << what
            << exit(FatalError);
    }
}


void Foam::fsbi::caseInput::checkFile
(
    const fileName& file, const word& className
) const
{
    if (isDir(path_/file))
    {
        FatalErrorInFunction
            << file.c_str() << " must be a file, but is a folder"
            << exit(FatalError);
    }
    if (!isFile(path_/file, false))
    {
        return;
    }
    const dictionaryText text(contents(path_/file), className);
    if (text.diagnostic().size())
    {
        FatalIOError
        (
            FUNCTION_NAME, __FILE__, __LINE__, path_/file, max(text.line(), 1)
        )   << file.c_str() << ' ' << (text.line() ? "line " + name(text.line()) + ": "
            : string()).c_str() << text.diagnostic().c_str()
            << exit(FatalIOError);
    }
    for (const std::string& included : text.included())
    {
        checkFile(file.path()/fileName(included), word());
    }
}


Foam::wordList Foam::fsbi::caseInput::regionFolders() const
{
    wordHashSet names;
    for (const char* top : {"constant", "system", "0"})
    {
        for (const fileName& folder : readDir(path_/top, fileName::DIRECTORY))
        {
            if (isRegion(path_/top/folder))
            {
                names.insert(folder);
            }
        }
    }
    return names.sortedToc();
}


void Foam::fsbi::caseInput::checkSchemes(const fileName& file) const
{
    if (!isFile(path_/file, false))
    {
        return;
    }
    IFstream is(path_/file);
    const dictionary dict(is);
    for (const entry& e : dict)
    {
        // OpenFOAM would abort
        if (e.keyword().ends_with("Schemes") && !e.isDict())
        {
            FatalIOErrorInFunction(dict)
                << "Entry '" << e.keyword() << "' on line "
                << e.startLineNumber() << " must be a dictionary"
                << exit(FatalIOError);
        }
    }
}


void Foam::fsbi::caseInput::checkRegion(const word& region) const
{
    checkFile("constant"/region/"material");
    checkFile("constant"/region/"exactSolution");
    for (const word file : {"fvSchemes", "fvSolution", "remeshDict"})
    {
        checkFile("system"/region/file);
    }
    checkSchemes("system"/region/"fvSchemes");
    for (const word file : {"U", "D"})
    {
        checkFile("0"/region/file, "volVectorField");
    }
}


void Foam::fsbi::caseInput::checkFluid() const
{
    for (const char* top : {"constant", "system", "0"})
    {
        if (isDir(path_/top/fluid))
        {
            require
            (
                "constant"/fluid/"material",
                "it holds the viscosity of the fluid, which rigid and rolling"
                " bodies need. A scene of elastic bodies without fluid has no"
                " folders constant/fluid, system/fluid and 0/fluid"
            );
        }
    }
}


void Foam::fsbi::caseInput::checkAll(const wordList& others) const
{
    require("system/controlDict", "is this the folder of a case?");
    for (const word& file : systemFiles)
    {
        checkFile("system"/file);
    }
    for (const word& file : others)
    {
        checkFile("system"/file);
    }
    require("constant/bodies", "it holds one dictionary for each body");
    for (const word& file : constantFiles)
    {
        checkFile("constant"/file);
    }
    checkFluid();
    for (const word& region : regionFolders())
    {
        checkRegion(region);
    }
}


void Foam::fsbi::caseInput::check
(
    const argList& args, const wordList& others
)
{
    if (Pstream::master())
    {
        caseInput(args.globalPath()).checkAll(others);
    }
    returnReduce(true, andOp<bool>());          // until the master has looked
}


void Foam::fsbi::caseInput::checkAlone
(
    const argList& args, const word& file, const char* what
)
{
    const caseInput input(args.globalPath());
    input.require("system/controlDict", "is this the folder of a case?");
    input.require("system"/file, what);
    input.checkFile("system/controlDict");
    input.checkFile("system"/file);
}


void Foam::fsbi::caseInput::reportFolders(const wordList& regions) const
{
    for (const word& folder : regionFolders())
    {
        if (regions.found(folder))
        {
            continue;
        }
        for (const fileName top : {"constant", "system", "0"})
        {
            if (isRegion(path_/top/folder))
            {
                Info<< "Warning: nothing in " << (top/folder).c_str() << " is read: the"
                    << " regions of the scene are " << flatOutput(regions)
                    << nl;
            }
        }
    }
}


void Foam::fsbi::caseInput::reportFiles() const
{
    for (const fileName top : {"constant", "system"})
    {
        const wordList& known =
            top == "constant" ? constantFiles : systemFiles;
        for (const fileName& file : readDir(path_/top, fileName::FILE))
        {
            // not the copies that editors make
            const bool copy = file.find_first_of("~#.") != std::string::npos;
            const word meant(nearest(file, known));
            if (!copy && !known.found(file) && meant.size())
            {
                Info<< "Warning: " << (top/file).c_str() << " is not read: is"
                    << " it " << meant << '?' << nl;
            }
        }
    }
}


void Foam::fsbi::caseInput::reportUnread
(
    const Time& time, const wordList& regions
)
{
    if (Pstream::master())
    {
        const caseInput input(time.globalPath());
        input.reportFolders(regions);
        input.reportFiles();
    }
}
