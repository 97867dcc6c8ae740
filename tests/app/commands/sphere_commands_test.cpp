// Control spheres by commands: which is next, where a nudge or a slide takes them, what is added and taken
// away.
#include "app/commands/trail/spheres.h"

#include <tuple>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "app/commands/pose/hold.h"
#include "app/commands/table/command_ids.h"
#include "app/commands/table/selection.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/new_trail.h"
#include "tests/support/app/run_command.h"
#include "tests/support/refusal.h"

using namespace stretch;
using namespace stretch::app;
using test::run;
using Frames = std::vector<double>;

namespace {

const Mat3 axesFromTheSide(Vec3(0.0, 0.0, -1.0), Vec3(0.0, 1.0, 0.0), Vec3(1.0, 0.0, 0.0));

/// The left arm's trail over the frames 0 to 10 with spheres at 0, 4 and 10.
Document withThreeSpheres(rig::TrailSpace space = rig::TrailSpace::world) {
  Document document = test::withNewTrail(test::boxer(), {});
  rig::Trail& trail = document.trails.front();
  trail.controlFrames = {0.0, 4.0, 10.0};
  trail.settings.space = space;
  trail.settings.viewAxes = axesFromTheSide;
  return document;
}

Session spheresSelected(const Document& document, const Frames& frames) {
  Session session(document);
  selectTrail(session, document.trails.front().id);
  session.view().selection.editTrails().spheres = frames;
  return session;
}

const rig::Trail& trailOf(const Session& session) {
  return session.document().trails.front();
}

/// How far the spheres were pulled, in the world, in the order of their frames.
std::vector<std::pair<double, Vec3>> pullsOf(const Session& session) {
  const rig::TrailSettings& settings = trailOf(session).settings;
  const bool isView = settings.space == rig::TrailSpace::view;
  std::vector<std::pair<double, Vec3>> pulls;
  for (const rig::SphereOffset& sphere : settings.spheres) {
    pulls.emplace_back(sphere.frame, isView ? settings.viewAxes * sphere.offset : sphere.offset);
  }
  return pulls;
}

} // namespace

TEST_CASE("Tab goes from sphere to sphere, round and round, from the one at the playhead on") {
  Session session = spheresSelected(withThreeSpheres(), {});
  const auto goes = [&](const char* command) {
    CHECK(run(session, command).empty());
    CHECK(session.view().selection.spheres() == Frames{session.view().frame});
    return session.view().frame;
  };
  session.view().frame = 4.0;
  CHECK(goes(command::sphereNext) == 4.0);
  CHECK(goes(command::sphereNext) == 10.0);
  CHECK(goes(command::sphereNext) == 0.0);
  CHECK(goes(command::spherePrevious) == 10.0);
  CHECK(goes(command::spherePrevious) == 4.0);
  CHECK(goes(command::spherePrevious) == 0.0);
  for (const auto& [frame, next, before] : {std::tuple(4.0, 4.0, 4.0), {3.0, 4.0, 0.0}, {12.0, 0.0, 10.0}}) {
    for (const bool forwards : {true, false}) {
      session.view().selection.dropSpheres();
      session.view().frame = frame;
      CHECK(goes(forwards ? command::sphereNext : command::spherePrevious) == (forwards ? next : before));
    }
  }
}

TEST_CASE("Nudged spheres go where the view shows, whichever axes their trail has, and no others go") {
  for (const rig::TrailSpace space : {rig::TrailSpace::world, rig::TrailSpace::view}) {
    Session session = spheresSelected(withThreeSpheres(space), {4.0, 10.0});
    const double step = nudgeUnits(session.document());
    REQUIRE(run(session, "sphere.nudge-right").empty());
    for (const auto& [frame, pull] : pullsOf(session)) {
      CAPTURE(frame);
      CHECK(glm::length(pull - Vec3(step, 0.0, 0.0)) < 1e-12);
    }
    CHECK(pullsOf(session).size() == 2);
    session.view().cameraAxes = axesFromTheSide;
    REQUIRE(run(session, "sphere.nudge-right").empty());
    REQUIRE(pullsOf(session).size() == 2);
    CHECK(glm::length(pullsOf(session)[0].second - Vec3(step, 0.0, -step)) < 1e-12);
  }
}

