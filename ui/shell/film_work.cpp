#include "ui/shell/film_work.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "app/commands/table/selection.h"
#include "app/evaluate/evaluate.h"
#include "core/anim/frames.h"
#include "ui/batch/film.h"
#include "ui/batch/sequence_pictures.h"
#include "ui/shell/shell.h"

namespace stretch::ui {

namespace {

/// All that the drawing needs, so that the window may go on.
struct FilmRequest {
  app::Document document;
  std::shared_ptr<const rig::MotionState> motion;
  std::vector<double> frames;
  CharacterLook look;
  bool besideOriginal = false;
  PictureOptions options;
};

std::vector<double> filmedFrames(const app::Session& session) {
  const double last = lastFrame(app::clipOf(session.document(), session.view().clip));
  const Vec2 range = session.rangeByHand().value_or(Vec2(0.0, last));
  std::vector<double> frames;
  for (double frame = std::min(range.x, last); frame <= std::min(range.y, last); frame += 1.0) {
    frames.push_back(frame);
  }
  return frames;
}

FilmRequest requestOf(Shell& shell) {
  app::Session& session = *shell.open.character();
  const app::ViewState& view = session.view();
  const ViewportOverlays& overlays = shell.ui.overlays;
  FilmRequest request{session.document(), session.sharedMotion(), {}, {}, overlays.sideBySide, {}};
  request.frames = filmedFrames(session);
  request.look.skeleton = overlays.skeleton;
  request.look.ghosts = overlays.ghosts ? overlays.ghostsBefore : 0;
  request.look.trails = false;
  request.look.labelled = true;
  if (overlays.reference) {
    const Result<Backdrops> backdrops = backdropsOf(request.document, view.clip);
    request.look.backdrops = backdrops ? *backdrops : Backdrops(); // What is not there was told before.
  }
  request.look.camera = cameraNamed(*request.document.scene, shell.viewport.look.name);
  request.options.safeFrame = overlays.safeFrame;
  request.options.camera = shell.viewport.camera;
  if (request.besideOriginal) {
    request.options.widthPixels *= 2; // Each side shows as much as one alone would.
  }
  return request;
}

/// The clip without anything that was done to it.
app::Document originalOf(app::Document document) {
  document.clips = app::sourceClipsOf(document);
  document.sourceClips = nullptr;
  document.trails.clear();
  document.adjustments.clear();
  document.holds = {};
  document.weights.clear();
  return document;
}

FilmSide sideOf(const app::Document& document, const std::shared_ptr<const rig::MotionState>& motion,
                const FilmRequest& request) {
  std::vector<double> frames = request.frames; // the same moments, counted as this clip counts
  for (double& frame : frames) {
    frame *= motion->framesPerSecond / request.motion->framesPerSecond;
  }
  return {document.scene.get(), picturesOfCharacter(document, motion, frames, request.look)};
}

Result<std::filesystem::path> drawTo(const std::filesystem::path& path, const FilmRequest& request,
                                     const skinning::Proceed& proceed) {
  Result<std::optional<FilmSound>> sound =
      filmSoundOf(request.document, request.motion->clip, request.frames);
  if (!sound) {
    return sound.error();
  }
  Film film{{}, request.frames, request.motion->framesPerSecond, std::move(*sound)};
  film.sides.push_back(sideOf(request.document, request.motion, request));
  if (request.besideOriginal) {
    const app::Document original = originalOf(request.document);
    const auto motion =
        std::make_shared<const rig::MotionState>(app::prepareMotion(original, request.motion->clip));
    film.sides.insert(film.sides.begin(), sideOf(original, motion, request));
    for (std::size_t i = 0; i < request.frames.size(); ++i) {
      std::string& label = film.sides[1].pictures[i].label;
      film.sides[0].pictures[i].label = "original, " + label;
      label = "exaggerated, " + label;
    }
  }
  const Status written = writeFilm(film, request.options, path, proceed);
  return written ? Result<std::filesystem::path>(path) : Result<std::filesystem::path>(written.error());
}

} // namespace

std::string filmedText(const Shell& shell) {
  const std::vector<double> frames = filmedFrames(*shell.open.character());
  return fmt::format("frames {:g} to {:g}{}", frames.front(), frames.back(),
                     shell.ui.overlays.sideBySide ? ", beside the original" : "");
}

void startFilm(Shell& shell, const std::filesystem::path& path) {
  if (shell.beside.film.job != nullptr) {
    tell(shell, ToastKind::warning, shell.beside.film.path.filename().string() + " is still being drawn");
    return;
  }
  if (shell.beside.library.picture != nullptr) {
    tell(shell, ToastKind::warning, "A picture is still being drawn: try again in a moment");
    return;
  }
  const FilmRequest request = requestOf(shell);
  shell.beside.film.path = path;
  shell.beside.film.drawn = filmedText(shell);
  shell.beside.film.job = std::make_unique<app::Job<std::filesystem::path>>(
      [path, request](const skinning::Proceed& proceed) { return drawTo(path, request, proceed); });
}

void updateFilm(Shell& shell) {
  FilmWork& work = shell.beside.film;
  if (work.job == nullptr || !work.job->isFinished()) {
    return;
  }
  const bool isStopped = work.job->isCancelled();
  const Result<std::filesystem::path> made = work.job->take();
  work.job.reset();
  if (isStopped) {
    return;
  }
  if (!made) {
    tellProblem(shell, made.error());
    return;
  }
  tell(shell, ToastKind::success, "Drawn: " + made->string() + ", " + work.drawn);
}

} // namespace stretch::ui
