/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Application
    fsbiTestRepulsion

Description
    Checks of the repulsion between spheres and beside walls, plane, round and
    hollow, there of contact, too: total forces against integrals over true
    spheres, on finer and finer triangles; balance; derivatives; what is told of
    walls.

\*---------------------------------------------------------------------------*/

#include "checks.H"
#include "twoSpheres.H"
#include "mathematicalConstants.H"

using namespace Foam;
using namespace Foam::fsbi;
using constant::mathematical::pi;

static const scalar b = 2e-3, range = 0.4, minimumGap = 0.05;
static const scalar gap = 0.15;         // of the spheres in all checks

static const std::string entries = "range 0.4; minimumGap 0.05; ";
static const std::string pressure = entries + "strength 2e-3; ";
static const std::string pointForce = pressure + "form pointForce; ";
static const std::string spheresOnly = "between ((lower upper)); ";
static const std::string wallOnly = "between ((lower floor)); ";


static scalar law(const scalar d)
{
    return d < range ? b*(1/pow3(d) - 1/pow3(range)) : 0;
}


//- Force on the sphere of radius R by its own zones, opposite one of radius Q
//  at a distance D of centres, along the line of centres
static scalar onZones(const scalar R, const scalar Q, const scalar D)
{
    const label n = 200000;
    scalar sum = 0;
    for (label i = 0; i < n; ++i)
    {
        const scalar angle = 0.5*pi*(i + 0.5)/n;
        const scalar along = D - R*Foam::cos(angle);
        const scalar distance = Foam::hypot(along, R*Foam::sin(angle));
        sum +=
            law(distance - Q - minimumGap)*along/distance
           *2*pi*sqr(R)*Foam::sin(angle)*0.5*pi/n;
    }
    return sum;
}


//- Half on the zones of each
static scalar exactForce()
{
    const scalar R = twoSpheres::lower, Q = twoSpheres::upper;
    return 0.5*(onZones(R, Q, R + gap + Q) + onZones(Q, R, R + gap + Q));
}


//- For spheres nearly touching
static scalar Derjaguin()
{
    const scalar R =
        1/(1/twoSpheres::lower + 1/twoSpheres::upper), d = gap - minimumGap;
    return
        2*pi*R*b
       *((1/sqr(d) - 1/sqr(range))/2 - (range - d)/pow3(range));
}


static void checkMeshes(checks& c)
{
    const scalar exact = exactForce();
    scalarField onMesh, point, order(2);
    for (const scalar size : {0.16, 0.08, 0.04})
    {
        const twoSpheres scene(size, gap);
        onMesh.append(scene.force(pressure + spheresOnly));
        point.append(scene.force(pointForce + spheresOnly));
        Info<< "    edges of " << size << ": pressure " << onMesh.last()
            << ", point forces " << point.last() << " (true spheres, pressure "
            << exact << ", Derjaguin " << Derjaguin() << ')' << endl;
    }
    c.checkBelow
    (
        "pressure: the integral over the true spheres",
        mag(onMesh[2]/exact - 1), 0.01
    );
    c.check
    (
        "pressure: second order in the edge",
        mag(onMesh[2] - exact) < mag(onMesh[0] - exact)/12
    );
    // Derjaguin's first term left out is of the part gap/R
    c.checkBelow
    (
        "pressure: Derjaguin's integral", mag(onMesh[2]/Derjaguin() - 1),
        gap/(2.0/3)
    );
    c.checkClose
    (
        "point forces: fourfold as edges are halved", point[2]/point[1], 4, 0.05
    );
    // the area of an equilateral triangle makes one of the other
    const scalar area = Foam::sqrt(3.0)/4*sqr(0.04);
    c.checkClose
    (
        "point forces: those of the pressure over the triangles' area",
        area*point[2], exact, 0.05
    );
}


