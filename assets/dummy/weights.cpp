#include "assets/dummy/weights.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <glm/geometric.hpp>

#include "assets/dummy/distance_field.h"

namespace stretch::assets {

namespace {

/// The volume that moves with a joint: a round cone.
struct Bone {
  int joint;
  Vec3 start;
  Vec3 end;
  double startRadius;
  double endRadius;
};

using Weights = std::vector<std::vector<double>>; ///< Per vertex, one for each joint.

void addTrunk(std::vector<Bone>& bones, const std::vector<Joint>& skeleton) {
  const auto joint = [&](const char* name) { return jointIndex(skeleton, name); };
  bones.push_back({joint("Hips"), {-0.04, 0.915, -0.01}, {0.04, 0.915, -0.01}, 0.11, 0.11});
  bones.push_back({joint("Hips"), {0.0, 0.90, 0.0}, {0.0, 0.97, 0.0}, 0.11, 0.11});
  bones.push_back({joint("Spine"), {0.0, 1.055, 0.0}, {0.0, 1.085, 0.0}, 0.11, 0.11});
  bones.push_back({joint("Spine1"), {0.0, 1.155, 0.0}, {0.0, 1.195, 0.0}, 0.11, 0.11});
  bones.push_back({joint("Spine2"), {0.0, 1.275, -0.005}, {0.0, 1.345, -0.01}, 0.115, 0.09});
  bones.push_back({joint("Neck"), {0.0, 1.435, -0.016}, {0.0, 1.46, -0.01}, 0.056, 0.056});
  bones.push_back({joint("Head"), {0.0, 1.56, 0.0}, {0.0, 1.64, 0.0}, 0.09, 0.12});
}

void addLimbs(std::vector<Bone>& bones, const std::vector<Joint>& skeleton, const std::string& side) {
  const auto bone = [&](const char* from, const char* to, double startRadius, double endRadius) {
    const int joint = jointIndex(skeleton, side + from);
    const Vec3 start = skeleton[static_cast<std::size_t>(joint)].position;
    const Vec3 end = jointPosition(skeleton, side + to);
    return Bone{joint, start, end, startRadius, endRadius};
  };
  const double left = side == "Left" ? 1.0 : -1.0;
  bones.push_back({jointIndex(skeleton, side + "Shoulder"),
                   {left * 0.085, 1.375, -0.012},
                   {left * 0.125, 1.37, -0.012},
                   0.055,
                   0.058});
  Bone arm = bone("Arm", "ForeArm", 0.066, 0.044);
  arm.start += 0.08 * (arm.end - arm.start);
  bones.push_back(arm);
  bones.push_back(bone("ForeArm", "Hand", 0.044, 0.044));
  bones.push_back(bone("Hand", "HandMiddle1", 0.05, 0.062));
  Bone mitt = bone("Hand", "HandMiddle1", 0.062, 0.075);
  mitt.joint = jointIndex(skeleton, side + "HandMiddle1");
  mitt.start = mitt.end + 0.08 * (mitt.end - mitt.start);
  mitt.end += 0.6 * (mitt.end - jointPosition(skeleton, side + "Hand"));
  bones.push_back(mitt);
  const Vec3 thumb = jointPosition(skeleton, side + "HandThumb1");
  const Vec3 along = glm::normalize(mitt.end - mitt.start);
  bones.push_back({jointIndex(skeleton, side + "HandThumb1"), thumb + 0.02 * along,
                   thumb + 0.085 * along + Vec3(0.0, 0.0, 0.022), 0.03, 0.03});
  Bone thigh = bone("UpLeg", "Leg", 0.10, 0.06);
  thigh.start += Vec3(left * 0.01, -0.075, 0.0);
  bones.push_back(thigh);
  bones.push_back(bone("Leg", "Foot", 0.06, 0.055));
  bones.push_back(bone("Foot", "ToeBase", 0.058, 0.055));
  bones.push_back({jointIndex(skeleton, side + "Foot"),
                   {left * 0.122, 0.05, -0.05},
                   {left * 0.13, 0.05, 0.02},
                   0.05,
                   0.05});
  bones.push_back({jointIndex(skeleton, side + "ToeBase"),
                   {left * 0.14, 0.045, 0.125},
                   {left * 0.14, 0.045, 0.15},
                   0.055,
                   0.05});
}

std::vector<Bone> bonesOf(const std::vector<Joint>& skeleton) {
  std::vector<Bone> bones;
  addTrunk(bones, skeleton);
  addLimbs(bones, skeleton, "Left");
  addLimbs(bones, skeleton, "Right");
  return bones;
}

int nearestJoint(const Vec3& point, const std::vector<Bone>& bones) {
  int nearest = 0;
  double least = std::numeric_limits<double>::max();
  for (const Bone& bone : bones) {
    const double distance = roundConeDistance(point, bone.start, bone.end, bone.startRadius, bone.endRadius);
    if (distance < least) {
      least = distance;
      nearest = bone.joint;
    }
  }
  return nearest;
}

/// Wanted standard deviation of the diffusion, metres: the widths at the joints, blended by distance to them.
double blendWidth(const Vec3& point, const std::vector<Joint>& skeleton) {
  struct Width {
    const char* joint;
    double width;
  };
  constexpr std::array<Width, 15> widths{{{"Spine", 0.05},
                                          {"Spine1", 0.05},
                                          {"Spine2", 0.055},
                                          {"Neck", 0.030},
                                          {"Head", 0.022},
                                          {"LeftShoulder", 0.045},
                                          {"LeftArm", 0.042},
                                          {"LeftForeArm", 0.022},
                                          {"LeftHand", 0.014},
                                          {"LeftHandMiddle1", 0.022},
                                          {"LeftHandThumb1", 0.014},
                                          {"LeftUpLeg", 0.050},
                                          {"LeftLeg", 0.023},
                                          {"LeftFoot", 0.026},
                                          {"LeftToeBase", 0.020}}};
  double sum = 0.0;
  double total = 0.0;
  for (const Width& width : widths) {
    const Vec3 offset = Vec3(std::abs(point.x), point.y, point.z) - jointPosition(skeleton, width.joint);
    const double square = glm::dot(offset, offset) + 1e-4;
    const double influence = 1.0 / (square * square);
    sum += influence * width.width;
    total += influence;
  }
  return sum / total;
}

void diffuse(Weights& weights, const SurfaceMesh& mesh, const std::vector<Joint>& skeleton) {
  constexpr int steps = 40;
  const std::vector<std::vector<int>> neighbours = vertexNeighbours(mesh);
  std::vector<double> rates(mesh.positions.size());
  for (std::size_t v = 0; v < rates.size(); ++v) {
    double squares = 0.0;
    for (const int other : neighbours[v]) {
      const Vec3 edge = mesh.positions[static_cast<std::size_t>(other)] - mesh.positions[v];
      squares += glm::dot(edge, edge);
    }
    const double spread = squares / static_cast<double>(neighbours[v].size());
    const double width = blendWidth(mesh.positions[v], skeleton);
    rates[v] = std::min(0.9, 2.0 * width * width / (spread * steps));
  }
  for (int step = 0; step < steps; ++step) {
    const Weights before = weights;
    for (std::size_t v = 0; v < rates.size(); ++v) {
      for (std::size_t joint = 0; joint < skeleton.size(); ++joint) {
        double mean = 0.0;
        for (const int other : neighbours[v]) {
          mean += before[static_cast<std::size_t>(other)][joint];
        }
        mean /= static_cast<double>(neighbours[v].size());
        weights[v][joint] += rates[v] * (mean - before[v][joint]);
      }
    }
  }
}

/// The four strongest, as multiples of 1/4096 that sum to 1.
Influences strongest(const std::vector<double>& weights) {
  constexpr double grid = 4096.0;
  std::vector<int> order(weights.size());
  for (std::size_t joint = 0; joint < order.size(); ++joint) {
    order[joint] = static_cast<int>(joint);
  }
  const auto weightOf = [&](int joint) { return weights[static_cast<std::size_t>(joint)]; };
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return weightOf(a) > weightOf(b); });
  double total = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    total += weightOf(order[i]);
  }
  Influences influences;
  double rest = grid;
  for (std::size_t i = 1; i < 4; ++i) {
    const double units = std::floor(weightOf(order[i]) / total * grid + 0.5);
    influences.joints[i] = units > 0.0 ? order[i] : 0;
    influences.weights[i] = units / grid;
    rest -= units;
  }
  influences.joints[0] = order[0];
  influences.weights[0] = rest / grid;
  return influences;
}

} // namespace

std::vector<Influences> smoothWeights(const SurfaceMesh& mesh, const std::vector<Joint>& skeleton) {
  const std::vector<Bone> bones = bonesOf(skeleton);
  Weights weights;
  for (const Vec3& position : mesh.positions) {
    weights.emplace_back(skeleton.size(), 0.0);
    weights.back()[static_cast<std::size_t>(nearestJoint(position, bones))] = 1.0;
  }
  diffuse(weights, mesh, skeleton);
  std::vector<Influences> influences;
  influences.reserve(weights.size());
  for (const auto& row : weights) {
    influences.push_back(strongest(row));
  }
  return influences;
}

} // namespace stretch::assets
