/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Application
    fsbiTestThermalMotion

Description
    Checks of Brownian paths: parts add up, variances, independence; of random
    forces: the covariance is 2 kT R/dt of any resistance, what is given of a
    body's motion is left out; what is refused.

\*---------------------------------------------------------------------------*/

#include "boxMesh.H"
#include "checks.H"
#include "rigidBody.H"
#include "thermalMotion.H"
#include "IStringStream.H"

using namespace Foam;
using namespace Foam::fsbi;

static const scalar kT = 1.380649e-8*310;


static dictionary dictOf(const std::string& text)
{
    return dictionary(IStringStream(text)());
}


//- Two bodies in no fluid
class twoBodies
{
    autoPtr<Time> clock_;
    PtrList<rigidBody> rigid_;
    UPtrList<immersedBody> bodies_;
    autoPtr<effectContext> context_;

public:

    explicit twoBodies(const std::string& inertia = "overdamped true;")
    :
        clock_(testClock())
    {
        for (const word name : {"a", "b"})
        {
            rigid_.append
            (
                new rigidBody
                (
                    name, dictOf
                    (
                        "type rigidBody; position (0 0 0); shape { type sphere;"
                        " radius 1; size 0.45; }" + inertia
                    )
                )
            );
        }
        for (rigidBody& body : rigid_)
        {
            bodies_.append(&body);
        }
        context_.reset(new effectContext{clock_(), bodies_, {}, 1});
    }

    Time& clock() { return clock_(); }

    autoPtr<thermalMotion> make(const std::string& entries) const
    {
        return autoPtr<thermalMotion>::New(dictOf(entries), context_());
    }

    //- Forces in a step that ends at a time
    List<sixVector> forces
    (
        thermalMotion& effect,
        const freeResistance& resistance,
        const scalar time,
        const scalar dt
    )
    {
        clock_->setDeltaT(dt, false);
        clock_->setTime(time, 1);
        effect.beginStep();
        effect.setResistance(resistance);
        loads l{List<List<triFace>>(2)};
        effect.apply(l);
        return l.forces().whole;
    }
};


static scalar difference(const sixVector& a, const sixVector& b)
{
    scalar largest = 0;
    forAll(a, k)
    {
        largest = max(largest, mag(a[k] - b[k]));
    }
    return largest;
}


static sixVector sum(const sixVector& a, const sixVector& b)
{
    sixVector s(a);
    forAll(s, k)
    {
        s[k] += b[k];
    }
    return s;
}


static void checkParts(checks& c)
{
    const BrownianPath path(3, "bead", 2.5);
    const scalar times[] = {0.3, 0.31, 1.9, 2.5, 2.5000001, 7.7, 250.2, 251};
    sixVector parts(scalar(0));
    for (label i = 1; i < 8; ++i)
    {
        parts = sum(parts, path.increment(times[i - 1], times[i]));
    }
    c.checkBelow
    (
        "parts of a step add up to the whole",
        difference(parts, path.increment(0.3, 251)), 1e-12
    );
    c.checkBelow
    (
        "a path is the same whoever asks",
        difference
        (
            BrownianPath(3, "bead", 2.5).increment(1, 2), path.increment(1, 2)
        ),
        1e-300
    );
    for (const char* name : {"bead", "Bead"})
    {
        c.check
        (
            "another body or seed has another path",
            difference
            (
                BrownianPath(name[0] == 'b' ? 4 : 3, name, 2.5).increment(1, 2),
                path.increment(1, 2)
            ) > 1e-3
        );
    }
}


