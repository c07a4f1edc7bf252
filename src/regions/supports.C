/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "supports.H"
#include "PstreamReduceOps.H"
#include "StringStream.H"

Foam::fsbi::supports::supports(const boundBox& body)
:
    centre_(body.centre()),
    size_(0.5*body.mag()),
    sum_(row(scalar(0)))
{}


void Foam::fsbi::supports::hold(const point& x, const vector& direction)
{
    const vector turning(((x - centre_)/size_) ^ direction);
    row a;
    for (int k = 0; k < 3; ++k)
    {
        a[k] = direction[k];
        a[k + 3] = turning[k];
    }
    for (label i = 0; i < 6; ++i)
    {
        for (label j = 0; j < 6; ++j)
        {
            sum_[i][j] += a[i]*a[j];
        }
    }
}


Foam::DynamicList<Foam::string> Foam::fsbi::supports::freeMotions() const
{
    FixedList<row, 6> m(sum_);
    scalar largest = VSMALL;
    for (label i = 0; i < 6; ++i)
    {
        for (label j = 0; j < 6; ++j)
        {
            reduce(m[i][j], sumOp<scalar>());
        }
        largest = max(largest, m[i][i]);
    }

    // Gauss-Jordan; the matrix is semidefinite, so that a vanishing pivot
    // means a vanishing row
    FixedList<bool, 6> isFree(false);
    for (label k = 0; k < 6; ++k)
    {
        isFree[k] = m[k][k] < 1e-8*largest;
        for (label i = 0; i < 6 && !isFree[k]; ++i)
        {
            const scalar factor = i == k ? 0 : m[i][k]/m[k][k];
            for (label j = 0; j < 6; ++j)
            {
                m[i][j] -= factor*m[k][j];
            }
        }
    }
    DynamicList<string> motions;
    for (label k = 0; k < 6; ++k)
    {
        if (isFree[k])
        {
            row motion(scalar(0));
            motion[k] = 1;
            for (label i = 0; i < 6; ++i)
            {
                if (!isFree[i])
                {
                    motion[i] = -m[i][k]/m[i][i];
                }
            }
            motions.append(inWords(motion));
        }
    }
    return motions;
}


Foam::string Foam::fsbi::supports::inWords(const row& motion) const
{
    const vector shift(motion[0], motion[1], motion[2]);
    const vector turn(motion[3], motion[4], motion[5]);
    const auto rounded = [](vector v)
    {
        v /= mag(v);
        for (int k = 0; k < 3; ++k)
        {
            v[k] = 1e-3*std::round(1e3*v[k]) + 0;
        }
        return v;
    };
    OStringStream os;
    if (mag(turn) > 0.5*mag(shift))
    {
        os << "rotation about " << rounded(turn);
    }
    else
    {
        os << "translation along " << rounded(shift);
    }
    return os.str();
}
