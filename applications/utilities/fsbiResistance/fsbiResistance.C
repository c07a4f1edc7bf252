/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Application
    fsbiResistance

Description
    Resistance and mobility matrices of the rigid bodies of a scene, where they
    stand at the start or in the last saved state, with all walls and other
    bodies:

        (F, T) = R (U, omega),    (U, omega) = R^-1 (F, T),

    F, T: what the bodies exert on the fluid, about their centres, U and omega:
    their motion against a fluid at rest. From six solutions for each body and
    one with the scene's own flow, whose forces on bodies at rest are written,
    too. For reduced-order models, and to see what a mesh is worth: the matrix
    of the exact flow is symmetric.

Usage
    \code
    blockMesh && fsbiResistance
    blockMesh && fsbiResistance -tractions
    \endcode
    -tractions: one solution with the scene's flow around the bodies at rest
    (rolling ones at their surface velocity); writes
    postProcessing/tractions.<body>.csv, `x,y,z,tx,ty,tz`: centres of the
    triangles of the surface, and the fluid's force on the body per area there
    (sum of areas times these: the force). For fsbiIdentifyMaterial, see there.

    Without: writes postProcessing/resistance.csv, its layout is that of `layout`
    below, which the help and every run print.

\*---------------------------------------------------------------------------*/

#include "petscObjects.H"
#include "resistance.H"
#include "caseFingerprint.H"
#include "argList.H"
#include "caseInput.H"
#include "checkpoint.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "scalarMatrices.H"

using namespace Foam;

static const wordList rowNames({"Fx", "Fy", "Fz", "Tx", "Ty", "Tz"});
static const wordList columnNames({"Ux", "Uy", "Uz", "Wx", "Wy", "Wz"});

//- How the table is to be read, for the help and after a run
static const string layout
(
    "It holds (F, T) = R (U, W) and (U, W) = M (F, T). F, T: force and torque\n"
    "that the bodies exert on the fluid; the fluid's on them are the opposite, so\n"
    "R is positive definite. U, W: velocity and angular velocity in a fluid at\n"
    "rest. Torque and velocity are those of each body's centre, its position in\n"
    "the history.\n"
    "A row for each body and component: `body,row`, Fx Fy Fz Tx Ty Tz. Columns:\n"
    "R.<body>.<Ux ... Wz>; M.<body>.<Fx ... Tz>, whose rows are Ux ... Wz; flow,\n"
    "the fluid's force or torque on the bodies at rest in the scene's flow. Axes\n"
    "and units are the case's."
);


//- Forces and torques on all bodies, one after the other, for a motion
static scalarField loadsAt(fsbi::scene& scene, const scalarField& motion)
{
    List<fsbi::sixVector> velocities(scene.bodies().rigid.size()), loads;
    forAll(motion, i)
    {
        velocities[i/6][i % 6] = motion[i];
    }
    const fsbi::outcome solved(scene.loadsAt(velocities, loads));
    if (!solved)
    {
        FatalErrorInFunction << solved.reason.c_str() << exit(FatalError);
    }
    scalarField flat(motion.size());
    forAll(flat, i)
    {
        flat[i] = loads[i/6][i % 6];
    }
    return flat;
}


static scalarSquareMatrix inverse(scalarSquareMatrix R)
{
    labelList pivots(R.n());
    LUDecompose(R, pivots);
    scalarSquareMatrix result(R.n(), R.n(), Zero);
    for (label j = 0; j < R.n(); ++j)
    {
        scalarField column(R.n(), Zero);
        column[j] = 1;
        LUBacksubstitute(R, pivots, column);
        forAll(column, i)
        {
            result(i, j) = column[i];
        }
    }
    return result;
}


//- Largest difference to the transposed, over what would be symmetric
static scalar asymmetry(const scalarSquareMatrix& R)
{
    scalar largest = 0;
    for (label i = 0; i < R.n(); ++i)
    {
        for (label j = 0; j < i; ++j)
        {
            largest = max
            (
                largest,
                mag(R(i, j) - R(j, i))/Foam::sqrt(mag(R(i, i)*R(j, j)))
            );
        }
    }
    return largest;
}


static void write
(
    const fsbi::scene& scene,
    const fileName& file,
    const scalarSquareMatrix& R,
    const scalarSquareMatrix& M,
    const scalarField& flow
)
{
    mkDir(file.path());
    OFstream os(file);
    os.precision(10);
    const auto bodyOf = [&](const label i)
    {
        return scene.bodies().rigid[i/6].name();
    };
    os << "body,row";
    for (const word kind : {"R", "M"})
    {
        for (label j = 0; j < R.n(); ++j)
        {
            os << ',' << kind << '.' << bodyOf(j) << '.'
                << (kind == "R" ? columnNames : rowNames)[j % 6];
        }
    }
    os << ",flow" << nl;
    for (label i = 0; i < R.n(); ++i)
    {
        os << bodyOf(i) << ',' << rowNames[i % 6];
        for (const scalarSquareMatrix* A : {&R, &M})
        {
            for (label j = 0; j < R.n(); ++j)
            {
                os << ',' << (*A)(i, j);
            }
        }
        os << ',' << flow[i] << nl;
    }
}


