// Each part of a trail that has a side, mirrored; and the spheres of a trail one by one.
#include <memory>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "app/edits/trail/mirror_edits.h"
#include "app/edits/trail/sphere_edits.h"
#include "app/edits/trail/trail_edits.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/new_trail.h"

using namespace stretch;
using namespace stretch::app;

namespace {

rig::TrailSettings sidedSettings() {
  rig::TrailSettings settings;
  settings.spheres = {{4.0, Vec3(0.3, 0.2, 0.1), Vec3(0.05, -0.02, 0.01)}, {6.0, Vec3(-0.1, 0.0, 0.4), {}}};
  settings.stopAt = rig::StopPlane{Vec3(0.5, 0.1, 0.2), Vec3(0.6, -0.8, 0.0)};
  return settings;
}

const Vec3 leftwards(1.0, 0.0, 0.0);
const Vec3 throughBody(0.2, 0.0, 0.0);

/// A trail that was pulled, and is done with.
Document appliedDocument(bool follow = true) {
  Document document = test::withNewTrail(test::boxer(), {});
  rig::Trail& trail = document.trails.front();
  trail.settings.spheres = {{5.0, Vec3(0.0, 0.1, 0.0), {}}};
  trail.connected = trail.follow = follow;
  trail.applied = follow;
  return document;
}

} // namespace

TEST_CASE("What is pulled, its tangents and the stop change sides with a trail, and keep their heights") {
  const rig::TrailSettings mirrored = mirroredSettings(sidedSettings(), leftwards, throughBody);
  REQUIRE(mirrored.spheres.size() == 2);
  CHECK(mirrored.spheres[0].offset == Vec3(-0.3, 0.2, 0.1));
  CHECK(mirrored.spheres[0].tangent == Vec3(-0.05, -0.02, 0.01));
  CHECK(mirrored.spheres[1].offset == Vec3(0.1, 0.0, 0.4));
  CHECK_FALSE(mirrored.spheres[1].tangent);
  REQUIRE(mirrored.stopAt);
  CHECK(glm::length(mirrored.stopAt->point - Vec3(-0.1, 0.1, 0.2)) < 1e-12); // As far beyond the body's
                                                                             // middle.
  CHECK(mirrored.stopAt->normal == Vec3(-0.6, -0.8, 0.0));
}

TEST_CASE("What is pulled along the axes of a view changes the view's sides, whatever way the body faces") {
  const Vec3 aslant(0.6, 0.0, 0.8);
  rig::TrailSettings settings = sidedSettings();
  settings.space = rig::TrailSpace::view;
  settings.viewAxes = Mat3(Vec3(0, 0, -1), Vec3(0, 1, 0), Vec3(1, 0, 0)); // From the body's left.
  const rig::TrailSettings mirrored = mirroredSettings(settings, aslant, throughBody);
  CHECK(mirrored.spheres[0].offset == Vec3(-0.3, 0.2, 0.1));
  CHECK(mirrored.spheres[0].tangent == Vec3(-0.05, -0.02, 0.01));
  // In the world that is the mirror image of what it was.
  const Vec3 before = settings.viewAxes * settings.spheres[0].offset;
  const Vec3 after = mirrored.viewAxes * mirrored.spheres[0].offset;
  CHECK(glm::length(after - reflected(before, aslant)) < 1e-12);
}

TEST_CASE("A sphere that is set has the tangent that is given, and loses it with one that has none") {
  const Document document = test::withNewTrail(test::boxer(), {});
  const int trail = document.trails.front().id;
  const rig::SphereOffset wanted{5.0, Vec3(0.1, 0.0, 0.0), Vec3(0.0, 0.02, 0.0)};
  const Result<Document> set = setSphereOffset(document, trail, wanted);
  REQUIRE(set);
  CHECK(set->trails.front().settings.spheres == std::vector<rig::SphereOffset>{wanted});
  const Result<Document> again = setSphereOffset(*set, trail, {5.0, Vec3(0.2, 0.0, 0.0), {}});
  REQUIRE(again);
  CHECK(again->trails.front().settings.spheres ==
        std::vector<rig::SphereOffset>{{5.0, Vec3(0.2, 0.0, 0.0), {}}});
}

TEST_CASE("The first and the last sphere of a trail stay, whichever are taken away") {
  const Document document = test::withNewTrail(test::boxer(), {});
  const int trail = document.trails.front().id;
  const std::vector<double> present{0.0, 3.0, 6.0, 10.0};
  const auto left = [&](const std::vector<double>& frames) {
    const Result<Document> changed = removeSpheres(document, trail, present, frames);
    REQUIRE(changed);
    return changed->trails.front().controlFrames;
  };
  CHECK(left({3.0}) == std::vector<double>{0.0, 6.0, 10.0});
  CHECK(left({0.0, 3.0, 10.0}) == std::vector<double>{0.0, 6.0, 10.0});
  CHECK(left({3.0, 6.0, 10.0}) == std::vector<double>{0.0, 10.0});
}

TEST_CASE("Spheres that are set at one frame are one, in order of time") {
  const Document document = test::withNewTrail(test::boxer(), {});
  const Result<Document> changed =
      setControlFrames(document, document.trails.front().id, {6.0, 0.0, 6.0, 10.0, 0.0});
  REQUIRE(changed);
  CHECK(changed->trails.front().controlFrames == std::vector<double>{0.0, 6.0, 10.0});
}

TEST_CASE("A trail that was done with is so no longer once a sphere is pulled, and stays so where none is") {
  const Document document = appliedDocument();
  const int trail = document.trails.front().id;
  const std::vector<SphereMove> moved{{5.0, Vec3(0.0, 0.1, 0.0)}};
  const std::vector<SphereMove> still{{5.0, Vec3(0.0)}};
  CHECK_FALSE(moveSpheres(document, trail, moved)->trails.front().applied);
  CHECK(moveSpheres(document, trail, still)->trails.front().applied);
}

TEST_CASE("Of a trail that was done with other spheres bend anew what was pulled, and nothing else") {
  Document document = appliedDocument();
  const int trail = document.trails.front().id;
  CHECK_FALSE(setControlFrames(document, trail, {0.0, 4.0, 10.0})->trails.front().applied);
  document.trails.front().settings.spheres.clear();
  CHECK(setControlFrames(document, trail, {0.0, 4.0, 10.0})->trails.front().applied);
}

TEST_CASE("A sphere of a path that was not exaggerated is pulled off it, and the character follows") {
  Document document = appliedDocument();
  rig::Trail& trail = document.trails.front();
  trail.exaggerated = trail.connected = trail.applied = false;
  const Result<Document> pulled =
      moveSpheres(document, trail.id, std::vector<SphereMove>{{5.0, Vec3(0.0, 0.1, 0.0)}});
  REQUIRE(pulled);
  CHECK(pulled->trails.front().exaggerated);
  CHECK(pulled->trails.front().connected);
}
