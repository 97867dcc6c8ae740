#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "../../support/ui/render_scenes.h"
#include "ui/render/overlay/arrow_mesh.h"
#include "ui/render/overlay/skeleton_drawing.h"
#include "ui/render/overlay/trail_drawing.h"
#include "ui/render/scene/bounds.h"
#include "ui/render/scene/lighting.h"
#include "ui/render/scene/value_colors.h"
#include "ui/render/view/quality.h"

using namespace stretch;
using namespace stretch::ui;
using namespace stretch::test;

namespace {

const View someView = makeView(Camera{}, {800.0, 600.0, 1.0});

TrailPicture straightTrail() {
  TrailPicture trail;
  trail.samplesPerFrame = 2;
  for (int i = 0; i <= 8; ++i) {
    trail.original.emplace_back(0.1 * i, 1.0, 0.0);
    trail.exaggerated.emplace_back(0.2 * i, 1.0, 0.0);
  }
  return trail;
}

std::ptrdiff_t count(const Overlay& overlay, MarkerShape shape) {
  return std::count_if(overlay.markers.begin(), overlay.markers.end(),
                       [&](const Marker& mark) { return mark.shape == shape; });
}

} // namespace

TEST_CASE("The original is thin and dashed, the exaggerated path thick and solid") {
  const Overlay overlay = drawTrail(someView, straightTrail());
  REQUIRE(overlay.lines.size() == 2);
  CHECK(overlay.lines[0].dashPoints > 0.0F);
  CHECK(overlay.lines[1].dashPoints == 0.0F);
  CHECK(overlay.lines[0].points[0].widthPoints < overlay.lines[1].points[0].widthPoints);
  CHECK(overlay.lines[0].points[0].color == rgba(okabe::skyBlue));
  CHECK(overlay.lines[1].points[0].color == rgba(okabe::orange));
}

TEST_CASE("Every frame has a tick across the original and a dot on the exaggerated path") {
  const Overlay overlay = drawTrail(someView, straightTrail());
  CHECK(count(overlay, MarkerShape::tick) == 5);
  CHECK(count(overlay, MarkerShape::disc) == 5);
  TrailPicture without = straightTrail();
  without.samplesPerFrame = 0;
  CHECK(drawTrail(someView, without).markers.empty());
}

TEST_CASE("The playhead is marked on both paths, key spheres are larger and the selected one the largest") {
  TrailPicture trail = straightTrail();
  trail.samplesPerFrame = 0;
  trail.currentSample = 2.5;
  trail.spheres = {{trail.exaggerated[0], false, false}, {trail.exaggerated[4], true, false}};
  const Overlay overlay = drawTrail(someView, trail);
  REQUIRE(overlay.markers.size() == 4);
  CHECK(count(overlay, MarkerShape::sphere) == 2);
  CHECK(overlay.markers[1].radiusPoints > overlay.markers[0].radiusPoints);
  CHECK(overlay.markers[2].world.x == Approx(0.25));
  CHECK(overlay.markers[3].world.x == Approx(0.5));
  CHECK(overlay.markers[0].radiusPoints > overlay.markers[2].radiusPoints);
}

TEST_CASE("Outside its window a trail fades out") {
  TrailPicture trail = straightTrail();
  trail.currentSample = 0.0;
  trail.windowSamples = 2.0;
  const Overlay overlay = drawTrail(someView, trail);
  CHECK(overlay.lines[1].points.front().color.a == 1.0F);
  CHECK(overlay.lines[1].points.back().color.a == 0.0F);
}

TEST_CASE("A trail is whole within its window, and fades over half a window beside it") {
  TrailPicture trail = straightTrail();
  trail.samplesPerFrame = 1;
  trail.currentSample = 0.0;
  trail.windowSamples = 4.0;
  const Overlay overlay = drawTrail(someView, trail);
  REQUIRE(overlay.markers.size() == 20); // Nine for each path, the original first, and the playhead on both.
  const std::vector<float> opacities{1.0F, 1.0F, 1.0F, 1.0F, 1.0F, 0.5F, 0.0F, 0.0F, 0.0F};
  for (std::size_t sample = 0; sample < opacities.size(); ++sample) {
    CAPTURE(sample);
    CHECK(overlay.markers[sample].fill.a == Approx(opacities[sample]).margin(1e-6));
  }
}

