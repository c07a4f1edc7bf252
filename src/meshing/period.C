/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "period.H"

#include <cmath>

Foam::List<Foam::vector> Foam::fsbi::imagesOf(const UList<period>& periods)
{
    DynamicList<vector> sums({vector(Zero)});
    for (const period& p : periods)
    {
        const label n = sums.size();
        for (label i = 0; i < n; ++i)
        {
            const vector sum(sums[i]);
            sums.append(sum - p.translation);
            sums.append(sum + p.translation);
        }
    }
    return List<vector>(SubList<vector>(sums, sums.size() - 1, 1));
}


Foam::vector Foam::fsbi::intoCell
(
    const UList<period>& periods, const point& p, const vector& shift
)
{
    vector way(Zero);
    for (const period& along : periods)
    {
        way -=
            std::floor(along.from(p - shift)/along.length())*along.translation;
    }
    return way;
}
