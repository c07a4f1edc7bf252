/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fluidRegion.H"
#include "viscosityLaw.H"
#include "bodyCoupling.H"
#include "loadCoupling.H"
#include "tractionCondition.H"
#include "syncTools.H"

Foam::fsbi::fluidRegion::fluidRegion
(
    const Time& time,
    const word& name,
    const UPtrList<rigidBody>& rigidBodies,
    UPtrList<immersedBody>& bodies,
    timings& t,
    const dictionary& savedMesh
)
:
    time_(time),
    timings_(t),
    rigidBodies_(rigidBodies),
    material_(readMaterial(time, name)),
    reduced_(reducedFlow::New(time, name, rigidBodies, bodies.size())),
    mesh_(time, name, bodies, t, savedMesh, bool(reduced_)),
    conditions_(time, mesh_),
    error_(mesh_)
{
    checkedDictionary::checkBlocks(mesh().solutionDict(), {"coupling"});
    checkedDictionary::checkBlocks(mesh().schemesDict(), {});
    if (savedMesh.size())
    {
        restore(savedMesh);
    }
    else
    {
        conditions_.read();
        createFields();
    }
    setState();
    momentum_.reset
    (
        new momentumEquation
        (
            mesh(), viscosityLaw::New(checkedDictionary(material_)),
            momentumTerm::all(mesh(), material_)
        )
    );
    if (momentum_->remembers())
    {
        confine("inertia needs earlier flows, where no cell may have been");
    }
    createOperators();
    conditions_.evaluate(U_(), stokes(), given_);      // mistakes show now
    checkReduced();
    momentum_->restore(savedMesh.subOrEmptyDict("momentum"), x_, given_);
    if (momentum_->terms().size())
    {
        Info<< "Momentum equation with: ";
        momentum_->reportNames(Info);
        Info<< nl << endl;
    }
}


Foam::dictionary Foam::fsbi::fluidRegion::readMaterial
(
    const Time& time, const word& region
)
{
    const IOdictionary material
    (
        IOobject
        (
            "material", time.caseConstant(), region, time,
            IOobject::MUST_READ, IOobject::NO_WRITE, false
        )
    );
    const checkedDictionary entries(material);
    entries.found("FoamFile");
    viscosityLaw::New(entries);
    for (const word& term : momentumTerm::names())
    {
        entries.found(term);
    }
    entries.finish();
    return material;
}


void Foam::fsbi::fluidRegion::restore(const dictionary& saved)
{
    IOobject io
    (
        "U", time_.timeName(), mesh(), IOobject::MUST_READ,
        IOobject::NO_WRITE
    );
    U_.reset(new volVectorField(io, mesh()));
    io.rename("p");
    p_.reset(new volScalarField(io, mesh()));
    conditions_.keep
    (
        U_(), saved.getOrDefault<vector>("startVelocity", Zero)
    );
    if (reduced_)
    {
        reduced_->restore(saved);
    }
}


void Foam::fsbi::fluidRegion::save(dictionary& state) const
{
    mesh_.save(state);
    if (reduced_)
    {
        reduced_->save(state);
    }
    state.set("startVelocity", conditions_.startVelocity());
    dictionary memory;
    momentum_->save(memory);
    if (memory.size())
    {
        state.set("momentum", memory);
    }
}


void Foam::fsbi::fluidRegion::createFields()
{
    IOobject io("U", time_.timeName(), mesh());
    U_.reset(new volVectorField(io, mesh(), conditions_.fieldDictionary()));
    io.rename("p");
    p_.reset
    (
        new volScalarField
        (
            io, mesh(), dimensionedScalar(dimPressure, Zero),
            calculatedFvPatchScalarField::typeName
        )
    );
}


void Foam::fsbi::fluidRegion::setState()
{
    x_.setSize(4*mesh().nCells());
    forAll(U_(), i)
    {
        const vector& u = U_()[i];
        x_[4*i] = u.x();
        x_[4*i + 1] = u.y();
        x_[4*i + 2] = u.z();
        x_[4*i + 3] = p_()[i];
    }
}


void Foam::fsbi::fluidRegion::linkBodies()
{
    const labelList& wall = stokes().wallVertices();
    bodyFaces_.setSize(mesh_.bodies().size());
    bodyVertices_.setSize(mesh_.bodies().size());

    labelList bodyOf(mesh().nPoints(), -1);
    forAll(mesh_.bodies(), b)
    {
        bodyFaces_[b].clear();
        if (mesh_.bodyPatch(b) < 0)
        {
            continue;
        }
        const polyPatch& pp = mesh().boundaryMesh()[mesh_.bodyPatch(b)];
        bodyFaces_[b] =
            identity(pp.size(), pp.start() - mesh().nInternalFaces());
        UIndirectList<label>(bodyOf, pp.meshPoints()) = b;
    }
    syncTools::syncPointList(mesh(), bodyOf, maxEqOp<label>(), label(-1));

    List<DynamicList<label>> vertices(mesh_.bodies().size());
    forAll(wall, i)
    {
        if (bodyOf[wall[i]] >= 0)
        {
            vertices[bodyOf[wall[i]]].append(i);
        }
    }
    forAll(stokes().wallEdges(), i)
    {
        const edge& e = stokes().wallEdges()[i];
        const label b = bodyOf[e.start()];
        if (b >= 0 && bodyOf[e.end()] == b)
        {
            vertices[b].append(wall.size() + i);
        }
    }
    forAll(vertices, b)
    {
        bodyVertices_[b].transfer(vertices[b]);
    }
}


