#include "tests/support/skinning/tube_creature.h"

#include <string>

namespace stretch::test {

namespace {

struct Named {
  std::string name;
  Vec3 place;
};

// A limb on both sides: a tube through its joints, and on to a tip.
void addPair(TubePerson& body, const std::vector<Named>& joints, const Vec3& tip, double radius) {
  for (const auto& [side, sign] :
       {std::pair{std::string("left"), 1.0}, std::pair{std::string("right"), -1.0}}) {
    const Vec3 across(sign, 1.0, 1.0);
    for (std::size_t i = 0; i < joints.size(); ++i) {
      const Vec3 next = i + 1 < joints.size() ? joints[i + 1].place : tip;
      body.joints[side + joints[i].name] = across * joints[i].place;
      addTube(body, {{across * joints[i].place, radius}, {across * next, radius}});
    }
  }
}

void addTrunk(TubePerson& body, const std::vector<Named>& joints, const Vec3& tip, double radius) {
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const Vec3 next = i + 1 < joints.size() ? joints[i + 1].place : tip;
    body.joints[joints[i].name] = joints[i].place;
    addTube(body, {{joints[i].place, radius}, {next, radius}});
  }
}

} // namespace

TubePerson tubeQuadruped(bool hasTail) {
  TubePerson body;
  addTube(body, {{{0.0, 1.0, -0.6}, 0.2}, {{0.0, 1.0, 0.5}, 0.2}});
  body.joints = {{"hips", {0.0, 1.02, -0.45}}, {"chest", {0.0, 1.02, 0.35}}};
  addTrunk(body, {{"neck", {0.0, 1.1, 0.5}}}, {0.0, 1.4, 0.8}, 0.1);
  addTrunk(body, {{"head", {0.0, 1.36, 0.76}}}, {0.0, 1.3, 1.1}, 0.1);
  if (hasTail) {
    addTrunk(body, {{"tail1", {0.0, 1.0, -0.6}}}, {0.0, 0.6, -1.1}, 0.05);
  }
  addPair(body,
          {{"Shoulder", {0.14, 0.84, 0.35}}, {"Elbow", {0.14, 0.5, 0.29}}, {"Wrist", {0.14, 0.2, 0.36}}},
          {0.14, 0.04, 0.45}, 0.05);
  addPair(body, {{"Hip", {0.14, 0.9, -0.45}}, {"Knee", {0.14, 0.58, -0.36}}, {"Hock", {0.14, 0.3, -0.52}}},
          {0.14, 0.04, -0.36}, 0.05);
  return body;
}

TubePerson tubeBird() {
  TubePerson body;
  addTube(body, {{{0.0, 0.7, -0.4}, 0.15}, {{0.0, 0.75, 0.5}, 0.15}});
  body.joints = {{"hips", {0.0, 0.72, -0.1}}};
  addTrunk(body, {{"neck", {0.0, 0.8, 0.5}}}, {0.0, 1.0, 0.75}, 0.08);
  addTrunk(body, {{"head", {0.0, 0.97, 0.7}}}, {0.0, 0.95, 1.1}, 0.08);
  addTube(body, {{{0.0, 0.7, -0.4}, 0.06}, {{0.0, 0.75, -1.0}, 0.06}});
  addPair(body, {{"Hip", {0.1, 0.62, -0.1}}, {"Knee", {0.1, 0.5, 0.02}}, {"Ankle", {0.1, 0.3, -0.18}}},
          {0.1, 0.03, 0.0}, 0.03);
  addPair(body, {{"Wing1", {0.1, 0.8, 0.3}}, {"Wing2", {0.5, 0.85, 0.35}}, {"Wing3", {0.9, 0.85, 0.25}}},
          {1.3, 0.8, -0.1}, 0.035);
  body.joints["leftWing4"] = {1.3, 0.8, -0.1};
  return body;
}

TubePerson tubeInsect(int rows) {
  TubePerson body;
  addTube(body, {{{0.0, 0.4, -0.35}, 0.14}, {{0.0, 0.4, 0.4}, 0.14}});
  addTube(body, {{{0.0, 0.42, -0.4}, 0.2}, {{0.0, 0.42, -1.0}, 0.2}});
  body.joints = {{"thorax", {0.0, 0.4, 0.0}}};
  for (int row = 1; row <= rows; ++row) {
    const double part = (row - 1.0) / (rows - 1.0);
    const double base = 0.3 - 0.4 * part;
    const double foot = 1.25 - 1.85 * part; // more before than behind: a body alike at both ends may face
                                            // either
    const auto at = [&](double x, double y, double out) { return Vec3(x, y, base + out * (foot - base)); };
    const std::string leg = "Leg" + std::to_string(row);
    addPair(body,
            {{leg + "Base", at(0.1, 0.38, 0.05)},
             {leg + "Knee", at(0.5, 0.75, 0.35)},
             {leg + "Ankle", at(0.85, 0.4, 0.7)}},
            at(1.05, 0.03, 1.0), 0.035);
    body.joints["left" + leg + "Foot"] = at(1.05, 0.03, 1.0);
  }
  return body;
}

TubePerson tubeStooping() {
  TubePerson body;
  addTube(body, {{{0.0, 0.9, 0.0}, 0.15}, {{0.0, 1.5, 0.75}, 0.15}});
  addPair(body, {{"Hip", {0.12, 0.9, 0.0}}}, {0.12, 0.05, 0.0}, 0.06);
  return body;
}

} // namespace stretch::test
