#include "core/gltf/packed/meshopt_view.h"

#include <fmt/core.h>
#include <meshoptimizer.h>

namespace stretch::gltf {

namespace {

// Each run of 64 equal bytes of an attribute takes a byte at least, each triangle and index one as well.
constexpr std::uint64_t mostBytesFromOne = 64;

bool isStrideAllowed(const MeshoptView& view) {
  if (view.mode == "ATTRIBUTES") {
    return view.stride % 4 == 0 && view.stride > 0 && view.stride <= 256;
  }
  return view.stride == 2 || view.stride == 4;
}

bool isFilterAllowed(const MeshoptView& view) {
  if (view.filter == "NONE") {
    return true;
  }
  const bool knowsStride = (view.filter == "OCTAHEDRAL" && (view.stride == 4 || view.stride == 8)) ||
                           (view.filter == "QUATERNION" && view.stride == 8) || view.filter == "EXPONENTIAL";
  return view.mode == "ATTRIBUTES" && knowsStride;
}

std::string complaintAbout(const MeshoptView& view) {
  const bool isModeKnown = view.mode == "ATTRIBUTES" || view.mode == "TRIANGLES" || view.mode == "INDICES";
  if (!isModeKnown) {
    return fmt::format("has the mode '{}', which is not known", view.mode.substr(0, 40));
  }
  if (!isStrideAllowed(view)) {
    return fmt::format("has a stride of {} bytes, which its mode cannot have", view.stride);
  }
  if (!isFilterAllowed(view)) {
    return fmt::format("has the filter '{}', which its elements cannot have", view.filter.substr(0, 40));
  }
  if (view.mode == "TRIANGLES" && view.count % 3 != 0) {
    return fmt::format("has {} indices, which are no whole triangles", view.count);
  }
  const std::uint64_t most = view.bytes.size() * mostBytesFromOne;
  if (view.count == 0 || view.count > most || view.count * view.stride > most) {
    return fmt::format("says {} elements, which its {} bytes cannot hold", view.count, view.bytes.size());
  }
  return {};
}

int decodeElements(const MeshoptView& view, Bytes& decoded) {
  if (view.mode == "ATTRIBUTES") {
    return meshopt_decodeVertexBuffer(decoded.data(), view.count, view.stride, view.bytes.data(),
                                      view.bytes.size());
  }
  return view.mode == "TRIANGLES" ? meshopt_decodeIndexBuffer(decoded.data(), view.count, view.stride,
                                                              view.bytes.data(), view.bytes.size())
                                  : meshopt_decodeIndexSequence(decoded.data(), view.count, view.stride,
                                                                view.bytes.data(), view.bytes.size());
}

void undoFilter(const MeshoptView& view, Bytes& decoded) {
  if (view.filter == "OCTAHEDRAL") {
    meshopt_decodeFilterOct(decoded.data(), view.count, view.stride);
  } else if (view.filter == "QUATERNION") {
    meshopt_decodeFilterQuat(decoded.data(), view.count, view.stride);
  } else if (view.filter == "EXPONENTIAL") {
    meshopt_decodeFilterExp(decoded.data(), view.count, view.stride);
  }
}

} // namespace

Result<Bytes> decodeMeshopt(const MeshoptView& view) {
  if (std::string complaint = complaintAbout(view); !complaint.empty()) {
    return Error{std::move(complaint), "", "export it again"};
  }
  Bytes decoded(view.count * view.stride);
  if (decodeElements(view, decoded) != 0) {
    return Error{"holds compressed data that cannot be decoded", "", "export it again"};
  }
  undoFilter(view, decoded);
  return decoded;
}

} // namespace stretch::gltf
