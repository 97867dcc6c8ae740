// Bones that pose a mesh, centre lines of bodies, words of files: small pieces against what is calculated by
// hand.
#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "core/math/transform.h"
#include "skinning/body/body_skeleton.h"
#include "skinning/sequence/text.h"
#include "skinning/skinned_sequence.h"

using namespace stretch;
using namespace stretch::skinning;

namespace {

bool isClose(const Vec3& is, const Vec3& wanted) {
  return glm::length(is - wanted) < 1e-6;
}

/// Two bones, the second beginning at (2, 0, 0), over two frames.
SkinnedSequence twoBones() {
  SkinnedSequence skinned;
  skinned.name = "arm";
  skinned.framesPerSecond = 12.0;
  skinned.bindPositions = {{1, 0, 0}, {3, 1, 0}, {2, 0, 0}};
  skinned.triangles = {{0, 1, 2}};
  skinned.bones.resize(2);
  skinned.bones[1].pivot = Vec3(2.0, 0.0, 0.0);
  skinned.bones[1].name = "hand";
  skinned.influences.resize(3);
  skinned.influences[0].weights[0] = 1.0F;
  skinned.influences[1].bones[0] = 1;
  skinned.influences[1].weights[0] = 1.0F;
  skinned.influences[2].bones[7] = 1;
  skinned.influences[2].weights[0] = 0.25F;
  skinned.influences[2].weights[7] = 0.75F;
  skinned.poses.resize(4);
  for (std::size_t k = 0; k < 2; ++k) {
    skinned.pose(k, 1).position = skinned.bones[1].pivot;
  }
  return skinned;
}

} // namespace

TEST_CASE("A bone turns and stretches about its pivot, along its stretch axes, and then moves") {
  SkinBone bone;
  bone.pivot = Vec3(1.0, 2.0, 3.0);
  BonePose pose;
  pose.position = Vec3(10.0, 0.0, 0.0);
  CHECK(isClose(transformPoint(skinMatrix(bone, pose), bone.pivot), pose.position));
  CHECK(isClose(transformPoint(skinMatrix(bone, pose), Vec3(2.0, 2.0, 3.0)), Vec3(11.0, 0.0, 0.0)));
  pose.rotation = glm::angleAxis(glm::radians(90.0), Vec3(0.0, 0.0, 1.0));
  CHECK(isClose(transformPoint(skinMatrix(bone, pose), Vec3(2.0, 2.0, 3.0)), Vec3(10.0, 1.0, 0.0)));
  pose.scale = Vec3(3.0, 1.0, 0.5);
  CHECK(isClose(transformPoint(skinMatrix(bone, pose), Vec3(2.0, 3.0, 5.0)), Vec3(9.0, 3.0, 1.0)));
  pose.stretchAxes = glm::angleAxis(glm::radians(90.0), Vec3(0.0, 0.0, 1.0)); // x along y
  CHECK(isClose(transformPoint(skinMatrix(bone, pose), Vec3(2.0, 3.0, 5.0)), Vec3(7.0, 1.0, 1.0)));
}

TEST_CASE("Frames of a skinned mesh follow its bones by weight, whichever slot names them") {
  SkinnedSequence skinned = twoBones();
  skinned.pose(1, 0).position = Vec3(0.0, 4.0, 0.0);
  skinned.pose(1, 1).rotation = glm::angleAxis(glm::radians(90.0), Vec3(0.0, 0.0, 1.0));
  skinned.pose(1, 1).position = Vec3(2.0, 0.0, 8.0);
  const MeshSequence shown = skinAllFrames(skinned);
  CHECK(shown.name == "arm");
  CHECK(shown.framesPerSecond == 12.0);
  CHECK(shown.triangles == skinned.triangles);
  CHECK(shown.frameNames == std::vector<std::string>{"frame 0", "frame 1"});
  REQUIRE(shown.frameCount() == 2);
  for (std::size_t v = 0; v < 3; ++v) {
    CHECK(isClose(Vec3(shown.frame(0)[v]), Vec3(skinned.bindPositions[v])));
  }
  CHECK(isClose(Vec3(shown.frame(1)[0]), Vec3(1.0, 4.0, 0.0)));
  CHECK(isClose(Vec3(shown.frame(1)[1]), Vec3(1.0, 1.0, 8.0)));
  CHECK(isClose(Vec3(shown.frame(1)[2]), 0.25 * Vec3(2.0, 4.0, 0.0) + 0.75 * Vec3(2.0, 0.0, 8.0)));
}

