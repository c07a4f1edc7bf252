/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidMeasures.H"
#include "fvMesh.H"
#include "mathematicalConstants.H"

namespace Foam
{

//- Smallest and largest principal value, by angles: OpenFOAM's eigenValues
//  warns of complex ones where two are nearly equal
static void principalValues(const symmTensor& C, scalar& least, scalar& most)
{
    const scalar mean = tr(C)/3;
    const symmTensor D(C - mean*symmTensor::I);
    const scalar radius = sqrt(magSqr(D)/6);
    const scalar third = max(pow3(radius), VSMALL);
    const scalar angle =
        acos(min(max(0.5*det(D)/third, scalar(-1)), scalar(1)))/3;
    most = mean + 2*radius*cos(angle);
    least =
        mean + 2*radius*cos(angle + constant::mathematical::twoPi/3);
}

} // End namespace Foam


void Foam::fsbi::solidMeasures::setDeformation
(
    const scalarField& volumes,
    const elasticOperator& solid
)
{
    const tensorField& F = solid.state().deformation();
    scalarField energy(F.size());
    minJ = minStretch = GREAT;
    maxStretch = 0;
    forAll(F, v)
    {
        const solidMaterial& law = solid.state().law(v);
        energy[v] =
            solid.state().mixed() && law.lambda() > 0
          ? law.shearEnergy(F[v])
          + 0.5*sqr(solid.state().pressure()[v])/law.lambda()
          : law.energy(F[v]);
        minJ = min(minJ, det(F[v]));
        scalar least, most;
        principalValues(symm(F[v].T() & F[v]), least, most);
        minStretch = min(minStretch, sqrt(max(least, scalar(0))));
        maxStretch = max(maxStretch, sqrt(most));
    }
    // with the centre exact for quadratic functions over tetrahedra
    const constitutiveState* centres = solid.atCentres();
    elastic = 0;
    forAll(volumes, celli)
    {
        const labelList& points = solid.stencil().vertices().ofCells()[celli];
        scalar mean = 0;
        for (const label v : points)
        {
            mean += energy[v]/points.size();
        }
        if (centres)
        {
            const tensor& atCentre = centres->deformation()[celli];
            mean += 0.8*(solid.parts().law(celli).energy(atCentre) - mean);
        }
        elastic += volumes[celli]*mean;
    }
    reduce(elastic, sumOp<scalar>());
    if (solid.skin())
    {
        skin = solid.skin()->measured();
        elastic += skin.energy;
    }
    reduce(minJ, minOp<scalar>());
    reduce(minStretch, minOp<scalar>());
    reduce(maxStretch, maxOp<scalar>());
}


void Foam::fsbi::solidMeasures::setMotion
(
    const scalarField& volumes,
    const scalar density,
    const vectorField& x,
    const vectorField& v
)
{
    const scalarField mass(density*volumes);
    centre = gSum(volumes*x)/gSum(volumes);
    kinetic = 0.5*gSum(mass*magSqr(v));
    momentum = gSum(mass*v);
    angularMomentum = gSum(mass*(x ^ v));
}