TEST_CASE("Spheres keep apart on the screen, and shrink far from the playhead, but not where one is meant") {
  const Vec3 place(0.0, 1.0, 0.0);
  const Vec3 tenPixels(10.0 * unitsPerPixel(someView, place), 0.0, 0.0);
  const auto radii = [&](const std::vector<TrailSphere>& spheres) {
    TrailPicture trail;
    trail.spheres = spheres;
    std::vector<double> found;
    for (const Marker& mark : drawTrail(someView, trail, {.sphereRadiusPoints = 8.0F}).markers) {
      found.push_back(static_cast<double>(mark.radiusPoints));
    }
    return found;
  };
  const auto lone = radii({{place}});
  REQUIRE(lone.size() == 1);
  CHECK(lone[0] == Approx(8.0));
  CHECK(radii({{place, false, false, false}})[0] == Approx(0.6 * 8.0));
  // Two and their gap have ten points together.
  const auto close = radii({{place}, {place + tenPixels, true}, {place - tenPixels, false, true}});
  REQUIRE(close.size() == 3);
  CHECK(close[0] == Approx(4.5).epsilon(1e-3));
  CHECK(close[1] == Approx(1.25 * 8.0));
  CHECK(close[2] == Approx(1.15 * 8.0));
}

TEST_CASE("A trail of one point or none is drawn without harm") {
  TrailPicture trail;
  CHECK(drawTrail(someView, trail).markers.empty());
  trail.original = {{0.0, 1.0, 0.0}};
  trail.currentSample = 7.0;
  CHECK(drawTrail(someView, trail).markers.size() == 2);
}

TEST_CASE("Bones lead from joint to joint, through helper nodes") {
  Scene scene = bipedScene();
  const BipedNodes nodes;
  const std::vector<NodeIndex> joints = jointsOf(scene);
  CHECK(joints.size() == scene.skins[0].joints.size());
  const FrameState frame = frameOf(scene, restPose(scene), 0.0);
  CHECK(boneSegments(scene, frame, joints).size() == joints.size() - 1);

  auto& skinJoints = scene.skins[0].joints;
  skinJoints.erase(std::find(skinJoints.begin(), skinJoints.end(), nodes.leftForearm));
  const auto bones = boneSegments(scene, frame, jointsOf(scene));
  const auto ofUpperArm = std::find_if(
      bones.begin(), bones.end(), [&](const BoneSegment& bone) { return bone.node == nodes.leftUpperArm; });
  REQUIRE(ofUpperArm != bones.end());
  CHECK(glm::length(ofUpperArm->toWorld - positionOf(frame.worlds[at(nodes.leftHand)])) < 1e-12);
}

TEST_CASE("A character of rigid parts has a skeleton too") {
  Scene scene = triangleScene();
  CHECK(jointsOf(scene) == std::vector{NodeIndex(0)});
}

TEST_CASE("A skeleton without a mesh is drawn as a stick figure, all of it in the picture") {
  Scene scene = bipedScene();
  CHECK_FALSE(isStickFigure(scene));
  for (Node& node : scene.nodes) {
    node.mesh = -1;
  }
  scene.skins.clear();
  REQUIRE(isStickFigure(scene));
  const FrameState frame = frameOf(scene, restPose(scene), 0.0);
  const std::vector<NodeIndex> joints = jointsOf(scene);
  CHECK(joints.size() > 10);
  const Box box = BoundsSampler(scene).boxOf(scene, frame);
  REQUIRE_FALSE(box.empty());
  for (const NodeIndex joint : joints) {
    const Vec3 place = positionOf(frame.worlds[at(joint)]);
    CHECK(place.y >= box.minimum.y - 1e-9);
    CHECK(place.y <= box.maximum.y + 1e-9);
  }
}

TEST_CASE("The stretch ratio of a bone is its singular value farthest from one") {
  CHECK(stretchRatio(Mat3(1.0)) == Approx(1.0));
  CHECK(stretchRatio(Mat3(2.0, 0, 0, 0, 0.7, 0, 0, 0, 0.7)) == Approx(2.0));
  CHECK(stretchRatio(Mat3(0.4, 0, 0, 0, 1.2, 0, 0, 0, 1.2)) == Approx(0.4));
  const Mat3 turn(glm::mat3_cast(glm::angleAxis(0.8, glm::normalize(Vec3(1, 2, 3)))));
  CHECK(stretchRatio(turn * Mat3(1, 0, 0, 0, 3, 0, 0, 0, 1) * glm::transpose(turn)) == Approx(3.0));
  CHECK(stretchRatio(Mat3(1, 0, 0, 0, 0, 0, 0, 0, 1)) == 0.0);
}

TEST_CASE("Stretch colours are grey at one, warm above and cool below") {
  const glm::vec3 rest = stretchColor(1.0);
  CHECK(rest.r == Approx(rest.b));
  CHECK(stretchColor(2.0).r > 4.0F * stretchColor(2.0).b);
  CHECK(stretchColor(0.5).b > 4.0F * stretchColor(0.5).r);
  CHECK(stretchColor(100.0) == stretchColor(largestShownStretch));
  CHECK(stretchColor(0.0) == stretchColor(smallestShownStretch));
}

