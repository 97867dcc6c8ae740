#include <limits>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "core/math/transform.h"
#include "tests/support/core/glb_builder.h"

using namespace stretch;
using gltf::Json;

namespace {

// Cameras of the arm's file, by the nodes that carry them; the first one is the builder's own.
test::GlbBuilder withCameras() {
  test::GlbBuilder glb = test::armBuilder();
  glb.json["cameras"] = {{{"type", "perspective"},
                          {"name", "Lens"},
                          {"perspective", {{"yfov", 0.5}, {"znear", 0.1}, {"aspectRatio", 1.5}}}},
                         {{"type", "orthographic"},
                          {"name", "Flat"},
                          {"orthographic", {{"xmag", 4.0}, {"ymag", -2.0}, {"znear", 0.1}, {"zfar", 9}}}},
                         {{"type", "perspective"}, {"perspective", {{"yfov", 0.0}, {"znear", 0.1}}}},
                         {{"type", "fisheye"}, {"fisheye", {{"yfov", 1.0}}}}};
  for (const auto& [name, camera] :
       {std::pair("Shot", 0), {"", 1}, {"Shot", 0}, {"", 0}, {"broken", 2}, {"odd", 3}}) {
    Json node{{"camera", camera}};
    if (*name != '\0') {
      node["name"] = name;
    }
    glb.json["nodes"].push_back(node);
  }
  return glb;
}

} // namespace

TEST_CASE("the file's cameras are read with their lens, each under a name of its own") {
  const test::GlbBuilder glb = withCameras();
  const gltf::Loaded file = test::loaded(glb);
  const std::vector<SceneCamera>& cameras = file.scene->cameras;
  REQUIRE(cameras.size() == 5);
  const int first = static_cast<int>(glb.json["nodes"].size()) - 6;
  CHECK(cameras[0].name == "camera"); // the builder's own node
  CHECK(cameras[1].name == "Shot");
  CHECK(cameras[1].node == NodeIndex(first));
  CHECK(cameras[1].kind == CameraKind::perspective);
  CHECK(cameras[1].fieldOfViewRadians == 0.5);
  CHECK(cameras[1].aspect == 1.5);
  CHECK(cameras[2].name == "Flat");
  CHECK(cameras[2].kind == CameraKind::orthographic);
  CHECK(cameras[2].halfHeight == 2.0);
  CHECK(cameras[2].aspect == 2.0);
  CHECK(cameras[3].name == "Shot #" + std::to_string(first + 2));
  CHECK(cameras[4].name == "Lens");
  CHECK(cameraNamed(*file.scene, "Flat") == &cameras[2]);
  CHECK(cameraNamed(*file.scene, "broken") == nullptr);
  CHECK(test::warnsOf(file, "cameras[2] and 1 more")); // one line for what is alike
}

TEST_CASE("a flat camera of negative magnifications shows as much as one of positive ones") {
  test::GlbBuilder glb = withCameras();
  glb.json["cameras"][1]["orthographic"]["xmag"] = -4.0;
  const gltf::Loaded file = test::loaded(glb);
  const SceneCamera* const flat = cameraNamed(*file.scene, "Flat");
  REQUIRE(flat != nullptr);
  CHECK(flat->halfHeight == 2.0);
  CHECK(flat->aspect == 2.0);
}

TEST_CASE("a camera stands at its node, looks along -Z and is not bent by its scale") {
  Mat4 world = toMatrix({Vec3(1.0, 2.0, 3.0), axisAngle(Vec3(0.0, 1.0, 0.0), 0.5 * pi), Vec3(1.0)});
  world[0] *= 3.0;
  world[2] *= 0.5;
  const std::optional<CameraPlace> place = cameraPlace(CameraKind::perspective, world);
  REQUIRE(place);
  CHECK(glm::length(place->position - Vec3(1.0, 2.0, 3.0)) < 1e-12);
  CHECK(glm::length(place->forward - Vec3(-1.0, 0.0, 0.0)) < 1e-12);
  CHECK(glm::length(place->right - Vec3(0.0, 0.0, -1.0)) < 1e-12);
  CHECK(glm::length(place->up - Vec3(0.0, 1.0, 0.0)) < 1e-12);
  world[2] = Vec4(0.0);
  CHECK_FALSE(cameraPlace(CameraKind::perspective, world));
}

TEST_CASE("a point lies in the picture by its depth in perspective, and not behind the eye") {
  CameraPlace camera{CameraKind::perspective, Vec3(0.0, 0.0, 4.0)};
  CHECK(glm::length(inPicture(camera, Vec3(1.0, 0.5, 2.0)).value() - Vec2(0.5, 0.25)) < 1e-12);
  CHECK_FALSE(inPicture(camera, Vec3(0.0, 0.0, 5.0)));
  CHECK(glm::length(towardsEye(camera, Vec3(3.0, 0.0, 0.0)) - Vec3(-0.6, 0.0, 0.8)) < 1e-12);
  camera.kind = CameraKind::orthographic;
  CHECK(glm::length(inPicture(camera, Vec3(1.0, 0.5, 9.0)).value() - Vec2(1.0, 0.5)) < 1e-12);
  CHECK(towardsEye(camera, Vec3(3.0, 0.0, 0.0)) == Vec3(0.0, 0.0, 1.0));
  CHECK(focalLength(2.0 * std::atan(0.5)) == Approx(24.0));
  for (const Vec3& eye : {Vec3(0.0, 1.0, 0.0), Vec3(0.0, -2.0, 0.0), Vec3(1.0, 0.2, -3.0)}) {
    const CameraPlace looking = cameraFrom(eye);
    CHECK(glm::length(looking.forward + glm::normalize(eye)) < 1e-12);
    CHECK(glm::length(glm::cross(looking.right, looking.up) + looking.forward) < 1e-12);
    CHECK(looking.up.y > -1e-12);
  }
}

TEST_CASE("seen from straight above and from straight below the world's x runs to the right") {
  const CameraPlace above = cameraFrom(Vec3(0.0, 3.0, 0.0));
  CHECK(glm::length(above.right - Vec3(1.0, 0.0, 0.0)) < 1e-12);
  CHECK(glm::length(above.up - Vec3(0.0, 0.0, -1.0)) < 1e-12);
  const CameraPlace below = cameraFrom(Vec3(0.0, -3.0, 0.0));
  CHECK(glm::length(below.right - Vec3(1.0, 0.0, 0.0)) < 1e-12);
  CHECK(glm::length(below.up - Vec3(0.0, 0.0, 1.0)) < 1e-12);
}

TEST_CASE(
    "nobody looks through a camera that stands at no number, or whose axes are too long to be counted") {
  CHECK(cameraPlace(CameraKind::perspective, Mat4(1.0)));
  for (int axis = 0; axis < 3; ++axis) {
    Mat4 nowhere(1.0);
    nowhere[3][axis] = std::numeric_limits<double>::infinity();
    CHECK_FALSE(cameraPlace(CameraKind::perspective, nowhere));
  }
  Mat4 huge(1.0);
  huge[2] *= 1e200;
  CHECK_FALSE(cameraPlace(CameraKind::perspective, huge));
}
