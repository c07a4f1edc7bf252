/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "magnetics.H"
#include "dipole.H"

namespace Foam
{
namespace fsbi
{

//- Difference of moments, over the largest, at which they agree; and how often
//  bodies may answer each other. They do so at less than a quarter of what
//  they are told, unless they overlap
static const scalar agreed = 1e-13;
static const label maxAnswers = 100;

} // End namespace fsbi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsbi::magnetics::interact(List<state>& s) const
{
    scalar change = GREAT, largest = 0;
    for (label n = 0; n < maxAnswers && change > agreed*largest; ++n)
    {
        change = largest = 0;
        forAll(s, a)
        {
            s[a].B = s[a].givenB;
            s[a].gradient = s[a].givenGradient;
            forAll(s, b)
            {
                if (a != b && body(a).present() && body(b).present())
                {
                    const vector r(apart(s[b], s[a]));
                    s[a].B += dipoleB(s[b].m, r);
                    s[a].gradient +=
                        dipoleGradient(s[b].m, r)/units_.metre();
                }
            }
        }
        forAll(s, a)
        {
            const magnet& magnet = magnets_[a];
            const vector m(magnet.law->moment(magnet.volume, s[a].R, s[a].B));
            change = max(change, mag(m - s[a].m));
            largest = max(largest, mag(m));
            s[a].m = m;
        }
    }
    if (change > agreed*largest)
    {
        FatalErrorInFunction
            << "The moments that magnetic bodies induce in each other do not"
            << " agree: bodies overlap, or are saturated in no field"
            << exit(FatalError);
    }
}


Foam::scalar Foam::fsbi::magnetics::forceStiffness
(
    const label magneti, const state& s
) const
{
    const magnet& magnet = magnets_[magneti];
    const scalar t = context_.time.value();
    const scalar h = 1e-3*cbrt(magnet.volume)*units_.metre();
    const auto force = [&](const point& x)
    {
        const vector B(givenB(x, t) + s.B - s.givenB);
        return
            givenGradient(x, t)
          & magnet.law->moment(magnet.volume, s.R, B);
    };
    scalar sum = 0;
    for (direction d = 0; d < 3; ++d)
    {
        vector step(Zero);
        step[d] = h;
        sum += magSqr(force(s.x + step) - force(s.x - step));
    }
    return units_.joule()*sqrt(sum)/(2*h);
}


void Foam::fsbi::magnetics::addGiven
(
    const label magneti, const state& s, loads& l
) const
{
    const magnet& magnet = magnets_[magneti];
    const scalar J = units_.joule();
    const tensor turning
    (
        J*magnet.law->torqueStiffness(magnet.volume, s.R, s.B)
    );
    const scalar moving = forceStiffness(magneti, s);
    loads::sixMatrix K(sixVector(scalar(0)));
    for (direction i = 0; i < 3; ++i)
    {
        K[i][i] = moving;
        for (direction j = 0; j < 3; ++j)
        {
            K[3 + i][3 + j] = turning(i, j);
        }
    }
    l.add
    (
        magnet.body, join(J*(s.givenGradient & s.m), J*(s.m ^ s.B)), K
    );
}


void Foam::fsbi::magnetics::addPair
(
    const label a, const label b, const List<state>& s, loads& l
) const
{
    const vector r(apart(s[b], s[a]));
    const scalar J = units_.joule(), L = units_.metre();
    const vector force(J/L*(dipoleGradient(s[b].m, r) & s[a].m));
    if (!body(a).deforms() && !body(b).deforms())
    {
        // second derivative of the energy, largest if both stand in line
        const scalar k =
            24*mu0By4Pi*mag(s[a].m)*mag(s[b].m)/pow5(mag(r))*J/sqr(L);
        loads::site atA, atB;
        atA.body = magnets_[a].body;
        atB.body = magnets_[b].body;
        l.add({atA, atB, force, k*tensor::I});
        return;
    }
    const loads::sixMatrix none(sixVector(scalar(0)));
    l.add(magnets_[a].body, join(force, Zero), none);
    l.add(magnets_[b].body, join(-force, Zero), none);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::List<Foam::fsbi::magnetics::state>
Foam::fsbi::magnetics::states() const
{
    const scalar t = context_.time.value();
    List<state> all(magnets_.size());
    forAll(all, i)
    {
        state& s = all[i];
        const placement where(body(i).placed());
        s.x = where.centre;
        s.there = s.x + body(i).toImage();
        s.R = where.orientation.R();
        s.B = s.givenB = givenB(s.x, t);
        s.gradient = s.givenGradient = givenGradient(s.x, t);
        s.m = magnets_[i].law->moment(magnets_[i].volume, s.R, s.B);
    }
    if (interaction_)
    {
        interact(all);
    }
    return all;
}


void Foam::fsbi::magnetics::apply(loads& l) const
{
    const List<state> all(states());
    forAll(all, a)
    {
        if (!body(a).present())
        {
            continue;
        }
        addGiven(a, all[a], l);
        for (label b = a + 1; interaction_ && b < all.size(); ++b)
        {
            if (body(b).present())
            {
                addPair(a, b, all, l);
            }
        }
    }
}
