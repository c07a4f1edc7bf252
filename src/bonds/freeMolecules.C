/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "freeMolecules.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::freeMolecules::freeMolecules
(
    const adhesion& a,
    const currentSurfaces& surfaces,
    const UList<vector>& slid,
    const scalar time
)
:
    adhesion_(a),
    surfaces_(surfaces),
    slid_(slid),
    blocked_(a.populations().size()),
    places_(a.populations().size()),
    sites_(a.populations().size())
{
    forAll(blocked_, i)
    {
        blocked_[i] = a.populations()[i].blockedAt(time);
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::fsbi::freeMolecules::blocked
(
    const label population, const point& x
)
{
    const occupiedSites* sites = adhesion_.populations()[population].occupied;
    if (!sites)
    {
        return blocked_[population];
    }
    if (sites->places.empty())
    {
        return 0;
    }
    if (!sites_.set(population))
    {
        sites_.set(population, new pointSearch(sites->places));
    }
    return sites->parts[sites_[population].nearest(x)];
}


const Foam::fsbi::pointSearch& Foam::fsbi::freeMolecules::placesOf
(
    const label population
)
{
    if (!places_.set(population))
    {
        const adhesion::population& p = adhesion_.populations()[population];
        pointField points(p.molecules.size());
        forAll(p.molecules, i)
        {
            points[i] = surfaces_.position(p.surface, p.molecules[i]);
        }
        places_.set(population, new pointSearch(points));
    }
    return places_[population];
}


Foam::fsbi::molecule Foam::fsbi::freeMolecules::patch
(
    const label population, const point& x
) const
{
    const adhesion::population& p = adhesion_.populations()[population];
    const domainWall& wall = surfaces_.wall(p.surface);
    const vector e1(surfaces_.alongPeriod(wall.normal));
    const vector e2(wall.normal ^ e1);
    const vector d(x - slid_[p.surface]);

    counterRandom::stream offset(p.places.at(0, 0));
    offset.uniform();       // is of adhesion::population::unblocked()
    const scalar perLength = Foam::sqrt(p.density);
    const auto number = [&](const vector& e)
    {
        // as many as fit between a place and its image, which are the same
        const scalar period = surfaces_.period(e);
        const label n = max(label(1), label(std::round(period*perLength)));
        const scalar at =
            (d & e)*(period > 0 ? n/period : perLength) + offset.uniform();
        const label i = std::floor(at);
        return period > 0 ? ((i % n) + n) % n : i;
    };
    const label i = number(e1);
    return {population, i, number(e2)};
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsbi::freeMolecules::density(const label population) const
{
    const adhesion::population& p = adhesion_.populations()[population];
    return
        surfaces_.isPlane(p.surface)
      ? p.density
      : p.molecules.size()/surfaces_.surface(p.surface).area();
}


Foam::fsbi::molecule Foam::fsbi::freeMolecules::at
(
    const label population, const point& x
)
{
    if (surfaces_.isPlane(adhesion_.populations()[population].surface))
    {
        return patch(population, x);
    }
    return {population, placesOf(population).nearest(x), 0};
}
