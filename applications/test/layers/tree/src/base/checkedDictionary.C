/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "checkedDictionary.H"
#include "scalar.H"
#include "wordList.H"
#include "FlatOutput.H"
#include "HashPtrTable.H"
#include "error.H"

std::function<void(const Foam::string&)>
    Foam::fsbi::checkedDictionary::note_;

const Foam::dictionary& Foam::fsbi::checkedDictionary::subDictOrEmpty
(
    const word& key
) const
{
    // one for each name, which the notes of defaults tell
    static HashPtrTable<dictionary, string> absent;

    known_.insert(key);
    if (dict_.found(key))
    {
        return subDict(key);
    }
    const fileName name(dict_.name() + '.' + key);
    if (!absent.found(name))
    {
        absent.insert(name, autoPtr<dictionary>::New(name));
    }
    return *absent[name];
}


const Foam::dictionary& Foam::fsbi::checkedDictionary::subDict
(
    const word& key
) const
{
    known_.insert(key);
    const entry* e = dict_.findEntry(key);
    if (e && !e->isDict())
    {
        FatalIOErrorInFunction(dict_)
            << "Entry '" << key << "' must be a sub-dictionary: " << key
            << " { ... }" << exit(FatalIOError);
    }
    return dict_.subDict(key);
}


Foam::scalar Foam::fsbi::checkedDictionary::positive(const word& key) const
{
    const scalar value = get<scalar>(key);
    if (!(value > 0))
    {
        FatalIOErrorInFunction(dict_)
            << "Entry '" << key << "' must be above zero, but is " << value
            << exit(FatalIOError);
    }
    return value;
}


Foam::scalar Foam::fsbi::checkedDictionary::positive
(
    const word& key, const scalar deflt
) const
{
    return found(key) ? positive(key) : noted(key, deflt);
}


Foam::scalar Foam::fsbi::checkedDictionary::tolerance
(
    const word& key, const scalar deflt
) const
{
    const scalar value = positive(key, deflt);
    if (value > largestTolerance)
    {
        FatalIOErrorInFunction(dict_)
            << "Entry '" << key << "' is " << value << ": above "
            << scalar(largestTolerance) << " nothing would be solved; the"
            << " default is " << deflt << exit(FatalIOError);
    }
    return value;
}


Foam::label Foam::fsbi::checkedDictionary::count
(
    const word& key, const label deflt
) const
{
    const label value = getOrDefault<label>(key, deflt);
    if (value < 1)
    {
        FatalIOErrorInFunction(dict_)
            << "Entry '" << key << "' must be 1 or more, but is " << value
            << exit(FatalIOError);
    }
    return value;
}


Foam::vector Foam::fsbi::checkedDictionary::direction(const word& key) const
{
    const vector value = get<vector>(key);
    if (mag(value) < SMALL)
    {
        FatalIOErrorInFunction(dict_)
            << "Entry '" << key << "' has no length" << exit(FatalIOError);
    }
    return value/mag(value);
}


Foam::vector Foam::fsbi::checkedDictionary::direction
(
    const word& key, const vector& deflt
) const
{
    return found(key) ? direction(key) : noted(key, deflt);
}


Foam::word Foam::fsbi::checkedDictionary::choice
(
    const word& key, const wordList& valid
) const
{
    const word value = get<word>(key);
    if (!valid.found(value))
    {
        FatalIOErrorInFunction(dict_)
            << "Entry '" << key << "' is '" << value
            << "'; valid choices are " << flatOutput(valid)
            << exit(FatalIOError);
    }
    return value;
}


Foam::word Foam::fsbi::checkedDictionary::choice
(
    const word& key, const wordList& valid, const word& deflt
) const
{
    return found(key) ? choice(key, valid) : noted(key, deflt);
}


void Foam::fsbi::checkedDictionary::finish() const
{
    for (const entry& e : dict_)
    {
        if (!known_.found(e.keyword()))
        {
            const label line = e.startLineNumber();
            FatalIOErrorInFunction(dict_)
                << "Unknown keyword '" << e.keyword()
                << (line > 0 ? "' on line " + Foam::name(line) : string("'"))
                   .c_str()
                << " of " << dict_.name()
                << "; known keywords are " << flatOutput(known_.sortedToc())
                << exit(FatalIOError);
        }
    }
}


void Foam::fsbi::checkedDictionary::checkBlocks
(
    const dictionary& dict, const wordList& read
)
{
    const checkedDictionary blocks(dict);
    for (const word& key : read)
    {
        blocks.subDictOrEmpty(key);
    }
    for
    (
        const char* key :
        {
            "FoamFile", "solvers", "relaxationFactors", "cache", "ddtSchemes",
            "gradSchemes", "divSchemes", "laplacianSchemes",
            "interpolationSchemes", "snGradSchemes", "fluxRequired", "wallDist"
        }
    )
    {
        blocks.found(key);
    }
    blocks.finish();
}