void Foam::fsbi::fluidRegion::beginStep()
{
    oldX_ = x_;
    momentum_->beginStep();
}


void Foam::fsbi::fluidRegion::rewind()
{
    if (oldX_.size() == x_.size())
    {
        x_ = oldX_;
    }
    else
    {
        x_ = 0;     // the failed step has left a new mesh
    }
}


void Foam::fsbi::fluidRegion::renew
(
    const outcome& followed, const label generation
)
{
    auto timer = timings_.measure("assembly");
    if (followed && mesh_.generation() == generation)
    {
        momentum_->update();
    }
    else if (followed)
    {
        createFields();
        setState();
        createOperators();
    }
}


Foam::fsbi::outcome Foam::fsbi::fluidRegion::follow()
{
    return
        reduced_
      ? reduced_->place(rigidBodies_[0].placed())
      : followMesh();
}


Foam::fsbi::outcome Foam::fsbi::fluidRegion::followMesh()
{
    const label generation = mesh_.generation();
    const outcome followed = mesh_.follow
    (
        [this]()
        {
            if (carried_)
            {
                carried_->release();
            }
            // what stands on the mesh that is about to go
            solver_.clear();
            momentum_->release();
            error_.release();
            U_.clear();
            p_.clear();
        },
        still_
    );
    renew(followed, generation);
    if (carried_ && followed && mesh_.generation() != generation)
    {
        auto timer = timings_.profileMemory(carried_->type());
        carried_->renew();
    }
    return followed;
}


Foam::fsbi::outcome Foam::fsbi::fluidRegion::move()
{
    {
        auto timer = timings_.measure("meshing");
        mesh_.move();
        const outcome usable(mesh_.usable());
        if (!usable)
        {
            return usable;
        }
    }
    auto timer = timings_.measure("assembly");
    momentum_->update();
    return outcome();
}


Foam::fsbi::solverReport Foam::fsbi::fluidRegion::solve
(
    UList<bodyRows>& rows,
    List<sixVector>& loads
)
{
    evaluateEffects({});
    auto timer = timings_.measure("solve");
    if (reduced_)
    {
        return reduced_->solve(rows, acting_, loads);
    }
    const solverReport report
    (
        solver_->solve(problem(rows, {}), x_, traction_)
    );
    loads = bodyLoads(stokes(), rows, traction_);
    setFields(rows);
    return report;
}


void Foam::fsbi::fluidRegion::evaluateEffects
(
    const UList<elasticRows*>& elastic
)
{
    if (!effects_)
    {
        return;
    }
    acting_ = effects_->evaluate();
    forAll(elastic, e)
    {
        elastic[e]->spread(acting_.whole(nRigid() + e));
    }
}


Foam::fsbi::loads::onBodies Foam::fsbi::fluidRegion::effectForces
(
    const UList<bodyRows>& rows
) const
{
    if (!effects_)
    {
        return loads::onBodies();
    }
    List<sixVector> velocities(rows.size());
    forAll(rows, b)
    {
        velocities[b] = rows[b].velocity;
    }
    return loadCoupling::forces(acting_, rows, velocities);
}


Foam::fsbi::flowProblem Foam::fsbi::fluidRegion::problem
(
    UList<bodyRows>& rows, const UList<elasticRows*>& elastic
)
{
    forAll(rows, b)
    {
        rows[b].faces = bodyFaces_[b];
        rows[b].vertices = bodyVertices_[b];
    }
    conditions_.evaluate(U_(), stokes(), given_);
    return
    {
        given_, rows, elastic, acting_, still_,
        elastic.size() && effects_ && effects_->steep()
    };
}


void Foam::fsbi::fluidRegion::write
(
    const std::function<void(const regIOobject&)>& add
) const
{
    mesh_.write(add);
    add(U_());
    add(p_());
    momentum_->write(add);
}


void Foam::fsbi::fluidRegion::setFields(const UList<bodyRows>& rows)
{
    volVectorField& U = U_();
    volScalarField& p = p_();
    forAll(U, i)
    {
        U[i] = vector(x_[4*i], x_[4*i + 1], x_[4*i + 2]);
        p[i] = x_[4*i + 3];
    }

    const scalarField pb(stokes().boundaryPressure());
    const tensorField grad(stokes().velocityGradients());
    error_.evaluate(stokes(), grad);
    forAll(U.boundaryField(), patchi)
    {
        fvPatchVectorField& Up = U.boundaryFieldRef()[patchi];
        const fvPatch& patch = Up.patch();
        if (patch.coupled())
        {
            continue;
        }
        const label start = patch.start() - mesh().nInternalFaces();
        p.boundaryFieldRef()[patchi] = SubField<scalar>(pb, patch.size(), start);

        if (isA<tractionCondition>(Up))
        {
            const labelUList& cells = patch.faceCells();
            const vectorField db(patch.Cf() - patch.Cn());
            vectorField u(patch.size());
            forAll(u, i)
            {
                u[i] = U[cells[i]] + (db[i] & grad[cells[i]]);
            }
            Up == u;
        }
    }
    forAll(rows, b)
    {
        if (mesh_.bodyPatch(b) < 0)
        {
            continue;
        }
        fvPatchVectorField& Up =
            U.boundaryFieldRef()[mesh_.bodyPatch(b)];
        Up ==
            linear(rows[b].velocity)
          + (
                angular(rows[b].velocity)
              ^ (Up.patch().Cf() - rows[b].centre)
            );
    }
    U.correctBoundaryConditions();
    p.correctBoundaryConditions();
}
