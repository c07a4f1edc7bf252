/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "momentumChecks.H"

using namespace Foam;
using namespace Foam::fsbi;

//- Steps that long are steady
static const scalar forever = 1e9;

static const std::string blood
(
    "type Carreau; viscosityAtRest 16; viscosityAtHighRates 1; time 3;"
    " exponent 0.36;"
);


static autoPtr<viscosityLaw> lawOf(const std::string& entries)
{
    IStringStream is(entries);
    const dictionary dict(is);
    const checkedDictionary checked(dict);
    autoPtr<viscosityLaw> law(viscosityLaw::New(checked));
    checked.finish();
    return law;
}


static std::string ofPower(const scalar exponent, const scalar smallestRate)
{
    return
        "type powerLaw; consistency 2; exponent " + name(exponent)
      + "; smallestRate " + name(smallestRate) + ";";
}


static void checkLaws(checks& c)
{
    const autoPtr<viscosityLaw> Carreau(lawOf(blood));
    c.checkClose("Carreau: at rest", Carreau->viscosity(0), 16, 1e-14);
    // bound: (time rate)^(exponent - 1) of what is between the plateaus, and as
    // much again
    c.checkClose
    (
        "Carreau: at high rates", Carreau->viscosity(1e12), 1,
        30*Foam::pow(3e6, -0.64)
    );
    c.checkClose
    (
        "power law", lawOf(ofPower(0.5, 1e-9))->viscosity(16), 1, 1e-14
    );
    for (const std::string& entries : {blood, ofPower(0.4, 0.1), ofPower(1.6, 1)})
    {
        const autoPtr<viscosityLaw> law(lawOf(entries));
        scalar worst = 0;
        for (const scalar s : {0.01, 0.3, 20.0, 5e4})
        {
            const scalar h = 1e-5*s;
            const scalar difference =
                (law->viscosity(s + h) - law->viscosity(s - h))/(2*h);
            worst = max(worst, mag(law->slope(s)/difference - 1));
        }
        // bound: the square of the step and round-off over it
        c.checkBelow(law->type() + ": slope", worst, 1e-8);
    }
    c.checkFatal
    (
        "an unknown fluid", []{ lawOf("type water;"); }, "Carreau"
    );
    c.checkFatal
    (
        "a power law without its smallest rate",
        []{ lawOf("type powerLaw; consistency 1; exponent 0.5;"); },
        "smallestRate"
    );
    c.checkFatal
    (
        "a negative plateau",
        []{ lawOf(blood + "viscosityAtHighRates -1;"); }, "negative"
    );
}


//- A fluid in the cube whose side x = 1 is pulled at, and all else moved as in a
//  shear flow; or, with turn, in one that is not linear
struct pulledCube
{
    momentumEquation momentum;
    boundaryValues given;
    scalarList x;
    vectorField traction;

    static tensor shear()
    {
        return tensor(0.4, 1.1, -0.3, 0.2, -0.7, 0.5, 0.1, -0.2, 0.3);
    }

    static vector flow(const point& p, const scalar turn)
    {
        return (shear() & p) + turn*vector(sqr(p.y()), p.x()*p.z(), sqr(p.x()));
    }

    pulledCube
    (
        const fvMesh& mesh, const std::string& law, const scalar turn = 0
    )
    :
        momentum(mesh, lawOf(law), PtrList<momentumTerm>()),
        x(4*mesh.nCells())
    {
        const label inner = mesh.nInternalFaces();
        boolList velocityGiven(mesh.nFaces() - inner, true);
        forAll(velocityGiven, i)
        {
            velocityGiven[i] = mesh.faceCentres()[inner + i].x() < 1 - 1e-6;
        }
        momentum.set(velocityGiven, stokesOperator::schemes());
        const symmTensor D(symm(shear()));
        const scalar eta = lawOf(law)->viscosity(2*magSqr(D));
        given.faces.setSize(velocityGiven.size());
        forAll(given.faces, i)
        {
            const point& p = mesh.faceCentres()[inner + i];
            const vector n(1, 0, 0);
            given.faces[i] =
                velocityGiven[i]
              ? flow(p, turn) : vector((2*eta*D & n) - pressure(p)*n);
        }
        given.vertices.setSize(momentum.viscous().wallPoints().size());
        forAll(given.vertices, i)
        {
            given.vertices[i] = flow(momentum.viscous().wallPoints()[i], turn);
        }
        forAll(mesh.cellCentres(), i)
        {
            const point& p = mesh.cellCentres()[i];
            const vector u(flow(p, turn));
            x[4*i] = u.x();
            x[4*i + 1] = u.y();
            x[4*i + 2] = u.z();
            x[4*i + 3] = pressure(p);
        }
        traction.setSize(given.faces.size());
    }

