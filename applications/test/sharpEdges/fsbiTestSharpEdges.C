/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Application
    fsbiTestSharpEdges

Description
    Checks of what the operator of fourth order does at edges of a body: the
    solutions beside a wedge, straight and bent, against finite differences,
    quadrature beside an edge, a cube in flows that are known. Run on several
    processors (mpirun -np 3 fsbiTestSharpEdges -parallel) it compares with one.

\*---------------------------------------------------------------------------*/

#include "checks.H"
#include "cubicFlow.H"
#include "meshDistribution.H"
#include "simplexRules.H"
#include "testMeshes.H"
#include "wedge.H"
#include "argList.H"

using namespace Foam;
using namespace Foam::fsbi;

static const scalar mu = 1.7;

//- Half of the cube
static const scalar half = 0.8;

//- A point beside an edge along z, at theta from the bisector
static point beside(const scalar r, const scalar theta, const scalar z)
{
    return point(r*Foam::cos(theta), r*Foam::sin(theta), z);
}


//- Second order differences of the flows of modes
struct differences
{
    //- Of the gradients; of the divergence; of the forces
    scalar gradient = 0, divergence = 0, force = 0;

    template<class Flows>
    differences(const Flows& flows, const point& x)
    {
        static const scalar step = 1e-4;
        const auto here(flows(x));
        forAll(here, k)
        {
            tensor grad(Zero);
            vector lapU(Zero), gradP(Zero);
            for (direction d = 0; d < 3; ++d)
            {
                vector e(Zero);
                e[d] = step;
                const auto a(flows(point(x - e))[k]);
                const auto b(flows(point(x + e))[k]);
                const vector slope((b.u - a.u)/(2*step));
                for (direction j = 0; j < 3; ++j)
                {
                    grad(d, j) = slope[j];
                    lapU[j] +=
                        (b.gradient(d, j) - a.gradient(d, j))/(2*step);
                }
                gradP[d] = (b.p - a.p)/(2*step);
            }
            gradient = max(gradient, mag(grad - here[k].gradient));
            divergence = max(divergence, mag(tr(here[k].gradient)));
            force = max(force, mag(lapU - gradP));
        }
    }
};


static void checkModes(checks& c)
{
    // bound: the exponents as printed by Moffatt (1964) and Dean & Montagnon
    // (1949), four digits
    const wedgeModes right(1.5*constant::mathematical::pi);
    c.checkClose("270 degrees: first exponent", right.exponents()[0], 0.5445, 1e-4);
    c.checkClose("270 degrees: second exponent", right.exponents()[1], 0.9085, 1e-4);
    for (const scalar degrees : {190.0, 225.0, 257.0, 270.0, 300.0, 350.0})
    {
        const scalar angle = degrees*constant::mathematical::pi/180;
        const wedgeModes modes(angle);
        const auto flows = [&](const point& x) { return modes.at(x); };
        const std::string name = Foam::name(degrees) + " degrees: ";
        differences worst(flows, beside(0.7, 0.3*angle, 0.2));
        const differences other(flows, beside(1.2, -0.45*angle, 0.2));
        scalar atWall = 0;
        for (const label side : {-1, 1})
        {
            for (const auto& flow : modes.at(beside(0.6, side*angle/2, 0)))
            {
                atWall = max(atWall, mag(flow.u));
            }
        }
        // bound: truncation of differences 1e-8 times third derivatives of some
        // tens
        c.checkBelow(name + "gradients", max(worst.gradient, other.gradient), 1e-6);
        c.checkBelow(name + "forces", max(worst.force, other.force), 1e-6);
        // bound: round-off
        c.checkBelow(name + "divergence", max(worst.divergence, other.divergence), 1e-12);
        c.checkBelow(name + "at rest on both sides", atWall, 1e-12);
    }
}


