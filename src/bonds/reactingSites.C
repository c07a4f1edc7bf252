/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "reactingSites.H"

#include <cmath>
#include <queue>
#include <vector>

namespace
{
    using namespace Foam;

    //- The next event of a site
    struct appointment
    {
        scalar time;
        label site;
        fsbi::counterRandom::stream draws;

        //- Is this one later? Sites in their order if at the same time
        bool operator<(const appointment& other) const
        {
            return time > other.time
             || (time == other.time && site > other.site);
        }
    };
}

void Foam::fsbi::reactingSites::advance(const scalar dt)
{
    std::priority_queue<appointment> events;
    const auto appoint = [&](appointment event)
    {
        const scalar k = rate(event.site);
        if (k > 0)
        {
            const scalar wait = -std::log(event.draws.uniform());
            // compared before division, for the quotient may overflow
            if (wait < k*(dt - event.time))
            {
                event.time += wait/k;
                events.push(event);
            }
        }
    };

    for (label site = 0; site < size(); ++site)
    {
        appoint({0, site, draws(site)});
    }
    while (!events.empty())
    {
        appointment next(events.top());
        events.pop();
        react(next.site, next.time, next.draws);
        appoint(next);
    }
}
