/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bodyMesher.H"
#include "cellEstimate.H"
#include "volumeMesher.H"
#include "meshAssembly.H"
#include "meshingAttempts.H"
#include "serialScope.H"
#include "sizeField.H"

namespace Foam
{
namespace fsbi
{

//- Degrees above its limit that a mesh may have for want of a better one: this
//  one does not degrade
static const scalar moreBorne = 5;

static void checkSurface(const word& name, const bodySurface& surface)
{
    surface.check(name);
    if (surface.volume() <= 0)
    {
        FatalErrorInFunction
            << "The surface of body '" << name << "' is inside out or empty: "
            << "its volume is " << surface.volume() << exit(FatalError);
    }
}


//- Of several shells one has the others as holes; why it is not so, or empty
static string severalOutward(const bodySurface& surface)
{
    label outward = 0;
    for (const bodySurface::shell& shell : surface.shells())
    {
        outward += shell.volume > 0;
    }
    return
        outward == 1 ? ""
      : "the surface has " + Foam::name(outward) + " parts that are turned outward,"
        " of which one can be filled";
}


// From the edge length of the triangles to that inside. gmsh inserts points
// until the circumradii are below the size it is asked for; edges are then
// longer by what was measured in uniform meshes.
class innerSize
{
    //- Of all triangles
    scalarField sizes_;

    autoPtr<surfaceDistance> surface_;

    const scalar inside_;

    const scalar growth_;

    static constexpr scalar edgePerSize_ = 1.4;

public:

    innerSize
    (
        const bodySurface& surface,
        const std::vector<bodySurface>& parts,
        const scalar inside,
        const scalar growth
    )
    :
        inside_(inside > 0 ? inside : surface.meanEdge()),
        growth_(growth)
    {
        pointField points;
        DynamicList<triFace> triangles;
        const auto add = [&](const bodySurface& s)
        {
            const label n = points.size();
            for (const triFace& t : s.triangles())
            {
                triangles.append(triFace(n + t[0], n + t[1], n + t[2]));
            }
            points.append(s.points());
            sizes_.append(sizeField::triangleSizes(s));
        };
        add(surface);
        std::for_each(parts.begin(), parts.end(), add);
        surface_.reset(new surfaceDistance(points, triangles));
    }

    scalar operator()(const point& p) const
    {
        scalar d;
        label triangle;
        if (!surface_->find(p, ROOTVGREAT, d, triangle))
        {
            return inside_/edgePerSize_;
        }
        const scalar h = sizes_[triangle];
        return
            (h + max(-growth_*d, min(growth_*d, inside_ - h)))/edgePerSize_;
    }
};

} // End namespace fsbi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::fsbi::meshLists Foam::fsbi::bodyMesher::meshOnce
(
    const bodySurface& surface,
    const std::vector<bodySurface>& parts,
    const std::function<scalar(const point&)>& size,
    const meshingAttempt& settings
) const
{
    meshLists mesh;
    autoPtr<volumeMesher> model(volumeMesher::New(surface.bounds().mag()));
    model->addSurface(surface);
    for (const bodySurface& part : parts)
    {
        model->addPart(part);
    }
    List<FixedList<label, 4>> tetrahedra;
    mesh.failure = model->generate(size, settings, mesh.points, tetrahedra);
    if (mesh.valid())
    {
        DynamicList<boundaryTriangle> boundary;
        forAll(surface.triangles(), i)
        {
            boundary.append({surface.triangles()[i], 0, i});
        }
        mesh.bodyPoints.append(identity(surface.points().size()));
        assembleMesh(mesh, std::move(tetrahedra), boundary, 1);
    }
    return mesh;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::bodyMesher::bodyMesher(const dictionary& remeshDict)
:
    controls_(remeshDict)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::fsbi::meshLists Foam::fsbi::bodyMesher::fill
(
    const word& patchName,
    const bodySurface& surface,
    const scalar size,
    const std::vector<bodySurface>& parts
) const
{
    checkSurface(patchName, surface);
    meshLists mesh;
    mesh.failure = severalOutward(surface);
    if (!mesh.valid())
    {
        return mesh;
    }
    const serialScope serial;
    const innerSize wanted
    (
        surface, parts, size > 0 ? size : controls_.farSize, controls_.growth
    );
    const boundBox box(surface.bounds());
    const auto inside = [&](const point& p)
    {
        return surface.winding(p) > 0.5;
    };
    mesh.failure = tooManyCells
    (
        cellsIn(box, {}, std::cref(wanted), inside, controls_.maxCells),
        controls_
    );
    if (mesh.valid())
    {
        mesh = firstGoodMesh
        (
            controls_,
            [&](const meshingAttempt& settings)
            {
                return meshOnce(surface, parts, std::cref(wanted), settings);
            },
            controls_.maxNonOrthogonality + moreBorne
        );
    }
    if (mesh.valid())
    {
        dictionary dict;
        dict.set("type", "patch");
        mesh.patchNames.append(patchName);
        mesh.patchDicts.append(dict);
    }
    return mesh;
}