//- An edge that is an arc, with chords as long as a fifth of its radius
static void checkArc(checks& c)
{
    sharpVertex s;
    s.normals[0] = vector(0, 0, -1);
    s.normals[1] = vector(-1, 0, 0);
    s.tangent = vector(0, 1, 0);
    s.curvature = vector(-1, 0, 0);
    s.lengths[0] = s.lengths[1] = 0.2;
    s.angle = 1.5*constant::mathematical::pi;
    const wedge edge(point(1, 0, 0), s, point(1, 0, 0));
    const wedgeModes modes(1e-6*edge.angle());
    const auto flows = [&](const point& x)
    {
        return edge.flowsAt(x, modes, 5.0);
    };
    const differences d(flows, point(1.1, 0.13, 0.07));
    // bound: of a truncation 1e-8 times third derivatives of some thousands; a
    // fifth of the radius times singular gradients of order ten is what would be
    // left out
    c.checkBelow("bent edge: gradients", d.gradient, 1e-3);
    // bound: the flow along the edge is shifted to the chord with a slope of at most
    // 0.1, and has gradients of 4
    c.checkBelow("bent edge: divergence", d.divergence, 0.4);
    scalar atRim = 0;
    for (const label i : {0, 1, 2})
    {
        // on the chord and below it
        const scalar t = 0.5*i;
        const point end(Foam::cos(0.2), Foam::sin(0.2), 0);
        const point onChord((1 - t)*point(1, 0, 0) + t*end);
        for (const auto& flow : flows(onChord - vector(0, 0, 0.1)))
        {
            atRim = max(atRim, mag(flow.u));
        }
    }
    // bound: arc for parabola, h^3/8 of the radius, over a depth of a half
    c.checkBelow("bent edge: at rest on the facets", atRim, 0.01);
}


//- Mean over a tetrahedron by halving it again and again
static scalar fineMean
(
    const std::function<scalar(const point&)>& f,
    const FixedList<point, 4>& x,
    const label depth
)
{
    if (depth == 0)
    {
        const weightedPoints rule(tetrahedronRule(x, FixedList<bool, 4>(false)));
        scalar sum = 0;
        forAll(rule.x, q)
        {
            sum += rule.weights[q]*f(rule.x[q]);
        }
        return sum;
    }
    label a = 0, b = 1;
    for (label i = 0; i < 4; ++i)
    {
        for (label j = i + 1; j < 4; ++j)
        {
            if (mag(x[i] - x[j]) > mag(x[a] - x[b]) + SMALL)
            {
                a = i;
                b = j;
            }
        }
    }
    FixedList<point, 4> first(x), second(x);
    first[a] = second[b] = 0.5*(x[a] + x[b]);
    return 0.5*(fineMean(f, first, depth - 1) + fineMean(f, second, depth - 1));
}


static void checkRules(checks& c)
{
    const FixedList<point, 4> x
    ({
        point(0, 0, 0), point(0, 0, 1), point(1, 0.2, 0.3), point(0.1, 0.9, 0.6)
    });
    const auto root = [](const point& p)
    {
        return Foam::pow(sqr(p.x()) + sqr(p.y()), 0.5*0.5445);
    };
    const FixedList<bool, 4> onEdge({true, true, false, false});
    const weightedPoints rule(tetrahedronRule(x, onEdge));
    scalar sum = 0;
    forAll(rule.x, q)
    {
        sum += rule.weights[q]*root(rule.x[q]);
    }
    // bound: what the header says
    c.checkClose("mean beside an edge", sum, fineMean(root, x, 15), 0.005);
}


