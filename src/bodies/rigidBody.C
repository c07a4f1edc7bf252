/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "rigidBody.H"
#include "checkedDictionary.H"
#include "mathematicalConstants.H"
#include "timeFunction.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{

defineTypeNameAndDebug(rigidBody, 0);
addToRunTimeSelectionTable(body, rigidBody, entries);

} // End namespace fsbi
} // End namespace Foam


const Foam::wordList Foam::fsbi::rigidBody::integrators
({
    "monolithic", "explicitEuler", "semiImplicit"
});

namespace
{

//- Change of the turn from one step to the next that is no jump [rad], and
//  how many steps are not extrapolated after one: a body that has been turned
//  into a field within a step stops in the next
const Foam::scalar largestJump = 0.5;
const Foam::label stepsAfterJump = 2;

//- A rotation vector of at most half a turn with as many turns more as make it the
//  one that is about known
Foam::vector wound(const Foam::vector& least, const Foam::vector& known)
{
    using namespace Foam;
    const scalar angle = mag(least);
    const vector axis(angle > SMALL ? least/angle : normalised(known));
    const scalar round = 2*constant::mathematical::pi;
    return least + round*std::round(((known - least) & axis)/round)*axis;
}

} // End anonymous namespace


Foam::fsbi::rigidBody::rigidBody
(
    const word& name,
    const dictionary& dict,
    const dictionary& saved
)
:
    name_(name),
    shapeCentre_(Zero),
    density_(0),
    mass_(0),
    inertia_(Zero),
    firstOrientation_(quaternion::I),
    oldStep_(0),
    step_(0),
    accepted_(0),
    stopped_(false),
    solved_(false),
    turn_(Zero)
{
    const checkedDictionary entries(dict);
    entries.found("type");
    entries.found("libs");
    entries.found("enters");
    integrator_ =
        entries.choice("integrator", integrators, integrators.first());

    readDensity(entries);
    const dictionary& shapeDict = entries.subDict("shape");
    shape_ = bodyShape::New(shapeDict);
    shapeText_ = textOf(shapeDict);
    const point position(entries.get<point>("position"));
    const Tuple2<vector, scalar> turned(orientationOf(entries));
    if (mag(turned.first()) > 0)
    {
        firstOrientation_ = quaternion
        (
            turned.first()/mag(turned.first()), turned.second()
        );
    }
    firstVelocity_ = join
    (
        entries.getOrDefault<vector>("velocity", Zero),
        entries.getOrDefault<vector>("angularVelocity", Zero)
    );
    for (auto* load : {&force_, &torque_})
    {
        const word key(load == &force_ ? "force" : "torque");
        if (entries.found(key))
        {
            *load = timeFunction<vector>(key, entries);
        }
    }
    const checkedDictionary constraints(entries.subDictOrEmpty("constraints"));
    if (entries.found("constraints") && constraints.dict().empty())
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'constraints' of body '" << name << "' is empty: give"
            << " velocity, angularVelocity or both" << exit(FatalIOError);
    }
    readPrescription(constraints, "velocity", linear_);
    readPrescription(constraints, "angularVelocity", angular_);
    constraints.finish();
    entries.finish();

    if (saved.empty())
    {
        place(shape_->triangulate(), position);
    }
    else
    {
        checkShape(dict, saved);
        restore(saved);
    }
}


void Foam::fsbi::rigidBody::readDensity(const checkedDictionary& entries)
{
    overdamped_ = entries.getOrDefault("overdamped", false);
    if (!overdamped_ || entries.found("density"))
    {
        density_ = entries.positive("density");
    }
    if (overdamped_ && integrator_ == "explicitEuler")
    {
        FatalIOErrorInFunction(entries.dict())
            << "Integrator 'explicitEuler' needs inertia: it does not go with"
            << " 'overdamped'; take integrator 'monolithic'"
            << exit(FatalIOError);
    }
}


