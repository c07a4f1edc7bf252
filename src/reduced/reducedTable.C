/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "reducedTable.H"
#include "hdfHandle.H"
#include "OSspecific.H"
#include "OStringStream.H"
#include "tensor.H"

namespace Foam
{
namespace fsbi
{

//- Entries of R beside its diagonal, in the axes n, t, s
static const label offDiagonal[6][2] =
    {{0, 1}, {0, 5}, {1, 5}, {2, 3}, {2, 4}, {3, 4}};

//- Loads that a flow along t makes, and one along s
static const label ofAlong[3] = {0, 1, 5};
static const label ofAcross[3] = {2, 3, 4};

//- A vector of length zero: the body's axis stands on the wall
static const scalar upright = 1e-9;


//- A 6 x 6 matrix of vectors' components in the columns of Q, in laboratory axes
static scalarSquareMatrix turned(const scalarSquareMatrix& A, const tensor& Q)
{
    scalarSquareMatrix result(6, 6, Zero);
    for (label I = 0; I < 6; I += 3)
    {
        for (label J = 0; J < 6; J += 3)
        {
            tensor block;
            for (direction i = 0; i < 9; ++i)
            {
                block[i] = A(I + i/3, J + i % 3);
            }
            block = Q & block & Q.T();
            for (direction i = 0; i < 9; ++i)
            {
                result(I + i/3, J + i % 3) = block[i];
            }
        }
    }
    return result;
}


//- A table of doubles, by columns; false: it is not there, or has others
static bool columns
(
    const hid_t file, const char* name, const label n, List<scalarList>& result
)
{
    const hdf::quiet silent;
    const hdfHandle dataset(H5Dopen2(file, name, H5P_DEFAULT));
    hsize_t size[2];
    if
    (
        !dataset.valid() || !hdf::shape(dataset, size)
     || size[0] < 1 || label(size[1]) != n
    )
    {
        return false;
    }
    result.setSize(n);
    forAll(result, j)
    {
        std::vector<double> values;
        if (!hdf::readColumn(dataset, j, values))
        {
            return false;
        }
        result[j] = scalarList(label(values.size()));
        std::copy(values.begin(), values.end(), result[j].begin());
    }
    return true;
}


static vector vectorOf(const List<scalarList>& row, const label first)
{
    return vector(row[first][0], row[first + 1][0], row[first + 2][0]);
}


//- The one text of an attribute; empty: there is none
static string textOf(const hid_t file, const char* name)
{
    const hdf::quiet silent;
    std::vector<std::string> found;
    return
        hdf::text(file, name, found) && found.size()
      ? string(found[0]) : string();
}

} // End namespace fsbi
} // End namespace Foam


void Foam::fsbi::reducedTable::refuse(const string& why) const
{
    FatalErrorInFunction
        << "The table " << file_ << " of method 'reduced' (system/fluid/"
        << "fvSolution) " << why.c_str() << exit(FatalError);
}


Foam::fsbi::reducedTable::reducedTable
(
    const fileName& file,
    const word& body,
    const string& fingerprint,
    const string& flow
)
:
    file_(file)
{
    if (!isFile(file))
    {
        refuse("is not there: make it by fsbiReduce");
    }
    const hdf::quiet silent;
    const hdfHandle opened
    (
        H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT)
    );
    if (!opened.valid() || !read(opened))
    {
        refuse("is none of fsbiReduce, or damaged: make it anew");
    }
    const string of(textOf(opened, "body"));
    if (of != body)
    {
        refuse("is of body '" + of + "', not of '" + body + "'");
    }
    const string along(textOf(opened, "flow"));
    if
    (
        textOf(opened, "fingerprint") != fingerprint
     || (!along.empty() && !flow.empty() && along != flow)
    )
    {
        refuse
        (
            "is of another case: since it was made the body's shape,"
            " constant/fluid/material, 0.orig/fluid/U, system/blockMeshDict or"
            " remeshDict has changed. Make it anew by fsbiReduce"
        );
    }
}


