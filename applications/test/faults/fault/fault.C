/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Class
    Foam::fsbi::fault

Description
    For tests: an effect that pushes a body with a force of any size, or with
    no number, in its n-th attempt of a step and in some after that.

Usage
    constant/effects
    \code
    fault
    {
        libs        ("libfault.so");
        body        tumourCell;
        push        (nan nan nan);
        attempt     3;
        times       1;
    }
    \endcode

\*---------------------------------------------------------------------------*/

#include "effect.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{

class fault
:
    public effect
{
    const label body_;
    const vector push_;
    const label attempt_;
    const label times_;

    //- Attempts so far; not of the state: a repeated step is another attempt
    label begun_ = 0;

public:

    TypeName("fault");

    fault(const dictionary& dict, const surroundings& around)
    :
        effect(around),
        body_(around.bodyIndex(dict.get<word>("body"), dict)),
        push_(dict.get<vector>("push")),
        attempt_(dict.get<label>("attempt")),
        times_(dict.get<label>("times"))
    {}

    void apply(loads& l) const override
    {
        if (begun_ >= attempt_ && begun_ < attempt_ + times_)
        {
            l.add
            (
                body_, join(push_, Zero),
                loads::sixMatrix(sixVector(scalar(0)))
            );
        }
    }

    void beginStep() override { ++begun_; }
    void rewind() override {}
    void endStep() override {}
    void save(dictionary&) const override {}
    void restore(const dictionary&) override {}
};

defineTypeNameAndDebug(fault, 0);
addToRunTimeSelectionTable(effect, fault, entries);

} // End namespace fsbi
} // End namespace Foam
