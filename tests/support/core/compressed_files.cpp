#include "tests/support/core/compressed_files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include <draco/compression/expert_encode.h>
#include <draco/mesh/mesh.h>
#include <meshoptimizer.h>

namespace stretch::test {

namespace {

using gltf::Bytes;
using gltf::Json;

constexpr int rings = 24;
constexpr int sides = 12;
constexpr double fullTurn = 6.283185307179586;

struct TubeVertices {
  std::vector<float> positions;
  std::vector<std::int8_t> normals; // padded to four
  std::vector<float> texCoords;
  std::vector<std::uint8_t> joints;
  std::vector<float> weights;
  std::vector<std::uint16_t> corners;
};

std::int8_t rounded(double value) {
  return static_cast<std::int8_t>(std::lround(value * 127.0));
}

void addTubeVertex(int ring, int side, TubeVertices& tube) {
  const double along = static_cast<double>(ring) / (rings - 1);
  const double angle = fullTurn * side / sides;
  const double radius = 0.2 + 0.05 * std::sin(5.0 * along);
  tube.positions.insert(tube.positions.end(),
                        {static_cast<float>(radius * std::cos(angle)), static_cast<float>(2.0 * along),
                         static_cast<float>(radius * std::sin(angle))});
  tube.normals.insert(tube.normals.end(), {rounded(std::cos(angle)), 0, rounded(std::sin(angle)), 0});
  tube.texCoords.insert(tube.texCoords.end(), {static_cast<float>(side) / sides, static_cast<float>(along)});
  const bool isUpper = along > 0.5;
  const auto lower = static_cast<std::uint8_t>(isUpper ? 1 : 0);
  const auto share = static_cast<float>(isUpper ? 2.0 * along - 1.0 : 2.0 * along);
  tube.joints.insert(tube.joints.end(), {lower, static_cast<std::uint8_t>(lower + 1), 0, 0});
  tube.weights.insert(tube.weights.end(), {1.0F - share, share, 0.0F, 0.0F});
}

TubeVertices tubeVertices() {
  TubeVertices tube;
  for (int ring = 0; ring < rings; ++ring) {
    for (int side = 0; side < sides; ++side) {
      addTubeVertex(ring, side, tube);
      const int next = (side + 1) % sides;
      if (ring + 1 < rings) {
        for (const int corner : {ring * sides + side, (ring + 1) * sides + side, ring * sides + next,
                                 ring * sides + next, (ring + 1) * sides + side, (ring + 1) * sides + next}) {
          tube.corners.push_back(static_cast<std::uint16_t>(corner));
        }
      }
    }
  }
  return tube;
}

Json& accessorOf(GlbBuilder& glb, int accessor) {
  return glb.json["accessors"][static_cast<std::size_t>(accessor)];
}

// Rotations as shorts, which a quarter of turns and none survive.
void quantizeRotations(GlbBuilder& glb) {
  const float half = 0.70710678F;
  std::vector<std::int16_t> shorts;
  for (const float value : {0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, half, half, 0.0F, 0.0F, 0.0F, 1.0F}) {
    shorts.push_back(static_cast<std::int16_t>(std::lround(value * 32767.0F)));
  }
  const int turns = glb.accessor(shorts, 5122, "VEC4", 4);
  accessorOf(glb, turns)["normalized"] = true;
  glb.json["animations"][0]["samplers"][0]["output"] = turns;
}

void noteBounds(const std::vector<float>& positions, Json& accessor) {
  std::array<float, 3> least{9, 9, 9};
  std::array<float, 3> most{-9, -9, -9};
  for (std::size_t i = 0; i < positions.size(); ++i) {
    least[i % 3] = std::min(least[i % 3], positions[i]);
    most[i % 3] = std::max(most[i % 3], positions[i]);
  }
  accessor["min"] = least;
  accessor["max"] = most;
}

std::size_t strideOf(const Json& view, const Json& accessor) {
  return view.at("byteLength").get<std::size_t>() / accessor.at("count").get<std::size_t>();
}

const Json& accessorOfView(const GlbBuilder& glb, std::size_t view) {
  for (const Json& accessor : glb.json.at("accessors")) {
    if (accessor.at("bufferView") == view) {
      return accessor;
    }
  }
  throw std::logic_error("a view without an accessor");
}

Bytes viewBytes(const GlbBuilder& glb, const Json& view) {
  const auto start = static_cast<std::ptrdiff_t>(view.at("byteOffset").get<std::size_t>());
  const auto length = static_cast<std::ptrdiff_t>(view.at("byteLength").get<std::size_t>());
  return {glb.binary.begin() + start, glb.binary.begin() + start + length};
}

template <typename Number>
std::vector<float> asFloats(const Bytes& bytes, float one) {
  std::vector<float> values;
  for (std::size_t i = 0; i + sizeof(Number) <= bytes.size(); i += sizeof(Number)) {
    Number value{};
    std::memcpy(&value, bytes.data() + i, sizeof value);
    values.push_back(static_cast<float>(value) / one);
  }
  return values;
}

// What the filter of such an accessor makes of its bytes; "NONE" leaves them.
std::string filtered(const Json& accessor, std::size_t count, std::size_t stride, Bytes& bytes) {
  const int component = accessor.at("componentType").get<int>();
  if (component == 5120 && stride == 4) {
    std::vector<float> normals = asFloats<std::int8_t>(bytes, 127.0F);
    meshopt_encodeFilterOct(bytes.data(), count, stride, 8, normals.data());
    return "OCTAHEDRAL";
  }
  if (component == 5122 && stride == 8) {
    const std::vector<float> turns = asFloats<std::int16_t>(bytes, 32767.0F);
    meshopt_encodeFilterQuat(bytes.data(), count, stride, 16, turns.data());
    return "QUATERNION";
  }
  if (component == 5126 && accessor.at("type") == "VEC3") {
    const std::vector<float> values = asFloats<float>(bytes, 1.0F);
    meshopt_encodeFilterExp(bytes.data(), count, stride, 20, values.data());
    return "EXPONENTIAL";
  }
  return "NONE";
}

Bytes meshoptAttributes(const Bytes& bytes, std::size_t count, std::size_t stride) {
  Bytes packed(meshopt_encodeVertexBufferBound(count, stride));
  packed.resize(meshopt_encodeVertexBuffer(packed.data(), packed.size(), bytes.data(), count, stride));
  return packed;
}

Bytes meshoptIndices(const Bytes& bytes, bool areTriangles) {
  std::vector<unsigned> corners;
  for (const float value : asFloats<std::uint16_t>(bytes, 1.0F)) {
    corners.push_back(static_cast<unsigned>(value));
  }
  constexpr std::size_t vertices = rings * sides;
  Bytes packed(areTriangles ? meshopt_encodeIndexBufferBound(corners.size(), vertices)
                            : meshopt_encodeIndexSequenceBound(corners.size(), vertices));
  packed.resize(
      areTriangles
          ? meshopt_encodeIndexBuffer(packed.data(), packed.size(), corners.data(), corners.size())
          : meshopt_encodeIndexSequence(packed.data(), packed.size(), corners.data(), corners.size()));
  return packed;
}

std::size_t appendAligned(const Bytes& bytes, Bytes& binary) {
  const std::size_t offset = (binary.size() + 3) / 4 * 4;
  binary.resize(offset);
  binary.insert(binary.end(), bytes.begin(), bytes.end());
  return offset;
}

void use(const char* extension, GlbBuilder& glb) {
  glb.json["extensionsUsed"].push_back(extension);
  glb.json["extensionsRequired"].push_back(extension);
}

// Packs one view; answers its extension.
Json packView(const GlbBuilder& plain, std::size_t index, Filters filters, Bytes& packed) {
  const Json& view = plain.json.at("bufferViews").at(index);
  const Json& accessor = accessorOfView(plain, index);
  const auto count = accessor.at("count").get<std::size_t>();
  const std::size_t stride = strideOf(view, accessor);
  Bytes bytes = viewBytes(plain, view);
  Json extension = {{"byteStride", stride}, {"count", count}};
  if (stride == 2) {
    const bool areTriangles = filters == Filters::all;
    extension["mode"] = areTriangles ? "TRIANGLES" : "INDICES";
    packed = meshoptIndices(bytes, areTriangles);
    return extension;
  }
  extension["mode"] = "ATTRIBUTES";
  if (filters == Filters::all) {
    extension["filter"] = filtered(accessor, count, stride, bytes);
  }
  packed = meshoptAttributes(bytes, count, stride);
  return extension;
}

draco::DataType dracoType(int component) {
  switch (component) {
  case 5120:
    return draco::DT_INT8;
  case 5121:
    return draco::DT_UINT8;
  default:
    return draco::DT_FLOAT32;
  }
}

struct Packing {
  draco::Mesh mesh;
  Json ids = Json::object();
};

void addDracoAttribute(const GlbBuilder& plain, const std::string& name, const Json& accessor,
                       Packing& made) {
  using draco::GeometryAttribute;
  const Json& view = plain.json.at("bufferViews").at(accessor.at("bufferView").get<std::size_t>());
  const Bytes bytes = viewBytes(plain, view);
  const auto count = accessor.at("count").get<std::size_t>();
  const std::size_t stride = strideOf(view, accessor);
  const int width = accessor.at("type").get<std::string>()[3] - '0';
  const draco::DataType type = dracoType(accessor.at("componentType").get<int>());
  const GeometryAttribute::Type kind = name == "POSITION"     ? GeometryAttribute::POSITION
                                       : name == "TEXCOORD_0" ? GeometryAttribute::TEX_COORD
                                                              : GeometryAttribute::GENERIC;
  GeometryAttribute attribute;
  attribute.Init(kind, nullptr, static_cast<std::int8_t>(width), type, accessor.value("normalized", false),
                 draco::DataTypeLength(type) * width, 0);
  const int id = made.mesh.AddAttribute(attribute, true, static_cast<std::uint32_t>(count));
  for (std::uint32_t i = 0; i < count; ++i) {
    made.mesh.attribute(id)->SetAttributeValue(draco::AttributeValueIndex(i), bytes.data() + i * stride);
  }
  made.ids[name] = made.mesh.attribute(id)->unique_id();
}

void addDracoFaces(const GlbBuilder& plain, const Json& accessor, draco::Mesh& mesh) {
  const Json& view = plain.json.at("bufferViews").at(accessor.at("bufferView").get<std::size_t>());
  const std::vector<float> corners = asFloats<std::uint16_t>(viewBytes(plain, view), 1.0F);
  mesh.SetNumFaces(corners.size() / 3);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    draco::Mesh::Face face = mesh.face(draco::FaceIndex(static_cast<std::uint32_t>(i / 3)));
    face[i % 3] = static_cast<std::uint32_t>(corners[i]);
    mesh.SetFace(draco::FaceIndex(static_cast<std::uint32_t>(i / 3)), face);
  }
}

} // namespace

