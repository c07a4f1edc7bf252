/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "adsorbed.H"
#include "calculatedFvPatchFields.H"
#include "fluidRegion.H"
#include "ofAllProcessors.H"
#include "pointSearch.H"
#include "volFields.H"

namespace Foam
{
namespace fsbi
{

//- Calls for every face of the surface on this processor
template<class Function>
static void eachFace
(
    const soluteSurface& surface, const polyMesh& mesh, const Function& f
)
{
    const labelPair range(surface.faces(mesh));
    for (label i = range.first(); i < range.first() + range.second(); ++i)
    {
        f(i);
    }
}

} // End namespace fsbi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::adsorbed::adsorbed
(
    const fluidRegion& fluid,
    const word& solute,
    const PtrList<soluteSurface>& surfaces
)
:
    fluid_(fluid),
    solute_(solute),
    surfaces_(surfaces)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::fvMesh& Foam::fsbi::adsorbed::mesh() const
{
    return fluid_.mesh();
}


Foam::label Foam::fsbi::adsorbed::patch(const soluteSurface& surface) const
{
    return mesh().boundaryMesh().findPatchID(surface.name());
}


Foam::scalar Foam::fsbi::adsorbed::area(const label boundaryFace) const
{
    return mag(mesh().faceAreas()[mesh().nInternalFaces() + boundaryFace]);
}


bool Foam::fsbi::adsorbed::slides(const soluteSurface& surface) const
{
    const label patchi = patch(surface);
    return
        patchi >= 0 && !fluid_.meshing().isBody(surface.name())
     && gMax(mag(fluid_.U().boundaryField()[patchi])()) > 0;
}


Foam::fsbi::adsorbed::layer Foam::fsbi::adsorbed::layerOn
(
    const soluteSurface& surface
) const
{
    DynamicList<point> places;
    DynamicList<scalar> densities;
    scalar amount = 0;
    eachFace(surface, mesh(), [&](const label i)
    {
        places.append(mesh().faceCentres()[mesh().nInternalFaces() + i]);
        densities.append(now_[i]);
        amount += area(i)*now_[i];
    });
    return
    {
        ofAllProcessors(pointField(std::move(places))),
        ofAllProcessors(scalarField(std::move(densities))),
        returnReduce(amount, sumOp<scalar>())
    };
}


void Foam::fsbi::adsorbed::take(const soluteSurface& surface, const layer& was)
{
    if (was.places.empty())
    {
        eachFace(surface, mesh(), [&](const label i)
        {
            now_[i] = surface.start().held;
        });
        return;
    }
    const pointSearch old(was.places);
    scalarList sums(2, Zero);
    eachFace(surface, mesh(), [&](const label i)
    {
        const point& x = mesh().faceCentres()[mesh().nInternalFaces() + i];
        now_[i] = was.densities[old.nearest(x)];
        sums[0] += area(i)*now_[i];
        sums[1] += area(i)*(surface.sites() - now_[i]);
    });
    reduce(sums, sumOp<scalarList>());
    const scalar missing = was.amount - sums[0];
    const scalar part = missing/max(sums[missing > 0], VSMALL);
    eachFace(surface, mesh(), [&](const label i)
    {
        now_[i] +=
            missing > 0
          ? min(part, scalar(1))*(surface.sites() - now_[i])
          : part*now_[i];
    });
}


void Foam::fsbi::adsorbed::renew
(
    const soluteSurface& surface, occupiedSites& occupied
) const
{
    layer there(layerOn(surface));
    occupied.places = std::move(there.places);
    occupied.parts = min
    (
        max(there.densities/surface.sites(), scalar(0)), scalar(1)
    );
}


void Foam::fsbi::adsorbed::renewOccupied()
{
    for (const soluteSurface* surface : binding_)
    {
        const auto asked = occupied_.find(surface->name());
        if (asked != occupied_.end())
        {
            renew(*surface, asked->second);
        }
    }
}


Foam::volScalarField Foam::fsbi::adsorbed::field
(
    const IOobject::readOption read
) const
{
    const IOobject io
    (
        solute_ + ".bound", mesh().time().timeName(), mesh(), read,
        IOobject::NO_WRITE, false
    );
    return
        read == IOobject::MUST_READ
      ? volScalarField(io, mesh())
      : volScalarField
        (
            io, mesh(), dimensionedScalar(dimless, Zero),
            calculatedFvPatchScalarField::typeName
        );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsbi::adsorbed::start()
{
    for (const soluteSurface& surface : surfaces_)
    {
        if (surface.binds())
        {
            binding_.push_back(&surface);
        }
    }
    now_ = scalarField(mesh().nFaces() - mesh().nInternalFaces(), Zero);
    for (const soluteSurface* surface : binding_)
    {
        take(*surface, layer());
    }
    next_ = now_;
}


Foam::scalar Foam::fsbi::adsorbed::missing
(
    const soluteTransport& solution, const scalar dt
) const
{
    scalar largest = 0;
    for (const soluteSurface* binding : binding_)
    {
        const soluteSurface& surface = *binding;
        eachFace(surface, mesh(), [&](const label i)
        {
            const scalar c = max(solution.atWall()[i], scalar(0));
            const scalar bound = now_[i] + dt*solution.through()[i]/area(i);
            largest = max
            (
                largest,
                mag(bound - surface.boundAfter(now_[i], dt, c))/surface.sites()
            );
        });
    }
    return returnReduce(largest, maxOp<scalar>());
}


void Foam::fsbi::adsorbed::advance
(
    const soluteTransport& solution, const scalar dt
)
{
    next_ = now_;
    for (const soluteSurface* binding : binding_)
    {
        const soluteSurface& surface = *binding;
        eachFace(surface, mesh(), [&](const label i)
        {
            next_[i] += dt*solution.through()[i]/area(i);
        });
        if (slides(surface))
        {
            const scalar everywhere = mean(surface);
            eachFace(surface, mesh(), [&](const label i)
            {
                next_[i] = everywhere;
            });
        }
    }
}


Foam::scalar Foam::fsbi::adsorbed::mean(const soluteSurface& surface) const
{
    scalarList sums(2, Zero);
    eachFace(surface, mesh(), [&](const label i)
    {
        sums[0] += area(i)*next_[i];
        sums[1] += area(i);
    });
    reduce(sums, sumOp<scalarList>());
    return sums[0]/max(sums[1], VSMALL);
}


Foam::scalar Foam::fsbi::adsorbed::most(const soluteSurface& surface) const
{
    scalar largest = 0;
    eachFace(surface, mesh(), [&](const label i)
    {
        largest = max(largest, next_[i]);
    });
    return returnReduce(largest, maxOp<scalar>());
}


void Foam::fsbi::adsorbed::accept()
{
    now_ = next_;
    renewOccupied();
}


void Foam::fsbi::adsorbed::release()
{
    old_.clear();
    for (const soluteSurface* surface : binding_)
    {
        old_[surface->name()] = layerOn(*surface);
    }
}


void Foam::fsbi::adsorbed::renew()
{
    now_ = scalarField(mesh().nFaces() - mesh().nInternalFaces(), Zero);
    for (const soluteSurface* surface : binding_)
    {
        take(*surface, old_[surface->name()]);
    }
    next_ = now_;
    old_.clear();
}


const Foam::fsbi::occupiedSites& Foam::fsbi::adsorbed::occupied
(
    const word& surface, const dictionary& where
)
{
    DynamicList<word> valid;
    for (const soluteSurface* s : binding_)
    {
        valid.append(s->name());
    }
    if (!valid.found(surface))
    {
        FatalIOErrorInFunction(where)
            << "Species '" << solute_ << "' does not bind to '" << surface
            << "': in constant/species its 'surfaces' of type binding are "
            << flatOutput(valid) << exit(FatalIOError);
    }
    occupied_[surface];
    renewOccupied();
    return occupied_[surface];
}


void Foam::fsbi::adsorbed::write
(
    const std::function<void(const regIOobject&)>& add
) const
{
    if (binding_.empty())
    {
        return;
    }
    volScalarField bound(field(IOobject::NO_READ));
    for (const soluteSurface* surface : binding_)
    {
        const label patchi = patch(*surface);
        if (patchi >= 0)
        {
            fvPatchScalarField& pf = bound.boundaryFieldRef()[patchi];
            pf == SubField<scalar>
            (
                now_, pf.size(), surface->faces(mesh()).first()
            );
        }
    }
    add(bound);
}


void Foam::fsbi::adsorbed::restore()
{
    if (binding_.empty())
    {
        return;
    }
    const volScalarField bound(field(IOobject::MUST_READ));
    for (const soluteSurface* surface : binding_)
    {
        const label patchi = patch(*surface);
        if (patchi >= 0)
        {
            const fvPatchScalarField& pf = bound.boundaryField()[patchi];
            SubField<scalar>
            (
                now_, pf.size(), surface->faces(mesh()).first()
            ) = pf;
        }
    }
    next_ = now_;
}
