/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "gmshModel.H"
#include "addToRunTimeSelectionTable.H"
#include "meshingAttempts.H"

#include <algorithm>
#include <cmath>
#include <gmsh.h>

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(gmshModel, 0);
    addToRunTimeSelectionTable(volumeMesher, gmshModel, entries);
}
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsbi::gmshModel::setOptions
(
    const meshingAttempt& settings
)
{
    const std::pair<const char*, double> options[] =
    {
        {"Mesh.Algorithm", 6},                  // frontal: best triangles
        {"Mesh.Algorithm3D", double(settings.algorithm3D)},
        {"Mesh.RandomSeed", double(settings.seed)},
        {"Mesh.Optimize", double(settings.optimise)},
        {"Mesh.OptimizeThreshold", 0.4},
        {"Mesh.OptimizeNetgen", 0},
        {"Mesh.Renumber", 0},                   // keeps our node tags
        {"Mesh.ElementOrder", 1},
        {"Mesh.MeshSizeExtendFromBoundary", 0}, // the size field says it all
        {"Mesh.MeshSizeFromPoints", 0},
        {"Mesh.MeshSizeFromCurvature", 0},
        {"Mesh.MaxNumThreads1D", 1},
        {"Mesh.MaxNumThreads2D", 1},
        {"Mesh.MaxNumThreads3D", 1}
    };
    for (const auto& option : options)
    {
        gmsh::option::setNumber(option.first, option.second);
    }
}


