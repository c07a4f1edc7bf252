/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bodyState.H"
#include "OStringStream.H"
#include "mathematicalConstants.H"

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


Foam::Tuple2<Foam::vector, Foam::scalar> Foam::fsbi::orientationOf
(
    const checkedDictionary& entries
)
{
    const word key("orientation");
    const Tuple2<vector, scalar> turn
    (
        entries.getOrDefault(key, Tuple2<vector, scalar>(Zero, 0))
    );
    const scalar length = mag(turn.first());
    if (entries.dict().found(key) && length < SMALL)
    {
        FatalIOErrorInFunction(entries.dict())
            << "Entry '" << key << "' has an axis of no length; it is"
            << " ((axis) angle)" << exit(FatalIOError);
    }
    if (mag(turn.second()) > constant::mathematical::twoPi)
    {
        FatalIOErrorInFunction(entries.dict())
            << "Entry '" << key << "' turns by " << turn.second() << " rad, more"
            << " than a turn: angles are in radians" << exit(FatalIOError);
    }
    if (length > 0 && mag(length - 1) > 1e-3)
    {
        Info<< "Warning: the axis of '" << key << "' in "
            << entries.dict().name().name().c_str() << " has the length "
            << length << ": its direction counts" << nl << endl;
    }
    return turn;
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