//- On triangles as wide as the range: the largest error, relative, with the upper
//  sphere in several directions from the lower one
static scalar worst(twoSpheres& scene)
{
    const point centre(scene.sphere(0).centre);
    const point above(scene.sphere(1).centre);
    scalar error = 0;
    for (label i = 0; i < 8; ++i)
    {
        const scalar z = 0.125 + 0.25*(i % 4), angle = 2.4*i;
        const scalar r = Foam::sqrt(1 - sqr(z));
        const vector way(r*Foam::cos(angle), r*Foam::sin(angle), z);
        scene.sphere(1).centre = centre + mag(above - centre)*way;
        const loads::onBodies sum
        (
            scene.acting(scene.make(pressure + spheresOnly)()).forces()
        );
        const vector force(linear(sum.whole[0]));
        error = max(error, mag(force/exactForce() + way));
    }
    scene.sphere(1).centre = above;
    return error;
}


static void checkDescribed(checks& c)
{
    const scalar size = 0.4;
    twoSpheres scene(size, gap);
    const scalar byTriangles = worst(scene);
    scene.sphere(0).isSphere = scene.sphere(1).isSphere = true;
    const scalar error = worst(scene);
    Info<< "    described spheres, edges of " << size << ": off by " << error
        << ", their triangles by " << byTriangles << endl;

    // bound: the nearest point is taken above that of the triangles, whose normals
    // are off by size/sqrt(3) R at corners, so it is off by gap times that and the
    // distance by its square over 2 R; the law falls by 3/(gap - minimumGap). Parts
    // are fine enough for 2 %
    const scalar R = twoSpheres::lower;
    const scalar distance = sqr(gap*size/R)/(6*R);
    c.checkBelow
    (
        "described spheres: the integral over them", error,
        3/(gap - minimumGap)*distance + 0.02
    );
    c.check
    (
        "described spheres: their triangles are farther off", byTriangles > 2*error
    );
    // parts have edges of 0.22, so a middle within 0.13 of the gap, which is 0.013
    // wider there
    const auto accepted = [&](const scalar minimumGap)
    {
        return scene.make
        (
            "range 0.4; strength 0; minimumGap " + std::to_string(minimumGap)
          + "; " + spheresOnly
        );
    };
    c.check("described spheres: less than the gap is accepted", bool(accepted(0.95*gap)));
    c.checkFatal
    (
        "described spheres: more than the gap is refused",
        [&]{ accepted(1.1*gap); }, "less than minimumGap"
    );
}


static void checkBalance(checks& c)
{
    for (const std::string& form : {pressure, pointForce})
    {
        twoSpheres scene(0.16, gap);
        scene.sphere(1).isSphere = true;
        const loads l(scene.acting(scene.make(form + spheresOnly)()));
        vector force(Zero), torque(Zero);
        scalar size = 0;
        for (const loads::spring& s : l.springs())
        {
            size += mag(s.force);
        }
        const loads::onBodies sum(l.forces());
        for (label i = 0; i < 2; ++i)
        {
            const point centre(scene.sphere(i).centre);
            force += linear(sum.whole[i]);
            torque += angular(sum.whole[i]) + (centre ^ linear(sum.whole[i]));
        }
        const std::string name = form == pressure ? "pressure" : "point forces";
        c.check(name + ": there are forces", size > 0);
        c.checkBelow(name + ": action is reaction", mag(force)/size, 1e-13);
        c.checkBelow(name + ": no torque on both", mag(torque)/size, 1e-11);
    }
}


//- The force beside a wall and its change with the height
static void checkDerivative
(
    checks& c, const std::string& name, const std::string& form,
    const scalar above
)
{
    twoSpheres scene(0.16, 9, 1);
    const autoPtr<repulsion> r(scene.make(form + wallOnly));
    const auto at = [&](const scalar height)
    {
        scene.sphere(0).centre = point(0, 0, twoSpheres::lower + height);
        return scene.acting(r());
    };
    const scalar step = 1e-6;
    const scalar change =
        at(above + step).forces().whole[0][2]
      - at(above - step).forces().whole[0][2];
    const loads l(at(above));
    loads::ofBodies u(l.atRest());
    u.whole[0][2] = 2*step;
    c.check(name + ": pushes away", l.forces().whole[0][2] > 0);
    c.checkClose(name, change, l.changes(u).whole[0][2], 1e-4);
}


