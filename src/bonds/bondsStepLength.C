/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bonds.H"

Foam::scalar Foam::fsbi::bonds::longestStep(string& reason) const
{
    const currentSurfaces now(context_);
    const scalar stretch = stretchTime(now);
    scalar approach = GREAT;
    for (const adhesion::siteSet& s : adhesion_->sets())
    {
        for (const adhesion::target& t : s.targets)
        {
            approach = min(approach, approachTime(now, s, t));
        }
    }
    reason =
        stretch < approach
      ? "bonds stretch" : "surfaces that bind to each other approach";
    return min(stretch, approach);
}


Foam::scalar Foam::fsbi::bonds::stretchTime(const currentSurfaces& now) const
{
    scalar longest = GREAT;
    for (const auto& entry : state_.bonds)
    {
        const bond& b = entry.second;
        const bondPair& pair = adhesion_->pairs()[b.pair];
        const adhesion::siteSet& s = adhesion_->sets()[entry.first.first];
        const materialPoint& start = s.sites[entry.first.second];
        const label other = adhesion_->surface(b.ligand);

        const Pair<point> at(ends(now, entry));
        const vector d(at.second() - at.first());
        const vector v(now.velocity(other, b.end) - now.velocity(s.body, start));
        const scalar speed = mag(v & d)/max(mag(d), VSMALL);
        longest = min
        (
            longest,
            maxStretch_*pair.law->thermalLength()/max(speed, VSMALL)
        );
    }
    return longest;
}


Foam::scalar Foam::fsbi::bonds::approachTime
(
    const currentSurfaces& now,
    const adhesion::siteSet& s,
    const adhesion::target& t
) const
{
    const label other = adhesion_->populations()[t.ligands].surface;
    const bondPair& pair = adhesion_->pairs()[t.pair];
    const scalar reach = pair.rate->reach();
    const scalar allowed = maxStretch_*pair.law->thermalLength();

    // what the next step, of up to twice the length, may bring near
    const scalar margin = 2*context_.time.deltaTValue()
       *(now.fastest(s.body) + now.fastest(other));

    scalar longest = GREAT;
    currentSurfaces::nearestPoint at;
    for (const materialPoint& site : s.sites)
    {
        const point x(now.position(s.body, site));
        if (!now.present(s.body) || !now.find(other, x, reach + margin, at))
        {
            continue;
        }
        const vector v
        (
            now.velocity(s.body, site) - now.velocity(other, now.there(other, at))
        );
        const scalar closing = -(v & at.normal);
        if (closing > VSMALL)
        {
            // freely until the reach, then as far as one step may go
            longest = min
            (
                longest,
                (max(at.gap - reach, scalar(0)) + allowed)/closing
            );
        }
    }
    return longest;
}
