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
    const auto appoint = [&](const label site, const scalar time)
    {
        waitingTime& c = waitingTimeOf(site);
        if (c.left < 0)
        {
            c.left = -std::log(draws(site, c.events).uniform());
        }
        const scalar k = rate(site);
        // compared before division, for the quotient may overflow
        if (c.left < k*(dt - time))
        {
            events.push({time + c.left/k, site});
        }
        else
        {
            c.left -= k*(dt - time);
        }
    };

    for (label site = 0; site < size(); ++site)
    {
        appoint(site, 0);
    }
    while (!events.empty())
    {
        const appointment next(events.top());
        events.pop();
        waitingTime& c = waitingTimeOf(next.site);
        counterRandom::stream numbers(draws(next.site, c.events));
        numbers.uniform();      // the waiting time's own
        react(next.site, next.time, numbers);
        ++c.events;
        c.left = -1;
        appoint(next.site, next.time);
    }
}
