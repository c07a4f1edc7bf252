/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "partitioned.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{

defineTypeNameAndDebug(partitioned, 0);

addNamedToRunTimeSelectionTable(couplingScheme, partitioned, entries, explicit);
addNamedToRunTimeSelectionTable
(
    couplingScheme, partitioned, entries, semiImplicit
);
addNamedToRunTimeSelectionTable(couplingScheme, partitioned, entries, Aitken);
addNamedToRunTimeSelectionTable(couplingScheme, partitioned, entries, IQNILS);


static scalar largest(const volVectorField& u)
{
    scalar result = gMax(mag(u.primitiveField())());
    for (const fvPatchVectorField& up : u.boundaryField())
    {
        result = max(result, gMax(mag(up)()));
    }
    return result;
}

} // End namespace fsbi
} // End namespace Foam

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::partitioned::partitioned
(
    fluidRegion& fluid,
    UPtrList<solidRegion>& solids,
    const dictionary& dict
)
:
    couplingScheme(fluid, solids, dict),
    passes_(passesOf(dict)),
    entries_(passes_),
    loop_(entries_),
    robin_(entries_.positive("robin", 1.5)),
    springs_(solids.size()),
    effects_(solids.size())
{
    entries_.finish();
    checkParts();
    startLoop();
}


Foam::dictionary Foam::fsbi::partitioned::passesOf(const dictionary& dict)
{
    dictionary passes(dict.subOrEmptyDict("passes"));
    if (passes.found("method"))
    {
        FatalIOErrorInFunction(passes)
            << "The method of the passes is the entry 'scheme' of 'coupling';"
            << " there is no 'method' in 'passes'" << exit(FatalIOError);
    }
    passes.set("method", dict.get<word>("scheme"));
    return passes;
}


void Foam::fsbi::partitioned::checkParts() const
{
    if (fluid_.stokes().closed())
    {
        FatalErrorInFunction
            << "Elastic bodies in a fluid without a boundary of given traction"
            << " need the scheme 'monolithic' in 'coupling' of"
            << " system/fluid/fvSolution" << exit(FatalError);
    }
    for (const elasticRows* body : elastic_)
    {
        if (body->tethered() || body->elastic->state().material().flows())
        {
            FatalErrorInFunction
                << "Tethered bodies and those of a liquid need the scheme"
                << " 'monolithic' in 'coupling' of system/fluid/fvSolution"
                << exit(FatalError);
        }
    }
}


