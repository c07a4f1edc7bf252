/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "materialPoint.H"
#include "triPointRef.H"

Foam::fsbi::materialPoint Foam::fsbi::materialPoint::nearest
(
    const label triangle,
    const point& p,
    const UList<point>& points,
    const UList<triFace>& triangles
)
{
    const triPointRef corners(triangles[triangle].tri(points));
    const point at(corners.nearestPoint(p).rawPoint());
    const vector ab(corners.b() - corners.a());
    const vector ac(corners.c() - corners.a());
    const vector d(at - corners.a());

    // d = b ab + c ac
    const scalar bb = ab & ab, cc = ac & ac, bc = ab & ac;
    const scalar det = bb*cc - bc*bc;
    materialPoint result;
    result.triangle = triangle;
    result.b = (cc*(d & ab) - bc*(d & ac))/det;
    result.c = (bb*(d & ac) - bc*(d & ab))/det;
    return result;
}


Foam::labelList Foam::fsbi::materialPoint::numbers
(
    const scalar density,
    const counterRandom& random,
    const UList<point>& points,
    const UList<triFace>& triangles
)
{
    labelList result(triangles.size(), Zero);
    label n = 0;
    scalar sum = 0, next = random.at(2, n).uniform();
    forAll(triangles, i)
    {
        sum += density*triangles[i].tri(points).mag();
        while (next <= sum)
        {
            ++result[i];
            ++n;
            next = n + random.at(2, n).uniform();
        }
    }
    return result;
}


Foam::DynamicList<Foam::fsbi::materialPoint>
Foam::fsbi::materialPoint::spread
(
    const UList<label>& numbers, const counterRandom& random
)
{
    DynamicList<materialPoint> result;
    forAll(numbers, i)
    {
        counterRandom::stream draws(random.at(0, i));
        for (label n = 0; n < numbers[i]; ++n)
        {
            const scalar root = Foam::sqrt(draws.uniform());
            const scalar u = draws.uniform();
            materialPoint p;
            p.triangle = i;
            p.b = root*(1 - u);
            p.c = root*u;
            result.append(p);
        }
    }
    return result;
}
