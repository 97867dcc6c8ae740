#include "skinning/export/posed_probes.h"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/anim/sampling.h"
#include "skinning/linear_blend_skinning.h"

namespace stretch::skinning {
namespace {

void put(Transform& local, Channel channel, const Vec4& value) {
  if (channel == Channel::rotation) {
    local.rotation = glm::normalize(Quat(value.w, value.x, value.y, value.z));
  } else {
    (channel == Channel::scale ? local.scale : local.translation) = Vec3(value);
  }
}

/// Faces, edges and corners of a cube: where a joint's vertices are looked for.
std::vector<Vec3> directions() {
  std::vector<Vec3> all;
  for (int i = 0; i < 27; ++i) {
    const Vec3 d(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    if (glm::length(d) > 0.0) {
      all.push_back(glm::normalize(d));
    }
  }
  return all;
}

/// For each joint the vertices that lie farthest out in every direction, of those that it moves.
std::set<std::size_t> farthestOut(const std::vector<Vec3>& places,
                                  const std::vector<VertexInfluences>& influences, std::size_t joints) {
  constexpr float leastWeight = 0.2F;
  struct Farthest {
    double distance = -std::numeric_limits<double>::infinity();
    std::size_t vertex = 0;
  };
  const std::vector<Vec3> ways = directions();
  std::vector<Farthest> farthest(joints * ways.size());
  for (std::size_t v = 0; v < influences.size(); ++v) {
    for (std::size_t i = 0; i < VertexInfluences::capacity; ++i) {
      for (std::size_t d = 0; influences[v].weights[i] > leastWeight && d < ways.size(); ++d) {
        Farthest& best = farthest[influences[v].joints[i] * ways.size() + d];
        const double distance = glm::dot(ways[d], places[v]);
        best = distance > best.distance ? Farthest{distance, v} : best;
      }
    }
  }
  std::set<std::size_t> taken;
  for (const Farthest& one : farthest) {
    if (one.distance > -std::numeric_limits<double>::infinity()) {
      taken.insert(one.vertex);
    }
  }
  return taken;
}

} // namespace

PosedProbes::PosedProbes(const Scene& scene, std::vector<ClipCourse> courses, std::size_t frames,
                         const std::vector<std::size_t>& also)
    : frames_(frames), courses_(std::move(courses)) {
  for (const Node& node : scene.nodes) {
    parents_.push_back(node.parent.value);
  }
  for (const NodeIndex node : parentsFirst(scene)) {
    order_.push_back(at(node));
  }
  const Skin& skin = scene.skins.front();
  for (const NodeIndex joint : skin.joints) {
    joints_.push_back(at(joint));
  }
  inverseBind_ = skin.inverseBind;
  addProbes(scene, also);
  Followers all;
  all.nodes = order_;
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    all.joints.push_back(j);
  }
  const std::vector<Transform> rest = restPose(scene).locals;
  for (std::size_t k = 0; k < frames_; ++k) {
    addFrame(rest, all, k);
  }
}

void PosedProbes::addFrame(const std::vector<Transform>& rest, const Followers& all, std::size_t frame) {
  std::vector<Transform> locals = rest;
  for (const ClipCourse& course : courses_) {
    for (const std::size_t node : course.nodes) {
      put(locals[node], course.channel, course.values[frame]);
    }
  }
  std::vector<Mat4> worlds(parents_.size());
  std::vector<Mat4> skins(joints_.size());
  pose(all, locals, worlds, skins);
  std::vector<Vec3> places;
  for (const Probe& probe : probes_) {
    places.push_back(placeOf(probe, skins));
  }
  locals_.push_back(std::move(locals));
  worlds_.push_back(std::move(worlds));
  skins_.push_back(std::move(skins));
  source_.push_back(std::move(places));
}

void PosedProbes::addProbes(const Scene& scene, const std::vector<std::size_t>& also) {
  std::vector<Vec3> places;
  std::vector<VertexInfluences> influences;
  for (const NodeIndex node : drawnMeshNodes(scene)) {
    for (const Primitive& primitive : scene.meshes[at(scene.nodes[at(node)].mesh)].primitives) {
      places.insert(places.end(), primitive.positions.begin(), primitive.positions.end());
      influences.insert(influences.end(), primitive.influences.begin(), primitive.influences.end());
    }
  }
  std::set<std::size_t> taken = farthestOut(places, influences, joints_.size());
  taken.insert(also.begin(), also.end());
  for (const std::size_t v : taken) {
    Probe probe{places[v], {}};
    for (std::size_t i = 0; i < VertexInfluences::capacity; ++i) {
      if (influences[v].weights[i] > 0.0F) {
        probe.joints.emplace_back(influences[v].joints[i], static_cast<double>(influences[v].weights[i]));
      }
    }
    probes_.push_back(std::move(probe));
  }
}

PosedProbes::Group PosedProbes::groupOf(const std::vector<std::size_t>& courses) const {
  std::vector<std::size_t> targets;
  for (const std::size_t course : courses) {
    targets.insert(targets.end(), courses_[course].nodes.begin(), courses_[course].nodes.end());
  }
  return {courses, followersOf(targets)};
}

PosedProbes::Followers PosedProbes::followersOf(const std::vector<std::size_t>& targets) const {
  Followers followers;
  std::vector<bool> moves(parents_.size(), false);
  for (const std::size_t node : order_) {
    const bool above = parents_[node] >= 0 && moves[static_cast<std::size_t>(parents_[node])];
    moves[node] = above || std::ranges::find(targets, node) != targets.end();
    if (moves[node]) {
      followers.nodes.push_back(node);
    }
  }
  std::vector<bool> turns(joints_.size(), false);
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    turns[j] = moves[joints_[j]];
    if (turns[j]) {
      followers.joints.push_back(j);
    }
  }
  for (std::size_t p = 0; p < probes_.size(); ++p) {
    if (std::ranges::any_of(probes_[p].joints, [&](const auto& joint) { return turns[joint.first]; })) {
      followers.probes.push_back(p);
    }
  }
  return followers;
}

