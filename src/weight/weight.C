/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "weight.H"
#include "prescribedBody.H"
#include "timeFunction.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{

defineTypeNameAndDebug(weight, 0);
addToRunTimeSelectionTable(effect, weight, entries);

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::weight::weight
(
    const dictionary& dict, const effectContext& context
)
:
    effect(context),
    mass_(context.bodies.size(), Zero)
{
    const checkedDictionary entries(dict);
    entries.found("libs");
    gravity_ = timeFunction<vector>("gravity", entries);
    const scalar fluidDensity = entries.positive("fluidDensity");
    entries.finish();
    checkOthers(dict);
    setMass(dict, fluidDensity);
}


void Foam::fsbi::weight::checkOthers(const dictionary& dict) const
{
    if (context_.gravities.size())
    {
        FatalIOErrorInFunction(dict)
            << "'weight' is gravity and buoyancy of all bodies, but there is"
            << " gravity already: " << context_.gravities.first().c_str()
            << ". Remove one of the two" << exit(FatalIOError);
    }
}


void Foam::fsbi::weight::setMass
(
    const dictionary& dict, const scalar fluidDensity
)
{
    Info<< "Weight less buoyancy:" << nl;
    forAll(context_.bodies, b)
    {
        const immersedBody& body = context_.bodies[b];
        if (isA<prescribedBody>(body))
        {
            continue;
        }
        if (!(body.density() > 0))
        {
            FatalIOErrorInFunction(dict)
                << "Body '" << body.name() << "' has no density, which"
                << " 'weight' needs: entry 'density' in "
                << (body.deforms() ? "its material" : "constant/bodies")
                << exit(FatalIOError);
        }
        mass_[b] = (body.density() - fluidDensity)*body.volume();
        Info<< "    " << body.name() << ": mass " << mass_[b] << nl;
    }
    Info<< endl;
}


void Foam::fsbi::weight::apply(loads& l) const
{
    const vector g(gravity_->value(context_.time.value()));
    const loads::sixMatrix none(sixVector(scalar(0)));
    forAll(mass_, b)
    {
        if (context_.bodies[b].present() && mass_[b] != 0)
        {
            l.add(b, join(mass_[b]*g, Zero), none);
        }
    }
}
