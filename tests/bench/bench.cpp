// bench [--repeat N] [--only TEXT] [FILE...]: what the program's own work costs, as ratios within one run.
// Without a file: the bundled character. Every file gets a trail on its first limb, over the first clip.
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include "app/document.h"
#include "app/edits/pose/offset_edits.h"
#include "app/edits/trail/sphere_edits.h"
#include "app/evaluate/cache.h"
#include "app/evaluate/evaluate.h"
#include "app/files/save.h"
#include "core/base/check.h"
#include "core/scene/scene.h"
#include "tests/bench/graph_bench.h"
#include "tests/bench/measure.h"

namespace stretch::bench {

namespace {

constexpr double scale = 3.0;
constexpr std::size_t samplesPerFrame = 2; // as the viewport draws them

/// A connected trail over the whole clip on each of the first `limbs` limbs.
app::Document withTrails(app::Document document, std::size_t limbs) {
  const Clip& clip = app::clipOf(document, 0);
  for (std::size_t i = 0; i < std::min(limbs, document.body.limbs.size()); ++i) {
    rig::Trail trail;
    trail.id = document.nextTrailId++;
    trail.limb = document.body.limbs[i].id;
    trail.settings.endFrame = clip.endSeconds * clip.framesPerSecond;
    trail.settings.scale = scale;
    trail.exaggerated = true;
    trail.connected = true;
    document.trails.push_back(std::move(trail));
  }
  return document;
}

/// A sphere of one trail, dragged as in the window: the program remembers what did not change.
class Drag {
public:
  Drag(app::Document atBegin, int trailId, double frame)
      : atBegin_(std::move(atBegin)), trailId_(trailId), frame_(frame), pull_(0.01 * atBegin_.body.height) {
    step();
  }

  /// What one mouse move costs between the event and the drawing.
  void step() {
    pull_ = -pull_;
    const app::SphereMove move{frame_, Vec3(0.0, pull_, 0.0)};
    const Result<app::Document> preview = app::moveSpheres(atBegin_, trailId_, {&move, 1});
    check(preview.ok(), "the sphere of a bench can be moved");
    static_cast<void>(cache_.paths(*preview, 0, samplesPerFrame));
    static_cast<void>(cache_.frame(*preview, 0, frame_ / app::clipOf(*preview, 0).framesPerSecond));
  }

private:
  app::Document atBegin_;
  int trailId_;
  double frame_;
  double pull_;
  app::EvaluationCache cache_;
};

/// The hips lowered over feet that stay, dragged as in the window.
class PoseDrag {
public:
  PoseDrag(app::Document atBegin, double frame)
      : atBegin_(std::move(atBegin)), frame_(frame), low_(0.05 * atBegin_.body.height),
        pull_(0.01 * atBegin_.body.height) {
    step();
  }

