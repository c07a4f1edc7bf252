/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "trajectory.H"
#include "caseInput.H"
#include "fluidRegion.H"
#include "resistance.H"
#include "timeFunction.H"
#include "untrapped.H"

namespace Foam
{
namespace fsbi
{

//- The path in time
class path
{
    autoPtr<Function1<vector>> position_;
    autoPtr<Function1<vector>> spin_;

public:

    scalar start, end;
    label samples, meshes;

    //- 36 numbers; empty: from solutions
    scalarList given;

    path(const checkedDictionary& entries)
    :
        position_(timeFunction<vector>("position", entries)),
        start(entries.getOrDefault<scalar>("start", 0)),
        end(entries.get<scalar>("end")),
        samples(entries.getOrDefault<label>("samples", 100)),
        meshes(entries.getOrDefault<label>("meshes", 10)),
        given(entries.getOrDefault<scalarList>("resistance", scalarList()))
    {
        if (entries.found("angularVelocity"))
        {
            spin_ = timeFunction<vector>("angularVelocity", entries);
        }
        entries.finish();
        if (end <= start || samples < 3 || meshes < 1)
        {
            FatalIOErrorInFunction(entries.dict())
                << "'end' must be after 'start', 'samples' at least 3 and"
                << " 'meshes' at least 1" << exit(FatalIOError);
        }
        if (given.size() && given.size() != 36)
        {
            FatalIOErrorInFunction(entries.dict())
                << "'resistance' has " << given.size() << " numbers, not the"
                << " 36 of a 6 x 6 matrix" << exit(FatalIOError);
        }
    }

    point at(const scalar t) const { return position_->value(t); }

    //- By differences over the samples, within the path
    vector velocity(const scalar t) const
    {
        const scalar h = (end - start)/(samples - 1);
        const scalar a = max(t - h, start), b = min(t + h, end);
        if (b - a > 1.5*h)
        {
            return (at(b) - at(a))/(b - a);
        }
        const scalar s = b > t + 0.5*h ? h : -h;
        return (4*at(t + s) - at(t + 2*s) - 3*at(t))/(2*s);
    }

