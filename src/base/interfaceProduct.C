/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "interfaceProduct.H"
#include "PstreamReduceOps.H"
#include "Pstream.H"
#include "ops.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::interfaceProduct::interfaceProduct(const scalarField& weights)
:
    weights_(weights)
{
    for (const scalar w : weights_)
    {
        if (!(w >= 0))
        {
            FatalErrorInFunction
                << "An interface entry has the weight " << w
                << abort(FatalError);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsbi::interfaceProduct::norm(const scalarField& a) const
{
    scalar sum = 0;
    forAll(weights_, i)
    {
        sum += weights_[i]*a[i]*a[i];
    }
    return Foam::sqrt(returnReduce(sum, sumOp<scalar>()));
}


Foam::scalarList Foam::fsbi::interfaceProduct::products
(
    const UList<scalarField>& vectors, const scalarField& a
) const
{
    const scalarField weighted(weights_*a);
    scalarList sums(vectors.size(), Zero);
    forAll(vectors, j)
    {
        const scalarField& v = vectors[j];
        forAll(weighted, i)
        {
            sums[j] += weighted[i]*v[i];
        }
    }
    // gathered and sent back, so that all processors have the same bits
    Pstream::listCombineGather(sums, plusEqOp<scalar>());
    Pstream::listCombineScatter(sums);
    return sums;
}
