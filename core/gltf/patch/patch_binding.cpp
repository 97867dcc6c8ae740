#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "core/gltf/import/accessor.h"
#include "core/gltf/import/import.h"
#include "core/gltf/json/json.h"
#include "core/gltf/patch/patch_parts.h"
#include "core/gltf/source/fields.h"

namespace stretch::gltf {

namespace {

using Pointer = Json::json_pointer;

constexpr std::size_t slotsOfSet = 4; // joints that JOINTS_0 and WEIGHTS_0 name for a vertex
constexpr std::array setNames{std::pair("JOINTS_0", "WEIGHTS_0"), std::pair("JOINTS_1", "WEIGHTS_1")};

void appendSkin(const AddedSkin& skin, Journal& journal, AppendedData& data) {
  std::vector<float> numbers(skin.joints.size() * matrixSize);
  Json joints = Json::array();
  for (std::size_t i = 0; i < skin.joints.size(); ++i) {
    store(skin.inverseBind[i], numbers.data() + i * matrixSize);
    joints.push_back(skin.joints[i].value);
  }
  const std::size_t matrices = data.add(AppendedData::Use::inverseBind, "MAT4", matrixSize, numbers, false);
  Json json = Json::object();
  if (!skin.name.empty()) {
    json["name"] = skin.name;
  }
  json["inverseBindMatrices"] = matrices;
  json["joints"] = std::move(joints);
  journal.append(Pointer("/skins"), std::move(json));
}

// JOINTS_1, WEIGHTS_1 and so on, and every set of them that is compressed.
bool isInfluenceSet(const std::string& attribute) {
  return attribute.starts_with("JOINTS_") || attribute.starts_with("WEIGHTS_");
}

void dropSets(const Pointer& attributes, Journal& journal) {
  if (!journal.json().contains(attributes)) {
    return;
  }
  std::vector<std::string> names;
  for (const auto& [name, accessor] : journal.json().at(attributes).items()) {
    if (isInfluenceSet(name)) {
      names.push_back(name);
    }
  }
  for (const std::string& name : names) {
    journal.erase(attributes / name);
  }
}

class MeshBinding {
public:
  MeshBinding(const std::vector<BoundMesh>& bound, Journal& journal, AppendedData& data)
      : journal_(journal), data_(data), source_(journal.json()) {
    for (const BoundMesh& one : bound) {
      boundNodes_.insert(one.node);
    }
  }

  void bind(const BoundMesh& bound) {
    const Pointer node = Pointer("/nodes") / at(bound.node);
    const auto mesh = static_cast<std::size_t>(indexOr(journal_.json().at(node), "mesh"));
    const bool staysOnSkin = indexOr(journal_.json().at(node), "skin") == bound.skin;
    const std::size_t own = ownMesh(mesh);
    if (own != mesh) {
      journal_.set(node / "mesh", own);
    }
    std::size_t shown = 0;
    const Json primitives = element(source_, "meshes", mesh)["primitives"];
    const std::map<int, std::size_t> triangles = trianglesByPlaces(element(source_, "meshes", mesh));
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      const Json* const position = findPath(primitives[i], {"attributes", "POSITION"});
      if (position == nullptr) {
        continue;
      }
      const auto accessor = position->get<std::size_t>();
      const std::size_t vertices = wholeOr(element(source_, "accessors", accessor), "count", 0);
      const Pointer place = Pointer("/meshes") / own / "primitives" / i;
      const auto sharing = triangles.find(static_cast<int>(accessor));
      if (holdsTriangles(primitives[i])) {
        point(place, accessor, bound.influences[shown++]);
      } else if (sharing != triangles.end()) { // an outline of them
        point(place, accessor, bound.influences[sharing->second]);
      } else if (!staysOnSkin) {
        VertexInfluences first;
        first.weights[0] = 1.0F;
        point(place, accessor, std::vector<VertexInfluences>(vertices, first));
      }
    }
    journal_.set(node / "skin", bound.skin);
  }

private:
  struct WrittenSet {
    std::size_t joints = 0;
    std::size_t weights = 0;
    std::vector<std::uint16_t> jointNumbers;
    std::vector<float> weightNumbers;
  };

  // The mesh itself for the first node of those that show it, where all of them are bound; else a copy.
  std::size_t ownMesh(std::size_t mesh) {
    bool areAllBound = true;
    for (std::size_t node = 0; node < sizeOf(source_, "nodes"); ++node) {
      areAllBound =
          areAllBound && (indexOr(element(source_, "nodes", node), "mesh") != static_cast<int>(mesh) ||
                          boundNodes_.contains(NodeIndex(node)));
    }
    if (areAllBound && taken_.insert(mesh).second) {
      return mesh;
    }
    return journal_.append(Pointer("/meshes"), Json(element(source_, "meshes", mesh)));
  }