    bool free() const { return !spin_; }
    vector spin(const scalar t) const { return spin_->value(t); }
};


//- Resistance, and force and torque of flow and applied, at a place
static resistance resistanceAt
(
    const word& name, const dictionary& bodyDict, const point& x,
    const quaternion& q, const Time& time
)
{
    // `position` is the shape's centre, x that of mass
    const rigidBody atStart(name, bodyDict);
    const vector offset
    (
        atStart.rotation().T()
      & (atStart.start() - bodyDict.get<point>("position"))
    );
    dictionary placed(bodyDict);
    placed.set("position", point(x - (q.R() & offset)));
    const vector angle(angleOf(q));
    const scalar turn = mag(angle);
    placed.set
    (
        "orientation",
        Tuple2<vector, scalar>(turn > 0 ? angle/turn : vector(1, 0, 0), turn)
    );
    PtrList<rigidBody> bodies(1);
    bodies.set(0, new rigidBody(name, placed));
    UPtrList<immersedBody> immersed;
    immersed.append(&bodies[0]);
    timings clocks;
    fluidRegion fluid
    (
        time, caseInput::fluid, bodies, immersed, clocks, dictionary::null
    );
    checkResistance(fluid.momentum(), "Fields of fsbiFieldDesign");
    return resistanceOf(6, [&](const scalarField& motion)
    {
        const untrapped scope;
        List<bodyRows> rows(1, bodies[0].rows(time.value()));
        rows[0].free = FixedList<bool, 6>(false);
        List<sixVector> loads;
        forAll(motion, i)
        {
            rows[0].velocity[i] = motion[i];
        }
        if (!fluid.solve(rows, loads).converged)
        {
            FatalErrorInFunction
                << "The solver did not converge at the place " << x
                << exit(FatalError);
        }
        scalarField flat(6);
        forAll(flat, i)
        {
            flat[i] = loads[0][i];
        }
        return flat;
    });
}


//- Angular velocity: given, or without a torque of the magnets
static vector spinAt
(
    const path& p, const scalar t, const resistance& r,
    const sixVector& applied
)
{
    if (!p.free())
    {
        return p.spin(t);
    }
    const vector U(p.velocity(t));
    tensor W;
    vector torque;
    for (direction i = 0; i < 3; ++i)
    {
        torque[i] = r.flow[3 + i] + applied[3 + i];
        for (direction j = 0; j < 3; ++j)
        {
            torque[i] -= r.R(3 + i, j)*U[j];
            W(i, j) = r.R(3 + i, 3 + j);
        }
    }
    return inv(W) & torque;
}


//- Force and torque that the magnets must add
static sixVector missing
(
    const path& p, const scalar t, const vector& spin, const resistance& r,
    const sixVector& applied
)
{
    const sixVector motion(join(p.velocity(t), spin));
    sixVector load;
    for (label i = 0; i < 6; ++i)
    {
        load[i] = -r.flow[i] - applied[i];
        for (label j = 0; j < 6; ++j)
        {
            load[i] += r.R(i, j)*motion[j];
        }
        if (i >= 3 && p.free())
        {
            load[i] = 0;
        }
    }
    return load;
}


//- Between places that are one apart: Lagrange's cubic through the four
//  nearest, or what there are
static resistance interpolated
(
    const List<resistance>& known, const scalar at
)
{
    const label n = min(known.size(), 4);
    const label first = max(min(label(at) - 1, known.size() - n), 0);
    resistance r{scalarSquareMatrix(6, 6, Zero), scalarField(6, Zero)};
    for (label k = first; k < first + n; ++k)
    {
        scalar weight = 1;
        for (label l = first; l < first + n; ++l)
        {
            weight *= l == k ? 1 : (at - l)/(k - l);
        }
        for (label i = 0; i < 6; ++i)
        {
            r.flow[i] += weight*known[k].flow[i];
            for (label j = 0; j < 6; ++j)
            {
                r.R(i, j) += weight*known[k].R(i, j);
            }
        }
    }
    return r;
}


//- At the ends of equal parts of the path
static List<resistance> resistancesAlong
(
    const path& p, const word& name, const dictionary& bodyDict,
    const rigidBody& body, const Time& time
)
{
    if (p.given.size())
    {
        resistance r{scalarSquareMatrix(6, 6, Zero), scalarField(6, Zero)};
        forAll(p.given, i)
        {
            r.R(i/6, i % 6) = p.given[i];
        }
        return List<resistance>(1, r);
    }
    List<resistance> all(p.meshes);
    quaternion q(body.now().orientation);
    const scalar dt = (p.end - p.start)/max(p.meshes - 1, 1);
    forAll(all, k)
    {
        const scalar t = p.start + k*dt;
        all[k] = resistanceAt(name, bodyDict, p.at(t), q, time);
        Info<< "Resistance at " << p.at(t) << ": along x "
            << all[k].R(0, 0) << endl;
        const vector spin(spinAt(p, t, all[k], body.applied(t)));
        q = rotationBy(dt*spin)*q;
        q /= mag(q);
    }
    return all;
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::loadTrajectory Foam::fsbi::pathTrajectory
(
    const dictionary& trajectory, const word& name, const dictionary& bodyDict,
    const Time& time
)
{
    const path p{checkedDictionary(trajectory)};
    const rigidBody body(name, bodyDict);
    const auto known(resistancesAlong(p, name, bodyDict, body, time));
    const label last = known.size() - 1;
    const scalar dt = (p.end - p.start)/(p.samples - 1);
    quaternion q(body.now().orientation);
    loadTrajectory c;
    for (label n = 0; n < p.samples; ++n)
    {
        const scalar t = p.start + n*dt;
        const scalar at = scalar(n)/(p.samples - 1)*last;
        const resistance r(interpolated(known, at));
        const sixVector applied(body.applied(t));
        const vector spin(spinAt(p, t, r, applied));
        const sixVector load(missing(p, t, spin, r, applied));
        c.append({t, p.at(t), q.R(), linear(load), angular(load)});
        q = rotationBy(dt*spin)*q;
        q /= mag(q);
    }
    return c;
}
