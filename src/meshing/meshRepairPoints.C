/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshRepairI.H"

namespace Foam
{
namespace fsbi
{

//- Steps of a moved point over the mean length of its edges: the first, and each
//  over the one before
static const scalar firstStep = 0.15, shorter = 0.4;
static const label nSteps = 6;

} // End namespace fsbi
} // End namespace Foam


Foam::scalar Foam::fsbi::meshRepair::around
(
    const label pointi, point& centre, scalar& length
)
{
    cells_.star(pointi, star_);
    cells_.sides(star_, sides_);
    // near points count more: the mean alone would make small cells larger
    centre = Zero;
    scalar weight = 0;
    length = 0;
    for (const label c : star_)
    {
        for (const label v : cells_[c])
        {
            if (v != pointi)
            {
                const scalar edge = mag(points_[v] - points_[pointi]);
                centre += points_[v]/(edge + VSMALL);
                weight += 1/(edge + VSMALL);
                length += edge;
            }
        }
    }
    centre /= weight;
    length /= 3*star_.size();
    return badness(star_, GREAT);
}


bool Foam::fsbi::meshRepair::better
(
    const label pointi, const point& x, scalar& least
)
{
    const point before(points_[pointi]);
    points_[pointi] = x;
    if (mobility_[pointi] == SLIDING)
    {
        const vector& n = normals_.at(pointi);
        points_[pointi] -= n*(n & (x - before));
    }
    const scalar limit = (1 - roundOff)*least;
    const scalar b = badness(star_, limit);
    if (b < limit)
    {
        least = b;
        return true;
    }
    points_[pointi] = before;
    return false;
}


void Foam::fsbi::meshRepair::centre(const label pointi)
{
    if (mobility_[pointi] == FIXED)
    {
        return;
    }
    const point start(points_[pointi]);
    point middle;
    scalar length;
    scalar least = around(pointi, middle, length);
    if
    (
        better(pointi, middle, least)
     || better(pointi, 0.5*(start + middle), least)
    )
    {
        touch(star_);
    }
}


void Foam::fsbi::meshRepair::smooth(const label pointi)
{
    if (mobility_[pointi] == FIXED)
    {
        return;
    }
    const point start(points_[pointi]);
    point middle;
    scalar step;
    const scalar before = around(pointi, middle, step);
    scalar least = before;
    better(pointi, 0.5*(start + middle), least);
    better(pointi, middle, least);
    step *= firstStep;
    for (label k = 0; k < nSteps; ++k)
    {
        bool any = false;
        for (direction i = 0; i < 6; ++i)
        {
            point x(points_[pointi]);
            x[i/2] += i % 2 ? -step : step;
            any = better(pointi, x, least) || any;
        }
        step *= any ? 1 : shorter;
    }
    if (least < (1 - worthwhile)*before)
    {
        touch(star_);
    }
    else
    {
        points_[pointi] = start;
    }
}
