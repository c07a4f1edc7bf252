/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Description
    Checks of what cells have besides an elastic inside: a cortex, and a liquid.

\*---------------------------------------------------------------------------*/

#include "skin.H"
#include "elasticCase.H"
#include "quaternion.H"
#include "mathematicalConstants.H"

#include <algorithm>

using namespace Foam;
using namespace Foam::fsbi;

static const std::string skins[] =
{
    "tension 0.7;",
    "type Skalak; shearModulus 2; areaModulus 5;",
    "type neoHookeanMembrane; shearModulus 2;",
    "type EvansSkalak; shearModulus 2; areaModulus 5; tension 0.3;",
    "tension 0.3; bendingModulus 0.02;",
    "type Skalak; shearModulus 2; areaModulus 5; bendingModulus 0.02;"
    " spontaneousCurvature 0.5;"
};

//- Of one that goes all round
static const std::string loadingFaces[] =
{
    "type Skalak; shearModulus 2; areaModulus 5; tension 0.3; loads faces;",
    "tension 0.3; bendingModulus 0.02; loads faces;"
};

static dictionary entries(const std::string& text)
{
    return dictionary(IStringStream(text)());
}


static solidBoundary::kind allFree(const point&)
{
    return solidBoundary::traction;
}


static vectorField shaken(const fvMesh& mesh, const scalar size)
{
    vectorField u(mesh.nPoints());
    forAll(u, v)
    {
        u[v] =
            size*vector(noise(3*v), noise(3*v + 1), noise(3*v + 2));
    }
    return u;
}


//- Forces are minus the derivative of the energy, and balance; the tangent is
//  theirs; they turn with the body
static void checkForces(checks& c, elasticCase& body, const std::string& text)
{
    const fvMesh& mesh = body.mesh;
    cortex skin(mesh, 0, body.given.kinds, entries(text));
    const vectorField u(shaken(mesh, 0.05));
    vectorField along(shaken(mesh, 1));
    std::reverse(along.begin(), along.end());

    const scalar h = 1e-5;
    // what faces have goes to their corners here, as if both moved together
    const auto whole = [&](const cortex::acting& f)
    {
        vectorField onCorners(f.vertices);
        forAll(f.faces, i)
        {
            for (const label v : mesh.faces()[mesh.nInternalFaces() + i])
            {
                onCorners[v] += f.faces[i]/3;
            }
        }
        return onCorners;
    };
    const auto at = [&](const vectorField& x){ return whole(skin.forces(x)); };
    const vectorField more(at(u + h*along));
    const scalar above = skin.measured().energy;
    const vectorField less(at(u - h*along));
    const scalar below = skin.measured().energy;
    const vectorField force(at(u));
    const vectorField change(whole(skin.tangent(along)));
    const scalar work = sum(force & along);
    // bound: central differences, h^2 of third derivatives of some hundred
    c.checkClose
    (
        text + " forces over the slope of the energy",
        -work/((above - below)/(2*h)), 1, 1e-7
    );
    c.checkBelow
    (
        text + " derivative of forces",
        max(mag(change - (more - less)/(2*h)))/max(mag(change)), 1e-7
    );
    // bound: round-off
    c.checkBelow(text + " sum of forces", mag(sum(force)), 1e-13);
    c.checkBelow
    (
        text + " sum of moments",
        mag(sum((mesh.points() + u) ^ force)), 1e-13
    );
    const quaternion q(normalised(vector(1, 2, 3)), 2);
    vectorField turned(mesh.points() + u);
    for (vector& x : turned)
    {
        x = q.transform(x);
    }
    vectorField there(at(turned - mesh.points()));
    forAll(there, v)
    {
        there[v] -= q.transform(force[v]);
    }
    c.checkBelow(text + " forces turned", max(mag(there)), 1e-13);
}


//- A side of a cube that is made a quadric, whose fits are exact. h: height
static void checkCurvature(checks& c, const fvMesh& mesh)
{
    const scalar modulus = 0.7, tension = 1e-3;
    const scalar hxx = 0.3, hxy = 0.2, hyy = -0.2;
    List<solidBoundary::kind> kinds
    (
        mesh.nFaces() - mesh.nInternalFaces(), solidBoundary::displacement
    );
    scalarField areas(mesh.nPoints(), Zero);
    forAll(kinds, i)
    {
        const label facei = mesh.nInternalFaces() + i;
        if (mesh.faceCentres()[facei].z() > 0.99)
        {
            kinds[i] = solidBoundary::traction;
            for (const label v : mesh.faces()[facei])
            {
                areas[v] += mag(mesh.faceAreas()[facei])/3;
            }
        }
    }
    vectorField u(mesh.nPoints(), Zero);
    scalar expected = 0;
    forAll(u, v)
    {
        const point& p = mesh.points()[v];
        const scalar x = p.x(), y = p.y();
        u[v].z() = 0.5*hxx*x*x + hxy*x*y + 0.5*hyy*y*y + 0.3*x;
        const scalar hx = hxx*x + hxy*y + 0.3, hy = hxy*x + hyy*y;
        const scalar W = Foam::sqrt(1 + hx*hx + hy*hy);
        const scalar K =
           -((1 + hy*hy)*hxx - 2*hx*hy*hxy + (1 + hx*hx)*hyy)/pow3(W);
        const bool inside = max(mag(x), mag(y)) < 0.99;
        expected += inside ? 0.5*modulus*K*K*W*areas[v] : 0;
    }
    cortex skin
    (
        mesh, 0, kinds, entries("tension 1e-3; bendingModulus 0.7;")
    );
    skin.forces(u);
    const cortex::measures m(skin.measured());
    // bound: round-off
    c.checkClose
    (
        "energy of bending of a quadric", m.energy - tension*m.area, expected,
        1e-11
    );
}


