/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "loadedBody.H"
#include "IStringStream.H"
#include "mathematicalConstants.H"
#include "untrapped.H"
#include "symmetryPolyPatch.H"
#include "symmetryPlanePolyPatch.H"

namespace Foam
{
namespace fsbi
{

//- Smallest part of the data that is added at once
static const scalar smallest = 0.02;

//- Springs that keep a compressed body from turning over, over the least ones
static const scalar safety = 2;

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::loadedBody::loadedBody
(
    const fvMesh& mesh,
    surfaceData& data,
    const bool deformed,
    const bool mixed
)
:
    mesh_(mesh),
    transfer_(mesh, data.x),
    mixed_(mixed),
    kinds_(mesh.nFaces() - mesh.nInternalFaces(), solidBoundary::traction)
{
    setKinds(data);
    if (!held_)
    {
        data.turnBack();
    }
    setLoads(data, deformed);
    const scalar pi = constant::mathematical::pi;
    radius_ = Foam::sqrt(0.25*sum(areas_)/pi);
    if (!held_)
    {
        setSteadying();
    }
}


void Foam::fsbi::loadedBody::setSteadying()
{
    // moment of the forces and of springs of unit stiffness, per small angle
    vectorField x
    (
        given_
      + SubField<vector>
        (
            mesh_.faceCentres(), kinds_.size(), mesh_.nInternalFaces()
        )
    );
    x -= sum(areas_*x)/sum(areas_);
    const symmTensor virial(symm(sum(force_*x)));
    const symmTensor moment(tr(virial)*symmTensor::I - virial);
    const symmTensor springs(sum(areas_*(magSqr(x)*symmTensor::I - sqr(x))));
    steadying_ =
        safety*max(0, -eigenValues(moment).x()/eigenValues(springs).x());
}


void Foam::fsbi::loadedBody::setKinds(const surfaceData& data)
{
    boolList symmetric(kinds_.size(), false);
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        if (isA<symmetryPolyPatch>(pp) || isA<symmetryPlanePolyPatch>(pp))
        {
            forAll(pp, i)
            {
                symmetric[pp.start() + i - mesh_.nInternalFaces()] = true;
            }
        }
    }
    held_ = false;
    forAll(kinds_, i)
    {
        const point& x = mesh_.faceCentres()[mesh_.nInternalFaces() + i];
        if (symmetric[i])
        {
            kinds_[i] = solidBoundary::symmetry;
        }
        else if (!data.loaded(surfaceTransfer::nearest(data.x, x, 1)[0]))
        {
            kinds_[i] = solidBoundary::displacement;
        }
        held_ = held_ || kinds_[i] != solidBoundary::traction;
    }
}


Foam::vectorField Foam::fsbi::loadedBody::deformedAreas
(
    const surfaceData& data
) const
{
    const pointField moved(transfer_.moved(data.u));
    vectorField result(kinds_.size());
    forAll(result, i)
    {
        result[i] =
            mesh_.faces()[mesh_.nInternalFaces() + i].areaNormal(moved);
    }
    return result;
}


void Foam::fsbi::loadedBody::setLoads
(
    const surfaceData& data, const bool deformed
)
{
    areas_ = mag
    (
        vectorField
        (
            SubField<vector>
            (
                mesh_.faceAreas(), kinds_.size(), mesh_.nInternalFaces()
            )
        )
    );
    given_ = transfer_.toFaces(data.u);
    vectorField known(data.t);
    forAll(known, i)
    {
        if (!data.loaded(i))
        {
            known[i] = Zero;    // next to held faces
        }
    }
    force_ =
        transfer_.toFaces(known)
       *(deformed ? scalarField(mag(deformedAreas(data))) : areas_);
    forAll(kinds_, i)
    {
        if (kinds_[i] != solidBoundary::traction)
        {
            force_[i] = Zero;
        }
    }
}


void Foam::fsbi::loadedBody::setSprings
(
    const scalar ratio, const scalar modulus
)
{
    stiffness_ = max(ratio*modulus/radius_, steadying_);
}


void Foam::fsbi::loadedBody::setLaw(const dictionary& law)
{
    law_ = law;
    solver_.clear();
    elastic_.clear();
    material_ = solidMaterial::New(law_);
    elastic_ = elasticOperator::New
    (
        2, mesh_, material_(), kinds_,
        constitutiveState::formulation::totalLagrangian, mixed_
    );
    dictionary controls;
    controls.set("tolerance", 1e-9);
    controls.set("maxIterations", 25);
    solver_ = solidSolver::New(mesh_, elastic_(), material_(), controls);
}


bool Foam::fsbi::loadedBody::solve(const scalar part, const vectorField& more)
{
    solidBoundary given;
    given.kinds = kinds_;
    given.faces = part*given_;
    given.follower.setSize(kinds_.size(), Zero);
    given.pressure.setSize(kinds_.size(), Zero);
    boundarySpring spring
    {
        (stiffness_*areas_)*tensor::I, vectorField(kinds_.size(), Zero)
    };
    forAll(kinds_, i)
    {
        if (kinds_[i] == solidBoundary::traction)
        {
            given.faces[i] = Zero;
        }
        else
        {
            spring.stiffness[i] = Zero;
        }
    }
    spring.load = part*(force_ + (spring.stiffness & given_)) + more;
    const vector sum(held_ ? vector(Zero) : Foam::sum(part*force_));
    const scalarField volumes(mesh_.cellVolumes());
    const vectorField volumeForce((-sum/Foam::sum(volumes))*volumes);
    const scalarField mass(mesh_.nCells(), Zero);

    const untrapped scope;
    const solverReport report
    (
        solver_->solve({given, volumeForce, mass, &spring}, x_)
    );
    ++solutions_;
    if (!report.converged || !std::isfinite(report.residual))
    {
        return false;
    }
    faces_ = elastic_->boundaryDisplacement();
    reaction_ = elastic_->boundaryForce();
    forAll(kinds_, i)
    {
        if (kinds_[i] != solidBoundary::displacement)
        {
            reaction_[i] = Zero;
        }
    }
    return true;
}


bool Foam::fsbi::loadedBody::approach()
{
    x_.setSize(elastic_->size());
    x_ = 0;
    scalar reached = 0, step = 1;
    while (reached < 1)
    {
        const scalarList before(x_);
        const scalar part = min(reached + step, scalar(1));
        if (solve(part, vectorField(kinds_.size(), Zero)))
        {
            reached = part;
            continue;
        }
        x_ = before;
        step /= 2;
        if (step < smallest)
        {
            return false;
        }
    }
    return true;
}


bool Foam::fsbi::loadedBody::solve(vectorField& u)
{
    const scalarList before(x_);
    const bool started = x_.size() == elastic_->size();
    if
    (
        !(started && solve(1, vectorField(kinds_.size(), Zero)))
     && !approach()
    )
    {
        x_ = before;
        return false;
    }
    u = transfer_.toPoints(faces_, elastic_->vertexDisplacement());
    return true;
}


bool Foam::fsbi::loadedBody::respond
(
    const vectorField& force, vectorField& du, vectorField& reaction
)
{
    const vectorField faces(faces_), reactions(reaction_);
    const scalarList x(x_);

    // small, but far above the solver's tolerance
    const scalar size = 1e-3*Foam::sqrt(sum(magSqr(force_))/sum(magSqr(force)));
    const bool solved = solve(1, size*force);
    du = (faces_ - faces)/size;
    reaction = (reaction_ - reactions)/size;
    x_ = x;
    faces_ = faces;
    reaction_ = reactions;
    return solved;
}


Foam::vectorField Foam::fsbi::loadedBody::springTraction() const
{
    vectorField result(stiffness_*(given_ - faces_));
    forAll(kinds_, i)
    {
        if (kinds_[i] != solidBoundary::traction)
        {
            result[i] = Zero;
        }
    }
    return result;
}


Foam::scalar Foam::fsbi::loadedBody::springShare() const
{
    return Foam::sqrt
    (
        sum(areas_*magSqr(springTraction()))
       /max(sum(areas_*magSqr(traction())), VSMALL)
    );
}
