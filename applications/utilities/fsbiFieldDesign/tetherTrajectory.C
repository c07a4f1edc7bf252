/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "trajectory.H"
#include "hdfHandle.H"
#include "OSspecific.H"

#include <algorithm>

namespace Foam
{
namespace fsbi
{

//- Tables of a history file; fatal, with the entry that named it, if not there
class pastRun
{
    const dictionary& entry_;
    const fileName file_;
    hdfHandle handle_;
    std::vector<std::string> paths_;

public:

    pastRun(const dictionary& entry, const fileName& folder)
    :
        entry_(entry),
        file_(folder/"postProcessing"/"history.h5")
    {
        const hdf::quiet silence;
        if (isFile(file_))
        {
            handle_ = hdf::open(file_);
        }
        if (!handle_.valid() || !hdf::datasets(handle_, paths_))
        {
            FatalIOErrorInFunction(entry_)
                << "There is no history " << file_ << " to read: run the case"
                << " first, or give its folder as 'case'"
                << exit(FatalIOError);
        }
    }

    bool has(const std::string& path) const
    {
        return
            std::find(paths_.begin(), paths_.end(), path) != paths_.end();
    }

    //- Columns, the first is the time
    List<scalarField> table(const std::string& path) const
    {
        if (!has(path))
        {
            FatalIOErrorInFunction(entry_)
                << "The history " << file_ << " has no " << path
                << ": is the body of that name and kind in that run?"
                << exit(FatalIOError);
        }
        const hdf::quiet silence;
        const hdfHandle dataset(H5Dopen2(handle_, path.c_str(), H5P_DEFAULT));
        hsize_t size[2] = {0, 0};
        bool good = hdf::shape(dataset, size) && size[0] > 0;
        List<scalarField> columns(size[1]);
        forAll(columns, c)
        {
            std::vector<double> values;
            good = good && hdf::readColumn(dataset, c, values);
            columns[c].setSize(values.size());
            std::copy(values.begin(), values.end(), columns[c].begin());
        }
        if (!good)
        {
            FatalIOErrorInFunction(entry_)
                << "The history " << file_ << " has no rows of " << path
                << exit(FatalIOError);
        }
        return columns;
    }

    const fileName& file() const { return file_; }
};


static vector vectorOf(const List<scalarField>& table, const label row)
{
    return vector(table[1][row], table[2][row], table[3][row]);
}


static void addElastic(const pastRun& run, const word& body, loadTrajectory& c)
{
    const fileName path("elasticBodies"/body);
    const auto force(run.table(path/"tether"));
    const auto x(run.table(path/"centre"));
    forAll(force[0], n)
    {
        c.append
        (
            {
                force[0][n], vectorOf(x, n), tensor::I, vectorOf(force, n),
                Zero
            }
        );
    }
}


static void addRigid(const pastRun& run, const word& body, loadTrajectory& c)
{
    const fileName path("bodies"/body);
    const auto x(run.table(path/"position"));
    const auto q(run.table(path/"orientation"));
    const auto force(run.table(path/"force"/"fluid"));
    const auto torque(run.table(path/"torque"/"fluid"));
    const auto applied(run.table(path/"force"/"applied"));
    const auto appliedTorque(run.table(path/"torque"/"applied"));
    forAll(force[0], n)
    {
        const quaternion turned
        (
            q[1][n], vector(q[2][n], q[3][n], q[4][n])
        );
        c.append
        (
            {
                force[0][n], vectorOf(x, n), turned.R(),
              - vectorOf(force, n) - vectorOf(applied, n),
              - vectorOf(torque, n) - vectorOf(appliedTorque, n)
            }
        );
    }
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::loadTrajectory Foam::fsbi::tetherTrajectory
(
    const dictionary& tether, const word& body, const fileName& thisCase,
    const bool elastic
)
{
    const checkedDictionary entries(tether);
    fileName folder(entries.getOrDefault<fileName>("case", thisCase));
    entries.finish();
    folder.expand();
    if (!folder.isAbsolute())
    {
        folder = thisCase/folder;
    }
    const pastRun run(tether, folder);
    loadTrajectory c;
    elastic ? addElastic(run, body, c) : addRigid(run, body, c);
    scalar largest = 0;
    for (const wantedLoad& l : c)
    {
        largest = max(largest, max(mag(l.force), mag(l.torque)));
    }
    if (largest == 0)
    {
        FatalIOErrorInFunction(tether)
            << "Nothing held the body '" << body << "' in " << run.file()
            << ": " << (elastic ? "give it a 'tether'" : "'constraints'")
            << " in constant/bodies there" << exit(FatalIOError);
    }
    return c;
}
