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
    const surfacesNow& surfaces,
    bondMap& bonds,
    clockMap& clocks,
    DynamicList<bondEvent>& events,
    const scalar time
)
:
    adhesion_(a),
    surfaces_(surfaces),
    bonds_(bonds),
    clocks_(clocks),
    events_(events),
    time_(time)
{
    for (const auto& b : bonds_)
    {
        activate(b.first.first, b.first.second);
        if (a.pairs()[b.second.pair].faces)
        {
            taken_.insert({b.second.ligands, b.second.end.triangle});
        }
    }
    forAll(a.sets(), set)
    {
        for (const adhesion::target& t : a.sets()[set].targets)
        {
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


void Foam::fsbi::bondStep::findMolecules
(
    const label set, const adhesion::target& t
)
{
    const adhesion::siteSet& s = adhesion_.sets()[set];
    const adhesion::population& ligands = adhesion_.populations()[t.ligands];
    const contactRate& rate = adhesion_.pairs()[t.pair].rate();
    const scalar density = ligands.freeDensity(time_);
    const scalar blocked =
        adhesion_.populations()[s.receptors].blockedAt(time_);

    scalar gap = GREAT, sum = 0;
    DynamicList<label> found;
    surfacesNow::contact at;
    forAll(s.sites, site)
    {
        const point x(surfaces_.position(s.body, s.sites[site]));
        if
        (
            surfaces_.find(ligands.surface, x, rate.reach(), at)
         && adhesion_.unblocked(set, site, blocked)
        )
        {
            const scalar k = density*rate(at.gap);
            if (k > 0)
            {
                activate(set, site).ways.append
                (
                    candidate{t.pair, t.ligands, k, at, -1}
                );
                found.append(number_[{set, site}]);
                sum += k;
                gap = min(gap, at.gap);
            }
        }
    }
    if (adhesion_.pairs()[t.pair].faceCorrection != "none" && found.size())
    {
        const scalar scale = correctedRate(t, gap)/sum;
        for (const label i : found)
        {
            active_[i].ways.last().rate *= scale;
        }
    }
}


bool Foam::fsbi::bondStep::form
(
    const activeSite& s, const candidate& way,
    counterRandom::stream& draws, bond& b
) const
{
    b.pair = way.pair;
    b.ligands = way.ligands;
    if (adhesion_.sets()[s.set].faces)
    {
        b.end = materialPoint::centroid(way.triangle);
        return !taken_.count({way.ligands, way.triangle});
    }

    const scalar r =
        adhesion_.pairs()[way.pair].rate->distance(way.at.gap, draws.uniform());
    const scalar angle = constant::mathematical::twoPi*draws.uniform();
    const vector& n = way.at.normal;
    vector e1(n ^ (mag(n.x()) < 0.6 ? vector(1, 0, 0) : vector(0, 1, 0)));
    e1 /= mag(e1);
    const vector along(Foam::cos(angle)*e1 + Foam::sin(angle)*(n ^ e1));

    const label surface = adhesion_.populations()[way.ligands].surface;
    if (surfaces_.isWall(surface))
    {
        b.anchor = way.at.nearest
          + Foam::sqrt(max(sqr(r) - sqr(way.at.gap), scalar(0)))*along;
    }
    else
    {
        b.end = surfaces_.away(surface, s.place, way.at, along, r);
    }
    return true;
}


void Foam::fsbi::bondStep::log
(
    const activeSite& s, const bond& b, const scalar time, const bool formed
)
{
    const bondPair& pair = adhesion_.pairs()[b.pair];
    const point y(end(adhesion_, surfaces_, b));
    const scalar length = pair.length(s.place, y);
    events_.append
    (
        bondEvent
        {
            time_ + time, b.pair, s.set, s.site, formed, length,
            pair.law->force(length), s.place, y
        }
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::point Foam::fsbi::bondStep::end
(
    const adhesion& a, const surfacesNow& surfaces, const bond& b
)
{
    const label surface = a.populations()[b.ligands].surface;
    return
        surfaces.isWall(surface)
      ? b.anchor : surfaces.position(surface, b.end);
}


const Foam::DynamicList<Foam::fsbi::bondStep::candidate>*
Foam::fsbi::bondStep::candidates(const label set, const label site) const
{
    const auto found = number_.find({set, site});
    return
        found == number_.end() ? nullptr : &active_[found->second].ways;
}


Foam::fsbi::reactingSites::clock& Foam::fsbi::bondStep::clockOf
(
    const label i
)
{
    return clocks_[{active_[i].set, active_[i].site}];
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
    if (bound != bonds_.end())
    {
        const bondPair& pair = adhesion_.pairs()[bound->second.pair];
        return pair.law->kOff
        (
            pair.length(s.place, end(adhesion_, surfaces_, bound->second))
        );
    }
    scalar sum = 0;
    for (const candidate& way : s.ways)
    {
        sum += way.rate;
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
    if (bound != bonds_.end())
    {
        log(s, bound->second, time, false);
        taken_.erase({bound->second.ligands, bound->second.end.triangle});
        bonds_.erase(bound);
        return;
    }

    scalar share = draws.uniform()*rate(i);
    label w = 0;
    for (; w < s.ways.size() - 1 && share > s.ways[w].rate; ++w)
    {
        share -= s.ways[w].rate;
    }
    bond b;
    // a face that is taken is still counted in the rate: it says no
    if (form(s, s.ways[w], draws, b))
    {
        if (adhesion_.sets()[s.set].faces)
        {
            taken_.insert({b.ligands, b.end.triangle});
        }
        log(s, b, time, true);
        bonds_.insert({{s.set, s.site}, b});
    }
}
