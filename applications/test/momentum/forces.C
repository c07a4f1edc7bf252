/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "momentumChecks.H"
#include "volumeForce.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{

//- As a user's library would have it: the gradient of (s.x)^2
class outsideForce
:
    public volumeForce
{
    vector slope_;

public:

    TypeName("outside");

    explicit outsideForce(const checkedDictionary& entries)
    :
        slope_(entries.get<vector>("slope"))
    {}

    void add(const pointField& x, const scalar, vectorField& b) const override
    {
        forAll(x, i)
        {
            b[i] += 2*(slope_ & x[i])*slope_;
        }
    }
};

defineTypeNameAndDebug(outsideForce, 0);
addToRunTimeSelectionTable(volumeForce, outsideForce, entries);

} // End namespace fsbi
} // End namespace Foam

using namespace Foam;
using namespace Foam::fsbi;


//- A fluid that accelerates as a whole, and one at rest that is heavy
void checkPressure(checks& c)
{
    const testMeshes room(wide);
    autoPtr<fvMesh> mesh(room.mesh("tetrahedra", 6, 0.4));
    const auto linear = [&](const unsteadyFlow& flow, const vector& slope)
    {
        return
            flow.pressureError([&](const point& x) { return slope & x; })
           /(mag(slope)*6);
    };
    const vector A(0.3, -0.2, 0.5);
    unsteadyFlow flow
    (
        mesh(), mu, heavy,
        [&](const point&, const scalar t) { return sqr(t)*A; }
    );
    for (const scalar dt : {0.1, 0.07, 0.2})
    {
        flow.step(dt, "tolerance 1e-10;");
    }
    c.checkBelow("the velocity is uniform", flow.error(), 1e-8);
    // bound: BDF2 is exact for what is quadratic in time, after a first step
    // whose error, of a field that is uniform, dies out by half a step
    c.checkBelow
    (
        "pressure of a fluid that accelerates",
        linear(flow, -rho*2*flow.time()*A), 1e-7
    );

    const vector g(0.1, -9, 3);
    unsteadyFlow rest
    (
        mesh(), mu,
        "forces { weight { type gravity; density 1.3; acceleration"
        " (0.1 -9 3); } }",
        [](const point&, scalar) { return vector::zero; }
    );
    rest.step(1, "tolerance 1e-10;");
    c.checkBelow("pressure of a heavy fluid", linear(rest, rho*g), 1e-7);
    scalar body = 0;
    const polyPatch& pp = mesh->boundaryMesh()["sphere"];
    forAll(pp, k)
    {
        body -= pp.faceCentres()[k] & pp.faceAreas()[k]/3;
    }
    c.checkBelow
    (
        "Archimedes", mag(rest.force() + rho*body*g)/(rho*body*mag(g)), 1e-7
    );
}


//- p = (s.x)^2 holds it
void checkOutside(checks& c)
{
    const testMeshes meshes(cube);
    autoPtr<fvMesh> mesh(meshes.mesh("hexahedra", 8));
    unsteadyFlow rest
    (
        mesh(), mu, "forces { push { type outside; slope (1 0.5 -0.7); } }",
        [](const point&, scalar) { return vector::zero; }
    );
    rest.step(1);
    const vector s(1, 0.5, -0.7);
    const scalar worst =
        rest.pressureError([&](const point& x) { return sqr(s & x); });
    // bound: second order on cells of a quarter, of a pressure that changes by 5
    c.checkBelow("a force of another library", worst, sqr(0.25));
}
