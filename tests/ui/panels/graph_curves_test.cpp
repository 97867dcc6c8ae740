// Curves of the graph against what the character does, row by row and frame by frame, and when they are made
// anew.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "app/commands/keys/keys.h"
#include "app/commands/table/selection.h"
#include "app/evaluate/evaluate.h"
#include "core/math/euler.h"
#include "rig/limb.h"
#include "tests/support/ui/panel_driver.h"
#include "tests/support/ui/work.h"
#include "ui/panels/rows/graph_model.h"

using namespace stretch;
using ui::Curve;
using ui::GraphChannels;
using ui::GraphSubject;

namespace {

struct GraphStage {
  test::PanelDriver driver{std::nullopt};
  ui::PanelContext context{driver.open,      driver.ui,    driver.theme, driver.commands,
                           driver.requested, driver.items, driver.status};

  explicit GraphStage(void (*state)(const test::Work&)) { state({driver.open, driver.ui, driver.status}); }
  app::Session& session() { return context.character(); }
  ui::GraphState& graph() { return driver.ui.time.graph; }
  std::vector<Curve> curves(const GraphSubject& subject, const ui::Span& frames = {0.0, 24.0}) {
    return ui::graphCurves(context, subject, frames);
  }
  NodeIndex firstJoint() { return app::findLimb(session().document(), "left-arm")->joints.front(); }
  Transform localAt(double frame, bool asSource) {
    const app::Document& document = session().document();
    const double seconds = frame / app::clipOf(document, 0).framesPerSecond;
    const FrameState state = asSource ? app::evaluateOriginal(document, 0, seconds)
                                      : app::evaluate(document, app::prepareMotion(document, 0), seconds);
    return state.pose.locals[at(firstJoint())];
  }
};

void turnKeysOfArm(const test::Work& work) {
  test::withArmsGraph(work);
  app::Session& session = work.session();
  const std::vector<app::KeyRow> rows = app::rowsOfSelection(session);
  const auto turning = std::ranges::find(rows, Channel::rotation, &app::KeyRow::channel);
  REQUIRE(turning != rows.end());
  const app::KeySelection all = app::allKeys(session.document(), 0, std::vector{*turning});
  const Result<app::EditedKeys> moved = app::moveKeys(session.document(), 0, all, {.value = 7.0});
  REQUIRE(moved);
  session.edit(moved->document, "Move");
}

Vec3 vectorAt(const std::vector<Curve>& curves, std::vector<Vec2> Curve::*points, std::size_t i) {
  return {(curves[0].*points)[i].y, (curves[1].*points)[i].y, (curves[2].*points)[i].y};
}

/// Points of three curves are the channel of a joint, at each of their frames.
void checkPoints(GraphStage& stage, const std::vector<Curve>& curves, std::vector<Vec2> Curve::*points,
                 Channel channel, bool asSource) {
  REQUIRE(curves.size() == 3);
  const std::size_t count = (curves[0].*points).size();
  REQUIRE(count > 10);
  Vec3 before = vectorAt(curves, points, 0);
  for (std::size_t i = 0; i < count; ++i) {
    const double frame = (curves[0].*points)[i].x;
    CHECK((curves[1].*points)[i].x == frame);
    CHECK((curves[2].*points)[i].x == frame);
    const Transform local = stage.localAt(frame, asSource);
    const Vec3 value = vectorAt(curves, points, i);
    if (channel == Channel::rotation) {
      CHECK(std::abs(glm::dot(rotationOf(value * (pi / 180.0)), local.rotation)) == Approx(1.0).margin(1e-6));
      CHECK(glm::length(value - before) < 180.0);
    } else {
      CHECK(glm::distance(value, channel == Channel::scale ? local.scale : local.translation) < 1e-5);
    }
    before = value;
  }
}

const std::vector<std::pair<GraphChannels, Channel>> channelsOfJoints{
    {GraphChannels::translation, Channel::translation},
    {GraphChannels::rotation, Channel::rotation},
    {GraphChannels::scale, Channel::scale}};

} // namespace

