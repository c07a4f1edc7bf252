/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "phaseLag.H"
#include "mathematicalConstants.H"

#include <cmath>

using Foam::constant::mathematical::twoPi;

void Foam::fsbi::phaseLag::update(const vector& B, const vector& m)
{
    const bool known = mag(axis_) > 0;
    const vector turn(B_ ^ B);
    if (mag(turn) > 1e-9*mag(B_)*mag(B))
    {
        axis_ = turn/mag(turn);
    }
    B_ = B;
    if (mag(axis_) > 0)
    {
        const vector across(m - (m & axis_)*axis_);
        const scalar now = std::atan2(axis_ & (across ^ B), across & B);
        const scalar change = now - angle_;
        angle_ = known ? angle_ + change - twoPi*std::round(change/twoPi) : now;
    }
}


Foam::label Foam::fsbi::phaseLag::slips() const
{
    return label(std::floor(angle_/twoPi + 0.5));
}


void Foam::fsbi::phaseLag::save(dictionary& state) const
{
    state.set("B", B_);
    state.set("axis", axis_);
    state.set("angle", angle_);
}


void Foam::fsbi::phaseLag::restore(const dictionary& state)
{
    B_ = state.get<vector>("B");
    axis_ = state.get<vector>("axis");
    angle_ = state.get<scalar>("angle");
}