GlbBuilder tubeBuilder() {
  GlbBuilder glb = armBuilder();
  const TubeVertices tube = tubeVertices();
  const int positions = glb.floats(tube.positions, "VEC3", 3);
  noteBounds(tube.positions, accessorOf(glb, positions));
  const int normals = glb.accessor(tube.normals, 5120, "VEC4", 4);
  accessorOf(glb, normals)["type"] = "VEC3";
  accessorOf(glb, normals)["normalized"] = true;
  glb.json["bufferViews"].back()["byteStride"] = 4;
  const int texCoords = glb.floats(tube.texCoords, "VEC2", 2);
  const int joints = glb.accessor(tube.joints, 5121, "VEC4", 4);
  const int weights = glb.floats(tube.weights, "VEC4", 4);
  const int corners = glb.accessor(tube.corners, 5123, "SCALAR", 1);
  glb.json["meshes"][0]["primitives"][0] = {{"attributes",
                                             {{"POSITION", positions},
                                              {"NORMAL", normals},
                                              {"TEXCOORD_0", texCoords},
                                              {"JOINTS_0", joints},
                                              {"WEIGHTS_0", weights}}},
                                            {"indices", corners},
                                            {"material", 0}};
  quantizeRotations(glb);
  use("KHR_mesh_quantization", glb);
  return glb;
}