TEST_CASE("Curves of a joint are what it does, with the source under what acts on it", "[graph-curves]") {
  for (const auto& [state, moves] : {std::pair(&test::withArmsGraph, false), {&test::withTrail, true}}) {
    GraphStage stage(state);
    const GraphSubject joint = ui::graphSubjects(stage.context).front();
    REQUIRE(joint.nodes == std::vector{stage.firstJoint()});
    for (const auto& [shown, channel] : channelsOfJoints) {
      CAPTURE(moves, static_cast<int>(shown));
      stage.graph().channels = shown;
      const std::vector<Curve> curves = stage.curves(joint);
      checkPoints(stage, curves, &Curve::points, channel, !moves);
      for (std::size_t c = 0; c < curves.size(); ++c) {
        CHECK(curves[c].label == std::string(1, "XYZ"[c]));
        CHECK(curves[c].component == c);
        CHECK(curves[c].row == 0);
        CHECK_FALSE(curves[c].offsetKeys);
        CHECK(curves[c].source.empty());
        CHECK(curves[c].before.empty() == !moves);
      }
      if (moves) {
        checkPoints(stage, curves, &Curve::before, channel, true);
      }
    }
  }
}

TEST_CASE("Edited keys show the curve before them, and stand where they are in the clip", "[graph-curves]") {
  GraphStage stage(&turnKeysOfArm);
  stage.graph().channels = GraphChannels::rotation;
  const GraphSubject joint = ui::graphSubjects(stage.context).front();
  const std::vector<Curve> curves = stage.curves(joint);
  checkPoints(stage, curves, &Curve::points, Channel::rotation, false);
  const Clip& clip = app::clipOf(stage.session().document(), 0);
  const Track& track = *clip.tracks[at(findTrack(clip, stage.firstJoint(), Channel::rotation))];
  for (const Curve& curve : curves) {
    REQUIRE(curve.source.size() == curve.points.size());
    for (std::size_t i = 0; i < curve.source.size(); ++i) {
      CHECK(curve.source[i].x == curve.points[i].x);
    }
    REQUIRE(curve.keys.size() == track.times.size());
    for (std::size_t k = 0; k < curve.keys.size(); ++k) {
      CHECK(curve.keys[k].at.x ==
            Approx(static_cast<double>(track.times[k]) * clip.framesPerSecond).margin(1e-6));
    }
  }
  // At keys the curves and what was before them are seven degrees apart.
  const auto valueAt = [](const std::vector<Vec2>& points, double frame) {
    const auto found = std::ranges::find(points, frame, &Vec2::x);
    REQUIRE(found != points.end());
    return found->y;
  };
  for (const Curve& curve : curves) {
    for (const ui::CurveKey& key : curve.keys) {
      if (key.at.x <= 24.0 && key.at.x == std::round(key.at.x)) {
        CHECK(valueAt(curve.points, key.at.x) == Approx(key.at.y).margin(1e-3));
        CHECK(valueAt(curve.points, key.at.x) - valueAt(curve.source, key.at.x) == Approx(7.0).margin(0.05));
      }
    }
  }
}

TEST_CASE("Frames are sampled by quarters as far as the view and the clip go, to the very end",
          "[graph-curves]") {
  GraphStage stage(&test::withArmsGraph);
  const GraphSubject joint = ui::graphSubjects(stage.context).front();
  const double last = app::clipOf(stage.session().document(), 0).endSeconds *
                      app::clipOf(stage.session().document(), 0).framesPerSecond;
  const auto framesOver = [&](double start, double end) {
    std::vector<double> frames;
    const std::vector<Curve> curves = stage.curves(joint, {start, end});
    for (const Vec2& point : curves[0].points) {
      frames.push_back(point.x);
    }
    return frames;
  };
  for (const auto& [start, end] : {std::pair(3.2, 7.7), {-5.0, 2.0}, {0.0, 4.0}, {last - 3.0, last + 9.0}}) {
    CAPTURE(start, end);
    const std::vector<double> frames = framesOver(start, end);
    const double first = std::max(0.0, std::floor(start));
    const double until = std::min(last, std::ceil(end));
    std::vector<double> wanted;
    for (double frame = first; frame <= until + 1e-9; frame += 0.25) {
      wanted.push_back(frame);
    }
    if (wanted.back() < until - 1e-9) {
      wanted.push_back(until);
    }
    CHECK(frames == wanted);
  }
}