bool Foam::fsbi::reducedTable::read(const int64_t file)
{
    List<scalarList> wall, body, range, error, gaps, angles;
    const bool there =
        columns(file, "wall", 9, wall) && columns(file, "body", 5, body)
     && columns(file, "range", 2, range) && columns(file, "error", 1, error)
     && columns(file, "gapKnots", 1, gaps)
     && columns(file, "angleKnots", 1, angles)
     && columns(file, "coefficients", nFunctions, coefficients_);
    if (!there)
    {
        return false;
    }
    origin_ = vectorOf(wall, 0);
    normal_ = vectorOf(wall, 3);
    along_ = vectorOf(wall, 6);
    axis_ = vectorOf(body, 0);
    longAxis_ = body[3][0];
    crossAxis_ = body[4][0];
    lowest_ = range[0][0];
    highest_ = range[1][0];
    error_ = error[0][0];

    // a sphere has one coefficient of angles, others cubic splines
    const label n = coefficients_[0].size();
    const label ofAngles = angles[0].size() == 2 ? 1 : angles[0].size() - 4;
    const label ofGaps = gaps[0].size() - 4;
    if (ofAngles < 1 || ofGaps < 4 || ofGaps*ofAngles != n)
    {
        return false;
    }
    gaps_ = bSpline(gaps[0], ofGaps);
    angles_ = bSpline(angles[0], ofAngles);
    return true;
}


Foam::fsbi::reducedTable::configuration Foam::fsbi::reducedTable::of
(
    const placement& p
) const
{
    configuration c;
    c.n = normal_;
    vector e(p.orientation.transform(axis_));
    e *= (e & normal_) < 0 ? -1 : 1;
    const vector lean(e - (e & normal_)*normal_);
    const bool leans = angles_.size() > 1 && mag(lean) > upright;
    c.t = leans ? lean/mag(lean) : along_;
    c.s = c.n ^ c.t;
    c.angle = leans ? std::atan2(mag(lean), e & normal_) : 0;
    c.gap =
        ((p.centre - origin_) & normal_)
      - std::hypot
        (
            longAxis_*std::cos(c.angle), crossAxis_*std::sin(c.angle)
        );
    return c;
}


Foam::scalarList Foam::fsbi::reducedTable::functions
(
    const scalar gap, const scalar angle
) const
{
    const bSpline::values g(gaps_.at(std::log(gap)));
    const bSpline::values a(angles_.at(angle));
    scalarList f(nFunctions, Zero);
    forAll(g.of, i)
    {
        forAll(a.of, j)
        {
            const label row = (g.first + i)*angles_.size() + a.first + j;
            forAll(f, k)
            {
                f[k] += g.of[i]*a.of[j]*coefficients_[k][row];
            }
        }
    }
    return f;
}


Foam::fsbi::outcome Foam::fsbi::reducedTable::at
(
    const placement& p, heldBody& r
) const
{
    const configuration c(of(p));
    if (!(c.gap >= lowest_ && c.gap <= highest_))
    {
        OStringStream reason;
        reason
            << "the body is " << c.gap << " from the wall, outside of the range of "
            << file_.name() << ", " << lowest_ << " to " << highest_
            << ": make that wider (gaps of system/reduceDict, fsbiReduce)";
        return outcome::failed(reason.str());
    }
    const scalarList f(functions(c.gap, c.angle));
    scalarSquareMatrix R(6, 6, Zero);
    for (label i = 0; i < 6; ++i)
    {
        R(i, i) = std::exp(f[i]);
    }
    for (label k = 0; k < 6; ++k)
    {
        const label i = offDiagonal[k][0], j = offDiagonal[k][1];
        R(i, j) = R(j, i) = f[6 + k]*std::sqrt(R(i, i)*R(j, j));
    }
    sixVector load(scalar(0));
    for (label k = 0; k < 3; ++k)
    {
        load[ofAlong[k]] = (along_ & c.t)*f[12 + k];
        load[ofAcross[k]] = (along_ & c.s)*f[15 + k];
    }
    const tensor Q(tensor(c.n, c.t, c.s).T());
    r.gap = c.gap;
    r.R = turned(R, Q);
    r.flow = join(Q & linear(load), Q & angular(load));
    return outcome();
}
