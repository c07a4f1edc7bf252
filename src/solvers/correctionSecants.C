/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "correctionSecants.H"
#include "interfaceLeastSquares.H"

namespace Foam
{
namespace fsbi
{

//- A correction over the one before it, up to which the derivative is good
static const scalar goodFactor = 0.1;

static const std::size_t mostColumns = 8;

//- Corrections before differences are made use of: large strains take a few until
//  the derivative is good
static const label plainCorrections = 3;

//- A correction over the one before it, above which differences mislead
static const scalar misled = 2;

//- Part of a column that must be new: corrections are solved to a thousandth
static const scalar filter = 1e-2;

} // End namespace fsbi
} // End namespace Foam


void Foam::fsbi::correctionSecants::start(const label begin, const label end)
{
    begin_ = begin;
    product_ = interfaceProduct(scalarField(end - begin, 1));
    columns_.clear();
    correction_.clear();
    iterate_.clear();
    norm_ = 0;
    corrections_ = 0;
}


bool Foam::fsbi::correctionSecants::better
(
    const scalarList& before, const scalarList& x, scalarList& iterate
)
{
    scalarField correction(product_.size());
    forAll(correction, i)
    {
        correction[i] = x[begin_ + i] - before[begin_ + i];
    }
    const scalar norm = product_.norm(correction);
    const bool good = norm_ == 0 || norm <= goodFactor*norm_;
    ++corrections_;
    if (norm > misled*norm_ && norm_ > 0)
    {
        columns_.clear();
    }
    else if (norm_ > 0)
    {
        columns_.push_front
        (
            {correction - correction_, scalarField(x) - scalarField(iterate_)}
        );
        if (columns_.size() > mostColumns)
        {
            columns_.pop_back();
        }
    }
    correction_ = correction;
    norm_ = norm;
    iterate_ = x;
    if (good || corrections_ <= plainCorrections || columns_.empty())
    {
        return false;
    }
    List<const scalarField*> V(columns_.size());
    forAll(V, j)
    {
        V[j] = &columns_[j].correction;
    }
    const interfaceLeastSquares fit(product_, V, correction, filter);
    iterate = x;
    forAll(V, j)
    {
        const scalar c = fit.coefficients()[j];
        forAll(iterate, i)
        {
            iterate[i] -= c*columns_[j].iterate[i];
        }
    }
    return true;
}
