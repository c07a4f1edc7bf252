/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "savedRegion.H"
#include "savedField.H"
#include "checkpoint.H"
#include "regionMesh.H"
#include "pointIOField.H"
#include "IFstream.H"
#include "regIOobject.H"
#include "OSspecific.H"
#include <memory>

namespace Foam
{
namespace fsbi
{

//- Text or numbers that are written again as they are
class copiedObject
:
    public regIOobject
{
public:

    const word type_;
    const std::function<void(Ostream&)> write_;

    copiedObject
    (
        const IOobject& io,
        const word& type,
        const std::function<void(Ostream&)>& write
    )
    :
        regIOobject(io),
        type_(type),
        write_(write)
    {}

    const word& type() const override { return type_; }

    bool writeData(Ostream& os) const override
    {
        write_(os);
        return os.good();
    }
};

static const fileName meshFolder(polyMesh::meshSubDir);

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::savedRegion::savedRegion
(
    const Time& time,
    const word& name,
    const fileNameList& folders,
    const label number
)
:
    time_(time),
    name_(name),
    folders_(folders)
{
    readMesh();
    for (const fileName& file : stateFolder::files(folders_[0]))
    {
        if (file.components()[0] == name_ && file.path() != name_/meshFolder)
        {
            readFile(file);
        }
    }
    target_.reset
    (
        new meshParts
        (
            source_->whole,
            reference_.size() ? reference_ : source_->whole.points, number
        )
    );
}


Foam::autoPtr<Foam::fsbi::meshPart> Foam::fsbi::savedRegion::readPart
(
    const label parti, pointField& reference
) const
{
    // a case of its own, as the parts of a mesh have the same name
    const fileName path(folders_[parti].path());
    Time time(Time::controlDictName, path.path(), fileName(path.name()));
    time.setTime(time_);
    const polyMesh mesh
    (
        IOobject(name_, time.timeName(), time, IOobject::MUST_READ)
    );
    auto part = autoPtr<meshPart>::New();
    part->mesh = wholeMesh::lists(mesh);
    IOobject io
    (
        "referencePoints", time.timeName(), meshFolder, mesh,
        IOobject::MUST_READ, IOobject::NO_WRITE, false
    );
    if (isFile(io.objectPath()))
    {
        reference = pointIOField(io);
    }
    if (folders_.size() == 1)
    {
        part->cells = identity(mesh.nCells());
        part->faces = identity(mesh.nFaces());
        part->points = identity(mesh.nPoints());
        return part;
    }
    labelList* lists[] = {&part->cells, &part->faces, &part->points};
    const wordList names({"wholeCells", "wholeFaces", "wholePoints"});
    forAll(names, i)
    {
        io.rename(names[i]);
        if (!isFile(io.objectPath()))
        {
            FatalErrorInFunction
                << io.objectPath() << " is missing: the mesh of region "
                << name_ << " does not know its place in the whole. It was"
                << " saved by an older version, or decomposed without"
                << " addressing. Continue it on " << folders_.size()
                << " processes until the next mesh is made, or start anew"
                << exit(FatalError);
        }
        *lists[i] = labelIOList(io);
    }
    return part;
}


void Foam::fsbi::savedRegion::readMesh()
{
    PtrList<meshPart> parts;
    List<pointField> references(folders_.size());
    forAll(folders_, p)
    {
        parts.append(readPart(p, references[p]).ptr());
    }
    source_.reset(new meshParts(std::move(parts), name_));
    if (references[0].empty())
    {
        return;
    }
    reference_.setSize(source_->whole.points.size());
    forAll(references, p)
    {
        UIndirectList<point>(reference_, source_->parts[p].points) =
            references[p];
    }
}


Foam::autoPtr<Foam::Istream> Foam::fsbi::savedRegion::open
(
    const label parti, const fileName& file, word& type
) const
{
    auto is = autoPtr<Istream>(new IFstream(folders_[parti]/file));
    IOobject io(file.name(), time_.timeName(), time_);
    io.readHeader(is());
    type = io.headerClassName();
    return is;
}


void Foam::fsbi::savedRegion::readFile(const fileName& file)
{
    PtrList<Istream> parts;
    UPtrList<Istream> streams;
    savedFile saved;
    forAll(folders_, p)
    {
        parts.append(open(p, file, saved.type).ptr());
        streams.append(&parts[p]);
    }
    saved.name = file.name();
    saved.local = file.path() == name_ ? fileName() : fileName(file.components()[1]);
    if (savedField::isField(saved.type))
    {
        const auto field = std::make_shared<savedField>
        (
            streams, saved.type, source_(), file
        );
        saved.write = [field](const meshPart& part, Ostream& os)
        {
            field->write(part, os);
        };
    }
    else if (saved.local == "state" && saved.name.compare(0, 8, "surface.") == 0)
    {
        readCopy(saved, file);
    }
    else
    {
        readList(saved, streams, file);
    }
    files_.append(saved);
}


Foam::fsbi::savedRegion::placesOfPart Foam::fsbi::savedRegion::placesOf
(
    const fileName& file
) const
{
    const word name(file.name());
    if (file.path() == name_/"state")
    {
        if (name == "solution" || name == "increment")
        {
            return
                hasPressures(file)
              ? &meshPart::mixedPlaces
              : &meshPart::unknownPlaces;
        }
        if (name == "faceForce")
        {
            return &meshPart::boundaryPlaces;
        }
        if
        (
            name == "referenceF" || name == "oldF" || name == "olderF"
        )
        {
            return &meshPart::pointPlaces;
        }
        if (name == "jumpHistory")
        {
            return &meshPart::facePlaces;
        }
        if (name.compare(0, 7, "motion.") == 0)
        {
            return &meshPart::cellPlaces;
        }
    }
    FatalErrorInFunction
        << "It is not known what the numbers of " << file << " are of: cells,"
        << " faces or points. The state cannot be distributed"
        << exit(FatalError);
    return nullptr;
}


bool Foam::fsbi::savedRegion::hasPressures(const fileName& file) const
{
    label size = 0, displacements = 0;
    forAll(folders_, p)
    {
        word type;
        label n;
        open(p, file, type)() >> n;
        size += n;
        displacements += source_->parts[p].unknownPlaces.size();
    }
    if (size != displacements && size != displacements + source_->whole.points.size())
    {
        FatalErrorInFunction
            << "Body '" << name_ << "' has parts of other materials, whose"
            << " state cannot be distributed: continue on as many processors as"
            << " it was saved on" << exit(FatalError);
    }
    return size != displacements;
}


void Foam::fsbi::savedRegion::readList
(
    savedFile& file, UPtrList<Istream>& parts, const fileName& name
)
{
    const placesOfPart ofPart = placesOf(name);
    List<labelList> places;
    for (const meshPart& part : source_->parts)
    {
        places.append(part.*ofPart);
    }
    const std::shared_ptr<joinedList> list
    (
        joinedList::fromFiles(parts, file.type, places, name).release()
    );
    file.write = [list, ofPart](const meshPart& part, Ostream& os)
    {
        list->writeList(part.*ofPart, os);
    };
}


void Foam::fsbi::savedRegion::readCopy
(
    savedFile& file, const fileName& name
)
{
    word type;
    const auto values = std::make_shared<vectorField>
    (
        open(0, name, type)()
    );
    file.write = [values](const meshPart&, Ostream& os) { os << *values; };
}


void Foam::fsbi::savedRegion::write
(
    const label parti, stateFolder& folder
) const
{
    const meshPart& part = target_->parts[parti];
    autoPtr<fvMesh> mesh
    (
        part.mesh.makeMesh
        (
            IOobject(name_, time_.timeName(), time_, IOobject::NO_READ)
        )
    );
    if (target_->parts.size() > 1)
    {
        setNumbers(mesh(), part.cells, part.faces, part.points);
    }
    const auto add = [&](const regIOobject& object)
    {
        checkpoint::add(time_, folder, object);
    };
    fsbi::writeMesh(mesh(), mesh->points(), add);
    if (reference_.size())
    {
        add
        (
            pointIOField
            (
                IOobject
                (
                    "referencePoints", time_.timeName(), meshFolder, mesh(),
                    IOobject::NO_READ, IOobject::NO_WRITE, false
                ),
                pointField(reference_, part.points)
            )
        );
    }
    for (const savedFile& file : files_)
    {
        add
        (
            copiedObject
            (
                IOobject
                (
                    file.name, time_.timeName(), file.local, mesh(),
                    IOobject::NO_READ, IOobject::NO_WRITE, false
                ),
                file.type,
                [&](Ostream& os) { file.write(part, os); }
            )
        );
    }
}
