#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <string>

#include <fmt/core.h>

#include "app/batch/trail_report.h"
#include "app/edits/trail/sphere_edits.h"
#include "app/evaluate/cache.h"
#include "app/evaluate/evaluate.h"
#include "app/files/save.h"
#include "core/base/check.h"
#include "core/gltf/json/json.h"
#include "tests/bench/speed/long_clip.h"
#include "tests/bench/speed/rows.h"

namespace stretch::bench {

namespace {

constexpr std::size_t samplesPerFrame = 2; // as the viewport draws them
constexpr double measuredFrames = 48.0;    // 49 with both ends

/// What Blender's paths of one bone over as many frames take; 0 without Blender.
double blenderMilliseconds(const SpeedInput& input) {
  const std::filesystem::path answer = std::filesystem::temp_directory_path() / "stretch-engine-blender.txt";
  std::filesystem::remove(answer);
  const RunCost cost = runProgram({"blender", "--background", "--factory-startup", "--python",
                                   (std::string(STRETCH_SOURCE_DIR) + "/tests/bench/speed/blender_paths.py"),
                                   "--", input.file.string(),
                                   fmt::format("{}", static_cast<int>(measuredFrames) + 1), answer.string()});
  double milliseconds = 0.0;
  std::ifstream(answer) >> milliseconds;
  return cost.ran ? milliseconds : 0.0;
}

/// A trail that was not there before, as the editor finds it: the body is known.
Comparison onePath(const SpeedInput& input) {
  std::array<app::Document, 2> moving{input.document, input.document};
  for (app::Document& document : moving) {
    addTrail(document, 0, 0.0, measuredFrames);
  }
  moving.back().trails.front().id += 1;
  app::EvaluationCache cache;
  std::size_t turn = 0;
  const auto solve = [&] { static_cast<void>(cache.paths(moving[turn++ % 2], 0, samplesPerFrame)); };
  const Pair cost = measureInTurn(input.repetitions, solve, [] {});
  return {"one trail of 49 frames, motion and paths",
          "Blender's paths_calculate, one bone",
          cost.ours,
          blenderMilliseconds(input),
          1.0 / 150.0,
          "sampling the limb's joints at 2 times a frame"};
}

/// One sphere of a trail, moved as by the first step of a drag: what was there before it is remembered.
class FirstStep {
public:
  FirstStep(app::Document document, int trailId, double frame)
      : document_(std::move(document)), trailId_(trailId), frame_(frame) {}

