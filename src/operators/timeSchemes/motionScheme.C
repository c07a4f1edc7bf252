/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "motionScheme.H"

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(motionScheme, 0);
    defineRunTimeSelectionTable(motionScheme, entry);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::motionScheme::motionScheme()
:
    dt_(0),
    accelerationCoeff_(0),
    velocityCoeff_(0)
{}


Foam::autoPtr<Foam::fsbi::motionScheme> Foam::fsbi::motionScheme::New
(
    ITstream& entry
)
{
    entry.rewind();
    token first;
    if (entry.nRemainingTokens())
    {
        entry >> first;
    }
    const word type(first.isWord() ? first.wordToken() : word::null);

    auto constructor = entryConstructorTablePtr_->cfind(type);
    if (!constructor.found())
    {
        FatalIOErrorInFunction(entry)
            << "Unknown time scheme '" << type << "'; valid schemes are "
            << flatOutput(entryConstructorTablePtr_->sortedToc())
            << exit(FatalIOError);
    }
    return constructor()(entry);
}


Foam::scalarList Foam::fsbi::motionScheme::numbers
(
    ITstream& entry, const labelList& counts, const string& usage
)
{
    DynamicList<scalar> values;
    bool good = true;
    while (good && entry.nRemainingTokens())
    {
        const token t(entry);
        good = t.isNumber();
        values.append(good ? t.number() : 0);
    }
    if (!good || !counts.found(values.size()))
    {
        FatalIOErrorInFunction(entry)
            << "A time scheme is written as  " << usage.c_str()
            << exit(FatalIOError);
    }
    return scalarList(values);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsbi::motionScheme::beginStep(const scalar dt)
{
    if (dt_ > 0 || !(dt > 0))
    {
        FatalErrorInFunction
            << "A step of " << dt << " is begun, "
            << (dt_ > 0 ? "but another one is under way" : "not positive")
            << abort(FatalError);
    }
    prepare(dt);
    dt_ = dt;
}


void Foam::fsbi::motionScheme::rewind()
{
    dt_ = 0;
}


void Foam::fsbi::motionScheme::endStep
(
    const vectorField& u, const vectorField& R
)
{
    if (!(dt_ > 0) || u.size() != knownAcceleration_.size())
    {
        FatalErrorInFunction
            << "The step that ends "
            << (dt_ > 0 ? "has other cells than at its begin" : "is not begun")
            << abort(FatalError);
    }
    accept(dt_, u, R);
    dt_ = 0;
}


Foam::tmp<Foam::vectorField> Foam::fsbi::motionScheme::velocity
(
    const vectorField& u
) const
{
    return velocityCoeff_*u + knownVelocity_;
}


Foam::tmp<Foam::vectorField> Foam::fsbi::motionScheme::weighted
(
    const vectorField& R
) const
{
    return tmp<vectorField>::New(R);
}


Foam::string Foam::fsbi::motionScheme::warning
(
    const scalar dt, const scalar fastestFrequency
) const
{
    const scalar limit = stepLimit();
    if (dt*fastestFrequency <= limit)
    {
        return string();
    }
    OStringStream text;
    text<< "Time scheme " << type().c_str() << ": fastest angular frequency "
        << "times step is " << dt*fastestFrequency << ", above " << limit
        << " undamped oscillations grow. Take a step below "
        << limit/fastestFrequency << ", or an A-stable scheme: "
        << "generalisedAlpha, Newmark, Fornberg 1 or 2";
    return text.str();
}


void Foam::fsbi::motionScheme::save(dictionary& state) const
{
    if (dt_ > 0)
    {
        FatalErrorInFunction
            << "The state is saved within a step" << abort(FatalError);
    }
    state.set("scheme", word(type()));
}


void Foam::fsbi::motionScheme::restore(const dictionary& state)
{
    if (state.get<word>("scheme") != type())
    {
        FatalIOErrorInFunction(state)
            << "The run was saved with time scheme "
            << state.get<word>("scheme") << " and cannot continue with "
            << type() << exit(FatalIOError);
    }
    dt_ = 0;
}