TEST_CASE("Offsets of the clip that is looked at are drawn over its curves, those of another clip are not",
          "[graph-curves]") {
  for (const int clip : {0, 1}) {
    CAPTURE(clip);
    GraphStage stage(&test::withArmsGraph);
    stage.graph().channels = GraphChannels::rotation;
    app::Document document = stage.session().document();
    std::vector<Clip> clips = *document.clips;
    clips.push_back(clips.front());
    document.clips = std::make_shared<const std::vector<Clip>>(std::move(clips));
    rig::Adjustment lifted;
    lifted.clip = clip;
    lifted.controller = "left-hand";
    lifted.rangeFrames = Vec2(0.0, 24.0);
    lifted.keys = {{.frame = 0.0, .move = Vec3(0.0, 0.1, 0.0)}};
    document.adjustments = {lifted};
    stage.session().edit(std::move(document), "Lift");
    stage.session().view().clip = 0;
    const GraphSubject joint = ui::graphSubjects(stage.context).front();
    const std::vector<Curve> curves = stage.curves(joint);
    REQUIRE(curves.size() == 3);
    for (const Curve& curve : curves) {
      CHECK(curve.before.empty() == (clip != 0));
    }
    checkPoints(stage, curves, &Curve::points, Channel::rotation, clip != 0);
  }
}

TEST_CASE("A limb's length is that from its base to its end, and the source's beside it where they differ",
          "[graph-curves]") {
  for (const auto& [state, moves] :
       {std::pair(&test::withArmsGraph, false), {&test::withTrail, true}, {&turnKeysOfArm, true}}) {
    GraphStage stage(state);
    stage.graph().channels = GraphChannels::stretch;
    const app::Document& document = stage.session().document();
    const rig::Limb& arm = *app::findLimb(document, "left-arm");
    const rig::MotionState motion = app::prepareMotion(document, 0);
    const double rate = app::clipOf(document, 0).framesPerSecond;
    const std::vector<Curve> curves = stage.curves(ui::graphSubjects(stage.context).front());
    REQUIRE(curves.size() == 1);
    CHECK(curves[0].label == "Length");
    CHECK(curves[0].keys.empty());
    CHECK(curves[0].before.size() == (moves ? curves[0].points.size() : 0));
    double most = 0.0;
    for (std::size_t i = 0; i < curves[0].points.size(); ++i) {
      const Vec2 point = curves[0].points[i];
      CHECK(point.y == Approx(rig::limbLength(arm, app::evaluate(document, motion, point.x / rate))));
      if (moves) {
        CHECK(curves[0].before[i].x == point.x);
        CHECK(curves[0].before[i].y ==
              Approx(rig::limbLength(arm, app::evaluateOriginal(document, 0, point.x / rate))));
        most = std::max(most, std::abs(point.y - curves[0].before[i].y));
      }
    }
    CHECK((most > 0.1) == (state == &test::withTrail));
  }
}

TEST_CASE("Curves of a controller have its offset's keys, moves or turns, and an attribute's one value",
          "[graph-curves]") {
  GraphStage stage(&test::withEverything);
  app::selectControllers(stage.session(), {"hips"});
  const GraphSubject hips = ui::graphSubjects(stage.context).front();
  CHECK(hips.controller == "hips");
  CHECK(hips.nodes.empty());
  const auto& adjustments = stage.session().document().adjustments;
  const auto adjustment = std::ranges::find(adjustments, "hips", &rig::Adjustment::controller);
  REQUIRE(adjustment != adjustments.end());
  for (const bool turns : {false, true}) {
    stage.graph().offsetChannels = turns ? GraphChannels::rotation : GraphChannels::translation;
    const std::vector<Curve> curves = stage.curves(hips);
    REQUIRE(curves.size() == 3);
    for (std::size_t c = 0; c < 3; ++c) {
      CHECK(curves[c].component == c + (turns ? 3U : 0U));
      CHECK(curves[c].label == std::string(1, "XYZ"[c]));
      CHECK(curves[c].offsetKeys);
      REQUIRE(curves[c].keys.size() == adjustment->keys.size());
      for (std::size_t k = 0; k < curves[c].keys.size(); ++k) {
        const rig::OffsetKey& key = adjustment->keys[k];
        const auto axis = static_cast<glm::length_t>(c);
        CHECK(curves[c].keys[k].at.x == key.frame);
        CHECK(curves[c].keys[k].at.y == Approx(turns ? key.turn[axis] * 180.0 / pi : key.move[axis]));
      }
    }
  }
  app::selectControllers(stage.session(), {"right-hand"});
  const std::vector<GraphSubject> subjects = ui::graphSubjects(stage.context);
  const auto stretch = std::ranges::find(subjects, "right-arm.stretch", &GraphSubject::controller);
  REQUIRE(stretch != subjects.end());
  const std::vector<Curve> curves = stage.curves(*stretch);
  REQUIRE(curves.size() == 1);
  CHECK(curves[0].label == "Value");
  CHECK(curves[0].keys.size() == 1);
  CHECK(curves[0].keys[0].at == Vec2(8.0, 0.5));
}

