#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/scene/scene.h"

namespace stretch::test {

/// A joint of a made-up skeleton: known to the test by its key, whatever its name.
struct SyntheticJoint {
  std::string key; ///< "upperArm.l", "spine0", ...
  std::string parent;
  Vec3 position{0.0};  ///< World, bind pose, before facing and scale.
  bool isJoint = true; ///< Part of the skin.
  bool movesMesh = true;
  Vec3 flesh{0.0}; ///< How far its mesh reaches beyond it, where the body has tubes.
};

/// Ends of the keys of both sides, and the sign of their x.
inline const std::vector<std::pair<std::string, double>> sides{{".l", 1.0}, {".r", -1.0}};

/// A plausible biped, 1.8 units tall, standing in a T-pose on the floor, facing +Z, left at +X.
struct SyntheticBiped {
  std::vector<SyntheticJoint> joints;
  std::map<std::string, std::string> names; ///< Key to node name; a key without an entry has no name.
  double armatureScale = 1.0;  ///< Of a node above the root joint; the bind pose's model space is its own.
  bool facesBackwards = false; ///< Turned about Y: left is at -X.
  bool withMesh = true;
  bool withSkin = true;
  bool shuffled = false;      ///< Node indices in another order than the tree's.
  bool feetPointBack = false; ///< The mesh of the feet alone, as a mech's spurs.
  bool tubes = false;         ///< Rings about the bones in place of boxes along the axes, so that posed limbs
                              ///< have a mesh as well.
  bool rigid = false;         ///< Without a skin: a mesh under each joint that moves one.
  bool posedAtRest = false;   ///< Rest rotations that are not the bind pose's.
  double size = 1.0;          ///< Of the whole, in the scene's units.
  Quat turn{1.0, 0.0, 0.0, 0.0}; ///< Of the whole in the world; by quarters, or its boxes are no boxes.
};

struct BodyOptions {
  int spineJoints = 3;
  int neckJoints = 1;
  bool clavicles = true;
  bool hands = true;
  bool feet = true;
  bool toes = true;
  bool fingers = true;
  bool tips = false; ///< A joint without weight at the top of the head and at the end of the toes.
};

[[nodiscard]] SyntheticBiped makeBody(const BodyOptions& options = {});

/// The joint of that key, which the body must have.
[[nodiscard]] SyntheticJoint& jointOf(SyntheticBiped& body, const std::string& key);

/// Puts a joint at `share` of the way from `key` to its child `childKey` and, if `inChain`, hangs the child
/// from it.
void addTwist(SyntheticBiped& body, const std::string& newKey, const std::string& key,
              const std::string& childKey, double share, bool inChain);

/// Puts another body into the same file, moved; its keys are those of its own with "other " before them.
void addOther(SyntheticBiped& body, const SyntheticBiped& other, const Vec3& moveWorld);

/// Names of the joints of a scheme: "%" stands for the side.
struct NamingScheme {
  std::string title;
  std::string left;
  std::string right;
  std::map<std::string, std::string> names; ///< Key without its side ("upperArm", "spine0") to name.
};

void applyNames(SyntheticBiped& body, const NamingScheme& scheme);

/// The scene, and where each joint went.
struct BuiltBiped {
  Scene scene;
  std::map<std::string, NodeIndex> node;
};

[[nodiscard]] BuiltBiped build(const SyntheticBiped& body);

} // namespace stretch::test
