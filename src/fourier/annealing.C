/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "annealing.H"

#include <gsl/gsl_rng.h>
#include <gsl/gsl_siman.h>

#include <memory>

//- Stages: the last one's steps are 2^-17 of the first's
static const int nStages = 18;

namespace Foam
{
namespace fsbi
{

//- What GSL carries around
struct annealedPoint
{
    scalarList x;
    const std::function<scalar(const scalarList&)>* cost;
    const scalarMinMax* limits;
};

static annealedPoint& point(void* p)
{
    return *static_cast<annealedPoint*>(p);
}

static double energy(void* p)
{
    return (*point(p).cost)(point(p).x);
}

// One factor at a time, or all: narrow valleys need both
static void move(const gsl_rng* random, void* p, double size)
{
    annealedPoint& here = point(p);
    const label n = here.x.size();
    const label only = gsl_rng_uniform_int(random, 2*n);
    forAll(here.x, i)
    {
        if (only >= n || only == i)
        {
            const scalar change = size*(2*gsl_rng_uniform(random) - 1);
            here.x[i] = here.limits->clip(here.x[i]*exp(change));
        }
    }
}

static double distance(void* a, void* b)
{
    scalar sum = 0;
    forAll(point(a).x, i)
    {
        sum += mag(point(a).x[i] - point(b).x[i]);
    }
    return sum;
}

static void copy(void* from, void* to)
{
    point(to) = point(from);
}

static void* clone(void* p)
{
    return new annealedPoint(point(p));
}

static void destroy(void* p)
{
    delete static_cast<annealedPoint*>(p);
}

} // End namespace fsbi
} // End namespace Foam


Foam::scalarList Foam::fsbi::annealed
(
    const scalarList& start,
    const std::function<scalar(const scalarList&)>& cost,
    const scalarMinMax& limits,
    const unsigned long seed
)
{
    const std::unique_ptr<gsl_rng, decltype(&gsl_rng_free)> random
    (
        gsl_rng_alloc(gsl_rng_taus2), gsl_rng_free
    );
    gsl_rng_set(random.get(), seed);
    annealedPoint best{start, &cost, &limits};
    scalar size = 0.5, temperature = 1e-2;
    for (int stage = 0; stage < nStages; ++stage)
    {
        // tries, moves per temperature, size, k, first T, fall of T, last T
        const gsl_siman_params_t parameters =
            {1, 20*int(start.size()), size, 1, temperature, 1.3, 0.01*temperature};
        gsl_siman_solve
        (
            random.get(), &best, energy, move, distance, nullptr,
            copy, clone, destroy, 0, parameters
        );
        size /= 2;
        temperature /= 10;
    }
    return best.x;
}