  void step() {
    pull_ = -pull_;
    const app::ControllerOffset hips{"hips", Vec3(0.0, pull_ - low_, 0.0), Vec3(0.0)};
    const Result<app::Document> preview = app::setOffsets(atBegin_, 0, frame_, {&hips, 1}, {}, {});
    check(preview.ok(), "the hips of a bench can be moved");
    static_cast<void>(cache_.paths(*preview, 0, samplesPerFrame));
    const double seconds = frame_ / app::clipOf(*preview, 0).framesPerSecond;
    static_cast<void>(cache_.frame(*preview, 0, seconds));
    static_cast<void>(cache_.controllers(*preview, 0, seconds));
  }

private:
  app::Document atBegin_;
  double frame_;
  double low_;
  double pull_;
  app::EvaluationCache cache_;
};

/// The first step of a drag, when nothing is remembered.
void refresh(const app::Document& document, double frame) {
  const rig::MotionState motion = app::prepareMotion(document, 0);
  static_cast<void>(app::trailPaths(document, motion, samplesPerFrame));
  static_cast<void>(app::evaluate(document, motion, frame / app::clipOf(document, 0).framesPerSecond));
}

void measureSphereDrag(const app::Document& moving, const rig::SolvedTrail& trail, double frame,
                       const std::string& trails, Table& table) {
  Drag drag(moving, trail.trail.id, frame);
  table.add("a sphere dragged, " + trails + ": " + trail.limb.id, [&] { drag.step(); });
}

void measureTrails(const app::Document& document, std::size_t limbs, Table& table) {
  const Clip& clip = app::clipOf(document, 0);
  const double middleSeconds = 0.5 * (clip.startSeconds + clip.endSeconds);
  const double middleFrame = middleSeconds * clip.framesPerSecond;
  const app::Document moving = withTrails(document, limbs);
  const rig::MotionState motion = app::prepareMotion(moving, 0);
  const std::string trails =
      fmt::format("{} trail{}", motion.trails.size(), motion.trails.size() == 1 ? "" : "s");
  table.add("a frame with " + trails,
            [&] { static_cast<void>(app::evaluate(moving, motion, middleSeconds)); });
  table.add(trails + " solved and drawn anew", [&] { refresh(moving, middleFrame); });
  // What acts first may move all others.
  measureSphereDrag(moving, motion.trails.front(), middleFrame, trails, table);
  if (motion.trails.size() > 1) {
    measureSphereDrag(moving, motion.trails.back(), middleFrame, trails, table);
  }
  if (document.body.hips.exists()) {
    PoseDrag drag(moving, middleFrame);
    table.add("the hips dragged, " + trails, [&] { drag.step(); });
  }
}

void measureMotion(const app::Document& document, const Options& options) {
  Table table("motion", options);
  const Clip& clip = app::clipOf(document, 0);
  const double middleSeconds = 0.5 * (clip.startSeconds + clip.endSeconds);
  table.add("a frame of the clip as it is",
            [&] { static_cast<void>(app::evaluateOriginal(document, 0, middleSeconds)); });
  constexpr std::size_t armsAndLegs = 4;
  for (const std::size_t limbs : {std::size_t{1}, armsAndLegs, document.body.limbs.size()}) {
    measureTrails(document, limbs, table);
  }
  table.print();
}

void measureFile(const std::filesystem::path& path, const app::Document& document, const Options& options) {
  const std::filesystem::path output = std::filesystem::temp_directory_path() / "stretch-engine-bench.glb";
  const int repetitions = std::max(options.repetitions / 10, 3);
  Table table("file", options);
  table.add("open", repetitions, [&] { static_cast<void>(app::openDocument(path)); });
  table.add("save without an edit", repetitions,
            [&] { static_cast<void>(app::saveDocument(document, output, {})); });
  if (!document.clips->empty() && !document.body.limbs.empty()) {
    app::Document moving = withTrails(document, 1);
    moving.trails.front().applied = true;
    table.add("save with one trail applied", repetitions,
              [&] { static_cast<void>(app::saveDocument(moving, output, {})); });
  }
  std::filesystem::remove(output);
  table.print();
}

bool benchFile(const std::filesystem::path& path, const Options& options) {
  const Result<app::Document> document = app::openDocument(path);
  if (!document) {
    fmt::print(stderr, "bench: {}\n", document.error().line());
    return false;
  }
  fmt::print("\n{}: {:.1f} MB, {} vertices, {} nodes, {} limbs", path.filename().string(),
             static_cast<double>(std::filesystem::file_size(path)) * 1e-6, vertexCount(*document->scene),
             document->scene->nodes.size(), document->body.limbs.size());
  const bool moves = !document->clips->empty() && !document->body.limbs.empty();
  if (moves) {
    const Clip& clip = app::clipOf(*document, 0);
    fmt::print("; first clip: {} frames, {} tracks", frameCount(clip), clip.tracks.size());
  }
  fmt::print("\n");
  measureFile(path, *document, options);
  if (moves) {
    measureMotion(*document, options);
    measureGraph(*document, options);
  }
  return true;
}

} // namespace

} // namespace stretch::bench

int main(int argumentCount, char** arguments) {
  CLI::App program{"What the program's own work costs, as ratios within one run."};
  std::vector<std::string> files;
  stretch::bench::Options options;
  program.add_option("FILE", files, "Characters; default: the bundled one");
  program.add_option("--repeat", options.repetitions, "Repetitions of each measurement")
      ->check(CLI::Range(1, 100000));
  program.add_option("--only", options.only, "Only the rows whose text holds this");
  CLI11_PARSE(program, argumentCount, arguments);
  if (files.empty()) {
    files.emplace_back(STRETCH_SOURCE_DIR "/assets/dummy.glb");
  }
  bool allRead = true;
  for (const std::string& file : files) {
    allRead = stretch::bench::benchFile(file, options) && allRead;
  }
  return allRead ? 0 : 1;
}
