/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "inertia.H"
#include "Switch.H"
#include "volFields.H"
#include "pointFields.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{

defineTypeNameAndDebug(inertia, 0);
addToRunTimeSelectionTable(momentumTerm, inertia, entries);

//- Swept volumes over the largest cell's that are a mesh at rest
static const scalar atRest = 1e-14;

//- Travel of the domain over its size that is round-off
static const scalar noTravel = 1e-9;

static vectorField velocities(const scalarList& x)
{
    vectorField u(x.size()/4);
    forAll(u, i)
    {
        u[i] = vector(x[4*i], x[4*i + 1], x[4*i + 2]);
    }
    return u;
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::inertia::inertia(const fvMesh& mesh, const dictionary& dict)
:
    momentumTerm(mesh)
{
    const checkedDictionary entries(dict);
    density_ = entries.positive("density");
    if (entries.getOrDefault<Switch>("convection", false))
    {
        convection_.reset(new convection(density_));
    }
    entries.finish();
}


void Foam::fsbi::inertia::beginStep()
{
    const scalar dt = mesh_.time().deltaTValue();
    const scalar r = levels_.size() > 1 ? dt/lastStep_ : 0;
    c_[0] = (1 + 2*r)/(1 + r)/dt;
    c_[1] = -(1 + r)/dt;
    c_[2] = sqr(r)/(1 + r)/dt;
}


Foam::scalarField Foam::fsbi::inertia::swept
(
    const pointField& from, const pointField& to
) const
{
    scalarField volumes(mesh_.nFaces());
    forAll(volumes, facei)
    {
        volumes[facei] = mesh_.faces()[facei].sweptVol(from, to);
    }
    return volumes;
}


Foam::scalarField Foam::fsbi::inertia::outOfCells
(
    const scalarField& onFaces
) const
{
    scalarField sum(mesh_.nCells(), Zero);
    forAll(mesh_.faceOwner(), facei)
    {
        sum[mesh_.faceOwner()[facei]] += onFaces[facei];
    }
    forAll(mesh_.faceNeighbour(), facei)
    {
        sum[mesh_.faceNeighbour()[facei]] -= onFaces[facei];
    }
    return sum;
}


void Foam::fsbi::inertia::update()
{
    const scalarField& V = mesh_.cellVolumes();
    rate_ = density_*c_[0]*V;
    past_ = vectorField(V.size(), Zero);
    massFlux_.clear();
    if (!c_[0])
    {
        return;
    }
    scalarField then(V);
    scalarField flux(mesh_.nFaces(), Zero);
    const pointField* now = &mesh_.points();
    forAll(levels_, l)
    {
        const scalarField s(swept(levels_[l].points, *now));
        now = &levels_[l].points;
        then -= outOfCells(s);
        past_ += density_*c_[l + 1]*then*levels_[l].u;
        flux += (l ? -c_[2] : c_[0])*s;
    }
    if (gMax(mag(flux)()) > atRest*c_[0]*gMax(V))
    {
        massFlux_ = -density_*flux;
    }
}


void Foam::fsbi::inertia::addJacobian(const scalar* dx, scalar* dr) const
{
    forAll(rate_, i)
    {
        for (label k = 0; k < 3; ++k)
        {
            dr[4*i + k] += rate_[i]*dx[4*i + k];
        }
    }
}


void Foam::fsbi::inertia::addResidual(const scalar* x, scalar* r) const
{
    addJacobian(x, r);
    forAll(past_, i)
    {
        for (label k = 0; k < 3; ++k)
        {
            r[4*i + k] += past_[i][k];
        }
    }
}


void Foam::fsbi::inertia::addFluxes
(
    const stokesOperator& viscous, const boundaryValues& given, scalar* r
) const
{
    if (convection_)
    {
        convection_->add(viscous, given, massFlux_, r);
    }
    else if (massFlux_.size())
    {
        convection::addOut(mesh_, massFlux_*viscous.onFaces(given).mean, r);
    }
}


void Foam::fsbi::inertia::addFluxChanges
(
    const stokesOperator& viscous, const boundaryValues& given, scalar* r
) const
{
    if (convection_)
    {
        convection_->addChanges(viscous, given, r);
    }
    else
    {
        addFluxes(viscous, given, r);
    }
}


void Foam::fsbi::inertia::addMassFlux(scalarField& flux) const
{
    if (convection_)
    {
        flux += convection_->massFlux();
    }
}


void Foam::fsbi::inertia::addMassRate(scalarField& rate) const
{
    rate += rate_;
}


void Foam::fsbi::inertia::endStep
(
    const stokesOperator& viscous, const scalarList& x
)
{
    const level now
    {
        velocities(x), viscous.velocityGradients(), mesh_.points()
    };
    if (levels_.size())
    {
        const level before(levels_[0]);
        levels_ = List<level>({now, before});
    }
    lastStep_ = mesh_.time().deltaTValue();
}


void Foam::fsbi::inertia::release()
{
    carried_.clear();
    for (const level& l : levels_)
    {
        carried_.append(new meshOverlap(mesh_, l.points, l.u, l.gradient));
    }
}


Foam::vector Foam::fsbi::inertia::travel(const pointField& from) const
{
    const boundBox here(mesh_.points());
    const vector way(here.min() - boundBox(from).min());
    return mag(way) > noTravel*here.mag() ? way : vector(Zero);
}


void Foam::fsbi::inertia::renew()
{
    forAll(carried_, l)
    {
        const vector way(travel(levels_[l].points));
        carried_[l].moveBy(way);
        carried_[l].onto(mesh_, levels_[l].u, levels_[l].gradient);
        levels_[l].points = mesh_.points() - way;
    }
    carried_.clear();
}


Foam::IOobject Foam::fsbi::inertia::object(const word& name) const
{
    return IOobject
    (
        name, mesh_.time().timeName(), mesh_, IOobject::MUST_READ,
        IOobject::NO_WRITE, false
    );
}


void Foam::fsbi::inertia::write
(
    const std::function<void(const regIOobject&)>& add
) const
{
    if (levels_.size() < 2)
    {
        return;
    }
    const auto put = [&](const word& name, const auto& values)
    {
        typedef typename std::decay<decltype(values[0])>::type Type;
        IOobject io(object(name));
        io.readOpt() = IOobject::NO_READ;
        GeometricField<Type, fvPatchField, volMesh> field
        (
            io, mesh_, dimensioned<Type>(dimless, Zero)
        );
        field.primitiveFieldRef() = values;
        add(field);
    };
    put("gradUOfInertia", levels_[0].gradient);
    put("previousU", levels_[1].u);
    put("previousGradU", levels_[1].gradient);
    IOobject io(object("previousPoints"));
    io.readOpt() = IOobject::NO_READ;
    pointVectorField points
    (
        io, pointMesh::New(mesh_), dimensionedVector(dimLength, Zero)
    );
    points.primitiveFieldRef() = levels_[1].points;
    add(points);
}


void Foam::fsbi::inertia::save(dictionary& state) const
{
    state.set("levels", levels_.size());
    state.set("lastStep", lastStep_);
}


void Foam::fsbi::inertia::restore
(
    const stokesOperator& viscous, const dictionary& state, const scalarList& x
)
{
    levels_.setSize(state.getOrDefault<label>("levels", 1));
    levels_[0] = level
    {
        velocities(x), viscous.velocityGradients(), mesh_.points()
    };
    if (levels_.size() > 1)
    {
        lastStep_ = state.get<scalar>("lastStep");
        levels_[0].gradient = volTensorField(object("gradUOfInertia"), mesh_);
        levels_[1].u = volVectorField(object("previousU"), mesh_);
        levels_[1].gradient = volTensorField(object("previousGradU"), mesh_);
        levels_[1].points = pointVectorField
        (
            object("previousPoints"), pointMesh::New(mesh_)
        );
    }
}