    static scalar pressure(const point& p) { return 0.3*p.x() - 2*p.z(); }

    //- Rows where all is changed by so much of what noise gives
    scalarField rows(const scalar part)
    {
        scalarList at(x), r(x.size());
        boundaryValues changed(given);
        forAll(at, i)
        {
            at[i] += part*noise(i);
        }
        forAll(changed.faces, i)
        {
            changed.faces[i] +=
                part*vector(noise(i), noise(i + 1), noise(i + 2));
        }
        momentum.residual(at.cdata(), changed, r.begin(), traction);
        return scalarField(r);
    }

    scalarField derivative()
    {
        rows(0);
        scalarList dx(x.size()), dr(x.size());
        forAll(dx, i)
        {
            dx[i] = noise(i);
        }
        boundaryValues changes(given);
        changes.vertices = Zero;
        forAll(changes.faces, i)
        {
            changes.faces[i] = vector(noise(i), noise(i + 1), noise(i + 2));
        }
        momentum.applyJacobian(dx.cdata(), changes, dr.begin(), traction);
        return scalarField(dr);
    }
};


//- In a linear flow, in which what the derivative leaves out vanishes: the
//  stabilisation acts on nothing, and the mean viscosity's transposed part on
//  closed cells
static void checkDerivative(checks& c, const word& kind)
{
    const testMeshes meshes(cube);
    autoPtr<fvMesh> mesh(meshes.mesh(kind, 4));
    pulledCube flow(mesh(), blood);
    const scalar step = 1e-7;
    const scalarField plus(flow.rows(step));
    const vectorField pulls(flow.traction);
    const scalarField differences((plus - flow.rows(-step))/(2*step));
    const vectorField ofTraction((pulls - flow.traction)/(2*step));
    const scalarField derivative(flow.derivative());
    // bound: round-off over the step, and the step by which the smallest viscosity
    // changes in either direction
    c.checkBelow
    (
        kind + ": derivative in a Carreau fluid",
        max(mag(derivative - differences))/max(mag(differences)), 1e-6
    );
    c.checkBelow
    (
        kind + ": derivative of tractions",
        max(mag(flow.traction - ofTraction))/max(mag(ofTraction)), 1e-6
    );
}


//- A law of one viscosity is that of a Newtonian fluid
static void checkConstant(checks& c, const word& kind)
{
    const testMeshes meshes(cube);
    autoPtr<fvMesh> mesh(meshes.mesh(kind, 4));
    pulledCube one(mesh(), ofPower(1, 1), 0.7);
    pulledCube other(mesh(), "type Newtonian; viscosity 2;", 0.7);
    const scalarField difference(one.rows(0.1) - other.rows(0.1));
    // bound: round-off of some tens of terms
    c.checkBelow
    (
        kind + ": a power law of exponent 1",
        max(mag(difference))/max(mag(other.rows(0.1))), 1e-13
    );
}


//- Flow along x between the planes y = -1 and 1, driven by a fall of pressure
class channel
{
    //- Velocities at equal distances from the middle to the wall
    scalarList u_;

    const autoPtr<viscosityLaw> law_;
    const scalar fall_;

    //- Of which eta(g^2) g is the stress
    scalar rate(const scalar stress) const
    {
        scalar low = 0, high = 1;
        while (high*law_->viscosity(sqr(high)) < stress)
        {
            high *= 2;
        }
        for (label k = 0; k < 60; ++k)
        {
            const scalar middle = 0.5*(low + high);
            const bool below = middle*law_->viscosity(sqr(middle)) < stress;
            (below ? low : high) = middle;
        }
        return 0.5*(low + high);
    }

public:

    channel(const std::string& law, const scalar fall)
    :
        u_(2001, Zero),
        law_(lawOf(law)),
        fall_(fall)
    {
        const label n = u_.size() - 1;
        for (label k = n; k > 0; --k)
        {
            const scalar a = (k - 1.0)/n, b = scalar(k)/n;
            u_[k - 1] =
                u_[k]
              + (b - a)/6
               *(
                    rate(fall_*a) + 4*rate(fall_*(a + b)/2) + rate(fall_*b)
                );
        }
    }