Foam::pointField Foam::fsbi::gmshModel::readPoints()
{
    std::vector<std::size_t> tags;
    std::vector<double> coordinates, parameters;
    gmsh::model::mesh::getNodes
    (
        tags, coordinates, parameters, -1, -1, false, false
    );

    // the given points keep their tags 1, 2, ..., the new ones follow
    std::vector<std::pair<std::size_t, std::size_t>> order;
    for (std::size_t i = 0; i < tags.size(); ++i)
    {
        order.push_back({tags[i], i});
    }
    std::sort(order.begin(), order.end());
    pointField points(order.size());
    forAll(points, p)
    {
        const double* x = &coordinates[3*order[p].second];
        points[p] = point(x[0], x[1], x[2])/scale_;
        index_[order[p].first] = p;
    }
    return points;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::gmshModel::gmshModel(const scalar diameter)
:
    scale_(std::ldexp(1.0, 4 - std::ilogb(diameter))),
    nGivenPoints_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::vector<int> Foam::fsbi::gmshModel::add(const bodySurface& surface)
{
    std::vector<int> tags;
    const label first = nGivenPoints_ + 1;
    const label nPoints = surface.points().size();
    for (const bodySurface::shell& shell : surface.shells())
    {
        const int tag = gmsh::model::addDiscreteEntity
        (
            2, 100001 + given_.size() + filled_.size() + tags.size()
        );
        std::vector<std::size_t> nodes, corners;
        std::vector<double> coordinates;
        for (const label i : shell.points)
        {
            const point p(scale_*surface.points()[i]);
            nodes.push_back(first + i);
            coordinates.insert(coordinates.end(), {p.x(), p.y(), p.z()});
        }
        for (const label i : shell.triangles)
        {
            for (const label p : surface.triangles()[i])
            {
                corners.push_back(first + p);
            }
        }
        gmsh::model::mesh::addNodes(2, tag, nodes, coordinates);
        gmsh::model::mesh::addElementsByType(tag, 2, {}, corners);
        tags.push_back(tag);
    }
    nGivenPoints_ += nPoints;
    return tags;
}


void Foam::fsbi::gmshModel::addOutline
(
    const domainOutline& outline,
    const std::function<point(const point&)>& place
)
{
    std::vector<int> corners, lines;
    for (const point& corner : outline.corners())
    {
        const point p(scale_*place(corner));
        corners.push_back(gmsh::model::geo::addPoint(p.x(), p.y(), p.z()));
    }
    for (const labelPair& line : outline.lines())
    {
        lines.push_back
        (
            gmsh::model::geo::addLine
            (
                corners[line.first()], corners[line.second()]
            )
        );
    }
    for (label piece = 0; piece < outline.nPieces(); ++piece)
    {
        std::vector<int> loops;
        for (const DynamicList<label>& loop : outline.loops(piece))
        {
            std::vector<int> tags;
            for (const label l : loop)
            {
                tags.push_back(l > 0 ? lines[l - 1] : -lines[-l - 1]);
            }
            loops.push_back(gmsh::model::geo::addCurveLoop(tags));
        }
        pieces_.push_back(gmsh::model::geo::addPlaneSurface(loops));
    }
}


void Foam::fsbi::gmshModel::addVolumes() const
{
    std::vector<int> shells;
    if (pieces_.size())
    {
        shells.push_back(gmsh::model::geo::addSurfaceLoop(pieces_));
    }
    // without pieces the last surface given is the domain's
    for (auto tag = given_.rbegin(); tag != given_.rend(); ++tag)
    {
        shells.push_back(gmsh::model::geo::addSurfaceLoop({*tag}));
    }
    for (const int tag : filled_)
    {
        shells.push_back(gmsh::model::geo::addSurfaceLoop({tag}));
        gmsh::model::geo::addVolume({shells.back()});
    }
    gmsh::model::geo::addVolume(shells);
}


void Foam::fsbi::gmshModel::mesh
(
    const sizeFunction& size,
    const meshingAttempt& settings,
    const int dimension
)
{
    setOptions(settings);
    if (dimension == 3)
    {
        addVolumes();
    }
    gmsh::model::geo::synchronize();
    for (const copy& c : copies_)
    {
        const vector t(scale_*c.translation);
        gmsh::model::mesh::setPeriodic
        (
            2, {c.tag}, {c.of},
            {1, 0, 0, t.x(), 0, 1, 0, t.y(), 0, 0, 1, t.z(), 0, 0, 0, 1}
        );
    }
    gmsh::model::mesh::setSizeCallback
    (
        [&](int, int, double x, double y, double z)
        {
            return scale_*size(point(x, y, z)/scale_);
        }
    );
    gmsh::model::mesh::generate(dimension);
    gmsh::model::mesh::removeSizeCallback();
}


Foam::string Foam::fsbi::gmshModel::generate
(
    const sizeFunction& size,
    const meshingAttempt& settings,
    pointField& points,
    List<FixedList<label, 4>>& tetrahedra
)
{
    const int tetrahedron = 4;
    std::vector<std::size_t> tags, nodes;
    try
    {
        mesh(size, settings, 3);
        gmsh::model::mesh::getElementsByType(tetrahedron, tags, nodes);
    }
    catch (...)
    {
        return "gmsh: " + session_.errors();
    }
    if (nodes.empty())
    {
        return "gmsh made no cells: " + session_.errors();
    }

    points = readPoints();
    tetrahedra.setSize(tags.size());
    forAll(tetrahedra, c)
    {
        for (label i = 0; i < 4; ++i)
        {
            tetrahedra[c][i] = index_.at(nodes[4*c + i]);
        }
    }
    return "";
}


Foam::string Foam::fsbi::gmshModel::generateSurfaces
(
    const sizeFunction& size,
    const meshingAttempt& settings,
    pointField& points
)
{
    try
    {
        mesh(size, settings, 2);
    }
    catch (...)
    {
        return "gmsh: " + session_.errors();
    }
    points = readPoints();
    return "";
}


Foam::List<Foam::triFace> Foam::fsbi::gmshModel::pieceTriangles
(
    const label piece
) const
{
    const int triangle = 2;
    std::vector<std::size_t> tags, nodes;
    gmsh::model::mesh::getElementsByType(triangle, tags, nodes, pieces_[piece]);
    List<triFace> triangles(tags.size());
    forAll(triangles, i)
    {
        for (label j = 0; j < 3; ++j)
        {
            triangles[i][j] = index_.at(nodes[3*i + j]);
        }
    }
    return triangles;
}