static void checkVariances(checks& c)
{
    // Steps as long as the interval, parts of it and across its ends
    for (const scalar dt : {2.5, 0.7, 0.011, 6.1})
    {
        const BrownianPath path(1, "bead", 2.5);
        const label n = 4000;
        scalar mean = 0, variance = 0, next = 0, other = 0;
        sixVector before(scalar(0));
        for (label i = 0; i < n; ++i)
        {
            const sixVector dW(path.increment(i*dt, (i + 1)*dt));
            forAll(dW, k)
            {
                mean += dW[k];
                variance += sqr(dW[k]);
                next += dW[k]*before[k];
                other += dW[k]*dW[(k + 1) % 6];
            }
            before = dW;
        }
        // bound: three standard deviations of 24 000 independent numbers
        const scalar N = 6*n, sigma = Foam::sqrt(1/N);
        const std::string which = "steps of " + Foam::name(dt) + ": ";
        c.checkBelow(which + "mean", mag(mean)/N/Foam::sqrt(dt), 3*sigma);
        c.checkBelow
        (
            which + "variance",
            mag(variance/N/dt - 1), 3*Foam::sqrt(2.0)*sigma
        );
        c.checkBelow(which + "one after the other", mag(next)/N/dt, 3*sigma);
        c.checkBelow(which + "components", mag(other)/N/dt, 3*sigma);
    }
}


//- Paths of many bodies: mean squares spread as those of normal numbers do
static void checkBodies(checks& c)
{
    const label bodies = 400, steps = 300, N = 6*bodies;
    scalar mean = 0, spread = 0;
    for (label body = 0; body < bodies; ++body)
    {
        const BrownianPath path
        (
            1, "thermalMotion/body" + Foam::name(body), 880
        );
        sixVector squares(scalar(0));
        for (label i = 0; i < steps; ++i)
        {
            const sixVector dW(path.increment(i*880.0, (i + 1)*880.0));
            forAll(dW, k)
            {
                squares[k] += sqr(dW[k])/880/steps;
            }
        }
        for (const scalar square : squares)
        {
            mean += square/N;
            spread += sqr(square - 1)*steps/2/N;
        }
    }
    // bound: three standard deviations; the kurtosis of a mean square is
    // 3 + 12/steps
    c.checkBelow
    (
        "bodies: mean square", mag(mean - 1), 3*Foam::sqrt(2.0/steps/N)
    );
    c.checkBelow
    (
        "bodies: its spread", mag(spread - 1),
        3*Foam::sqrt((2 + 12.0/steps)/N)
    );
    Info<< "    of bodies: mean square " << mean << ", spread over that of"
        << " normal numbers " << spread << endl;
}


//- Of the free components a resistance with no symmetry, by random numbers
static freeResistance anyResistance(const label firstFree)
{
    freeResistance r;
    for (label b = 0; b < 2; ++b)
    {
        for (direction k = 0; k < 6; ++k)
        {
            if (b > 0 || k >= firstFree)
            {
                r.rows.append({b, k});
            }
        }
    }
    const label n = r.rows.size();
    counterRandom::stream draws(counterRandom(7, "resistance").at(0, 0));
    scalarSquareMatrix A(n, n, Zero);
    r.R = A;
    for (label i = 0; i < n; ++i)
    {
        for (label j = 0; j < n; ++j)
        {
            A(i, j) = draws.uniform() - 0.5;
        }
    }
    for (label i = 0; i < n; ++i)
    {
        for (label j = 0; j < n; ++j)
        {
            for (label k = 0; k < n; ++k)
            {
                r.R(i, j) += 30*A(i, k)*A(j, k);
            }
        }
        r.R(i, i) += 5;
    }
    return r;
}


