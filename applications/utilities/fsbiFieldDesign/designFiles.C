/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "designFiles.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "SubField.H"

Foam::scalarField Foam::fsbi::designed::strengths
(
    const label field, const label n
) const
{
    label first = 0;
    for (label i = 0; i < field; ++i)
    {
        first += entries.driven()[i].size();
    }
    return scalarField
    (
        SubField<scalar>
        (
            solutions[n].strengths, entries.driven()[field].size(), first
        )
    );
}


void Foam::fsbi::designed::writeTables(const fileName& folder) const
{
    mkDir(folder);
    scalarField times(wanted.size());
    List<scalarField> values(wanted.size());
    forAll(entries.driven(), i)
    {
        forAll(wanted, n)
        {
            times[n] = wanted[n].time;
            values[n] = strengths(i, n);
        }
        const drivenField& field = entries.driven()[i];
        field.writeTable(folder/field.name(), times, values);
    }
}


void Foam::fsbi::designed::writeCsv(const fileName& file) const
{
    mkDir(file.path());
    OFstream os(file);
    os.precision(10);
    os  << "time,x,y,z";
    for (const drivenField& field : entries.driven())
    {
        for (const word& column : field.columns())
        {
            os << ',' << field.name() << '.' << column;
        }
    }
    os  << ",Bx,By,Bz,Gxx,Gxy,Gxz,Gyy,Gyz,Gzz"
        << ",wantedFx,wantedFy,wantedFz,wantedTx,wantedTy,wantedTz"
        << ",Fx,Fy,Fz,Tx,Ty,Tz,residual" << nl;
    const scalar metre = entries.inUnits().metre();
    forAll(wanted, n)
    {
        const wantedLoad& w = wanted[n];
        const auto& s = solutions[n];
        const symmTensor G(metre*symm(s.made.gradient));
        DynamicList<scalar> row;
        const auto add = [&](const auto& v)
        {
            for (direction d = 0; d < v.size(); ++d)
            {
                row.append(v[d]);
            }
        };
        add(w.x);
        forAll(entries.driven(), i)
        {
            for (const scalar v : entries.driven()[i].written(strengths(i, n)))
            {
                row.append(v);
            }
        }
        add(s.made.B);
        add(G);
        add(w.force);
        add(w.torque);
        add(s.force);
        add(s.torque);
        os << w.time;
        for (const scalar v : row)
        {
            os << ',' << v;
        }
        os << ',' << s.residual << nl;
    }
}


void Foam::fsbi::designed::summarise(const scalar radius) const
{
    scalar force = 0, torque = 0;
    label worst = 0;
    forAll(wanted, n)
    {
        force = max(force, mag(wanted[n].force));
        torque = max(torque, mag(wanted[n].torque));
        worst = solutions[n].residual > solutions[worst].residual ? n : worst;
    }
    Info<< nl << wanted.size() << " times from " << wanted.first().time
        << " to " << wanted.last().time << nl
        << "Largest force wanted:   " << force << nl
        << "Largest torque wanted:  " << torque << nl;
    forAll(entries.driven(), i)
    {
        const drivenField& field = entries.driven()[i];
        scalar largest = 0;
        forAll(wanted, n)
        {
            for (const scalar v : strengths(i, n))
            {
                largest = max(largest, mag(v));
            }
        }
        Info<< "Largest " << field.columns()[0][0] << " of "
            << field.name() << ": " << largest
            << (field.columns()[0] == "I" ? " A"
                : field.columns()[0] == "Bx" ? " T" : " T/m");
        if (field.limit() < VGREAT)
        {
            Info<< ", limit " << field.limit();
        }
        Info<< nl;
    }
    Info<< "Load not made, over the largest wanted (torque over " << radius
        << "): " << solutions[worst].residual << " at time "
        << wanted[worst].time << nl;
    if (switches.size())
    {
        Info<< "The fields switch at " << flatOutput(switches)
            << ": within their limits nothing in between makes the load, and"
            << " the coils must be as fast" << nl;
    }
}