void Foam::fsbi::partitioned::startLoop()
{
    const scalarField x(surfaces());
    // root mean square of vectors, which all processors hold whole
    loop_.start
    (
        scalarField(x.size(), 3/(max(x.size(), 1)*scalar(Pstream::nProcs())))
    );
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalarField Foam::fsbi::partitioned::surfaces() const
{
    label n = 0;
    for (const solidRegion& solid : solids_)
    {
        n += 3*solid.surface().displacement().size();
    }
    scalarField x(n);
    scalar* at = x.begin();
    for (const solidRegion& solid : solids_)
    {
        const vectorField& d = solid.surface().displacement();
        at = std::copy_n(d.cdata()->v_, 3*d.size(), at);
    }
    return x;
}


Foam::List<Foam::vectorField> Foam::fsbi::partitioned::parted
(
    const scalarField& x
) const
{
    List<vectorField> d(solids_.size());
    const scalar* at = x.begin();
    forAll(d, e)
    {
        d[e].setSize(solids_[e].surface().displacement().size());
        std::copy_n(at, 3*d[e].size(), d[e].begin()->v_);
        at += 3*d[e].size();
    }
    return d;
}


Foam::scalar Foam::fsbi::partitioned::scale() const
{
    scalar rate = 0;
    for (const elasticRows* body : elastic_)
    {
        rate = max(rate, body->velocityCoeff);
    }
    // before a flow at rest has begun to move, a length will do
    const scalar speed = largest(fluid_.U());
    return speed > 0 ? speed/rate : fluid_.mesh().bounds().mag();
}


Foam::fsbi::boundarySpring Foam::fsbi::partitioned::spring
(
    const label solidi, const vectorField& given
) const
{
    const elasticRows& body = *elastic_[solidi];
    const fvMesh& mesh = solids_[solidi].mesh();
    const label inner = mesh.nInternalFaces();
    scalarField area(body.elastic->boundary().kinds().size(), 0);
    for (const label i : body.solid.faces)
    {
        area[i] = mag(mesh.faceAreas()[inner + i]);
    }
    const scalar radius = 3*gSum(mesh.V().field())/gSum(area);

    boundarySpring s;
    s.stiffness =
        (robin_*fluid_.stokes().mu()/radius*body.velocityCoeff)*area*tensor::I;
    if (fluid_.acting().onElastic())
    {
        body.solid.addToFaces
        (
            fluid_.acting().springStiffness(fluid_.nRigid() + solidi),
            s.stiffness
        );
    }
    vectorField d(area.size(), Zero);
    body.solid.spreadFaces
    (
        vectorField
        (
            surfaceDisplacement::split(given, body.solid).faces
          - body.movedFaces
        ),
        d
    );
    s.load =
        body.surfaceForce(body.fluidForces(fluid_.traction()))
      + effects_[solidi]
      + (s.stiffness & d);
    return s;
}


Foam::vectorField Foam::fsbi::partitioned::fluidForce(const label solidi) const
{
    const vectorField all
    (
        springs_[solidi].force
        (
            elastic_[solidi]->elastic->surfaceDisplacement()
        )
    );
    return all - effects_[solidi];
}


Foam::fsbi::outcome Foam::fsbi::partitioned::solveFluid
(
    const List<vectorField>& given, List<bodyRows>& rows
)
{
    const solverReport report(fluid_.solve(rows, elastic_, given));
    report_.iterations += report.iterations;
    return
        report.converged
      ? outcome()
      : outcome::failed
        (
            "the flow's solver reached a residual of " + name(report.residual)
          + " only, in " + name(report.iterations) + " iterations"
        );
}


Foam::fsbi::outcome Foam::fsbi::partitioned::solveSolids
(
    const List<vectorField>& given, const List<bodyRows>& rows
)
{
    List<vectorField> none;         // of contact, which needs monolithic
    effects_ = effectForces(rows, none);
    forAll(solids_, e)
    {
        springs_[e] = spring(e, given[e]);
        solverReport report;
        const outcome solved(solids_[e].solve(springs_[e], report));
        if (!solved)
        {
            return solved;
        }
        report_.iterations += report.iterations;
        if (!solids_[e].follow())
        {
            return outcome::failed
            (
                "body '" + solids_[e].name() + "' is turned inside out"
            );
        }
    }
    return outcome();
}


Foam::fsbi::outcome Foam::fsbi::partitioned::pass
(
    const scalarField& x, scalarField& Hx, List<bodyRows>& rows
)
{
    const List<vectorField> given(parted(x));
    forAll(solids_, e)
    {
        solids_[e].surface().place(given[e]);
    }
    const outcome moved(moveMesh());
    if (!moved)
    {
        return moved;
    }
    outcome solved(solveFluid(given, rows));
    if (solved)
    {
        solved = solveSolids(given, rows);
    }
    Hx = surfaces();
    return solved;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::fsbi::outcome Foam::fsbi::partitioned::solve(List<bodyRows>& rows)
{
    scalarField x(surfaces());
    const solverReport report
    (
        loop_.solve
        (
            [&](const scalarField& given, scalarField& answer)
            {
                return pass(given, answer, rows);
            },
            scale(), x
        )
    );
    report_.corrections = report.iterations;
    report_.residual = report.residual;
    report_.converged = report.converged;
    if (report.converged)
    {
        return outcome();
    }
    return outcome::failed
    (
        report.failure.size()
      ? report.failure
      : string
        (
            "fluid and bodies do not agree after " + name(report.iterations)
          + " passes: the residual is " + name(report.residual)
        )
    );
}


void Foam::fsbi::partitioned::restore(const dictionary& state)
{
    // a state of the monolithic scheme has nothing for passes
    if (state.found("method"))
    {
        loop_.restore(state);
    }
}
