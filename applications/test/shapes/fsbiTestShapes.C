/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Application
    fsbiTestShapes

Description
    Checks of the body shapes: volume, area and inertia against exact values,
    closed and well-shaped triangles, the leukocyte map and its inverse, and the
    refusal of surfaces that are no bodies.

\*---------------------------------------------------------------------------*/

#include "checks.H"
#include "bodyShape.H"
#include "smoothShape.H"
#include "leukocyteMap.H"
#include "IStringStream.H"
#include "cpuTime.H"
#include "mathematicalConstants.H"
#include "quaternion.H"
#include "triSurface.H"
#include "OSspecific.H"

using namespace Foam;
using namespace Foam::fsbi;
using constant::mathematical::pi;

static bodySurface shape(const std::string& entries, const scalar size = 0)
{
    const dictionary dict{IStringStream(entries)()};
    return bodyShape::New(dict)->triangulate(size);
}


// Smallest angle of any triangle, degrees
static scalar minAngle(const bodySurface& s)
{
    scalar smallest = 180;
    for (const triFace& t : s.triangles())
    {
        for (label i = 0; i < 3; ++i)
        {
            const point& p = s.points()[t[i]];
            const vector a(s.points()[t[(i + 1) % 3]] - p);
            const vector b(s.points()[t[(i + 2) % 3]] - p);
            smallest = min
            (
                smallest, Foam::acos((a & b)/(mag(a)*mag(b)))*180/pi
            );
        }
    }
    return smallest;
}


static label euler(const bodySurface& s)
{
    return s.points().size() - s.triangles().size()/2;
}


static void checkSurface
(
    checks& c, const word& name, const bodySurface& s, const scalar size,
    const scalar angle
)
{
    s.check(name);
    c.check(name + " is closed, oriented and free of crossings", true);
    c.check
    (
        name + " is topologically a sphere", euler(s) == 2,
        Foam::name(euler(s))
    );
    c.checkClose(name + " has the wanted edges", s.meanEdge(), size, 0.15);
    c.checkBelow(name + ": smallest angle", angle - minAngle(s), 0);
    Info<< "    " << s.triangles().size() << " triangles, mean edge "
        << s.meanEdge() << ", smallest angle " << minAngle(s) << endl;
}


static void checkSphere(checks& c)
{
    const bodySurface s(shape("type sphere; radius 2;", 0.3));
    checkSurface(c, "sphere", s, 0.3, 40);
    c.checkClose("sphere: volume", s.volume(), 4*pi/3*8, 1e-12);
    c.checkClose("sphere: area", s.area(), 16*pi, 0.01);
    const symmTensor I(s.inertia());
    c.checkClose("sphere: inertia", I.xx(), 0.4*s.volume()*4, 0.01);
    c.checkBelow("sphere: centroid", mag(s.centroid()), 1e-12);
    c.checkBelow
    (
        "sphere: isotropic", mag(dev(I))/mag(I), 1e-10
    );
    const bodySurface fine(shape("type sphere; radius 2;", 0.06));
    c.checkClose("fine sphere: area", fine.area(), 16*pi, 5e-4);
    c.checkClose("sphere: inside", s.winding(point(0.3, 0.2, 1.5)), 1, 1e-10);
    c.checkClose("sphere: outside", s.winding(point(0.3, 0.2, 2.5)), 0, 1e-10);

    // rotated and moved: the same body
    const quaternion q(vector(1, 2, 3)/Foam::sqrt(14.0), 0.7);
    const bodySurface moved(s.transformed(q.R(), point(100, -50, 20)));
    c.checkClose("moved: volume", moved.volume(), s.volume(), 1e-10);
    c.checkClose("moved: inertia", tr(moved.inertia()), tr(I), 1e-8);
}


