/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "domainSurface.H"
#include "readSurface.H"
#include "surfaceRetriangulation.H"
#include "edgeHashes.H"
#include "mergePoints.H"
#include "SortableList.H"

namespace Foam
{
namespace fsbi
{

//- Points nearer to each other than this part of the domain are one
static const scalar samePoint = 1e-6;

static triSurface readFile(const fileName& file)
{
    triSurface surface;
    outcome read(readSurface(file, surface));
    if (read && surface.empty())
    {
        read = outcome::failed("The surface file '" + file + "' has no triangles");
    }
    if (!read)
    {
        FatalErrorInFunction << read.reason.c_str() << exit(FatalError);
    }
    return surface;
}


static void mergeAll
(
    DynamicList<point>& points,
    DynamicList<triFace>& triangles,
    DynamicList<label>& patches
)
{
    labelList merged;
    pointField left;
    const scalar tolerance = samePoint*boundBox(points, false).mag();
    mergePoints(points, tolerance, false, merged, left);
    label n = 0;
    forAll(triangles, i)
    {
        triFace t(triangles[i]);
        for (label& p : t)
        {
            p = merged[p];
        }
        if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
        {
            patches[n] = patches[i];
            triangles[n++] = t;
        }
    }
    triangles.setSize(n);
    patches.setSize(n);
    points = left;
}

//- Triangles that hang together turned alike, whatever solids and files have
static void turnAlike(List<triFace>& triangles)
{
    EdgeMap<DynamicList<label>> beside(2*triangles.size());
    forAll(triangles, i)
    {
        for (label j = 0; j < 3; ++j)
        {
            beside(edge(triangles[i][j], triangles[i][(j + 1) % 3])).append(i);
        }
    }
    boolList reached(triangles.size(), false);
    forAll(triangles, start)
    {
        DynamicList<label> front(1, start);
        while (front.size())
        {
            const label i = front.remove();
            reached[i] = true;
            for (label j = 0; j < 3; ++j)
            {
                const edge e(triangles[i][j], triangles[i][(j + 1) % 3]);
                for (const label k : beside[e])
                {
                    if (!reached[k])
                    {
                        // the edge runs the other way there
                        if (triangles[k].edgeDirection(e) > 0)
                        {
                            triangles[k].flip();
                        }
                        reached[k] = true;
                        front.append(k);
                    }
                }
            }
        }
    }
}


//- Turned out of the fluid: the outermost shell outward, those of posts inward
static bodySurface turnedOut(const bodySurface& surface)
{
    const std::vector<bodySurface::shell> shells(surface.shells());
    std::size_t outermost = 0;
    for (std::size_t i = 0; i < shells.size(); ++i)
    {
        if (mag(shells[i].volume) > mag(shells[outermost].volume))
        {
            outermost = i;
        }
    }
    List<triFace> triangles(surface.triangles());
    for (std::size_t i = 0; i < shells.size(); ++i)
    {
        if ((shells[i].volume > 0) != (i == outermost))
        {
            for (const label t : shells[i].triangles)
            {
                triangles[t].flip();
            }
        }
    }
    return bodySurface(surface.points(), triangles);
}

} // End namespace fsbi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsbi::domainSurface::add
(
    const fileName& file,
    const bool only,
    DynamicList<point>& points,
    DynamicList<triFace>& triangles,
    DynamicList<label>& patches
)
{
    const triSurface read(readFile(file));
    const label first = points.size(), firstPatch = patchNames_.size();
    for (const geometricSurfacePatch& patch : read.patches())
    {
        word name
        (
            read.patches().size() == 1 && !only
          ? word(file.nameLessExt()) : patch.name()
        );
        if (name == "wall")
        {
            Info<< "The patch of 'wall' is 'walls': OpenFOAM has a group of patches"
                << " of that name" << endl;
            name = "walls";
        }
        if (patchNames_.found(name))
        {
            FatalErrorInFunction
                << "Two solids of the surface files are named '" << name
                << "', the second in " << file << exit(FatalError);
        }
        patchNames_.append(name);
    }
    points.append(read.localPoints());
    forAll(read, i)
    {
        const labelledTri& t = read.localFaces()[i];
        triangles.append(triFace(t[0] + first, t[1] + first, t[2] + first));
        patches.append(firstPatch + read[i].region());
    }
}


void Foam::fsbi::domainSurface::sort()
{
    const SortableList<label> sorted(patches_);
    patches_ = sorted;
    surface_ = bodySurface
    (
        surface_.points(),
        List<triFace>(surface_.triangles(), sorted.indices())
    );
}


Foam::fsbi::domainSurface::domainSurface
(
    const domainSurface& given,
    const bodySurface& triangles,
    const labelUList& patches
)
:
    name_(given.name_),
    surface_(triangles),
    patchNames_(given.patchNames_),
    patches_(patches)
{
    sort();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::domainSurface::domainSurface
(
    const List<fileName>& files, const scalar scale
)
:
    name_("the domain")
{
    for (const fileName& file : files)
    {
        name_ += " '" + file + "'";
    }
    DynamicList<point> points;
    DynamicList<triFace> triangles;
    DynamicList<label> patches;
    for (const fileName& file : files)
    {
        add(file, files.size() == 1, points, triangles, patches);
    }
    for (point& p : points)
    {
        p *= scale;
    }
    mergeAll(points, triangles, patches);
    patches_ = patches;
    turnAlike(triangles);
    surface_ = bodySurface
    (
        pointField(std::move(points)), List<triFace>(std::move(triangles))
    );
    const outcome solid(surface_.solid(name_));
    if (!solid)
    {
        FatalErrorInFunction << solid.reason.c_str() << exit(FatalError);
    }
    surface_ = turnedOut(surface_);
    sort();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsbi::domainSurface::area(const label patchi) const
{
    scalar sum = 0;
    forAll(patches_, i)
    {
        if (patches_[i] == patchi)
        {
            sum += surface_.triangles()[i].mag(surface_.points());
        }
    }
    return sum;
}


Foam::fsbi::domainSurface Foam::fsbi::domainSurface::retriangulated
(
    const sizeFunction& size, const scalar featureAngle
) const
{
    labelList patches;
    const bodySurface triangles
    (
        fsbi::retriangulated(surface_, patches_, featureAngle, size, patches)
    );
    const outcome solid
    (
        triangles.solid(name_ + ", in triangles of the size wanted,")
    );
    if (!solid)
    {
        FatalErrorInFunction
            << solid.reason.c_str() << nl
            << "A smaller size may help, or another featureAngle"
            << exit(FatalError);
    }
    return domainSurface(*this, triangles, patches);
}


Foam::fsbi::meshLists Foam::fsbi::domainSurface::fill
(
    const bodyMesher& mesher, const wordList& open
) const
{
    meshLists mesh(mesher.fill("domain", surface_));
    if (!mesh.valid())
    {
        return mesh;
    }
    // the faces are in the order of the triangles
    const label first = mesh.patchStarts[0];
    const label n = patchNames_.size();
    mesh.patchNames = patchNames_;
    mesh.patchDicts.setSize(n);
    mesh.patchSizes = labelList(n, Zero);
    mesh.patchStarts.setSize(n);
    for (const label patchi : patches_)
    {
        ++mesh.patchSizes[patchi];
    }
    label start = first;
    forAll(patchNames_, patchi)
    {
        dictionary dict;
        dict.set("type", open.found(patchNames_[patchi]) ? "patch" : "wall");
        mesh.patchDicts[patchi] = dict;
        mesh.patchStarts[patchi] = start;
        start += mesh.patchSizes[patchi];
    }
    return mesh;
}
