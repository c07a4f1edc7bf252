/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "hdfHandle.H"

#include <algorithm>

namespace Foam
{
namespace fsbi
{
namespace hdf
{

// The format that can be written while it is read: data reach the file before
// what points to them, so a kill at any moment leaves a readable file
static hdfHandle accessProperties()
{
    hdfHandle access(H5Pcreate(H5P_FILE_ACCESS));
    H5Pset_libver_bounds(access, H5F_LIBVER_LATEST, H5F_LIBVER_LATEST);
    return access;
}


hdfHandle create(const std::string& file)
{
    const hdfHandle access = accessProperties();
    return hdfHandle
    (
        H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access)
    );
}


hdfHandle open(const std::string& file)
{
    const hdfHandle access = accessProperties();

    // a killed run leaves its mark 'open for writing'; this is what HDF5's
    // own tool h5clear does about it
    const hbool_t clear = true;
    if (H5Pexist(access, "clear_status_flags") > 0)
    {
        H5Pset(access, "clear_status_flags", &clear);
    }
    else
    {
        H5Pinsert2
        (
            access, "clear_status_flags", sizeof(clear),
            const_cast<hbool_t*>(&clear),
            nullptr, nullptr, nullptr, nullptr, nullptr, nullptr
        );
    }
    hdfHandle handle(H5Fopen(file.c_str(), H5F_ACC_RDWR, access));

    // and its superblock, written last, may not know the end of the file yet
    if (handle.valid() && H5Fincrement_filesize(handle, 0) < 0)
    {
        handle.close();
    }
    return handle;
}


static herr_t collectDataset
(
    hid_t, const char* name, const H5O_info_t* info, void* paths
)
{
    if (info->type == H5O_TYPE_DATASET)
    {
        static_cast<std::vector<std::string>*>(paths)->push_back(name);
    }
    return 0;
}


bool datasets(const hid_t file, std::vector<std::string>& paths)
{
    return H5Ovisit
    (
        file, H5_INDEX_NAME, H5_ITER_NATIVE, collectDataset, &paths
    ) >= 0;
}


bool shape(const hid_t dataset, hsize_t (&rowsColumns)[2])
{
    const hdfHandle space(H5Dget_space(dataset));
    return
        space.valid()
     && H5Sget_simple_extent_ndims(space) == 2
     && H5Sget_simple_extent_dims(space, rowsColumns, nullptr) == 2;
}


hdfHandle createTable
(
    const hid_t file, const std::string& path, const hsize_t columns
)
{
    // about 16 kB at a time: small enough to rewrite after every step
    const hsize_t rows = std::max<hsize_t>(1, 2048/columns);
    const hsize_t none[2] = {0, columns};
    const hsize_t limit[2] = {H5S_UNLIMITED, columns};
    const hsize_t chunk[2] = {rows, columns};

    const hdfHandle space(H5Screate_simple(2, none, limit));
    const hdfHandle layout(H5Pcreate(H5P_DATASET_CREATE));
    H5Pset_chunk(layout, 2, chunk);
    const hdfHandle links(H5Pcreate(H5P_LINK_CREATE));
    H5Pset_create_intermediate_group(links, 1);

    return hdfHandle
    (
        H5Dcreate2
        (
            file, path.c_str(), H5T_IEEE_F64LE, space, links, layout,
            H5P_DEFAULT
        )
    );
}


bool addRows
(
    const hid_t dataset, const hsize_t row, const hsize_t columns,
    const std::vector<double>& values
)
{
    const hsize_t start[2] = {row, 0};
    const hsize_t count[2] = {values.size()/columns, columns};
    const hsize_t size[2] = {row + count[0], columns};
    if (H5Dset_extent(dataset, size) < 0)
    {
        return false;
    }
    const hdfHandle target(H5Dget_space(dataset));
    const hdfHandle source(H5Screate_simple(2, count, nullptr));
    H5Sselect_hyperslab
    (
        target, H5S_SELECT_SET, start, nullptr, count, nullptr
    );
    return H5Dwrite
    (
        dataset, H5T_NATIVE_DOUBLE, source, target, H5P_DEFAULT, values.data()
    ) >= 0;
}


bool readColumn
(
    const hid_t dataset, const hsize_t column, std::vector<double>& values
)
{
    hsize_t size[2];
    if (!shape(dataset, size))
    {
        return false;
    }
    values.resize(size[0]);
    if (values.empty())
    {
        return true;
    }
    const hsize_t start[2] = {0, column};
    const hsize_t count[2] = {size[0], 1};
    const hdfHandle source(H5Dget_space(dataset));
    const hdfHandle target(H5Screate_simple(2, count, nullptr));
    H5Sselect_hyperslab
    (
        source, H5S_SELECT_SET, start, nullptr, count, nullptr
    );
    return H5Dread
    (
        dataset, H5T_NATIVE_DOUBLE, target, source, H5P_DEFAULT, values.data()
    ) >= 0;
}


hdfHandle openGroup(const hid_t file, const std::string& path)
{
    hdfHandle group(H5Gopen2(file, path.c_str(), H5P_DEFAULT));
    if (!group.valid())
    {
        const hdfHandle links(H5Pcreate(H5P_LINK_CREATE));
        H5Pset_create_intermediate_group(links, 1);
        group = hdfHandle
        (
            H5Gcreate2(file, path.c_str(), links, H5P_DEFAULT, H5P_DEFAULT)
        );
    }
    return group;
}


// Fixed-length strings: no memory owned by HDF5 to give back
static hdfHandle textType(const size_t length)
{
    hdfHandle type(H5Tcopy(H5T_C_S1));
    H5Tset_size(type, length);
    H5Tset_strpad(type, H5T_STR_NULLPAD);
    H5Tset_cset(type, H5T_CSET_UTF8);
    return type;
}


bool setText
(
    const hid_t object, const char* name, const std::vector<std::string>& text
)
{
    size_t length = 1;
    for (const std::string& s : text)
    {
        length = std::max(length, s.size());
    }
    std::string buffer(length*text.size(), '\0');
    for (size_t i = 0; i < text.size(); ++i)
    {
        text[i].copy(&buffer[i*length], length);
    }

    if (H5Aexists(object, name) > 0 && H5Adelete(object, name) < 0)
    {
        return false;
    }
    const hsize_t size = text.size();
    const hdfHandle type = textType(length);
    const hdfHandle space(H5Screate_simple(1, &size, nullptr));
    const hdfHandle attribute
    (
        H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT)
    );
    return attribute.valid() && H5Awrite(attribute, type, buffer.data()) >= 0;
}


bool text
(
    const hid_t object, const char* name, std::vector<std::string>& text
)
{
    const hdfHandle attribute(H5Aopen(object, name, H5P_DEFAULT));
    if (!attribute.valid())
    {
        return false;
    }
    const hdfHandle space(H5Aget_space(attribute));
    const hdfHandle type(H5Aget_type(attribute));
    const size_t length = H5Tget_size(type);
    const hssize_t n = H5Sget_simple_extent_npoints(space);
    std::string buffer(length*n, '\0');
    if (H5Aread(attribute, type, &buffer[0]) < 0)
    {
        return false;
    }
    text.clear();
    for (hssize_t i = 0; i < n; ++i)
    {
        text.emplace_back(buffer.substr(i*length, length).c_str());
    }
    return true;
}

} // End namespace hdf
} // End namespace fsbi
} // End namespace Foam
