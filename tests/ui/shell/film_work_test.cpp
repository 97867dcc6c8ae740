#include <algorithm>
#include <chrono>
#include <thread>

#include <catch2/catch.hpp>

#include "app/commands/table/command_ids.h"
#include "app/files/user_poses.h"
#include "tests/support/ui/editor_stage.h"
#include "ui/render/picture/image_edits.h"
#include "ui/shell/film_work.h"

using namespace stretch;
using namespace stretch::ui;

namespace {

/// The bundled character while a playblast of it is drawn, which ends only when it is given up.
struct EndlessFilm : test::EditorStage {
  EndlessFilm() {
    openBoxer();
    shell.beside.film.path = folder / "shot.mp4";
    shell.beside.film.drawn = "frames 3 to 9";
    shell.beside.film.job =
        std::make_unique<app::Job<std::filesystem::path>>([](const skinning::Proceed& proceed) {
          while (proceed(0.5)) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
          }
          return Result<std::filesystem::path>(Error{"was stopped", "", ""});
        });
  }
  [[nodiscard]] std::ptrdiff_t timesTold(const std::string& text) const {
    return std::ranges::count(shell.ui.toasts, text, &Toast::text);
  }
};

} // namespace

TEST_CASE("Esc stops a playblast that is drawn, whose name and frames are told until then", "[jobs]") {
  EndlessFilm stage;
  CHECK(statusOf(stage.shell).busyText == "Drawing shot.mp4, frames 3 to 9");
  stage.shell.ui.toasts.clear();
  stage.press("Esc");
  CHECK(stage.timesTold("Stopped: nothing was changed") == 1);
  stage.settle();
  CHECK(stage.shell.beside.film.job == nullptr);
  CHECK(statusOf(stage.shell).busyText.empty());
  CHECK(stage.shell.ui.toasts.size() == 1); // That it was stopped is no failure of it.
}

TEST_CASE("While a playblast is drawn no other is begun, which is told, and the first goes on") {
  EndlessFilm stage;
  const auto* const first = stage.shell.beside.film.job.get();
  startFilm(stage.shell, stage.folder / "other.mp4");
  CHECK(stage.timesTold("shot.mp4 is still being drawn") == 1);
  CHECK(stage.shell.beside.film.job.get() == first);
  CHECK(stage.shell.beside.film.path.filename() == "shot.mp4");
}

TEST_CASE(
    "While a playblast is drawn no pose is kept, whose picture would be drawn beside it, which is told") {
  EndlessFilm stage;
  stage.run(app::command::poseKeep);
  CHECK(std::ranges::any_of(stage.shell.ui.toasts, [](const Toast& toast) {
    return toast.text.find("another picture is still being drawn") != std::string::npos;
  }));
  CHECK(app::posesIn(app::posesFolder()).poses.empty());
  CHECK_FALSE(stage.shell.ui.body.library.open);
}

TEST_CASE("While the picture of a pose is drawn no playblast is begun, which is told") {
  test::EditorStage stage;
  stage.openBoxer();
  stage.shell.beside.library.picture = std::make_unique<app::Job<Image>>(
      [](const skinning::Proceed&) { return Result<Image>(filled(2, 2, glm::vec3(0.5F))); });
  startFilm(stage.shell, stage.folder / "shot.mp4");
  CHECK(stage.shell.beside.film.job == nullptr);
  CHECK(std::ranges::count(stage.shell.ui.toasts, "A picture is still being drawn: try again in a moment",
                           &Toast::text) == 1);
}
