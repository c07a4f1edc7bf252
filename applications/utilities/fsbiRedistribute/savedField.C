/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "savedField.H"
#include "OStringStream.H"

namespace Foam
{

static string textOf(const dictionary& dict, const word& key)
{
    OStringStream os;
    os.precision(17);
    const entry* e = dict.findEntry(key, keyType::LITERAL);
    if (e)
    {
        os << *e;
    }
    return os.str();
}

} // End namespace Foam


bool Foam::fsbi::savedField::isField(const word& fieldClass)
{
    for (const string type : {"Scalar", "Vector", "SymmTensor", "Tensor"})
    {
        if
        (
            fieldClass == "vol" + type + "Field"
         || fieldClass == "point" + type + "Field"
        )
        {
            return true;
        }
    }
    return false;
}


Foam::fsbi::savedField::savedField
(
    UPtrList<Istream>& files,
    const word& fieldClass,
    const meshParts& mesh,
    const fileName& file
)
:
    file_(file),
    ofCells_(fieldClass.compare(0, 3, "vol") == 0),
    dimensions_(dimless),
    patches_(mesh.whole.patchNames.size()),
    lists_(patches_.size())
{
    PtrList<dictionary> dicts;
    UPtrList<const dictionary> parts, boundaries;
    List<labelList> places;
    forAll(files, p)
    {
        dicts.append(new dictionary(files[p]));
        parts.append(&dicts[p]);
        boundaries.append(&dicts[p].subDict("boundaryField"));
        const meshPart& part = mesh.parts[p];
        places.append(ofCells_ ? part.cellPlaces : part.pointPlaces);
    }
    internal_ = joinedList::fromEntries(parts, "internalField", places);
    if (!internal_)
    {
        FatalErrorInFunction
            << "The internalField of " << file_ << " cannot be read"
            << exit(FatalError);
    }
    dicts[0].readEntry("dimensions", dimensions_);
    forAll(patches_, patchi)
    {
        readPatch(patchi, boundaries, mesh);
    }
}


void Foam::fsbi::savedField::readPatch
(
    const label patchi,
    const UPtrList<const dictionary>& parts,
    const meshParts& mesh
)
{
    const word& name = mesh.whole.patchNames[patchi];
    UPtrList<const dictionary> dicts;
    List<labelList> places;
    forAll(parts, p)
    {
        dicts.append(&parts[p].subDict(name));
        places.append(mesh.parts[p].patchPlaces[patchi]);
    }
    patches_[patchi] = dicts[0];
    for (const word& key : dicts[0].toc())
    {
        autoPtr<joinedList> list
        (
            ofCells_
          ? joinedList::fromEntries(dicts, key, places)
          : autoPtr<joinedList>()
        );
        if (list)
        {
            lists_[patchi].set(key, std::shared_ptr<joinedList>(list.release()));
            continue;
        }
        for (const dictionary& dict : dicts)
        {
            if (textOf(dict, key) != textOf(dicts[0], key))
            {
                FatalErrorInFunction
                    << "Entry '" << key << "' of patch " << name << " of "
                    << file_ << " is not the same on all processors and no"
                    << " list of the patch's faces: it cannot be distributed"
                    << exit(FatalError);
            }
        }
    }
}


void Foam::fsbi::savedField::writePatch
(
    const label patchi, const meshPart& part, Ostream& os
) const
{
    os.beginBlock(part.mesh.patchNames[patchi]);
    const labelList& places = part.patchPlaces[patchi];
    if (!part.isPhysical(patchi))
    {
        os.writeEntry("type", "processor");
        if (ofCells_)
        {
            internal_->writeEntry("value", places, os);
        }
        os.endBlock();
        return;
    }
    for (const entry& e : patches_[patchi])
    {
        const auto list = lists_[patchi].cfind(e.keyword());
        if (list.found())
        {
            (*list)->writeEntry(e.keyword(), places, os);
        }
        else
        {
            os << e;
        }
    }
    os.endBlock();
}


void Foam::fsbi::savedField::write(const meshPart& part, Ostream& os) const
{
    os.writeEntry("dimensions", dimensions_);
    os << nl << nl;
    internal_->writeEntry
    (
        "internalField", ofCells_ ? part.cellPlaces : part.pointPlaces, os
    );
    os << nl;
    os.beginBlock("boundaryField");
    forAll(part.mesh.patchNames, patchi)
    {
        writePatch(patchi, part, os);
    }
    os.endBlock();
}
