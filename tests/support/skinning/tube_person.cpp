#include "tests/support/skinning/tube_person.h"

#include <array>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

namespace stretch::test {

namespace {

constexpr std::uint32_t around = 20;

class Tubes {
public:
  explicit Tubes(TubePerson& person) : person_(person) {}

  // Closed at both ends.
  void add(const std::vector<TubeRing>& rings) {
    const Vec3 along = glm::normalize(rings.back().middle - rings.front().middle);
    const Vec3 helper = std::abs(along.y) < 0.9 ? Vec3(0.0, 1.0, 0.0) : Vec3(0.0, 0.0, 1.0);
    const Vec3 x = glm::normalize(helper - glm::dot(helper, along) * along);
    const Vec3 y = glm::cross(along, x);
    const auto first = static_cast<std::uint32_t>(person_.positions.size());
    for (const TubeRing& ring : rings) {
      for (std::uint32_t i = 0; i < around; ++i) {
        const double angle = 2.0 * pi * i / around;
        person_.positions.push_back(ring.middle + ring.radius * (std::cos(angle) * x + std::sin(angle) * y));
      }
    }
    for (std::uint32_t ring = 0; ring + 1 < rings.size(); ++ring) {
      for (std::uint32_t i = 0; i < around; ++i) {
        const std::uint32_t a = first + ring * around + i;
        const std::uint32_t b = first + ring * around + (i + 1) % around;
        person_.triangles.push_back({a, b, a + around});
        person_.triangles.push_back({b, b + around, a + around});
      }
    }
    cap(first, rings.front().middle);
    cap(first + static_cast<std::uint32_t>(rings.size() - 1) * around, rings.back().middle);
  }

private:
  void cap(std::uint32_t ring, const Vec3& middle) {
    const auto centre = static_cast<std::uint32_t>(person_.positions.size());
    person_.positions.push_back(middle);
    for (std::uint32_t i = 0; i < around; ++i) {
      person_.triangles.push_back({ring + i, ring + (i + 1) % around, centre});
    }
  }

  TubePerson& person_;
};

void addArm(const std::string& name, double side, const TubePose& pose, TubePerson& person) {
  const Vec3 shoulder(side * pose.shoulders, 1.43, 0.0);
  const Vec3 along(side * std::cos(pose.armsDown), -std::sin(pose.armsDown), 0.0);
  const auto at = [&](double way) { return shoulder + way * along; };
  person.joints[name + "UpperArm"] = shoulder;
  person.joints[name + "LowerArm"] = at(0.28);
  person.joints[name + "Hand"] = at(0.53);
  if (pose.hasRods) {
    Tubes(person).add({{at(-0.08), 0.02}, {at(0.2), 0.02}});
    Tubes(person).add({{at(0.14), 0.07}, {at(0.72), 0.07}});
    person.joints[name + "LowerArm"] = at(0.18);
    person.joints.erase(name + "Hand");
    return;
  }
  Tubes(person).add({{at(-0.08), 0.06},
                     {at(0.02), 0.06},
                     {at(0.1), 0.05},
                     {at(0.28), 0.043},
                     {at(0.38), 0.045},
                     {at(0.53), 0.03},
                     {at(0.6), 0.048},
                     {at(0.68), 0.045},
                     {at(0.72), 0.02}});
  if (const double held = side < 0.0 ? pose.holdsInRight : pose.holdsInLeft; held > 0.0) {
    Tubes(person).add({{at(0.62), 0.02}, {at(0.72 + held), 0.02}});
  }
}

void addLeg(const std::string& name, double side, TubePerson& person) {
  const double x = side * 0.1;
  person.joints[name + "UpperLeg"] = {x, 0.9, 0.0};
  person.joints[name + "LowerLeg"] = {x, 0.5, 0.0};
  person.joints[name + "Foot"] = {x, 0.1, 0.0};
  person.joints[name + "Toes"] = {x, 0.03, 0.1};
  Tubes(person).add({{{x, 0.95, 0.0}, 0.08},
                     {{x, 0.85, 0.0}, 0.085},
                     {{x, 0.5, 0.0}, 0.06},
                     {{x, 0.12, 0.0}, 0.045},
                     {{x, 0.05, 0.0}, 0.05}});
  Tubes(person).add({{{x, 0.045, -0.07}, 0.045}, {{x, 0.045, 0.16}, 0.045}});
}

void addBox(const Vec3& low, const Vec3& high, TubePerson& person) {
  const auto first = static_cast<std::uint32_t>(person.positions.size());
  for (std::uint32_t corner = 0; corner < 8; ++corner) {
    person.positions.emplace_back((corner & 1U) != 0 ? high.x : low.x, (corner & 2U) != 0 ? high.y : low.y,
                                  (corner & 4U) != 0 ? high.z : low.z);
  }
  for (const auto& [a, b, c, d] : std::array<std::array<std::uint32_t, 4>, 6>{
           {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}}}) {
    person.triangles.push_back({first + a, first + b, first + c});
    person.triangles.push_back({first + a, first + c, first + d});
  }
}

} // namespace

