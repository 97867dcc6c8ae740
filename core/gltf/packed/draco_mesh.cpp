#include "core/gltf/packed/draco_mesh.h"

#include <cstring>
#include <exception>
#include <memory>
#include <optional>

#include <draco/compression/config/compression_shared.h>
#include <draco/compression/mesh/mesh_edgebreaker_decoder.h>
#include <draco/compression/mesh/mesh_sequential_decoder.h>
#include <draco/core/varint_decoding.h>
#include <fmt/core.h>

#include "core/gltf/import/accessor_layout.h"

namespace stretch::gltf {

namespace {

// Even grids of equal quads do not come down to so little for each of their triangles and vertices.
constexpr std::uint64_t mostElementsFromOneByte = 256;
constexpr std::uint64_t elementsOfAnyMesh = 4096;
constexpr std::uint64_t bytesForTriangle = 200; // that the decoder takes for its tables
constexpr std::size_t mostAttributes = 64;

struct DracoLimits {
  std::uint64_t elements = 0;
  std::uint64_t bytes = 0;
};

// The decoder of the library with a look at each count before memory is taken for it.
template <typename Base>
class BoundedDecoder : public Base {
public:
  BoundedDecoder(DracoLimits limits, bool isSequential) : limits_(limits), isSequential_(isSequential) {}

  [[nodiscard]] const std::string& complaint() const { return complaint_; }

protected:
  // Connectivity begins with two numbers in either method: triangles and vertices, or vertices and
  // triangles.
  bool DecodeConnectivity() override {
    draco::DecoderBuffer ahead = *this->buffer();
    std::uint32_t first = 0;
    std::uint32_t second = 0;
    if (!draco::DecodeVarint(&first, &ahead) || !draco::DecodeVarint(&second, &ahead)) {
      return false;
    }
    const std::uint64_t triangles = isSequential_ ? first : second;
    const std::uint64_t vertices = isSequential_ ? second : first;
    if (triangles > limits_.elements || vertices > limits_.elements ||
        (triangles + vertices) * bytesForTriangle > limits_.bytes) {
      complaint_ =
          fmt::format("says {} triangles and {} vertices, which its bytes cannot hold", triangles, vertices);
      return false;
    }
    return Base::DecodeConnectivity();
  }

