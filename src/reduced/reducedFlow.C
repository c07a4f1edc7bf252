/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "reducedFlow.H"
#include "IOdictionary.H"
#include "loadCoupling.H"

namespace Foam
{
namespace fsbi
{

static sixVector product(const scalarSquareMatrix& A, const sixVector& v)
{
    sixVector result(scalar(0));
    for (label i = 0; i < 6; ++i)
    {
        for (label j = 0; j < 6; ++j)
        {
            result[i] += A(i, j)*v[j];
        }
    }
    return result;
}


//- Motion under loads
static sixVector motion(scalarSquareMatrix R, const sixVector& load)
{
    scalarField x(6);
    std::copy_n(load.begin(), 6, x.begin());
    LUsolve(R, x);
    sixVector result;
    std::copy_n(x.begin(), 6, result.begin());
    return result;
}


//- As a velocity of the surface
static scalar size(const sixVector& v, const scalar radius)
{
    return mag(linear(v)) + radius*mag(angular(v));
}

} // End namespace fsbi
} // End namespace Foam


Foam::autoPtr<Foam::fsbi::reducedFlow> Foam::fsbi::reducedFlow::New
(
    const Time& time,
    const word& region,
    const UPtrList<rigidBody>& bodies,
    const label nBodies
)
{
    const IOdictionary solution
    (
        IOobject
        (
            "fvSolution", time.caseSystem(), region, time,
            IOobject::READ_IF_PRESENT, IOobject::NO_WRITE, false
        )
    );
    const dictionary coupling(solution.subOrEmptyDict("coupling"));
    if (coupling.getOrDefault<word>("method", "coupled") != "reduced")
    {
        return autoPtr<reducedFlow>();
    }
    if (bodies.size() != 1 || nBodies != 1)
    {
        FatalIOErrorInFunction(solution)
            << "Entry 'method' is 'reduced', which is for scenes of one rigid"
            << " body; constant/bodies has " << nBodies
            << " bodies. Valid choices are here (coupled SIMPLEC)"
            << exit(FatalIOError);
    }
    const dictionary own(coupling.subOrEmptyDict("reduced"));
    const checkedDictionary entries(own);
    autoPtr<reducedFlow> flow(new reducedFlow(time, bodies, entries));
    entries.finish();
    return flow;
}


Foam::fsbi::reducedFlow::reducedFlow
(
    const Time& time,
    const UPtrList<rigidBody>& bodies,
    const checkedDictionary& entries
)
:
    table_
    (
        time.globalPath()
       /entries.getOrDefault<fileName>("table", "constant/reduced.h5"),
        bodies[0].name(), caseFingerprint(time, bodies), flowFingerprint(time)
    ),
    every_(entries.found("check") ? entries.count("check", 1) : 0),
    tolerance_(entries.tolerance("tolerance", 0.05))
{
    const outcome placed(place(bodies[0].placed()));
    if (!placed)
    {
        FatalErrorInFunction
            << "At the start " << placed.reason.c_str() << exit(FatalError);
    }
    Info<< "Flow: reduced, from a table of gaps of " << table_.lowest()
        << " to " << table_.highest() << ", to " << 100*table_.error()
        << " %; it is not solved, its fields "
        << (every_ ? "are those of the last check" : "stay as they are")
        << nl << endl;
}


Foam::fsbi::outcome Foam::fsbi::reducedFlow::place(const placement& p)
{
    return table_.at(p, held_);
}


void Foam::fsbi::reducedFlow::assemble
(
    const UList<bodyRows>& rows,
    const loads& acting,
    scalarSquareMatrix& A,
    scalarField& b
) const
{
    const bodyRows& body = rows[0];
    List<sixVector> v(1, sixVector(scalar(0)));
    const auto effects = [&]()
    {
        return
            acting.empty()
          ? sixVector(scalar(0))
          : loadCoupling::forces(acting, rows, v).whole[0];
    };
    const sixVector atRest(effects());
    for (label j = 0; j < 6; ++j)
    {
        v[0][j] = 1;
        const sixVector moved(effects());
        const sixVector inertia
        (
            join
            (
                body.massRate*linear(v[0]), body.inertiaRate & angular(v[0])
            )
        );
        v[0][j] = 0;
        for (label i = 0; i < 6; ++i)
        {
            A(i, j) =
                body.free[i]
              ? inertia[i] + held_.R(i, j) - (moved[i] - atRest[i])
              : scalar(i == j);
        }
    }
    for (label i = 0; i < 6; ++i)
    {
        b[i] =
            body.free[i]
          ? body.rhs[i] + held_.flow[i] + atRest[i]
          : body.velocity[i];
    }
}


Foam::fsbi::solverReport Foam::fsbi::reducedFlow::solve
(
    UList<bodyRows>& rows, const loads& acting, List<sixVector>& onBodies
) const
{
    scalarSquareMatrix A(6, 6, Zero);
    scalarField x(6);
    assemble(rows, acting, A, x);
    LUsolve(A, x);
    std::copy_n(x.begin(), 6, rows[0].velocity.begin());

    onBodies = List<sixVector>(1, held_.flow);
    const sixVector drag(product(held_.R, rows[0].velocity));
    solverReport report;
    report.converged = true;
    forAll(drag, k)
    {
        onBodies[0][k] -= drag[k];
        report.converged = report.converged && std::isfinite(drag[k]);
    }
    return report;
}


void Foam::fsbi::reducedFlow::compare
(
    const bodyRows& rows, const sixVector& full
) const
{
    sixVector missed(product(held_.R, rows.velocity));
    forAll(missed, k)
    {
        missed[k] += full[k] - held_.flow[k];
    }
    const scalar scale =
        size(rows.velocity, rows.radius)
      + size(motion(held_.R, held_.flow), rows.radius);
    const scalar difference =
        size(motion(held_.R, missed), rows.radius)/max(scale, VSMALL);
    Info<< "Check: a full solution differs by " << 100*difference
        << " % of the velocity, gap " << held_.gap << endl;
    if (difference > tolerance_)
    {
        FatalErrorInFunction
            << "A full solution differs by " << 100*difference << " % of the"
            << " velocity from method 'reduced', more than its tolerance of "
            << 100*tolerance_ << " % (system/fluid/fvSolution), at a gap of "
            << held_.gap << ". More samples (gaps, angles of"
            << " system/reduceDict) may help; near the ends of the domain, or in"
            << " a flow that changes along the wall or with time, they do not"
            << exit(FatalError);
    }
}
