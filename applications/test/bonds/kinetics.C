/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bondChecks.H"
#include "reactingSites.H"
#include "scalarList.H"

namespace Foam
{
namespace fsbi
{

//- Bonds that know nothing of each other, of constant rates
class twoStates
:
    public reactingSites
{
public:

    const scalar on, off;
    label seed = 0;
    List<waitingTime> waitingTimes;
    boolList bound;
    scalarList since;
    scalar now = 0;

    //- Sums over completed lifetimes
    scalar lived = 0, lives = 0;

    twoStates(const label n, const scalar on, const scalar off)
    :
        on(on), off(off), waitingTimes(n), bound(n, false), since(n, Zero)
    {}

    label size() const override { return bound.size(); }
    scalar rate(const label i) const override { return bound[i] ? off : on; }

    waitingTime& waitingTimeOf(const label i) override { return waitingTimes[i]; }

    counterRandom::stream draws
    (
        const label i, const label event
    ) const override
    {
        return counterRandom(seed, "pair").at(event, i);
    }

    void react
    (
        const label i, const scalar time, counterRandom::stream&
    ) override
    {
        if (bound[i])
        {
            lived += now + time - since[i];
            lives += 1;
        }
        since[i] = now + time;
        bound[i] = !bound[i];
    }

    scalar fraction() const
    {
        return scalar(std::count(bound.begin(), bound.end(), true))/size();
    }

    void run(const scalar duration, const label steps, const label chosen)
    {
        seed = chosen;
        for (label step = 0; step < steps; ++step)
        {
            advance(duration/steps);
            now += duration/steps;
        }
    }
};


//- Bonds that share a force, in units of kT/gamma and of 1/k0_off; the cluster
//  is gone when the last one breaks
class cluster
:
    public reactingSites
{
public:

    const scalar force, on;
    const counterRandom random;
    List<waitingTime> waitingTimes;
    boolList bound;
    label number;

    cluster
    (
        const label n, const scalar force, const scalar on, const label seed
    )
    :
        force(force), on(on), random(seed, "cluster"), waitingTimes(n),
        bound(n, true),
        number(n)
    {}

    label size() const override { return bound.size(); }

    waitingTime& waitingTimeOf(const label i) override { return waitingTimes[i]; }

    counterRandom::stream draws
    (
        const label i, const label event
    ) const override
    {
        return random.at(event, i);
    }

    scalar rate(const label i) const override
    {
        return number == 0 ? 0 : bound[i] ? std::exp(force/number) : on;
    }

    void react
    (
        const label i, const scalar, counterRandom::stream&
    ) override
    {
        if (number > 0)
        {
            bound[i] = !bound[i];
            number += bound[i] ? 1 : -1;
        }
    }
};


//- Is the occupancy after a time that of the exact process?
static bool occupancy
(
    const scalar error, const scalar duration, const label steps,
    scalar& value, scalar& exact, scalar& deviation
)
{
    const scalar on = 0.7, off = 0.4;
    const label n = 40000;
    twoStates bonds(n, on, off*error);
    bonds.run(duration, steps, 11);
    value = bonds.fraction();
    exact = on/(on + off)*(1 - std::exp(-(on + off)*duration));
    deviation = sqrt(exact*(1 - exact)/n);
    return agrees(value, exact, deviation);
}


// Steps in which something happens are rejected, as by a solver that finds
// them hard, and tried again at half the length, down to a shortest one
static void checkRejection(checks& c)
{
    twoStates plain(20, 0.7, 0.4);
    plain.run(10, 1, 3);
    autoPtr<twoStates> b(new twoStates(20, 0.7, 0.4));
    b->seed = 3;
    label rejected = 0;
    while (b->now < 10 - 1e-9)
    {
        for (scalar dt = min(0.5, 10 - b->now); true; dt /= 2)
        {
            autoPtr<twoStates> tried(new twoStates(b()));
            tried->advance(dt);
            if (dt < 1e-3 || tried->since == b->since)
            {
                tried->now += dt;
                b.reset(tried.release());
                break;
            }
            ++rejected;
        }
    }
    c.check
    (
        "rejected steps do not change what happens",
        rejected > 100 && plain.lives > 10 && plain.bound == b->bound
     && plain.lives == b->lives && mag(plain.lived - b->lived) < 1e-9
    );
}


static void checkOccupancy(checks& c)
{
    scalar value, exact, deviation;
    for (const label steps : {1, 7, 100})
    {
        for (const scalar duration : {0.5, 2.0, 10.0})
        {
            occupancy(1, duration, steps, value, exact, deviation);
            checkSigma
            (
                c, "occupancy at " + std::to_string(duration) + " in "
              + std::to_string(steps) + " steps", value, exact, deviation
            );
        }
    }
    twoStates once(5000, 0.7, 0.4), often(5000, 0.7, 0.4);
    once.run(10, 1, 3);
    often.run(10, 137, 3);
    c.check
    (
        "the same events however an interval is cut into steps",
        once.bound == often.bound && once.lives == often.lives
     && mag(once.lived - often.lived) < 1e-9*once.lived
    );
    c.check
    (
        "a rate wrong by a tenth is noticed",
        !occupancy(1.1, 2, 7, value, exact, deviation)
     && !occupancy(0.9, 10, 1, value, exact, deviation)
    );
}


static void checkLifetimes(checks& c)
{
    for (const label steps : {1, 1000})
    {
        // completed lives only: hardly any is cut off at the end
        twoStates bonds(200, 2, 0.4);
        bonds.run(400, steps, 5);
        const scalar mean = bonds.lived/bonds.lives;
        checkSigma
        (
            c, "lifetime in " + std::to_string(steps) + " steps", mean, 2.5,
            2.5/sqrt(bonds.lives)
        );
        c.check
        (
            "a lifetime wrong by a tenth would be noticed",
            !agrees(1.1*mean, 2.5, 2.5/sqrt(bonds.lives))
        );
    }
}


//- Mean life of clusters
static scalar meanLife
(
    const label n, const scalar force, const scalar on, const scalar dt,
    scalar& deviation
)
{
    const label samples = 2000;
    scalar sum = 0, squares = 0;
    for (label sample = 0; sample < samples; ++sample)
    {
        cluster bonds(n, force, on, sample);
        label steps = 0;
        for (; bonds.number > 0; ++steps)
        {
            bonds.advance(dt);
        }
        // gone somewhere in the last step
        const scalar life = (steps - 0.5)*dt;
        sum += life;
        squares += sqr(life);
    }
    const scalar mean = sum/samples;
    deviation = sqrt((squares/samples - sqr(mean))/samples);
    return mean;
}


// Mean first passage times of the one-step process, computed independently of
// this project by solving its linear equations: number of bonds, force and
// rate of rebinding, mean life (Erdmann, T. & Schwarz, U.S. (2004), J. Chem.
// Phys. 121, 8997, state the process)
static void checkClusters(checks& c)
{
    const scalar table[][4] =
    {
        {1, 1, 0, 0.36787944}, {2, 0, 0, 1.5}, {2, 2, 1, 0.34416854},
        {5, 0, 0, 2.2833333}, {5, 2.5, 1, 0.83958314}, {5, 5, 0, 0.25594107},
        {10, 0, 0, 2.9289683}, {10, 10, 0.5, 0.24917106}
    };
    for (const auto& row : table)
    {
        scalar deviation;
        const scalar mean =
            meanLife(label(row[0]), row[1], row[2], 2e-3*row[3], deviation);
        char name[80];
        snprintf
        (
            name, sizeof(name), "life of %g bonds, force %g, rebinding %g",
            row[0], row[1], row[2]
        );
        checkSigma(c, name, mean, row[3], deviation);
    }
}


void checkKinetics(checks& c)
{
    checkOccupancy(c);
    checkRejection(c);
    checkLifetimes(c);
    checkClusters(c);
}

} // End namespace fsbi
} // End namespace Foam
