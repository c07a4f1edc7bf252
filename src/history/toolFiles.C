/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "toolFiles.H"
#include "Time.H"
#include "IFstream.H"
#include "OFstream.H"
#include "OSspecific.H"

namespace Foam
{
namespace fsbi
{

static void writeRegionProperties
(
    const fileName& constant, const wordList& fluids, const wordList& solids
)
{
    const fileName file(constant/"regionProperties");
    if (isFile(file) && !dictionary(IFstream(file)()).found("madeBy"))
    {
        return;         // the user's, which the scene has checked
    }
    OFstream os(file);
    os  << "FoamFile" << nl << token::BEGIN_BLOCK << incrIndent << nl;
    os.writeEntry("version", "2.0");
    os.writeEntry("format", word("ascii"));
    os.writeEntry("class", dictionary::typeName);
    os.writeEntry("object", word("regionProperties"));
    os  << decrIndent << token::END_BLOCK << nl << nl
        << "// Written anew by every run, unless this line is removed" << nl;
    os.writeEntry("madeBy", word("fsbiFoam"));
    os  << nl << "regions" << nl << token::BEGIN_LIST;
    const auto add = [&](const char* kind, const wordList& names)
    {
        os  << nl << "    " << kind << " (";
        for (const word& name : names)
        {
            os  << ' ' << name;
        }
        os  << " )";
    };
    add("fluid", fluids);
    add("solid", solids);
    os  << nl << token::END_LIST << token::END_STATEMENT << nl;
}

} // End namespace fsbi
} // End namespace Foam


void Foam::fsbi::writeToolFiles(const Time& time, const scene& scene)
{
    const auto mark = [&](const fvMesh& mesh)
    {
        if (Pstream::master())
        {
            writeEmptyMesh(time.globalPath()/time.constant(), mesh);
        }
        if (Pstream::parRun())
        {
            writeEmptyMesh(time.path()/time.constant(), mesh);
        }
    };
    wordList fluids, solids;
    if (scene.hasFluid())
    {
        fluids.append(scene.fluid().name());
        mark(scene.fluid().mesh());
    }
    for (const solidRegion& solid : scene.bodies().elastic)
    {
        mark(solid.mesh());
        solids.append(solid.name());
    }
    if (Pstream::master())
    {
        writeRegionProperties
        (
            time.globalPath()/time.constant(), fluids, solids
        );
        OFstream(time.globalPath()/(time.globalCaseName() + ".foam"));
    }
}
