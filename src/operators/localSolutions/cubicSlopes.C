/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cubicSlopes.H"

namespace Foam
{
namespace fsbi
{

//- The derivative of which monomial gives this one, and how many times
struct antiderivative
{
    label monomial;
    scalar factor;
};

static FixedList<FixedList<antiderivative, 3>, nQuadratic> antiderivatives()
{
    FixedList<FixedList<antiderivative, 3>, nQuadratic> result;
    for (label m = 0; m < nQuadratic; ++m)
    {
        for (label i = 0; i < 3; ++i)
        {
            label k = 0;
            const auto is = [&](const label j)
            {
                return
                    cubicExponents[k][j] == cubicExponents[m][j] + (i == j);
            };
            while (!is(0) || !is(1) || !is(2))
            {
                ++k;
            }
            result[m][i] = {k, scalar(cubicExponents[k][i])};
        }
    }
    return result;
}


fsbiWide static void setSlopes
(
    const label nVertices, const scalar* c, const scalar* perLength,
    const antiderivative* of, scalar* slopes
)
{
    for (label v = 0; v < nVertices; ++v)
    {
        for (label j = 0; j < 3*nQuadratic; ++j)
        {
            four(slopes + nSlopes*v + 4*j) =
                perLength[v]*of[j].factor
               *four(c + 4*nCubic*v + 4*of[j].monomial);
        }
    }
}


//- Add weight times the gradient of a vertex's polynomial at d, lengths in h
fsbiInlined static void addGradient
(
    const scalar weight, const vector& d, const scalar* slopes,
    fourNumbers& x, fourNumbers& y, fourNumbers& z
)
{
    const scalar a[nQuadratic] =
    {
        weight, weight*d.x(), weight*d.y(), weight*d.z(),
        weight*d.x()*d.x(), weight*d.x()*d.y(), weight*d.x()*d.z(),
        weight*d.y()*d.y(), weight*d.y()*d.z(), weight*d.z()*d.z()
    };
    for (label m = 0; m < nQuadratic; ++m)
    {
        x += a[m]*four(slopes + 12*m);
        y += a[m]*four(slopes + 12*m + 4);
        z += a[m]*four(slopes + 12*m + 8);
    }
}


fsbiWide void setGradients
(
    const label nFaces, const label* faceStart, const label* faceVertex,
    const label* pointStart, const point* points,
    const point* vertices, const scalar* perLength, const scalar* slopes,
    tensor* gradient
)
{
    for (label i = 0; i < nFaces; ++i)
    {
        const scalar weight = 1.0/(faceStart[i + 1] - faceStart[i]);
        for (label k = pointStart[i]; k < pointStart[i + 1]; ++k)
        {
            fourNumbers x = {0, 0, 0, 0}, y = x, z = x;
            for (label j = faceStart[i]; j < faceStart[i + 1]; ++j)
            {
                const label v = faceVertex[j];
                const scalar s = perLength[v];
                const vector d
                (
                    s*(points[k].x() - vertices[v].x()),
                    s*(points[k].y() - vertices[v].y()),
                    s*(points[k].z() - vertices[v].z())
                );
                addGradient(weight, d, slopes + nSlopes*v, x, y, z);
            }
            gradient[k] = tensor
            (
                x[0], y[0], z[0], x[1], y[1], z[1], x[2], y[2], z[2]
            );
        }
    }
}


void setSlopes
(
    const label nVertices, const scalar* c, const scalar* perLength,
    scalar* slopes
)
{
    static const auto of = antiderivatives();
    setSlopes(nVertices, c, perLength, of[0].cdata(), slopes);
}

} // End namespace fsbi
} // End namespace Foam
