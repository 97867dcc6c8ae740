#include "rig/plan/plan_tables.h"

#include <algorithm>

#include <fmt/format.h>

namespace stretch::rig {

namespace {

constexpr LimbSide left = LimbSide::left;
constexpr LimbSide right = LimbSide::right;
constexpr LimbSide middle = LimbSide::middle;

using Bones = std::vector<FigureBone>;

// A pair that is drawn on the right; `left` on the side where the figure's left is.
void addPair(std::vector<PlannedLimb>& limbs, const PlannedLimb& onTheRight, const std::string& leftId,
             const std::string& rightId, FigureView view) {
  for (const LimbSide side : {left, right}) {
    PlannedLimb limb = onTheRight;
    limb.place.side = side;
    limb.id = side == left ? leftId : rightId;
    const bool isMirrored = (side == left) == (view == FigureView::above);
    const float sign = isMirrored ? -1.0F : 1.0F;
    for (FigureBone& bone : limb.bones) {
      bone.fromX *= sign;
      bone.toX *= sign;
    }
    limb.end.x *= sign;
    limb.key.x *= sign;
    limbs.push_back(std::move(limb));
  }
}

// Of the plans that are no biped's: a tail swings, a hoof stands.
LimbManner mannerOf(LimbKind kind) {
  switch (kind) {
  case LimbKind::leg:
    return {.stands = true, .stiffness = 1.5, .damping = 1.0};
  case LimbKind::tail:
    return {.turnEnd = true, .overshoot = 0.3, .stiffness = 0.6, .damping = 0.3};
  case LimbKind::wing:
    return {.turnEnd = true, .overshoot = 0.15, .stiffness = 0.8, .damping = 0.5};
  case LimbKind::fin:
    return {.turnEnd = true, .overshoot = 0.2, .stiffness = 0.7, .damping = 0.4};
  case LimbKind::feeler:
    return {.turnEnd = true, .overshoot = 0.4, .stiffness = 0.5, .damping = 0.25};
  default:
    break;
  }
  return {};
}

BodyPlan bipedPlan() {
  BodyPlan plan{"biped", "a biped", 2, {}, {}, FigureView::front};
  const Bones arm{{31, 66, 10, 50, 99, 8}, {50, 99, 8, 66, 131, 6}, {67.5F, 134, 7.5F, 71, 143, 6.5F}};
  const Bones leg{{13, 132, 12, 17, 174, 9}, {17, 174, 9, 19, 212, 6.5F}, {19.5F, 217, 6.5F, 29, 220, 5.5F}};
  addPair(plan.limbs, {"", {LimbKind::arm}, true, arm, {69, 138.5F}, {70, 104}}, "left-arm", "right-arm",
          plan.view);
  addPair(plan.limbs, {"", {LimbKind::leg}, true, leg, {20.5F, 217}, {38, 184}}, "left-leg", "right-leg",
          plan.view);
  plan.limbs.push_back({"spine",
                        biped::spine,
                        true,
                        {{0, 72, 19, 0, 112, 15}, {0, 108, 14, 0, 116, 15.5F}},
                        {0, 66},
                        {0, 104}});
  plan.limbs.push_back(
      {"neck", biped::neck, true, {{0, 40, 6.5F, 0, 50, 8}, {0, 21, 16, 0, 30, 12.5F}}, {0, 24}, {28, 22}});
  plan.limbs.push_back({"tail",
                        {LimbKind::tail, middle},
                        false,
                        {{0, 140, 6, -34, 156, 5}, {-34, 156, 5, -58, 184, 4}, {-58, 184, 4, -66, 210, 2.5F}},
                        {-66, 210},
                        {-52, 152},
                        mannerOf(LimbKind::tail)});
  plan.controllers = {{"head", {0, 6}},           {"spine-top", {0, 62}},     {"spine-mid", {0, 78}},
                      {"spine-low", {0, 119}},    {"hips", {0, 135}},         {"body", {0, 224}},
                      {"left-hand", {73, 152}},   {"right-hand", {-73, 152}}, {"left-elbow", {52, 99}},
                      {"right-elbow", {-52, 99}}, {"left-foot", {34, 222}},   {"right-foot", {-34, 222}},
                      {"left-knee", {18, 172}},   {"right-knee", {-18, 172}}};
  return plan;
}

BodyPlan quadrupedPlan() {
  BodyPlan plan{"quadruped", "a quadruped", 4, {}, {}, FigureView::above};
  const Bones front{{20, 82, 9, 40, 74, 7}, {40, 74, 7, 46, 50, 5.5F}, {46, 46, 6, 46, 41, 5}};
  const Bones hind{{20, 140, 11, 42, 150, 8}, {42, 150, 8, 46, 178, 5.5F}, {46, 182, 6, 46, 176, 5}};
  addPair(plan.limbs, {"", {LimbKind::leg, left, 1}, true, front, {46, 43}, {60, 66}}, "front-left-leg",
          "front-right-leg", plan.view);
  addPair(plan.limbs, {"", {LimbKind::leg, left, 2}, true, hind, {46, 179}, {61, 160}}, "hind-left-leg",
          "hind-right-leg", plan.view);
  plan.limbs.push_back(
      {"spine", biped::spine, true, {{0, 80, 15, 0, 116, 13}, {0, 116, 13, 0, 140, 14}}, {0, 76}, {0, 98}});
  plan.limbs.push_back(
      {"neck", biped::neck, true, {{0, 50, 7, 0, 62, 9}, {0, 16, 8, 0, 32, 12}}, {0, 30}, {24, 26}});
  plan.limbs.push_back({"tail",
                        {LimbKind::tail, middle},
                        true,
                        {{0, 160, 6, 0, 182, 5}, {0, 182, 5, 6, 204, 4}, {6, 204, 4, 18, 220, 2.5F}},
                        {18, 220},
                        {-14, 200}});
  const Bones wing{{24, 100, 5, 56, 92, 5}, {56, 92, 5, 84, 112, 3.5F}, {58, 96, 3, 62, 124, 2}};
  addPair(plan.limbs, {"", {LimbKind::wing}, false, wing, {84, 112}, {80, 92}}, "left-wing", "right-wing",
          plan.view);
  return plan;
}

BodyPlan birdPlan() {
  BodyPlan plan{"bird", "a bird or a two-legged dinosaur", 2, {}, {}, FigureView::above};
  const Bones arm{{18, 84, 6, 34, 72, 5}, {34, 72, 5, 34, 58, 4}};
  const Bones leg{{14, 136, 10, 30, 150, 7}, {30, 150, 7, 32, 172, 5}, {32, 176, 5, 34, 164, 4}};
  addPair(plan.limbs, {"", {LimbKind::arm}, false, arm, {34, 58}, {52, 68}}, "left-arm", "right-arm",
          plan.view);
  addPair(plan.limbs, {"", {LimbKind::leg}, true, leg, {33, 174}, {54, 168}}, "left-leg", "right-leg",
          plan.view);
  plan.limbs.push_back(
      {"spine", biped::spine, true, {{0, 86, 14, 0, 120, 16}, {0, 120, 16, 0, 140, 12}}, {0, 82}, {0, 103}});
  plan.limbs.push_back(
      {"neck", biped::neck, true, {{0, 52, 6, 0, 70, 8}, {0, 34, 10, 0, 20, 4}}, {0, 34}, {22, 34}});
  plan.limbs.push_back({"tail",
                        {LimbKind::tail, middle},
                        true,
                        {{0, 158, 8, 0, 184, 7}, {0, 184, 7, 0, 214, 10}},
                        {0, 214},
                        {22, 206}});
  const Bones wing{{22, 92, 8, 50, 84, 6}, {50, 84, 6, 84, 112, 4}, {44, 92, 5, 66, 120, 3}};
  addPair(plan.limbs, {"", {LimbKind::wing}, false, wing, {84, 112}, {76, 84}}, "left-wing", "right-wing",
          plan.view);
  return plan;
}

// Legs in rows from front to back, spread like a fan.
BodyPlan manyLegs(const std::string& id, const std::string& title, int rows) {
  BodyPlan plan{id, title, 2 * rows, {}, {}, FigureView::above};
  const float first = 62.0F;
  const float step = rows > 1 ? 66.0F / static_cast<float>(rows - 1) : 0.0F;
  for (int row = 1; row <= rows; ++row) {
    const auto i = static_cast<float>(row - 1);
    const float base = first + 0.62F * step * i + 8.0F;
    const float knee = first + step * (1.35F * i - 0.35F * static_cast<float>(rows - 1) * 0.5F) - 8.0F;
    const float foot = first + step * (2.0F * i - 0.5F * static_cast<float>(rows - 1)) + 4.0F;
    const Bones leg{{18, base, 5, 50, knee, 4.5F}, {50, knee, 4.5F, 78, foot, 3}};
    const std::string number = row == 1 ? std::string() : fmt::format("-{}", row);
    addPair(plan.limbs,
            {"", {LimbKind::leg, left, row}, true, leg, {78, foot}, {60, 0.5F * (knee + foot) + 12.0F}},
            "left-leg" + number, "right-leg" + number, plan.view);
  }
  plan.limbs.push_back({"spine", biped::spine, true, {{0, 62, 12, 0, 118, 11}}, {0, 62}, {0, 90}});
  plan.limbs.push_back({"neck", biped::neck, false, {{0, 35, 9, 0, 39, 10}}, {0, 35}, {22, 38}});
  plan.limbs.push_back({"tail",
                        {LimbKind::tail, middle},
                        false,
                        {{0, 146, 14, 0, 176, 18}, {0, 176, 18, 0, 198, 8}},
                        {0, 198},
                        {0, 164}});
  const Bones feeler{{5, 32, 2.5F, 14, 16, 2}, {14, 16, 2, 28, 8, 1.5F}};
  addPair(plan.limbs, {"", {LimbKind::feeler}, false, feeler, {28, 8}, {47, 15}}, "left-feeler",
          "right-feeler", plan.view);
  const Bones wing{{16, 130, 4, 32, 168, 7}, {32, 168, 7, 42, 206, 5}};
  addPair(plan.limbs, {"", {LimbKind::wing}, false, wing, {42, 206}, {63, 206}}, "left-wing", "right-wing",
          plan.view);
  return plan;
}

BodyPlan serpentPlan() {
  BodyPlan plan{"serpent", "a serpent or a fish", 0, {}, {}, FigureView::above};
  plan.limbs.push_back({"spine",
                        biped::spine,
                        true,
                        {{0, 40, 13, 16, 76, 11},
                         {16, 76, 11, -16, 128, 10},
                         {-16, 128, 10, 14, 180, 7},
                         {14, 180, 7, 4, 218, 3}},
                        {0, 40},
                        {0, 102}});
  plan.limbs.back().ledByHead = true;
  plan.limbs.push_back({"neck", biped::neck, false, {{0, 12, 8, 0, 20, 9}}, {0, 12}, {24, 18}});
  const Bones front{{22, 66, 5, 48, 84, 4}, {48, 84, 4, 54, 96, 2.5F}};
  const Bones hind{{14, 136, 4, 36, 152, 3}, {36, 152, 3, 40, 160, 2}};
  addPair(plan.limbs, {"", {LimbKind::fin, left, 0}, false, front, {54, 96}, {68, 79}}, "left-fin",
          "right-fin", plan.view);
  addPair(plan.limbs, {"", {LimbKind::fin, left, 2}, false, hind, {40, 160}, {57, 148}}, "left-fin-2",
          "right-fin-2", plan.view);
  return plan;
}

// Of limbs that the plan itself says nothing about.
void setManners(BodyPlan& plan) {
  for (PlannedLimb& limb : plan.limbs) {
    limb.manner = limb.manner == LimbManner{} ? mannerOf(limb.place.kind) : limb.manner;
  }
}

} // namespace

std::vector<BodyPlan> planTables() {
  std::vector<BodyPlan> plans{bipedPlan(),
                              quadrupedPlan(),
                              birdPlan(),
                              manyLegs("insect", "an insect", 3),
                              manyLegs("spider", "a spider", 4),
                              serpentPlan(),
                              {"other", "a body of no known plan", 0, {}, {}, FigureView::above}};
  for (BodyPlan& plan : plans) {
    std::ranges::stable_sort(plan.limbs, {}, &PlannedLimb::place);
    if (plan.id != "biped") {
      setManners(plan);
    }
  }
  return plans;
}

} // namespace stretch::rig
