/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "conformalMesher.H"
#include "cellEstimate.H"
#include "volumeMesher.H"
#include "meshingAttempts.H"
#include "serialScope.H"
#include "sizeField.H"
#include "surfacesTogether.H"
#include "surfaceDistance.H"
#include "wallPolyPatch.H"
#include "OStringStream.H"

#include <algorithm>
#include <cmath>
#include <memory>

namespace Foam
{
namespace fsbi
{

//- Binary digits of a coordinate, over the size of the domain, that the mesh
//  depends on: 1e-6. Round-off further down would turn edges of the mesh
static const label digits = 20;

//- And over the shortest edge of a body, where that needs more
static const label digitsOfEdge = 8;

//- Where bodies are placed
static const char* const places =
    " (position and shape in constant/bodies, vertices and scale of the domain"
    " in system/blockMeshDict)";

//- Shortest mean edge of a body, in units of the last of these digits: bodies
//  that round-off would deform
static const scalar finestEdge = 4;

static vector rounded(const vector& x, const scalar unit)
{
    return unit*vector
    (
        std::round(x.x()/unit), std::round(x.y()/unit), std::round(x.z()/unit)
    );
}


//- What points are rounded to, if there are no such edges
static scalar unitOf(const boundBox& domain)
{
    return std::ldexp(1.0, std::ilogb(domain.mag()) - digits);
}


static scalar unitOf
(
    const boundBox& domain, const UList<bodySurface>& bodies
)
{
    int exponent = std::ilogb(unitOf(domain));
    for (const bodySurface& body : bodies)
    {
        const scalar edge = min(body.pointEdges());
        exponent = min(exponent, std::ilogb(edge) - digitsOfEdge);
    }
    return std::ldexp(1.0, exponent);
}


static List<bodySurface> rounded
(
    const UList<bodySurface>& bodies, const scalar unit
)
{
    List<bodySurface> result(bodies.size());
    forAll(bodies, b)
    {
        pointField points(bodies[b].points());
        for (point& p : points)
        {
            p = rounded(p, unit);
        }
        result[b] = bodySurface(points, bodies[b].triangles());
    }
    return result;
}

} // End namespace fsbi
} // End namespace Foam

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::fsbi::outcome Foam::fsbi::conformalMesher::placed
(
    const wordList& names,
    const UList<bodySurface>& bodies,
    const boundBox& domain
)
{
    OStringStream reason;
    forAll(bodies, b)
    {
        const boundBox box(bodies[b].bounds());
        if (!domain.overlaps(box))
        {
            reason
                << "Body '" << names[b] << "' lies outside the domain, near "
                << box.centre() << places;
            return outcome::failed(reason.str());
        }
        if (!domain.contains(box))
        {
            reason
                << "Body '" << names[b] << "' crosses the boundary of the"
                << " domain: it reaches from " << box.min() << " to "
                << box.max() << ", the domain from " << domain.min() << " to "
                << domain.max() << places;
            return outcome::failed(reason.str());
        }
        if (bodies[b].meanEdge() < finestEdge*unitOf(domain))
        {
            reason
                << "Body '" << names[b] << "' is " << cmptMax(box.span())
                << " large in a domain of " << cmptMax(domain.span())
                << ": is it in another unit (scale)?";
            return outcome::failed(reason.str());
        }
    }
    return outcome();
}


Foam::fsbi::outcome Foam::fsbi::conformalMesher::apart
(
    const wordList& names,
    const UList<bodySurface>& bodies,
    const UList<vector>& images,
    const bodySurface& walls,
    const bool closed
)
{
    surfacesTogether all;
    forAll(bodies, b)
    {
        const outcome solid(bodies[b].solid("body '" + names[b] + "'"));
        if (!solid)
        {
            return solid;
        }
        all.append(bodies[b], names[b], "overlaps body '" + names[b] + "'");
    }
    all.append(walls, word(), "crosses the boundary of the domain");
    forAll(bodies, b)
    {
        for (const vector& image : images)
        {
            const bodySurface there(bodies[b].transformed(tensor::I, image));
            const auto near = [&](const bodySurface& body)
            {
                return body.bounds().overlaps(there.bounds());
            };
            if (std::any_of(bodies.begin(), bodies.end(), near))
            {
                all.append
                (
                    there, names[b],
                    "overlaps body '" + names[b] + "' a period further"
                );
            }
        }
    }
    const string crossing(all.crossing(bodies.size()));
    return
        crossing.empty()
      ? outside(names, bodies, walls, closed)
      : outcome::failed(crossing + places);
}


