#include "core/interchange/figure_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>

#include <assimp/scene.h>
#include <glm/gtc/matrix_transform.hpp>

#include "core/gltf/json/json.h"
#include "core/interchange/assimp_values.h"
#include "core/math/finite.h"

namespace stretch::interchange {

namespace {

using gltf::Json;

constexpr std::size_t influencesOfSet = 4;
constexpr std::size_t mostInfluences = 8;

struct SkinJoint {
  std::size_t node = 0;
  Mat4 inverseBind{1.0};
};

// Meshes of one node that share a skin, or have none.
struct MeshGroup {
  std::vector<unsigned> meshes;
  std::vector<SkinJoint> joints; // Of all of them; empty without a skin.
};

float sound(float number) {
  return std::isfinite(number) ? number : 0.0F;
}

Vec3 soundVector(const aiVector3D& v) {
  return {sound(v.x), sound(v.y), sound(v.z)};
}

void appendVector(const Vec3& v, std::vector<float>& to) {
  to.insert(to.end(), {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)});
}

std::vector<float> positionsOf(const aiVector3D* from, unsigned count, double lengths) {
  std::vector<float> values;
  values.reserve(std::size_t{count} * 3);
  for (unsigned v = 0; v < count; ++v) {
    appendVector(lengths * soundVector(from[v]), values);
  }
  return values;
}

std::vector<float> normalsOf(const aiVector3D* from, unsigned count) {
  std::vector<float> values;
  values.reserve(std::size_t{count} * 3);
  for (unsigned v = 0; v < count; ++v) {
    const Vec3 normal = soundVector(from[v]);
    const double length = glm::length(normal);
    appendVector(length > 1e-9 ? normal / length : Vec3(0.0, 1.0, 0.0), values);
  }
  return values;
}

std::vector<float> differencesOf(const aiVector3D* to, const aiVector3D* from, unsigned count,
                                 double lengths) {
  std::vector<float> values;
  values.reserve(std::size_t{count} * 3);
  for (unsigned v = 0; v < count; ++v) {
    appendVector(lengths * (soundVector(to[v]) - soundVector(from[v])), values);
  }
  return values;
}

Json targetsOf(const aiMesh& mesh, double lengths, GlbParts& parts) {
  Json targets = Json::array();
  for (unsigned t = 0; t < mesh.mNumAnimMeshes; ++t) {
    const aiAnimMesh& target = *mesh.mAnimMeshes[t];
    const bool isMoved = target.mVertices != nullptr && target.mNumVertices == mesh.mNumVertices;
    const std::vector<float> moved =
        isMoved ? differencesOf(target.mVertices, mesh.mVertices, mesh.mNumVertices, lengths)
                : std::vector<float>(std::size_t{mesh.mNumVertices} * 3);
    Json written{{"POSITION", parts.addFloats(moved, "VEC3", true)}};
    if (isMoved && target.mNormals != nullptr && mesh.mNormals != nullptr) {
      written["NORMAL"] =
          parts.addFloats(differencesOf(target.mNormals, mesh.mNormals, mesh.mNumVertices, 1.0), "VEC3");
    }
    targets.push_back(std::move(written));
  }
  return targets;
}

Json attributesOf(const aiMesh& mesh, double lengths, GlbParts& parts) {
  Json attributes{
      {"POSITION", parts.addFloats(positionsOf(mesh.mVertices, mesh.mNumVertices, lengths), "VEC3", true)}};
  if (mesh.mNormals != nullptr) {
    attributes["NORMAL"] = parts.addFloats(normalsOf(mesh.mNormals, mesh.mNumVertices), "VEC3");
  }
  for (unsigned set = 0; set < AI_MAX_NUMBER_OF_TEXTURECOORDS && mesh.HasTextureCoords(set); ++set) {
    std::vector<float> values;
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      values.insert(values.end(),
                    {sound(mesh.mTextureCoords[set][v].x), sound(mesh.mTextureCoords[set][v].y)});
    }
    attributes["TEXCOORD_" + std::to_string(set)] = parts.addFloats(values, "VEC2");
  }
  if (mesh.HasVertexColors(0)) {
    std::vector<float> values;
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      const aiColor4D& c = mesh.mColors[0][v];
      values.insert(values.end(), {sound(c.r), sound(c.g), sound(c.b), sound(c.a)});
    }
    attributes["COLOR_0"] = parts.addFloats(values, "VEC4");
  }
  return attributes;
}

