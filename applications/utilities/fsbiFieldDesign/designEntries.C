/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "designEntries.H"
#include "solidRegion.H"

Foam::IOdictionary Foam::fsbi::designEntries::read
(
    const word& name, const fileName& folder
) const
{
    return IOdictionary
    (
        IOobject
        (
            name, folder, time_, IOobject::MUST_READ, IOobject::NO_WRITE, false
        )
    );
}


const Foam::dictionary& Foam::fsbi::designEntries::named
(
    const dictionary& all, const word& name, const dictionary& where
)
{
    if (!all.isDict(name))
    {
        wordList valid(all.sortedToc());
        FatalIOErrorInFunction(where)
            << "There is no sub-dictionary '" << name << "' in " << all.name()
            << ", only " << flatOutput(valid) << exit(FatalIOError);
    }
    return all.subDict(name);
}


void Foam::fsbi::designEntries::readFields()
{
    const dictionary& all = checkedDictionary(magnetics_).subDict("fields");
    dictionary others(all);
    for (const entry& e : entries_.subDict("fields"))
    {
        if (!e.isDict())
        {
            FatalIOErrorInFunction(dict_.subDict("fields"))
                << "Entry '" << e.keyword() << "' is no dictionary: a field is"
                << " name {} or name { limit ...; }" << exit(FatalIOError);
        }
        driven_.append
        (
            new drivenField
            (
                e.keyword(), e.dict(),
                named(all, e.keyword(), dict_.subDict("fields")), units_
            )
        );
        others.remove(e.keyword());
    }
    if (driven_.empty())
    {
        FatalIOErrorInFunction(dict_)
            << "'fields' names no field of constant/effects, which has "
            << flatOutput(all.sortedToc()) << exit(FatalIOError);
    }
    given_.reset(new magneticFields(others, units_));
}


void Foam::fsbi::designEntries::checkBody() const
{
    const word type(named(bodies_, body_, dict_).get<word>("type"));
    const bool path = dict_.found("trajectory");
    if (dict_.found("tether") == path)
    {
        FatalIOErrorInFunction(dict_)
            << "Give one of 'tether' and 'trajectory'" << exit(FatalIOError);
    }
    if (type != "rigidBody" && type != "elasticBody")
    {
        FatalIOErrorInFunction(dict_)
            << "Body '" << body_ << "' is a " << type
            << ", whose motion is given: it needs no magnets"
            << exit(FatalIOError);
    }
    label bodies = 0;
    for (const entry& e : bodies_)
    {
        bodies += e.isDict() && e.keyword() != "FoamFile";
    }
    if (path && (elastic() || bodies > 1))
    {
        FatalIOErrorInFunction(dict_)
            << "A 'trajectory' is for a scene with one body, a rigidBody."
            << " Elsewhere let a run with 'constraints' or a 'tether' find the"
            << " load, and use 'tether'" << exit(FatalIOError);
    }
    const vector B(1, 2, 3);
    const tensor R(quaternion(vector(0, 0, 1), 1).R());
    if
    (
        elastic()
     && mag(law_->moment(1, R, B) - law_->moment(1, tensor::I, B))
      > 1e-9*mag(law_->moment(1, R, B))
    )
    {
        FatalIOErrorInFunction(lawEntries())
            << "The moment of '" << body_ << "' turns with the body, and the"
            << " history of an elastic body has no orientation"
            << exit(FatalIOError);
    }
}


Foam::fsbi::designEntries::designEntries(const Time& time)
:
    time_(time),
    dict_(read("fieldDesignDict", time.caseSystem())),
    effects_(read("effects", time.caseConstant())),
    bodies_(read("bodies", time.caseConstant())),
    entries_(dict_),
    magnetics_(named(effects_, "magnetics", effects_)),
    body_(entries_.get<word>("body")),
    units_(checkedDictionary(magnetics_)),
    law_
    (
        magnetisation::New
        (
            named(checkedDictionary(magnetics_).subDict("bodies"), body_, dict_)
        )
    ),
    bias_(entries_.getOrDefault<vector>("bias", Zero)),
    tolerance_(entries_.positive("tolerance", 1e-3)),
    report_
    (
        entries_.choice("unattainable", {"fatal", "report"}, "fatal")
     == "report"
    )
{
    for (const word key : {"FoamFile", "tether", "trajectory"})
    {
        entries_.found(key);
    }
    readFields();
    entries_.finish();
    checkBody();
}


Foam::scalar Foam::fsbi::designEntries::volume() const
{
    timings clocks;
    const scalar inCase =
        elastic()
      ? solidRegion
        (
            {time_, clocks, body_, false, true}, bodyDict(), dictionary::null
        ).surface().placedSurface().volume()
      : rigidBody(body_, bodyDict()).placedSurface().volume();
    return inCase/pow3(units_.metre());
}


Foam::fsbi::loadTrajectory Foam::fsbi::designEntries::wanted() const
{
    if (dict_.found("tether"))
    {
        return tetherTrajectory
        (
            entries_.subDict("tether"), body_, time_.globalPath(), elastic()
        );
    }
    return pathTrajectory
    (
        entries_.subDict("trajectory"), body_, bodyDict(), time_
    );
}
