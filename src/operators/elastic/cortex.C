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
    nHalo_(nHalo)
{
    const checkedDictionary entries(dict);
    tension_ = entries.getOrDefault<scalar>("tension", 0);
    if (entries.found("type"))
    {
        law_ = membraneLaw::New(entries);
    }
    entries.finish();
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
            addElement(triFace(f[0], f[k], f[k + 1]));
        }
    }
}


void Foam::fsbi::cortex::addElement(const triFace& corners)
{
    const pointField& x = mesh_.points();
    element t;
    t.corners = corners;
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


void Foam::fsbi::cortex::pull
(
    const element& t, const vector& by1, const vector& by2, vectorField& force
)
{
    force[t.corners[0]] += by1 + by2;
    force[t.corners[1]] -= by1;
    force[t.corners[2]] -= by2;
}


void Foam::fsbi::cortex::sumShared(vectorField& force) const
{
    sharedVertices::sum<3>(mesh_, force.begin()->v_, nHalo_);
}


Foam::vectorField Foam::fsbi::cortex::forces(const vectorField& displacement)
{
    vectorField force(mesh_.nPoints(), Zero);
    const auto at = [&](const label v)
    {
        return mesh_.points()[v] + displacement[v];
    };
    valid_ = true;
    for (element& t : elements_)
    {
        t.e1 = at(t.corners[1]) - at(t.corners[0]);
        t.e2 = at(t.corners[2]) - at(t.corners[0]);
        const scalar m11 = magSqr(t.e1), m22 = magSqr(t.e2);
        const scalar m12 = t.e1 & t.e2;
        const scalar T = t.G11*m11 + 2*t.G12*m12 + t.G22*m22;
        const scalar d = t.overDet*(m11*m22 - sqr(m12));
        if (!(d > SMALL))
        {
            valid_ = false;
            t.W = membraneLaw::energy();
            continue;
        }
        t.W = membraneLaw::constantTension(tension_, d);
        if (law_)
        {
            t.W += law_->at(T, d);
        }
        const scalar S11 = t.W.T*t.G11 + t.W.d*t.overDet*m22;
        const scalar S22 = t.W.T*t.G22 + t.W.d*t.overDet*m11;
        const scalar S12 = t.W.T*t.G12 - t.W.d*t.overDet*m12;
        pull
        (
            t,
            2*t.area*(S11*t.e1 + S12*t.e2),
            2*t.area*(S22*t.e2 + S12*t.e1),
            force
        );
    }
    sumShared(force);
    return force;
}


Foam::vectorField Foam::fsbi::cortex::tangent(const vectorField& dx) const
{
    vectorField force(mesh_.nPoints(), Zero);
    for (const element& t : elements_)
    {
        const vector de1(dx[t.corners[1]] - dx[t.corners[0]]);
        const vector de2(dx[t.corners[2]] - dx[t.corners[0]]);
        const scalar m11 = magSqr(t.e1), m22 = magSqr(t.e2);
        const scalar m12 = t.e1 & t.e2;
        const scalar dm11 = 2*(t.e1 & de1), dm22 = 2*(t.e2 & de2);
        const scalar dm12 = (t.e1 & de2) + (t.e2 & de1);
        const scalar dT = t.G11*dm11 + 2*t.G12*dm12 + t.G22*dm22;
        const scalar dd = t.overDet*(dm11*m22 + m11*dm22 - 2*m12*dm12);
        const scalar byT = t.W.TT*dT + t.W.Td*dd;
        const scalar byd = t.W.Td*dT + t.W.dd*dd;
        const scalar q = t.overDet*t.W.d, dq = t.overDet*byd;
        const scalar S11 = t.W.T*t.G11 + q*m22;
        const scalar S22 = t.W.T*t.G22 + q*m11;
        const scalar S12 = t.W.T*t.G12 - q*m12;
        const scalar dS11 = byT*t.G11 + dq*m22 + q*dm22;
        const scalar dS22 = byT*t.G22 + dq*m11 + q*dm11;
        const scalar dS12 = byT*t.G12 - dq*m12 - q*dm12;
        pull
        (
            t,
            2*t.area*(dS11*t.e1 + S11*de1 + dS12*t.e2 + S12*de2),
            2*t.area*(dS22*t.e2 + S22*de2 + dS12*t.e1 + S12*de1),
            force
        );
    }
    sumShared(force);
    return force;
}


bool Foam::fsbi::cortex::valid() const
{
    return returnReduce(valid_, andOp<bool>());
}


Foam::scalar Foam::fsbi::cortex::energy() const
{
    scalar sum = 0;
    for (const element& t : elements_)
    {
        sum += t.area*t.W.W;
    }
    return returnReduce(sum, sumOp<scalar>());
}