class MeshAdder {
public:
  MeshAdder(const aiScene& scene, const Figure& figure, const std::vector<int>& materials,
            std::vector<gltf::JsonDocument>& nodes, GlbParts& parts)
      : scene_(scene), figure_(figure), materials_(materials), nodes_(nodes), parts_(parts) {
    notes_.nodeOfMesh.assign(scene.mNumMeshes, -1);
  }

  MeshNotes addAll() {
    for (std::size_t i = 0; i < figure_.nodes.size(); ++i) {
      const std::vector<MeshGroup> groups = groupsOf(i);
      for (std::size_t g = 0; g < groups.size(); ++g) {
        addGroup(groups[g], i, g == 0 ? i : addChild(i, figure_.nodes[i].name));
      }
    }
    return std::move(notes_);
  }

private:
  std::size_t addChild(std::size_t parent, const std::string& name) {
    nodes_.emplace_back(Json{{"name", name}});
    (*nodes_[parent])["children"].push_back(nodes_.size() - 1);
    parentsOfAdded_.push_back(static_cast<int>(parent));
    return nodes_.size() - 1;
  }

  // A bone's matrix in the figure's units: from vertices scaled by one factor to a joint scaled by another.
  // What places a mesh on its node, and nothing below that, is not in the library's matrix.
  [[nodiscard]] SkinJoint jointOf(const aiBone& bone, std::size_t joint, const FigureNode& meshNode) const {
    Mat4 matrix = matrixOf(bone.mOffsetMatrix);
    matrix = isFinite(matrix) ? matrix : Mat4(1.0);
    for (const aiNode* const element : meshNode.chain) {
      if (std::string_view(element->mName.C_Str()).find("_$AssimpFbx$_Geometric") != std::string_view::npos) {
        matrix = matrix * restOf(*element);
      }
    }
    return {joint, glm::scale(Mat4(1.0), Vec3(figure_.nodes[joint].lengths)) * matrix *
                       glm::scale(Mat4(1.0), Vec3(1.0 / meshNode.lengths))};
  }

  std::vector<SkinJoint> jointsOf(const aiMesh& mesh, const FigureNode& meshNode) {
    std::vector<SkinJoint> joints;
    for (unsigned b = 0; b < mesh.mNumBones; ++b) {
      const auto found = figure_.byName.find(mesh.mBones[b]->mName.C_Str());
      if (found == figure_.byName.end()) {
        ++notes_.lostBones;
      } else {
        joints.push_back(jointOf(*mesh.mBones[b], static_cast<std::size_t>(found->second), meshNode));
      }
    }
    return joints;
  }

  static const SkinJoint* findJoint(const std::vector<SkinJoint>& joints, std::size_t node) {
    const auto found = std::ranges::find(joints, node, &SkinJoint::node);
    return found == joints.end() ? nullptr : &*found;
  }

  static bool agree(const std::vector<SkinJoint>& a, const std::vector<SkinJoint>& b) {
    constexpr double near = 1e-5;
    return a.empty() == b.empty() && std::ranges::all_of(b, [&](const SkinJoint& joint) {
             const SkinJoint* const other = findJoint(a, joint.node);
             double apart = 0.0;
             for (int column = 0; other != nullptr && column < 4; ++column) {
               apart = std::max(apart, glm::length(other->inverseBind[column] - joint.inverseBind[column]));
             }
             return apart < near * (1.0 + glm::length(joint.inverseBind[3]));
           });
  }

