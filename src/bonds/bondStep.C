/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bondStep.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::bondStep::bondStep
(
    const adhesion& a,
    const currentSurfaces& surfaces,
    bondState& state,
    DynamicList<bondEvent>& events,
    const scalar time
)
:
    adhesion_(a),
    surfaces_(surfaces),
    state_(state),
    events_(events),
    time_(time),
    free_(a, surfaces, state.slid, time)
{
    for (const auto& b : state.bonds)
    {
        free_.take(receptor(activate(b.first.first, b.first.second)));
        free_.take(b.second.ligand);
    }
    forAll(a.sets(), set)
    {
        for (const adhesion::target& t : a.sets()[set].targets)
        {
            if (!present(set, t))
            {
                continue;
            }
            if (a.sets()[set].faces)
            {
                findFaces(set, t);
            }
            else
            {
                findMolecules(set, t);
            }
        }
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::fsbi::bondStep::activeSite& Foam::fsbi::bondStep::activate
(
    const label set, const label site
)
{
    const auto inserted = number_.insert({{set, site}, active_.size()});
    if (inserted.second)
    {
        const adhesion::siteSet& s = adhesion_.sets()[set];
        active_.append
        (
            activeSite
            {
                set, site, surfaces_.position(s.body, s.sites[site]), {}
            }
        );
    }
    return active_[inserted.first->second];
}


bool Foam::fsbi::bondStep::present
(
    const label set, const adhesion::target& t
) const
{
    return
        surfaces_.present(adhesion_.sets()[set].body)
     && surfaces_.present(adhesion_.populations()[t.ligands].surface);
}


void Foam::fsbi::bondStep::findMolecules
(
    const label set, const adhesion::target& t
)
{
    const adhesion::siteSet& s = adhesion_.sets()[set];
    const bondPair& pair = adhesion_.pairs()[t.pair];
    const label other = adhesion_.populations()[t.ligands].surface;
    const scalar density = free_.density(t.ligands);

    // all molecules in reach count, whether or not they can bind
    scalar gap = GREAT, sum = 0;
    DynamicList<label> found;
    candidate channel{t.pair, t.ligands, 0, {}, -1};
    forAll(s.sites, site)
    {
        const point x(surfaces_.position(s.body, s.sites[site]));
        if (surfaces_.find(other, x, pair.rate->reach(), channel.at))
        {
            channel.rate = density*pair.rate()(channel.at.gap);
            sum += channel.rate;
            gap = min(gap, channel.at.gap);
            if (offer(set, site, channel))
            {
                found.append(number_[{set, site}]);
            }
        }
    }
    if (pair.faceCorrection != "none" && found.size())
    {
        const scalar scale = globalRate(t, gap)*s.sites.size()/sum;
        for (const label i : found)
        {
            active_[i].channels.last().rate *= scale;
        }
    }
}


bool Foam::fsbi::bondStep::offer
(
    const label set, const label site, const candidate& channel
)
{
    const bool can = channel.rate > 0
     && free_.unblocked
        (
            {adhesion_.sets()[set].receptors, site, 0},
            surfaces_.position
            (
                adhesion_.sets()[set].body, adhesion_.sets()[set].sites[site]
            )
        );
    if (can)
    {
        activate(set, site).channels.append(channel);
    }
    return can;
}


Foam::fsbi::bond Foam::fsbi::bondStep::form
(
    const activeSite& s,
    const candidate& channel,
    counterRandom::stream& draws
)
{
    const adhesion::population& ligands =
        adhesion_.populations()[channel.ligands];
    bond b;
    b.pair = channel.pair;
    if (adhesion_.sets()[s.set].faces)
    {
        const label n = ligands.numbers[channel.triangle];
        const label i = min(label(draws.uniform()*n), n - 1);
        b.end = materialPoint::centroid(channel.triangle);
        b.ligand = {channel.ligands, ligands.first[channel.triangle] + i, 0};
        return b;
    }

    const scalar r =
        adhesion_.pairs()[channel.pair].rate->distance
        (
            channel.at.gap, draws.uniform()
        );
    const scalar angle = constant::mathematical::twoPi*draws.uniform();
    const vector& n = channel.at.normal;
    const vector e1(currentSurfaces::along(n));
    const vector along(Foam::cos(angle)*e1 + Foam::sin(angle)*(n ^ e1));

    b.ligand.population = channel.ligands;
    if (surfaces_.isPlane(ligands.surface))
    {
        b.anchor = channel.at.nearest
          + Foam::sqrt(max(sqr(r) - sqr(channel.at.gap), scalar(0)))*along;
    }
    else
    {
        b.end =
            surfaces_.away(ligands.surface, s.place, channel.at, along, r);
    }
    b.ligand = free_.at(channel.ligands, end(adhesion_, surfaces_, b));
    return b;
}


void Foam::fsbi::bondStep::log
(
    const activeSite& s, const bond& b, const scalar time, const bool formed
)
{
    const bondPair& pair = adhesion_.pairs()[b.pair];
    const point y(end(s, b));
    const scalar length = pair.length(s.place, y);
    const vector& image = surfaces_.toImage(adhesion_.sets()[s.set].body);
    events_.append
    (
        bondEvent
        {
            time_ + time, b.pair, s.set, s.site, formed, length,
            pair.law->force(length), s.place - image, y - image
        }
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::point Foam::fsbi::bondStep::end
(
    const adhesion& a, const currentSurfaces& surfaces, const bond& b
)
{
    const label surface = a.surface(b.ligand);
    return
        surfaces.isPlane(surface)
      ? b.anchor : surfaces.position(surface, b.end);
}


const Foam::DynamicList<Foam::fsbi::bondStep::candidate>*
Foam::fsbi::bondStep::candidates(const label set, const label site) const
{
    const auto found = number_.find({set, site});
    return
        found == number_.end() ? nullptr : &active_[found->second].channels;
}


Foam::fsbi::reactingSites::waitingTime& Foam::fsbi::bondStep::waitingTimeOf
(
    const label i
)
{
    return state_.waitingTimes[{active_[i].set, active_[i].site}];
}


Foam::fsbi::counterRandom::stream Foam::fsbi::bondStep::draws
(
    const label i, const label event
) const
{
    return adhesion_.sets()[active_[i].set].events.at(event, active_[i].site);
}


Foam::scalar Foam::fsbi::bondStep::rate(const label i) const
{
    const activeSite& s = active_[i];
    const auto bound = find(s);
    if (bound != state_.bonds.end())
    {
        const bondPair& pair = adhesion_.pairs()[bound->second.pair];
        return pair.law->kOff
        (
            pair.length(s.place, end(s, bound->second))
        );
    }
    scalar sum = 0;
    for (const candidate& channel : s.channels)
    {
        sum += channel.rate;
    }
    return sum;
}


void Foam::fsbi::bondStep::react
(
    const label i, const scalar time, counterRandom::stream& draws
)
{
    const activeSite& s = active_[i];
    const auto bound = find(s);
    if (bound != state_.bonds.end())
    {
        log(s, bound->second, time, false);
        free_.release(receptor(s));
        free_.release(bound->second.ligand);
        state_.bonds.erase(bound);
        return;
    }

    scalar share = draws.uniform()*rate(i);
    label w = 0;
    for (; w < s.channels.size() - 1 && share > s.channels[w].rate; ++w)
    {
        share -= s.channels[w].rate;
    }
    const bond b(form(s, s.channels[w], draws));
    // molecules that are not free are still counted in the rate: they say no
    if (free_.free(receptor(s), s.place) && free_.free(b.ligand, end(s, b)))
    {
        free_.take(receptor(s));
        free_.take(b.ligand);
        log(s, b, time, true);
        state_.bonds.insert({{s.set, s.site}, b});
    }
}
