/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// What a species reads, records, saves and restores

#include "solute.H"
#include "boundBox.H"
#include "calculatedFvPatchFields.H"
#include "fluidRegion.H"

namespace Foam
{
namespace fsbi
{

//- Names that the region's own fields have
static bool ofTheFlow(const word& name)
{
    return wordHashSet({"U", "p", "points", "referencePoints"}).found(name);
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::solute::solute
(
    const fluidRegion& fluid, const dictionary& dict, const dictionary& saved
)
:
    fluid_(fluid),
    name_(dict.dictName()),
    bound_(fluid, name_, surfaces_)
{
    if (ofTheFlow(name_))
    {
        FatalIOErrorInFunction(dict)
            << "A species cannot have the name '" << name_ << "', which is that"
            << " of a field of the flow" << exit(FatalIOError);
    }
    const checkedDictionary entries(dict);
    diffusivity_ = entries.positive("diffusivity");
    decay_ = entries.getOrDefault<scalar>("decay", 0);
    tolerance_ = entries.tolerance("tolerance", 1e-9);
    readSurfaces(entries.subDictOrEmpty("surfaces"));
    if (!(decay_ >= 0))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'decay' must not be negative, but is " << decay_
            << exit(FatalIOError);
    }
    now_.surfaces.setSize(surfaces_.size());
    forAll(surfaces_, s)
    {
        now_.surfaces[s] = surfaces_[s].start();
    }
    bound_.start();
    setInitial(entries);
    entries.finish();
    if (saved.size())
    {
        restore(saved);
    }
    else
    {
        now_.began = amount();
    }
    next_ = now_;
}


void Foam::fsbi::solute::readSurfaces(const dictionary& dict)
{
    for (const entry& e : dict)
    {
        if (!e.isDict())
        {
            FatalIOErrorInFunction(dict)
                << "Entry '" << e.keyword() << "' of 'surfaces' is no"
                << " dictionary: a surface is name { type uptake; k ...; }"
                << exit(FatalIOError);
        }
        surfaces_.append(new soluteSurface(e.dict()));
        checkPatch(surfaces_.last(), e.dict());
    }
}


void Foam::fsbi::solute::checkPatch
(
    const soluteSurface& surface, const dictionary& dict
) const
{
    wordList valid(namesOf(fluid_.meshing().bodies()));
    const wordList bodies(valid);
    for (const polyPatch& pp : fluid_.mesh().boundaryMesh())
    {
        if (!pp.coupled() && !valid.found(pp.name()))
        {
            valid.append(pp.name());
        }
    }
    if (!valid.found(surface.name()))
    {
        FatalIOErrorInFunction(dict)
            << "There is no body or patch '" << surface.name() << "'; valid"
            << " names are " << flatOutput(valid) << exit(FatalIOError);
    }
    if (surface.isInflow() && bodies.found(surface.name()))
    {
        FatalIOErrorInFunction(dict)
            << "Nothing flows in through body '" << surface.name() << "'. Valid"
            << " types of bodies are (fixedConcentration release uptake"
            << " binding)"
            << exit(FatalIOError);
    }
}


void Foam::fsbi::solute::setInitial(const checkedDictionary& entries)
{
    const auto concentration = [](const checkedDictionary& d, const word& key)
    {
        const scalar c = d.getOrDefault<scalar>(key, 0);
        if (!(c >= 0))
        {
            FatalIOErrorInFunction(d.dict())
                << "Entry '" << key << "' must not be negative, but is " << c
                << exit(FatalIOError);
        }
        return c;
    };
    now_.c = scalarField
    (
        fluid_.mesh().nCells(), concentration(entries, "initial")
    );
    if (entries.found("box"))
    {
        const checkedDictionary box(entries.subDict("box"));
        const boundBox where(box.get<point>("min"), box.get<point>("max"));
        const scalar c = concentration(box, "concentration");
        box.finish();
        forAll(now_.c, celli)
        {
            if (where.contains(fluid_.mesh().cellCentres()[celli]))
            {
                now_.c[celli] = c;
            }
        }
    }
}


void Foam::fsbi::solute::declare(recording& history) const
{
    history.declare
    (
        name_/"balance",
        {
            "fluid", "released", "takenUp", "entered", "decayed", "displaced",
            "error", "min", "max", "levelled", "residual"
        },
        "N, N, N, N, N, N, -, N/L^3, N/L^3, N, -"
    );
    for (const soluteSurface& surface : surfaces_)
    {
        history.declare
        (
            fileName(name_)/"surfaces"/surface.name(),
            surface.binds()
          ? wordList({"rate", "released", "held", "concentration", "heldMost"})
          : wordList({"rate", "released", "held", "concentration"}),
            surface.binds()
          ? "N/T, N, N/L^2, N/L^3, N/L^2" : "N/T, N, N, N/L^3"
        );
    }
}


void Foam::fsbi::solute::record(recording& history) const
{
    history.append
    (
        name_/"balance",
        scalarList
        ({
            amount(), now_.released, now_.takenUp, now_.entered, now_.decayed,
            now_.displaced, imbalance(), gMin(now_.c), gMax(now_.c), now_.moved,
            now_.residual
        })
    );
    forAll(surfaces_, s)
    {
        const soluteSurface::memory& m = now_.surfaces[s];
        scalarList row({m.rate, m.released, m.held, m.wall});
        if (surfaces_[s].binds())
        {
            row.append(bound_.most(surfaces_[s]));
        }
        history.append(fileName(name_)/"surfaces"/surfaces_[s].name(), row);
    }
}


void Foam::fsbi::solute::write
(
    const std::function<void(const regIOobject&)>& add
) const
{
    const fvMesh& mesh = fluid_.mesh();
    volScalarField c
    (
        IOobject
        (
            name_, mesh.time().timeName(), mesh, IOobject::NO_READ,
            IOobject::NO_WRITE, false
        ),
        mesh,
        dimensionedScalar(dimless, Zero),
        calculatedFvPatchScalarField::typeName
    );
    c.primitiveFieldRef() = now_.c;
    forAll(c.boundaryField(), patchi)
    {
        fvPatchScalarField& pf = c.boundaryFieldRef()[patchi];
        if (!pf.coupled())
        {
            pf == pf.patchInternalField();
        }
    }
    c.correctBoundaryConditions();
    add(c);
    bound_.write(add);
}


void Foam::fsbi::solute::save(dictionary& state) const
{
    dictionary surfaces;
    forAll(surfaces_, s)
    {
        const soluteSurface::memory& m = now_.surfaces[s];
        surfaces.set
        (
            surfaces_[s].name(),
            scalarList({m.held, m.released, m.rate, m.wall})
        );
    }
    state.set("surfaces", surfaces);
    state.set
    (
        "account",
        scalarList
        ({
            now_.began, now_.released, now_.takenUp, now_.entered,
            now_.decayed, now_.displaced, now_.moved
        })
    );
}


void Foam::fsbi::solute::restore(const dictionary& saved)
{
    const fvMesh& mesh = fluid_.mesh();
    now_.c = volScalarField
    (
        IOobject
        (
            name_, mesh.time().timeName(), mesh, IOobject::MUST_READ,
            IOobject::NO_WRITE, false
        ),
        mesh
    ).primitiveField();
    const scalarList a(saved.get<scalarList>("account"));
    now_.began = a[0];
    now_.released = a[1];
    now_.takenUp = a[2];
    now_.entered = a[3];
    now_.decayed = a[4];
    now_.displaced = a[5];
    now_.moved = a[6];
    const dictionary& surfaces = saved.subDict("surfaces");
    forAll(surfaces_, s)
    {
        if (surfaces.found(surfaces_[s].name()))
        {
            const scalarList m
            (
                surfaces.get<scalarList>(surfaces_[s].name())
            );
            now_.surfaces[s] = {m[0], m[1], m[2], m[3]};
        }
    }
    bound_.restore();
}