TEST_CASE("How far a bone is scaled is told over all frames and axes, with the first frame of each") {
  SkinnedSequence skinned = twoBones();
  CHECK(scaleRangeOf(skinned, 0).least == 1.0);
  CHECK(scaleRangeOf(skinned, 0).most == 1.0);
  skinned.pose(0, 1).scale = Vec3(1.0, 1.5, 1.0);
  skinned.pose(1, 1).scale = Vec3(0.5, 1.5, 3.0);
  const ScaleRange range = scaleRangeOf(skinned, 1);
  CHECK(range.least == 0.5);
  CHECK(range.leastFrame == 1);
  CHECK(range.most == 3.0);
  CHECK(range.mostFrame == 1);
  skinned.pose(1, 1).scale = Vec3(1.5, 1.0, 1.0);
  CHECK(scaleRangeOf(skinned, 1).mostFrame == 0); // the first that is so large
  CHECK(scaleRangeOf(skinned, 0).most == 1.0);
}

TEST_CASE("A bone without a name is called by its number") {
  const SkinnedSequence skinned = twoBones();
  CHECK(nameOfBone(skinned, 0) == "bone_0");
  CHECK(nameOfBone(skinned, 1) == "hand");
}

TEST_CASE("A mesh without bones is the first frame of its sequence") {
  MeshSequence sequence;
  sequence.name = "flag";
  sequence.clipName = "wave";
  sequence.vertexCount = 2;
  sequence.positions = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {10, 11, 12}};
  sequence.framesPerSecond = 5.0;
  const SkinnedSequence skinned = withoutBones(sequence);
  CHECK(skinned.bindPositions == std::vector<glm::vec3>{{1, 2, 3}, {4, 5, 6}});
  CHECK(skinned.name == "flag");
  CHECK(skinned.clipName == "wave");
  CHECK(skinned.framesPerSecond == 5.0);
  CHECK(skinned.frameCount() == 0);
}

TEST_CASE("The curvature of a line is the sum of the angles between its segments") {
  CHECK(totalCurvature({Vec3(0.0), Vec3(1.0, 0.0, 0.0), Vec3(5.0, 0.0, 0.0)}) == Approx(0.0).margin(1e-9));
  CHECK(totalCurvature({Vec3(0.0), Vec3(1.0, 0.0, 0.0), Vec3(1.0, 7.0, 0.0), Vec3(1.0, 7.0, 2.0)}) ==
        Approx(pi));
  CHECK(totalCurvature({Vec3(0.0), Vec3(1.0, 0.0, 0.0), Vec3(2.0, 1.0, 0.0), Vec3(3.0, 1.0, 0.0)}) ==
        Approx(0.5 * pi));
  CHECK(totalCurvature({Vec3(0.0), Vec3(1.0, 0.0, 0.0)}) == 0.0);
}

TEST_CASE("A place along a body belongs to the segment that it lies in, at the ends to the outermost") {
  BodySkeleton skeleton;
  skeleton.joints.resize(4);
  skeleton.stations = {10.0, 12.0, 14.0, 16.0};
  CHECK(skeleton.segmentCount() == 3);
  CHECK(segmentAt(skeleton, 11.9) == 0);
  CHECK(segmentAt(skeleton, 12.1) == 1);
  CHECK(segmentAt(skeleton, 15.0) == 2);
  CHECK(segmentAt(skeleton, 0.0) == 0);
  CHECK(segmentAt(skeleton, 99.0) == 2);
  skeleton.along = {10.0, 11.0, 13.5, 15.0, 16.0};
  CHECK(segmentsOfTriangles(skeleton, {{0, 1, 2}, {2, 3, 4}, {1, 2, 3}}) == std::vector<int>{0, 2, 1});
}

TEST_CASE("Lines of a text end with either kind of line end, the last one with none") {
  const auto linesOf = [](std::string_view text) {
    std::vector<std::string> lines;
    std::string_view line;
    while (nextLine(text, line)) {
      lines.emplace_back(line);
    }
    return lines;
  };
  using Lines = std::vector<std::string>;
  CHECK(linesOf("").empty());
  CHECK(linesOf("a") == Lines{"a"});
  CHECK(linesOf("a\n") == Lines{"a"});
  CHECK(linesOf("a\r\nb c\n\n\rd\r") == Lines{"a", "b c", "", "\rd"});
}

TEST_CASE("Words are cut off between blanks of any kind, names keep those inside") {
  std::string_view text = " \tv\v1.5\f-2 \r";
  CHECK(nextWord(text) == "v");
  CHECK(nextWord(text) == "1.5");
  CHECK(nextWord(text) == "-2");
  CHECK(nextWord(text).empty());
  CHECK(text.empty());
  std::string_view one = "word";
  CHECK(nextWord(one) == "word");
  CHECK(one.empty());
  CHECK(trimmed(" \ta b\t ") == "a b");
  CHECK(trimmed("ab") == "ab");
  CHECK(trimmed(" \t ").empty());
  CHECK(trimmed("").empty());
  CHECK(lowerExtension("/Some/Where.d/FILE.ObJ") == ".obj");
  CHECK(lowerExtension("none").empty());
  CHECK(placeOf("a.obj", 12) == "a.obj:12");
}