TEST_CASE("Curves follow whatever they are made from: clip, theme, view, subject, keys and picks",
          "[graph-curves]") {
  GraphStage stage(&test::withArmsGraph);
  stage.graph().channels = GraphChannels::rotation;
  const std::vector<GraphSubject> subjects = ui::graphSubjects(stage.context);
  const std::vector<Curve> first = stage.curves(subjects[0]);
  const auto pointsOf = [](const std::vector<Curve>& curves) { return curves[0].points; };
  CHECK(pointsOf(stage.curves(subjects[0])) == pointsOf(first));
  CHECK(pointsOf(stage.curves(subjects[1])) != pointsOf(first));
  CHECK(pointsOf(stage.curves(subjects[0], {0.0, 23.0})) != pointsOf(first));
  CHECK(pointsOf(stage.curves(subjects[0], {1.0, 24.0})) != pointsOf(first));
  CHECK(pointsOf(stage.curves(subjects[0])) == pointsOf(first));
  const NodeIndex joint = stage.firstJoint();
  const app::KeyRow row{joint, Channel::rotation, {}};
  const app::KeySelection third{{row, {{2, 0b101U}}}};
  app::pickKeys(stage.session(), third, false);
  const auto pickedOf = [&] {
    std::vector<std::vector<int>> picked;
    for (const Curve& curve : stage.curves(subjects[0])) {
      picked.emplace_back();
      for (const ui::CurveKey& key : curve.keys) {
        if (key.picked) {
          picked.back().push_back(key.key);
        }
      }
      CHECK(curve.picked == picked.back().size());
    }
    return picked;
  };
  using Picked = std::vector<std::vector<int>>;
  CHECK(pickedOf() == Picked{{2}, {}, {2}});
  app::pickKeys(stage.session(), {{row, {{0, 0b010U}, {1, ~0U}}}}, false);
  CHECK(pickedOf() == Picked{{1}, {0, 1}, {1}});
  stage.graph().isolated = true;
  app::pickKeys(stage.session(), third, false);
  const auto hidden = [&] {
    std::vector<bool> off;
    for (const Curve& curve : stage.curves(subjects[0])) {
      off.push_back(curve.hidden);
    }
    return off;
  };
  CHECK(hidden() == std::vector{false, true, false});
  stage.graph().hidden = {true, false, false};
  CHECK(hidden() == std::vector{true, true, false});
  stage.graph().isolated = false;
  CHECK(hidden() == std::vector{true, false, false});
  app::pickKeys(stage.session(), {}, false);
  CHECK(pickedOf() == Picked{{}, {}, {}});
}

TEST_CASE("Curves are those of the clip that is looked at", "[graph-curves]") {
  GraphStage stage(&test::withArmsGraph);
  stage.graph().channels = GraphChannels::rotation;
  const GraphSubject joint = ui::graphSubjects(stage.context).front();
  const std::vector<Curve> first = stage.curves(joint);
  // Another clip of the same tracks, twice as slow.
  app::Document document = stage.session().document();
  std::vector<Clip> clips = *document.clips;
  clips.push_back(clips.front());
  for (auto& track : clips.back().tracks) {
    track.edit([](Track& keys) {
      for (float& time : keys.times) {
        time *= 2.0F;
      }
    });
  }
  clips.back().endSeconds *= 2.0;
  document.clips = std::make_shared<const std::vector<Clip>>(std::move(clips));
  stage.session().edit(std::move(document), "Edit");
  CHECK(stage.curves(joint)[0].points == first[0].points);
  stage.session().view().clip = static_cast<int>(stage.session().document().clips->size()) - 1;
  const std::vector<Curve> slow = stage.curves(joint);
  REQUIRE(slow[0].keys.size() == first[0].keys.size());
  for (std::size_t k = 0; k < slow[0].keys.size(); ++k) {
    CHECK(slow[0].keys[k].at.x == Approx(2.0 * first[0].keys[k].at.x).margin(1e-4));
    CHECK(slow[0].keys[k].at.y == Approx(first[0].keys[k].at.y).margin(1e-4));
  }
}