TEST_CASE("Spheres slide along the path from neighbour to neighbour, those at its ends along its ends") {
  for (const rig::TrailSpace space : {rig::TrailSpace::world, rig::TrailSpace::view}) {
    for (const bool forwards : {true, false}) {
      CAPTURE(forwards);
      Session session = spheresSelected(withThreeSpheres(space), {});
      const std::vector<PlacedSphere> placed = placedSpheres(session, trailOf(session).id);
      REQUIRE(placed.size() == 3);
      const double step = (forwards ? 1.0 : -1.0) * nudgeUnits(session.document());
      const auto along = [&](std::size_t from, std::size_t to) {
        return step * glm::normalize(placed[to].positionWorld - placed[from].positionWorld);
      };
      const std::vector<Vec3> wanted{along(0, 1), along(0, 2), along(1, 2)};
      REQUIRE(run(session, command::sphereAll).empty());
      CHECK(session.view().selection.spheres() == Frames{0.0, 4.0, 10.0});
      REQUIRE(run(session, forwards ? command::sphereAlongForward : command::sphereAlongBack).empty());
      const std::vector<std::pair<double, Vec3>> pulls = pullsOf(session);
      REQUIRE(pulls.size() == 3);
      for (std::size_t i = 0; i < 3; ++i) {
        CHECK(pulls[i].first == placed[i].frame);
        CHECK(glm::length(pulls[i].second - wanted[i]) < 1e-9);
      }
    }
  }
  Session one = spheresSelected(withThreeSpheres(), {4.0});
  REQUIRE(run(one, command::sphereAlongForward).empty());
  REQUIRE(pullsOf(one).size() == 1);
  CHECK(pullsOf(one)[0].first == 4.0);
}

TEST_CASE("Tangents are taken from the selected spheres alone, and pulls with them when those are put back") {
  const Vec3 rising(0.0, 0.02, 0.0);
  Document document = withThreeSpheres();
  document.trails.front().settings.spheres = {{0.0, Vec3(0.1, 0.0, 0.0), rising},
                                              {4.0, Vec3(0.2, 0.0, 0.0), rising},
                                              {10.0, Vec3(0.3, 0.0, 0.0), {}}};
  Session session = spheresSelected(document, {0.0, 10.0});
  REQUIRE(run(session, command::sphereSmooth).empty());
  std::vector<rig::SphereOffset> left = document.trails.front().settings.spheres;
  left[0].tangent.reset();
  CHECK(trailOf(session).settings.spheres == left);
  session.view().selection.editTrails().spheres = {10.0};
  CHECK(run(session, command::sphereSmooth) == "select a sphere with a tangent of its own");
  session.view().selection.editTrails().spheres = {0.0, 4.0};
  REQUIRE(run(session, command::sphereReset).empty());
  CHECK(trailOf(session).settings.spheres == std::vector<rig::SphereOffset>{left[2]});
  CHECK(run(session, command::sphereReset) == "select a sphere that was pulled");
}

TEST_CASE("A deleted sphere at an end of its trail is put back and stays selected, one between is gone") {
  Document document = withThreeSpheres();
  document.trails.front().settings.spheres = {{0.0, Vec3(0.1, 0.0, 0.0), {}}, {4.0, Vec3(0.2, 0.0, 0.0), {}}};
  Session session = spheresSelected(document, {0.0});
  REQUIRE(run(session, command::editDelete).empty());
  CHECK(session.history().undoLabel() == "Put the spheres back");
  CHECK(session.view().selection.spheres() == Frames{0.0});
  CHECK(trailOf(session).controlFrames == Frames{0.0, 4.0, 10.0});
  CHECK(pullsOf(session).size() == 1);
  session.view().selection.editTrails().spheres = {4.0, 10.0};
  REQUIRE(run(session, command::editDelete).empty());
  CHECK(session.history().undoLabel() == "Remove the spheres");
  CHECK(session.view().selection.spheres().empty());
  CHECK(trailOf(session).controlFrames == Frames{0.0, 10.0});
  CHECK(pullsOf(session).empty());
}