//- Force per area of the fluid on a body, where the scene's flow meets it
static void writeTractions(const fsbi::scene& scene, const label bodyi)
{
    const fvMesh& mesh = scene.fluid().mesh();
    const fsbi::fluidMesh& meshing = scene.fluid().meshing();
    const polyPatch& pp = mesh.boundaryMesh()[meshing.bodyPatch(bodyi)];
    const label start = pp.start() - mesh.nInternalFaces();

    List<pointField> points(Pstream::nProcs());
    List<vectorField> tractions(Pstream::nProcs());
    pointField& x = points[Pstream::myProcNo()];
    vectorField& t = tractions[Pstream::myProcNo()];
    x = pp.faceCentres();
    t.setSize(pp.size());
    forAll(t, i)
    {
        // sigma.S, S out of the fluid
        t[i] = -scene.fluid().traction()[start + i]/mag(pp.faceAreas()[i]);
    }
    Pstream::gatherList(points);
    Pstream::gatherList(tractions);
    if (!Pstream::master())
    {
        return;
    }
    const fileName file
    (
        mesh.time().globalPath()/"postProcessing"
       /"tractions." + meshing.bodies()[bodyi].name() + ".csv"
    );
    mkDir(file.path());
    OFstream os(file);
    os.precision(12);
    os << "x,y,z,tx,ty,tz" << nl;
    forAll(points, proci)
    {
        forAll(points[proci], i)
        {
            const point& p = points[proci][i];
            const vector& force = tractions[proci][i];
            os << p.x() << ',' << p.y() << ',' << p.z() << ',' << force.x()
                << ',' << force.y() << ',' << force.z() << nl;
        }
    }
    Info<< "Written: " << file << endl;
}


int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Resistance and mobility matrices of the rigid bodies of a scene, where"
        " they\nstand at the start, or in the last saved state with"
        " 'startFrom latestTime'.\n\n"
        "    blockMesh && fsbiResistance\n\n"
        "Writes postProcessing/resistance.csv.\n" + layout
    );
    argList::addBoolOption
    (
        "tractions",
        "Write the fluid's force per area on the bodies at rest; no matrices"
    );
    #include "setRootCase.H"
    fsbi::caseInput::check(args);
    #include "createTime.H"

    fsbi::petscSession petsc;
    fsbi::scene scene(runTime, fsbi::checkpoint(runTime).read());
    if (scene.bodies().rigid.empty() || scene.bodies().elastic.size())
    {
        FatalErrorInFunction
            << "fsbiResistance needs a scene with rigid bodies, and with no"
            << " elastic ones" << exit(FatalError);
    }
    const string unresolved(scene.unresolved(scene.smallestGap()));
    if (unresolved.size())
    {
        Info<< unresolved.c_str() << endl;
    }
    if (args.found("tractions"))
    {
        loadsAt(scene, scalarField(6*scene.bodies().rigid.size(), Zero));
        forAll(scene.fluid().meshing().bodies(), bodyi)
        {
            writeTractions(scene, bodyi);
        }
        return 0;
    }

    checkResistance(scene.fluid().momentum(), "The matrices of fsbiResistance");
    const label n = 6*scene.bodies().rigid.size();
    const fsbi::resistance found
    (
        fsbi::resistanceOf
        (
            n, [&](const scalarField& motion)
            {
                const scalarField loads(loadsAt(scene, motion));
                Info<< "Solution: " << scene.report().iterations
                    << " iterations";
                if (scene.fluid().error().known())
                {
                    Info<< ", forces to "
                        << 100*scene.fluid().error().relative() << " %";
                }
                Info<< endl;
                return loads;
            }
        )
    );
    const scalarSquareMatrix& R = found.R;
    const fileName file
    (
        runTime.globalPath()/"postProcessing"/"resistance.csv"
    );
    if (Pstream::master())
    {
        write(scene, file, R, inverse(R), found.flow);
    }
    Info<< nl << "Cells: " << scene.nCells() << nl
        << "Asymmetry: " << asymmetry(R) << nl
        << "Fingerprint: "
        << fsbi::caseFingerprint(runTime, scene.bodies().rigid).c_str() << nl
        << "Written: " << file << nl << layout.c_str() << nl << endl;
    scene.clocks().report(Info);
    Info<< "End" << nl << endl;
    return 0;
}
