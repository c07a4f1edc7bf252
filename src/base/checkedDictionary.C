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
    if (const dictionary* sub = dict_.findDict(key))
    {
        return *sub;
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
            FatalIOErrorInFunction(dict_)
                << "Unknown keyword '" << e.keyword() << "' on line "
                << e.startLineNumber() << " of " << dict_.name()
                << "; known keywords are " << flatOutput(known_.sortedToc())
                << exit(FatalIOError);
        }
    }
}