void Foam::fsbi::rigidBody::place
(
    const bodySurface& raw,
    const point& position
)
{
    raw.check(name_);
    shapeCentre_ = raw.centroid();
    surface_ = raw.transformed(tensor::I, -shapeCentre_);
    setMass();

    now_.orientation = firstOrientation_;
    enter(position + (rotation() & shapeCentre_));
    start_ = now_.centre;
}


void Foam::fsbi::rigidBody::enter(const point& centre)
{
    state s;
    s.centre = centre;
    s.orientation = firstOrientation_;
    s.velocity = firstVelocity_;
    begin(s);
}


void Foam::fsbi::rigidBody::leave()
{
    state s;
    s.centre = now_.centre;
    s.orientation = now_.orientation;
    begin(s);
}


void Foam::fsbi::rigidBody::begin(const state& s)
{
    older_ = old_ = now_ = s;
    oldStep_ = step_ = 0;
    accepted_ = 0;
    stopped_ = solved_ = false;
}


void Foam::fsbi::rigidBody::setMass()
{
    mass_ = density_*surface_.volume();
    inertia_ = density_*(tensor::I & surface_.inertia());
    radius_ = average(mag(surface_.points()));
}


void Foam::fsbi::rigidBody::checkShape
(
    const dictionary& dict,
    const dictionary& saved
) const
{
    if (saved.get<string>("shape") != shapeText_)
    {
        FatalIOErrorInFunction(dict)
            << "The shape of body '" << name_ << "' is no longer the one of"
            << " the saved state, which is {" << nl
            << saved.get<string>("shape").c_str() << "}. Put it back, or start"
            << " a new run at time 0" << exit(FatalIOError);
    }
}


void Foam::fsbi::rigidBody::readPrescription
(
    const checkedDictionary& entries,
    const word& key,
    prescription& p
)
{
    const wordList all({"x", "y", "z"});
    const wordList axes
    (
        entries.getOrDefault<wordList>(key + "Axes", all)
    );
    const bool given = entries.found(key);
    if (entries.dict().found(key + "Axes") && (!given || axes.empty()))
    {
        FatalIOErrorInFunction(entries.dict())
            << "Entry '" << key << "Axes' "
            << (given ? "is empty" : "is of no use alone")
            << ": it lists the axes along which '" << key << "' is prescribed,"
            << " of (x y z)" << exit(FatalIOError);
    }
    if (!given)
    {
        return;
    }
    p.value = timeFunction<vector>(key, entries);
    for (const word& axis : axes)
    {
        if (!all.found(axis))
        {
            FatalIOErrorInFunction(entries.dict())
                << "'" << axis << "' in '" << key << "Axes' is no axis;"
                << " valid axes are (x y z)" << exit(FatalIOError);
        }
        p.axes[all.find(axis)] = true;
    }
}


Foam::fsbi::bodySurface Foam::fsbi::rigidBody::placedSurface() const
{
    return surface_.transformed(rotation(), now_.centre);
}


Foam::fsbi::bodySurface Foam::fsbi::rigidBody::surfaceForMesh() const
{
    const placement p(placementForMesh());
    return surface_.transformed(p.orientation.R(), p.centre);
}


Foam::fsbi::placement Foam::fsbi::rigidBody::placementForMesh() const
{
    return {now_.centre, shape_->round() ? quaternion::I : now_.orientation};
}


bool Foam::fsbi::rigidBody::hasShape() const
{
    return shape_->projects();
}


Foam::point Foam::fsbi::rigidBody::onShape(const point& p) const
{
    const tensor R(placementForMesh().orientation.R());
    const point inShape((R.T() & (p - now_.centre)) + shapeCentre_);
    return now_.centre + (R & (shape_->project(inShape) - shapeCentre_));
}


Foam::vectorField Foam::fsbi::rigidBody::pointVelocity() const
{
    return
        linear(now_.velocity)
      + (angular(now_.velocity) ^ (rotation() & surface_.points()));
}


