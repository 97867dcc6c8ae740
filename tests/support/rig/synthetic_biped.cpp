#include "tests/support/rig/synthetic_biped.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

namespace stretch::test {

namespace {

void addArm(SyntheticBiped& body, const BodyOptions& options, const std::string& side, double sign,
            const std::string& chest) {
  const auto add = [&](const std::string& key, const std::string& parent, const Vec3& position) {
    body.joints.push_back({key + side, parent, Vec3(sign * position.x, position.y, position.z)});
  };
  std::string shoulder = chest;
  if (options.clavicles) {
    add("clavicle", chest, {0.03, 1.42, 0.01});
    shoulder = "clavicle" + side;
  }
  add("upperArm", shoulder, {0.18, 1.43, -0.02});
  add("foreArm", "upperArm" + side, {0.45, 1.43, -0.03});
  if (!options.hands) {
    return;
  }
  add("hand", "foreArm" + side, {0.70, 1.43, -0.02});
  if (options.fingers) {
    for (int finger = 0; finger < 3; ++finger) {
      const std::string key = "finger" + std::to_string(finger);
      const double z = 0.03 * (1 - finger);
      add(key + "a", "hand" + side, {0.79, 1.43, z});
      add(key + "b", fmt::format("{}a{}", key, side), {0.83, 1.43, z});
    }
  }
}

void addLeg(SyntheticBiped& body, const BodyOptions& options, const std::string& side, double sign) {
  const auto add = [&](const std::string& key, const std::string& parent, const Vec3& position) {
    body.joints.push_back({key + side, parent, Vec3(sign * position.x, position.y, position.z)});
  };
  add("thigh", "hips", {0.1, 0.92, 0.0});
  add("shin", "thigh" + side, {0.1, 0.50, 0.01});
  if (!options.feet) {
    return;
  }
  add("foot", "shin" + side, {0.1, 0.09, -0.03});
  if (options.toes) {
    add("toe", "foot" + side, {0.1, 0.02, 0.1});
    if (options.tips) {
      add("toeTip", "toe" + side, {0.1, 0.02, 0.17});
      body.joints.back().movesMesh = false;
    }
  }
}

std::string addTrunk(SyntheticBiped& body, const BodyOptions& options) {
  body.joints.push_back({"root", "", Vec3(0.0), true, false});
  body.joints.push_back({"hips", "root", Vec3(0, 0.98, 0)});
  std::string below = "hips";
  for (int i = 0; i < options.spineJoints; ++i) {
    const std::string key = "spine" + std::to_string(i);
    body.joints.push_back({key, below, Vec3(0, 1.08 + 0.3 * i / std::max(1, options.spineJoints), 0.01)});
    below = key;
  }
  return below;
}

void addHead(SyntheticBiped& body, const BodyOptions& options, std::string below) {
  for (int i = 0; i < options.neckJoints; ++i) {
    const std::string key = "neck" + std::to_string(i);
    body.joints.push_back({key, below, Vec3(0, 1.48 + 0.05 * i, 0.0)});
    below = key;
  }
  body.joints.push_back({"head", below, Vec3(0, 1.58, 0.01)});
  if (options.tips) {
    body.joints.push_back({"headTip", "head", Vec3(0, 1.8, 0.01), true, false});
  }
}

SyntheticJoint& find(SyntheticBiped& body, const std::string& key) {
  return *std::ranges::find(body.joints, key, &SyntheticJoint::key);
}

const SyntheticJoint& find(const SyntheticBiped& body, const std::string& key) {
  return *std::ranges::find(body.joints, key, &SyntheticJoint::key);
}

// Placement of the body's own coordinates in the armature's: turned and scaled, and unscaled so that the
// scale above restores it.
Vec3 placed(const SyntheticBiped& body, const Vec3& position) {
  const Vec3 turned = body.facesBackwards ? Vec3(-position.x, position.y, -position.z) : position;
  return body.turn * turned * (body.size / body.armatureScale);
}

int jointIndex(const SyntheticBiped& body, const std::string& key) {
  return static_cast<int>(std::ranges::find(body.joints, key, &SyntheticJoint::key) - body.joints.begin());
}

// Node 0 is the armature, the last one carries the mesh; a shuffle spreads the joints between.
NodeIndex nodeIndex(const SyntheticBiped& body, int joint) {
  const int count = static_cast<int>(body.joints.size());
  const int stride = count % 7 != 0    ? 7
                     : count % 11 != 0 ? 11
                                       : 13; // no divisor of the count of any body here
  return NodeIndex(body.shuffled ? 1 + (joint * stride + 3) % count : 1 + joint);
}

void addBox(Primitive& primitive, const Vec3& low, const Vec3& high, std::uint16_t slot) {
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 point((corner & 1) != 0 ? high.x : low.x, (corner & 2) != 0 ? high.y : low.y,
                     (corner & 4) != 0 ? high.z : low.z);
    primitive.positions.emplace_back(point);
    VertexInfluences influences;
    influences.joints[0] = slot;
    influences.weights[0] = 1.0F;
    primitive.influences.push_back(influences);
  }
}

void addRing(Primitive& primitive, const SyntheticBiped& body, const Vec3& middle, const Vec3& along,
             std::uint16_t slot) {
  const double radius = std::clamp(0.18 * glm::length(along), 0.004, 0.09);
  const Vec3 aside = glm::normalize(
      glm::cross(along, std::abs(along.y) < 0.9 * glm::length(along) ? Vec3(0, 1, 0) : Vec3(1, 0, 0)));
  const Vec3 across = glm::normalize(glm::cross(along, aside));
  for (const Vec3& offset : {aside, -aside, across, -across}) {
    primitive.positions.emplace_back(placed(body, middle + radius * offset));
    VertexInfluences influences;
    influences.joints[0] = slot;
    influences.weights[0] = 1.0F;
    primitive.influences.push_back(influences);
  }
}

// Rings about the bones to a joint's children; ends of chains go on a little, or as far as their flesh.
void addTubes(Primitive& primitive, const SyntheticBiped& body, const SyntheticJoint& joint,
              std::uint16_t slot) {
  std::vector<Vec3> bones;
  for (const SyntheticJoint& child : body.joints) {
    if (child.parent == joint.key) {
      bones.push_back(child.position - joint.position);
    }
  }
  if (joint.flesh != Vec3(0.0)) {
    bones.push_back(joint.flesh);
  } else if (bones.empty() && !joint.parent.empty()) {
    bones.push_back(0.3 * (joint.position - find(body, joint.parent).position));
  }
  for (const Vec3& bone : bones) {
    if (glm::length(bone) > 1e-6) {
      addRing(primitive, body, joint.position + 0.1 * bone, bone, slot);
      addRing(primitive, body, joint.position + 0.5 * bone, bone, slot);
      addRing(primitive, body, joint.position + bone, bone, slot);
    }
  }
}

// A box around the bone from a joint to its children; ends of chains get a stub, heads and feet their own
// shapes.
void addWeight(Primitive& primitive, const SyntheticBiped& body, const SyntheticJoint& joint,
               std::uint16_t slot) {
  if (body.tubes) {
    addTubes(primitive, body, joint, slot);
    return;
  }
  Vec3 low = joint.position;
  Vec3 high = joint.position;
  const auto include = [&](const Vec3& point) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  };
  for (const SyntheticJoint& child : body.joints) {
    if (child.parent == joint.key && joint.key != "root" && child.key.substr(0, 5) != "thigh") {
      include(child.position);
    }
  }
  const std::string stem = joint.key.substr(0, joint.key.find('.'));
  const double sign = joint.position.x < 0.0 ? -1.0 : 1.0;
  if (stem == "head") {
    include(joint.position + Vec3(0.1, 0.22, 0.13));
    include(joint.position + Vec3(-0.1, 0.0, -0.11));
  } else if (stem == "foot" || stem == "toe") {
    const double reach = stem == "foot" ? 0.1 : 0.18;
    include(Vec3(joint.position.x, 0.0, body.feetPointBack ? -2.0 * reach : reach));
  } else if (stem == "hand" || stem == "foreArm" || stem[0] == 'f') {
    include(joint.position + Vec3(sign * (stem == "foreArm" ? 0.25 : 0.03), 0.0, 0.0));
  } else if (stem == "shin") {
    include(Vec3(joint.position.x, 0.05, joint.position.z));
  }
  const Vec3 thickness(0.02);
  addBox(primitive, placed(body, low - thickness), placed(body, high + thickness), slot);
}

