/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bondStep.H"
#include "boundBox.H"

Foam::scalar Foam::fsbi::bondStep::smallestGap
(
    const label a, const label b, const scalar reach
) const
{
    // an edge of one surface against an edge of the other is left out
    scalar smallest = reach;
    bool some = false;
    const auto look = [&](const label from, const label to, const materialPoint& p)
    {
        currentSurfaces::nearestPoint at;
        if (surfaces_.find(to, surfaces_.position(from, p), smallest, at))
        {
            smallest = at.gap;
            some = true;
        }
    };
    for (const label turned : {0, 1})
    {
        const label from = turned ? b : a, to = turned ? a : b;
        const bodySurface& s = surfaces_.surface(from);
        boolList seen(s.points().size(), false);
        forAll(s.triangles(), t)
        {
            look(from, to, materialPoint::centroid(t));
            for (label k = 0; k < 3; ++k)
            {
                bool& corner = seen[s.triangles()[t][k]];
                if (!corner)
                {
                    look(from, to, {t, scalar(k == 1), scalar(k == 2)});
                    corner = true;
                }
            }
        }
    }
    return some ? smallest : -1;
}


Foam::labelList Foam::fsbi::bondStep::facesNear
(
    const label a, const label b, const vector& way, const scalar reach
) const
{
    // what triangles stand for may be nearer than they are
    const boundBox box
    (
        surfaces_.bounds
        (
            b, way, reach + surfaces_.standsOut(a) + surfaces_.standsOut(b)
        )
    );
    DynamicList<label> near;
    forAll(surfaces_.surface(a).triangles(), triangle)
    {
        if (box.contains(surfaces_.centroid(a, triangle)))
        {
            near.append(triangle);
        }
    }
    return labelList(near);
}


Foam::scalar Foam::fsbi::bondStep::globalRate
(
    const adhesion::target& t, const scalar gap
) const
{
    const bondPair& pair = adhesion_.pairs()[t.pair];
    // closer than at rest a molecule need not be shortened: it tilts
    const scalar l = pair.faces
      ? gap - pair.roughness
      : max(gap - pair.roughness, pair.law->lambda());
    return free_.number(t.ligands)*pair.law->kOn(l);
}


Foam::DynamicList<Foam::fsbi::bondStep::facePair>
Foam::fsbi::bondStep::facePairs
(
    const label set, const adhesion::target& t
) const
{
    const label a = adhesion_.sets()[set].body;
    const adhesion::population& ligands = adhesion_.populations()[t.ligands];
    const label b = ligands.surface;
    const bondPair& pair = adhesion_.pairs()[t.pair];
    scalar reach = pair.rate->reach();
    if (pair.faceCorrection != "none")
    {
        reach += 4*surfaces_.surface(b).meanEdge();
    }

    DynamicList<facePair> result;
    const auto addPair = [&]
    (
        const label i, const point& x, const label j, const point& y
    )
    {
        const label n = ligands.numbers[j];
        if (n > 0 && magSqr(y - x) <= sqr(reach))
        {
            const scalar logOn = pair.law->logOn(pair.length(x, y));
            result.append(facePair{i, j, Foam::log(scalar(n)) + logOn});
        }
    };
    for (const vector& way : surfaces_.ways(false))
    {
        const labelList others(facesNear(b, a, -way, reach));
        pointField places(others.size());
        forAll(others, j)
        {
            places[j] =
                surfaces_.position(b, materialPoint::centroid(others[j])) + way;
        }
        for (const label i : facesNear(a, b, way, reach))
        {
            const point x(surfaces_.position(a, materialPoint::centroid(i)));
            forAll(others, j)
            {
                addPair(i, x, others[j], places[j]);
            }
        }
    }
    return result;
}


Foam::scalar Foam::fsbi::bondStep::meanRate
(
    const label set,
    const bondPair& pair,
    const UList<facePair>& pairs,
    const scalar largest
) const
{
    const labelList& receptors =
        adhesion_.populations()[adhesion_.sets()[set].receptors].numbers;
    const bool all = pair.faceCorrection == "global";
    scalar sum = 0;
    for (const facePair& p : pairs)
    {
        sum += (all ? 1 : receptors[p.i])*Foam::exp(p.logRate - largest);
    }
    return sum/(all ? receptors.size() : adhesion_.sets()[set].sites.size());
}


void Foam::fsbi::bondStep::findFaces
(
    const label set, const adhesion::target& t
)
{
    const adhesion::siteSet& s = adhesion_.sets()[set];
    const adhesion::population& receptors =
        adhesion_.populations()[s.receptors];
    const label other = adhesion_.populations()[t.ligands].surface;
    const bondPair& pair = adhesion_.pairs()[t.pair];
    const scalar gap = smallestGap(s.body, other, pair.rate->reach());
    if (gap < 0)
    {
        return;
    }

    // logarithms, for with coarse faces all rates may underflow before they
    // are scaled
    const DynamicList<facePair> pairs(facePairs(set, t));
    scalar largest = -GREAT;
    for (const facePair& p : pairs)
    {
        largest = max(largest, p.logRate);
    }
    scalar scale = 0;
    if (pair.faceCorrection == "none")
    {
        scale = Foam::exp(largest);
    }
    else
    {
        const scalar mean = meanRate(set, pair, pairs, largest);
        scale = mean > 0 ? globalRate(t, gap)/mean : 0;
    }
    for (const facePair& p : pairs)
    {
        const scalar k = scale*Foam::exp(p.logRate - largest);
        const candidate channel{t.pair, t.ligands, k, {}, p.j};
        const label first = receptors.first[p.i];
        for (label n = 0; n < receptors.numbers[p.i]; ++n)
        {
            offer(set, first + n, channel);
        }
    }
}
