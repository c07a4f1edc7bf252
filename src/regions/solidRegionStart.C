/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidRegion.H"
#include "caseInput.H"
#include "steadyState.H"
#include "Time.H"
#include "mathematicalConstants.H"
#include "IOdictionary.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{

defineTypeNameAndDebug(solidRegion, 0);
addToRunTimeSelectionTable(body, solidRegion, entries);

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::solidRegion::solidRegion
(
    const bodySite& site, const dictionary& dict, const dictionary& saved
)
:
    time_(site.time),
    timings_(site.clocks),
    body_(site.name, dict),
    materialEntries_
    (
        IOdictionary
        (
            IOobject
            (
                "material", time_.caseConstant(), site.name, time_,
                IOobject::MUST_READ, IOobject::NO_WRITE, false
            )
        )
    ),
    material_(solidMaterial::New(materialEntries_, {"cortex", "parts"})),
    inFluid_(site.inFluid),
    tethered_(Zero),
    fluidForce_(Zero),
    oldStep_(0)
{
    auto timer = timings_.measure("meshing");
    readOrder();
    mesh_ =
        saved.empty()
      ? body_.makeMesh(time_, site.alone, order_ == 4)
      : readRegionMesh(time_, site.name, time_.timeName());
    create(saved.size());
    if (saved.empty())
    {
        start();
    }
    else
    {
        restore(saved);
    }
}


const Foam::dictionary& Foam::fsbi::solidRegion::controls() const
{
    const dictionary* entries = mesh().solutionDict().findDict("solid");
    return entries ? *entries : dictionary::null;
}


Foam::boolList Foam::fsbi::solidRegion::holdFaces()
{
    boolList held(conditions_->given().kinds.size(), false);
    vectorField heldAt(held.size());
    forAll(held, i)
    {
        const point& x = mesh().faceCentres()[mesh().nInternalFaces() + i];
        held[i] =
            conditions_->given().kinds[i] != solidBoundary::coupled
         && body_.held(x);
        heldAt[i] = body_.displacement(x);
    }
    if (body_.hasBox() && !returnReduce(held.found(true), orOp<bool>()))
    {
        FatalErrorInFunction
            << "The box 'held' of body '" << name() << "' in constant/bodies"
            << " holds no face of its surface, which reaches from "
            << mesh().bounds().min() << " to " << mesh().bounds().max()
            << exit(FatalError);
    }
    conditions_->hold(held, heldAt);
    return held;
}


void Foam::fsbi::solidRegion::create(const bool saved)
{
    checkNumerics();
    readFormulation();
    volumes_ = mesh().cellVolumes();
    centres_ = mesh().cellCentres();
    fields_.reset(new solidFields(mesh(), saved, inFluid_));
    const materialParts parts(readParts());
    conditions_.reset
    (
        new solidConditions(mesh_(), fields_->D(), reference_)
    );
    createMotion();
    const boolList held(holdFaces());
    checkStatics();

    movedCells_.setSize(mesh().nCells(), Zero);
    movedFaces_.setSize(mesh().nFaces() - mesh().nInternalFaces(), Zero);
    movedPoints_.setSize(mesh().nPoints(), Zero);
    if (inFluid_)
    {
        // its surface is that of the stress-free body
        wetted_.reset
        (
            new wettedSurface
            (
                mesh(), held, body_, material_->density(), order_ == 4, mayBeCut_
            )
        );
        wetted_->setSurface(rows_);
    }
    if (saved)
    {
        moveMesh();
    }
    const bool mixed = checkedDictionary(controls()).getOrDefault
    (
        "mixed", order_ == 2 && mostIncompressible() >= 0.45
    );
    checkLiquid(mixed);
    checkPressures(mixed, parts);
    elastic_ = elasticOperator::New
    (
        order_, mesh(), parts, conditions_->given().kinds, formulation_, mixed
    );
    setCortex();
    volumes_ += elastic_->volumesOnFacets();
    x_.setSize(elastic_->size(), 0);
    increment_ = x_;
    renewSolver();
    if (inFluid_)
    {
        rows_.elastic = &elastic_();
        rows_.given = &conditions_->given();
        rows_.x = &x_;
        rows_.volumes = volumes_;
        setTether();
        setMoved();
    }
}


void Foam::fsbi::solidRegion::checkNumerics() const
{
    checkedDictionary::checkBlocks(mesh().solutionDict(), {"solid"});
    checkedDictionary::checkBlocks(mesh().schemesDict(), {"d2dt2Schemes"});
    const dictionary chosen
    (
        mesh().schemesDict().subOrEmptyDict("d2dt2Schemes")
    );
    const checkedDictionary schemes(chosen);
    schemes.found("default");
    schemes.found("d2dt2(D)");
    schemes.finish();
}