Foam::fsbi::sixVector Foam::fsbi::rigidBody::momentum(const state& s) const
{
    const tensor R(s.orientation.R());
    return join
    (
        mass_*linear(s.velocity),
        (R & inertia_ & R.T()) & angular(s.velocity)
    );
}


bool Foam::fsbi::rigidBody::hasHistory() const
{
    return accepted_ > 0;
}


Foam::FixedList<Foam::scalar, 3> Foam::fsbi::rigidBody::weights() const
{
    if (!hasHistory() || stopped_)
    {
        return FixedList<scalar, 3>({1, -1, 0});
    }
    const scalar r = step_/oldStep_;
    return FixedList<scalar, 3>
    ({
        (1 + 2*r)/(1 + r), -(1 + r), r*r/(1 + r)
    });
}


void Foam::fsbi::rigidBody::advance(const scalar dt)
{
    sixVector mean(old_.velocity);
    if (accepted_ > 1 && !stopped_)
    {
        const scalar r = 0.5*dt/oldStep_;
        forAll(mean, k)
        {
            mean[k] += r*(old_.velocity[k] - older_.velocity[k]);
        }
    }
    else if (!hasHistory() && solved_)
    {
        mean = now_.velocity;
    }
    else if (accepted_ < 0)
    {
        mean = sixVector(scalar(0));
    }
    advance(dt, mean, 1);
}


void Foam::fsbi::rigidBody::advance
(
    const scalar dt, const sixVector& velocity, const scalar part
)
{
    step_ = dt;
    now_.centre = old_.centre + part*dt*linear(velocity);
    turn_ = part*dt*angular(velocity);
    now_.orientation = rotationBy(turn_)*old_.orientation;
    now_.orientation /= mag(now_.orientation);
}


Foam::fsbi::sixVector Foam::fsbi::rigidBody::applied(const scalar time) const
{
    return join
    (
        force_ ? force_->value(time) : vector(Zero),
        torque_ ? torque_->value(time) : vector(Zero)
    );
}


void Foam::fsbi::rigidBody::addInertia(bodyRows& rows) const
{
    const FixedList<scalar, 3> c(weights());
    const tensor R(rotation());
    rows.massRate = c[0]*mass_/step_;
    rows.inertiaRate = (c[0]/step_)*(R & inertia_ & R.T());
    const sixVector p(momentum(old_)), q(momentum(older_));
    forAll(rows.rhs, k)
    {
        rows.rhs[k] -= (c[1]*p[k] + c[2]*q[k])/step_;
    }
}


Foam::vector Foam::fsbi::rigidBody::turned() const
{
    return wound(angleOf(now_.orientation*conjugate(old_.orientation)), turn_);
}


void Foam::fsbi::rigidBody::addPlacement(bodyRows& rows) const
{
    const auto moved = [](const state& to, const state& from)
    {
        return join
        (
            to.centre - from.centre,
            angleOf(to.orientation*conjugate(from.orientation))
        );
    };
    const FixedList<scalar, 3> c(weights());
    const sixVector before(moved(old_, older_));
    const sixVector placed(join(now_.centre - old_.centre, turned()));
    rows.gain = step_/c[0];
    forAll(rows.offset, k)
    {
        rows.offset[k] = placed[k] - c[2]/c[0]*before[k];
    }
}


Foam::fsbi::sixVector Foam::fsbi::rigidBody::explicitVelocity
(
    const scalar time
) const
{
    if (!hasHistory() && !solved_)
    {
        return old_.velocity;           // its load is not known yet
    }
    const tensor R(old_.orientation.R());
    const sixVector& f = old_.load;
    const sixVector g(applied(time - step_));
    const vector V
    (
        linear(old_.velocity) + step_/mass_*(linear(f) + linear(g))
    );
    const vector L
    (
        angular(momentum(old_)) + step_*(angular(f) + angular(g))
    );
    return join(V, inv(R & inertia_ & R.T()) & L);
}


