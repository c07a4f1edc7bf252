/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bodyState.H"
#include "OStringStream.H"

Foam::quaternion Foam::fsbi::rotationBy(const vector& angle)
{
    const scalar a = mag(angle);
    return a > VSMALL ? quaternion(angle/a, a) : quaternion::I;
}


Foam::vector Foam::fsbi::angleOf(const quaternion& q)
{
    const scalar sine = mag(q.v());
    return
        sine > VSMALL
      ? (2*std::atan2(sign(q.w())*sine, mag(q.w()))/sine)*q.v()
      : vector(Zero);
}


Foam::string Foam::fsbi::textOf(const dictionary& dict)
{
    OStringStream os;
    os.precision(17);
    dict.write(os, false);
    return os.str();
}


Foam::dictionary Foam::fsbi::bodyState::saved() const
{
    dictionary dict;
    dict.set("centre", centre);
    dict.set("orientation", orientation);
    dict.set("velocity", linear(velocity));
    dict.set("angularVelocity", angular(velocity));
    dict.set("force", linear(load));
    dict.set("torque", angular(load));
    return dict;
}


void Foam::fsbi::bodyState::restore(const dictionary& dict)
{
    centre = dict.get<point>("centre");
    orientation = dict.get<quaternion>("orientation");
    velocity = join
    (
        dict.get<vector>("velocity"), dict.get<vector>("angularVelocity")
    );
    load = join(dict.get<vector>("force"), dict.get<vector>("torque"));
}