Vec3 PosedProbes::placeOf(const Probe& probe, const std::vector<Mat4>& skins) {
  Vec3 place(0.0);
  for (const auto& [joint, weight] : probe.joints) {
    place += weight * transformPoint(skins[joint], probe.place);
  }
  return place;
}

void PosedProbes::pose(const Followers& followers, const std::vector<Transform>& locals,
                       std::vector<Mat4>& worlds, std::vector<Mat4>& skins) const {
  for (const std::size_t node : followers.nodes) {
    const Mat4 local = toMatrix(locals[node]);
    worlds[node] = parents_[node] < 0 ? local : worlds[static_cast<std::size_t>(parents_[node])] * local;
  }
  for (const std::size_t joint : followers.joints) {
    skins[joint] = worlds[joints_[joint]] * inverseBind_[joint];
  }
}

void PosedProbes::putAll(const Group& group, const std::vector<Vec4>& values,
                         std::vector<Transform>& locals) const {
  for (std::size_t i = 0; i < group.courses.size(); ++i) {
    const ClipCourse& course = courses_[group.courses[i]];
    for (const std::size_t node : course.nodes) {
      put(locals[node], course.channel, values[i]);
    }
  }
}

double PosedProbes::farthest(std::size_t frame, const Group& group, const std::vector<Vec4>& values,
                             double enough) const {
  std::vector<Transform> locals = locals_[frame];
  std::vector<Mat4> worlds = worlds_[frame];
  std::vector<Mat4> skins = skins_[frame];
  putAll(group, values, locals);
  pose(group.followers, locals, worlds, skins);
  double most = 0.0;
  for (const std::size_t p : group.followers.probes) {
    most = std::max(most, glm::distance(placeOf(probes_[p], skins), source_[frame][p]));
    if (most > enough) {
      break;
    }
  }
  return most;
}

void PosedProbes::set(std::size_t frame, const Group& group, const std::vector<Vec4>& values) {
  putAll(group, values, locals_[frame]);
  pose(group.followers, locals_[frame], worlds_[frame], skins_[frame]);
}

} // namespace stretch::skinning