Foam::fsbi::bodyRows Foam::fsbi::rigidBody::rows(const scalar time) const
{
    bodyRows rows;
    rows.centre = meshedPlacement().centre;
    rows.radius = radius_;
    rows.rhs = applied(time);
    rows.velocity = now_.velocity;
    rows.free = FixedList<bool, 6>(true);
    rows.massRate = 0;
    rows.inertiaRate = Zero;

    if (!overdamped_ && step_ > 0)
    {
        addInertia(rows);
    }
    if (step_ > 0)
    {
        addPlacement(rows);
    }
    if (integrator_ == "explicitEuler" && step_ > 0)
    {
        rows.velocity = explicitVelocity(time);
        rows.free = FixedList<bool, 6>(false);
    }

    for (label k = 0; k < 6; ++k)
    {
        const prescription& p = k < 3 ? linear_ : angular_;
        if (p.axes[k % 3])
        {
            rows.free[k] = false;
            rows.velocity[k] = p.value->value(time)[k % 3];
        }
    }
    return rows;
}


void Foam::fsbi::rigidBody::set
(
    const sixVector& velocity,
    const sixVector& load
)
{
    if (!hasHistory() && !solved_)
    {
        old_.load = load;               // of the start, for explicitEuler
    }
    now_.velocity = velocity;
    now_.load = load;
    solved_ = true;
}


void Foam::fsbi::rigidBody::settle()
{
    bodyRows rows;
    addPlacement(rows);
    sixVector u(rows.offset);
    forAll(u, k)
    {
        u[k] = rows.gain*now_.velocity[k] - u[k];
    }
    now_.centre += linear(u);
    turn_ = turned() + angular(u);
    now_.orientation = rotationBy(angular(u))*now_.orientation;
    now_.orientation /= mag(now_.orientation);
}


void Foam::fsbi::rigidBody::stand(const placement& p)
{
    now_.centre = p.centre;
    now_.orientation = p.orientation;
}


void Foam::fsbi::rigidBody::beginStep()
{
    old_ = now_;
    solved_ = false;
}


void Foam::fsbi::rigidBody::rewind()
{
    now_ = old_;
    solved_ = false;
}


void Foam::fsbi::rigidBody::endStep()
{
    const vector jump
    (
        step_*(angular(now_.velocity) - angular(old_.velocity))
    );
    accepted_ = mag(jump) > largestJump ? -stepsAfterJump : accepted_ + 1;
    older_ = old_;
    oldStep_ = step_;
}


void Foam::fsbi::rigidBody::save(dictionary& dict) const
{
    dict.set("now", now_.saved());
    dict.set("older", older_.saved());
    dict.set("start", start_);
    dict.set("step", oldStep_);
    dict.set("accepted", accepted_);
    dict.set("stopped", stopped_);
    dict.set("shape", shapeText_);
    dict.set("shapeCentre", shapeCentre_);
    dict.set("points", surface_.points());
    dict.set("triangles", surface_.triangles());
    dict.set("scale", surface_.scale());
    dict.set("offset", surface_.offset());
}


void Foam::fsbi::rigidBody::restore(const dictionary& dict)
{
    now_.restore(dict.subDict("now"));
    older_.restore(dict.subDict("older"));
    old_ = now_;
    start_ = dict.get<point>("start");
    shapeCentre_ = dict.getOrDefault<point>("shapeCentre", Zero);
    oldStep_ = dict.get<scalar>("step");
    accepted_ = dict.get<label>("accepted");
    stopped_ = dict.getOrDefault("stopped", false);
    surface_ = bodySurface
    (
        dict.get<pointField>("points"), dict.get<List<triFace>>("triangles")
    ).standingFor
    (
        dict.getOrDefault<scalar>("scale", 1),
        dict.getOrDefault<scalar>("offset", 0)
    );
    setMass();
}