    vector operator()(const point& x, const scalar) const
    {
        const scalar s = min(mag(x.y()), scalar(1))*(u_.size() - 1);
        const label k = min(label(s), u_.size() - 2);
        // the slope is known, and with it a cubic between the points
        const scalar h = 1.0/(u_.size() - 1), t = s - k;
        const scalar a = -h*rate(fall_*k*h), b = -h*rate(fall_*(k + 1)*h);
        const scalar d = u_[k + 1] - u_[k];
        return vector
        (
            u_[k] + t*(a + t*(3*d - 2*a - b + t*(a + b - 2*d))), 0, 0
        );
    }
};


//- Error of the velocity in a channel
static scalar channelError
(
    const word& kind,
    const label n,
    const std::string& law,
    const scalar fall,
    label& corrections
)
{
    const channel exact(law, fall);
    const testMeshes meshes(cube);
    autoPtr<fvMesh> mesh(meshes.mesh(kind, n));
    unsteadyFlow flow(mesh(), lawOf(law), "", exact);
    flow.x = 0;
    flow.step(forever);
    Info<< "    channel of " << mesh->nCells() << ' ' << kind.c_str() << ": "
        << flow.report.corrections << " corrections, "
        << flow.report.iterations << " iterations, error " << flow.error()
        << endl;
    corrections = flow.report.corrections;
    return flow.report.converged ? flow.error() : GREAT;
}


static void checkOrder(checks& c)
{
    for (const word kind : {"hexahedra", "tetrahedra"})
    {
        const label n = kind == "hexahedra" ? 12 : 8;
        for (const std::string& law : {blood, ofPower(0.6, 0.01)})
        {
            // of rates to some units
            label corrections;
            const scalar coarse = channelError(kind, n, law, 4, corrections);
            const scalar fine = channelError(kind, 2*n, law, 4, corrections);
            const scalar order = Foam::log(coarse/fine)/Foam::log(2.0);
            const word type(lawOf(law)->type());
            // limit: 1.54 and 1.70 of a Carreau fluid, 1.50 and 1.61 of a power law
            // were measured on tetrahedra and hexahedra; 1.7 had been expected. On
            // coarser tetrahedra a Newtonian flow shows 1.63. In the middle of a
            // channel a power law's viscosity has a pole, of which the fourth
            // derivative of u, y^(1/n - 3), leaves h^(1/n) in a sum from h on: 1.67
            c.check(kind + ", " + type + ": order", order > 1.48, name(order));
        }
    }
}


//- From rest, in fluids from thin to thick
static void checkCorrections(checks& c)
{
    label most = 0;
    bool converged = true;
    for (const scalar exponent : {0.3, 0.5, 0.8, 1.5})
    {
        label corrections;
        converged =
            channelError
            (
                "tetrahedra", 6, ofPower(exponent, 0.1), 4, corrections
            ) < 1
         && converged;
        most = max(most, corrections);
    }
    c.check("power laws of all exponents converge", converged);
    // limit: 13 were measured, from rest with an exponent of 0.3 (16 on finer
    // meshes with 0.6); five to where convergence is quadratic and four from
    // there had been expected
    c.check("corrections", most <= 20, name(most));
}


static void checkRefused(checks& c)
{
    const testMeshes meshes(cube);
    autoPtr<fvMesh> mesh(meshes.mesh("tetrahedra", 2));
    const channel exact(blood, 1);
    unsteadyFlow flow(mesh(), lawOf(blood), "", exact);
    c.checkFatal
    (
        "a Carreau fluid by SIMPLEC",
        [&]() { flow.step(forever, "method SIMPLEC;"); }, "coupled"
    );
    stokesOperator::schemes s;
    s.order = 4;
    c.checkFatal
    (
        "a Carreau fluid by order 4",
        [&]()
        {
            flow.momentum.set(flow.momentum.viscous().velocityGiven(), s);
        },
        "Newtonian"
    );
}


void checkViscosity(checks& c)
{
    checkLaws(c);
    for (const word& kind : testMeshes::kinds())
    {
        checkDerivative(c, kind);
        checkConstant(c, kind);
    }
    checkOrder(c);
    checkCorrections(c);
    checkRefused(c);
}
