/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "SIMPLEC.H"
#include "bodyCoupling.H"
#include "checkedDictionary.H"
#include "gaussLaplacianScheme.H"
#include "linear.H"
#include "zeroGradientFvPatchFields.H"
#include "fixedValueFvPatchFields.H"

namespace Foam
{
namespace fsbi
{

//- Fatal if more than the fluid acts on the bodies
static void checkUnaided(const loads& acting)
{
    if (!acting.empty())
    {
        FatalErrorInFunction
            << "Effects that act on bodies (constant/effects) need method"
            << " 'coupled' in 'coupling' of system/fluid/fvSolution"
            << exit(FatalError);
    }
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::SIMPLEC::SIMPLEC
(
    const fvMesh& mesh,
    const momentumEquation& momentum,
    const dictionary& dict
)
:
    mesh_(mesh),
    equation_(momentum),
    stokes_(momentum.viscous()),
    closed_(true),
    residual_(4*mesh.nCells()),
    traction_(stokes_.nBoundaryFaces(), Zero)
{
    const checkedDictionary entries(dict);
    knowOthers(entries);
    tolerance_ = entries.tolerance("tolerance", 1e-6);
    maxIterations_ = entries.count("maxIterations", 2000);
    alpha_ = entries.positive("relaxation", 0.9);
    omegaImp_ = entries.getOrDefault<scalar>("omegaImp", 0);
    entries.finish();
    if (alpha_ >= 1)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'relaxation' must be below 1, but is " << alpha_
            << exit(FatalIOError);
    }
    closed_ = stokes_.closed();
}


Foam::wordList Foam::fsbi::SIMPLEC::correctionTypes
(
    const word& whereVelocityGiven
) const
{
    const word fixed(fixedValueFvPatchScalarField::typeName);
    const word free(zeroGradientFvPatchScalarField::typeName);
    wordList types(mesh_.boundary().size(), free);
    forAll(types, patchi)
    {
        const polyPatch& pp = mesh_.boundaryMesh()[patchi];
        const label i = pp.start() - mesh_.nInternalFaces();
        const bool given =
            pp.size() && !pp.coupled() && stokes_.velocityGiven()[i];
        types[patchi] =
            given == (whereVelocityGiven == fixed) ? fixed : free;
    }
    return types;
}


Foam::dictionary Foam::fsbi::SIMPLEC::solverDict(const word& field) const
{
    const dictionary* given =
        mesh_.solutionDict().subOrEmptyDict("solvers").findDict(field);
    if (given)
    {
        return *given;
    }
    dictionary dict;
    dict.set("solver", word(field == "p" ? "GAMG" : "smoothSolver"));
    dict.set("smoother", word("symGaussSeidel"));
    dict.set("relTol", 0.1);
    dict.set("tolerance", 0);
    return dict;
}


void Foam::fsbi::SIMPLEC::createMatrices()
{
    const auto io = [&](const word& name)
    {
        return IOobject(name, mesh_.time().timeName(), mesh_);
    };
    const word fixed(fixedValueFvPatchScalarField::typeName);
    const word free(zeroGradientFvPatchScalarField::typeName);
    du_.reset
    (
        new volVectorField
        (
            io("velocityCorrection"), mesh_, dimensionedVector(dimless, Zero),
            correctionTypes(fixed)
        )
    );
    dp_.reset
    (
        new volScalarField
        (
            io("pressureCorrection"), mesh_, dimensionedScalar(dimless, Zero),
            correctionTypes(free)
        )
    );

    createMomentum();

    volScalarField D
    (
        io("D"), mesh_, dimensionedScalar(dimless, Zero), free
    );
    D.primitiveFieldRef() = mesh_.V()*reciprocal_;
    D.correctBoundaryConditions();
    continuity_.reset
    (
        (
           -fv::gaussLaplacianScheme<scalar, scalar>::fvmLaplacianUncorrected
            (
                Foam::linear<scalar>(mesh_).interpolate(D)*mesh_.magSf(),
                mesh_.nonOrthDeltaCoeffs(), dp_()
            )
        ).ptr()
    );
    if (closed_)
    {
        continuity_->setReference(0, 0);
    }
}


void Foam::fsbi::SIMPLEC::createMomentum()
{
    momentum_.reset
    (
        (
           -fv::gaussLaplacianScheme<vector, scalar>::fvmLaplacianUncorrected
            (
                stokes_.mu()*mesh_.magSf(), mesh_.nonOrthDeltaCoeffs(), du_()
            )
        ).ptr()
    );
    if (equation_.massRate().size())
    {
        momentum_->diag() += equation_.massRate();
    }
    scalarField diagonal(momentum_->D());
    scalarField offDiagonal(mesh_.nCells(), Zero);
    momentum_->sumMagOffDiag(offDiagonal);
    reciprocal_ = 1/(diagonal/alpha_ - offDiagonal);
    momentum_->diag() += (1/alpha_ - 1)*diagonal;
}


void Foam::fsbi::SIMPLEC::correctVelocity(scalarList& x)
{
    du_() = dimensionedVector(dimless, Zero);
    forAll(momentum_->source(), i)
    {
        const scalar* r = residual_.cdata() + 4*i;
        momentum_->source()[i] = -vector(r[0], r[1], r[2]);
    }
    momentum_->solve(solverDict("U"));
    forAll(du_(), i)
    {
        x[4*i] += du_()[i].x();
        x[4*i + 1] += du_()[i].y();
        x[4*i + 2] += du_()[i].z();
    }
}


void Foam::fsbi::SIMPLEC::correctPressure(scalarList& x)
{
    dp_() = dimensionedScalar(dimless, Zero);
    forAll(continuity_->source(), i)
    {
        continuity_->source()[i] = -residual_[4*i + 3];
    }
    continuity_->solve(solverDict("p"));

    const surfaceScalarField dpf(Foam::linear<scalar>(mesh_).interpolate(dp_()));
    vectorField force(mesh_.nCells(), Zero);
    forAll(mesh_.owner(), facei)
    {
        const vector f(dpf[facei]*mesh_.faceAreas()[facei]);
        force[mesh_.owner()[facei]] += f;
        force[mesh_.neighbour()[facei]] -= f;
    }
    for (const fvsPatchScalarField& pf : dpf.boundaryField())
    {
        forAll(pf, i)
        {
            force[pf.patch().faceCells()[i]] += pf[i]*pf.patch().Sf()[i];
        }
    }
    forAll(force, i)
    {
        const vector du(reciprocal_[i]*force[i]);
        x[4*i] -= du.x();
        x[4*i + 1] -= du.y();
        x[4*i + 2] -= du.z();
        x[4*i + 3] += dp_()[i];
    }
}


void Foam::fsbi::SIMPLEC::wallResistance
(
    const bodyRows& body,
    scalar& drag,
    scalar& torque
) const
{
    drag = 0;
    torque = 0;
    for (const label i : body.faces)
    {
        const label facei = mesh_.nInternalFaces() + i;
        const point& x = mesh_.faceCentres()[facei];
        const vector& S = mesh_.faceAreas()[facei];
        const vector d(x - mesh_.cellCentres()[mesh_.faceOwner()[facei]]);
        const scalar k =
            stokes_.mu()*stokes_.stencil().wallWeight()[i]*magSqr(S)/(d & S);
        drag += k;
        torque += k*2.0/3.0*magSqr(x - body.centre);
    }
    reduce(drag, sumOp<scalar>());
    reduce(torque, sumOp<scalar>());
}


void Foam::fsbi::SIMPLEC::relaxBodies
(
    const UList<bodyRows>& bodies,
    List<sixVector>& v
) const
{
    const List<sixVector> defects
    (
        bodyDefects(bodies, v, bodyLoads(stokes_, bodies, traction_))
    );
    forAll(bodies, b)
    {
        const bodyRows& body = bodies[b];
        const scalar m = body.massRate;
        const scalar I = tr(body.inertiaRate)/3;
        const bool given = omegaImp_ > 0 && m > 0 && I > 0;
        scalar drag = 0, torque = 0;
        if (!given)
        {
            wallResistance(body, drag, torque);
        }
        const scalar perForce = given ? omegaImp_/m : 1/(m + drag);
        const scalar perTorque = given ? omegaImp_/I : 1/(I + torque);
        for (label k = 0; k < 6; ++k)
        {
            v[b][k] +=
                body.free[k]
              ? (k < 3 ? perForce : perTorque)*defects[b][k]
              : defects[b][k];
        }
    }
}


void Foam::fsbi::SIMPLEC::evaluate
(
    const boundaryValues& given,
    const UList<bodyRows>& bodies,
    const UList<sixVector>& v,
    const scalarList& x
)
{
    values_ = given;
    setBodyVelocities(stokes_, bodies, v, values_);
    equation_.residual(x.cdata(), values_, residual_.data(), traction_);
}


Foam::scalar Foam::fsbi::SIMPLEC::norm
(
    const UList<bodyRows>& bodies,
    const UList<sixVector>& v
) const
{
    scalarList scaled(residual_);
    scales_.apply(scaled.begin());
    scalar sum = 0;
    for (const scalar r : scaled)
    {
        sum += sqr(r);
    }
    reduce(sum, sumOp<scalar>());

    const List<sixVector> defects
    (
        bodyDefects(bodies, v, bodyLoads(stokes_, bodies, traction_))
    );
    forAll(defects, b)
    {
        forAll(defects[b], k)
        {
            sum += sqr(scales_.bodies()[b][k]*defects[b][k]);
        }
    }
    return Foam::sqrt(sum);
}


Foam::fsbi::solverReport Foam::fsbi::SIMPLEC::solve
(
    const flowProblem& problem, scalarList& x, vectorField& traction
)
{
    checkUnaided(problem.acting);
    const boundaryValues& given = problem.given;
    UList<bodyRows>& bodies = problem.bodies;

    // silent linear solvers: their number would bury the run's own lines
    const int shown = SolverPerformance<scalar>::debug;
    SolverPerformance<scalar>::debug = 0;
    SolverPerformance<vector>::debug = 0;

    createMatrices();
    scales_ = rowScales(equation_, bodies);
    List<sixVector> v(bodies.size(), sixVector(scalar(0)));
    evaluate(given, bodies, v, scalarList(x.size(), Zero));
    const scalar atRest = max(norm(bodies, v), VSMALL);
    forAll(v, b)
    {
        v[b] = bodies[b].velocity;
    }

    solverReport report;
    for (; report.iterations <= maxIterations_; ++report.iterations)
    {
        evaluate(given, bodies, v, x);
        report.residual = norm(bodies, v)/atRest;
        report.converged = report.residual < tolerance_;
        if (report.converged || !(report.residual < 1e6))
        {
            break;
        }
        relaxBodies(bodies, v);
        correctVelocity(x);
        evaluate(given, bodies, v, x);
        correctPressure(x);
    }

    forAll(v, b)
    {
        bodies[b].velocity = v[b];
    }
    traction = traction_;
    SolverPerformance<scalar>::debug = shown;
    SolverPerformance<vector>::debug = shown;
    return report;
}