TEST_CASE("The graph offers what is selected, each joint once, then all of them", "[graph-curves]") {
  GraphStage stage(&test::withArmsGraph);
  app::selectLimb(stage.session(), "right-leg", true);
  const app::Document& document = stage.session().document();
  const rig::Limb& arm = *app::findLimb(document, "left-arm");
  const rig::Limb& leg = *app::findLimb(document, "right-leg");
  const std::vector<GraphSubject> subjects = ui::graphSubjects(stage.context);
  const std::vector<NodeIndex> ofArm = rig::jointsAndEnd(arm);
  const std::vector<NodeIndex> ofLeg = rig::jointsAndEnd(leg);
  REQUIRE(subjects.size() == ofArm.size() + 2);
  for (std::size_t i = 0; i < ofArm.size(); ++i) {
    CHECK(subjects[i].nodes == std::vector{ofArm[i]});
    CHECK(subjects[i].title == document.scene->nodes[at(ofArm[i])].name);
    CHECK(subjects[i].limb == "left-arm");
    CHECK(subjects[i].isOne);
  }
  std::vector<NodeIndex> both = ofArm;
  both.insert(both.end(), ofLeg.begin(), ofLeg.end());
  const GraphSubject& all = subjects[ofArm.size()];
  CHECK(all.title == "All joints");
  CHECK(all.nodes == both);
  CHECK(all.limb == "left-arm");
  CHECK_FALSE(all.isOne);
  CHECK(subjects.back().title == "Whole body");
  CHECK(subjects.back().nodes.size() > both.size());
  // Of many joints only those are rows that have keys; a joint alone is one with keys or without.
  for (const auto& [shown, channel] : channelsOfJoints) {
    stage.graph().channels = shown;
    std::vector<app::KeyRow> wanted;
    const Clip& clip = app::clipOf(document, 0);
    for (const NodeIndex node : both) {
      if (findTrack(clip, node, channel) >= 0) {
        wanted.push_back({node, channel, {}});
      }
    }
    CHECK(ui::graphRows(stage.context, all) == wanted);
    CHECK(ui::graphRows(stage.context, subjects[1]) == std::vector<app::KeyRow>{{ofArm[1], channel, {}}});
  }
}

TEST_CASE("The graph tells the units of joints, controllers and attributes by what it shows of them",
          "[graph-curves]") {
  GraphStage stage(&test::withArmsGraph);
  const std::vector<GraphSubject> subjects = ui::graphSubjects(stage.context);
  const GraphSubject& all = subjects[subjects.size() - 2];
  REQUIRE(all.title == "All joints");
  for (const auto& [channels, unit] : {std::pair(GraphChannels::translation, " m"),
                                       {GraphChannels::rotation, "\xC2\xB0"},
                                       {GraphChannels::scale, ""},
                                       {GraphChannels::stretch, " m"}}) {
    stage.graph().channels = channels;
    CHECK(ui::graphChannels(stage.context, subjects[0]) == channels);
    CHECK(std::string(ui::graphUnit(stage.context, subjects[0])) == unit);
  }
  CHECK(ui::graphRows(stage.context, all).empty()); // A length has no keys.
  const GraphSubject hand{"Left hand", {}, "left-hand"};
  const GraphSubject curl{"Left hand curl", {}, "left-hand.curl"};
  stage.graph().offsetChannels = GraphChannels::translation;
  CHECK(std::string(ui::graphUnit(stage.context, hand)) == " m");
  CHECK(std::string(ui::graphUnit(stage.context, curl)).empty());
  stage.graph().offsetChannels = GraphChannels::rotation;
  CHECK(ui::graphChannels(stage.context, hand) == GraphChannels::rotation);
  CHECK(std::string(ui::graphUnit(stage.context, hand)) == "\xC2\xB0");
  CHECK(ui::graphRows(stage.context, hand) ==
        std::vector<app::KeyRow>{{NodeIndex::none, Channel::translation, "left-hand"}});
  stage.session().view().selection.editTrails().limbs.clear();
  CHECK(ui::graphSubjects(stage.context).empty());
}
