/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "recorder.H"
#include "runNotes.H"
#include "Time.H"
#include "OSspecific.H"

#include <cstdlib>

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

Foam::fsbi::recorder* Foam::fsbi::recorder::open_ = nullptr;


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
    ofEffects_(history_, time, "effects"),
    ofSpecies_(history_, time, "species"),
    steps_(time, scene)
{
    declare();
    for (const auto& note : runNotes(scene, defaults))
    {
        history_.note("runs"/time.timeName(), note.first, note.second);
    }
    history_.flush();           // readable from now on
    openSeries();
    open_ = this;
    std::atexit(flushAtExit);
}


Foam::fsbi::recorder::~recorder()
{
    flushAtExit();
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
    if (scene_.carried())
    {
        scene_.carried()->declare(ofSpecies_);
    }
    if (solvesFlow())
    {
        ends_ = scene_.fluid().endPatches();
        periodic_ = scene_.fluid().periodic();
    }
    for (const word& patch : ends_)
    {
        history_.declare
        (
            "flow"/patch, {"in", "out", "pressure"}, "L^3/T, L^3/T, M/L/T^2"
        );
    }
    if (periodic_)
    {
        history_.declare("flow/mean", {"x", "y", "z"}, "L/T");
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


bool Foam::fsbi::recorder::solvesFlow() const
{
    return scene_.hasFluid() && !scene_.fluid().reduced();
}


bool Foam::fsbi::recorder::estimatesError() const
{
    return
        solvesFlow()
     && scene_.fluid().error().expected(scene_.fluid().stokes());
}


Foam::fsbi::recorder::tables::tables
(
    historyFile& history, const Time& time, const word& group
)
:
    history_(history),
    time_(time),
    group_(group)
{}


void Foam::fsbi::recorder::tables::declare
(
    const fileName& path, const wordList& columns, const string& units
)
{
    history_.declare(group_/path, columns, units);
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
    if (solvesFlow())
    {
        history_.declare
        (
            path/"stresslet", {"xx", "xy", "xz", "yy", "yz", "zz"},
            "M L^2/T^2"
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
    scene_.effects()->declare(ofEffects_);
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
    if (body.hasCortex())
    {
        history_.declare
        (
            path/"cortex", {"area", "energy", "leastStretch", "mostStretch"},
            "L^2, M L^2/T^2, -, -"
        );
    }
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
        history_.declare(path/"shortestAxis", xyz, "-");
        history_.declare(path/"extents", xyz, "L");
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


void Foam::fsbi::recorder::append(const stepControl& steps)
{
    auto timer = scene_.clocks().measure("output");
    appendBodies();
    if (solvesFlow())
    {
        appendStresslets();
    }
    if (scene_.effects())
    {
        appendEffects();
    }
    if (scene_.carried())
    {
        scene_.carried()->record(ofSpecies_);
    }
    appendPassages();
    appendFlow();
    appendCost();
    steps_.accept(steps.gap(), steps.limit());
    // steps by a table of resistances take less time than writing one to files
    if (steps.saveDue() || sinceFlush_.elapsedTime() > 0.2)
    {
        flush();
    }
}


void Foam::fsbi::recorder::reject(const outcome& step)
{
    steps_.reject(step.reason);
    flush();                    // it may be the last thing a run says
}


void Foam::fsbi::recorder::flush()
{
    open_ = nullptr;            // not again if it ends in a fatal error
    history_.flush();
    for (OFstream& os : series_)
    {
        stepSeries::flush(os);
    }
    steps_.flush();
    sinceFlush_.resetTime();
    open_ = this;
}


void Foam::fsbi::recorder::flushAtExit()
{
    if (open_)
    {
        open_->flush();
        open_ = nullptr;
    }
}
