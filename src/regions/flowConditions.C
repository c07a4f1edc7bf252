/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "flowConditions.H"
#include "startField.H"
#include "tractionCondition.H"
#include "pointwiseValue.H"
#include "IStringStream.H"
#include "OStringStream.H"
#include "PrimitivePatchInterpolation.H"
#include "syncTools.H"

namespace Foam
{
namespace fsbi
{

//- Net flux over the gross one that is a rounding of profiles on faces, to be
//  spread out, rather than a mistake
static const scalar acceptedImbalance = 0.01;

//- Deviation of normals or velocities of a patch that is round-off
static const scalar roundOff = 1e-6;

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::flowConditions::flowConditions
(
    const Time& time,
    const fluidMesh& mesh
)
:
    time_(time),
    mesh_(mesh)
{}


void Foam::fsbi::flowConditions::read()
{
    dictionary dict(startField(time_, mesh_.name(), "U", dimVelocity));
    checkPatches(dict, mesh_.mesh());
    checkBodies(dict.subDict("boundaryField"));

    // values of an earlier mesh, where the condition knows better
    for (entry& e : dict.subDict("boundaryField"))
    {
        const entry* value =
            e.isDict() ? e.dict().findEntry("value") : nullptr;
        if
        (
            value && value->isStream()
         && value->stream().size()
         && value->stream()[0] == token(word("nonuniform"))
         && e.dict().getOrDefault<word>("type", "") != "fixedValue"
        )
        {
            e.dict().remove("value");
        }
    }
    conditions_ = dict;
}


void Foam::fsbi::flowConditions::checkBodies(const dictionary& patches) const
{
    for (const word& name : namesOf(mesh_.bodies()))
    {
        const entry* e = patches.findEntry(name, keyType::LITERAL);
        if (!e)
        {
            continue;
        }
        // as a state at time 0 has it
        const dictionary& given = e->isDict() ? e->dict() : dictionary::null;
        const entry* value = given.findEntry("value");
        const bool ours =
            given.getOrDefault<word>("type", "")
         == fixedValueFvPatchVectorField::typeName
         && value && value->isStream() && value->stream().size()
         && (
                value->stream()[0] == token(word("nonuniform"))
             || vectorField("value", given, 1)[0] == vector(Zero)
            );
        if (!ours)
        {
            FatalIOErrorInFunction(patches)
                << "Patch '" << name << "' is the surface of a body, whose"
                << " velocity is that of its motion (constant/bodies): remove"
                << " its entry" << exit(FatalIOError);
        }
    }
}


Foam::vector Foam::fsbi::flowConditions::startVelocity() const
{
    ITstream& is = conditions_.lookup("internalField");
    return word(is) == "uniform" ? vector(is) : vector::zero;
}


void Foam::fsbi::flowConditions::keep
(
    const volVectorField& U, const vector& startVelocity
)
{
    dictionary patches;
    for (const fvPatchVectorField& pf : U.boundaryField())
    {
        if (pf.coupled() || mesh_.isBody(pf.patch().name()))
        {
            continue;
        }
        OStringStream os;
        os.precision(17);
        pf.write(os);
        dictionary entry(IStringStream(os.str())());
        entry.remove("value");
        if (pf.type() == fixedValueFvPatchVectorField::typeName)
        {
            // a plain value lasts through remeshing where it is uniform, to
            // the last bit: an average would not
            const vector least(gMin(pf)), most(gMax(pf));
            OStringStream value;
            value.precision(17);
            value << "value uniform "
                << (least == most ? least : gAverage(pf)) << ";";
            entry.read(IStringStream(value.str())(), false);
        }
        patches.set(pf.patch().name(), entry);
    }
    OStringStream start;
    start.precision(17);
    start << "dimensions [0 1 -1 0 0 0 0]; internalField uniform "
        << startVelocity << ";";
    dictionary dict(IStringStream(start.str())());
    dict.set("boundaryField", patches);
    conditions_ = dict;
}


Foam::dictionary Foam::fsbi::flowConditions::fieldDictionary() const
{
    dictionary dict(conditions_);
    addMeshPatches(dict.subDict("boundaryField"));
    return dict;
}


void Foam::fsbi::flowConditions::addMeshPatches(dictionary& patches) const
{
    for (const polyPatch& pp : mesh_.mesh().boundaryMesh())
    {
        const bool body = mesh_.isBody(pp.name());
        if (body || pp.coupled())
        {
            setPatch
            (
                patches, pp.name(), body ? word("fixedValue") : pp.type()
            );
        }
    }
}


void Foam::fsbi::flowConditions::check(const volVectorField& U)
{
    for (const fvPatchVectorField& pf : U.boundaryField())
    {
        if (!pf.fixesValue() && !pf.coupled())
        {
            FatalErrorInFunction
                << "Patch '" << pf.patch().name() << "' of field U in region "
                << U.mesh().name() << " has the boundary condition '" << pf.type()
                << "'; give a velocity (fixedValue, uniformFixedValue,"
                << " linearShear, Poiseuille, StokesSphere), 'traction' or"
                << " 'cyclic'" << exit(FatalError);
        }
    }
}


Foam::boolList Foam::fsbi::flowConditions::velocityGiven
(
    const volVectorField& U
) const
{
    check(U);
    boolList given(mesh_.mesh().nFaces() - mesh_.mesh().nInternalFaces(), false);
    bool any = false;
    for (const fvPatchVectorField& pf : U.boundaryField())
    {
        const fvPatch& patch = pf.patch();
        const label start = patch.start() - mesh_.mesh().nInternalFaces();
        if (!patch.coupled() && !isA<tractionCondition>(pf))
        {
            any = true;
            SubList<bool>(given, patch.size(), start) = true;
        }
    }
    if (!any)
    {
        FatalErrorInFunction
            << "No patch of field U in region " << mesh_.name()
            << " gives a velocity: the flow is not determined" << exit(FatalError);
    }
    return given;
}


Foam::string Foam::fsbi::flowConditions::asWall
(
    const fvPatchVectorField& pf, planeWall& wall
) const
{
    const scalar area = gSum(pf.patch().magSf());
    const vector S(gSum(pf.patch().Sf()));
    const vector u(gSum(vectorField(pf.patch().magSf()*pf))/area);
    const scalar fastest = gMax(mag(pf)());
    const scalar uneven = gMax(mag(pf - u)());
    wall =
    {
        pf.patch().name(),
        gSum(vectorField(pf.patch().magSf()*pf.patch().Cf()))/area,
        -S/max(mag(S), VSMALL), u
    };
    if (mag(S) <= (1 - roundOff)*area)
    {
        return "not plane";
    }
    if (isA<tractionCondition>(pf))
    {
        return "its traction is given";
    }
    if (mag(u & S) > roundOff*fastest*area)
    {
        return "fluid passes through it";
    }
    return uneven > roundOff*fastest ? "its velocity in 0/fluid/U varies" : "";
}


template<class Visitor>
void Foam::fsbi::flowConditions::visitOutside
(
    const volVectorField& U, const Visitor& visitor
) const
{
    for (const fvPatchVectorField& pf : U.boundaryField())
    {
        if
        (
            !pf.coupled() && !mesh_.isBody(pf.patch().name())
         && gSum(pf.patch().magSf())
        )
        {
            planeWall wall;
            const string why(asWall(pf, wall));
            visitor(wall, why);
        }
    }
}


Foam::List<Foam::fsbi::planeWall> Foam::fsbi::flowConditions::walls
(
    const volVectorField& U
) const
{
    DynamicList<planeWall> found;
    visitOutside(U, [&](const planeWall& wall, const string& why)
    {
        if (why.empty())
        {
            found.append(wall);
        }
    });
    return List<planeWall>(found);
}


Foam::List<Foam::fsbi::unseenPatch> Foam::fsbi::flowConditions::unseen
(
    const volVectorField& U
) const
{
    DynamicList<unseenPatch> found;
    visitOutside(U, [&](const planeWall& wall, const string& why)
    {
        if (why.size())
        {
            found.append({wall.name, why});
        }
    });
    return List<unseenPatch>(found);
}


void Foam::fsbi::flowConditions::evaluate
(
    volVectorField& U,
    const stokesOperator& stokes,
    boundaryValues& given
) const
{
    given.faces.setSize(stokes.nBoundaryFaces());
    given.faces = Zero;
    // not updateCoeffs(): that does nothing the second time, at a later time
    U.boundaryFieldRef().evaluate();
    for (const fvPatchVectorField& pf : U.boundaryField())
    {
        if (pf.coupled())
        {
            continue;
        }
        const label start = pf.patch().start() - mesh_.mesh().nInternalFaces();
        SubField<vector> values(given.faces, pf.size(), start);
        if (isA<tractionCondition>(pf))
        {
            values = refCast<const tractionCondition>(pf).traction();
        }
        else if (!mesh_.isBody(pf.patch().name()))
        {
            values = pf;
        }
    }
    setVertices(U, stokes, given);
    balanceFluxes(stokes, given);
    setBodies(U, stokes, given);
}


const Foam::fsbi::prescribedBody* Foam::fsbi::flowConditions::prescribed
(
    const word& patch
) const
{
    const label b = namesOf(mesh_.bodies()).find(patch);
    return b < 0 ? nullptr : isA<prescribedBody>(mesh_.bodies()[b]);
}


void Foam::fsbi::flowConditions::setBodies
(
    volVectorField& U,
    const stokesOperator& stokes,
    boundaryValues& given
) const
{
    for (fvPatchVectorField& pf : U.boundaryFieldRef())
    {
        if (const auto* body = prescribed(pf.patch().name()))
        {
            vectorField u(pf.size());
            forAll(u, i)
            {
                u[i] = body->velocityAt(pf.patch().Cf()[i], pf.patch().Sf()[i]);
            }
            pf == u;
            const label start =
                pf.patch().start() - mesh_.mesh().nInternalFaces();
            SubField<vector>(given.faces, u.size(), start) = u;
        }
    }
}


void Foam::fsbi::flowConditions::setVertices
(
    const volVectorField& U,
    const stokesOperator& stokes,
    boundaryValues& given
) const
{
    // processors share vertices of the mesh; what is on edges they all have
    const labelList& wall = stokes.wallVertices();
    vectorField sum(mesh_.mesh().nPoints(), Zero);
    scalarField count(sum.size(), Zero);
    vectorField edgeSum(stokes.wallEdges().size(), Zero);
    scalarField edgeCount(edgeSum.size(), Zero);
    for (const fvPatchVectorField& pf : U.boundaryField())
    {
        if (pf.coupled() || isA<tractionCondition>(pf))
        {
            continue;
        }
        const labelList points
        (
            stokes.wallPointsOn(pf.patch().patch().meshPoints())
        );
        const vectorField u(wallVelocity(pf, stokes, points));
        forAll(u, k)
        {
            const label i = points[k], edgei = i - wall.size();
            (edgei < 0 ? sum[wall[i]] : edgeSum[edgei]) += u[k];
            (edgei < 0 ? count[wall[i]] : edgeCount[edgei]) += 1;
        }
    }
    syncTools::syncPointList(mesh_.mesh(), sum, plusEqOp<vector>(), vector::zero);
    syncTools::syncPointList(mesh_.mesh(), count, plusEqOp<scalar>(), scalar(0));

    given.vertices.setSize(stokes.wallPoints().size());
    forAll(wall, i)
    {
        given.vertices[i] = sum[wall[i]]/max(count[wall[i]], scalar(1));
    }
    forAll(edgeSum, i)
    {
        given.vertices[wall.size() + i] =
            edgeSum[i]/max(edgeCount[i], scalar(1));
    }
}


Foam::vectorField Foam::fsbi::flowConditions::wallVelocity
(
    const fvPatchVectorField& pf,
    const stokesOperator& stokes,
    const labelList& points
) const
{
    const polyPatch& pp = pf.patch().patch();
    const pointField x(stokes.wallPoints(), points);
    if (const auto* profile = isA<pointwiseValue>(pf))
    {
        return profile->valueAt(x, time_.value());
    }
    vectorField u(x.size(), Zero);
    if (const auto* body = prescribed(pp.name()))
    {
        forAll(u, i)
        {
            u[i] = body->velocityAt(x[i]);
        }
    }
    else if (!mesh_.isBody(pp.name()))
    {
        const vectorField corners
        (
            PrimitivePatchInterpolation<primitivePatch>(pp)
           .faceToPointInterpolate(static_cast<const vectorField&>(pf))
        );
        const auto at = [&](const label v)
        {
            return corners[pp.meshPointMap()[v]];
        };
        const labelList& wall = stokes.wallVertices();
        forAll(u, i)
        {
            const label edgei = points[i] - wall.size();
            u[i] =
                edgei < 0
              ? at(wall[points[i]])
              : 0.5
               *(
                    at(stokes.wallEdges()[edgei].start())
                  + at(stokes.wallEdges()[edgei].end())
                );
        }
    }
    return u;
}


void Foam::fsbi::flowConditions::balanceFluxes
(
    const stokesOperator& stokes,
    boundaryValues& given
) const
{
    const boolList& velocityGiven = stokes.velocityGiven();
    scalar net = 0, gross = 0;
    bool open = false;
    for (const polyPatch& pp : mesh_.mesh().boundaryMesh())
    {
        const label start = pp.start() - mesh_.mesh().nInternalFaces();
        for (label i = start; !pp.coupled() && i < start + pp.size(); ++i)
        {
            open |= !velocityGiven[i];
            const scalar flux =
                given.faces[i]
              & mesh_.mesh().faceAreas()[mesh_.mesh().nInternalFaces() + i];
            net += flux;
            gross += mag(flux);
        }
    }
    reduce(open, orOp<bool>());
    reduce(net, sumOp<scalar>());
    reduce(gross, sumOp<scalar>());
    if (open || gross < VSMALL)
    {
        return;
    }
    if (mag(net) > acceptedImbalance*gross)
    {
        FatalErrorInFunction
            << "The velocities given on the boundary of region "
            << mesh_.name() << " do not balance: net outflow " << net << " of " << gross
            << ". Correct field U, or give one patch the condition 'traction'"
            << exit(FatalError);
    }
    forAll(given.faces, i)
    {
        if (velocityGiven[i])
        {
            const vector& S =
                mesh_.mesh().faceAreas()[mesh_.mesh().nInternalFaces() + i];
            const scalar share = mag(given.faces[i] & S)/gross;
            given.faces[i] -= net*share*S/magSqr(S);
        }
    }
}
