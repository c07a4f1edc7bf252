/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "opticalTweezers.H"
#include "prescribedBody.H"
#include "timeFunction.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{

defineTypeNameAndDebug(opticalTweezers, 0);
addToRunTimeSelectionTable(effect, opticalTweezers, entries);

} // End namespace fsbi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::opticalTweezers::opticalTweezers
(
    const dictionary& dict, const effectContext& context
)
:
    effect(context)
{
    const checkedDictionary entries(dict);
    entries.found("libs");
    Info<< "Optical tweezers:" << nl;
    for (const entry& e : dict)
    {
        if (e.keyword() == "libs")
        {
            continue;
        }
        autoPtr<trap> t(new trap);
        t->name = e.keyword();
        read(*t, entries.subDict(e.keyword()));
        traps_.append(t.ptr());
    }
    Info<< endl;
    if (traps_.empty())
    {
        FatalIOErrorInFunction(dict)
            << "'opticalTweezers' has no trap: name { body ...; position ...;"
            << " stiffness ...; }" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsbi::opticalTweezers::read(trap& t, const dictionary& dict) const
{
    const checkedDictionary entries(dict);
    t.body = context_.bodyIndex(entries.get<word>("body"), dict);
    const immersedBody& body = context_.bodies[t.body];
    if (isA<prescribedBody>(body))
    {
        FatalIOErrorInFunction(dict)
            << "Body '" << body.name() << "' has a given motion, which a trap"
            << " cannot change" << exit(FatalIOError);
    }
    if (body.deforms() != entries.found("bead"))
    {
        FatalIOErrorInFunction(dict)
            << "Body '" << body.name() << "' is "
            << (body.deforms() ? "elastic: a trap holds it by a" : "rigid: a"
                " trap holds its centre, there is no")
            << " 'bead { position ...; radius ...; }'" << exit(FatalIOError);
    }
    readPull(t, entries);
    Info<< "    " << t.name << ": " << body.name();
    if (body.deforms())
    {
        glue(t, checkedDictionary(entries.subDict("bead")));
    }
    Info<< nl;
    entries.finish();
}


void Foam::fsbi::opticalTweezers::readPull
(
    trap& t, const checkedDictionary& entries
) const
{
    if (!entries.found("force"))
    {
        t.position = timeFunction<vector>("position", entries);
        t.stiffness = entries.positive("stiffness");
        return;
    }
    const bool spring = entries.found("position") || entries.found("stiffness");
    const immersedBody& body = context_.bodies[t.body];
    if (spring || !body.deforms())
    {
        FatalIOErrorInFunction(entries.dict())
            << "'force' is "
            << (spring ? "there in place of 'position' and 'stiffness'"
                : "of a bead on an elastic body; a rigid one has its own"
                " 'force' in constant/bodies")
            << ": remove one of them" << exit(FatalIOError);
    }
    t.force = timeFunction<vector>("force", entries);
}


void Foam::fsbi::opticalTweezers::glue
(
    trap& t, const checkedDictionary& bead
) const
{
    const point position(bead.get<point>("position"));
    const scalar radius = bead.positive("radius");
    bead.finish();

    const bodySurface s(context_.bodies[t.body].stressFree());
    scalar area = 0;
    scalar nearest = GREAT;
    vector mean(Zero);
    forAll(s.triangles(), i)
    {
        const point centre(s.triangles()[i].centre(s.points()));
        nearest = min(nearest, mag(centre - position));
        if (mag(centre - position) <= radius)
        {
            const scalar A = s.triangles()[i].mag(s.points());
            t.parts.append({i, A, centre});
            area += A;
            mean += A*centre;
        }
    }
    if (t.parts.empty())
    {
        FatalIOErrorInFunction(bead.dict())
            << "The bead of '" << t.name << "' holds no triangle of '"
            << context_.bodies[t.body].name() << "': the centre of the"
            << " nearest is " << nearest << " away, its radius is " << radius
            << exit(FatalIOError);
    }
    mean /= area;
    for (part& p : t.parts)
    {
        p.share /= area;
        p.offset -= mean;
    }
    Info<< ", " << t.parts.size() << " triangles of area " << area;
}


Foam::point Foam::fsbi::opticalTweezers::holds(const trap& t) const
{
    const immersedBody& body = context_.bodies[t.body];
    if (t.parts.empty())
    {
        return body.placed().centre;
    }
    const bodySurface s(body.placedSurface());
    point mean(Zero);
    for (const part& p : t.parts)
    {
        mean += p.share*s.triangles()[p.triangle].centre(s.points());
    }
    return mean;
}


Foam::vector Foam::fsbi::opticalTweezers::pull
(
    const trap& t, const point& held
) const
{
    const scalar now = context_.time.value();
    return
        t.force.valid()
      ? t.force->value(now)
      : t.stiffness*(t.position->value(now) - held);
}


void Foam::fsbi::opticalTweezers::applyBead(const trap& t, loads& l) const
{
    const immersedBody& body = context_.bodies[t.body];
    const bodySurface s(body.placedSurface());
    const point centre(body.placed().centre);
    for (const part& p : t.parts)
    {
        const point x(s.triangles()[p.triangle].centre(s.points()));
        l.add
        ({
            {t.body, p.triangle, x - centre}, {loads::fixed},
            p.share*pull(t, x - p.offset), p.share*t.stiffness*tensor::I
        });
    }
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

void Foam::fsbi::opticalTweezers::apply(loads& l) const
{
    for (const trap& t : traps_)
    {
        if (!context_.bodies[t.body].present())
        {
            continue;
        }
        if (t.parts.size())
        {
            applyBead(t, l);
            continue;
        }
        loads::sixMatrix K(sixVector(scalar(0)));
        for (label k = 0; k < 3; ++k)
        {
            K[k][k] = t.stiffness;
        }
        l.add(t.body, join(pull(t, holds(t)), Zero), K);
    }
}


void Foam::fsbi::opticalTweezers::declare(recording& history) const
{
    for (const trap& t : traps_)
    {
        const fileName path("opticalTweezers"/t.name);
        history.declare(path/"force", {"x", "y", "z"}, "M L/T^2");
        history.declare(path/"holds", {"x", "y", "z"}, "L");
    }
}


void Foam::fsbi::opticalTweezers::record(recording& history) const
{
    for (const trap& t : traps_)
    {
        if (!context_.bodies[t.body].present())
        {
            continue;
        }
        const fileName path("opticalTweezers"/t.name);
        const point x(holds(t));
        const vector F(pull(t, x));
        history.append(path/"force", scalarList({F.x(), F.y(), F.z()}));
        history.append(path/"holds", scalarList({x.x(), x.y(), x.z()}));
    }
}
