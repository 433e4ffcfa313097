#include "results/Hdf5Truncation.h"

#include <algorithm>
#include <array>
#include <vector>

namespace squat::results::hdf5 {
namespace {

std::size_t presentInOnePiece(hid_t dataset, const std::vector<hsize_t>& extents, std::size_t axis, std::size_t bytes) {
  const haddr_t start = H5Dget_offset(dataset);
  if (start == HADDR_UNDEF) return extents[axis];  // never written: fill values
  const Handle type(H5Dget_type(dataset), H5Tclose);
  const std::size_t values = bytes > start ? (bytes - start) / std::max<std::size_t>(1, H5Tget_size(type.get())) : 0;
  std::size_t outer = 1, inner = 1;
  for (std::size_t i = 0; i < extents.size(); ++i)
    if (i != axis) (i < axis ? outer : inner) *= static_cast<std::size_t>(extents[i]);
  // The last of the outer blocks decides.
  const std::size_t before = (std::max<std::size_t>(1, outer) - 1) * extents[axis] * inner;
  return values > before ? std::min<std::size_t>(extents[axis], (values - before) / std::max<std::size_t>(1, inner))
                         : 0;
}

std::size_t presentInChunks(hid_t dataset, hid_t space, std::size_t extent, std::size_t axis, std::size_t bytes) {
  hsize_t count = 0;
  if (H5Dget_num_chunks(dataset, space, &count) < 0) return 0;
  std::size_t present = extent;
  for (hsize_t i = 0; i < count; ++i) {
    std::array<hsize_t, H5S_MAX_RANK> offset{};
    unsigned filters = 0;
    haddr_t start = 0;
    hsize_t size = 0;
    if (H5Dget_chunk_info(dataset, space, i, offset.data(), &filters, &start, &size) < 0) return 0;
    if (start > bytes || size > bytes - start) present = std::min<std::size_t>(present, offset[axis]);
  }
  return present;
}

}  // namespace

Handle openTruncated(const std::string& path) {
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  // The library's own tools open damaged files with this property. A library without it refuses them as before.
  const hbool_t skip = true;
  H5Pset(access.get(), "skip_eof_check", &skip);
  return {H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.get()), H5Fclose};
}

std::size_t missingBytes(hid_t file, std::size_t bytes) {
  hsize_t whole = 0;  // the larger of what there is and what the file says
  return H5Fget_filesize(file, &whole) < 0 || whole <= bytes ? 0 : static_cast<std::size_t>(whole) - bytes;
}

std::size_t presentAlong(hid_t dataset, std::size_t axis, std::size_t bytes) {
  const Handle space(H5Dget_space(dataset), H5Sclose);
  const int rank = H5Sget_simple_extent_ndims(space.get());
  if (rank <= 0 || axis >= static_cast<std::size_t>(rank)) return 0;
  std::vector<hsize_t> extents(static_cast<std::size_t>(rank));
  H5Sget_simple_extent_dims(space.get(), extents.data(), nullptr);
  const Handle creation(H5Dget_create_plist(dataset), H5Pclose);
  switch (H5Pget_layout(creation.get())) {
    case H5D_COMPACT:
      return extents[axis];
    case H5D_CONTIGUOUS:
      return presentInOnePiece(dataset, extents, axis, bytes);
    case H5D_CHUNKED:
      return presentInChunks(dataset, space.get(), extents[axis], axis, bytes);
    default:
      return 0;
  }
}

}  // namespace squat::results::hdf5
