/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "joinedList.H"
#include "symmTensorField.H"
#include "tensorField.H"
#include "sphericalTensorField.H"

namespace Foam
{
namespace fsbi
{

template<class Type>
class joinedListOf
:
    public joinedList
{
    Field<Type> whole_;

    tmp<Field<Type>> part(const UList<label>& places) const
    {
        auto result = tmp<Field<Type>>::New(places.size(), Zero);
        forAll(places, i)
        {
            const label n = places[i];
            if (n)
            {
                const Type& value = whole_[mag(n) - 1];
                result.ref()[i] = n > 0 ? value : Type(-value);
            }
        }
        return result;
    }

public:

    joinedListOf
    (
        const List<Field<Type>>& parts, const UList<labelList>& places
    )
    {
        label size = 0;
        for (const labelList& numbers : places)
        {
            for (const label n : numbers)
            {
                size = max(size, n);
            }
        }
        whole_.setSize(size, Zero);
        // what several parts have: that of the first
        forAllReverse(parts, p)
        {
            forAll(places[p], i)
            {
                if (places[p][i] > 0)
                {
                    whole_[places[p][i] - 1] = parts[p][i];
                }
            }
        }
    }

    void writeEntry
    (
        const word& keyword, const UList<label>& places, Ostream& os
    ) const override
    {
        part(places)->writeEntry(keyword, os);
    }

    void writeList(const UList<label>& places, Ostream& os) const override
    {
        os << part(places)();
    }
};


template<class Type>
static autoPtr<joinedList> joinEntries
(
    const UPtrList<const dictionary>& parts,
    const word& keyword,
    const UList<labelList>& places
)
{
    List<Field<Type>> fields(parts.size());
    forAll(parts, p)
    {
        fields[p] = Field<Type>(keyword, parts[p], places[p].size());
    }
    return autoPtr<joinedList>(new joinedListOf<Type>(fields, places));
}


template<class Type>
static autoPtr<joinedList> joinFiles
(
    UPtrList<Istream>& parts,
    const UList<labelList>& places,
    const fileName& file
)
{
    List<Field<Type>> fields(parts.size());
    forAll(parts, p)
    {
        parts[p] >> fields[p];
        if (fields[p].size() != places[p].size())
        {
            FatalErrorInFunction
                << "The part of processor " << p << " of " << file << " has "
                << fields[p].size() << " numbers instead of "
                << places[p].size() << exit(FatalError);
        }
    }
    return autoPtr<joinedList>(new joinedListOf<Type>(fields, places));
}


//- Component type of an entry: scalar, vector ...; empty: no list of values
static word typeOf(const dictionary& dict, const word& keyword)
{
    const entry* found = dict.findEntry(keyword, keyType::LITERAL);
    if (!found || !found->isStream() || found->stream().size() < 2)
    {
        return word();
    }
    const tokenList& tokens = found->stream();
    if (tokens[0] == word("nonuniform") && tokens[1].isCompound())
    {
        const word list(tokens[1].compoundToken().type());
        return list.substr(5, list.size() - 6);      // List<...>
    }
    if (tokens[0] != word("uniform"))
    {
        return word();
    }
    switch (tokens.size())
    {
        case 2: return tokens[1].isNumber() ? "scalar" : "";
        case 6: return "vector";
        case 9: return "symmTensor";
        case 12: return "tensor";
        case 4: return "sphericalTensor";
        default: return word();
    }
}

} // End namespace fsbi
} // End namespace Foam


Foam::autoPtr<Foam::fsbi::joinedList> Foam::fsbi::joinedList::fromEntries
(
    const UPtrList<const dictionary>& parts,
    const word& keyword,
    const UList<labelList>& places
)
{
    word type;
    for (const dictionary& dict : parts)
    {
        type = type.empty() ? typeOf(dict, keyword) : type;
    }
    if (type == "scalar")
    {
        return joinEntries<scalar>(parts, keyword, places);
    }
    if (type == "vector")
    {
        return joinEntries<vector>(parts, keyword, places);
    }
    if (type == "symmTensor")
    {
        return joinEntries<symmTensor>(parts, keyword, places);
    }
    if (type == "tensor")
    {
        return joinEntries<tensor>(parts, keyword, places);
    }
    if (type == "sphericalTensor")
    {
        return joinEntries<sphericalTensor>(parts, keyword, places);
    }
    return nullptr;
}


Foam::autoPtr<Foam::fsbi::joinedList> Foam::fsbi::joinedList::fromFiles
(
    UPtrList<Istream>& parts,
    const word& fieldClass,
    const UList<labelList>& places,
    const fileName& file
)
{
    if (fieldClass == "scalarField")
    {
        return joinFiles<scalar>(parts, places, file);
    }
    if (fieldClass == "vectorField")
    {
        return joinFiles<vector>(parts, places, file);
    }
    if (fieldClass == "tensorField")
    {
        return joinFiles<tensor>(parts, places, file);
    }
    FatalErrorInFunction
        << file << " is of class " << fieldClass << ", which cannot be"
        << " distributed; those that can are scalarField, vectorField and"
        << " tensorField" << exit(FatalError);
    return nullptr;
}
