/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "refining.H"
#include "gapRefinement.H"
#include "redGreen.H"
#include "surfaceDistance.H"
#include "unitConversion.H"

namespace Foam
{
namespace fsbi
{

static const scalar gapSag = 0.05;

//- Smallest angle of a triangulation, degrees
static scalar smallestAngle(const bodySurface& s)
{
    scalar cosine = 0;
    for (const triFace& t : s.triangles())
    {
        for (label i = 0; i < 3; ++i)
        {
            const point& x = s.points()[t[i]];
            const vector a(normalised(s.points()[t[(i + 1) % 3]] - x));
            const vector b(normalised(s.points()[t[(i + 2) % 3]] - x));
            cosine = max(cosine, a & b);
        }
    }
    return radToDeg(Foam::acos(cosine));
}


static void checkRedGreen(checks& c)
{
    const bodySurface coarse(shape("type sphere; radius 1;", 0.4));
    const auto project = [](const point& p) { return p/mag(p); };
    pointField points(coarse.points());
    for (point& p : points)
    {
        p = project(p);
    }
    redGreen fine(points, coarse.triangles(), project);
    label before = 0;
    for (label cuts = 0; cuts < 5; ++cuts)
    {
        // around a pole, ever narrower
        before = fine.triangles().size();
        boolList marked(before, false);
        forAll(marked, i)
        {
            const point centre(fine.triangles()[i].centre(fine.points()));
            marked[i] = mag(centre - vector(0, 0, 1)) < Foam::pow(0.5, cuts);
        }
        fine.split(marked);
    }
    const bodySurface surface(pointField(fine.points()), fine.conforming());
    const outcome solid(surface.solid("refined"));
    c.check("refined locally: encloses a solid", solid.ok, solid.reason);
    scalar off = 0;
    for (const point& p : surface.points())
    {
        off = max(off, mag(mag(p) - 1));
    }
    c.checkBelow("refined locally: points are on the shape", off, 1e-14);
    // bound: reds are similar to the first triangles, 47 degrees and more, but
    // for the shape's curvature; a green halves one angle
    c.check
    (
        "refined locally: no thin triangles", smallestAngle(surface) > 20,
        Foam::name(smallestAngle(surface))
    );
    // bound: a hundredth of what five cuts of all of them would give
    c.check
    (
        "refined locally: nowhere else",
        surface.triangles().size() < 10*coarse.triangles().size(),
        Foam::name(surface.triangles().size())
    );
}


//- Two unit spheres with a gap, and the walls of a box far away or near
struct gapScene
{
    List<bodySurface> bodies;
    autoPtr<smoothedFacets> smooth;
    List<shapeInGap> shapes;
    surfaceDistance walls;

    static bodySurface far()
    {
        return shape("type sphere; radius 20;", 4);
    }

    gapScene
    (
        const scalar gap, const bool secondHasShape,
        const bool deforming = false
    )
    :
        bodies(2),
        shapes(2),
        walls(far().points(), far().triangles())
    {
        const bodySurface sphere(shape("type sphere; radius 1;", 0.3));
        smooth.reset(new smoothedFacets(sphere, true));
        forAll(bodies, b)
        {
            const point centre(0, 0, (b ? 1 : -1)*(1 + gap/2));
            bodies[b] = sphere.transformed(tensor::I, centre);
            if (deforming)
            {
                shapes[b].smooth = smooth.get();
            }
            else if (!b || secondHasShape)
            {
                shapes[b].onto = [centre](const point& p)
                {
                    return centre + normalised(p - centre);
                };
            }
        }
    }

    List<surfaceInGaps> cut() const
    {
        return refinedInGaps(bodies, shapes, walls, {}, gapSag);
    }

