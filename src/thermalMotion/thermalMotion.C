/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "thermalMotion.H"
#include "prescribedBody.H"
#include "rigidBody.H"
#include "units.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{

defineTypeNameAndDebug(thermalMotion, 0);
addToRunTimeSelectionTable(effect, thermalMotion, entries);

//- Replace a symmetric matrix, of which the lower half counts, by its Cholesky
//  factor there; false: it is not positive definite
static bool factorise(scalarSquareMatrix& A)
{
    for (label j = 0; j < A.n(); ++j)
    {
        for (label i = j; i < A.n(); ++i)
        {
            scalar sum = A(i, j);
            for (label k = 0; k < j; ++k)
            {
                sum -= A(i, k)*A(j, k);
            }
            if (i == j && !(sum > 0))
            {
                return false;
            }
            A(i, j) = i == j ? sqrt(sum) : sum/A(j, j);
        }
    }
    return true;
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::thermalMotion::thermalMotion
(
    const dictionary& dict, const effectContext& context
)
:
    effect(context),
    force_(context.bodies.size(), sixVector(scalar(0)))
{
    const checkedDictionary entries(dict);
    entries.found("libs");
    kT_ = units(entries).Boltzmann()*entries.positive("temperature");
    seed_ = entries.get<label>("seed");
    given_ = entries.found("interval");
    interval_ = entries.positive("interval", context.time.deltaTValue());
    entries.finish();
    if (seed_ < 0)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'seed' must not be negative, but is " << seed_
            << exit(FatalIOError);
    }
    checkBodies(dict);
}


void Foam::fsbi::thermalMotion::checkBodies(const dictionary& dict) const
{
    label n = 0;
    for (const immersedBody& body : context_.bodies)
    {
        const rigidBody* rigid = dynamic_cast<const rigidBody*>(&body);
        if (!rigid && !isA<prescribedBody>(body))
        {
            FatalIOErrorInFunction(dict)
                << "Body '" << body.name() << "' is elastic: 'thermalMotion'"
                << " is of rigid bodies only" << exit(FatalIOError);
        }
        if (rigid && !rigid->overdamped())
        {
            FatalIOErrorInFunction(dict)
                << "Body '" << body.name() << "' has inertia, with which"
                << " 'thermalMotion' does not go: give it 'overdamped true;'"
                << " in constant/bodies" << exit(FatalIOError);
        }
        n += rigid ? 1 : 0;
    }
    if (n == 0)
    {
        FatalIOErrorInFunction(dict)
            << "There is no rigid body that 'thermalMotion' could move"
            << exit(FatalIOError);
    }
}


Foam::scalarField Foam::fsbi::thermalMotion::increments
(
    const UList<freeResistance::component>& rows
) const
{
    const scalar now = context_.time.value();
    const scalar before = now - context_.time.deltaTValue();
    scalarField dW(rows.size());
    label bodyi = -1;
    sixVector ofBody;
    forAll(rows, i)
    {
        if (rows[i].body != bodyi)
        {
            bodyi = rows[i].body;
            const string name("thermalMotion/" + context_.bodies[bodyi].name());
            ofBody =
                BrownianPath(seed_, name, interval_).increment(before, now);
        }
        dW[i] = ofBody[rows[i].axis];
    }
    return dW;
}


Foam::fsbi::outcome Foam::fsbi::thermalMotion::setResistance
(
    const freeResistance& resistance
)
{
    scalarSquareMatrix L(resistance.R);
    for (label i = 0; i < L.n(); ++i)
    {
        for (label j = 0; j < i; ++j)
        {
            L(i, j) = 0.5*(resistance.R(i, j) + resistance.R(j, i));
        }
    }
    if (!factorise(L))
    {
        return outcome::failed
        (
            "the resistance of the bodies is not positive definite: the mesh is"
            " too coarse, or the solver's tolerance (system/fluid/fvSolution)"
        );
    }
    const scalarField dW(increments(resistance.rows));
    const scalar size = sqrt(2*kT_)/context_.time.deltaTValue();
    force_ = sixVector(scalar(0));
    forAll(resistance.rows, i)
    {
        const freeResistance::component& row = resistance.rows[i];
        for (label j = 0; j <= i; ++j)
        {
            force_[row.body][row.axis] += size*L(i, j)*dW[j];
        }
    }
    return outcome();
}


void Foam::fsbi::thermalMotion::apply(loads& l) const
{
    const sixVector zero(scalar(0));
    const loads::sixMatrix none(zero);
    forAll(force_, b)
    {
        if (force_[b] != zero)
        {
            l.add(b, force_[b], none);
        }
    }
}


void Foam::fsbi::thermalMotion::declare(recording& history) const
{
    for (const immersedBody& body : context_.bodies)
    {
        if (!isA<prescribedBody>(body))
        {
            history.declare
            (
                "thermalMotion/" + body.name(),
                {"Fx", "Fy", "Fz", "Tx", "Ty", "Tz"},
                "M L/T^2, M L^2/T^2"
            );
        }
    }
}


void Foam::fsbi::thermalMotion::record(recording& history) const
{
    forAll(force_, b)
    {
        if (!isA<prescribedBody>(context_.bodies[b]))
        {
            history.append
            (
                "thermalMotion/" + context_.bodies[b].name(),
                scalarList(force_[b])
            );
        }
    }
}


void Foam::fsbi::thermalMotion::save(dictionary& state) const
{
    state.set("interval", interval_);
}


void Foam::fsbi::thermalMotion::restore(const dictionary& state)
{
    const scalar saved = state.get<scalar>("interval");
    if (given_ && interval_ != saved)
    {
        Info<< "thermalMotion goes on with the interval of the saved state, "
            << saved << nl << endl;
    }
    interval_ = saved;
}