//- Of a cube, with n edges on each of its own
static bodySurface cube(const label n)
{
    DynamicList<point> points;
    DynamicList<triFace> triangles;
    const auto number = [&](const point& p)
    {
        forAll(points, i)
        {
            if (mag(points[i] - p) < 1e-9)
            {
                return i;
            }
        }
        points.append(p);
        return points.size() - 1;
    };
    for (direction d = 0; d < 3; ++d)
    {
        for (const label side : {-1, 1})
        {
            const auto at = [&](const label i, const label j)
            {
                point p;
                p[d] = side*half;
                p[(d + 1) % 3] = half*(2.0*i/n - 1);
                p[(d + 2) % 3] = half*(2.0*j/n - 1);
                return number(p);
            };
            for (label i = 0; i < n; ++i)
            {
                for (label j = 0; j < n; ++j)
                {
                    const label a = at(i, j), b = at(i + 1, j);
                    const label e = at(i + 1, j + 1), f = at(i, j + 1);
                    triangles.append(side > 0 ? triFace(a, b, e) : triFace(a, e, b));
                    triangles.append(side > 0 ? triFace(a, e, f) : triFace(a, f, e));
                }
            }
        }
    }
    return bodySurface(pointField(points), List<triFace>(triangles));
}


static meshLists aroundCube(const testMeshes& room)
{
    const boundBox box(point(-3, -3, -3), point(3, 3, 3));
    autoPtr<polyMesh> domain
    (
        boxMesh(room.clock(), box, Vector<label>(4, 4, 4))
    );
    dictionary controls;
    controls.set("growth", 0.4);
    return conformalMesher(domain(), controls).generate
    (
        {"cube"}, List<bodySurface>(1, cube(5)), Zero
    );
}


//- u quadratic, p linear
static exactFlow quadraticFlow()
{
    exactFlow flow;
    flow.u = [](const point& x)
    {
        return vector(sqr(x.y()) + 0.3*x.z(), 1 - x.x(), x.x()*x.y());
    };
    flow.gradU = [](const point& x)
    {
        return tensor(0, -1, x.y(), 2*x.y(), 0, x.x(), 0.3, 0, 0);
    };
    flow.p = [](const point& x) { return mu*(2*x.x() - 0.5); };
    return flow;
}


//- Means over the cells, with points crowding at the cube's edges
static void setMeans
(
    appliedOperator& a,
    const std::function<vector(const point&)>& u,
    const std::function<scalar(const point&)>& p
)
{
    const auto atEdge = [](const point& x)
    {
        label n = 0;
        for (direction d = 0; d < 3; ++d)
        {
            n += mag(mag(x[d]) - half) < 1e-6;
        }
        return n > 1 && cmptMax(cmptMag(x)) < half + 1e-6;
    };
    for (label i = 0; i < a.mesh.nCells(); ++i)
    {
        FixedList<point, 4> corners;
        FixedList<bool, 4> onEdge;
        forAll(corners, k)
        {
            corners[k] = a.mesh.points()[a.mesh.cellPoints()[i][k]];
            onEdge[k] = atEdge(corners[k]);
        }
        const weightedPoints rule(tetrahedronRule(corners, onEdge));
        vector mean(Zero);
        a.x[4*i + 3] = 0;
        forAll(rule.x, q)
        {
            mean += rule.weights[q]*u(rule.x[q]);
            a.x[4*i + 3] += rule.weights[q]*p(rule.x[q]);
        }
        std::copy_n(mean.cdata(), 3, &a.x[4*i]);
    }
    forAll(a.b.faces, i)
    {
        a.b.faces[i] = u(a.mesh.faceCentres()[a.mesh.nInternalFaces() + i]);
    }
    forAll(a.b.vertices, i)
    {
        a.b.vertices[i] = u(a.stokes.wallPoints()[i]);
    }
    a.apply();
}


//- Largest momentum row of cells within some length of a point
static scalar rowsNear(const appliedOperator& a, const point& x, const scalar length)
{
    scalar worst = 0;
    forAll(a.mesh.cellCentres(), i)
    {
        if (mag(a.mesh.cellCentres()[i] - x) < length)
        {
            worst = max(worst, mag(vector(a.r[4*i], a.r[4*i + 1], a.r[4*i + 2])));
        }
    }
    return worst;
}


