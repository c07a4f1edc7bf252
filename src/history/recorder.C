/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "recorder.H"
#include "equivalentEllipsoid.H"
#include "runNotes.H"
#include "Time.H"
#include "OSspecific.H"

namespace Foam
{

//- A new run begins a new history
static fileName historyOf(const Time& time, const bool restarted)
{
    const fileName file(time.globalPath()/"postProcessing"/"history.h5");
    if (!restarted && Pstream::master())
    {
        rm(file);
    }
    return file;
}

} // End namespace Foam


Foam::fsbi::recorder::recorder
(
    const Time& time,
    scene& scene,
    const bool restarted,
    const UList<string>& defaults
)
:
    time_(time),
    scene_(scene),
    history_(historyOf(time, restarted), time.value()),
    steps_(time, scene)
{
    declare();
    for (const auto& note : runNotes(scene, defaults))
    {
        history_.note("runs"/time.timeName(), note.first, note.second);
    }
    history_.flush();           // readable from now on
    openSeries();
}


void Foam::fsbi::recorder::declare()
{
    for (const rigidBody& body : scene_.bodies().rigid)
    {
        declareMotion(body.name(), {"fluid", "applied"});
    }
    for (const prescribedBody& body : scene_.bodies().prescribed)
    {
        declareMotion(body.name(), {"fluid"});
    }
    for (const solidRegion& body : scene_.bodies().elastic)
    {
        declareElastic(body);
    }
    if (scene_.effects())
    {
        declareEffects();
    }
    if (scene_.hasFluid())
    {
        open_ = scene_.fluid().openPatches();
    }
    for (const word& patch : open_)
    {
        history_.declare
        (
            "flow"/patch, {"outflow", "pressure"}, "L^3/T, M/L/T^2"
        );
    }
    if (estimatesError())
    {
        history_.declare("accuracy", {"forces"}, "-");
    }
    history_.declare
    (
        "cost",
        {"step", "iterations", "corrections", "seconds", "cells", "meshes"},
        "T, -, -, s, -, -"
    );
}


bool Foam::fsbi::recorder::estimatesError() const
{
    return
        scene_.hasFluid()
     && scene_.fluid().error().expected(scene_.fluid().stokes());
}


void Foam::fsbi::recorder::declare
(
    const fileName& path, const wordList& columns, const string& units
)
{
    history_.declare("effects"/path, columns, units);
}


void Foam::fsbi::recorder::append
(
    const fileName& path, const UList<scalar>& row
)
{
    history_.append("effects"/path, time_.value(), row);
}


void Foam::fsbi::recorder::declareMotion
(
    const word& body, const wordList& sources
)
{
    const wordList xyz({"x", "y", "z"});
    const fileName path("bodies"/body);
    history_.declare(path/"position", xyz, "L");
    history_.declare(path/"orientation", {"w", "x", "y", "z"}, "quaternion");
    history_.declare(path/"velocity", xyz, "L/T");
    history_.declare(path/"angularVelocity", xyz, "rad/T");
    for (const word& source : sources)
    {
        history_.declare(path/"force"/source, xyz, "M L/T^2");
        history_.declare(path/"torque"/source, xyz, "M L^2/T^2");
    }
    declareStresslet(path);
}


