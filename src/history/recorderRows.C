/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// What recorder writes at the end of every step

#include "recorder.H"
#include "equivalentEllipsoid.H"
#include "Time.H"

void Foam::fsbi::recorder::tables::append
(
    const fileName& path, const UList<scalar>& row
)
{
    history_.append(group_/path, time_.value(), row);
}


void Foam::fsbi::recorder::appendStresslets()
{
    const fileNameList all(paths());
    forAll(all, b)
    {
        if (!scene_.bodies().immersed[b].present())
        {
            continue;
        }
        const symmTensor s(scene_.fluid().stresslet(b));
        history_.append
        (
            all[b]/"stresslet", time_.value(),
            scalarList({s.xx(), s.xy(), s.xz(), s.yy(), s.yz(), s.zz()})
        );
    }
}


void Foam::fsbi::recorder::appendEffects()
{
    const scalar t = time_.value();
    const fileNameList all(paths());
    forAll(all, b)
    {
        if (!scene_.bodies().immersed[b].present())
        {
            continue;
        }
        const sixVector& f = scene_.effectLoad(b);
        history_.append
        (
            all[b]/"force"/"effects", t, scalarList({f[0], f[1], f[2]})
        );
        history_.append
        (
            all[b]/"torque"/"effects", t, scalarList({f[3], f[4], f[5]})
        );
    }
    scene_.effects()->record(ofEffects_);
}


void Foam::fsbi::recorder::appendSeries
(
    OFstream& os,
    const bodyState& s
) const
{
    const auto add = [&](const vector& v)
    {
        os << ' ' << v.x() << ' ' << v.y() << ' ' << v.z();
    };
    os << time_.value();
    add(s.centre);
    os << ' ' << s.orientation.w();
    add(s.orientation.v());
    add(linear(s.velocity));
    add(angular(s.velocity));
    add(linear(s.load));
    add(angular(s.load));
    os << nl;
}


void Foam::fsbi::recorder::appendSeries
(
    OFstream& os,
    const solidRegion& body
) const
{
    const solidMeasures& m = body.measures();
    os << time_.value();
    for (const vector& v : {m.centre, m.momentum, m.angularMomentum})
    {
        os << ' ' << v.x() << ' ' << v.y() << ' ' << v.z();
    }
    for
    (
        const scalar s :
        {m.elastic, m.kinetic, m.work, m.minJ, m.minStretch, m.maxStretch}
    )
    {
        os << ' ' << s;
    }
    if (scene_.hasFluid())
    {
        const equivalentEllipsoid shape(body.surface().placedSurface());
        const vector& f = body.fluidForce();
        const vector& a = shape.axes;
        const vector e(shape.directions.x());
        os  << ' ' << f.x() << ' ' << f.y() << ' ' << f.z() << ' '
            << shape.volume << ' ' << a.x() << ' ' << a.y() << ' ' << a.z()
            << ' ' << e.x() << ' ' << e.y() << ' ' << e.z();
    }
    os << nl;
}


void Foam::fsbi::recorder::appendMotion
(
    const word& body, const bodyState& s
)
{
    const scalar t = time_.value();
    const fileName path("bodies"/body);
    const auto add = [&](const fileName& table, const vector& v)
    {
        history_.append(path/table, t, scalarList({v.x(), v.y(), v.z()}));
    };
    const vector& q = s.orientation.v();
    add("position", s.centre);
    history_.append
    (
        path/"orientation", t,
        scalarList({s.orientation.w(), q.x(), q.y(), q.z()})
    );
    add("velocity", linear(s.velocity));
    add("angularVelocity", angular(s.velocity));
    add("force/fluid", linear(s.load));
    add("torque/fluid", angular(s.load));
}


void Foam::fsbi::recorder::appendHistory(const rigidBody& body)
{
    const scalar t = time_.value();
    const fileName path("bodies"/body.name());
    const auto add = [&](const fileName& table, const vector& v)
    {
        history_.append(path/table, t, scalarList({v.x(), v.y(), v.z()}));
    };
    const sixVector applied(body.applied(t));
    appendMotion(body.name(), body.now());
    add("force/applied", linear(applied));
    add("torque/applied", angular(applied));
}


