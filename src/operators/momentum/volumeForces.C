/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "volumeForces.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{

defineTypeNameAndDebug(volumeForces, 0);
addToRunTimeSelectionTable(momentumTerm, volumeForces, entries);

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::volumeForces::volumeForces
(
    const fvMesh& mesh, const dictionary& dict
)
:
    momentumTerm(mesh)
{
    for (const entry& e : dict)
    {
        if (!e.isDict())
        {
            FatalIOErrorInFunction(dict)
                << "Entry '" << e.keyword() << "' is no dictionary: a force is"
                << " name { type gravity; ... }" << exit(FatalIOError);
        }
        forces_.append(volumeForce::New(e.dict()));
    }
}


void Foam::fsbi::volumeForces::update()
{
    onCells_.setSize(mesh_.nCells());
    onCells_ = Zero;
    vector pressureGradient(Zero);
    const scalar time = mesh_.time().value();
    for (const volumeForce& force : forces_)
    {
        force.add(mesh_.cellCentres(), time, onCells_);
        pressureGradient += force.pressureGradient(time);
    }
    onCells_ *= mesh_.cellVolumes();
    setOnFaces(pressureGradient);
}


void Foam::fsbi::volumeForces::setOnFaces(const vector& pressureGradient)
{
    onFaces_.clear();
    if (pressureGradient == vector::zero)
    {
        return;
    }
    onFaces_ = vectorField(mesh_.nFaces() - mesh_.nInternalFaces(), Zero);
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        if (pp.coupled() || !returnReduce(pp.size(), sumOp<label>()))
        {
            continue;
        }
        const pointField x(pp.faceCentres());
        const point middle(gAverage(x));
        const label start = pp.start() - mesh_.nInternalFaces();
        forAll(x, i)
        {
            onFaces_[start + i] =
                -(pressureGradient & (x[i] - middle))*pp.faceAreas()[i];
        }
    }
}


bool Foam::fsbi::volumeForces::buoyant() const
{
    for (const volumeForce& force : forces_)
    {
        if (force.buoyant())
        {
            return true;
        }
    }
    return false;
}


void Foam::fsbi::volumeForces::addResidual(const scalar*, scalar* r) const
{
    forAll(onCells_, i)
    {
        r[4*i] -= onCells_[i].x();
        r[4*i + 1] -= onCells_[i].y();
        r[4*i + 2] -= onCells_[i].z();
    }
}


void Foam::fsbi::volumeForces::addTraction
(
    const stokesOperator& viscous, vectorField& traction
) const
{
    forAll(onFaces_, i)
    {
        if (viscous.velocityGiven()[i])
        {
            traction[i] += onFaces_[i];
        }
    }
}