    List<bodySurface> refined() const
    {
        return surfacesOf(cut());
    }
};


//- Of the points whose heights over the gap's middle are below twice the gap:
//  the longest edge over the gap there, and how far they are off the sphere
static void inGap
(
    const bodySurface& s, const scalar gap, scalar& edge, scalar& off
)
{
    edge = off = 0;
    const point centre(0, 0, -1 - gap/2);
    for (const triFace& t : s.triangles())
    {
        for (label i = 0; i < 3; ++i)
        {
            const point& a = s.points()[t[i]];
            const point& b = s.points()[t[(i + 1) % 3]];
            const scalar width = -2*max(a.z(), b.z());
            if (width < 2*gap)
            {
                edge = max(edge, mag(a - b)/width);
                off = max(off, mag(mag(a - centre) - 1)/width);
            }
        }
    }
}


static void checkGapsOfSpheres(checks& c, const bool deforming)
{
    // corners beside edges that are longer and shorter than the mean by 15 % stand
    // out by 30 % more and less, which triangles do not tell from another shape;
    // besides, out stays a quarter of it where edges were halved
    const scalar known = 0.55*sqr(0.3)/8;
    for (const scalar gap : {0.1, 0.01, 0.001})
    {
        if (deforming && gap < known)
        {
            continue;
        }
        const word name
        (
            word(deforming ? "deforming spheres, " : "")
          + "gap " + Foam::name(gap)
        );
        const gapScene s(gap, true, deforming);
        const List<bodySurface> fine(s.refined());
        scalar edge, off;
        inGap(fine[0], gap, edge, off);
        // bound: what the refinement is to do: edges of three gaps at most, but
        // for the middle of one, which may be a gap wider
        c.check(name + ": short edges", edge > 0 && edge < 4, Foam::name(edge));
        // bound: volumes move points by h^2/12 of the edges h at most, a gap's
        // sag is h^2/4 between two spheres, and 0.05 of it by gapSag
        c.checkBelow
        (
            name + ": it is that of the spheres",
            off, deforming ? known/gap : gapSag
        );
        const outcome solid(fine[0].solid("body"));
        c.check(name + ": encloses a solid", solid.ok, solid.reason);
        scalar moved = 0;
        forAll(s.bodies[0].points(), p)
        {
            const point& x = s.bodies[0].points()[p];
            if (x.z() < -1)
            {
                moved = max(moved, mag(x - fine[0].points()[p]));
            }
        }
        c.checkBelow(name + ": nothing on the other side", moved, 1e-12);
        c.check
        (
            name + ": both bodies",
            fine[0].triangles().size() == fine[1].triangles().size()
        );
    }
}


//- Anything that sums to nothing special
static vectorField someVectors(const label n)
{
    vectorField v(n);
    forAll(v, i)
    {
        v[i] = vector(sin(3.1*i), cos(7.7*i), sin(1.3*i + 0.4));
    }
    return v;
}


static void checkCut(checks& c)
{
    const gapScene s(0.01, true, true);
    const surfaceCut cut(s.cut()[0].cut, s.smooth());
    const bodySurface& body = s.bodies[0];
    const bodySurface fine(cut.surface(body));
    const label nPoints = body.points().size();
    const label nTriangles = body.triangles().size();

    // bound: sums of some thirty products
    const vector v(1, -2, 3), spin(0.3, 0.5, -0.7);
    const vectorField shifted(cut.points(vectorField(nPoints, v)));
    c.checkBelow
    (
        "cut triangles: go along with a body that does not turn",
        gMax(mag(shifted - v)), 1e-13
    );
    vectorField atCentres(nTriangles), partCentres(fine.triangles().size());
    forAll(atCentres, i)
    {
        atCentres[i] = body.triangles()[i].centre(body.points());
    }
    forAll(partCentres, i)
    {
        partCentres[i] = fine.triangles()[i].centre(fine.points());
    }
    c.checkBelow
    (
        "cut triangles: turn with the body",
        gMax
        (
            mag
            (
                cut.faces(spin ^ atCentres) - (spin ^ partCentres)
            )
        ),
        1e-13
    );

    scalarField share(nTriangles, Zero);
    forAll(partCentres, i)
    {
        share[cut.parent(i)] += cut.share(i);
    }
    c.checkBelow
    (
        "cut triangles: parts make up the whole", gMax(mag(share - 1)), 1e-13
    );

    const vectorField forces(someVectors(partCentres.size()));
    const vectorField onTriangles(cut.onTriangles(forces));
    c.checkBelow
    (
        "cut triangles: no force is lost",
        mag(sum(onTriangles) - sum(forces)), 1e-11
    );
    c.checkBelow
    (
        "cut triangles: no torque is lost",
        mag(sum(atCentres ^ onTriangles) - sum(partCentres ^ forces)), 1e-11
    );
    const vectorField vTriangles(someVectors(nTriangles));
    c.checkBelow
    (
        "cut triangles: the same power on both sides, whatever moves",
        mag(sum(onTriangles & vTriangles) - sum(forces & cut.faces(vTriangles))),
        1e-11
    );
}


//- The triangles of a cube with n squares along an edge
static bodySurface cube(const label n)
{
    DynamicList<point> points;
    DynamicList<triFace> triangles;
    const auto corner = [&](const point& p)
    {
        const label known = points.find(p);
        if (known < 0)
        {
            points.append(p);
        }
        return known < 0 ? points.size() - 1 : known;
    };
    for (label face = 0; face < 6; ++face)
    {
        const direction d = face % 3, e = (d + 1) % 3, f = (d + 2) % 3;
        const auto at = [&](const label i, const label j)
        {
            point p(Zero);
            p[d] = face < 3 ? 0 : n;
            p[e] = face < 3 ? j : i;
            p[f] = face < 3 ? i : j;
            return corner(p);
        };
        for (label i = 0; i < n; ++i)
        {
            for (label j = 0; j < n; ++j)
            {
                const label a = at(i, j), b = at(i + 1, j + 1);
                triangles.append(triFace(a, at(i + 1, j), b));
                triangles.append(triFace(a, b, at(i, j + 1)));
            }
        }
    }
    return bodySurface(pointField(points), List<triFace>(triangles));
}


//- What smooths the triangles of round bodies leaves those of a cube alone
static void checkSharpEdges(checks& c)
{
    const bodySurface body(cube(4));
    const outcome solid(body.solid("cube"));
    c.check("cube: encloses a solid", solid.ok, solid.reason);
    const smoothedFacets smooth(body, true);
    scalar off = 0;
    for (const triFace& t : body.triangles())
    {
        const facetPlace place{t, vector(0.2, 0.3, 0.5)};
        off = max
        (
            off,
            mag(smooth.at(place, 0).of(body.points()) - place.of(body.points()))
        );
    }
    // bound: what is plane, and the triangles at edges, are reproduced
    c.checkBelow("cube: faces stay plane, edges sharp", off, 1e-13);
}


//- Corners that stand out are brought back, those on the surface stay
static void checkCorners(checks& c)
{
    const bodySurface sphere(shape("type sphere; radius 1;", 0.3));
    const smoothedFacets back(sphere, true), stay(sphere, false);
    scalar off = 0, moved = 0;
    forAll(sphere.points(), k)
    {
        const facetPlace place(facetPlace::at(k));
        off = max(off, mag(mag(back.position(place, sphere.points())) - 1));
        moved = max
        (
            moved,
            mag(stay.position(place, sphere.points()) - sphere.points()[k])
        );
    }
    // bound: they stand out by h^2/12, by up to half of it more or less where edges
    // differ
    c.checkBelow("corners that stand out: brought back", off, sqr(0.3)/24);
    c.checkBelow("corners on the surface: stay", moved, 1e-13);
}


void checkRefining(checks& c)
{
    checkCorners(c);
    checkSharpEdges(c);
    checkRedGreen(c);
    checkGapsOfSpheres(c, false);
    checkGapsOfSpheres(c, true);
    checkCut(c);
    const gapScene wide(1, true);
    const List<bodySurface> same(wide.refined());
    c.check
    (
        "a wide gap: the body's own triangles, to the last bit",
        same[0].points() == wide.bodies[0].points()
     && same[0].triangles() == wide.bodies[0].triangles()
    );
    const gapScene one(0.01, false);
    const List<bodySurface> half(one.refined());
    c.check
    (
        "a body whose shape is not known: nothing is cut for it",
        half[1].triangles() == one.bodies[1].triangles()
     && half[0].triangles() == one.bodies[0].triangles()
    );
}

} // End namespace fsbi
} // End namespace Foam
