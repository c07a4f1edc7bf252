/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "adhesion.H"
#include "FlatOutput.H"
#include "timeFunction.H"

namespace Foam
{
namespace fsbi
{

//- Molecules on a wall that is not plane would go along with the domain
static void refuseFollowing
(
    const adhesion::population& p, const currentSurfaces& surfaces
)
{
    if (surfaces.isWall(p.surface) && surfaces.wall(p.surface).follows)
    {
        FatalIOErrorInFunction(p.entries)
            << "Molecules cannot be on the wall '" << surfaces.name(p.surface)
            << "', which is not plane, where the domain follows a body: remove"
            << " 'follow' from system/remeshDict, and make the domain as long as"
            << " the body's way" << exit(FatalIOError);
    }
}

} // End namespace fsbi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::adhesion::adhesion
(
    const dictionary& molecules,
    const dictionary& pairs,
    const effectContext& context,
    const scalar kT,
    const uint32_t seed
)
{
    readPopulations(molecules, context, seed);
    const currentSurfaces surfaces(context);
    for (population& p : populations_)
    {
        if (!surfaces.isPlane(p.surface))
        {
            refuseFollowing(p, surfaces);
            const bodySurface& there = surfaces.surface(p.surface);
            p.spread
            (
                materialPoint::numbers
                (
                    p.density, p.places, there.points(), there.triangles()
                )
            );
        }
    }
    for (const entry& e : pairs)
    {
        if (!e.isDict())
        {
            FatalIOErrorInFunction(pairs)
                << "Entry '" << e.keyword() << "' is no dictionary: a pair is"
                << " name { kinds (A B); law ...; }" << exit(FatalIOError);
        }
        pairs_.append(new bondPair(e.keyword(), e.dict(), kT));
        addSets(pairs_.size() - 1, e.dict(), surfaces, seed);
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsbi::adhesion::readPopulations
(
    const dictionary& dict, const effectContext& context, const uint32_t seed
)
{
    const checkedDictionary surfaces(dict);
    const wordList names(context.names());
    for (const entry& e : dict)
    {
        if (!names.found(e.keyword()))
        {
            FatalIOErrorInFunction(dict)
                << "There is no body (constant/bodies) or wall '"
                << e.keyword() << "' for 'molecules'"
                << context.unseenReason(e.keyword()).c_str() << "; valid are "
                << flatOutput(names) << exit(FatalIOError);
        }
    }
    forAll(names, surface)
    {
        if (!surfaces.found(names[surface]))
        {
            continue;
        }
        const checkedDictionary kinds(surfaces.subDict(names[surface]));
        for (const entry& e : kinds.dict())
        {
            const checkedDictionary entries(kinds.subDict(e.keyword()));
            const std::string name(names[surface] + "/" + e.keyword());
            autoPtr<population> p
            (
                new population
                {
                    surface, e.keyword(), e.dict(), entries.positive("density"),
                    counterRandom(seed, name + "/places"), nullptr, nullptr,
                    {}, {}, {}
                }
            );
            p->readBlocked(entries, context);
            entries.finish();
            p->blockedAt(context.time.value());
            populations_.append(p.ptr());
        }
    }
}


void Foam::fsbi::adhesion::checkKinds
(
    const bondPair& pair, const dictionary& dict
) const
{
    wordHashSet known;
    for (const population& p : populations_)
    {
        known.insert(p.kind);
    }
    for (const word& kind : pair.kinds)
    {
        if (!known.found(kind))
        {
            FatalIOErrorInFunction(dict)
                << "There are no molecules '" << kind << "'; known kinds are "
                << flatOutput(known.sortedToc()) << exit(FatalIOError);
        }
    }
}


void Foam::fsbi::adhesion::placeSites(siteSet& s) const
{
    s.sites = populations_[s.receptors].molecules;
    if (s.faces)
    {
        for (materialPoint& site : s.sites)
        {
            site = materialPoint::centroid(site.triangle);
        }
    }
}


Foam::fsbi::adhesion::siteSet& Foam::fsbi::adhesion::set
(
    const label receptors,
    const bool faces,
    const currentSurfaces& surfaces,
    const uint32_t seed
)
{
    for (siteSet& s : sets_)
    {
        if (s.receptors == receptors && s.faces == faces)
        {
            return s;
        }
    }
    const population& p = populations_[receptors];
    const std::string name
    (
        surfaces.name(p.surface) + "/" + p.kind + (faces ? "/faces" : "")
    );
    sets_.append
    (
        new siteSet
        {
            receptors, p.surface, faces, counterRandom(seed, name + "/events"),
            {}, {}
        }
    );
    placeSites(sets_.last());
    return sets_.last();
}


void Foam::fsbi::adhesion::addSets
(
    const label pairi,
    const dictionary& dict,
    const currentSurfaces& surfaces,
    const uint32_t seed
)
{
    const bondPair& pair = pairs_[pairi];
    checkKinds(pair, dict);
    const bool alike = pair.kinds[0] == pair.kinds[1];
    bool some = false;
    forAll(populations_, i)
    {
        forAll(populations_, j)
        {
            const label a = populations_[i].surface;
            const label b = populations_[j].surface;
            if
            (
                populations_[i].kind != pair.kinds[0]
             || populations_[j].kind != pair.kinds[1]
             || a == b || (alike && a > b)
             || (surfaces.isWall(a) && surfaces.isWall(b))
            )
            {
                continue;
            }
            if
            (
                (pair.faces || pair.faceCorrection != "none")
             && (surfaces.isWall(a) || surfaces.isWall(b))
            )
            {
                FatalIOErrorInFunction(dict)
                    << "The wall '"
                    << surfaces.name(surfaces.isWall(a) ? a : b)
                    << "' has no faces; 'sites' must be 'molecules', without"
                    << " 'faceCorrection'" << exit(FatalIOError);
            }
            // molecules of a wall are a density, never receptors
            const bool turned = surfaces.isWall(a);
            set(turned ? j : i, pair.faces, surfaces, seed)
                .targets.append(target{pairi, turned ? i : j});
            some = true;
        }
    }
    if (!some)
    {
        FatalIOErrorInFunction(dict)
            << "No two surfaces, one of them a body's, carry the molecules "
            << flatOutput(pair.kinds) << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsbi::adhesion::population::readBlocked
(
    const checkedDictionary& entries, const effectContext& context
)
{
    const word key("blocked");
    if (!entries.found(key))
    {
        return;
    }
    const entry* e = entries.dict().findEntry(key, keyType::LITERAL);
    const tokenList tokens(e->isStream() ? e->stream() : tokenList());
    const word species("species");
    if (tokens.empty() || !tokens[0].isWord() || tokens[0].wordToken() != species)
    {
        blocked = timeFunction<scalar>(key, entries);
        return;
    }
    if (tokens.size() != 2 || !tokens[1].isWord())
    {
        FatalIOErrorInFunction(entries.dict())
            << "Entry '" << key << "' on line " << e->startLineNumber()
            << " must be: " << key << " species NAME; the name is one of"
            << " constant/species" << exit(FatalIOError);
    }
    if (!context.occupied)
    {
        FatalIOErrorInFunction(entries.dict())
            << "Entry '" << key << "' names species '" << tokens[1].wordToken()
            << "', but nothing is dissolved: there is no file constant/species"
            << exit(FatalIOError);
    }
    occupied = &context.occupied
    (
        tokens[1].wordToken(), context.names()[surface], entries.dict()
    );
}


Foam::scalar Foam::fsbi::adhesion::population::blockedAt
(
    const scalar time
) const
{
    const scalar part = blocked.valid() ? blocked->value(time) : 0;
    if (!(part >= 0 && part <= 1))
    {
        FatalIOErrorInFunction(entries)
            << "Entry 'blocked' is the part of the molecules that cannot bind,"
            << " from 0 to 1, but is " << part << " at the time " << time
            << exit(FatalIOError);
    }
    return part;
}


void Foam::fsbi::adhesion::population::spread(const labelList& given)
{
    numbers = given;
    molecules = materialPoint::spread(numbers, places);
    first.setSize(numbers.size());
    label n = 0;
    forAll(numbers, triangle)
    {
        first[triangle] = n;
        n += numbers[triangle];
    }
}


bool Foam::fsbi::adhesion::holds
(
    const label set, const label site, const label pair, const label ligands
) const
{
    if (set >= sets_.size() || site >= sets_[set].sites.size())
    {
        return false;
    }
    for (const target& t : sets_[set].targets)
    {
        if (t.pair == pair && t.ligands == ligands)
        {
            return true;
        }
    }
    return false;
}


void Foam::fsbi::adhesion::save(dictionary& state) const
{
    forAll(populations_, i)
    {
        state.set(word("molecules" + Foam::name(i)), populations_[i].numbers);
    }
}


bool Foam::fsbi::adhesion::restore(const dictionary& state)
{
    // the areas of a body that has turned or deformed are not the same bits
    const auto key = [](const label i)
    {
        return word("molecules" + Foam::name(i));
    };
    bool fits = !state.found(key(populations_.size()));
    for (label i = 0; fits && i < populations_.size(); ++i)
    {
        labelList numbers;
        fits = state.readIfPresent(key(i), numbers)
         && numbers.size() == populations_[i].numbers.size();
        populations_[i].spread(numbers);
    }
    for (siteSet& s : sets_)
    {
        placeSites(s);
    }
    return fits;
}