static void checkCovariance(checks& c)
{
    twoBodies bodies;
    autoPtr<thermalMotion> effect(bodies.make("temperature 310; seed 1;"));
    const freeResistance r(anyResistance(2));
    const label n = 3000, rows = r.rows.size();
    const scalar dt = 1.7;
    scalarSquareMatrix found(rows, rows, Zero);
    scalar given = 0;
    for (label step = 1; step <= n; ++step)
    {
        const List<sixVector> f(bodies.forces(effect(), r, step*dt, dt));
        given += mag(f[0][0]) + mag(f[0][1]);
        for (label i = 0; i < rows; ++i)
        {
            for (label j = 0; j < rows; ++j)
            {
                found(i, j) += f[r.rows[i].body][r.rows[i].axis]
                   *f[r.rows[j].body][r.rows[j].axis]/n;
            }
        }
    }
    scalar sum = 0, largest = 0;
    for (label i = 0; i < rows; ++i)
    {
        for (label j = 0; j <= i; ++j)
        {
            const scalar scale = 2*kT/dt;
            const scalar sigma = scale*Foam::sqrt
            (
                (r.R(i, i)*r.R(j, j) + sqr(r.R(i, j)))/n
            );
            const scalar away =
                mag(found(i, j) - scale*r.R(i, j))/sigma;
            sum += sqr(away);
            largest = max(largest, away);
        }
    }
    Info<< "    mean square of (found - 2 kT R/dt)/sigma "
        << sum/(rows*(rows + 1)/2) << ", largest " << largest << endl;
    // bound: of 55 entries, one in 400 is beyond 3 sigma, one in 3e4 beyond 4.2
    c.checkBelow("forces have the covariance 2 kT R/dt", largest, 4.2);
    c.checkBelow("what is given does not fluctuate", given, 1e-300);
}


static void checkSteps(checks& c)
{
    twoBodies bodies;
    const std::string entries = "temperature 310; seed 1; interval 2;";
    autoPtr<thermalMotion> effect(bodies.make(entries));
    const freeResistance r(anyResistance(0));
    const List<sixVector> whole(bodies.forces(effect(), r, 9, 3));
    const List<sixVector> first(bodies.forces(effect(), r, 7.1, 1.1));
    const List<sixVector> second(bodies.forces(effect(), r, 9, 1.9));
    scalar worst = 0;
    for (label b = 0; b < 2; ++b)
    {
        for (label k = 0; k < 6; ++k)
        {
            worst = max
            (
                worst,
                mag(1.1*first[b][k] + 1.9*second[b][k] - 3*whole[b][k])
            );
        }
    }
    c.checkBelow("a shorter step is on the same path", worst, 1e-14);

    autoPtr<thermalMotion> other(bodies.make("temperature 310; seed 1;"));
    dictionary state;
    effect->save(state);
    other->restore(state);
    c.checkBelow
    (
        "a restored one, too",
        difference(bodies.forces(other(), r, 9, 1.9)[1], second[1]), 1e-300
    );
    effect->rewind();
    loads l{List<List<triFace>>(2)};
    effect->apply(l);
    c.check("after a step is rejected there is nothing", l.empty());

    freeResistance bad(r);
    bad.R(3, 3) = -1;
    c.check
    (
        "a resistance that is none fails the step", !effect->setResistance(bad)
    );
}


static void checkRefused(checks& c)
{
    const twoBodies bodies, heavy("density 1;");
    c.checkFatal
    (
        "inertia is refused",
        [&]{ heavy.make("temperature 310; seed 1;"); }, "overdamped"
    );
    c.checkFatal
    (
        "no temperature is refused",
        [&]{ bodies.make("seed 1;"); }, "temperature"
    );
    c.checkFatal
    (
        "below zero, too",
        [&]{ bodies.make("temperature -3; seed 1;"); }, "temperature"
    );
    c.checkFatal
    (
        "so is a seed", [&]{ bodies.make("temperature 310; seed -1;"); }, "seed"
    );
    c.checkFatal
    (
        "an unknown word is refused",
        [&]{ bodies.make("temperature 310; seed 1; kT 1;"); }, "kT"
    );
}


int main(int argc, char *argv[])
{
    checks c;
    checkParts(c);
    checkVariances(c);
    checkBodies(c);
    checkCovariance(c);
    checkSteps(c);
    checkRefused(c);
    return c.finish();
}