void addTube(TubePerson& body, const std::vector<TubeRing>& rings) {
  Tubes(body).add(rings);
}

TubePerson blockPerson() {
  TubePerson person;
  person.joints["hips"] = {0.0, 0.6, 0.0};
  addBox({-0.24, 0.6, -0.1}, {0.24, 1.2, 0.1}, person);
  addBox({-0.2, 1.2, -0.2}, {0.2, 1.8, 0.2}, person);
  for (const auto& [name, side] : {std::pair<std::string, double>{"left", 1.0}, {"right", -1.0}}) {
    const double leg = side * 0.13;
    addBox({leg - 0.1, 0.0, -0.1}, {leg + 0.1, 0.6, 0.1}, person);
    person.joints[name + "UpperLeg"] = {leg, 0.6, 0.0};
    person.joints[name + "LowerLeg"] = {leg, 0.3, 0.0};
    const double arm = side * 0.36;
    addBox({arm - 0.1, 0.6, -0.1}, {arm + 0.1, 1.2, 0.1}, person);
    person.joints[name + "LowerArm"] = {arm, 0.9, 0.0};
  }
  return person;
}

TubePerson tubePerson(const TubePose& pose) {
  TubePerson person;
  person.joints = {{"hips", {0.0, 0.93, 0.0}}, {"neck", {0.0, 1.48, 0.0}}, {"head", {0.0, 1.56, 0.0}}};
  Tubes tubes(person);
  tubes.add({{{0.0, 0.86, 0.0}, 0.15},
             {{0.0, 1.0, 0.0}, 0.16},
             {{0.0, 1.15, 0.0}, 0.14},
             {{0.0, 1.35, 0.0}, 0.17},
             {{0.0, 1.45, 0.0}, 0.15},
             {{0.0, 1.49, 0.0}, 0.07}});
  tubes.add({{{0.0, 1.44, 0.0}, 0.05}, {{0.0, 1.6, 0.0}, 0.05}});
  tubes.add(
      {{{0.0, 1.56, 0.0}, 0.06}, {{0.0, 1.62, 0.0}, 0.1}, {{0.0, 1.72, 0.0}, 0.1}, {{0.0, 1.8, 0.0}, 0.04}});
  for (const auto& [name, side] : {std::pair{"left", 1.0}, std::pair{"right", -1.0}}) {
    addLeg(name, side, person);
    if (pose.hasArms) {
      addArm(name, side, pose, person);
    }
  }
  if (pose.everyNthHole > 0) {
    std::vector<Triangle> kept;
    for (std::size_t i = 0; i < person.triangles.size(); ++i) {
      if (i % pose.everyNthHole != 0) {
        kept.push_back(person.triangles[i]);
      }
    }
    person.triangles = kept;
  }
  return person;
}

} // namespace stretch::test
