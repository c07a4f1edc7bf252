/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Application
    fsbiTestGradients

Description
    Gradients at cells of known flows by all schemes of the Stokes operator, on
    hexahedra, hexahedra with moved vertices and tetrahedra: through vertices,
    and the source's for comparison. Checks what theory says of them.

Usage
    fsbiTestGradients [-table file.csv]
    \table
        -table | write the errors of ever finer meshes instead of the checks
    \endtable

\*---------------------------------------------------------------------------*/

#include "checks.H"
#include "appliedOperator.H"
#include "testMeshes.H"
#include "argList.H"
#include "OFstream.H"

using namespace Foam;
using namespace Foam::fsbi;

typedef std::function<vector(const point&)> flow;

static const wordList kinds({"hexahedra", "perturbed", "tetrahedra"});

static const flow linearFlow = [](const point& x)
{
    return x & tensor(0.3, 0.7, -0.4, 1.1, -0.8, 0.2, -0.6, 0.9, 0.5);
};

static const flow quadraticFlow = [](const point& x)
{
    return vector
    (
        x.y()*x.z() - sqr(x.y()), x.x()*x.z() + sqr(x.x()), x.x()*x.y()
    );
};

//- Past a sphere of radius 1 about the origin, outside the box
static const flow StokesFlow = [](const point& x)
{
    const vector U(1, 0.3, -0.5);
    const scalar r = mag(x), along = U & x;
    return
        U - 0.75*(U/r + x*along/pow3(r)) - 0.25*(U/pow3(r) - 3*x*along/pow5(r));
};


static tensor gradient(const flow& u, const point& x)
{
    const scalar step = 1e-4;
    tensor g(Zero);
    for (direction i = 0; i < 3; ++i)
    {
        vector e(Zero);
        e[i] = step;
        const vector d((u(x + e) - u(x - e))/(2*step));
        for (direction j = 0; j < 3; ++j)
        {
            g[3*i + j] = d[j];
        }
    }
    return g;
}


//- Root mean square over the gradient's own
static scalar wrongness
(
    const fvMesh& mesh, const flow& u, const stokesOperator::gradientScheme s
)
{
    stokesOperator::schemes schemes;
    schemes.gradients = s;
    appliedOperator a(mesh, 1, wordList(), schemes);
    exactFlow exact;
    exact.u = u;
    exact.gradU = [&](const point& x) { return gradient(u, x); };
    exact.p = [](const point&) { return 0; };
    a.apply(exact);
    const tensorField found(a.stokes.velocityGradients());
    scalar wrong = 0, size = 0;
    forAll(found, i)
    {
        const tensor g(a.cellMean<tensor>(exact.gradU, i));
        wrong += mesh.cellVolumes()[i]*magSqr(found[i] - g);
        size += mesh.cellVolumes()[i]*magSqr(g);
    }
    return Foam::sqrt(wrong/size);
}


static void check(checks& c, const testMeshes& meshes)
{
    typedef stokesOperator::gradientScheme scheme;
    for (const word& kind : kinds)
    {
        autoPtr<fvMesh> mesh(meshes.mesh(kind, 6));
        autoPtr<fvMesh> fine(meshes.mesh(kind, 12));
        const auto fall = [&](const flow& u, const scheme s)
        {
            return wrongness(mesh(), u, s)/wrongness(fine(), u, s);
        };
        for (const scheme s : {scheme::vertex, scheme::leastSquares})
        {
            const word name(kind + ", " + stokesOperator::gradientSchemes[s]);
            c.checkBelow
            (
                name + ": exact for a linear flow",
                wrongness(mesh(), linearFlow, s), 1e-8
            );
            c.check
            (
                name + ": first order at least", fall(StokesFlow, s) > 1.8,
                Foam::name(fall(StokesFlow, s))
            );
        }
        const word name(kind + ", Gauss");
        const scalar linear = wrongness(mesh(), linearFlow, scheme::Gauss);
        if (kind == "hexahedra")
        {
            c.checkBelow(name + ": exact for a linear flow", linear, 1e-8);
        }
        else
        {
            c.check
            (
                name + ": wrong for a linear flow, and stays so",
                linear > 0.01 && fall(linearFlow, scheme::Gauss) < 1.3,
                Foam::name(linear) + ", falls by "
              + Foam::name(fall(linearFlow, scheme::Gauss))
            );
        }
    }
}


static void writeTable(const testMeshes& meshes, const fileName& path)
{
    OFstream table(path);
    table << "cells,h,flow,gradients,error" << nl;
    for (const word& kind : kinds)
    {
        for (const label n : {5, 10, 20})
        {
            autoPtr<fvMesh> mesh(meshes.mesh(kind, n));
            const scalar h = Foam::cbrt(gAverage(mesh->cellVolumes()));
            for (const word& scheme : stokesOperator::gradientSchemes.names())
            {
                const auto row = [&](const word& name, const flow& u)
                {
                    table
                        << kind << ',' << h << ',' << name << ','
                        << scheme << ','
                        << wrongness
                           (
                               mesh(), u, stokesOperator::gradientSchemes[scheme]
                           )
                        << nl;
                };
                row("linear", linearFlow);
                row("quadratic", quadraticFlow);
                row("Stokes", StokesFlow);
            }
        }
    }
}


int main(int argc, char *argv[])
{
    argList::noBanner();
    argList::noParallel();
    argList::addOption("table", "file", "write errors of ever finer meshes");
    argList args(argc, argv, false, false, true);
    const testMeshes meshes(boundBox(point(1, 1, 1), point(3, 3, 3)));
    if (args.found("table"))
    {
        writeTable(meshes, args["table"]);
        return 0;
    }
    checks c;
    check(c, meshes);
    return c.finish();
}