//- Of small strain: principal tensions (K - G)(a + b) + 2 G a
static void checkModuli(checks& c, const std::string& text, const scalar K)
{
    const scalar G = 2, a = 2e-4, b = -0.7e-4;
    const autoPtr<membraneLaw> law
    (
        membraneLaw::New(checkedDictionary(entries(text)))
    );
    const scalar A = sqr(1 + a), B = sqr(1 + b);
    const auto e = law->at(A + B, A*B);
    const scalar N = 2*(1 + a)/(1 + b)*(e.T + B*e.d);
    const scalar expected = (K - G)*(a + b) + 2*G*a;
    // bound: the next order is strain over strain, times some numbers of 1
    c.checkClose(text + " tension of small strain", N/expected, 1, 20*a);
}


static void checkDerivatives(checks& c, const fvMesh& mesh)
{
    for (const std::string& text : skins)
    {
        elasticCase body
        (
            mesh, "type neoHookean; E 1; nu 0.4;", elasticCase::heldAndLoaded
        );
        body.giveLoads();
        body.elastic->setCortex(entries(text));
        c.checkBelow
        (
            "derivative of a body with " + text,
            body.derivativeError(0.02, 1e-5), 1e-7
        );
    }
}


//- Volume within the surface as it is displaced, less the one before
static scalar growth(const elasticCase& body)
{
    const fvMesh& mesh = body.mesh;
    const pointField x(mesh.points() + body.elastic->vertexDisplacement());
    scalar volume = -sum(mesh.V().field());
    for (label i = mesh.nInternalFaces(); i < mesh.nFaces(); ++i)
    {
        const face& f = mesh.faces()[i];
        volume += (x[f[0]] & f.areaNormal(x))/3;
    }
    return volume;
}


static scalar pressureRows(const elasticCase& body, const scalarList& r)
{
    const label n = body.elastic->ownedVertices().size();
    return sum(SubList<scalar>(r, n, body.elastic->firstJointRow() - n));
}


//- In the second step after a strain of its own
static void checkLiquid(checks& c, const fvMesh& mesh)
{
    elasticCase body
    (
        mesh, "type liquid; viscosity 0.3;", allFree,
        constitutiveState::formulation::totalLagrangian, true
    );
    body.elastic->setCortex(entries(skins[0]));
    body.elastic->beginStep(0.2, 0, false);
    forAll(body.x, i)
    {
        body.x[i] = 0.02*noise(7*i + 1);
    }
    scalarList r(body.x.size());
    body.elastic->residual(body.x.cdata(), body.given, r.begin());
    // bound: round-off
    c.checkBelow
    (
        "rows of a liquid's pressures add up to what its surface has grown by",
        mag(pressureRows(body, r) - growth(body)), 1e-14
    );
    body.elastic->endStep();
    body.elastic->beginStep(0.1, 0.2, false);
    c.checkBelow
    (
        "derivative of a liquid with a tension",
        body.derivativeError(0.02, 1e-5), 1e-7
    );
}


//- Turned by any angle a step it has no stress; sheared, Newton's
static void checkFlow(checks& c, const fvMesh& mesh)
{
    const scalar eta = 0.3, dt = 1e-3;
    const auto material =
        solidMaterial::New(entries("type liquid; viscosity 0.3;"));
    constitutiveState state
    (
        "body", 1, material(), constitutiveState::formulation::totalLagrangian,
        true
    );
    const auto stressAt = [&](const tensor& F)
    {
        state.gradient()[0] = F - tensor::I;
        state.evaluate();
        return tensor(state.CauchyStress()()[0]);
    };
    const tensor prior(1.2, 0.3, 0, 0.1, 0.9, 0.2, 0, 0, 1/1.05);
    const tensor before(prior/Foam::cbrt(det(prior)));
    state.setStep(dt, 0);
    stressAt(before);
    state.endStep();
    const tensor R(quaternion(normalised(vector(1, 2, 3)), 1.5).R());
    state.setStep(dt, dt);
    state.olderF()[0] = before;
    c.checkBelow
    (
        "stress of a liquid turned by 1.5 rad in a step, over viscosity by step",
        mag(stressAt(R & before))*dt/eta, 1e-13
    );
    // from here on the velocity gradient L: F = exp(L t) before
    const tensor L(0.2, 1, 0, 0.3, -0.5, 0, 0.4, 0, 0.3);
    const auto at = [&](const scalar t)
    {
        const tensor X(t*L);
        return
            (tensor::I + X + 0.5*(X & X) + (X & X & X)/6) & before;
    };
    state.olderF()[0] = at(-2*dt);
    state.oldF()[0] = at(-dt);
    // bound: BDF2, a third of dt^2 times the third derivative of C, some ten
    c.checkBelow
    (
        "stress of a liquid with a velocity gradient",
        mag(stressAt(before) - 2*eta*symm(L))/(eta*mag(L)), 20*sqr(dt)
    );
}


void checkSkin(checks& c, const fvMesh& mesh)
{
    const auto checkFree = [&](const std::string& text)
    {
        elasticCase body(mesh, "type neoHookean; E 1; nu 0.4;", allFree);
        checkForces(c, body, text);
    };
    std::for_each(std::begin(skins), std::end(skins), checkFree);
    std::for_each
    (
        std::begin(loadingFaces), std::end(loadingFaces), checkFree
    );
    checkCurvature(c, mesh);
    checkModuli(c, skins[1], 5);
    checkModuli(c, skins[2], 6);
    checkModuli(c, "type EvansSkalak; shearModulus 2; areaModulus 5;", 5);
    checkDerivatives(c, mesh);
    checkLiquid(c, mesh);
    checkFlow(c, mesh);
}