  std::vector<MeshGroup> groupsOf(std::size_t index) {
    const aiNode& node = *figure_.nodes[index].chain.back();
    std::vector<MeshGroup> groups;
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
      const unsigned mesh = node.mMeshes[i];
      if (scene_.mMeshes[mesh]->mNumVertices == 0 || scene_.mMeshes[mesh]->mNumFaces == 0) {
        continue;
      }
      const std::vector<SkinJoint> joints = jointsOf(*scene_.mMeshes[mesh], figure_.nodes[index]);
      auto group =
          std::ranges::find_if(groups, [&](const MeshGroup& one) { return agree(one.joints, joints); });
      if (group == groups.end()) {
        group = groups.insert(groups.end(), MeshGroup{});
      }
      group->meshes.push_back(mesh);
      for (const SkinJoint& joint : joints) {
        if (findJoint(group->joints, joint.node) == nullptr) {
          group->joints.push_back(joint);
        }
      }
      notes_.nodeOfMesh[mesh] =
          notes_.nodeOfMesh[mesh] < 0 ? static_cast<int>(index) : notes_.nodeOfMesh[mesh];
    }
    return groups;
  }

  void addGroup(const MeshGroup& group, std::size_t figureNode, std::size_t node) {
    const double lengths = figure_.nodes[figureNode].lengths;
    std::vector<SkinJoint> joints = group.joints;
    const auto known = meshes_.find({group.meshes, lengths});
    if (joints.empty() && known != meshes_.end()) {
      (*nodes_[node])["mesh"] = known->second;
      return;
    }
    Json primitives = Json::array();
    Json names = Json::array();
    Json weights = Json::array();
    for (const unsigned mesh : group.meshes) {
      primitives.push_back(primitiveOf(*scene_.mMeshes[mesh], lengths, joints, figureNode));
    }
    const aiMesh& first = *scene_.mMeshes[group.meshes.front()];
    for (unsigned t = 0; t < first.mNumAnimMeshes; ++t) {
      names.push_back(first.mAnimMeshes[t]->mName.C_Str());
      weights.push_back(sound(first.mAnimMeshes[t]->mWeight));
    }
    Json mesh{{"name", first.mName.C_Str()}, {"primitives", std::move(primitives)}};
    if (!names.empty()) {
      mesh["weights"] = std::move(weights);
      mesh["extras"] = {{"targetNames", std::move(names)}};
    }
    const std::size_t index = parts_.add("meshes", mesh);
    (*nodes_[node])["mesh"] = index;
    if (joints.empty()) {
      meshes_[{group.meshes, lengths}] = index;
    } else {
      (*nodes_[node])["skin"] = skinOf(joints);
    }
  }

  Json primitiveOf(const aiMesh& mesh, double lengths, std::vector<SkinJoint>& joints,
                   std::size_t figureNode) {
    Json primitive{{"attributes", attributesOf(mesh, lengths, parts_)}};
    std::vector<std::uint32_t> indices;
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      const bool isTriangle =
          face.mNumIndices == 3 &&
          std::all_of(face.mIndices, face.mIndices + 3, [&](unsigned i) { return i < mesh.mNumVertices; });
      if (isTriangle) {
        indices.insert(indices.end(), face.mIndices, face.mIndices + 3);
      }
    }
    primitive["indices"] = parts_.addIndices(indices);
    const int material = mesh.mMaterialIndex < materials_.size() ? materials_[mesh.mMaterialIndex] : -1;
    if (material >= 0) {
      primitive["material"] = material;
    }
    if (mesh.mNumAnimMeshes > 0) {
      primitive["targets"] = targetsOf(mesh, lengths, parts_);
    }
    if (!joints.empty()) {
      addInfluences(mesh, joints, figureNode, primitive["attributes"]);
    }
    return primitive;
  }

  struct Influence {
    std::uint16_t slot = 0;
    float weight = 0.0F;
  };

  // Vertices without a bone stay with the node of their mesh: a joint of their own says so.
  std::uint16_t restSlot(std::vector<SkinJoint>& joints, std::size_t figureNode) {
    auto found = restJoints_.find(figureNode);
    if (found == restJoints_.end()) {
      found =
          restJoints_
              .emplace(figureNode, addChild(figureNode, figure_.nodes[figureNode].name + " without weights"))
              .first;
    }
    const auto known = std::ranges::find(joints, found->second, &SkinJoint::node);
    const auto slot = known - joints.begin();
    if (known == joints.end()) {
      joints.push_back({found->second, Mat4(1.0)});
    }
    return static_cast<std::uint16_t>(slot);
  }

  std::vector<std::vector<Influence>> influencesOf(const aiMesh& mesh,
                                                   const std::vector<SkinJoint>& joints) const {
    std::vector<std::vector<Influence>> influences(mesh.mNumVertices);
    for (unsigned b = 0; b < mesh.mNumBones; ++b) {
      const aiBone& bone = *mesh.mBones[b];
      const auto node = figure_.byName.find(bone.mName.C_Str());
      if (node == figure_.byName.end()) {
        continue;
      }
      const auto slot = std::ranges::find(joints, static_cast<std::size_t>(node->second), &SkinJoint::node) -
                        joints.begin();
      for (unsigned w = 0; w < bone.mNumWeights; ++w) {
        const aiVertexWeight& one = bone.mWeights[w];
        if (one.mVertexId < mesh.mNumVertices && std::isfinite(one.mWeight) && one.mWeight > 0.0F) {
          influences[one.mVertexId].push_back({static_cast<std::uint16_t>(slot), one.mWeight});
        }
      }
    }
    return influences;
  }

  void addInfluences(const aiMesh& mesh, std::vector<SkinJoint>& joints, std::size_t figureNode,
                     Json& attributes) {
    std::vector<std::vector<Influence>> influences = influencesOf(mesh, joints);
    std::size_t most = 0;
    for (std::vector<Influence>& one : influences) {
      if (one.empty()) {
        ++notes_.unweightedVertices;
        one.push_back({restSlot(joints, figureNode), 1.0F});
      }
      std::ranges::stable_sort(one, std::greater{}, &Influence::weight);
      one.resize(std::min(one.size(), mostInfluences));
      float sum = 0.0F;
      for (const Influence& influence : one) {
        sum += influence.weight;
      }
      for (Influence& influence : one) {
        influence.weight /= sum;
      }
      most = std::max(most, one.size());
    }
    for (std::size_t set = 0; set * influencesOfSet < most; ++set) {
      std::vector<std::uint16_t> slots;
      std::vector<float> weights;
      for (const std::vector<Influence>& one : influences) {
        for (std::size_t k = set * influencesOfSet; k < (set + 1) * influencesOfSet; ++k) {
          const Influence influence = k < one.size() ? one[k] : Influence{};
          slots.push_back(influence.slot);
          weights.push_back(influence.weight);
        }
      }
      attributes["JOINTS_" + std::to_string(set)] = parts_.addJoints(slots);
      attributes["WEIGHTS_" + std::to_string(set)] = parts_.addFloats(weights, "VEC4");
    }
  }

  std::size_t skinOf(const std::vector<SkinJoint>& joints) {
    std::vector<std::size_t> list;
    std::vector<float> matrices;
    for (const SkinJoint& joint : joints) {
      list.push_back(joint.node);
      for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
          matrices.push_back(static_cast<float>(joint.inverseBind[column][row]));
        }
      }
    }
    const auto known = skins_.find({list, matrices});
    if (known != skins_.end()) {
      return known->second;
    }
    const auto parentOf = [&](std::size_t node) {
      return node < figure_.nodes.size() ? figure_.nodes[node].parent
                                         : parentsOfAdded_[node - figure_.nodes.size()];
    };
    const auto rootOf = [&](std::size_t node) {
      while (parentOf(node) >= 0) {
        node = static_cast<std::size_t>(parentOf(node));
      }
      return node;
    };
    notes_.spansRoots |=
        std::ranges::any_of(list, [&](std::size_t joint) { return rootOf(joint) != rootOf(list.front()); });
    const std::size_t skin =
        parts_.add("skins", {{"joints", list}, {"inverseBindMatrices", parts_.addFloats(matrices, "MAT4")}});
    skins_[{list, matrices}] = skin;
    return skin;
  }

  const aiScene& scene_;
  const Figure& figure_;
  const std::vector<int>& materials_;
  std::vector<gltf::JsonDocument>& nodes_; // Those of the figure, then those that are added.
  std::vector<int> parentsOfAdded_;
  GlbParts& parts_;
  MeshNotes notes_;
  std::map<std::pair<std::vector<unsigned>, double>, std::size_t> meshes_; // Without skins, as they are
                                                                           // shared.
  std::map<std::pair<std::vector<std::size_t>, std::vector<float>>, std::size_t> skins_;
  std::map<std::size_t, std::size_t> restJoints_; // By the node of the figure.
};

} // namespace

MeshNotes addMeshes(const aiScene& scene, const Figure& figure, const std::vector<int>& materials,
                    std::vector<gltf::JsonDocument>& nodes, GlbParts& parts) {
  return MeshAdder(scene, figure, materials, nodes, parts).addAll();
}

} // namespace stretch::interchange