TEST_CASE("A sphere is added within the range where there is room for it, else the one there is selected") {
  Session session = spheresSelected(withThreeSpheres(), {});
  for (const auto& [frame, sphere] : {std::pair(0.0, 0.0), std::pair(4.2, 4.0), std::pair(10.0, 10.0)}) {
    REQUIRE(addSphere(session, frame));
    CHECK(session.view().selection.spheres() == Frames{sphere});
  }
  CHECK_FALSE(session.history().canUndo());
  for (const double outside : {-0.5, 10.5}) {
    CHECK_THAT(test::refusal(addSphere(session, outside)), Catch::StartsWith("the frame lies outside"));
  }
  REQUIRE(addSphere(session, 4.5));
  CHECK(trailOf(session).controlFrames == Frames{0.0, 4.0, 4.5, 10.0});
  CHECK(session.view().selection.spheres() == Frames{4.5});
  selectTrail(session, 0);
  CHECK_THAT(test::refusal(addSphere(session, 4.0)), Catch::StartsWith("no trail is selected"));
}

TEST_CASE("A limb is pulled by the sphere at the playhead, or by one that is put there") {
  Session session = spheresSelected(withThreeSpheres(), {});
  const int trail = trailOf(session).id;
  double frame = 4.2;
  const Result<Document> there = withSphereAt(session, trail, frame);
  REQUIRE(there);
  CHECK(frame == 4.0);
  CHECK(there->trails.front().controlFrames == Frames{0.0, 4.0, 10.0});
  frame = 7.0;
  const Result<Document> put = withSphereAt(session, trail, frame);
  REQUIRE(put);
  CHECK(frame == 7.0);
  CHECK(put->trails.front().controlFrames == Frames{0.0, 4.0, 7.0, 10.0});
  CHECK_THAT(test::refusal(withSphereAt(session, 99, frame)),
             Catch::StartsWith("trail 99: there is no such"));
}

TEST_CASE(
    "A sphere has handles a third of the way to its neighbours, and none where nothing is exaggerated") {
  Session session = spheresSelected(withThreeSpheres(), {});
  const std::vector<PlacedSphere> placed = placedSpheres(session, trailOf(session).id);
  REQUIRE(placed.size() == 3);
  struct Side {
    std::size_t sphere;
    std::vector<std::size_t> neighbours;
  };
  for (const Side& side : {Side{0, {1}}, Side{1, {0, 2}}, Side{2, {1}}}) {
    CAPTURE(side.sphere);
    const std::vector<TangentHandle> handles = tangentHandles(session, placed[side.sphere].frame);
    REQUIRE(handles.size() == side.neighbours.size());
    for (std::size_t i = 0; i < handles.size(); ++i) {
      const PlacedSphere& neighbour = placed[side.neighbours[i]];
      const Vec3 way = neighbour.positionWorld - placed[side.sphere].positionWorld;
      CHECK(handles[i].frames == Approx((neighbour.frame - placed[side.sphere].frame) / 3.0));
      CHECK(glm::length(handles[i].sphereWorld - placed[side.sphere].positionWorld) < 1e-9);
      CHECK(glm::length(handles[i].towardsNeighbour - glm::normalize(way)) < 1e-9);
    }
  }
  CHECK(tangentHandles(session, 5.0).empty());
  Document plain = withThreeSpheres();
  plain.trails.front().exaggerated = plain.trails.front().connected = false;
  Session other = spheresSelected(plain, {});
  CHECK(tangentHandles(other, 4.0).empty());
}
