/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "eigenvalueSearch.H"
#include "jacobiSymbol.H"

//- Accuracy that round-off allows
static const Foam::scalar eigenvalueRoundOff = 1e-14;

//- Parts looked at in one box at most (a second)
static const Foam::label mostEigenvalueParts = 200000;


Foam::fsbi::eigenvalueSearch::eigenvalueSearch
(
    const std::function<expansion(const vector&)>& matrix,
    const std::function<scalar(const vector&)>& remainder
)
:
    matrix_(matrix),
    remainder_(remainder)
{}


void Foam::fsbi::eigenvalueSearch::add
(
    const vector& centre, const vector& half
)
{
    const expansion K = matrix_(centre);
    best_ = max(best_, symmetricEigenvalues(K.value).z());
    scalar bound = -GREAT;
    for (label corner = 0; corner < 8; ++corner)
    {
        symmTensor linear = K.value;
        vector at = centre;
        for (direction i = 0; i < 3; ++i)
        {
            const scalar d = (corner >> i & 1) ? half[i] : -half[i];
            linear += d*K.slope[i];
            at[i] += d;
        }
        bound = max(bound, symmetricEigenvalues(linear).z());
        // maxima often stand at corners of the box, where no centre is
        best_ = max(best_, symmetricEigenvalues(matrix_(at).value).z());
    }
    bound += remainder_(half);
    if (bound > best_ + eigenvalueRoundOff)
    {
        parts_.push({centre, half, bound});
    }
}


void Foam::fsbi::eigenvalueSearch::search(const boundBox& box)
{
    add(box.centre(), box.span()/2);
    for (label i = 0; i < mostEigenvalueParts && !parts_.empty(); ++i)
    {
        const part widest = parts_.top();
        if (widest.bound <= best_ + eigenvalueRoundOff)
        {
            break;
        }
        parts_.pop();
        const direction k = findMax(widest.half);
        vector half = widest.half;
        half[k] /= 2;
        for (const scalar side : {-1, 1})
        {
            vector centre = widest.centre;
            centre[k] += side*half[k];
            add(centre, half);
        }
    }
    if (!parts_.empty())
    {
        uncertainty_ = max(uncertainty_, parts_.top().bound - best_);
    }
    parts_ = {};
}
