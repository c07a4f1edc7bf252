/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "volumeForce.H"
#include "timeFunction.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{

defineTypeNameAndDebug(volumeForce, 0);
defineRunTimeSelectionTable(volumeForce, entries);


//- rho g
class gravity
:
    public volumeForce
{
    vector weight_;

public:

    TypeName("gravity");

    explicit gravity(const checkedDictionary& entries)
    :
        weight_
        (
            entries.positive("density")*entries.get<vector>("acceleration")
        )
    {}

    void add(const pointField&, const scalar, vectorField& b) const override
    {
        b += weight_;
    }

    bool buoyant() const override { return true; }
};

defineTypeNameAndDebug(gravity, 0);
addToRunTimeSelectionTable(volumeForce, gravity, entries);


//- The same everywhere
class uniformForce
:
    public volumeForce
{
    autoPtr<Function1<vector>> value_;

public:

    TypeName("uniform");

    explicit uniformForce
    (
        const checkedDictionary& entries, const word& keyword = "value"
    )
    :
        value_(timeFunction<vector>(keyword, entries))
    {}

    vector value(const scalar t) const { return value_->value(t); }

    void add(const pointField&, const scalar t, vectorField& b) const override
    {
        b += value(t);
    }
};

defineTypeNameAndDebug(uniformForce, 0);
addToRunTimeSelectionTable(volumeForce, uniformForce, entries);


//- Minus the gradient of a pressure that is no unknown
class pressureGradientForce
:
    public uniformForce
{
public:

    TypeName("pressureGradient");

    explicit pressureGradientForce(const checkedDictionary& entries)
    :
        uniformForce(entries, "gradient")
    {}

    void add(const pointField&, const scalar t, vectorField& b) const override
    {
        b -= value(t);
    }

    vector pressureGradient(const scalar t) const override
    {
        return value(t);
    }
};

defineTypeNameAndDebug(pressureGradientForce, 0);
addToRunTimeSelectionTable(volumeForce, pressureGradientForce, entries);

} // End namespace fsbi
} // End namespace Foam


Foam::autoPtr<Foam::fsbi::volumeForce> Foam::fsbi::volumeForce::New
(
    const dictionary& dict
)
{
    const checkedDictionary entries(dict);
    const word type
    (
        entries.choice("type", entriesConstructorTablePtr_->sortedToc())
    );
    autoPtr<volumeForce> force((*entriesConstructorTablePtr_)[type](entries));
    entries.finish();
    return force;
}
