/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "adhesion.H"
#include "FlatOutput.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::adhesion::adhesion
(
    const dictionary& molecules,
    const dictionary& pairs,
    const surroundings& around,
    const scalar kT,
    const uint32_t seed
)
{
    readPopulations(molecules, around);
    const surfacesNow surfaces(around);
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
    const dictionary& dict, const surroundings& around
)
{
    const checkedDictionary surfaces(dict);
    const wordList names(around.names());
    forAll(names, surface)
    {
        if (!surfaces.found(names[surface]))
        {
            continue;
        }
        for (const entry& e : surfaces.subDict(names[surface]))
        {
            const checkedDictionary entries(e.dict());
            autoPtr<population> p(new population);
            p->surface = surface;
            p->kind = e.keyword();
            p->density = entries.positive("density");
            if (entries.found("blocked"))
            {
                p->blocked = Function1<scalar>::New("blocked", e.dict());
                entries.found("blockedCoeffs");     // Function1's own
            }
            entries.finish();
            populations_.append(p.ptr());
        }
    }
    surfaces.finish();
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


Foam::fsbi::adhesion::siteSet& Foam::fsbi::adhesion::set
(
    const label receptors,
    const bool faces,
    const surfacesNow& surfaces,
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
            receptors, p.surface, faces, counterRandom(seed, name + "/places"),
            counterRandom(seed, name + "/events"), {}, {}, {}
        }
    );
    siteSet& s = sets_.last();
    const bodySurface& body = surfaces.surface(p.surface);
    if (faces)
    {
        forAll(body.triangles(), triangle)
        {
            s.sites.append(materialPoint::centroid(triangle));
        }
    }
    else
    {
        s.numbers = materialPoint::numbers
        (
            p.density, s.places, body.points(), body.triangles()
        );
        s.sites = materialPoint::spread(s.numbers, s.places);
    }
    return s;
}


void Foam::fsbi::adhesion::addSets
(
    const label pairi,
    const dictionary& dict,
    const surfacesNow& surfaces,
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

Foam::scalar Foam::fsbi::adhesion::population::blockedAt
(
    const scalar time
) const
{
    return
        blocked.valid()
      ? max(scalar(0), min(scalar(1), blocked->value(time))) : 0;
}


bool Foam::fsbi::adhesion::unblocked
(
    const label set, const label site, const scalar fraction
) const
{
    return
        fraction == 0
     || sets_[set].places.at(1, site).uniform() > fraction;
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
    forAll(sets_, i)
    {
        state.set(word("molecules" + Foam::name(i)), sets_[i].numbers);
    }
}


void Foam::fsbi::adhesion::restore(const dictionary& state)
{
    // the areas of a body that has turned or deformed are not the same bits
    forAll(sets_, i)
    {
        siteSet& s = sets_[i];
        if (!s.faces)
        {
            s.numbers = state.get<labelList>("molecules" + Foam::name(i));
            s.sites = materialPoint::spread(s.numbers, s.places);
        }
    }
}