Foam::fsbi::outcome Foam::fsbi::conformalMesher::outside
(
    const wordList& names,
    const UList<bodySurface>& bodies,
    const bodySurface& walls,
    const bool closed
)
{
    OStringStream reason;
    forAll(bodies, b)
    {
        const point& p = bodies[b].points()[0];
        if (closed && walls.winding(p) < 0.5)
        {
            reason
                << "Body '" << names[b] << "' lies outside the domain, near "
                << p << places;
            return outcome::failed(reason.str());
        }
        forAll(bodies, other)
        {
            if
            (
                other != b
             && bodies[other].bounds().contains(p)
             && bodies[other].winding(p) > 0.5
            )
            {
                reason
                    << "Body '" << names[b] << "' lies inside body '"
                    << names[other] << "'" << places;
                return outcome::failed(reason.str());
            }
        }
    }
    return outcome();
}


Foam::DynamicList<Foam::fsbi::boundaryTriangle>
Foam::fsbi::conformalMesher::boundaryOf
(
    const UList<bodySurface>& bodies,
    const domainBoundary& given,
    const volumeMesher& model,
    meshLists& mesh
) const
{
    DynamicList<boundaryTriangle> boundary;
    const label nDomain = domain_.boundaryMesh().size();
    label offset = 0;
    forAll(bodies, b)
    {
        forAll(bodies[b].triangles(), i)
        {
            const triFace& t = bodies[b].triangles()[i];
            // out of the fluid is into the body
            const triFace f(t[0] + offset, t[2] + offset, t[1] + offset);
            boundary.append({f, nDomain + b, i});
        }
        mesh.bodyPoints.append(identity(bodies[b].points().size(), offset));
        offset += bodies[b].points().size();
    }
    forAll(given.patches, i)
    {
        const triFace& t = given.surface.triangles()[i];
        const triFace f(t[0] + offset, t[1] + offset, t[2] + offset);
        boundary.append({f, given.patches[i], -1});
    }
    if (given.patches.empty())
    {
        for (label piece = 0; piece < outline_.nPieces(); ++piece)
        {
            for (const triFace& t : model.pieceTriangles(piece))
            {
                boundary.append({t, outline_.patch(piece), -1});
            }
        }
    }
    return boundary;
}


Foam::fsbi::meshLists Foam::fsbi::conformalMesher::meshOnce
(
    const UList<bodySurface>& bodies,
    const bodySurface& walls,
    const vector& shift,
    sizeField& size,
    const meshingAttempt& settings
) const
{
    meshLists mesh;
    size.coarsenGaps(settings.coarsening);
    const domainBoundary given
    (
        givenBoundary(bodies, walls, shift, size, settings, mesh.failure)
    );
    if (!mesh.valid())
    {
        return mesh;
    }
    autoPtr<volumeMesher> model(volumeMesher::New(walls.bounds().mag()));
    for (const bodySurface& body : bodies)
    {
        model->addSurface(body);
    }
    if (given.patches.size())
    {
        model->addSurface(given.surface);
    }
    else
    {
        addPieces([&](const point& p) { return p + shift; }, model());
    }

    List<FixedList<label, 4>> tetrahedra;
    mesh.failure = model->generate
    (
        std::cref(size), settings, mesh.points, tetrahedra
    );
    if (!mesh.valid())
    {
        return mesh;
    }

    assembleMesh
    (
        mesh, std::move(tetrahedra), boundaryOf(bodies, given, model(), mesh),
        domain_.boundaryMesh().size() + bodies.size()
    );
    cyclics_.order(mesh);
    return mesh;
}


Foam::scalar Foam::fsbi::conformalMesher::reportCells
(
    const UList<bodySurface>& bodies,
    const bodySurface& walls,
    const sizeField& size
) const
{
    List<extent> extents(bodies.size());
    PtrList<surfaceDistance> surfaces(bodies.size());
    forAll(bodies, b)
    {
        const bodySurface& body = bodies[b];
        extents[b] = {body.bounds(), max(body.pointEdges())};
        surfaces.set(b, new surfaceDistance(body.points(), body.triangles()));
    }
    const auto inFluid = [&](const point& p)
    {
        for (const surfaceDistance& surface : surfaces)
        {
            if (surface.contains(p))
            {
                return false;
            }
        }
        return !outline_.curved() || walls.winding(p) > 0.5;
    };
    const scalar cells = cellsIn
    (
        walls.bounds(), extents, std::cref(size), inFluid, controls_.maxCells
    );
    if (cells > 1.5*cellsTold_ && cells <= controls_.maxCells)
    {
        const scalar digit = std::pow(10, std::floor(std::log10(cells)) - 1);
        Info<< "Meshing about " << digit*std::round(cells/digit) << " cells"
            << endl;
        cellsTold_ = cells;
    }
    return cells;
}