//- The upper sphere periods away, and its image in the mesh so many from it
static void checkImages(checks& c)
{
    const vector period(3, -2, 30);
    const auto forces = [&](const label travelled, const label image)
    {
        const twoSpheres plain(0.16, gap);
        twoSpheres there(0.16, gap, 9, {period, -period});
        there.sphere(1).centre += travelled*period;
        there.sphere(1).setImage(image*period);
        const loads::onBodies with
        (
            there.acting(there.make(pressure + spheresOnly)()).forces()
        );
        const loads::onBodies without
        (
            plain.acting(plain.make(pressure + spheresOnly)()).forces()
        );
        scalar difference = 0;
        for (label body = 0; body < 2; ++body)
        {
            for (label k = 0; k < 6; ++k)
            {
                difference = max
                (
                    difference,
                    mag(with.whole[body][k] - without.whole[body][k])
                );
            }
        }
        return difference/mag(without.whole[0][2]);
    };
    // bound: round-off of coordinates of 100 over a distance of 0.1
    c.checkBelow("an image repels as the body", forces(-1, 0), 1e-10);
    c.checkBelow("a body that has gone far, by its image", forces(4, -4), 1e-10);

    // equal spheres in a row, each between two others
    twoSpheres row
    (
        0.08, 9, 9,
        {vector(2*twoSpheres::lower + gap, 0, 0),
        vector(-2*twoSpheres::lower - gap, 0, 0)}
    );
    row.sphere(1).setPresent(false);
    scalar gross = 0;
    const loads l(row.acting(row.make(pressure)()));
    for (const loads::spring& s : l.springs())
    {
        gross += mag(s.force.x());
    }
    const scalar net = mag(linear(l.forces().whole[0]));
    const scalar exact =
        onZones(twoSpheres::lower, twoSpheres::lower, 2*twoSpheres::lower + gap);
    c.checkClose("images of the body itself", gross, exact, 0.02);
    c.checkBelow("images of the body itself: no force", net/gross, 1e-12);
}


//- Force on the lower sphere beside a round wall, along z, by a law of distance
static scalar besideRound(const scalar above, const scalar radius, scalar (*of)(scalar))
{
    const scalar R = twoSpheres::lower;
    const label n = 4000, m = 200;
    scalar sum = 0;
    for (label i = 0; i < n*m; ++i)
    {
        const scalar theta = 0.5*pi*(i/m + 0.5)/n, phi = 2*pi*(i % m)/m;
        const scalar y = R*Foam::sin(theta)*Foam::cos(phi);
        const scalar z = radius + above + R*(1 - Foam::cos(theta));
        const scalar r = Foam::hypot(y, z);
        const scalar distance = radius > 0 ? r - radius : -radius - r;
        sum += of(distance)*mag(z)/r*sqr(R)*Foam::sin(theta);
    }
    return sum*0.5*pi/n*2*pi/m;
}


static scalar repelling(const scalar distance)
{
    return law(distance - minimumGap);
}


//- Of contact with gap = range = 0.1, and a pressure of 1
static scalar pressing(const scalar distance)
{
    const scalar s = distance/0.1 - 1;
    return s < 1 ? 0.2*(1 - 3/sqr(s) + 2/pow3(s)) : 0;
}