static void checkBox(checks& c)
{
    // exactly integrable: a box of 1 x 2 x 3
    pointField p({{0,0,0},{1,0,0},{1,2,0},{0,2,0},{0,0,3},{1,0,3},{1,2,3},{0,2,3}});
    const label f[12][3] =
    {
        {0,2,1},{0,3,2},{4,5,6},{4,6,7},{0,1,5},{0,5,4},
        {1,2,6},{1,6,5},{2,3,7},{2,7,6},{3,0,4},{3,4,7}
    };
    List<triFace> t(12);
    forAll(t, i)
    {
        t[i] = triFace(f[i][0], f[i][2], f[i][1]);    // inward on purpose
    }
    const bodySurface box(p, t);
    box.check("box");
    c.checkClose("box: turned outward, volume", box.volume(), 6, 1e-12);
    c.checkClose("box: area", box.area(), 22, 1e-12);
    c.checkClose("box: Ixx", box.inertia().xx(), 6*(4.0 + 9)/12, 1e-12);
    c.checkClose("box: Iyy", box.inertia().yy(), 6*(1.0 + 9)/12, 1e-12);
    c.checkBelow("box: Ixy", mag(box.inertia().xy()), 1e-12);

    List<triFace> open(t);
    open.setSize(11);
    c.checkFatal
    (
        "an open surface is refused",
        [&]{ bodySurface(p, open).check("holey"); }, "holey"
    );
    List<triFace> twisted(t);
    Swap(twisted[3][0], twisted[3][1]);
    c.checkFatal
    (
        "inconsistent orientation is refused",
        [&]{ bodySurface(p, twisted).check("moebius"); }, "oriented oppositely"
    );
    pointField crossing(p);
    crossing[6] = point(-1, 0.5, 1);
    c.checkFatal
    (
        "a self-intersecting surface is refused",
        [&]{ bodySurface(crossing, t).check("crossed"); }, "intersects itself"
    );
}


//- Distance from five turns around a cylinder of radius 1, rise 2 a turn
static scalar fromWinding(const point& p)
{
    const label n = 20000;
    const auto at = [&](const scalar i)
    {
        const scalar s = 10*pi*i/n;
        return point(Foam::cos(s), Foam::sin(s), s/pi - 5);
    };
    scalar nearest = GREAT;
    for (label i = 0; i < n; ++i)
    {
        const point a(at(i));
        const vector e(at(i + 1) - a);
        const scalar along = min(max(((p - a) & e)/magSqr(e), 0), 1);
        nearest = min(nearest, magSqr(p - a - along*e));
    }
    return Foam::sqrt(nearest);
}


static void checkOthers(checks& c)
{
    const bodySurface e(shape("type ellipsoid; semiAxes (1.8 0.75 0.75);", 0.15));
    checkSurface(c, "ellipsoid", e, 0.15, 30);
    c.checkClose
    (
        "ellipsoid: volume", e.volume(), 4*pi/3*1.8*0.75*0.75, 1e-12
    );
    c.checkClose
    (
        "ellipsoid: inertia", e.inertia().yy(),
        e.volume()/5*(sqr(1.8) + sqr(0.75)), 0.01
    );

    const bodySurface k(shape("type capsule; radius 0.5; length 2;", 0.1));
    checkSurface(c, "capsule", k, 0.1, 25);
    c.checkClose("capsule: area", k.area(), 2*pi*0.5*2 + pi, 0.01);

    const bodySurface l(shape("type leukocyte; radius 4;", 0.6));
    checkSurface(c, "leukocyte", l, 0.6, 25);

    // Evans & Fung 1972: 94 um^3 and 135 um^2, 0.81 um thick in the middle
    const bodySurface r(shape("type redBloodCell; diameter 7.82;", 0.4));
    checkSurface(c, "red blood cell", r, 0.4, 25);
    c.checkClose("red blood cell: volume", r.volume(), 94, 0.01);
    c.checkClose("red blood cell: area", r.area(), 135, 0.01);
    scalar middle = GREAT;
    for (const point& p : r.points())
    {
        middle = min(middle, mag(p.z()) + (Foam::hypot(p.x(), p.y()) > 1));
    }
    // bound: the scale to the volume, h^2/(6 R) over its height
    c.checkClose("red blood cell: half the middle", middle, 0.405, 0.02);

    const bodySurface h
    (
        shape
        (
            "type helix; radius 1; pitch 2; filamentRadius 0.1; turns 5;", 0.06
        )
    );
    checkSurface(c, "helix", h, 0.06, 25);
    const scalar arc = 5*Foam::sqrt(sqr(2*pi) + 4);
    c.checkClose
    (
        "helix: volume", h.volume(), pi*0.01*(arc + 0.4/3), 1e-6
    );
    c.checkClose("helix: area", h.area(), 2*pi*0.1*(arc + 0.2), 0.03);
    c.checkClose
    (
        "helix: height", h.bounds().span().z(), 10, 0.03
    );
    // bound: points lie 4 % of the radius outside; normals of facets that are off
    // by 0.1 leave a hundredth of it
    const bodySurface described(h.described());
    scalar worst = 0;
    for (const point& p : described.points())
    {
        worst = max(worst, mag(fromWinding(p) - 0.1)/0.1);
    }
    c.checkBelow("helix: radius at the points described", worst, 4e-4);
    const bodySurface left
    (
        shape
        (
            "type helix; radius 1; pitch 2; filamentRadius 0.1; turns 5;"
            "handedness left;", 0.06
        )
    );
    left.check("left helix");
    c.checkClose("left helix: volume", left.volume(), h.volume(), 1e-6);
}


