// What a clip does to the shading of a mesh in programs that turn normals by the joints' own matrices.
#include "app/forecast/shading.h"

#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/support/nodes.h"

using namespace stretch;
using namespace stretch::app;

namespace {

/// Four vertices: two whose normals lie between x and y and one whose normal is z on a joint of the left arm,
/// one on a joint of the right arm, and a clip of 21 frames that scales the left one along x.
struct ShadedArms {
  Document document;

  explicit ShadedArms(const std::vector<std::pair<double, double>>& scales,
                      const Vec3& axes = Vec3(1.0, 0.0, 0.0), bool hasNormals = true) {
    Scene scene;
    const NodeIndex left = test::addNode(scene, "left", NodeIndex::none, Vec3(0.0));
    const NodeIndex right = test::addNode(scene, "right", NodeIndex::none, Vec3(0.0));
    const NodeIndex body = test::addNode(scene, "body", NodeIndex::none, Vec3(0.0));
    Skin skin;
    skin.joints = {left, right};
    skin.inverseBind.assign(2, Mat4(1.0));
    scene.skins.push_back(skin);
    Primitive primitive;
    const glm::vec3 between(0.70710678F, 0.70710678F, 0.0F);
    primitive.positions = {{1.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}, {-1.0F, 0.0F, 0.0F}, {0.0F, -1.0F, 0.5F}};
    primitive.normals = {between, {0.0F, 0.0F, 1.0F}, between, between};
    primitive.hasNormals = hasNormals;
    primitive.influences.resize(4);
    for (VertexInfluences& vertex : primitive.influences) {
      vertex.weights[0] = 1.0F;
    }
    primitive.influences[3].joints[0] = 1;
    scene.nodes[at(body)].mesh = 0;
    scene.nodes[at(body)].skin = 0;
    scene.meshes.push_back({"body", {primitive}, {}});
    document.scene = std::make_shared<const Scene>(std::move(scene));
    document.body.limbs = {limbOf(rig::biped::leftArm, left), limbOf(rig::biped::rightArm, right)};
    Track track;
    track.node = left;
    track.channel = Channel::scale;
    for (const auto& [frame, scale] : scales) {
      track.times.push_back(static_cast<float>(frame / 30.0));
      for (const double axis : {axes.x, axes.y, axes.z}) {
        track.values.push_back(static_cast<float>(1.0 + axis * (scale - 1.0)));
      }
    }
    Clip clip;
    clip.endSeconds = static_cast<double>(track.times.back());
    clip.tracks.emplace_back(std::move(track));
    document.clips = std::make_shared<const std::vector<Clip>>(std::vector<Clip>{clip});
  }

private:
  static rig::Limb limbOf(const rig::LimbPlace& place, NodeIndex joint) {
    rig::Limb limb;
    static_cast<rig::LimbPlace&>(limb) = place;
    limb.id = rig::limbName(place);
    limb.joints = {joint};
    return limb;
  }
};

} // namespace

TEST_CASE("Normals that the joints' own matrices turn by more than 20 degrees too far are told, with limb "
          "and frame") {
  const ShadedArms arms({{0.0, 1.0}, {10.0, 2.0}, {20.0, 1.0}});
  const ClipLooks looks = clipLooks(arms.document, 0);
  CHECK(looks.clip == 0);
  CHECK(looks.moved == 3);
  CHECK(looks.wronglyShaded == 2); // What points along an axis is turned by neither.
  CHECK(looks.share() == Approx(2.0 / 3.0));
  // From a scale of 1.43 on; of twice the length it is the angle between (2, 1) and (1, 2).
  CHECK(looks.frame == 5.0);
  CHECK(looks.worstDegrees == Approx(36.8699).epsilon(1e-4));
  CHECK(looks.limb == "left-arm");
  CHECK(looks.box.low.x == Approx(-2.0));
  CHECK(looks.box.high.x == Approx(2.0));
  CHECK(looks.box.high.z == Approx(0.5));
  CHECK(restBox(arms.document).high.x == Approx(1.0));
  CHECK(restBox(arms.document).low.y == Approx(-1.0));
}

TEST_CASE(
    "Vertices are moved by a joint that scales unequally by what is seen, if the file has their normals") {
  const auto looksOf = [](double scale, const Vec3& axes, bool hasNormals = true) {
    return clipLooks(ShadedArms({{0.0, scale}, {2.0, scale}}, axes, hasNormals).document, 0);
  };
  const Vec3 along(1.0, 0.0, 0.0);
  CHECK(looksOf(1.016, along).moved == 3);
  CHECK(looksOf(1.014, along).moved == 0);
  CHECK(looksOf(2.0, Vec3(1.0)).moved == 0);
  CHECK(looksOf(2.0, along).wronglyShaded == 2);
  CHECK(looksOf(2.0, along, false).moved == 0);
  CHECK(looksOf(2.0, along, false).wronglyShaded == 0);
  CHECK(looksOf(1.4, along).wronglyShaded == 0); // 19 degrees
  CHECK(looksOf(1.4, along).limb.empty());
  CHECK(looksOf(0.69, along).wronglyShaded == 2); // as far to the other side as 1.43
}
