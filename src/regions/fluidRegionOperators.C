/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fluidRegion.H"
#include "volumeForces.H"

Foam::label Foam::fsbi::fluidRegion::readOrder
(
    const checkedDictionary& coupling
) const
{
    const label order = coupling.count("order", 2);
    if (order != 2 && order != 4)
    {
        FatalErrorInFunction
            << "Entry 'order' of 'coupling' in system/fluid/fvSolution is "
            << order << "; valid choices are (2 4)" << exit(FatalError);
    }
    for (const momentumTerm& term : momentum_->terms())
    {
        if (order == 4 && !isA<volumeForces>(term))
        {
            FatalErrorInFunction
                << "Order 4 of the fluid is not there with '" << term.type()
                << "' in constant/fluid/material. Give 'order 2' in 'coupling'"
                << " of system/fluid/fvSolution" << exit(FatalError);
        }
    }
    return order;
}


void Foam::fsbi::fluidRegion::createOperators()
{
    solver_.clear();
    const dictionary& coupling =
        mesh().solutionDict().subOrEmptyDict("coupling");
    checkIntegrators(coupling);
    const checkedDictionary entries(coupling);
    stokesOperator::schemes schemes;
    schemes.order = readOrder(entries);
    if (mesh_.withoutBodies())
    {
        // nobody solves on it, and order 4 has no hexahedra
        schemes.order = 2;
    }
    schemes.linearFaces =
        entries.choice
        (
            "faceValues", {"reconstructed", "linear"}, "reconstructed"
        ) == "linear";
    schemes.gradients = stokesOperator::gradientSchemes
    [
        entries.choice
        (
            "gradients", stokesOperator::gradientSchemes.names(), "vertex"
        )
    ];
    schemes.onSurface = surfaceOfBodies();
    forAll(mesh_.bodies(), b)
    {
        if (mesh_.bodies()[b].curved() && mesh_.bodyPatch(b) >= 0)
        {
            schemes.curvedPatches.append(mesh_.bodyPatch(b));
        }
    }
    momentum_->set
    (
        conditions_.velocityGiven(U_()), schemes, conditions_.resistances(U_())
    );
    linkBodies();
    createSolver();
}


Foam::fsbi::stokesOperator::schemes::described
Foam::fsbi::fluidRegion::surfaceOfBodies() const
{
    labelList bodyOf(mesh().boundaryMesh().size(), -1);
    List<bodySurface> surfaces(mesh_.bodies().size());
    forAll(mesh_.bodies(), b)
    {
        if (mesh_.bodyPatch(b) < 0)
        {
            continue;
        }
        bodyOf[mesh_.bodyPatch(b)] = b;
        const bodySurface meshed(mesh_.bodies()[b].meshedSurface());
        surfaces[b] = bodySurface().standingFor(meshed.scale(), meshed.offset());
    }
    return [=](const label patchi, const point& x, const vector& normal)
    {
        const label b = bodyOf[patchi];
        if (b < 0)
        {
            return x;
        }
        const immersedBody& body = mesh_.bodies()[b];
        if (body.hasShape())
        {
            return body.onMeshedShape(x);
        }
        // normals of the fluid's mesh point into the body
        const point centre(body.meshedPlacement().centre);
        return point(centre + surfaces[b].described(x - centre, -normal));
    };
}


void Foam::fsbi::fluidRegion::createSolver()
{
    solver_.clear();
    solver_ = fluidSolver::New
    (
        mesh(), momentum_(), mesh().solutionDict().subOrEmptyDict("coupling")
    );
}


void Foam::fsbi::fluidRegion::checkIntegrators(const dictionary& coupling) const
{
    const word method(coupling.getOrDefault<word>("method", "coupled"));
    for (const rigidBody& body : rigidBodies_)
    {
        if (body.integrator() == "semiImplicit" && method != "SIMPLEC")
        {
            FatalErrorInFunction
                << "Body '" << body.name() << "' has the integrator"
                << " 'semiImplicit', which works inside method SIMPLEC only,"
                << " but 'method' of 'coupling' in "
                << coupling.name() << " is '" << method
                << "'. Take integrator 'monolithic'" << exit(FatalError);
        }
    }
}