void Foam::fsbi::conformalMesher::setPatches
(
    const wordList& names, meshLists& mesh
) const
{
    for (const polyPatch& patch : domain_.boundaryMesh())
    {
        OStringStream os;
        os << patch;
        dictionary dict{IStringStream(os.str())()};
        dict.remove("nFaces");
        dict.remove("startFace");
        if (cyclics_.found(patch.index()))
        {
            // bent, they have no one normal to find it from
            dict.set("transform", "translational");
            dict.set("separationVector", cyclics_.translation(patch.index()));
        }
        mesh.patchNames.append(patch.name());
        mesh.patchDicts.append(dict);
    }
    for (const word& name : names)
    {
        dictionary dict;
        dict.set("type", "wall");
        dict.set("inGroups", wordList({"wall", "bodies"}));
        mesh.patchNames.append(name);
        mesh.patchDicts.append(dict);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::conformalMesher::conformalMesher
(
    const polyMesh& domain, const dictionary& remeshDict
)
:
    domain_(domain),
    controls_(remeshDict),
    outline_(domain),
    cyclics_(domain, outline_),
    open_(cyclics_.periods().size()),
    walls_(outline_.triangulation()),
    barriers_
    (
        walls_.part
        (
            [this](const label patch) { return !cyclics_.found(patch); }
        )
    ),
    cellsTold_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::List<Foam::fsbi::surfaceInGaps> Foam::fsbi::conformalMesher::refined
(
    const UList<bodySurface>& bodies,
    const UList<shapeInGap>& shapes,
    const vector& shift
) const
{
    // nothing holds the flow back at an open patch
    const bodySurface walls
    (
        walls_.part
        (
            [this](const label patch)
            {
                return isA<wallPolyPatch>(domain_.boundaryMesh()[patch]);
            }
        ).transformed(tensor::I, shift)
    );
    const surfaceDistance toWalls(walls.points(), walls.triangles());
    return refinedInGaps
    (
        bodies, shapes, toWalls, imagesOf(periods()), controls_.gapSag
    );
}


Foam::fsbi::meshLists Foam::fsbi::conformalMesher::generate
(
    const wordList& bodyNames,
    const UList<bodySurface>& exact,
    const vector& exactShift,
    const scalar finestEdge
) const
{
    const scalar unit = unitOf(walls_.surface.bounds(), exact);
    const List<bodySurface> bodies(rounded(exact, unit));
    const vector shift(rounded(exactShift, unit));
    const bodySurface walls(walls_.surface.transformed(tensor::I, shift));
    const bodySurface barriers(barriersAt(shift));
    outcome possible(placed(bodyNames, exact, room(shift)));
    if (possible)
    {
        possible = apart
        (
            bodyNames, bodies, imagesOf(periods()), barriers, periods().empty()
        );
    }
    meshLists mesh;
    mesh.failure = possible.reason;
    mesh.apart = bool(possible);
    if (!possible)
    {
        return mesh;
    }
    const serialScope serial;
    remeshControls controls(controls_);
    if (finestEdge > 0 && controls.minSize <= 0)
    {
        // without the round-off of bodies' places, as the points
        controls.minSize =
            remeshControls::finestPart*unit*std::round(finestEdge/unit);
    }
    sizeField size
    (
        domain_, shift, barriers, bodies, images(), controls
    );
    mesh.failure = tooManyCells(reportCells(bodies, walls, size), controls_);
    if (mesh.valid())
    {
        mesh = firstGoodMesh
        (
            controls_,
            [&](const meshingAttempt& settings)
            {
                return meshOnce(bodies, walls, shift, size, settings);
            },
            remeshControls::bearable
        );
    }
    if (mesh.valid())
    {
        mesh.points += exactShift - shift;
        forAll(exact, b)
        {
            UIndirectList<point>(mesh.points, mesh.bodyPoints[b]) =
                exact[b].points();
        }
        setPatches(bodyNames, mesh);
    }
    return mesh;
}


Foam::fsbi::outcome Foam::fsbi::conformalMesher::inside
(
    const wordList& names,
    const UList<bodySurface>& bodies,
    const bodySurface& walls,
    const vector& shift
) const
{
    if (open_)
    {
        const outcome there(placed(names, bodies, room(shift)));
        return
            there
          ? apart
            (
                names, bodies, imagesOf(periods()), barriersAt(shift), false
            )
          : there;
    }
    const outcome there(placed(names, bodies, walls.bounds()));
    return there ? apart(names, bodies, {}, walls, true) : there;
}


Foam::fsbi::outcome Foam::fsbi::conformalMesher::placed
(
    const wordList& names,
    const UList<bodySurface>& bodies,
    const vector& shift
) const
{
    return placed(names, bodies, room(shift));
}


Foam::fsbi::sizeFunction Foam::fsbi::conformalMesher::sizes
(
    const UList<bodySurface>& bodies,
    const vector& shift,
    const scalar finestEdge
) const
{
    const serialScope serial;
    remeshControls controls(controls_);
    if (controls.minSize <= 0)
    {
        controls.minSize = remeshControls::finestPart*finestEdge;
    }
    const std::shared_ptr<const sizeField> size
    (
        new sizeField
        (
            domain_, shift, barriersAt(shift), bodies, images(), controls
        )
    );
    return [size](const point& p) { return (*size)(p); };
}