TEST_CASE("The floor's cells are round numbers that follow the character's size") {
  CHECK(floorCellSize(1.75) == Approx(0.5));
  CHECK(floorCellSize(130.0) == Approx(20.0));
  CHECK(floorCellSize(0.02) == Approx(0.005));
}

TEST_CASE("A character stands on the ground where its feet are near it, else on a floor of its own") {
  const auto floorOf = [](double lowest) {
    Box box;
    box.add({-0.3, lowest, -0.2});
    box.add({0.3, lowest + 1.8, 0.2});
    return floorHeightOf(box);
  };
  CHECK(floorOf(-0.1) == 0.0);
  CHECK(floorOf(0.1) == 0.0);
  CHECK(floorOf(-2.0) == -2.0);
  CHECK(floorOf(0.5) == 0.5);
  CHECK(floorHeightOf(Box{}) == 0.0);
}

TEST_CASE("What is long and flat is measured by its length, whichever way it lies") {
  const bool liesAlongZ = GENERATE(false, true);
  Scene flat = triangleScene();
  for (glm::vec3& position : flat.meshes.front().primitives.front().positions) {
    const glm::vec2 place(position); // Two long either way.
    position =
        liesAlongZ ? glm::vec3(0.1F * place.x, 0.0F, place.y) : glm::vec3(place.x, 0.0F, 0.1F * place.y);
  }
  CHECK(measuresOf(flat, BoundsSampler(flat)).characterHeight == Approx(0.6));
}

TEST_CASE("The floor under a shadow reaches from the feet to the shadow's end") {
  Box box;
  box.add({-0.3, 0.0, -0.2});
  box.add({0.3, 1.8, 0.2});
  const Vec3 towardsLight = glm::normalize(Vec3(-1.0, 1.0, 0.0));
  const FloorArea area = shadowedFloor(box, 0.0, towardsLight);
  CHECK(area.centre.x - area.halfSize.x < -0.3);
  CHECK(area.centre.x + area.halfSize.x > 0.3 + 1.8);
}

TEST_CASE("The floor under a shadow is square, and lies about the feet and the shadow's end") {
  Box box;
  box.add({-0.3, 0.0, -0.2});
  box.add({0.3, 1.8, 0.2});
  const Vec3 towardsLight = glm::normalize(Vec3(0.0, 1.0, -1.0)); // Shadows are as long as things are high.
  const double floorHeight = GENERATE(0.0, -1.0);
  const double end = 0.2 + 1.8 - floorHeight;
  const FloorArea area = shadowedFloor(box, floorHeight, towardsLight);
  CHECK(area.centre.x == Approx(0.0).margin(1e-12));
  CHECK(area.centre.y == Approx(0.5 * (-0.2 + end)));
  CHECK(area.halfSize.y == Approx((0.5 + 0.14) * (0.2 + end))); // With a margin for the blur.
  CHECK(area.halfSize.x == area.halfSize.y);
}

TEST_CASE("The camera at the light sees the whole box and little beside it, the lit side nearest") {
  Box box;
  box.add({-0.4, 0.2, -0.3});
  box.add({0.5, 1.8, 0.2});
  const Vec3 towardsLight = glm::normalize(Vec3(-0.55, 1.15, 0.75));
  const Mat4 projection = lightProjection(box, towardsLight);
  Box seen;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const Vec3 point((corner & 1U) != 0 ? box.maximum.x : box.minimum.x,
                     (corner & 2U) != 0 ? box.maximum.y : box.minimum.y,
                     (corner & 4U) != 0 ? box.maximum.z : box.minimum.z);
    seen.add(Vec3(projection * Vec4(point, 1.0)));
  }
  for (int axis = 0; axis < 3; ++axis) {
    CAPTURE(axis);
    CHECK(seen.minimum[axis] == Approx(-1.0 / 1.04)); // A fiftieth of it stays free at each end.
    CHECK(seen.maximum[axis] == Approx(1.0 / 1.04));
  }
  const Vec3 lit(box.minimum.x, box.maximum.y, box.maximum.z);
  CHECK((projection * Vec4(lit, 1.0)).z == Approx(-1.0 / 1.04));
}

