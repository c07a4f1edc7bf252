/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bonds.H"

void Foam::fsbi::bonds::declare(recording& history) const
{
    for (const bondPair& pair : adhesion_->pairs())
    {
        history.declare
        (
            "bonds/" + pair.name,
            {"number", "formed", "broken", "tension", "fx", "fy", "fz"},
            "tension: sum over bonds; f: force on the receptors' bodies"
        );
    }
    history.declare
    (
        "bonds/events",
        {
            "instant", "pair", "set", "site", "formed", "length", "tension",
            "ax", "ay", "az", "bx", "by", "bz"
        },
        "pair in the order of the dictionary; a: end at the receptor"
    );
}


void Foam::fsbi::bonds::record(recording& history) const
{
    List<scalarList> sums(adhesion_->pairs().size(), scalarList(7, Zero));
    for (const bondEvent& e : events_)
    {
        sums[e.pair][e.formed ? 1 : 2] += 1;
        history.append
        (
            "bonds/events",
            scalarList
            ({
                e.time, scalar(e.pair), scalar(e.set), scalar(e.site),
                scalar(e.formed), e.length, e.force,
                e.a.x(), e.a.y(), e.a.z(), e.b.x(), e.b.y(), e.b.z()
            })
        );
    }
    const surfacesNow now(around_);
    for (const auto& entry : state_.bonds)
    {
        const bond& b = entry.second;
        const bondPair& pair = adhesion_->pairs()[b.pair];
        const adhesion::siteSet& s = adhesion_->sets()[entry.first.first];
        const point x(now.position(s.body, s.sites[entry.first.second]));
        const point y(end(now, b));
        const scalar f = pair.law->force(pair.length(x, y));
        const vector force(f*(y - x)/max(mag(y - x), VSMALL));
        scalarList& sum = sums[b.pair];
        sum[0] += 1;
        sum[3] += f;
        for (direction d = 0; d < 3; ++d)
        {
            sum[4 + d] += force[d];
        }
    }
    forAll(sums, i)
    {
        history.append("bonds/" + adhesion_->pairs()[i].name, sums[i]);
    }
}