GlbBuilder packedByMeshopt(const GlbBuilder& plain, Filters filters) {
  GlbBuilder result = plain;
  result.binary.clear();
  std::size_t fallbackBytes = 0;
  for (std::size_t i = 0; i < plain.json.at("bufferViews").size(); ++i) {
    Bytes packed;
    Json extension = packView(plain, i, filters, packed);
    extension["buffer"] = 0;
    extension["byteOffset"] = appendAligned(packed, result.binary);
    extension["byteLength"] = packed.size();
    Json& view = result.json["bufferViews"][i];
    view["buffer"] = 1;
    view["byteOffset"] = fallbackBytes;
    view["extensions"]["EXT_meshopt_compression"] = std::move(extension);
    fallbackBytes = (fallbackBytes + view["byteLength"].get<std::size_t>() + 3) / 4 * 4;
  }
  result.json["buffers"] = {
      Json::object(),
      {{"byteLength", fallbackBytes}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}}};
  use("EXT_meshopt_compression", result);
  return result;
}

GlbBuilder packedByDraco(const GlbBuilder& plain, DracoMethod method) {
  GlbBuilder result = plain;
  Json& primitive = result.json["meshes"][0]["primitives"][0];
  Packing packing;
  for (const auto& [name, accessor] : primitive["attributes"].items()) {
    addDracoAttribute(plain, name, plain.json.at("accessors").at(accessor.get<std::size_t>()), packing);
  }
  addDracoFaces(plain, plain.json.at("accessors").at(primitive["indices"].get<std::size_t>()), packing.mesh);
  packing.mesh.set_num_points(rings * sides);
  draco::ExpertEncoder encoder(packing.mesh);
  encoder.SetEncodingMethod(method == DracoMethod::sequential ? draco::MESH_SEQUENTIAL_ENCODING
                                                              : draco::MESH_EDGEBREAKER_ENCODING);
  encoder.SetAttributeQuantization(packing.ids["POSITION"].get<int>(), 14);
  encoder.SetAttributeQuantization(packing.ids["TEXCOORD_0"].get<int>(), 12);
  encoder.SetTrackEncodedProperties(true);
  draco::EncoderBuffer encoded;
  if (!encoder.EncodeToBuffer(&encoded).ok()) {
    throw std::logic_error("the tube cannot be packed");
  }
  const Bytes packed(encoded.data(), encoded.data() + encoded.size());
  for (const auto& [name, accessor] : primitive["attributes"].items()) {
    result.json["accessors"][accessor.get<std::size_t>()].erase("bufferView");
    result.json["accessors"][accessor.get<std::size_t>()]["count"] = encoder.num_encoded_points();
  }
  result.json["accessors"][primitive["indices"].get<std::size_t>()].erase("bufferView");
  const std::size_t offset = appendAligned(packed, result.binary);
  const std::size_t view = result.json["bufferViews"].size();
  result.json["bufferViews"].push_back(
      {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", packed.size()}});
  primitive["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", view}, {"attributes", packing.ids}};
  use("KHR_draco_mesh_compression", result);
  return result;
}

} // namespace stretch::test
