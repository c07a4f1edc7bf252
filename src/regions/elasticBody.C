/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "elasticBody.H"
#include "bodyMesher.H"
#include "quaternion.H"
#include "OStringStream.H"
#include "Time.H"
#include "Tuple2.H"
#include "IOdictionary.H"
#include "bodyState.H"
#include "meshQuality.H"
#include "timeFunction.H"

namespace Foam
{
namespace fsbi
{

//- Beyond these cells cost accuracy: non-orthogonality, degrees, and skewness
static const scalar poorAngle = 75, poorSkewness = 4;

//- Why a mesh of the user's cannot be used; what may be inaccurate is told
static string failureOfGiven(const word& name, const meshLists& whole)
{
    const meshQuality quality(whole);
    if (!(quality.minVolume > 0))
    {
        return "the mesh given has a cell with the volume "
          + Foam::name(quality.minVolume) + ", inside out or empty; checkMesh"
            " finds it";
    }
    if
    (
        quality.maxNonOrthogonality > poorAngle
     || quality.maxSkewness > poorSkewness
    )
    {
        Info<< "The mesh given for body '" << name << "' is ill-shaped:"
            << " non-orthogonality " << quality.maxNonOrthogonality
            << " degrees, skewness " << quality.maxSkewness
            << ": results near such cells may be off by several per cent"
            << endl;
    }
    return string();
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::elasticBody::elasticBody(const word& name, const dictionary& dict)
:
    name_(name),
    position_(Zero),
    turned_(tensor::I)
{
    const checkedDictionary entries(dict);
    entries.found("type");
    entries.found("libs");
    entries.found("enters");
    if (entries.found("shape"))
    {
        readShape(entries);
    }
    for (auto* load : {&bodyForce_, &acceleration_})
    {
        const word key(load == &bodyForce_ ? "bodyForce" : "acceleration");
        if (entries.found(key))
        {
            *load = timeFunction<vector>(key, entries);
        }
    }
    readHeld(entries);
    if (entries.found("parts"))
    {
        parts_.read(entries.subDict("parts"));
        shapeText_ += parts_.text();
    }
    if (entries.found("deformed"))
    {
        readDeformed(entries);
    }
    velocity_ = entries.getOrDefault<vector>("initialVelocity", Zero);
    angularVelocity_ =
        entries.getOrDefault<vector>("initialAngularVelocity", Zero);
    entries.finish();
}


void Foam::fsbi::elasticBody::readShape(const checkedDictionary& entries)
{
    shape_ = bodyShape::New(entries.subDict("shape"));
    position_ = entries.get<point>("position");
    const Tuple2<vector, scalar> turned(orientationOf(entries));
    if (mag(turned.first()) > 0)
    {
        turned_ =
            quaternion(turned.first()/mag(turned.first()), turned.second()).R();
    }
    OStringStream os;
    os.precision(17);
    os << position_ << turned;
    entries.subDict("shape").write(os, false);
    shapeText_ = os.str();
}


void Foam::fsbi::elasticBody::readHeld(const checkedDictionary& entries)
{
    if (entries.found("held"))
    {
        const checkedDictionary box(entries.subDict("held"));
        held_ = boundBox(box.get<point>("min"), box.get<point>("max"));
        box.finish();
        const vector span(held_.max() - held_.min());
        if (cmptMin(span) < 0)
        {
            FatalIOErrorInFunction(box.dict())
                << "The box 'held' has min " << held_.min() << " above max "
                << held_.max() << exit(FatalIOError);
        }
    }
    tethered_ = entries.found("tether");
    if (tethered_)
    {
        checkedDictionary(entries.subDict("tether")).finish();
    }
}


void Foam::fsbi::elasticBody::readDeformed(const checkedDictionary& entries)
{
    const checkedDictionary sphere(entries.subDict("shape"));
    sphere.choice("type", {"sphere"});
    const scalar radius = sphere.positive("radius");
    const checkedDictionary map(entries.subDict("deformed"));
    const scalar Ax = map.get<scalar>("Ax");
    const scalar Ay = map.get<scalar>("Ay");
    const scalar By = map.get<scalar>("By");
    if (!leukocyteMap::invertible(radius, Ax, Ay, By))
    {
        FatalIOErrorInFunction(map.dict())
            << "A sphere of radius " << radius << " folds over itself with Ax "
            << Ax << ", Ay " << Ay << ", By " << By << ": |Ax| must be below"
            << " 0.637 radius, Ay and By below 1" << exit(FatalIOError);
    }
    deformed_.reset(new leukocyteMap(radius, Ax, Ay, By));
    map.finish();
}


Foam::vector Foam::fsbi::elasticBody::displacement(const point& x) const
{
    return
        deformed()
      ? vector(deformed_->fromSphere(x - position_) - (x - position_))
      : vector(Zero);
}


Foam::autoPtr<Foam::fvMesh> Foam::fsbi::elasticBody::makeMesh
(
    const Time& time,
    const bool alone,
    const bool onSurface
) const
{
    if (!shape_ && hasRegionMesh(time, name_))
    {
        return readRegionMesh(time, name_, time.constant());
    }
    // by all: the master sends it to the others
    const IOdictionary controls
    (
        IOobject
        (
            "remeshDict", time.caseSystem(), name_, time,
            IOobject::READ_IF_PRESENT, IOobject::NO_WRITE, false
        )
    );
    meshLists whole;
    if (Pstream::master())
    {
        if (shape_)
        {
            const bodySurface facets(shape_->triangulate());
            whole = bodyMesher(controls).fill
            (
                name_,
                (onSurface ? facets.described() : facets)
               .transformed(turned_, position_),
                0,
                parts_.within(name_, facets, turned_, position_)
            );
        }
        else if (wholeMesh::exists(time, name_))
        {
            whole = wholeMesh(time, name_).lists();
        }
        else if (alone && wholeMesh::exists(time, polyMesh::defaultRegion))
        {
            whole = wholeMesh(time, polyMesh::defaultRegion).lists();
        }
        else
        {
            whole.failure =
                "there is neither an entry 'shape' in constant/bodies nor a"
                " mesh in constant/" + name_ + "/polyMesh"
              + (alone ? " or constant/polyMesh: run blockMesh first" : "");
        }
    }
    if (Pstream::master() && !shape_ && whole.valid())
    {
        whole.failure = failureOfGiven(name_, whole);
    }
    Pstream::scatter(whole.failure);
    if (!whole.valid())
    {
        FatalErrorInFunction
            << "No mesh of body '" << name_ << "': " << whole.failure.c_str()
            << exit(FatalError);
    }
    return makeRegionMesh(time, name_, whole);
}


Foam::vector Foam::fsbi::elasticBody::force
(
    const scalar time,
    const scalar density
) const
{
    vector f(Zero);
    if (bodyForce_)
    {
        f += bodyForce_->value(time);
    }
    if (acceleration_)
    {
        f += density*acceleration_->value(time);
    }
    return f;
}


Foam::tmp<Foam::vectorField> Foam::fsbi::elasticBody::velocity
(
    const vectorField& x,
    const point& centre
) const
{
    return velocity_ + (angularVelocity_ ^ (x - centre));
}


void Foam::fsbi::elasticBody::saveShape(dictionary& state) const
{
    state.set("shape", shapeText_);
}


void Foam::fsbi::elasticBody::checkShape(const dictionary& saved) const
{
    if (saved.get<string>("shape") != shapeText_)
    {
        FatalErrorInFunction
            << "The shape or place of body '" << name_ << "' in constant/bodies"
            << " is no longer the one of the saved state. Put it back, or start"
            << " a new run at time 0" << exit(FatalError);
    }
}
