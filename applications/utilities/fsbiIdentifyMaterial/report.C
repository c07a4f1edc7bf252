/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "report.H"
#include "OFstream.H"

#include <gsl/gsl_cdf.h>

namespace Foam
{
namespace fsbi
{

static const char* const columns =
    "constant,value,lowest,highest,deviation,atLimit";


//- Values as found, where nothing is known of how bounded they are
static void reportValues
(
    const identification& found,
    const List<identification::constant>& constants,
    const fileName& folder
)
{
    OFstream os(folder/"constants.csv");
    os.precision(10);
    os << columns << nl;
    forAll(constants, k)
    {
        os << constants[k].name << ',' << found.value(k) << ",nan,nan,nan,"
            << found.limited(k) << nl;
        Info<< "    " << constants[k].name << " = " << found.value(k) << nl;
    }
    Info<< "    intervals are computed for least squares of displacements only"
        << nl;
}


static void reportIntervals
(
    const identification& found,
    const List<identification::constant>& constants,
    const List<scalarList>& covariance,
    const scalar confidence,
    const fileName& folder
)
{
    const scalar t = gsl_cdf_tdist_Pinv
    (
        0.5 + 0.5*confidence, found.degreesOfFreedom()
    );
    OFstream os(folder/"constants.csv");
    os.precision(10);
    os << columns << nl;
    forAll(constants, k)
    {
        const auto& c = constants[k];
        const scalar deviation = Foam::sqrt(covariance[k][k]);
        const scalar half = t*deviation, value = found.value(k);
        const bool bounded = covariance[k][k] < GREAT;
        const scalar low = bounded ? c.value(found.at()[k] - half) : -GREAT;
        const scalar high = bounded ? c.value(found.at()[k] + half) : GREAT;
        os << c.name << ',' << value << ',' << low << ',' << high << ','
            << (bounded ? (c.powers() ? value*deviation : deviation) : GREAT)
            << ',' << found.limited(k) << nl;
        Info<< "    " << c.name << " = " << value << "    ";
        if (bounded)
        {
            Info<< 100*confidence << " % confidence interval: " << low << " to "
                << high << nl;
        }
        else
        {
            Info<< "no confidence interval: the body found cannot bear small"
                << " further forces" << nl;
        }
    }
    for (label k = 1; k < constants.size(); ++k)
    {
        for (label l = 0; l < k; ++l)
        {
            Info<< "    correlation of " << constants[l].name << " and "
                << constants[k].name << ": "
                << covariance[k][l]
                  /Foam::sqrt(covariance[k][k]*covariance[l][l]) << nl;
        }
    }
}


//- For constant/<body>
static void writeLaw
(
    const identification& found,
    const List<identification::constant>& constants,
    const fileName& folder
)
{
    forAll(constants, k)
    {
        if (found.limited(k))
        {
            Info<< "    " << constants[k].name << " is at the limit of its"
                << " range: widen it in 'find'; or the data do not determine it"
                << nl;
        }
    }
    OFstream law(folder/"material");
    IOobject::writeBanner(law)
        << "FoamFile { version 2.0; format ascii; class dictionary;"
        << " object material; }" << nl;
    found.law().write(law, false);
}

} // End namespace fsbi
} // End namespace Foam


void Foam::fsbi::reportConstants
(
    identification& found,
    const List<identification::constant>& constants,
    const scalar tractionError,
    const scalar confidence,
    const fileName& folder
)
{
    if (found.hasIntervals())
    {
        reportIntervals
        (
            found, constants, found.covariance(tractionError), confidence,
            folder
        );
    }
    else
    {
        reportValues(found, constants, folder);
    }
    writeLaw(found, constants, folder);
    Info<< "    standard deviations: displacement "
        << found.displacementError() << ", traction " << tractionError << nl;
}


void Foam::fsbi::reportMisfits
(
    const identification& found,
    loadedBody& body,
    const residualNorm& norm,
    const fileName& folder
)
{
    const scalar misfit = found.misfit(), noise = found.noise();
    const scalar model = Foam::sqrt(max(0, sqr(misfit) - sqr(noise)));
    const scalar ratio = found.springs();
    body.setSprings(loadedBody::stiff, found.modulus());
    body.setLaw(found.law());
    vectorField u;
    const bool solved = body.solve(u);
    const scalar lack = solved ? body.springShare() : GREAT;
    const scalar cost =
        solved
      ? norm.size(body.springTraction())
       /max(norm.size(body.traction()), VSMALL)
      : GREAT;
    Info<< "    relative misfit of displacement " << misfit << ", of this noise "
        << noise << ", model error " << model << nl
        << "    misfit of traction over that of no stress " << lack
        << ", in the norm given " << cost << nl
        << "    springs " << ratio << nl;
    OFstream os(folder/"misfits.csv");
    os.precision(10);
    os << "displacement,noise,modelError,traction,springs,cost" << nl << misfit
        << ',' << noise << ',' << model << ',' << lack << ',' << ratio << ','
        << cost << nl;
}
