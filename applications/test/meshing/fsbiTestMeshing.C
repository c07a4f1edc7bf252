/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Application
    fsbiTestMeshing

Description
    Checks of the conformal mesher, mesh motion and distribution.

\*---------------------------------------------------------------------------*/

#include "boxMesh.H"
#include "bodyShape.H"
#include "conformalMesher.H"
#include "fvMesh.H"
#include "IStringStream.H"
#include "clockTime.H"

using namespace Foam;
using namespace Foam::fsbi;

int main(int argc, char* argv[])
{
    autoPtr<Time> clock(testClock());
    autoPtr<polyMesh> box(boxMesh(clock(), boundBox(point(-4,-4,-4), point(4,4,4)), Vector<label>(8,8,8)));
    autoPtr<bodyShape> shape(bodyShape::New(dictionary(IStringStream("type sphere; radius 1; size 0.2;")())));
    List<bodySurface> bodies(1, shape->triangulate());
    Info<< bodies[0].triangles().size() << " " << bodies[0].meanEdge() << " " << bodies[0].volume() << nl;
    clockTime t;
    conformalMesher mesher(box(), dictionary(IStringStream("algorithm Delaunay;")()));
    meshLists mesh(mesher.generate({"bead"}, bodies, Zero));
    Info<< "t " << t.elapsedTime() << " " << mesh.failure << nl;
    meshQuality q(mesh);
    Info<< mesh.nCells() << " nonOrtho " << q.maxNonOrthogonality << " " << q.meanNonOrthogonality << " " << q.maxSkewness << " " << q.minVolume << nl;
    autoPtr<fvMesh> fv(mesh.makeMesh(IOobject("fluid", clock->timeName(), clock())));
    Info<< fv->boundaryMesh().names() << fv->nCells() << nl;
    fv->checkMesh(true);
    meshQuality p(fv());
    Info<< p.nCells << " nonOrtho " << p.maxNonOrthogonality << " " << p.meanNonOrthogonality << " " << p.maxSkewness << " " << p.minVolume << nl;
    return 0;
}
