/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "units.H"
#include "wordList.H"

Foam::fsbi::units::units(const checkedDictionary& entries)
:
    mass_(1),
    length_(1),
    time_(1)
{
    const wordList valid({"microvascular", "SI"});
    if (entries.choice("units", valid, "microvascular") == "microvascular")
    {
        mass_ = 1e15;
        length_ = 1e6;
        time_ = 1e6;
    }
}
