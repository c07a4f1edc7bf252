/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "drivenField.H"
#include "OFstream.H"
#include "symmTensor.H"

namespace Foam
{
namespace fsbi
{

//- Orthogonal symmetric traceless tensors, (xx xy xz yy yz zz), in whole
//  numbers, which text holds exactly
static List<symmTensor> tracelessBasis()
{
    return
    {
        {1, 0, 0, -1, 0, 0}, {-1, 0, 0, -1, 0, 2},
        {0, 1, 0, 0, 0, 0}, {0, 0, 1, 0, 0, 0}, {0, 0, 0, 0, 1, 0}
    };
}


//- The fields that one unit of every strength makes, as entries
static PtrList<dictionary> unitEntries
(
    const dictionary& field, const word& type
)
{
    PtrList<dictionary> all;
    const auto with = [&](const word& key, const auto& value)
    {
        all.append(new dictionary(field));
        all.last().set(key, value);
    };
    if (type == "coil")
    {
        with("current", scalar(1));
    }
    for (direction d = 0; type == "uniform" && d < 3; ++d)
    {
        vector e(Zero);
        e[d] = 1;
        with("B", e);
    }
    for (label i = 0; type == "gradient" && i < 5; ++i)
    {
        with("components", tracelessBasis()[i]);
        all.last().remove("axis");
        all.last().remove("axial");
    }
    return all;
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::drivenField::drivenField
(
    const word& name, const dictionary& design, const dictionary& field,
    const units& u
)
:
    name_(name),
    type_
    (
        checkedDictionary(field).choice
        (
            "type", {"coil", "uniform", "gradient"}
        )
    )
{
    const checkedDictionary entries(design);
    limit_ = entries.positive("limit", VGREAT);
    scale_ = entries.positive("scale", limit_ < VGREAT ? limit_ : 1);
    entries.finish();
    for (const dictionary& dict : unitEntries(field, type_))
    {
        units_.append(magneticField::New(dict, u));
    }
}


Foam::scalar Foam::fsbi::drivenField::unitSize(const label i) const
{
    return type_ == "gradient" ? 1/mag(tracelessBasis()[i]) : 1;
}


Foam::wordList Foam::fsbi::drivenField::columns() const
{
    return
        type_ == "coil" ? wordList({"I"})
      : type_ == "uniform" ? wordList({"Bx", "By", "Bz"})
      : wordList({"Gxx", "Gxy", "Gxz", "Gyy", "Gyz", "Gzz"});
}


Foam::scalarField Foam::fsbi::drivenField::written
(
    const UList<scalar>& strengths
) const
{
    if (type_ != "gradient")
    {
        return scalarField(strengths);
    }
    scalarField G(6, Zero);
    forAll(strengths, i)
    {
        for (direction d = 0; d < 6; ++d)
        {
            G[d] += strengths[i]*unitSize(i)*tracelessBasis()[i][d];
        }
    }
    return G;
}


void Foam::fsbi::drivenField::writeTable
(
    const fileName& file, const UList<scalar>& times,
    const UList<scalarField>& strengths
) const
{
    OFstream os(file);
    os.precision(12);
    os << '(' << nl;
    forAll(times, n)
    {
        const scalarField values(written(strengths[n]));
        os << '(' << times[n] << ' ';
        if (values.size() == 1)
        {
            os << values[0];
        }
        else
        {
            os << '(';
            forAll(values, i)
            {
                os << (i ? " " : "") << values[i];
            }
            os << ')';
        }
        os << ')' << nl;
    }
    os << ')' << nl;
    if (!os.good())
    {
        FatalErrorInFunction
            << "Cannot write " << file << exit(FatalError);
    }
}