void Foam::fsbi::recorder::declareStresslet(const fileName& path)
{
    if (scene_.hasFluid())
    {
        history_.declare
        (
            path/"stresslet", {"xx", "xy", "xz", "yy", "yz", "zz"},
            "M L^2/T^2"
        );
    }
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


Foam::fileNameList Foam::fsbi::recorder::paths() const
{
    DynamicList<fileName> all;
    for (const rigidBody& body : scene_.bodies().rigid)
    {
        all.append("bodies"/body.name());
    }
    for (const solidRegion& body : scene_.bodies().elastic)
    {
        all.append("elasticBodies"/body.name());
    }
    for (const prescribedBody& body : scene_.bodies().prescribed)
    {
        all.append("bodies"/body.name());
    }
    return fileNameList(std::move(all));
}


void Foam::fsbi::recorder::declareEffects()
{
    const wordList xyz({"x", "y", "z"});
    for (const fileName& path : paths())
    {
        history_.declare(path/"force"/"effects", xyz, "M L/T^2");
        history_.declare(path/"torque"/"effects", xyz, "M L^2/T^2");
    }
    scene_.effects()->declare(*this);
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
    scene_.effects()->record(*this);
}


void Foam::fsbi::recorder::declareElastic(const solidRegion& body)
{
    const wordList xyz({"x", "y", "z"});
    const fileName path("elasticBodies"/body.name());
    history_.declare
    (
        path/"energy", {"elastic", "kinetic", "work"}, "M L^2/T^2"
    );
    history_.declare(path/"momentum", xyz, "M L/T");
    history_.declare(path/"angularMomentum", xyz, "M L^2/T");
    history_.declare(path/"centre", xyz, "L");
    history_.declare
    (
        path/"deformation", {"minJ", "minStretch", "maxStretch"}, "-"
    );
    if (scene_.hasFluid())
    {
        declareStresslet(path);
        history_.declare(path/"fluidForce", xyz, "M L/T^2");
        history_.declare(path/"tether", xyz, "M L/T^2");
        history_.declare(path/"volume", {"now"}, "L^3");
        history_.declare
        (
            path/"semiAxes", {"longest", "middle", "shortest"}, "L"
        );
        history_.declare(path/"longestAxis", xyz, "-");
    }
    for (const word& patch : body.heldPatches())
    {
        history_.declare(path/"reaction"/patch, xyz, "M L/T^2");
    }
}


void Foam::fsbi::recorder::openSeries()
{
    if (!Pstream::master())
    {
        return;
    }
    const string motion
    (
        "position(xyz) quaternion(wxyz) velocity(xyz)"
        " angularVelocity(xyz) fluidForce(xyz) fluidTorque(xyz)"
    );
    for (const rigidBody& body : scene_.bodies().rigid)
    {
        openSeries(body.name(), motion);
    }
    for (const solidRegion& body : scene_.bodies().elastic)
    {
        openSeries
        (
            body.name(),
            "centre(xyz) momentum(xyz) angularMomentum(xyz) elasticEnergy"
            " kineticEnergy work minJ minStretch maxStretch"
          + string
            (
                scene_.hasFluid()
              ? " fluidForce(xyz) volume semiAxes(longest middle shortest)"
                " longestAxis(xyz)"
              : ""
            )
        );
    }
    for (const prescribedBody& body : scene_.bodies().prescribed)
    {
        openSeries(body.name(), motion);
    }
}


void Foam::fsbi::recorder::openSeries(const word& body, const string& columns)
{
    const fileName folder
    (
        time_.globalPath()/"postProcessing"/"bodies"/time_.timeName()
    );
    mkDir(folder);
    series_.append(new OFstream(folder/body + ".dat"));
    series_.last().precision(10);
    series_.last() << "# time " << columns.c_str() << nl;
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
    finishRow(os);
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
    finishRow(os);
}


void Foam::fsbi::recorder::finishRow(OFstream& os) const
{
    os << endl;
    stepSeries::check(os);
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
    if (scene_.hasFluid())
    {
        const equivalentEllipsoid shape(body.surface().placedSurface());
        add("fluidForce", body.fluidForce());
        add("tether", body.tether());
        history_.append(path/"volume", t, scalarList(1, shape.volume));
        add("semiAxes", shape.axes);
        add("longestAxis", shape.directions.x());
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
    for (const word& patch : open_)
    {
        const Pair<scalar> flow(scene_.fluid().flowThrough(patch));
        history_.append
        (
            "flow"/patch, time_.value(),
            scalarList({flow.first(), flow.second()})
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


void Foam::fsbi::recorder::append
(
    const Foam::string& limit, const scalar gap
)
{
    auto timer = scene_.clocks().measure("output");
    appendBodies();
    if (scene_.hasFluid())
    {
        appendStresslets();
    }
    if (scene_.effects())
    {
        appendEffects();
    }
    appendPassages();
    appendFlow();
    appendCost();
    history_.flush();
    steps_.accept(gap, limit);
}


void Foam::fsbi::recorder::reject(const outcome& step)
{
    steps_.reject(step.reason);
}