  bool DecodeAllAttributes() override {
    const draco::PointCloud& cloud = *this->point_cloud();
    std::uint64_t stride = 0;
    for (int i = 0; i < cloud.num_attributes(); ++i) {
      stride += 2 * static_cast<std::uint64_t>(cloud.attribute(i)->byte_stride()) + sizeof(std::uint32_t);
    }
    if (static_cast<std::size_t>(cloud.num_attributes()) > mostAttributes ||
        stride * cloud.num_points() > limits_.bytes) {
      complaint_ = fmt::format("has {} attributes of {} vertices, more than the program takes into memory",
                               cloud.num_attributes(), cloud.num_points());
      return false;
    }
    return Base::DecodeAllAttributes();
  }

private:
  DracoLimits limits_;
  bool isSequential_;
  std::string complaint_;
};

Error undecodable(std::string what) {
  return {std::move(what), "", "export it again"};
}

template <typename Base>
Result<std::unique_ptr<draco::Mesh>> decodedBy(draco::DecoderBuffer& buffer, DracoLimits limits,
                                               bool isSequential) {
  BoundedDecoder<Base> decoder(limits, isSequential);
  auto mesh = std::make_unique<draco::Mesh>();
  const draco::DecoderOptions options;
  const draco::Status status = decoder.Decode(options, &buffer, mesh.get());
  if (!status.ok()) {
    return undecodable(decoder.complaint().empty() ? "holds Draco data that cannot be decoded"
                                                   : decoder.complaint());
  }
  return mesh;
}

Result<std::unique_ptr<draco::Mesh>> dracoMesh(std::span<const std::uint8_t> bytes, std::size_t mostBytes) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  draco::DecoderBuffer ahead = buffer;
  draco::DracoHeader header;
  if (!draco::PointCloudDecoder::DecodeHeader(&ahead, &header).ok()) {
    return undecodable("holds no Draco data");
  }
  if (header.version_major != 2 || header.version_minor != 2) {
    return undecodable(fmt::format("holds Draco data of version {}.{}, where glTF has 2.2",
                                   header.version_major, header.version_minor));
  }
  if (header.encoder_type != draco::TRIANGULAR_MESH) {
    return undecodable("holds Draco data that are no mesh of triangles");
  }
  const DracoLimits limits{bytes.size() * mostElementsFromOneByte + elementsOfAnyMesh, mostBytes};
  return header.encoder_method == draco::MESH_SEQUENTIAL_ENCODING
             ? decodedBy<draco::MeshSequentialDecoder>(buffer, limits, true)
             : decodedBy<draco::MeshEdgebreakerDecoder>(buffer, limits, false);
}

template <typename Number>
bool convertValues(const draco::PointAttribute& from, std::size_t vertices, int width, Bytes& packed) {
  const std::size_t size = static_cast<std::size_t>(width) * sizeof(Number);
  packed.resize(vertices * size);
  std::vector<Number> value(static_cast<std::size_t>(width));
  for (std::size_t i = 0; i < vertices; ++i) {
    const auto index = from.mapped_index(draco::PointIndex(static_cast<std::uint32_t>(i)));
    if (index.value() >= from.size() ||
        !from.ConvertValue<Number>(index, static_cast<std::int8_t>(width), value.data())) {
      return false;
    }
    std::memcpy(packed.data() + i * size, value.data(), size);
  }
  return true;
}

bool convertTo(ComponentType type, const draco::PointAttribute& from, std::size_t vertices, int width,
               Bytes& packed) {
  switch (type) {
  case ComponentType::int8:
    return convertValues<std::int8_t>(from, vertices, width, packed);
  case ComponentType::uint8:
    return convertValues<std::uint8_t>(from, vertices, width, packed);
  case ComponentType::int16:
    return convertValues<std::int16_t>(from, vertices, width, packed);
  case ComponentType::uint16:
    return convertValues<std::uint16_t>(from, vertices, width, packed);
  case ComponentType::uint32:
    return convertValues<std::uint32_t>(from, vertices, width, packed);
  case ComponentType::float32:
    return convertValues<float>(from, vertices, width, packed);
  }
  return false;
}

Status takeAttribute(const draco::Mesh& mesh, const DracoAttribute& wanted, DracoMesh& made) {
  const draco::PointAttribute* attribute = mesh.GetAttributeByUniqueId(wanted.id);
  if (attribute == nullptr || attribute->num_components() != wanted.width) {
    return undecodable(attribute == nullptr
                           ? fmt::format("has no attribute {} in its Draco data", wanted.id)
                           : fmt::format("has {} components in attribute {} of its Draco data, but its "
                                         "accessor has {}",
                                         attribute->num_components(), wanted.id, wanted.width));
  }
  made.attributes.emplace_back();
  if (!convertTo(wanted.component, *attribute, made.vertexCount, wanted.width, made.attributes.back())) {
    return undecodable(fmt::format("has values in attribute {} of its Draco data that its accessor cannot "
                                   "hold",
                                   wanted.id));
  }
  return Success{};
}

Result<DracoMesh> takenApart(const draco::Mesh& mesh, std::span<const DracoAttribute> wanted) {
  DracoMesh made;
  made.vertexCount = mesh.num_points();
  made.corners.reserve(std::size_t{3} * mesh.num_faces());
  for (std::uint32_t face = 0; face < mesh.num_faces(); ++face) {
    for (const draco::PointIndex& corner : mesh.face(draco::FaceIndex(face))) {
      made.corners.push_back(corner.value());
    }
  }
  for (const DracoAttribute& one : wanted) {
    if (Status taken = takeAttribute(mesh, one, made); !taken) {
      return taken.error();
    }
  }
  if (made.vertexCount == 0 || made.corners.empty()) {
    return undecodable("holds Draco data without triangles");
  }
  return made;
}

} // namespace

Result<DracoMesh> decodeDraco(std::span<const std::uint8_t> bytes, std::span<const DracoAttribute> wanted,
                              std::size_t mostBytes) {
  try {
    const Result<std::unique_ptr<draco::Mesh>> mesh = dracoMesh(bytes, mostBytes);
    return mesh ? takenApart(**mesh, wanted) : mesh.error();
  } catch (const std::exception&) { // of the library: memory that is not there
    return undecodable("holds Draco data that cannot be decoded");
  }
}

} // namespace stretch::gltf