void Foam::fsbi::recorder::appendHistory(const solidRegion& body)
{
    const scalar t = time_.value();
    const fileName path("elasticBodies"/body.name());
    const solidMeasures& m = body.measures();
    const auto add = [&](const fileName& table, const vector& v)
    {
        history_.append(path/table, t, scalarList({v.x(), v.y(), v.z()}));
    };
    add("energy", vector(m.elastic, m.kinetic, m.work));
    add("momentum", m.momentum);
    add("angularMomentum", m.angularMomentum);
    add("centre", m.centre);
    add("deformation", vector(m.minJ, m.minStretch, m.maxStretch));
    if (body.hasCortex())
    {
        history_.append
        (
            path/"cortex", t,
            scalarList
            ({
                m.skin.area, m.skin.energy, m.skin.leastStretch,
                m.skin.mostStretch
            })
        );
    }
    if (scene_.hasFluid())
    {
        const bodySurface surface(body.surface().placedSurface());
        const equivalentEllipsoid shape(surface);
        add("fluidForce", body.fluidForce());
        add("tether", body.tether());
        history_.append(path/"volume", t, scalarList(1, shape.volume));
        add("semiAxes", shape.axes);
        add("longestAxis", shape.directions.x());
        add("shortestAxis", shape.directions.z());
        add("extents", surface.bounds().span());
    }
    for (const word& patch : body.heldPatches())
    {
        add("reaction"/patch, body.reaction(patch));
    }
}


void Foam::fsbi::recorder::appendPassages()
{
    for (const bodyPassage& p : scene_.traffic().passages())
    {
        history_.declare
        (
            "traffic", {"body", "enters", "x", "y", "z"},
            "-, -, L, L, L"
        );
        const word& name = scene_.bodies().immersed[p.body].name();
        history_.append
        (
            "traffic", time_.value(),
            scalarList
            ({
                scalar(scene_.bodies().place(name)), scalar(p.enters),
                p.centre.x(), p.centre.y(), p.centre.z()
            })
        );
    }
}


void Foam::fsbi::recorder::appendFlow()
{
    for (const word& patch : ends_)
    {
        const patchFlow flow(scene_.fluid().flowThrough(patch));
        history_.append
        (
            "flow"/patch, time_.value(),
            scalarList({flow.in, flow.out, flow.pressure})
        );
    }
    if (periodic_)
    {
        const vector mean(scene_.fluid().meanVelocity());
        history_.append
        (
            "flow/mean", time_.value(), scalarList({mean.x(), mean.y(), mean.z()})
        );
    }
}


void Foam::fsbi::recorder::appendCost()
{
    if (estimatesError())
    {
        history_.append
        (
            "accuracy", time_.value(),
            scalarList(1, scene_.fluid().error().relative())
        );
    }
    history_.append
    (
        "cost", time_.value(),
        scalarList
        ({
            time_.deltaTValue(), scalar(scene_.report().iterations),
            scalar(scene_.report().corrections),
            scene_.clocks().seconds("solve"), scalar(scene_.nCells()),
            scalar
            (
                scene_.hasFluid() ? scene_.fluid().meshing().generation() : 0
            )
        })
    );
}


void Foam::fsbi::recorder::appendBodies()
{
    const bodyList& bodies = scene_.bodies();
    label series = 0;
    const auto write = [&](const auto& state)
    {
        if (Pstream::master())
        {
            appendSeries(series_[series], state);
        }
    };
    for (const rigidBody& body : bodies.rigid)
    {
        if (body.present())
        {
            appendHistory(body);
            write(body.now());
        }
        ++series;
    }
    for (const solidRegion& body : bodies.elastic)
    {
        if (!scene_.hasFluid() || body.surface().present())
        {
            appendHistory(body);
            write(body);
        }
        ++series;
    }
    for (const prescribedBody& body : bodies.prescribed)
    {
        if (body.present())
        {
            appendMotion(body.name(), body.now());
            write(body.now());
        }
        ++series;
    }
}
