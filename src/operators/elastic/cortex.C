/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cortex.H"
#include "sharedVertices.H"

Foam::fsbi::cortex::cortex
(
    const fvMesh& mesh,
    const label nHalo,
    const List<solidBoundary::kind>& kinds,
    const dictionary& dict
)
:
    mesh_(mesh),
    nHalo_(nHalo),
    nFaces_(kinds.size())
{
    const checkedDictionary entries(dict);
    tension_ = entries.getOrDefault<scalar>("tension", 0);
    if (entries.found("type"))
    {
        law_ = membraneLaw::New(entries);
    }
    if (tension_ < 0 || (tension_ == 0 && !law_))
    {
        FatalIOErrorInFunction(dict)
            << "A cortex needs a 'tension', which is positive, or a 'type' of"
            << " elastic law, or both; 'tension' is " << tension_
            << exit(FatalIOError);
    }
    forAll(kinds, i)
    {
        const face& f = mesh.faces()[mesh.nInternalFaces() + i];
        for
        (
            label k = 1;
            kinds[i] == solidBoundary::traction && k < f.size() - 1;
            ++k
        )
        {
            addElement(triFace(f[0], f[k], f[k + 1]), i);
        }
        closed_ &=
            kinds[i] == solidBoundary::traction
         || kinds[i] == solidBoundary::coupled;
    }
    reduce(closed_, andOp<bool>());
    for (const element& t : elements_)
    {
        restVolume3_ += volume3(t, mesh.points());
    }
    reduce(restVolume3_, sumOp<scalar>());
    if (entries.choice("loads", {"corners", "faces"}, "corners") == "faces")
    {
        measureCorners(dict);
    }
    if (entries.found("bendingModulus"))
    {
        List<triFace> triangles(elements_.size());
        forAll(triangles, k)
        {
            triangles[k] = elements_[k].corners;
        }
        bending_.reset
        (
            new membraneBending(mesh, nHalo, triangles, entries)
        );
    }
    entries.finish();
}


void Foam::fsbi::cortex::measureCorners(const dictionary& dict)
{
    if (!closed_)
    {
        FatalIOErrorInFunction(dict)
            << "'loads faces' is for a cortex that goes all round its body,"
            << " but this one ends at held faces or a plane of symmetry;"
            << " leave it out" << exit(FatalIOError);
    }
    overArea_.setSize(mesh_.nPoints(), 0);
    for (const element& t : elements_)
    {
        for (const label v : t.corners)
        {
            overArea_[v] += t.area/3;
        }
    }
    sharedVertices::sum<1>(mesh_, overArea_.begin(), nHalo_);
    for (scalar& a : overArea_)
    {
        a = a > 0 ? 1/a : 0;
    }
}


void Foam::fsbi::cortex::addElement(const triFace& corners, const label face)
{
    const pointField& x = mesh_.points();
    element t;
    t.corners = corners;
    t.face = face;
    t.e1 = x[corners[1]] - x[corners[0]];
    t.e2 = x[corners[2]] - x[corners[0]];
    const scalar det = magSqr(t.e1 ^ t.e2);
    t.overDet = 1/det;
    t.G11 = magSqr(t.e2)/det;
    t.G22 = magSqr(t.e1)/det;
    t.G12 = -(t.e1 & t.e2)/det;
    t.area = 0.5*Foam::sqrt(det);
    elements_.append(t);
}


Foam::fsbi::cortex::byEdges Foam::fsbi::cortex::slopeOf(const element& t)
{
    // of the energy by m_11, m_22, and half of that by m_12
    const scalar q = t.overDet*t.W.d;
    const scalar S11 = t.W.T*t.G11 + q*magSqr(t.e2);
    const scalar S22 = t.W.T*t.G22 + q*magSqr(t.e1);
    const scalar S12 = t.W.T*t.G12 - q*(t.e1 & t.e2);
    return
    {
        2*t.area*(S11*t.e1 + S12*t.e2), 2*t.area*(S22*t.e2 + S12*t.e1)
    };
}


Foam::fsbi::cortex::byEdges Foam::fsbi::cortex::slopeTangent
(
    const element& t, const vector& de1, const vector& de2
)
{
    const scalar m11 = magSqr(t.e1), m22 = magSqr(t.e2), m12 = t.e1 & t.e2;
    const scalar dm11 = 2*(t.e1 & de1), dm22 = 2*(t.e2 & de2);
    const scalar dm12 = (t.e1 & de2) + (t.e2 & de1);
    const scalar dT = t.G11*dm11 + 2*t.G12*dm12 + t.G22*dm22;
    const scalar dd = t.overDet*(dm11*m22 + m11*dm22 - 2*m12*dm12);
    const scalar byT = t.W.TT*dT + t.W.Td*dd;
    const scalar q = t.overDet*t.W.d;
    const scalar dq = t.overDet*(t.W.Td*dT + t.W.dd*dd);
    const scalar S11 = t.W.T*t.G11 + q*m22;
    const scalar S22 = t.W.T*t.G22 + q*m11;
    const scalar S12 = t.W.T*t.G12 - q*m12;
    const scalar dS11 = byT*t.G11 + dq*m22 + q*dm22;
    const scalar dS22 = byT*t.G22 + dq*m11 + q*dm11;
    const scalar dS12 = byT*t.G12 - dq*m12 - q*dm12;
    return
    {
        2*t.area*(dS11*t.e1 + S11*de1 + dS12*t.e2 + S12*de2),
        2*t.area*(dS22*t.e2 + S22*de2 + dS12*t.e1 + S12*de1)
    };
}


