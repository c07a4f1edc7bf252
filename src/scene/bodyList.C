/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bodyList.H"
#include "HashSet.H"
#include "IOdictionary.H"
#include "Time.H"

namespace Foam
{
namespace fsbi
{

//- Fatal if the bodies are not those of the saved state
static void checkSaved(const dictionary& dict, const dictionary& saved)
{
    wordHashSet now(dict.toc());
    now.erase("FoamFile");
    const wordHashSet then(saved.subOrEmptyDict("bodies").toc());
    if (saved.size() && now != then)
    {
        FatalIOErrorInFunction(dict)
            << "The bodies are no longer those of the saved state, which are "
            << flatOutput(then.sortedToc()) << ". Put them back, or start a"
            << " new run at time 0" << exit(FatalIOError);
    }
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::bodyList::bodyList
(
    const Time& time,
    timings& t,
    const bool inFluid,
    const dictionary& saved
)
{
    const IOdictionary dict
    (
        IOobject
        (
            "bodies", time.caseConstant(), time, IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE, false
        )
    );
    checkSaved(dict, saved);
    entries_ = dict;
    read(dict, time, t, inFluid, saved.subOrEmptyDict("bodies"));
    if (inFluid)
    {
        immerse();
    }
}


void Foam::fsbi::bodyList::read
(
    const dictionary& dict,
    const Time& time,
    timings& t,
    const bool inFluid,
    const dictionary& saved
)
{
    const bool alone = dict.size() - dict.found("FoamFile") == 1 && !inFluid;
    for (const entry& e : dict)
    {
        if (e.keyword() == "FoamFile")
        {
            continue;
        }
        if (!e.isDict())
        {
            FatalIOErrorInFunction(dict)
                << "Entry '" << e.keyword() << "' is no dictionary: a body is"
                << " name { type rigidBody; shape {...} position (...); ... }"
                << exit(FatalIOError);
        }
        all_.append
        (
            body::New
            (
                {time, t, e.keyword(), alone, inFluid}, e.dict(),
                saved.subOrEmptyDict(e.keyword())
            )
        );
        sort(all_.last());
    }
}


Foam::label Foam::fsbi::bodyList::place(const word& name) const
{
    label n = 0;
    while (all_[n].name() != name)
    {
        ++n;
    }
    return n;
}


void Foam::fsbi::bodyList::sort(body& any)
{
    if (auto* unknownVelocity = dynamic_cast<rigidBody*>(&any))
    {
        rigid.append(unknownVelocity);
    }
    else if (auto* unknownDisplacement = dynamic_cast<solidRegion*>(&any))
    {
        elastic.append(unknownDisplacement);
    }
    else if (auto* given = dynamic_cast<prescribedBody*>(&any))
    {
        prescribed.append(given);
    }
    else
    {
        FatalErrorInFunction
            << "Type '" << any.type() << "' of body '" << any.name()
            << "' is derived neither from rigidBody, solidRegion nor"
            << " prescribedBody: nobody would solve for it"
            << exit(FatalError);
    }
}


void Foam::fsbi::bodyList::immerse()
{
    for (rigidBody& body : rigid)
    {
        immersed.append(&body);
        moving.append(&body);
    }
    for (solidRegion& body : elastic)
    {
        immersed.append(&body.surface());
        moving.append(&body);
    }
    for (prescribedBody& body : prescribed)
    {
        immersed.append(&body);
        moving.append(&body);
    }
}
