#include <cstring>
#include <map>

#include <fmt/core.h>

#include "core/gltf/import/accessor.h"
#include "core/gltf/packed/draco_mesh.h"
#include "core/gltf/source/fields.h"
#include "core/gltf/source/plain_parts.h"

namespace stretch::gltf {

namespace {

constexpr const char* meshCompression = "KHR_draco_mesh_compression";

const Json* compressedMesh(const Json& primitive) {
  return findPath(primitive, {"extensions", meshCompression});
}

// Which compressed data an accessor was filled from.
struct Origin {
  int view = -1;
  std::uint32_t attribute = 0;

  friend bool operator==(const Origin&, const Origin&) = default;
};

class MeshOpening {
public:
  MeshOpening(PlainSource& plain, Problems& problems)
      : plain_(plain), json_(*plain.source.json), problems_(problems) {}

  void open(Json& primitive, const std::string& place) {
    const Json compressed = *compressedMesh(primitive); // a copy: what it stands in is changed
    where_ = fmt::format("{}.extensions.{}", place, meshCompression);
    view_ = indexOr(compressed, "bufferView");
    const std::optional<std::span<const std::uint8_t>> bytes = bytesOfView();
    if (!bytes || !find(primitive, "attributes")->is_object() || !collectWanted(compressed, primitive)) {
      return;
    }
    const Result<DracoMesh> decoded = decodeDraco(*bytes, wanted_, bytesLeftToDecode(plain_));
    if (!decoded) {
      problems_.error(where_, decoded.error().what, decoded.error().remedy);
      return;
    }
    for (std::size_t i = 0; i < wanted_.size(); ++i) {
      const auto accessor = static_cast<std::size_t>(indexOr(primitive["attributes"], names_[i]));
      primitive["attributes"][names_[i]] =
          fill(accessor, {view_, wanted_[i].id}, decoded->vertexCount, decoded->attributes[i]);
    }
    placeCorners(primitive, *decoded);
    primitive["extensions"].erase(meshCompression);
  }

private:
  std::optional<std::span<const std::uint8_t>> bytesOfView() {
    const bool isThere = view_ >= 0 && static_cast<std::size_t>(view_) < sizeOf(json_, "bufferViews");
    const std::optional<std::span<const std::uint8_t>> bytes =
        isThere ? namedBytes(plain_.source, element(json_, "bufferViews", static_cast<std::size_t>(view_)))
                : std::nullopt;
    if (!bytes) {
      problems_.error(where_, "names bytes that are not there");
    }
    return bytes;
  }

  bool collectWanted(const Json& compressed, const Json& primitive) {
    wanted_.clear();
    names_.clear();
    const Json* attributes = find(compressed, "attributes");
    if (attributes == nullptr || !attributes->is_object()) {
      problems_.error(where_ + ".attributes", "is no object");
      return false;
    }
    for (const auto& [name, id] : attributes->items()) {
      const int accessor = indexOr(*find(primitive, "attributes"), name);
      const std::optional<std::uint64_t> number = wholeNumber(id);
      const std::optional<AccessorShape> shape =
          accessor < 0 ? std::nullopt : shapeOf(plain_.source, accessor);
      if (!number || *number > 0xFFFFFFFFU || !shape || shape->width > 4) {
        problems_.error(fmt::format("{}.attributes.{}", where_, name.substr(0, 100)),
                        "is not an attribute of the primitive");
        return false;
      }
      wanted_.push_back({static_cast<std::uint32_t>(*number), shape->width, shape->component});
      names_.push_back(name);
    }
    return true;
  }

  // The accessor itself where nothing else gives it values, else a copy of it at the end.
  std::size_t fill(std::size_t accessor, Origin origin, std::size_t count, Bytes bytes) {
    const auto known = origins_.find(accessor);
    if (known != origins_.end() && known->second == origin) {
      return accessor;
    }
    if (known != origins_.end() || find(element(json_, "accessors", accessor), "bufferView") != nullptr) {
      const Json copy = element(json_, "accessors", accessor);
      json_["accessors"].push_back(copy);
      accessor = json_["accessors"].size() - 1;
    }
    origins_[accessor] = origin;
    plain_.roundedAccessors.insert(accessor);
    restateCount(accessor, count);
    pointAccessor(accessor, std::move(bytes));
    return accessor;
  }

  void restateCount(std::size_t accessor, std::size_t count) {
    Json& json = json_["accessors"][accessor];
    if (const std::uint64_t said = wholeOr(json, "count", 0); said != count) {
      problems_.warning(
          at("accessors", accessor),
          fmt::format("says {} elements, but its compressed data hold {}, which are read", said, count));
      json["count"] = count;
    }
  }

  void pointAccessor(std::size_t accessor, Bytes bytes) {
    const std::size_t size = bytes.size();
    const std::size_t buffer = addPlainBuffer(plain_, std::move(bytes));
    json_["bufferViews"].push_back({{"buffer", buffer}, {"byteLength", size}});
    Json& json = json_["accessors"][accessor];
    json["bufferView"] = json_["bufferViews"].size() - 1;
    json.erase("byteOffset");
    json.erase("sparse");
  }

  // A list of triangles, whatever the primitive called it.
  void placeCorners(Json& primitive, const DracoMesh& decoded) {
    Bytes bytes(decoded.corners.size() * sizeof(std::uint32_t));
    std::memcpy(bytes.data(), decoded.corners.data(), bytes.size());
    const int said = indexOr(primitive, "indices");
    const bool isList = indexOr(primitive, "mode", 4) == 4;
    if (said >= 0 && isList) {
      const std::size_t accessor = fill(static_cast<std::size_t>(said), {view_, cornersOrigin},
                                        decoded.corners.size(), std::move(bytes));
      json_["accessors"][accessor]["componentType"] = static_cast<int>(ComponentType::uint32);
      primitive["indices"] = accessor;
      return;
    }
    json_["accessors"].push_back({{"componentType", static_cast<int>(ComponentType::uint32)},
                                  {"count", decoded.corners.size()},
                                  {"type", "SCALAR"}});
    pointAccessor(json_["accessors"].size() - 1, std::move(bytes));
    primitive["indices"] = json_["accessors"].size() - 1;
    primitive["mode"] = 4;
  }

  static constexpr std::uint32_t cornersOrigin = 0xFFFFFFFFU; // no id that encoders give

  PlainSource& plain_;
  Json& json_;
  Problems& problems_;
  std::string where_;
  int view_ = -1;
  std::vector<DracoAttribute> wanted_;
  std::vector<std::string> names_;
  std::map<std::size_t, Origin> origins_;
};

} // namespace

bool hasCompressedMeshes(const Json& json) {
  for (std::size_t i = 0; i < sizeOf(json, "meshes"); ++i) {
    const Json& mesh = element(json, "meshes", i);
    for (std::size_t k = 0; k < sizeOf(mesh, "primitives"); ++k) {
      if (compressedMesh(element(mesh, "primitives", k)) != nullptr) {
        return true;
      }
    }
  }
  return false;
}

void openMeshes(PlainSource& plain, Problems& problems) {
  MeshOpening opening(plain, problems);
  const Json& json = plain.source.json;
  for (std::size_t i = 0; i < sizeOf(json, "meshes"); ++i) {
    for (std::size_t k = 0; k < sizeOf(element(json, "meshes", i), "primitives"); ++k) {
      Json& primitive = (*plain.source.json)["meshes"][i]["primitives"][k];
      if (compressedMesh(primitive) != nullptr) {
        opening.open(primitive, at(at("meshes", i) + ".primitives", k));
      }
    }
  }
}

} // namespace stretch::gltf
