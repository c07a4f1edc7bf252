/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "workBalance.H"

void Foam::fsbi::workBalance::add(const state& now)
{
    work_ +=
        0.5*gSum((last_.force + now.force) & (now.D - last_.D))
      + 0.5*((last_.volumeForce + now.volumeForce) & (now.sumD - last_.sumD));
    last_ = now;
}


void Foam::fsbi::workBalance::save(dictionary& dict) const
{
    dict.set("work", work_);
    dict.set("volumeForce", last_.volumeForce);
}


void Foam::fsbi::workBalance::restore
(
    const dictionary& dict, const vectorField& D, const vector& sumD
)
{
    work_ = dict.get<scalar>("work");
    last_.volumeForce = dict.get<vector>("volumeForce");
    last_.D = D;
    last_.sumD = sumD;
}
