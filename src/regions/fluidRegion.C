/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fluidRegion.H"
#include "tractionFvPatchVectorField.H"
#include "velocityProfile.H"
#include "IFstream.H"
#include "IStringStream.H"
#include "OStringStream.H"
#include "PrimitivePatchInterpolation.H"
#include "syncTools.H"

namespace Foam
{
namespace fsbi
{

//- Net flux over the gross one that is a rounding of profiles on faces, to be
//  spread out, rather than a mistake
static const scalar acceptedImbalance = 0.01;

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::fluidRegion::fluidRegion
(
    const Time& time,
    const PtrList<rigidBody>& bodies,
    timings& t,
    const dictionary& savedMesh
)
:
    time_(time),
    timings_(t),
    mu_(readViscosity(time)),
    mesh_(time, bodies, t, savedMesh)
{
    if (savedMesh.size())
    {
        readFields();
    }
    else
    {
        boundaryConditions_ = startDictionary();
        createFields();
    }
    setState();
    createOperators();
    setGiven();             // what is wrong with it shows before the run
}


Foam::scalar Foam::fsbi::fluidRegion::readViscosity(const Time& time)
{
    const IOdictionary material
    (
        IOobject
        (
            "material", time.caseConstant(), "fluid", time,
            IOobject::MUST_READ, IOobject::NO_WRITE, false
        )
    );
    const checkedDictionary entries(material);
    entries.found("FoamFile");
    entries.choice("type", {"Newtonian"});
    const scalar viscosity = entries.positive("viscosity");
    entries.finish();
    return viscosity;
}


Foam::dictionary Foam::fsbi::fluidRegion::startDictionary() const
{
    dictionary dict;
    const fileName file(time_.globalPath()/time_.timeName()/"fluid"/"U");
    if (Pstream::master())
    {
        IFstream is(file);
        IOobject header("U", time_.timeName(), "fluid", time_);
        if (!is.good() || !header.readHeader(is))
        {
            FatalErrorInFunction
                << "The velocity field " << file << " is missing, or has no"
                << " header; it gives the boundary conditions"
                << exit(FatalError);
        }
        dict = dictionary(is);
    }
    Pstream::scatter(dict);
    dict.name() = file;

    // values of an earlier mesh, where the condition knows better
    for (entry& e : dict.subDict("boundaryField"))
    {
        const entry* value =
            e.isDict() ? e.dict().findEntry("value") : nullptr;
        if
        (
            value && value->isStream()
         && value->stream().size()
         && value->stream()[0] == token(word("nonuniform"))
         && e.dict().getOrDefault<word>("type", "") != "fixedValue"
        )
        {
            e.dict().remove("value");
        }
    }
    return dict;
}


Foam::dictionary Foam::fsbi::fluidRegion::presentDictionary() const
{
    dictionary patches;
    for (const fvPatchVectorField& pf : U_().boundaryField())
    {
        if (pf.coupled() || mesh_.isBody(pf.patch().name()))
        {
            continue;
        }
        OStringStream os;
        os.precision(17);
        pf.write(os);
        dictionary entry(IStringStream(os.str())());
        entry.remove("value");
        if (pf.type() == fixedValueFvPatchVectorField::typeName)
        {
            // a plain value lasts through remeshing where it is uniform
            OStringStream value;
            value.precision(17);
            value << "value uniform " << gAverage(pf) << ";";
            entry.read(IStringStream(value.str())(), false);
        }
        patches.set(pf.patch().name(), entry);
    }
    dictionary dict
    (
        IStringStream("dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0);")()
    );
    dict.set("boundaryField", patches);
    return dict;
}


void Foam::fsbi::fluidRegion::addMeshPatches(dictionary& patches) const
{
    for (const polyPatch& pp : mesh().boundaryMesh())
    {
        const bool body = mesh_.isBody(pp.name());
        if (body || pp.coupled())
        {
            const word type(body ? word("fixedValue") : pp.type());
            dictionary entry
            (
                IStringStream("type " + type + "; value uniform (0 0 0);")()
            );
            // set() would overwrite a pattern that matches the name
            patches.remove(pp.name());
            patches.add(pp.name(), entry);
        }
    }
}


void Foam::fsbi::fluidRegion::readFields()
{
    IOobject io
    (
        "U", time_.timeName(), mesh(), IOobject::MUST_READ,
        IOobject::NO_WRITE
    );
    U_.reset(new volVectorField(io, mesh()));
    io.rename("p");
    p_.reset(new volScalarField(io, mesh()));
    boundaryConditions_ = presentDictionary();
}


void Foam::fsbi::fluidRegion::createFields()
{
    IOobject io("U", time_.timeName(), mesh());
    dictionary dict(boundaryConditions_);
    addMeshPatches(dict.subDict("boundaryField"));
    U_.reset(new volVectorField(io, mesh(), dict));
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
    checkPatches();
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


void Foam::fsbi::fluidRegion::checkPatches() const
{
    for (const fvPatchVectorField& pf : U_().boundaryField())
    {
        if (!pf.fixesValue() && !pf.coupled())
        {
            FatalErrorInFunction
                << "Patch '" << pf.patch().name() << "' of field U in region"
                << " fluid has the boundary condition '" << pf.type()
                << "'; give a velocity (fixedValue, uniformFixedValue,"
                << " linearShear, Poiseuille, StokesSphere), 'traction' or"
                << " 'cyclic'" << exit(FatalError);
        }
    }
}


Foam::boolList Foam::fsbi::fluidRegion::velocityGiven() const
{
    boolList given(mesh().nFaces() - mesh().nInternalFaces(), false);
    bool any = false;
    for (const fvPatchVectorField& pf : U_().boundaryField())
    {
        const fvPatch& patch = pf.patch();
        const label start = patch.start() - mesh().nInternalFaces();
        if (!patch.coupled() && !isA<tractionFvPatchVectorField>(pf))
        {
            any = true;
            SubList<bool>(given, patch.size(), start) = true;
        }
    }
    if (!any)
    {
        FatalErrorInFunction
            << "No patch of field U in region fluid gives a velocity:"
            << " the flow is not determined" << exit(FatalError);
    }
    return given;
}


void Foam::fsbi::fluidRegion::linkBodies()
{
    const labelList& wall = stokes_->wallVertices();
    bodyFaces_.setSize(mesh_.bodies().size());
    bodyVertices_.setSize(mesh_.bodies().size());

    labelList bodyOf(mesh().nPoints(), -1);
    forAll(mesh_.bodies(), b)
    {
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
    forAll(vertices, b)
    {
        bodyVertices_[b].transfer(vertices[b]);
    }
}


void Foam::fsbi::fluidRegion::createOperators()
{
    solver_.clear();
    const dictionary& coupling =
        mesh().solutionDict().subOrEmptyDict("coupling");
    checkIntegrators(coupling);
    const bool linearFaces =
        checkedDictionary(coupling).choice
        (
            "faceValues", {"reconstructed", "linear"}, "reconstructed"
        ) == "linear";
    stokes_.reset
    (
        new stokesOperator(mesh(), mu_, velocityGiven(), linearFaces)
    );
    linkBodies();
    createSolver();
}


void Foam::fsbi::fluidRegion::createSolver()
{
    solver_.clear();
    solver_ = fluidSolver::New
    (
        mesh(), stokes_(), mesh().solutionDict().subOrEmptyDict("coupling")
    );
}


void Foam::fsbi::fluidRegion::checkIntegrators(const dictionary& coupling) const
{
    const word method(coupling.getOrDefault<word>("method", "coupled"));
    for (const rigidBody& body : mesh_.bodies())
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


bool Foam::fsbi::fluidRegion::follow(string& reason)
{
    const auto outcome = mesh_.follow
    (
        reason,
        [this]()
        {
            // what stands on the mesh that is about to go
            solver_.clear();
            stokes_.clear();
            U_.clear();
            p_.clear();
        }
    );
    auto timer = timings_.measure("assembly");
    if (outcome == fluidMesh::outcome::moved)
    {
        stokes_->update();
    }
    else if (outcome == fluidMesh::outcome::remeshed)
    {
        createFields();
        setState();
        createOperators();
    }
    return outcome != fluidMesh::outcome::failed;
}


void Foam::fsbi::fluidRegion::setGiven()
{
    given_.faces.setSize(stokes_->nBoundaryFaces());
    given_.faces = Zero;
    U_->boundaryFieldRef().updateCoeffs();
    for (const fvPatchVectorField& pf : U_().boundaryField())
    {
        if (pf.coupled())
        {
            continue;
        }
        const label start = pf.patch().start() - mesh().nInternalFaces();
        SubField<vector> values(given_.faces, pf.size(), start);
        if (isA<tractionFvPatchVectorField>(pf))
        {
            values = refCast<const tractionFvPatchVectorField>(pf).traction();
        }
        else if (!mesh_.isBody(pf.patch().name()))
        {
            values = pf;
        }
    }
    setGivenVertices();
    balanceFluxes();
}


void Foam::fsbi::fluidRegion::setGivenVertices()
{
    vectorField sum(mesh().nPoints(), Zero);
    scalarField count(mesh().nPoints(), Zero);
    for (const fvPatchVectorField& pf : U_().boundaryField())
    {
        const polyPatch& pp = pf.patch().patch();
        if (pf.coupled() || isA<tractionFvPatchVectorField>(pf))
        {
            continue;
        }
        const auto* profile = isA<velocityProfile>(pf);
        vectorField u(pp.nPoints(), Zero);
        if (profile)
        {
            u = profile->velocityAt(pp.localPoints(), time_.value());
        }
        else if (!mesh_.isBody(pp.name()))
        {
            u = PrimitivePatchInterpolation<primitivePatch>(pp)
               .faceToPointInterpolate(static_cast<const vectorField&>(pf));
        }
        forAll(u, i)
        {
            sum[pp.meshPoints()[i]] += u[i];
            count[pp.meshPoints()[i]] += 1;
        }
    }
    syncTools::syncPointList(mesh(), sum, plusEqOp<vector>(), vector::zero);
    syncTools::syncPointList(mesh(), count, plusEqOp<scalar>(), scalar(0));

    const labelList& wall = stokes_->wallVertices();
    given_.vertices.setSize(wall.size());
    forAll(wall, i)
    {
        given_.vertices[i] = sum[wall[i]]/max(count[wall[i]], scalar(1));
    }
}


void Foam::fsbi::fluidRegion::balanceFluxes()
{
    const boolList& velocityGiven = stokes_->velocityGiven();
    scalar net = 0, gross = 0;
    bool open = false;
    for (const polyPatch& pp : mesh().boundaryMesh())
    {
        const label start = pp.start() - mesh().nInternalFaces();
        for (label i = start; !pp.coupled() && i < start + pp.size(); ++i)
        {
            open |= !velocityGiven[i];
            const scalar flux =
                given_.faces[i]
              & mesh().faceAreas()[mesh().nInternalFaces() + i];
            net += flux;
            gross += mag(flux);
        }
    }
    reduce(open, orOp<bool>());
    reduce(net, sumOp<scalar>());
    reduce(gross, sumOp<scalar>());
    if (open || gross < VSMALL)
    {
        return;
    }
    if (mag(net) > acceptedImbalance*gross)
    {
        FatalErrorInFunction
            << "The velocities given on the boundary of region fluid do not"
            << " balance: net outflow " << net << " of " << gross
            << ". Correct field U, or give one patch the condition 'traction'"
            << exit(FatalError);
    }
    forAll(given_.faces, i)
    {
        if (velocityGiven[i])
        {
            const vector& S =
                mesh().faceAreas()[mesh().nInternalFaces() + i];
            const scalar share = mag(given_.faces[i] & S)/gross;
            given_.faces[i] -= net*share*S/magSqr(S);
        }
    }
}


Foam::fsbi::solverReport Foam::fsbi::fluidRegion::solve
(
    UList<bodyRows>& rows,
    List<sixVector>& loads
)
{
    auto timer = timings_.measure("solve");
    forAll(rows, b)
    {
        rows[b].faces = bodyFaces_[b];
        rows[b].vertices = bodyVertices_[b];
    }
    setGiven();

    solverReport report
    (
        solver_->solve
        (
            given_, vectorField(mesh().nCells(), Zero), rows, x_, traction_
        )
    );

    loads.setSize(rows.size());
    forAll(rows, b)
    {
        vector force(Zero), torque(Zero);
        for (const label i : bodyFaces_[b])
        {
            const point& x =
                mesh().faceCentres()[mesh().nInternalFaces() + i];
            force -= traction_[i];
            torque -= (x - rows[b].centre) ^ traction_[i];
        }
        reduce(force, sumOp<vector>());
        reduce(torque, sumOp<vector>());
        loads[b] = join(force, torque);
    }
    setFields(rows);
    return report;
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

    const scalarField pb(stokes_->boundaryPressure());
    const tensorField grad(stokes_->velocityGradients());
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

        if (isA<tractionFvPatchVectorField>(Up))
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