void Foam::fsbi::cortex::pull
(
    const element& t, const byEdges& slope, vectorField& vertices
)
{
    vertices[t.corners[0]] += slope.e1 + slope.e2;
    vertices[t.corners[1]] -= slope.e1;
    vertices[t.corners[2]] -= slope.e2;
}


void Foam::fsbi::cortex::shift
(
    const element& t, const vector& force, acting& to
)
{
    to.faces[t.face] -= force;
    for (const label v : t.corners)
    {
        to.vertices[v] += force/3;
    }
}


void Foam::fsbi::cortex::sumShared(vectorField& force) const
{
    sharedVertices::sum<3>(mesh_, force.begin()->v_, nHalo_);
}


void Foam::fsbi::cortex::smoothToFaces(acting& force) const
{
    vectorField moved(force.vertices.size(), Zero);
    for (const element& t : elements_)
    {
        vector f(Zero);
        for (const label v : t.corners)
        {
            f += t.area/3*overArea_[v]*force.vertices[v];
        }
        force.faces[t.face] += f;
        for (const label v : t.corners)
        {
            moved[v] -= f/3;
        }
    }
    sumShared(moved);
    force.vertices += moved;
}


Foam::fsbi::cortex::acting Foam::fsbi::cortex::forces(const vectorField& u)
{
    acting force{vectorField(u.size(), Zero), vectorField(nFaces_, Zero), 0};
    const pointField x(mesh_.points() + u);
    valid_ = true;
    vector2D sums(Zero);        // -f.x, 3 V
    for (element& t : elements_)
    {
        t.e1 = x[t.corners[1]] - x[t.corners[0]];
        t.e2 = x[t.corners[2]] - x[t.corners[0]];
        const scalar m11 = magSqr(t.e1), m22 = magSqr(t.e2);
        const scalar m12 = t.e1 & t.e2;
        const scalar d = t.overDet*(m11*m22 - sqr(m12));
        if (!(d > SMALL))
        {
            valid_ = false;
            t.W = membraneLaw::energy();
            t.slope = {Zero, Zero};
            continue;
        }
        t.W = membraneLaw::constantTension(tension_, d);
        if (law_)
        {
            t.W += law_->at(t.G11*m11 + 2*t.G12*m12 + t.G22*m22, d);
        }
        t.slope = slopeOf(t);
        pull(t, t.slope, force.vertices);
        sums.x() += (t.slope.e1 & t.e1) + (t.slope.e2 & t.e2);
        sums.y() += volume3(t, x);
    }
    if (bending_)
    {
        sums.x() += bending_->addForces(x, force.vertices);
        valid_ &= bending_->valid();
    }
    reduce(sums, sumOp<vector2D>());
    volume3_ = sums.y();
    if (closed_)
    {
        pressure_ = sums.x()/volume3_;
        force.growth = volume3_/restVolume3_ - 1;
    }
    for (const element& t : elements_)
    {
        shift(t, 0.5*pressure_*(t.e1 ^ t.e2), force);
    }
    sumShared(force.vertices);
    if (!overArea_.empty())
    {
        smoothToFaces(force);
    }
    return force;
}


Foam::fsbi::cortex::acting Foam::fsbi::cortex::tangent
(
    const vectorField& du
) const
{
    acting force{vectorField(du.size(), Zero), vectorField(nFaces_, Zero), 0};
    vector2D sums(Zero);
    const auto edge = [&](const element& t, const label i)
    {
        return du[t.corners[i]] - du[t.corners[0]];
    };
    for (const element& t : elements_)
    {
        const vector de1(edge(t, 1)), de2(edge(t, 2));
        const byEdges change(slopeTangent(t, de1, de2));
        pull(t, change, force.vertices);
        sums.x() +=
            (change.e1 & t.e1) + (change.e2 & t.e2)
          + (t.slope.e1 & de1) + (t.slope.e2 & de2);
        sums.y() +=
            0.5
           *(
                (3*du[t.corners[0]] + de1 + de2) & (t.e1 ^ t.e2)
            );
    }
    if (bending_)
    {
        sums.x() += bending_->addTangent(du, force.vertices);
    }
    if (closed_)
    {
        reduce(sums, sumOp<vector2D>());
        force.growth = sums.y()/restVolume3_;
        const scalar dp = (sums.x() - pressure_*sums.y())/volume3_;
        for (const element& t : elements_)
        {
            const vector dS((edge(t, 1) ^ t.e2) + (t.e1 ^ edge(t, 2)));
            shift(t, 0.5*(dp*(t.e1 ^ t.e2) + pressure_*dS), force);
        }
    }
    sumShared(force.vertices);
    if (!overArea_.empty())
    {
        smoothToFaces(force);
    }
    return force;
}


bool Foam::fsbi::cortex::valid() const
{
    return returnReduce(valid_, andOp<bool>());
}


Foam::fsbi::cortex::measures Foam::fsbi::cortex::measured() const
{
    measures m;
    m.leastStretch = GREAT;
    m.mostStretch = 0;
    for (const element& t : elements_)
    {
        const scalar now = 0.5*mag(t.e1 ^ t.e2);
        m.energy += t.area*t.W.W;
        m.area += now;
        m.leastStretch = min(m.leastStretch, now/t.area);
        m.mostStretch = max(m.mostStretch, now/t.area);
    }
    if (bending_)
    {
        m.energy += bending_->energy();
    }
    reduce(m.energy, sumOp<scalar>());
    reduce(m.area, sumOp<scalar>());
    reduce(m.leastStretch, minOp<scalar>());
    reduce(m.mostStretch, maxOp<scalar>());
    return m;
}