  // Primitives that share their vertices share what those follow, too.
  const WrittenSet& written(std::size_t positions, std::size_t set,
                            const std::vector<VertexInfluences>& influences) {
    WrittenSet made;
    for (const VertexInfluences& vertex : influences) {
      for (std::size_t i = set * slotsOfSet; i < (set + 1) * slotsOfSet; ++i) {
        const bool isUsed = vertex.weights[i] > 0.0F; // glTF wants unused slots to name joint 0
        made.jointNumbers.push_back(isUsed ? vertex.joints[i] : std::uint16_t{0});
        made.weightNumbers.push_back(isUsed ? vertex.weights[i] : 0.0F);
      }
    }
    std::vector<WrittenSet>& known = written_[positions];
    for (const WrittenSet& other : known) {
      if (other.jointNumbers == made.jointNumbers && other.weightNumbers == made.weightNumbers) {
        return other;
      }
    }
    made.joints = data_.addJoints(made.jointNumbers);
    made.weights = data_.add(AppendedData::Use::weights, "VEC4", slotsOfSet, made.weightNumbers, false);
    known.push_back(std::move(made));
    return known.back();
  }

  void point(const Pointer& primitive, std::size_t positions,
             const std::vector<VertexInfluences>& influences) {
    dropSets(primitive / "attributes", journal_);
    dropSets(primitive / "extensions" / "KHR_draco_mesh_compression" / "attributes", journal_);
    if (influences.empty()) {
      return;
    }
    const bool needsSecond = std::ranges::any_of(
        influences, [](const VertexInfluences& vertex) { return vertex.weights[slotsOfSet] > 0.0F; });
    for (std::size_t set = 0; set < (needsSecond ? setNames.size() : 1); ++set) {
      const WrittenSet& accessors = written(positions, set, influences);
      journal_.set(primitive / "attributes" / setNames[set].first, accessors.joints);
      journal_.set(primitive / "attributes" / setNames[set].second, accessors.weights);
    }
  }

  Journal& journal_;
  AppendedData& data_;
  const Json source_; // before any mesh was bound
  std::set<NodeIndex> boundNodes_;
  std::set<std::size_t> taken_;
  std::map<std::size_t, std::vector<WrittenSet>> written_; // by accessor of the positions
};

// Marks all that an extension may name: every whole number in it.
void markNumbers(const Json& json, std::set<int>& numbers) {
  if (json.is_number_integer()) {
    numbers.insert(json.get<int>());
  } else if (json.is_structured()) {
    for (const Json& part : json) {
      markNumbers(part, numbers);
    }
  }
}

// Accessors that extensions of meshes and their primitives may use.
std::set<int> namedByExtensions(const Json& json) {
  std::set<int> numbers;
  for (std::size_t i = 0; i < sizeOf(json, "meshes"); ++i) {
    const Json& mesh = element(json, "meshes", i);
    markNumbers(mesh.value("extensions", Json()), numbers);
    for (std::size_t k = 0; k < sizeOf(mesh, "primitives"); ++k) {
      markNumbers(element(mesh, "primitives", k).value("extensions", Json()), numbers);
    }
  }
  return numbers;
}

// Weights that nothing names any more are emptied, so that no reader finds fault with them: zeros, without
// data.
void emptyUnusedWeights(std::set<int> before, Journal& journal) {
  const std::vector<bool> used = usedAccessors(journal.json());
  std::erase_if(before, [named = namedByExtensions(journal.json())](int one) { return named.contains(one); });
  for (const int accessor : before) {
    const Pointer place = Pointer("/accessors") / static_cast<std::size_t>(accessor);
    for (const char* const name : {"bufferView", "byteOffset", "sparse", "min", "max"}) {
      if (!used[static_cast<std::size_t>(accessor)] && journal.json().at(place).contains(name)) {
        journal.erase(place / name);
      }
    }
  }
}

} // namespace

void patchBinding(const Edits& edits, Journal& journal, AppendedData& data) {
  for (const AddedSkin& skin : edits.addedSkins) {
    appendSkin(skin, journal, data);
  }
  if (edits.boundMeshes.empty()) {
    return;
  }
  std::set<int> before = weightAccessors(journal.json());
  MeshBinding binding(edits.boundMeshes, journal, data);
  const std::size_t skinsBefore = sizeOf(journal.json(), "skins") - edits.addedSkins.size();
  for (const BoundMesh& bound : edits.boundMeshes) {
    binding.bind(bound);
    if (const auto skin = static_cast<std::size_t>(bound.skin); skin >= skinsBefore) {
      showJoints(skin, bound.node, journal);
    }
  }
  emptyUnusedWeights(std::move(before), journal);
}

} // namespace stretch::gltf
