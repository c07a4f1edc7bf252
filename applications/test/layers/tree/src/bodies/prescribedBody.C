/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prescribedBody.H"
#include "timeFunction.H"

Foam::fsbi::prescribedBody::prescribedBody
(
    const word& name, const dictionary& dict
)
:
    name_(name),
    entries_(dict)
{
    entries_.found("type");
    entries_.found("libs");
    entries_.found("enters");
    now_.centre = entries_.get<point>("position");
    for (auto* given : {&velocity_, &angularVelocity_})
    {
        const word key(given == &velocity_ ? "velocity" : "angularVelocity");
        if (entries_.found(key))
        {
            *given = timeFunction<vector>(key, entries_);
        }
    }
}


void Foam::fsbi::prescribedBody::begin
(
    const scalar time, const dictionary& saved
)
{
    entries_.finish();
    if (saved.empty())
    {
        now_.velocity = given(time);
        old_ = now_;
        start_ = now_.centre;
    }
    else
    {
        restore(saved);
    }
}


Foam::vector Foam::fsbi::prescribedBody::integral
(
    const autoPtr<Function1<vector>>& f, const scalar time, const scalar dt
)
{
    if (!f)
    {
        return Zero;
    }
    const scalar middle = time - 0.5*dt, reach = 0.5*dt*sqrt(0.6);
    return dt/18
       *(
            5*f->value(middle - reach) + 8*f->value(middle)
          + 5*f->value(middle + reach)
        );
}


Foam::fsbi::sixVector Foam::fsbi::prescribedBody::given
(
    const scalar time
) const
{
    return join
    (
        velocity_ ? velocity_->value(time) : vector(Zero),
        angularVelocity_ ? angularVelocity_->value(time) : vector(Zero)
    );
}


Foam::vector Foam::fsbi::prescribedBody::velocityAt
(
    const point& x, const vector& S
) const
{
    const vector V(linear(now_.velocity));
    const vector slip(velocityAt(x) - V);
    return V + slip - (slip & S)*S/magSqr(S);
}


void Foam::fsbi::prescribedBody::advance(const scalar time, const scalar dt)
{
    now_.velocity = given(time);
    now_.centre = old_.centre + integral(velocity_, time, dt);
    now_.orientation = normalize
    (
        rotationBy(integral(angularVelocity_, time, dt))*old_.orientation
    );
}


void Foam::fsbi::prescribedBody::enter(const point& centre)
{
    const sixVector velocity(now_.velocity);
    now_ = bodyState();
    now_.centre = centre;
    now_.velocity = velocity;
    old_ = now_;
}


void Foam::fsbi::prescribedBody::save(dictionary& state) const
{
    state.set("now", now_.saved());
    state.set("start", start_);
}


void Foam::fsbi::prescribedBody::restore(const dictionary& state)
{
    now_.restore(state.subDict("now"));
    old_ = now_;
    start_ = state.get<point>("start");
}
