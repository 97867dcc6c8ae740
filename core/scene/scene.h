#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "core/math/transform.h"
#include "core/scene/camera.h"
#include "core/scene/node_index.h"
#include "core/scene/texture_use.h"

namespace stretch {

/// A character as a file describes it: plain values, read once, never edited. Indices are the file's own (a
/// node is known by its index, since names repeat); -1 means none.
struct Node {
  std::string name; ///< May be empty; not unique.
  NodeIndex parent;
  std::vector<NodeIndex> children;
  Transform rest;             ///< Local, at rest. The nearest TRS where the file gives a matrix.
  std::optional<Mat4> matrix; ///< The file's matrix where it gives one: then it is what counts until the node
                              ///< is animated.
  int mesh = -1;
  int skin = -1;
  std::vector<float> morphWeights; ///< Instead of the mesh's defaults; empty where the node gives none.
  bool isBindLeaf = false;   ///< Made by this program to carry a stretch (marked in the file's extras): no
                             ///< joint of a limb.
  bool isBindCorner = false; ///< A bind leaf that carries its part of the stretch by its translation.
};

struct Skin {
  std::string name;
  std::vector<NodeIndex> joints; ///< Node indices.
  std::vector<Mat4> inverseBind; ///< One for each joint: bind-pose model space to joint space. Identity where
                                 ///< the file has none.
  std::size_t fileJoints = 0;    ///< Joints in the file's own list, which may name some of this program's
                                 ///< behind these. 0: as many as here.

  [[nodiscard]] std::size_t jointsInFile() const { return std::max(fileJoints, joints.size()); }
};

/// How a vertex follows the joints: up to 8 influences, as read (JOINTS_0, JOINTS_1), weights made to sum
/// to 1.
struct VertexInfluences {
  static constexpr int capacity = 8;
  std::array<std::uint16_t, capacity> joints{}; ///< Indices into Skin::joints.
  std::array<float, capacity> weights{};
};

struct MorphTarget {
  std::vector<glm::vec3> positions; ///< Offsets, one for each vertex; empty when the target moves none.
  std::vector<glm::vec3> normals;
};

/// Triangles only: strips and fans are turned into triangles, points and lines are left out.
struct Primitive {
  std::vector<glm::vec3> positions; ///< Mesh space (bind-pose model space for skinned meshes).
  std::vector<glm::vec3> normals;   ///< One for each vertex; computed where the file has none.
  bool hasNormals = true;           ///< The file has them: not every program computes the same.
  std::vector<glm::vec2> texCoords; ///< Coordinates of the set that the base colour texture uses; empty when
                                    ///< there is none.
  std::vector<glm::vec2> emissiveTexCoords; ///< Coordinates of the set that the emissive texture uses, where
                                            ///< that is another one.
  std::vector<glm::vec4> colors;            ///< COLOR_0, linear; empty when there is none.
  std::vector<VertexInfluences> influences; ///< Empty when not skinned.
  std::vector<VertexInfluences> onCorners;  ///< Those of the file, where what it gives to corners is the
                                            ///< joints' in `influences` (Scene::bindChains); else empty.
  bool areInfluencesMended = false;         ///< Some weights of the file are no numbers: saving writes these.
  std::vector<std::uint32_t> indices;       ///< Three for each triangle.
  std::vector<MorphTarget> morphTargets;
  int material = -1;
};

struct Mesh {
  std::string name;
  std::vector<Primitive> primitives;
  std::vector<float> morphWeights; ///< Default weights; empty without morph targets.
};

/// Pixels of a texture, decoded: 8-bit RGBA, rows from the top, sRGB. Empty when it could not be read.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
};

enum class AlphaMode { opaque, mask, blend };

/// Material as the viewport draws it.
struct Material {
  std::string name;
  glm::vec4 baseColor{1.0F};
  TextureUse baseColorTexture;
  glm::vec3 emissive{0.0F};   ///< Linear, its strength included: may be beyond 1.
  TextureUse emissiveTexture; ///< Times `emissive`.
  AlphaMode alphaMode = AlphaMode::opaque;
  float alphaCutoff = 0.5F;
  bool doubleSided = false;
  bool unlit = false;
};

/// A node of this program's own under a joint, which a stretch K of the joint moves from `place` to K place
/// (docs/rig.md, Corners).
struct BindCorner {
  NodeIndex node;
  Vec3 place{0.0};           ///< In the joint's space, at rest.
  std::map<int, int> slotOf; ///< Its slot in the file's list of joints, by skin.
};

/// Nodes of this program's own under a joint, which carry its stretch (see foldBindLeaves): a leaf with the
/// stretch axes as its rotation and the stretch as its scale, and where a mesh or the axis asks for it a leaf
/// below that turns back; or corners.
struct BindChain {
  NodeIndex joint;
  NodeIndex leaf;                    ///< -1: the chain is one of corners.
  NodeIndex endLeaf;                 ///< -1: none.
  Quat restTurn{1.0, 0.0, 0.0, 0.0}; ///< Turn of the chain at rest: joint space from the last leaf's.
  std::vector<BindCorner> corners = {};

  [[nodiscard]] NodeIndex lastLeaf() const { return endLeaf.exists() ? endLeaf : leaf; }
  /// The nodes whose poses tell the stretch.
  [[nodiscard]] std::vector<NodeIndex> nodes() const;
};

struct Scene {
  std::vector<Node> nodes;
  std::vector<NodeIndex> roots; ///< Roots of the default scene; nodes that no scene shows are not drawn.
  std::vector<Skin> skins;
  std::vector<Mesh> meshes;
  std::vector<Material> materials;
  std::vector<Image> images;
  /// VRM humanoid table (0.x and 1.0): bone name as VRM 1.0 spells it ("leftUpperArm") -> node. Empty without
  /// one.
  std::map<std::string, NodeIndex> humanoid;
  std::vector<BindChain> bindChains; ///< Chains of a file that this program stretched.
  std::vector<SceneCamera> cameras;  ///< In the order of their nodes.
};

/// Node indices ordered so that every parent comes before its children. Files are checked for loops when they
/// are read.
[[nodiscard]] std::vector<NodeIndex> parentsFirst(const Scene& scene);

/// Whether `ancestor` is `node` or above it.
[[nodiscard]] bool isAncestorOrSelf(const Scene& scene, NodeIndex ancestor, NodeIndex node);

/// The lowest node that is at or above both; -1 where they hang from different roots.
[[nodiscard]] NodeIndex commonAncestor(const Scene& scene, NodeIndex a, NodeIndex b);

/// The node of a bone of the VRM humanoid table; -1 where the file names none that it has.
[[nodiscard]] NodeIndex humanoidNode(const Scene& scene, const std::string& bone);

/// The nodes, and all below them; ascending, without repeats.
[[nodiscard]] std::vector<NodeIndex> withSubtrees(const Scene& scene, const std::vector<NodeIndex>& nodes);

/// The camera of this name; null where there is none.
[[nodiscard]] const SceneCamera* cameraNamed(const Scene& scene, const std::string& name);

/// Nodes that are a joint of any skin.
[[nodiscard]] std::set<NodeIndex> skinJoints(const Scene& scene);

/// Vertices of all meshes.
[[nodiscard]] std::size_t vertexCount(const Scene& scene);

} // namespace stretch
