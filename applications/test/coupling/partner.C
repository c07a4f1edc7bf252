/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "partner.H"
#include "DynamicList.H"

using namespace Foam;
using namespace Foam::fsbi;

// Numbers from -1 to 1 without order, the same everywhere
static scalar scattered(const label i)
{
    const scalar s = 43758.5453*Foam::sin(12.9898*(i + 1));
    return 2*(s - std::floor(s)) - 1;
}


// Apply reflections, whose product is an orthogonal matrix without zeros
static void rotate(scalarField& x, const bool back)
{
    const label count = 6;
    const label n = x.size();
    for (label k = 0; k < count; ++k)
    {
        scalarField v(n);
        forAll(v, i)
        {
            v[i] = scattered(i + n*(back ? count - 1 - k : k));
        }
        x -= 2*sum(v*x)/sum(v*v)*v;
    }
}


Foam::fsbi::partner::partner
(
    const scalarList& eigenvalues, const division where, const scalar s
)
:
    A_(eigenvalues.size()),
    s_(s)
{
    const label n = size();
    forAll(A_, i)
    {
        A_[i] = scalarField(n, Zero);
        A_[i][i] = 1;
        if (n > 1)
        {
            rotate(A_[i], false);
        }
        A_[i] *= eigenvalues;
        if (n > 1)
        {
            rotate(A_[i], true);
        }
    }
    const label last = Pstream::nProcs() - 1;
    DynamicList<label> entries;
    DynamicList<scalar> weights;
    for (label i = 0; i < n; ++i)
    {
        // ranges of the processors overlap by one entry
        const scalar at = scalar(i)*(last + 1)/n;
        const label owner = min(label(at), last);
        const bool border =
            owner > 0 && label(scalar(i - 1)*(last + 1)/n) != owner;
        const label me = Pstream::myProcNo();
        if (where == onLast ? me == last
          : me == owner || (border && me == owner - 1))
        {
            entries.append(i);
            weights.append(border && where == shared ? 0.5 : 1);
        }
    }
    entries_ = entries;
    weights_ = scalarList(weights);
    aim(0);
}


Foam::scalarList Foam::fsbi::partner::spread
(
    const label n, const scalar a, const scalar b
)
{
    scalarList values(n);
    forAll(values, i)
    {
        values[i] = a*Foam::pow(b/a, scalar(i)/(n - 1));
    }
    return values;
}


Foam::scalarField Foam::fsbi::partner::whole(const scalarField& x) const
{
    scalarList all(size(), Zero);
    forAll(x, i)
    {
        all[entries_[i]] += weights_[i]*x[i];
    }
    Pstream::listCombineGather(all, plusEqOp<scalar>());
    Pstream::listCombineScatter(all);
    return scalarField(all);
}


Foam::scalarField Foam::fsbi::partner::part(const scalarField& all) const
{
    return scalarField(all, entries_);
}


Foam::scalarField Foam::fsbi::partner::solution(const scalar number) const
{
    scalarField x(size());
    forAll(x, i)
    {
        x[i] = 1 + 0.5*Foam::sin(0.7*i + 0.3*number) + 0.3*number*scattered(i);
    }
    return x;
}


void Foam::fsbi::partner::aim(const scalar number)
{
    b_ = scalarField(size(), Zero);
    const scalarField x(solution(number));
    scalarField full(size());
    forAll(full, i)
    {
        full[i] = x[i] + sum(A_[i]*x) + s_*Foam::tanh(x[i]);
    }
    b_ = full;
}


Foam::scalarField Foam::fsbi::partner::H(const scalarField& x) const
{
    const scalarField all(whole(x));
    scalarField Hx(x.size());
    forAll(Hx, k)
    {
        const label i = entries_[k];
        Hx[k] = b_[i] - sum(A_[i]*all) - s_*Foam::tanh(all[i]);
    }
    return Hx;
}


Foam::scalar Foam::fsbi::partner::error
(
    const scalarField& x, const scalar number
) const
{
    const scalarField exact(solution(number));
    return Foam::sqrt(sumSqr(whole(x) - exact)/sumSqr(exact));
}


Foam::autoPtr<Foam::fsbi::couplingLoop> Foam::fsbi::makeLoop
(
    const std::string& text, const partner& p
)
{
    const dictionary dict{IStringStream(text)()};
    const checkedDictionary entries(dict);
    autoPtr<couplingLoop> loop(new couplingLoop(entries));
    entries.finish();
    loop->start(p.weights());
    return loop;
}


Foam::fsbi::stepRun::stepRun
(
    couplingLoop& loop, const partner& p, scalarField& x, const bool accept
)
{
    const interfaceProduct product(p.weights());
    const scalar scale = product.norm(p.part(p.solution(0)));
    DynamicList<scalar> norms;
    loop.beginStep();
    report = loop.solve
    (
        [&](const scalarField& old, scalarField& Hx)
        {
            Hx = p.H(old);
            norms.append(product.norm(Hx - old)/scale);
            return outcome();
        },
        scale, x
    );
    accept ? loop.endStep() : loop.rewind();
    residuals = norms;
}


Foam::scalar Foam::fsbi::stepRun::factor(const label pass) const
{
    return residuals[pass]/residuals[pass - 1];
}