//- A post or a tube, by facets that become finer with the sphere's triangles
static void checkRound(checks& c, const std::string& name, const scalar radius)
{
    const scalar above = 0.15;
    const scalar exact = besideRound(above, radius, repelling);
    const scalar flat = besideRound(above, 1e6, repelling);
    const scalar exactContact = besideRound(above, radius, pressing);
    scalar off = GREAT;
    for (const scalar size : {0.16, 0.08, 0.04})
    {
        const twoSpheres scene(size, 9, above, {}, twoSpheres::round(radius, size));
        const scalar force =
            scene.acting(scene.make(pressure)()).forces().whole[0][2];
        const scalar contact = scene.touching("gap 0.1; pressure 1;").z();
        Info<< "    " << name.c_str() << ", edges of " << size << ": repulsion "
            << force << ", contact " << contact << " (exact " << exact << ", "
            << exactContact << "; a plane " << flat << ')' << endl;
        // bound: triangles of the sphere and the wall leave sagittas of size^2/8 of
        // their curvatures, of a law that falls by 3/(above - minimumGap) a length
        const scalar sagitta =
            sqr(size)/8*(1/twoSpheres::lower + 1/mag(radius));
        const std::string of = ", edges of " + std::to_string(size).substr(0, 4);
        off = mag(force/exact - 1);
        c.checkBelow
        (
            name + of + ": repulsion, the integral over the true sphere", off,
            3/(above - minimumGap)*sagitta
        );
        // bound: the barrier falls by 3/s + 3/(1 - s) a range, 12 at s = 0.5, and is
        // integrated in parts of 0.15 of its zone
        c.checkBelow
        (
            name + of + ": contact, the integral over the true sphere",
            mag(contact/exactContact - 1), 12/0.1*sagitta + sqr(0.15)
        );
    }
    c.check(name + ": not as a plane", mag(flat/exact - 1) > 10*off);
}


//- A plate at z = 0 that ends at x = 0, and the sphere beyond its end, below it
static void checkBorder(checks& c)
{
    domainWall plate{"plate", Zero, Zero, Zero};
    plate.facets = std::make_shared<const wallFacets>
    (
        bodySurface::open
        (
            pointField(List<point>{{-4, -4, 0}, {0, -4, 0}, {0, 4, 0}, {-4, 4, 0}}),
            {triFace(0, 1, 2), triFace(0, 2, 3)}
        )
    );
    twoSpheres scene(0.16, 9, 9, {}, plate);
    const auto force = [&](const point& centre)
    {
        scene.sphere(0).centre = centre;
        return linear(scene.acting(scene.make(pressure)()).forces().whole[0]);
    };
    const vector beyond(force({1.2, 0, -0.3}));
    c.check
    (
        "nothing is behind a wall that is beyond its border",
        beyond.x() > 0 && beyond.z() < 0
    );
    c.checkFatal
    (
        "a sphere behind a wall that is not plane is told",
        [&]{ force({-2, 0, -1.5}); }, "less than minimumGap"
    );
}


static void checkWalls(checks& c)
{
    const twoSpheres scene(0.16, gap);
    const auto told = [&](const std::string& between)
    {
        return scene.make(pressure + between)->unrepelled();
    };
    c.check
    (
        "a patch that is no wall is told",
        told("").size() == 1 && told("")[0].name == "end"
    );
    c.check
    (
        "a wall that no pair names is told",
        told(spheresOnly).size() == 2
     && told(spheresOnly)[1].name == "floor"
    );
    c.checkFatal
    (
        "a pair with a patch that is no wall says why",
        [&]{ scene.make(pressure + "between ((lower end));"); },
        "a patch, but its traction is given"
    );
    c.checkFatal
    (
        "an unknown form is refused",
        [&]{ scene.make(pressure + "form force;"); }, "pointForce"
    );
}


int main()
{
    checks c;
    checkMeshes(c);
    checkDescribed(c);
    checkBalance(c);
    checkDerivative(c, "pressure: derivative", pressure, 0.2);
    checkDerivative(c, "point forces: derivative", pointForce, 0.2);
    checkDerivative(c, "beyond the minimum gap: derivative", pressure, 0.03);
    checkImages(c);
    checkRound(c, "a post", 1.5);
    checkRound(c, "a tube", -3);
    checkBorder(c);
    checkWalls(c);
    return c.finish();
}
