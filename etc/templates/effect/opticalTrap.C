/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "opticalTrap.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{

defineTypeNameAndDebug(opticalTrap, 0);
addToRunTimeSelectionTable(effect, opticalTrap, entries);

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::opticalTrap::opticalTrap
(
    const dictionary& dict, const effectContext& context
)
:
    effect(context)
{
    const checkedDictionary entries(dict);
    entries.found("libs");
    body_ = context.bodyIndex(entries.get<word>("body"), dict);
    centre_ = entries.get<point>("centre");
    stiffness_ = entries.get<scalar>("stiffness");
    entries.finish();
}


Foam::vector Foam::fsbi::opticalTrap::force() const
{
    return stiffness_*(centre_ - context_.bodies[body_].placed().centre);
}


void Foam::fsbi::opticalTrap::apply(loads& l) const
{
    // the stiffness lets the solver take the force at the end of the step:
    // without it a step longer than 2 (drag/k) would not be stable
    loads::sixMatrix K(sixVector(scalar(0)));
    for (label k = 0; k < 3; ++k)
    {
        K[k][k] = stiffness_;
    }
    l.add(body_, join(force(), Zero), K);
}


void Foam::fsbi::opticalTrap::declare(recording& history) const
{
    history.declare("opticalTrap/force", {"x", "y", "z"}, "M L/T^2");
}


void Foam::fsbi::opticalTrap::record(recording& history) const
{
    const vector f(force());
    history.append("opticalTrap/force", scalarList({f.x(), f.y(), f.z()}));
}