static void checkMap(checks& c)
{
    const leukocyteMap map(4, 1, 0.1, 0.4);
    scalar worst = 0, slope = 0;
    const bodySurface sphere(smoothShape::geodesicSphere(12));
    for (const point& p : sphere.points())
    {
        worst = max(worst, mag(map.toSphere(map.fromSphere(4*p)) - 4*p));
        const tensor g(map.gradient(4*p));
        for (direction d = 0; d < 3; ++d)
        {
            vector step(Zero);
            step[d] = 1e-5;
            if (mag(p.y()) > 1e-4)
            {
                slope = max
                (
                    slope,
                    mag
                    (
                        (map.fromSphere(4*p + step)
                       - map.fromSphere(4*p - step))/2e-5
                      - (g & (step/1e-5))
                    )
                );
            }
        }
    }
    c.checkBelow("leukocyte map: round trip", worst, 1e-10);
    c.checkBelow("leukocyte map: gradient", slope, 1e-8);
}


static void checkFile(checks& c)
{
    const bodySurface s(shape("type sphere; radius 2;", 0.4));
    List<labelledTri> t(s.triangles().size());
    forAll(t, i)
    {
        const triFace& f = s.triangles()[i];
        t[i] = labelledTri(f[0], f[1], f[2], 0);
    }
    for (const word ext : {"stl", "obj"})
    {
        const fileName file
        (
            "/tmp/fsbiTestShapes." + Foam::name(pid()) + "." + ext
        );
        triSurface(t, s.points()).write(file);
        const bodySurface read
        (
            shape("type surfaceFile; scale 0.5; file \"" + file + "\";")
        );
        rm(file);
        read.check(ext);
        c.checkClose(ext + ": volume", read.volume(), s.volume()/8, 1e-4);
        c.check(ext + ": points merged", read.points().size() == s.points().size());
    }
}


static void checkErrors(checks& c)
{
    c.checkFatal
    (
        "an unknown shape is refused", []{ shape("type cube; radius 1;"); },
        "ellipsoid"
    );
    c.checkFatal
    (
        "an unknown keyword is refused",
        []{ shape("type sphere; radius 1; radios 2;"); }, "radios"
    );
    c.checkFatal
    (
        "a negative radius is refused", []{ shape("type sphere; radius -1;"); },
        "radius"
    );
    c.checkFatal
    (
        "too coarse a size is refused",
        []{ shape("type sphere; radius 1;", 1.2); }, "100"
    );
    c.checkFatal
    (
        "a leukocyte that folds is refused",
        []{ shape("type leukocyte; radius 1; By 1.2;"); }, "folds"
    );
    c.checkFatal
    (
        "a missing file is refused",
        []{ shape("type surfaceFile; file \"/nowhere.stl\";"); }, "nowhere"
    );
}


static void checkSpeed(checks& c)
{
    const bodySurface s(shape("type sphere; radius 1;", 0.036));
    cpuTime time;
    s.check("fine");
    Info<< "    " << s.triangles().size() << " triangles checked in "
        << time.elapsedCpuTime() << " s" << endl;
    c.checkBelow
    (
        "crossings of 20 000 triangles, seconds", time.elapsedCpuTime(), 1
    );
}


int main()
{
    checks c;
    checkBox(c);
    checkSphere(c);
    checkOthers(c);
    checkMap(c);
    checkFile(c);
    checkErrors(c);
    checkSpeed(c);
    return c.finish();
}