TEST_CASE(
    "Arrows reach from foot to tip, with a head as large as asked for, and the farthest is drawn first") {
  const Arrow near{{0.0, 1.0, 1.0}, {0.0, 2.0, 1.0}, glm::vec4(1.0F, 0.0F, 0.0F, 1.0F), 3.0F, 13.0F};
  const Arrow far{{0.0, 1.0, -1.0}, {0.0, 2.0, -1.0}, glm::vec4(0.0F, 0.0F, 1.0F, 1.0F), 3.0F, 13.0F};
  const std::vector<SolidVertex> vertices = arrowMeshes(someView, std::vector<Arrow>{near, far});
  REQUIRE_FALSE(vertices.empty());
  CHECK(vertices.front().color == far.color);
  CHECK(vertices.back().color == near.color);
  const auto boxOf = [](const std::vector<SolidVertex>& corners) {
    Box box;
    for (const SolidVertex& corner : corners) {
      box.add(Vec3(corner.position) + someView.eye);
    }
    return box;
  };
  const Box whole = boxOf(arrowMeshes(someView, std::vector<Arrow>{near}));
  CHECK(whole.minimum.y == Approx(1.0).epsilon(1e-5));
  CHECK(whole.maximum.y == Approx(2.0).epsilon(1e-5));
  const double point = unitsPerPixel(someView, near.from);
  CHECK(whole.size().x == Approx(2.0 * 0.38 * 13.0 * point).epsilon(1e-3)); // Its head, the widest part.
  Arrow stub = near; // Shorter than its head: nothing of it stands out at its foot.
  stub.to = near.from + Vec3(0.0, 5.0 * point, 0.0);
  const Box head = boxOf(arrowMeshes(someView, std::vector<Arrow>{stub}));
  CHECK(head.minimum.y == Approx(1.0).epsilon(1e-5));
  CHECK(head.size().x == Approx(2.0 * 0.38 * 5.0 * point).epsilon(1e-3));
}

TEST_CASE("Arrows are closed solids whose faces look outwards") {
  const std::vector<Arrow> arrows{{{0.0, 1.0, 0.0}, {0.0, 2.0, 0.0}, glm::vec4(1.0F), 3.0F, 13.0F}};
  const std::vector<SolidVertex> vertices = arrowMeshes(someView, arrows);
  REQUIRE_FALSE(vertices.empty());
  for (std::size_t i = 0; i < vertices.size(); i += 3) {
    const glm::vec3 face = glm::cross(vertices[i + 1].position - vertices[i].position,
                                      vertices[i + 2].position - vertices[i].position);
    CHECK(glm::dot(face, vertices[i].normal + vertices[i + 1].normal + vertices[i + 2].normal) > 0.0F);
  }
  CHECK(arrowMeshes(someView, std::vector<Arrow>{{{1, 1, 1}, {1, 1, 1}, glm::vec4(1.0F), 3.0F, 13.0F}})
            .empty());
}

TEST_CASE("Quality falls when frames stay slow, rises when they stay fast, and does not swing") {
  QualityGovernor governor(2);
  for (int i = 0; i < 20; ++i) {
    governor.frameTook(0.1);
  }
  CHECK(governor.level() == 0);
  for (int i = 0; i < 500; ++i) {
    governor.frameTook(0.001);
  }
  CHECK(governor.level() == 0);

  QualityGovernor fast(1);
  for (int i = 0; i < 500; ++i) {
    fast.frameTook(0.001);
  }
  CHECK(fast.level() == highestQualityLevel);
  fast.frameTook(0.2);
  CHECK(fast.level() == highestQualityLevel);
}

TEST_CASE("The sixth slow frame in a row lowers the quality, the ninetieth fast one raises it") {
  const auto take = [](QualityGovernor& governor, int frames, double seconds) {
    for (int i = 0; i < frames; ++i) {
      governor.frameTook(seconds);
    }
    return governor.level();
  };
  constexpr double slow = 1.0 / 20.0;
  constexpr double usual = 1.0 / 60.0;
  constexpr double fast = 1.0 / 120.0;
  QualityGovernor falling(2);
  CHECK(take(falling, 5, slow) == 2);
  CHECK(take(falling, 1, usual) == 2); // It begins anew.
  CHECK(take(falling, 5, slow) == 2);
  CHECK(take(falling, 1, slow) == 1);
  CHECK(take(falling, 5, slow) == 1);
  CHECK(take(falling, 1, slow) == 0);
  QualityGovernor rising(1);
  CHECK(take(rising, 89, fast) == 1);
  CHECK(take(rising, 1, usual) == 1);
  CHECK(take(rising, 89, fast) == 1);
  CHECK(take(rising, 1, fast) == 2);
  CHECK(take(rising, 1000, usual) == 2);
}

TEST_CASE("Renderers that draw in software are told from graphics cards by their name") {
  for (const char* name : {"llvmpipe (LLVM 15.0.6, 256 bits)", "softpipe", "Mesa DRI swrast",
                           "Gallium 0.4 on SWR", "Software Rasterizer"}) {
    INFO(name);
    CHECK(isSoftwareRenderer(name));
  }
  for (const char* name : {"NVIDIA GeForce RTX 3060/PCIe/SSE2", "Mesa Intel(R) UHD Graphics 620 (KBL GT2)",
                           "AMD Radeon RX 6600 (radeonsi)", "Apple M1", ""}) {
    INFO(name);
    CHECK_FALSE(isSoftwareRenderer(name));
  }
}