void Foam::fsbi::solidRegion::setTether()
{
    if (body_.tethered())
    {
        const scalar pi = constant::mathematical::pi;
        const scalar volume = gSum(volumes_);
        rows_.constraintWeight = volumes_/volume;
        rows_.radius = cbrt(0.75*volume/pi);
    }
}


void Foam::fsbi::solidRegion::createMotion()
{
    // in a fluid, where viscosity stops everything at once, without a scheme
    // there is no inertia
    const dictionary given
    (
        mesh().schemesDict().subOrEmptyDict("d2dt2Schemes")
    );
    if (inFluid_ && !given.found("default") && !given.found("d2dt2(D)"))
    {
        ITstream none("d2dt2Schemes", tokenList());
        motion_.reset(new steadyState(none));
        return;
    }
    motion_ = motionScheme::New(mesh().d2dt2Scheme("d2dt2(D)"));
}


void Foam::fsbi::solidRegion::readFormulation()
{
    typedef constitutiveState::formulation formulation;
    const word chosen
    (
        checkedDictionary(controls()).choice
        (
            "formulation", constitutiveState::formulationNames.sortedToc(),
            "totalLagrangian"
        )
    );
    formulation_ = constitutiveState::formulationNames[chosen];
    if (formulation_ != formulation::totalLagrangian)
    {
        reference_ = mesh().points();
    }
}


void Foam::fsbi::solidRegion::readOrder()
{
    const auto entries = [this](const word& region, const word& block)
    {
        const IOdictionary all
        (
            IOobject
            (
                "fvSolution", time_.caseSystem(), region, time_,
                IOobject::READ_IF_PRESENT, IOobject::NO_WRITE, false
            )
        );
        return dictionary(all.subOrEmptyDict(block));
    };
    const label fluid =
        inFluid_
      ? entries(caseInput::fluid, "coupling").getOrDefault<label>("order", 2)
      : 0;
    order_ = checkedDictionary(entries(name(), "solid")).count
    (
        "order", inFluid_ ? fluid : 2
    );
    if (order_ != 2 && order_ != 4)
    {
        FatalErrorInFunction
            << "Entry 'order' of 'solid' in system/" << name() << "/fvSolution"
            << " is " << order_ << "; valid choices are (2 4)"
            << exit(FatalError);
    }
    if (order_ == 4 && inFluid_ && fluid != 4)
    {
        FatalErrorInFunction
            << "Order 4 of body '" << name() << "' in 'solid' of system/"
            << name() << "/fvSolution wants the same of the fluid around it:"
            << " give 'order 4' in 'coupling' of system/fluid/fvSolution, too,"
            << " or no 'order' in either" << exit(FatalError);
    }
    // by turns forces come to the body's triangles only, not to places on them
    mayBeCut_ =
        inFluid_ && order_ == 2 && fluid == 2
     && entries(caseInput::fluid, "coupling").getOrDefault<word>
        (
            "scheme", "monolithic"
        ) == "monolithic";
}


void Foam::fsbi::solidRegion::setCortex()
{
    if (!materialEntries_.found("cortex"))
    {
        return;
    }
    const dictionary& entries = materialEntries_.subDict("cortex");
    if
    (
        order_ != 2
     || formulation_ != constitutiveState::formulation::totalLagrangian
    )
    {
        FatalIOErrorInFunction(entries)
            << "Body '" << name() << "' has a cortex, which wants, in 'solid' of"
            << " system/" << name() << "/fvSolution, order 2 and formulation"
            << " totalLagrangian, as they are by default" << exit(FatalIOError);
    }
    elastic_->setCortex(entries);
}


void Foam::fsbi::solidRegion::checkLiquid(const bool mixed) const
{
    if
    (
        material_->flows()
     && !(
            inFluid_ && mixed && order_ == 2
         && formulation_ == constitutiveState::formulation::totalLagrangian
        )
    )
    {
        FatalIOErrorInFunction(materialEntries_)
            << "Body '" << name() << "' is of a liquid, which wants a fluid"
            << " around it and, in 'solid' of system/" << name()
            << "/fvSolution, order 2, formulation totalLagrangian and mixed yes,"
            << " as they are by default" << exit(FatalIOError);
    }
    if
    (
        material_->flows()
     && !materialEntries_.subOrEmptyDict("cortex").found("type")
    )
    {
        FatalIOErrorInFunction(materialEntries_)
            << "Body '" << name() << "' is of a liquid, which needs a 'cortex'"
            << " with a 'type' of elastic law around it: a tension alone does not"
            << " hold the surface's triangles" << exit(FatalIOError);
    }
}