static void checkQuadratic(checks& c, appliedOperator& a)
{
    const exactFlow flow(quadraticFlow());
    setFlow(a, flow, mu);
    // bound: round-off; the degree at edges is lower, but not below this flow's
    c.checkBelow
    (
        "cube: quadratic flow: momentum rows", rowsNear(a, Zero, 3), 1e-10
    );
}


//- The singular flow of one edge of the cube, near its middle
static void checkSingular(checks& c, appliedOperator& a)
{
    const point middle(half, half, 0);
    const tensor axes
    (
        normalised(vector(1, 1, 0)), normalised(vector(-1, 1, 0)), vector(0, 0, 1)
    );
    const wedgeModes modes(1.5*constant::mathematical::pi);
    scalar rows[2], gradients = 0;
    for (const label k : {0, 2})
    {
        const auto u = [&](const point& x)
        {
            return axes.T() & modes.at(axes & (x - middle))[k].u;
        };
        const auto p = [&](const point& x)
        {
            return mu*modes.at(axes & (x - middle))[k].p;
        };
        setMeans(a, u, p);
        rows[k/2] = rowsNear(a, middle, 0.3);
        const tensorField found(a.stokes.velocityGradients());
        forAll(found, i)
        {
            const vector d(axes & (a.mesh.cellCentres()[i] - middle));
            if (mag(d) < 0.2)
            {
                const tensor exact(axes.T() & modes.at(d)[k].gradient & axes);
                gradients = max(gradients, mag(found[i] - exact)/mag(exact));
            }
        }
    }
    Info<< "    largest momentum rows of singular flows at the edge " << rows[0]
        << ", " << rows[1] << endl;
    // bound: forces on the faces of a cell, mu h times gradients of order one,
    // are 0.5; rules beside an edge are good to a hundredth of that, polynomials
    // miss a third
    c.checkBelow("cube: singular flow in the plane: momentum rows", rows[0], 0.02);
    c.checkBelow("cube: singular flow along the edge: momentum rows", rows[1], 0.02);
    c.checkBelow("cube: singular flows: gradients at cells", gradients, 0.02);
}


//- The same on one processor and on all, edges of the cube cut as well
static void checkParallel(checks& c)
{
    const testMeshes room(boundBox(point(-3, -3, -3), point(3, 3, 3)));
    meshLists whole;
    labelList ranks;
    scalarList r;
    if (Pstream::master())
    {
        Pstream::parRun() = false;
        whole = aroundCube(room);
        ranks = meshDistribution::bisect(whole, Pstream::nProcs());
        autoPtr<fvMesh> mesh(room.scaled(whole, 1));
        appliedOperator a(mesh(), mu, wordList(), {4});
        disturb(a, identity(mesh->nCells()));
        r = a.r;
        Pstream::parRun() = true;
    }
    Pstream::scatter(r);
    const meshDistribution part(whole, ranks);
    autoPtr<fvMesh> mesh(room.scaled(part.mesh, 1));
    appliedOperator a(mesh(), mu, wordList(), {4});
    disturb(a, part.cells);
    scalar rows = 0;
    forAll(a.r, i)
    {
        rows = max(rows, mag(a.r[i] - r[4*part.cells[i/4] + i % 4]));
    }
    // bound: sums in another order, of numbers up to ten
    c.checkBelow("in parallel: residual", returnReduce(rows, maxOp<scalar>()), 1e-10);
}


int main(int argc, char *argv[])
{
    argList::noBanner();
    argList::noCheckProcessorDirectories();
    argList args(argc, argv, false, false, true);
    checks c;
    if (Pstream::parRun())
    {
        checkParallel(c);
        return c.finish();
    }
    checkModes(c);
    checkArc(c);
    checkRules(c);

    const testMeshes room(boundBox(point(-3, -3, -3), point(3, 3, 3)));
    autoPtr<fvMesh> mesh(room.scaled(aroundCube(room), 1));
    appliedOperator a(mesh(), mu, wordList(), {4});
    checkQuadratic(c, a);
    checkSingular(c, a);
    return c.finish();
}
