/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "startField.H"
#include "checkedDictionary.H"
#include "fvPatchFields.H"
#include "spelling.H"
#include "Time.H"
#include "IFstream.H"
#include "IStringStream.H"

bool Foam::fsbi::hasStartField
(
    const Time& time,
    const word& region,
    const word& name
)
{
    bool there = isFile(time.globalPath()/time.timeName()/region/name);
    Pstream::scatter(there);
    return there;
}


Foam::dictionary Foam::fsbi::startField
(
    const Time& time,
    const word& region,
    const word& name,
    const dimensionSet& dimensions
)
{
    dictionary dict;
    const fileName file(time.globalPath()/time.timeName()/region/name);
    if (Pstream::master())
    {
        IFstream is(file);
        IOobject header(name, time.timeName(), region, time);
        if (!is.good() || !header.readHeader(is))
        {
            FatalErrorInFunction
                << "The field " << file << " is missing, or has no"
                << " header; it gives the boundary conditions of region "
                << region << exit(FatalError);
        }
        dict = dictionary(is);
    }
    Pstream::scatter(dict);
    dict.name() = file;
    const dimensionSet given(dict.lookup("dimensions"));
    if (given != dimensions)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'dimensions' of field " << name << " is " << given
            << ", but must be " << dimensions << exit(FatalIOError);
    }
    return dict;
}


//- Fatal if a patch has a condition that there is not
static void checkType(const Foam::dictionary& patch)
{
    using namespace Foam;
    const word type(patch.getOrDefault<word>("type", word::null));
    const wordList known
    (
        fvPatchVectorField::dictionaryConstructorTablePtr_->sortedToc()
    );
    if (type.size() && !known.found(type))
    {
        const word meant(fsbi::nearest(type, known));
        FatalIOErrorInFunction(patch)
            << "There is no boundary condition '" << type << "'"
            << string(meant.size() ? " (" + meant + "?)" : "").c_str()
            << ", neither here nor in a library that 'libs' of"
            << " system/controlDict names; those made for fsbiFoam stand in"
            << " etc/dictionaries/U, there are " << flatOutput(known)
            << exit(FatalIOError);
    }
}


void Foam::fsbi::checkPatches(const dictionary& field, const polyMesh& mesh)
{
    const polyBoundaryMesh& patches = mesh.boundaryMesh();
    const wordList names(patches.names());
    const dictionary& conditions =
        checkedDictionary(field).subDict("boundaryField");
    for (const entry& e : conditions)
    {
        if (!e.isDict())
        {
            FatalIOErrorInFunction(conditions)
                << "Entry '" << e.keyword() << "' on line "
                << e.startLineNumber() << " must be a dictionary, with the type"
                << " of condition" << exit(FatalIOError);
        }
        if
        (
            !e.keyword().isPattern() && !names.found(e.keyword())
         && !patches.groupPatchIDs().found(e.keyword())
         && !polyPatch::constraintType(e.keyword())
        )
        {
            FatalIOErrorInFunction(conditions)
                << "There are conditions for a patch '" << e.keyword()
                << "', but the patches of region '" << mesh.name() << "' are "
                << flatOutput(names) << exit(FatalIOError);
        }
        checkType(e.dict());
    }
}


void Foam::fsbi::setPatch
(
    dictionary& patches,
    const word& name,
    const word& type
)
{
    dictionary entry
    (
        IStringStream("type " + type + "; value uniform (0 0 0);")()
    );
    // set() would overwrite a pattern that matches the name
    patches.remove(name);
    patches.add(name, entry);
}