bool Foam::fsbi::solidRegion::isStatic() const
{
    return isA<steadyState>(motion_());
}


void Foam::fsbi::solidRegion::checkStatics() const
{
    if (body_.tethered() && !inFluid_)
    {
        FatalErrorInFunction
            << "Body '" << name() << "' has a 'tether' in constant/bodies, but"
            << " there is no fluid (constant/fluid/material) whose force it"
            << " could cancel; hold a patch in 0/" << name() << "/D instead"
            << exit(FatalError);
    }
    if (isStatic() && !inFluid_)
    {
        conditions_->checkSupports();
    }
    if (isStatic() && body_.moving())
    {
        FatalErrorInFunction
            << "Body '" << name() << "' has a velocity at the start, but the"
            << " scheme of d2dt2Schemes in system/" << name() << "/fvSchemes"
            << " is steadyState, without inertia" << exit(FatalError);
    }
    if (!(material_->density() > 0) && (!isStatic() || body_.hasAcceleration()))
    {
        FatalErrorInFunction
            << "Entry 'density' of constant/" << name() << "/material is"
            << " missing: "
            << (isStatic() ? "'acceleration' in constant/bodies" : "motion")
            << " needs it. The scheme of d2dt2Schemes in system/" << name()
            << "/fvSchemes is " << motion_->type()
            << (isStatic() ? "" : "; for statics take steadyState")
            << exit(FatalError);
    }
}


void Foam::fsbi::solidRegion::setUnknowns()
{
    vector* u = reinterpret_cast<vector*>(x_.data());
    const volVectorField& D = fields_->D();
    std::copy(D.begin(), D.end(), u);
    u += mesh().nCells();
    const List<solidBoundary::kind>& kinds = conditions_->given().kinds;
    forAll(kinds, i)
    {
        if (kinds[i] != solidBoundary::coupled)
        {
            *u++ = D[mesh().faceOwner()[mesh().nInternalFaces() + i]];
        }
    }
    elastic_->followCells
    (
        scalarList(x_.size(), Zero).cdata(), D.primitiveField(), x_.begin()
    );
    if (body_.deformed())
    {
        elastic_->set
        (
            [this](const point& p) { return body_.displacement(p); }, x_.begin()
        );
    }
}


void Foam::fsbi::solidRegion::start()
{
    setUnknowns();
    begin();
}


void Foam::fsbi::solidRegion::enter(const point& centre)
{
    setUnknowns();
    const vector by(centre - wetted_->start());
    elastic_->set
    (
        [&](const point& p) { return by + body_.displacement(p); }, x_.begin()
    );
    increment_ = 0;
    oldStep_ = 0;
    rows_.multiplier = Zero;
    fluidForce_ = Zero;
    begin();
}


void Foam::fsbi::solidRegion::leave()
{
    enter(wetted_->placed().centre);
}


void Foam::fsbi::solidRegion::begin()
{
    const vectorField u(cells());
    conditions_->evaluate(movedFaces_);
    const vector centre(gSum(volumes_*centres_)/gSum(volumes_));
    motion_->start
    (
        u, body_.velocity(centres_ + u, centre),
        isStatic() ? vectorField(u.size(), Zero) : initialAcceleration()
    );
    if (!evaluate())
    {
        FatalErrorInFunction
            << "The displacement at the start in 0/" << name() << "/D turns"
            << " the body inside out" << exit(FatalError);
    }
    if (wetted_)
    {
        wetted_->start(rows_);
        if (rows_.tethered())
        {
            tethered_ = gSum(vectorField(rows_.constraintWeight*cells()));
        }
    }
    setFields();
    balance_.start(working());
}


Foam::vectorField Foam::fsbi::solidRegion::initialAcceleration()
{
    // the way in a time far below that of any oscillation
    const vectorField u(cells());
    const scalarField masses(material_->density()*volumes_);
    const scalarField mass(masses*sqr(10*fastestFrequency()));
    const vectorField force(volumeForce()*volumes_ + mass*u);
    // so short a way that round-off allows no more
    dictionary coarse(controls());
    coarse.set("tolerance", 1e-6);
    const solverReport report
    (
        solidSolver::New(mesh(), elastic_(), material_(), coarse)->solve
        (
            {conditions_->given(), force, mass}, x_
        )
    );
    if (!report.converged || !evaluate())
    {
        FatalErrorInFunction
            << "No acceleration at the start of body '" << name()
            << "' balances its loads: " << judged(report).reason.c_str()
            << exit(FatalError);
    }
    std::copy(u.begin(), u.end(), reinterpret_cast<vector*>(x_.data()));
    return -forces_/masses;
}
