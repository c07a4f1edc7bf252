/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "imageChoice.H"

#include <cmath>

namespace Foam
{
namespace fsbi
{

//- Plane cells to begin with, a part of a period from each other; more of them
//  where the cost says that a side may be too steep: one of 32 was meshed, of 55 not
static const label starts = 8, mostStarts = 64;
static const scalar tooSteep = 10;

//- Slope of a side that is no worse than none
static const scalar flat = 1;

//- Steepest slope; beyond, a side would have to fold
static const scalar steepest = 50;

//- Further than this, in radii, a pair does not matter
static const scalar far = 4;

class imagesAlong
{
    const period& period_;
    const vector along_;
    const UList<scalar>& radii_;

    //- Ways to the neighbours beside the cell
    List<vector> beside_;

    //- Of the images
    pointField centres_;

    //- Of body a above a side and b beneath it
    scalar pairCost(const label a, const label b) const
    {
        const scalar both = radii_[a] + radii_[b];
        scalar cost = 0;
        for (const vector& way : beside_)
        {
            const vector d
            (
                centres_[a] - centres_[b] + period_.translation + way
            );
            const scalar gap = mag(d) - both;
            if (gap < far*both)
            {
                const scalar up = d & along_;
                const scalar across = mag(d - up*along_);
                const scalar slope =
                    up*steepest > across ? across/up : steepest*(2 - up/both);
                const scalar over = max(slope - flat, scalar(0));
                cost += std::exp(-4*gap/both)*sqr(sqr(over));
            }
        }
        return cost;
    }

    scalar costOf(const label a) const
    {
        scalar cost = 0;
        forAll(centres_, b)
        {
            if (b != a)
            {
                cost += pairCost(a, b) + pairCost(b, a);
            }
        }
        return cost;
    }

    //- Put a body where it costs less; is there such a place?
    bool improve(const label a)
    {
        const point now(centres_[a]);
        const scalar before = costOf(a);
        for (const scalar sign : {-1, 1})
        {
            centres_[a] = now + sign*period_.translation;
            if (costOf(a) < (1 - 1e-6)*before)
            {
                return true;
            }
        }
        centres_[a] = now;
        return false;
    }

public:

    imagesAlong
    (
        const UList<period>& periods, const label i,
        const UList<point>& centres, const UList<scalar>& radii
    )
    :
        period_(periods[i]),
        along_(periods[i].direction()),
        radii_(radii),
        centres_(centres)
    {
        DynamicList<period> others;
        forAll(periods, j)
        {
            if (j != i)
            {
                others.append(periods[j]);
            }
        }
        beside_ = imagesOf(others);
        beside_.append(Zero);
    }

    //- From the plane cell that is moved so, by parts of a period
    scalar improveFrom(const vector& shift, const scalar part)
    {
        const List<period> one(1, period_);
        for (point& c : centres_)
        {
            c += intoCell(one, c, shift + part*period_.translation);
        }
        bool better = true;
        for (label round = 0; better && round < 100; ++round)
        {
            better = false;
            forAll(centres_, a)
            {
                better = improve(a) || better;
            }
        }
        scalar cost = 0;
        forAll(centres_, a)
        {
            cost += costOf(a);
        }
        return cost;
    }

    const pointField& centres() const { return centres_; }
};

//- Do bodies with their centres in the cell cross no side? Sets their ways
static bool inPlaneCell
(
    const UList<period>& periods,
    const UList<point>& centres,
    const UList<boundBox>& boxes,
    const vector& shift,
    vectorField& ways
)
{
    bool inside = true;
    forAll(ways, b)
    {
        ways[b] = intoCell(periods, centres[b], shift);
        const pointField corners(boxes[b].points() + (ways[b] - shift));
        for (const period& along : periods)
        {
            for (const point& corner : corners)
            {
                const scalar from = along.from(corner);
                inside = inside && from > 0 && from < along.length();
            }
        }
    }
    return inside;
}

} // End namespace fsbi
} // End namespace Foam


Foam::vectorField Foam::fsbi::imageChoice
(
    const UList<period>& periods,
    const UList<point>& centres,
    const UList<scalar>& radii,
    const UList<boundBox>& boxes,
    const vector& shift
)
{
    vectorField ways(centres.size(), Zero);
    if (inPlaneCell(periods, centres, boxes, shift, ways))
    {
        return ways;
    }
    ways = vector(Zero);
    forAll(periods, i)
    {
        scalar least = GREAT;
        pointField best;
        const auto beginFrom = [&](const scalar part)
        {
            imagesAlong images(periods, i, centres, radii);
            const scalar cost = images.improveFrom(shift, part);
            if (cost < least)
            {
                least = cost;
                best = images.centres();
            }
        };
        for (label start = 0; start < starts && least > 0; ++start)
        {
            // out from the plane cell, to both sides
            const label n = start % 2 ? (start + 1)/2 : -start/2;
            beginFrom(scalar(n)/starts);
        }
        for (label n = 1; n < mostStarts && least > tooSteep; ++n)
        {
            beginFrom(scalar(n)/mostStarts);
        }
        forAll(ways, b)
        {
            const scalar n =
                (best[b] - centres[b]) & periods[i].direction();
            ways[b] +=
                std::round(n/periods[i].length())*periods[i].translation;
        }
    }
    return ways;
}
