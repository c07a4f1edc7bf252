/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceTransfer.H"
#include "untrapped.H"
#include "triPointRef.H"
#include "ListOps.H"

#include <Eigen/Dense>
#include <numeric>

namespace Foam
{
namespace fsbi
{

//- Points that a surface with six coefficients is fitted to
static const label curvedPoints = 14;

//- Least cosine between faces of one side: no fit goes around an edge
static const scalar sameSide = 0.7;

//- Faces in which a point may lie
static const label facesAround = 8;

//- Distance over the face's size that counts as none
static const scalar coincident = 1e-6;

} // End namespace fsbi
} // End namespace Foam


Foam::labelList Foam::fsbi::surfaceTransfer::nearest
(
    const pointField& points, const point& x, const label n
)
{
    labelList order(identity(points.size()));
    const label m = min(n, points.size());
    std::partial_sort
    (
        order.begin(), order.begin() + m, order.end(),
        [&](const label a, const label b)
        {
            return magSqr(points[a] - x) < magSqr(points[b] - x);
        }
    );
    order.setSize(m);
    return order;
}


Foam::scalarList Foam::fsbi::surfaceTransfer::fit
(
    const pointField& points,
    const labelList& near,
    const point& x,
    const bool curved
)
{
    const untrapped scope;          // Eigen computes with what it discards
    const label n = near.size();
    Eigen::MatrixXd at(n, 3);
    for (label j = 0; j < n; ++j)
    {
        const vector d(points[near[j]] - x);
        at.row(j) << d.x(), d.y(), d.z();
    }
    const scalar size = at.rowwise().norm().maxCoeff();
    at /= size;
    const Eigen::Vector3d mean(at.colwise().mean());
    const Eigen::MatrixXd about(at.rowwise() - mean.transpose());

    // along the surface: normal is the direction of least extent
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes
    (
        about.transpose()*about
    );
    const Eigen::MatrixXd s(at*axes.eigenvectors().rightCols(2));
    Eigen::MatrixXd A(n, curved ? 6 : 3);
    A.col(0).setOnes();
    A.middleCols(1, 2) = s;
    if (curved)
    {
        A.col(3) = s.col(0).array().square();
        A.col(4) = s.col(0).array()*s.col(1).array();
        A.col(5) = s.col(1).array().square();
    }
    const Eigen::VectorXd w
    (
        (-0.5*at.rowwise().squaredNorm().array()/0.25).exp()
    );
    // the least solution where points lie on a line
    const Eigen::MatrixXd inverse
    (
        (w.asDiagonal()*A).completeOrthogonalDecomposition().pseudoInverse()
    );
    scalarList weights(n);
    for (label j = 0; j < n; ++j)
    {
        weights[j] = inverse(0, j)*w[j];
    }
    return weights;
}


Foam::fsbi::surfaceTransfer::surfaceTransfer
(
    const fvMesh& mesh, const pointField& data
)
:
    mesh_(mesh),
    data_(data),
    faces_(mesh.nFaces() - mesh.nInternalFaces()),
    pointFaces_(data.size()),
    pointVertices_(data.size()),
    same_(sameFaces())
{
    if (same_)
    {
        forAll(faces_, i)
        {
            faces_[i].append({i, 1.0});
            pointFaces_[i].append({i, 1.0});
        }
        return;
    }
    setPoints();
    setFaces();
}


bool Foam::fsbi::surfaceTransfer::sameFaces() const
{
    if (faces_.size() != data_.size())
    {
        return false;
    }
    forAll(data_, i)
    {
        const label facei = mesh_.nInternalFaces() + i;
        if
        (
            magSqr(data_[i] - mesh_.faceCentres()[facei])
          > sqr(coincident)*mag(mesh_.faceAreas()[facei])
        )
        {
            return false;
        }
    }
    return true;
}


Foam::labelList Foam::fsbi::surfaceTransfer::onSameSide
(
    const label face
) const
{
    const auto normal = [&](const label b)
    {
        const vector& S = mesh_.faceAreas()[mesh_.nInternalFaces() + b];
        return vector(S/mag(S));
    };
    DynamicList<label> points;
    forAll(data_, i)
    {
        if ((normal(pointFaces_[i][0].first()) & normal(face)) > sameSide)
        {
            points.append(i);
        }
    }
    return labelList(std::move(points));
}