// The vertices of one joint as a mesh of a node below it.
void addRigidPart(Scene& scene, const SyntheticBiped& body, const SyntheticJoint& joint, NodeIndex node) {
  Primitive part;
  addWeight(part, body, joint, 0);
  part.influences.clear();
  for (glm::vec3& position : part.positions) {
    position -= glm::vec3(placed(body, joint.position));
  }
  Node carrier;
  carrier.name = scene.nodes[at(node)].name + "_mesh";
  carrier.parent = node;
  carrier.mesh = static_cast<int>(scene.meshes.size());
  scene.nodes[at(node)].children.emplace_back(static_cast<int>(scene.nodes.size()));
  scene.nodes.push_back(std::move(carrier));
  scene.meshes.push_back({joint.key, {std::move(part)}, {}});
}

} // namespace

SyntheticBiped makeBody(const BodyOptions& options) {
  SyntheticBiped body;
  const std::string chest = addTrunk(body, options);
  addHead(body, options, chest);
  for (const auto& [side, sign] : {std::pair(std::string(".l"), 1.0), std::pair(std::string(".r"), -1.0)}) {
    addArm(body, options, side, sign, chest);
    addLeg(body, options, side, sign);
  }
  return body;
}

void addTwist(SyntheticBiped& body, const std::string& newKey, const std::string& key,
              const std::string& childKey, double share, bool inChain) {
  const Vec3 from = find(body, key).position;
  SyntheticJoint& child = find(body, childKey);
  const Vec3 to = child.position;
  if (inChain) {
    child.parent = newKey;
  }
  body.joints.push_back({newKey, key, from + share * (to - from)});
}