  void before(app::EvaluationCache& cache) const { look(document_, cache); }
  void step(app::EvaluationCache& cache) const {
    const app::SphereMove move{frame_, Vec3(0.0, 0.01 * document_.body.height, 0.0)};
    const Result<app::Document> preview = app::moveSpheres(document_, trailId_, {&move, 1});
    check(preview.ok(), "the sphere of a bench can be moved");
    look(*preview, cache);
  }

private:
  void look(const app::Document& document, app::EvaluationCache& cache) const {
    static_cast<void>(cache.paths(document, 0, samplesPerFrame));
    static_cast<void>(cache.frame(document, 0, frame_ / app::clipOf(document, 0).framesPerSecond));
  }
  app::Document document_;
  int trailId_;
  double frame_;
};

/// The step alone, beside solving everything anew.
Comparison firstSteps(const SpeedInput& input) {
  app::Document moving = input.document;
  const double last = std::floor(app::clipOf(moving, 0).endSeconds * app::clipOf(moving, 0).framesPerSecond);
  for (std::size_t limb = 0; limb < moving.body.limbs.size(); ++limb) {
    addTrail(moving, limb, 0.0, last);
  }
  const int trail = app::prepareMotion(moving, 0).trails.front().trail.id; // which may move all others
  const FirstStep drag(moving, trail, std::floor(0.5 * last));
  const Pair cost = measureInTurn(
      input.repetitions,
      [&] {
        app::EvaluationCache cache;
        drag.before(cache);
        drag.step(cache);
      },
      [&] {
        app::EvaluationCache cache;
        drag.before(cache);
      });
  return {fmt::format("first step of a drag, {} trails: the sphere that moves most", moving.trails.size()),
          "all of them solved anew",
          std::max(0.0, cost.ours - cost.other),
          cost.other,
          0.15,
          "the paths that depend on it"};
}

/// A sphere dragged back and forth.
Pair dragCosts(const app::Document& ours, const app::Document& other, int repetitions) {
  const auto dragOf = [](const app::Document& document, app::EvaluationCache& cache) {
    auto drag = std::make_shared<FirstStep>(document, document.trails.front().id, 50.0);
    return [drag, &cache] {
      drag->before(cache);
      drag->step(cache);
    };
  };
  app::EvaluationCache first;
  app::EvaluationCache second;
  return measureInTurn(repetitions, dragOf(ours, first), dragOf(other, second));
}

Comparison dragInLongClip(const SpeedInput& input) {
  app::Document longer = withLongClip(input.document, 5000);
  app::Document shorter = withLongClip(input.document, 201);
  addTrail(longer, 0, 0.0, 100.0);
  addTrail(shorter, 0, 0.0, 100.0);
  const Pair cost = dragCosts(longer, shorter, input.repetitions);
  return {"drag of a trail of 100 frames in a clip of 5,000",
          "the same in a clip of 201",
          cost.ours,
          cost.other,
          1.1,
          "the path alone"};
}

/// The first trail of a clip, with nothing remembered of either.
Comparison firstSolveInLongClip(const SpeedInput& input) {
  app::Document longer = withLongClip(input.document, 50000);
  app::Document shorter = withLongClip(input.document, 201);
  const auto firstSolve = [](app::Document& document) {
    addTrail(document, 0, 0.0, 100.0);
    return [&document] {
      app::EvaluationCache cache;
      static_cast<void>(cache.paths(document, 0, samplesPerFrame));
    };
  };
  const Pair cost = measureInTurn(input.repetitions, firstSolve(longer), firstSolve(shorter));
  return {"first solve of a trail of 100 frames in a clip of 50,000",
          "the same in a clip of 201",
          cost.ours,
          cost.other,
          1.1,
          "the path alone"};
}

/// From placed trails to the written file, with its report.
void exaggerateWhole(const app::Document& document) {
  const std::filesystem::path path = std::filesystem::temp_directory_path() / "stretch-engine-speed.glb";
  std::vector<int> ids;
  for (const rig::Trail& trail : document.trails) {
    ids.push_back(trail.id);
  }
  static_cast<void>(app::exaggerationJson(document, 0, ids));
  check(app::saveDocument(document, path, {}).ok(), "the file of a bench can be written");
  std::filesystem::remove(path);
}

app::Document wholeClip(const SpeedInput& input, int frames) {
  app::Document document = withLongClip(input.document, frames);
  addTrail(document, 0, 0.0, frames - 1.0);
  return document;
}

std::vector<Comparison> wholeClips(const SpeedInput& input) {
  const app::Document shortest = wholeClip(input, 50);
  const app::Document middle = wholeClip(input, 500);
  const app::Document longest = wholeClip(input, 5000);
  const int few = std::max(3, input.repetitions / 10);
  const Pair first = measureInTurn(
      few, [&] { exaggerateWhole(middle); }, [&] { exaggerateWhole(shortest); });
  const Pair second = measureInTurn(
      few, [&] { exaggerateWhole(longest); }, [&] { exaggerateWhole(middle); });
  const std::string limit = "warnings: the limb's mesh at each frame";
  return {{"exaggerate a whole clip of 500 frames", "of 50", first.ours, first.other, 10.0, limit},
          {"exaggerate a whole clip of 5,000 frames", "of 500", second.ours, second.other, 10.0, limit}};
}

Comparison manyTrails(const SpeedInput& input) {
  constexpr double length = 40.0;
  const auto with = [&](int trails) {
    app::Document document = withLongClip(input.document, 500);
    const std::size_t limbs = std::min<std::size_t>(4, document.body.limbs.size());
    for (int i = 0; i < trails; ++i) {
      const int round = i / static_cast<int>(limbs);
      const double start = 1.5 * length * round;
      addTrail(document, static_cast<std::size_t>(i) % limbs, start, start + length);
    }
    return document;
  };
  const app::Document many = with(32);
  const app::Document half = with(16);
  const Pair cost = measureInTurn(
      std::max(3, input.repetitions / 5), [&] { exaggerateWhole(many); }, [&] { exaggerateWhole(half); });
  return {"exaggerate with 32 trails", "with 16", cost.ours, cost.other, 2.0, "warnings of each trail"};
}

} // namespace

std::vector<Comparison> motionComparisons(const SpeedInput& input) {
  std::vector<Comparison> rows{onePath(input), firstSteps(input), dragInLongClip(input),
                               firstSolveInLongClip(input)};
  for (Comparison& row : wholeClips(input)) {
    rows.push_back(std::move(row));
  }
  rows.push_back(manyTrails(input));
  return rows;
}

} // namespace stretch::bench
