/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coil.H"
#include "wordList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(coil, 0);
    addToRunTimeSelectionTable(magneticField, coil, entries);
}
}


Foam::fsbi::coil::coil(const checkedDictionary& entries, const units& u)
:
    current_(function<scalar>(entries, "current")),
    length_(1/u.metre())
{
    const word arrangement
    (
        entries.choice
        (
            "arrangement", {"single", "Helmholtz", "Maxwell"}, "single"
        )
    );
    const point centre(length_*entries.get<point>("centre"));
    const vector axis(entries.direction("axis"));
    const scalar radius = length_*entries.positive("radius");
    const scalar turns = entries.positive("turns", 1);
    if (arrangement == "single")
    {
        loops_.append(new currentLoop(centre, axis, radius));
        turns_ = {turns};
        return;
    }
    const bool Maxwell = arrangement == "Maxwell";
    const vector half((Maxwell ? sqrt(3.0) : 1)*0.5*radius*axis);
    loops_.append(new currentLoop(centre + half, axis, radius));
    loops_.append(new currentLoop(centre - half, axis, radius));
    turns_ = {turns, Maxwell ? -turns : turns};
}


Foam::vector Foam::fsbi::coil::unitB(const point& x) const
{
    vector sum(Zero);
    forAll(loops_, i)
    {
        sum += turns_[i]*loops_[i].B(length_*x);
    }
    return sum;
}


Foam::tensor Foam::fsbi::coil::unitGradient(const point& x) const
{
    tensor sum(Zero);
    forAll(loops_, i)
    {
        sum += (length_*turns_[i])*loops_[i].gradient(length_*x);
    }
    return sum;
}
