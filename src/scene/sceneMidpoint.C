/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// Steps of bodies on which random forces act: these are made from the resistance
// where the step begins, and velocities from them at the midpoint (Fixman's
// scheme; see thermalMotion)

#include "scene.H"
#include "resistance.H"
#include "Time.H"
#include "untrapped.H"

void Foam::fsbi::scene::checkFluctuations() const
{
    if (!fluctuates())
    {
        return;
    }
    for (const momentumTerm& term : fluid_->momentum().terms())
    {
        if (term.remembers())
        {
            FatalErrorInFunction
                << "Random forces of constant/effects are those of a fluid"
                << " without memory: they do not go with '"
                << term.type().c_str() << "' of constant/fluid/material"
                << exit(FatalError);
        }
    }
}


Foam::fsbi::outcome Foam::fsbi::scene::setResistance()
{
    const List<bodyRows> rows(bodyRowsNow());
    freeResistance free;
    List<sixVector> given(rows.size());
    forAll(rows, b)
    {
        for (direction k = 0; k < 6; ++k)
        {
            given[b][k] = rows[b].free[k] ? 0 : rows[b].velocity[k];
            if (rows[b].free[k])
            {
                free.rows.append({b, k});
            }
        }
    }
    outcome solved;
    label iterations = 0;
    const auto loads = [&](const scalarField& motion)
    {
        List<sixVector> velocities(given), onBodies(rows.size());
        forAll(motion, i)
        {
            velocities[free.rows[i].body][free.rows[i].axis] = motion[i];
        }
        scalarField result(motion.size(), Zero);
        if (solved)
        {
            solved = loadsAt(velocities, onBodies);
            iterations += report_.iterations;
            forAll(result, i)
            {
                result[i] = onBodies[free.rows[i].body][free.rows[i].axis];
            }
        }
        return result;
    };
    free.R = resistanceOf(free.rows.size(), loads).R;
    report_.iterations = iterations;

    // unit velocities are no guess for those of the step
    fluid_->rewind();
    return solved ? effects_->setResistance(free) : solved;
}


Foam::fsbi::outcome Foam::fsbi::scene::placeAtMidpoint()
{
    const scalar dt = time_.deltaTValue();
    for (rigidBody& body : bodies_.rigid)
    {
        body.advance(dt, sixVector(scalar(0)), 0);
    }
    outcome done(fluid_->follow());
    if (done)
    {
        done = setResistance();
    }
    if (!done)
    {
        return done;
    }
    List<bodyRows> rows(bodyRowsNow());
    for (bodyRows& row : rows)
    {
        row.gain = 0.5*dt;
    }
    const untrapped scope;
    done = solveRows(rows);
    forAll(rows, b)
    {
        bodies_.rigid[b].advance(dt, rows[b].velocity, 0.5);
    }
    placePrescribed(0.5);
    keepClear(false);
    return done;
}


void Foam::fsbi::scene::placePrescribed(const scalar part)
{
    const scalar dt = time_.deltaTValue();
    for (prescribedBody& body : bodies_.prescribed)
    {
        if (body.present())
        {
            body.advance(time_.value() - (1 - part)*dt, part*dt);
        }
    }
}


Foam::fsbi::outcome Foam::fsbi::scene::advanceByMidpoint()
{
    outcome done(placeAtMidpoint());
    if (done)
    {
        done = fluid_->follow();
    }
    if (done)
    {
        done = solveFluid();
        takePrescribedLoads();
        placePrescribed(1);
    }
    return done;
}