SyntheticJoint& jointOf(SyntheticBiped& body, const std::string& key) {
  return *std::ranges::find(body.joints, key, &SyntheticJoint::key);
}

void addOther(SyntheticBiped& body, const SyntheticBiped& other, const Vec3& moveWorld) {
  for (SyntheticJoint joint : other.joints) {
    body.names["other " + joint.key] = other.names.contains(joint.key) ? other.names.at(joint.key) : "";
    joint.key = "other " + joint.key;
    joint.parent = joint.parent.empty() ? "" : "other " + joint.parent;
    joint.position += moveWorld;
    body.joints.push_back(joint);
  }
}

void applyNames(SyntheticBiped& body, const NamingScheme& scheme) {
  for (const SyntheticJoint& joint : body.joints) {
    const std::size_t dot = joint.key.find('.');
    const auto entry = scheme.names.find(joint.key.substr(0, dot));
    if (entry == scheme.names.end()) {
      continue;
    }
    std::string name = entry->second;
    const std::size_t mark = name.find('%');
    if (mark != std::string::npos) {
      name.replace(mark, 1, joint.key.substr(dot + 1) == "l" ? scheme.left : scheme.right);
    }
    body.names[joint.key] = name;
  }
}

BuiltBiped build(const SyntheticBiped& body) {
  BuiltBiped built;
  const int count = static_cast<int>(body.joints.size());
  Scene& scene = built.scene;
  scene.nodes.resize(static_cast<std::size_t>(count) + 2);
  scene.nodes[0].name = "Armature";
  scene.nodes[0].rest.scale = Vec3(body.armatureScale);
  scene.roots = {NodeIndex(0), NodeIndex(count + 1)};
  Skin skin;
  Primitive flesh;
  for (int i = 0; i < count; ++i) {
    const SyntheticJoint& joint = body.joints[static_cast<std::size_t>(i)];
    const NodeIndex index = nodeIndex(body, i);
    const NodeIndex parent =
        joint.parent.empty() ? NodeIndex(0) : nodeIndex(body, jointIndex(body, joint.parent));
    Node& node = scene.nodes[at(index)];
    const auto name = body.names.find(joint.key);
    node.name = name == body.names.end() ? "" : name->second;
    node.parent = parent;
    scene.nodes[at(parent)].children.push_back(index);
    const Vec3 origin = joint.parent.empty()
                            ? Vec3(0.0)
                            : body.joints[static_cast<std::size_t>(jointIndex(body, joint.parent))].position;
    node.rest.translation = placed(body, joint.position) - placed(body, origin);
    const bool turned = body.posedAtRest && !joint.parent.empty() && joint.key != "hips";
    node.rest.rotation = turned ? glm::angleAxis(0.4, glm::normalize(Vec3(1, 2, 3))) : Quat(1, 0, 0, 0);
    built.node[joint.key] = index;
    if (body.rigid && joint.movesMesh) {
      addRigidPart(scene, body, joint, index);
    }
    if (joint.isJoint) {
      skin.joints.push_back(index);
      skin.inverseBind.push_back(glm::translate(Mat4(1.0), -placed(body, joint.position)));
      if (joint.movesMesh) {
        addWeight(flesh, body, joint, static_cast<std::uint16_t>(skin.joints.size() - 1));
      }
    }
  }
  if (body.withSkin) {
    scene.skins.push_back(std::move(skin));
  }
  if (body.withMesh && body.withSkin) {
    scene.meshes.push_back({"body", {std::move(flesh)}, {}});
    Node& carrier = scene.nodes.back();
    carrier.name = "Body";
    carrier.mesh = 0;
    carrier.skin = 0;
  }
  return built;
}

} // namespace stretch::test
