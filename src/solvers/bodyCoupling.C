/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include <mpi.h>
#include "bodyCoupling.H"

void Foam::fsbi::setBodyVelocities
(
    const stokesOperator& stokes,
    const UList<bodyRows>& bodies,
    const UList<sixVector>& velocities,
    boundaryValues& values
)
{
    const fvMesh& mesh = stokes.stencil().mesh();
    forAll(bodies, b)
    {
        const bodyRows& body = bodies[b];
        const vector V(linear(velocities[b])), omega(angular(velocities[b]));
        for (const label i : body.faces)
        {
            const point& x = mesh.faceCentres()[mesh.nInternalFaces() + i];
            values.faces[i] = V + (omega ^ (x - body.centre));
        }
        for (const label i : body.vertices)
        {
            const point& x = stokes.wallPoints()[i];
            values.vertices[i] = V + (omega ^ (x - body.centre));
        }
    }
}


//- Of the tensor r t the vector r ^ t
static Foam::vector crossed(const Foam::tensor& rt)
{
    return Foam::vector
    (
        rt.yz() - rt.zy(), rt.zx() - rt.xz(), rt.xy() - rt.yx()
    );
}


Foam::List<Foam::fsbi::sixVector> Foam::fsbi::bodyLoads
(
    const stokesOperator& stokes,
    const UList<bodyRows>& bodies,
    const vectorField& traction
)
{
    const fvMesh& mesh = stokes.stencil().mesh();
    const tensorField& moments = stokes.tractionMoments();
    scalarField sums(6*bodies.size(), Zero);
    forAll(bodies, b)
    {
        vector force(Zero), torque(Zero);
        for (const label i : bodies[b].faces)
        {
            const point& x = mesh.faceCentres()[mesh.nInternalFaces() + i];
            force -= traction[i];
            torque -= (x - bodies[b].centre) ^ traction[i];
            if (moments.size())
            {
                torque -= crossed(moments[i]);
            }
        }
        const sixVector load(join(force, torque));
        std::copy_n(load.begin(), 6, sums.begin() + 6*b);
    }
    if (UPstream::parRun())
    {
        MPI_Allreduce
        (
            MPI_IN_PLACE, sums.data(), sums.size(), MPI_DOUBLE, MPI_SUM,
            MPI_COMM_WORLD
        );
    }
    List<sixVector> loads(bodies.size());
    forAll(loads, b)
    {
        std::copy_n(sums.begin() + 6*b, 6, loads[b].begin());
    }
    return loads;
}


Foam::List<Foam::fsbi::sixVector> Foam::fsbi::bodyDefectChanges
(
    const UList<bodyRows>& bodies,
    const UList<sixVector>& velocities,
    const UList<sixVector>& loads
)
{
    List<sixVector> changes(bodies.size());
    forAll(bodies, b)
    {
        const bodyRows& body = bodies[b];
        const sixVector& v = velocities[b];
        const sixVector inertia
        (
            join(body.massRate*linear(v), body.inertiaRate & angular(v))
        );
        forAll(v, k)
        {
            changes[b][k] = body.free[k] ? loads[b][k] - inertia[k] : -v[k];
        }
    }
    return changes;
}


Foam::List<Foam::fsbi::sixVector> Foam::fsbi::bodyDefects
(
    const UList<bodyRows>& bodies,
    const UList<sixVector>& velocities,
    const UList<sixVector>& loads
)
{
    List<sixVector> defects(bodyDefectChanges(bodies, velocities, loads));
    forAll(bodies, b)
    {
        forAll(defects[b], k)
        {
            defects[b][k] +=
                bodies[b].free[k] ? bodies[b].rhs[k] : bodies[b].velocity[k];
        }
    }
    return defects;
}
