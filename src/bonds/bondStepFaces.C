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
    surfacesNow::contact at;
    for (const label turned : {0, 1})
    {
        for (const point& x : surfaces_.surface(turned ? b : a).points())
        {
            if (surfaces_.find(turned ? a : b, x, smallest, at))
            {
                smallest = at.gap;
                some = true;
            }
        }
    }
    return some ? smallest : -1;
}


Foam::labelList Foam::fsbi::bondStep::facesNear
(
    const label a, const label b, const scalar reach
) const
{
    boundBox box(surfaces_.surface(b).bounds());
    box.min() -= reach*vector::one;
    box.max() += reach*vector::one;
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


Foam::scalar Foam::fsbi::bondStep::correctedRate
(
    const adhesion::target& t, const scalar gap
) const
{
    const bondPair& pair = adhesion_.pairs()[t.pair];
    const adhesion::population& ligands = adhesion_.populations()[t.ligands];
    const bodySurface& surface = surfaces_.surface(ligands.surface);
    // closer than at rest a molecule need not be shortened: it tilts
    const scalar l = pair.faces
      ? gap - pair.roughness
      : max(gap - pair.roughness, pair.law->lambda());
    return
        ligands.freeDensity(time_)*surface.area()*pair.law->kOn(l)
       *(pair.faceCorrection == "global" ? surface.triangles().size() : 1);
}


void Foam::fsbi::bondStep::findFaces
(
    const label set, const adhesion::target& t
)
{
    const label a = adhesion_.sets()[set].body;
    const adhesion::population& ligands = adhesion_.populations()[t.ligands];
    const label b = ligands.surface;
    const bondPair& pair = adhesion_.pairs()[t.pair];
    const scalar density = ligands.freeDensity(time_);
    const scalar gap = smallestGap(a, b, pair.rate->reach());
    if (gap < 0 || !(density > 0))
    {
        return;
    }

    // logarithms, for with coarse faces all rates may underflow before they
    // are scaled
    const bool scaled = pair.faceCorrection != "none";
    const scalar reach =
        pair.rate->reach()
      + (scaled ? 4*surfaces_.surface(b).meanEdge() : scalar(0));
    struct option {label i; label j; scalar logRate;};
    DynamicList<option> options;
    const labelList others(facesNear(b, a, reach));
    scalar largest = -GREAT;
    for (const label i : facesNear(a, b, reach))
    {
        const point x(surfaces_.centroid(a, i));
        for (const label j : others)
        {
            const point y(surfaces_.centroid(b, j));
            if (magSqr(y - x) <= sqr(reach))
            {
                const scalar logRate =
                    Foam::log(density*surfaces_.area(b, j))
                  + pair.law->logOn(pair.length(x, y));
                options.append(option{i, j, logRate});
                largest = max(largest, logRate);
            }
        }
    }

    scalar sum = 0;
    for (const option& o : options)
    {
        sum += Foam::exp(o.logRate - largest);
    }
    scalar scale = scaled ? 0 : Foam::exp(largest);
    if (scaled && sum > 0)
    {
        scale = correctedRate(t, gap)/sum;
    }
    for (const option& o : options)
    {
        const scalar k = scale*Foam::exp(o.logRate - largest);
        if (k > 0)
        {
            activate(set, o.i).ways.append
            (
                candidate{t.pair, t.ligands, k, {}, o.j}
            );
        }
    }
}
