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
        push        (0 1 0);
        times       notANumber;      // of the push; also infinite, huge, none
        attempt     3;
        attempts    1;
    }
    \endcode

\*---------------------------------------------------------------------------*/

#include "effect.H"
#include "untrapped.H"
#include "addToRunTimeSelectionTable.H"
#include <limits>

namespace Foam
{
namespace fsbi
{

class fault
:
    public effect
{
    const label body_;
    vector push_;
    const label attempt_;
    const label attempts_;

    //- Attempts so far; not of the state: a repeated step is another attempt
    label begun_ = 0;

public:

    TypeName("fault");

    fault(const dictionary& dict, const effectContext& context)
    :
        effect(context),
        body_(context.bodyIndex(dict.get<word>("body"), dict)),
        push_(dict.get<vector>("push")),
        attempt_(dict.get<label>("attempt")),
        attempts_(dict.get<label>("attempts"))
    {
        const word times(dict.get<word>("times"));
        const untrapped scope;
        push_ *=
            times == "notANumber" ? std::nan("")
          : times == "infinite" ? std::numeric_limits<scalar>::infinity()
          : times == "huge" ? 1e299
          : 1;
    }

    void apply(loads& l) const override
    {
        if (begun_ >= attempt_ && begun_ < attempt_ + attempts_)
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