void Foam::fsbi::surfaceTransfer::setFaces()
{
    forAll(faces_, i)
    {
        const label facei = mesh_.nInternalFaces() + i;
        const point& x = mesh_.faceCentres()[facei];
        const labelList side(onSameSide(i));
        const pointField points(data_, side);
        if (points.empty())
        {
            FatalErrorInFunction
                << "There are no data near " << x << " on the surface"
                << exit(FatalError);
        }
        const scalar within = 0.36*mag(mesh_.faceAreas()[facei]);
        label inside = 0;
        for (const point& p : points)
        {
            inside += magSqr(p - x) < within;
        }
        const labelList near(nearest(points, x, max(label(planePoints), inside)));
        const scalarList weights(fit(points, near, x, false));
        forAll(near, j)
        {
            faces_[i].append({side[near[j]], weights[j]});
        }
    }
}


void Foam::fsbi::surfaceTransfer::setPoints()
{
    const pointField centres
    (
        SubField<point>
        (
            mesh_.faceCentres(), faces_.size(), mesh_.nInternalFaces()
        )
    );
    forAll(data_, i)
    {
        setPoint(i, nearest(centres, data_[i], facesAround));
    }
}


void Foam::fsbi::surfaceTransfer::setPoint
(
    const label i, const labelList& candidates
)
{
    const pointField& points = mesh_.points();
    scalar best = GREAT;
    for (const label b : candidates)
    {
        const face& f = mesh_.faces()[mesh_.nInternalFaces() + b];
        const point& c = mesh_.faceCentres()[mesh_.nInternalFaces() + b];
        forAll(f, j)
        {
            const label v = f[j], w = f.nextLabel(j);
            const triPointRef triangle(c, points[v], points[w]);
            const pointHit hit(triangle.nearestPoint(data_[i]));
            if (hit.distance() < best)
            {
                best = hit.distance();
                const barycentric2D part
                (
                    triangle.pointToBarycentric(hit.rawPoint())
                );
                pointFaces_[i].clear();
                pointVertices_[i].clear();
                pointFaces_[i].append({b, part.a()});
                pointVertices_[i].append({v, part.b()});
                pointVertices_[i].append({w, part.c()});
            }
        }
    }
}


Foam::vectorField Foam::fsbi::surfaceTransfer::toFaces
(
    const vectorField& data
) const
{
    vectorField result(faces_.size(), Zero);
    forAll(faces_, i)
    {
        for (const auto& entry : faces_[i])
        {
            result[i] += entry.second()*data[entry.first()];
        }
    }
    return result;
}


Foam::vectorField Foam::fsbi::surfaceTransfer::fromFaces
(
    const vectorField& faces
) const
{
    vectorField result(data_.size(), Zero);
    forAll(faces_, i)
    {
        for (const auto& entry : faces_[i])
        {
            result[entry.first()] += entry.second()*faces[i];
        }
    }
    return result;
}


Foam::vectorField Foam::fsbi::surfaceTransfer::toPoints
(
    const vectorField& faces, const vectorField& vertices
) const
{
    vectorField result(data_.size(), Zero);
    forAll(result, i)
    {
        for (const auto& entry : pointFaces_[i])
        {
            result[i] += entry.second()*faces[entry.first()];
        }
        for (const auto& entry : pointVertices_[i])
        {
            result[i] += entry.second()*vertices[entry.first()];
        }
    }
    return result;
}


Foam::vectorField Foam::fsbi::surfaceTransfer::fromPoints
(
    const vectorField& data
) const
{
    vectorField result(faces_.size(), Zero);
    forAll(data, i)
    {
        // of the triangle, all at its face: its vertices are half an edge away
        scalar sum = 0;
        for (const auto& entry : pointVertices_[i])
        {
            sum += entry.second();
        }
        for (const auto& entry : pointFaces_[i])
        {
            result[entry.first()] += (entry.second() + sum)*data[i];
        }
    }
    return result;
}


Foam::pointField Foam::fsbi::surfaceTransfer::moved
(
    const vectorField& displacement
) const
{
    pointField points(mesh_.points());
    boolList done(points.size(), false);
    forAll(faces_, i)
    {
        for (const label v : mesh_.faces()[mesh_.nInternalFaces() + i])
        {
            if (!done[v])
            {
                const labelList near(nearest(data_, points[v], curvedPoints));
                const scalarList weights(fit(data_, near, points[v], true));
                forAll(near, j)
                {
                    points[v] += weights[j]*displacement[near[j]];
                }
                done[v] = true;
            }
        }
    }
    return points;
}
