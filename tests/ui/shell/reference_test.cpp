#include <catch2/catch.hpp>

#include <cmath>
#include <filesystem>

#include "app/commands/table/command_ids.h"
#include "app/edits/trail/trail_edits.h"
#include "app/reference/reference_edits.h"
#include "tests/support/app/sound_bytes.h"
#include "tests/support/ui/editor_stage.h"
#include "ui/render/picture/image_edits.h"
#include "ui/shell/file_work.h"

using namespace stretch;
using namespace stretch::ui;
namespace command = stretch::app::command;
namespace fs = std::filesystem;

namespace {

/// The bundled character, a series of three images and a sound of a second.
struct Referring : test::EditorStage {
  Referring() {
    openBoxer();
    for (int i = 1; i <= 3; ++i) {
      REQUIRE(writePng(imageFile(i), filled(4 * i, 2, {1.0F, 0.0F, 0.0F})));
    }
    sound = folder.write("beat.wav", test::wavOf(test::toneBetween(0.25, 0.5, 1.0, 8000), 8000));
  }

  [[nodiscard]] fs::path imageFile(int number) const {
    return folder / ("film-" + std::to_string(number) + ".png");
  }
  [[nodiscard]] app::Reference reference() {
    return app::referenceOf(session().document(), session().view().clip);
  }
  /// Width of the image that stands behind the character; 0: none.
  [[nodiscard]] int shownWidth() {
    settle();
    frames(2);
    if (!shell.viewport.look.reference) {
      return 0;
    }
    const Result<std::shared_ptr<const Image>> image = shell.viewport.look.reference->image();
    REQUIRE(image);
    return (*image)->width;
  }
  void dropAndSettle(const fs::path& file) {
    drop({file});
    frames(2);
    settle();
    frames(2);
  }
  [[nodiscard]] std::string lastToast() const {
    return shell.ui.toasts.empty() ? std::string() : shell.ui.toasts.back().text;
  }

  fs::path sound;
};

} // namespace

TEST_CASE("Images that are dropped stand behind the character, each at its frame", "[jobs]") {
  Referring stage;
  stage.session().view().frame = 0.0;
  stage.dropAndSettle(stage.imageFile(1));
  CHECK(stage.reference().images.file == stage.imageFile(1).string());
  CHECK(stage.shell.ui.dialogs.reference.open);
  CHECK(stage.shell.ui.dialogs.reference.imageCount == 3);
  CHECK(stage.shownWidth() == 4);
  stage.session().view().frame = 2.0;
  stage.frames(3);
  CHECK(stage.shownWidth() == 12);
  stage.session().view().frame = 3.0; // after the last image
  stage.frames(3);
  CHECK(stage.shownWidth() == 0);
  stage.session().view().frame = 1.0;
  stage.frames(3);
  CHECK(stage.shownWidth() == 8);
  stage.run(command::viewReference);
  stage.frames(2);
  CHECK(stage.shownWidth() == 0);
  stage.run(command::viewReference);
  stage.frames(2);
  CHECK(stage.shownWidth() == 8);
}

TEST_CASE("Images and sound are chosen, taken off and brought back by undo, each by itself") {
  Referring stage;
  stage.dropAndSettle(stage.imageFile(2));
  stage.dropAndSettle(stage.sound);
  CHECK(stage.reference().images.file == stage.imageFile(2).string());
  CHECK(stage.reference().sound.file == stage.sound.string());
  REQUIRE(stage.shell.ui.time.sound.sound != nullptr);
  CHECK(stage.shell.ui.time.sound.sound->seconds() == Approx(1.0));
  stage.pressWidgetKey(ImGuiKey_Escape);
  stage.frames(2);
  stage.run(command::referenceNoImages);
  stage.frames(2);
  CHECK(stage.reference().images.file.empty());
  CHECK(stage.reference().sound.file == stage.sound.string());
  CHECK(stage.shownWidth() == 0);
  stage.run(command::referenceNoSound);
  stage.frames(2);
  CHECK(stage.shell.ui.time.sound.sound == nullptr);
  CHECK(stage.session().document().references.empty());
  stage.run(command::undo);
  stage.run(command::undo);
  stage.frames(2);
  stage.settle();
  stage.frames(2);
  CHECK(stage.shownWidth() == 8);
  CHECK(stage.shell.ui.time.sound.sound != nullptr);
}

TEST_CASE("Commands that take off are off where nothing is referred to") {
  Referring stage;
  stage.run(command::referenceNoImages);
  CHECK(stage.shell.refused == "Take off the reference images: choose reference images first");
  stage.run(command::referenceNoSound);
  CHECK(stage.shell.refused == "Take off the reference sound: choose a reference sound first");
}

TEST_CASE("What cannot be read is told once, and the work goes on") {
  Referring stage;
  const fs::path broken = stage.folder.write("broken-1.png", "no image");
  stage.dropAndSettle(broken);
  CHECK_THAT(stage.lastToast(), Catch::Contains("broken-1.png"));
  CHECK(stage.shownWidth() == 0);
  stage.shell.ui.toasts.clear();
  stage.frames(20);
  CHECK(stage.shell.ui.toasts.empty());
  const fs::path noise = stage.folder.write("noise.wav", "no sound");
  stage.dropAndSettle(noise);
  CHECK_THAT(stage.lastToast(), Catch::Contains("noise.wav"));
  CHECK(stage.shell.ui.time.sound.sound == nullptr);
}

TEST_CASE("A reference is kept with the user's settings of the file, at once, and comes with it again") {
  Referring stage;
  stage.dropAndSettle(stage.imageFile(1));
  stage.dropAndSettle(stage.sound);
  stage.shell.ui.dialogs.reference.open = false;
  stage.frames(2);
  const app::Reference before = stage.reference();
  const auto text = readText(viewPath(stage.folder / "dummy.glb"));
  REQUIRE(text);
  CHECK_THAT(*text, Catch::Contains("film-1.png"));
  CHECK_THAT(*text, Catch::Contains("beat.wav"));
  REQUIRE(stage.session().save(stage.folder / "dummy.glb", false)); // no question whether to save
  stage.openBoxer();
  CHECK(stage.reference() == before);
  CHECK_FALSE(stage.session().history().canUndo());
  CHECK(stage.session().history().isSaved());
  CHECK(stage.shownWidth() == 4);
  stage.run(command::referenceNoImages);
  stage.run(command::referenceNoSound);
  REQUIRE(stage.session().save(stage.folder / "dummy.glb", false));
  stage.openBoxer();
  CHECK(stage.session().document().references.empty());
}

TEST_CASE("Playing, the sound runs along with the playhead, and a moved playhead lets a moment be heard",
          "[jobs]") {
  Referring stage;
  stage.session().view().frame = 0.0;
  stage.dropAndSettle(stage.sound);
  SoundOutput& output = stage.shell.beside.reference.output;
  CHECK_FALSE(output.isPlaying());
  stage.session().view().frame = 9.0;
  stage.frame();
  CHECK(output.isPlaying());
  const double rate = app::clipOf(stage.session().document(), 0).framesPerSecond;
  CHECK(output.seconds() == Approx(9.0 / rate).margin(0.1));
  stage.frames(10); // a sixth of a second
  CHECK_FALSE(output.isPlaying());
  stage.shell.ui.time.timeline.playing = true;
  stage.frame();
  CHECK(output.isPlaying());
  stage.shell.ui.time.timeline.playing = false;
  stage.frames(2);
  CHECK_FALSE(output.isPlaying());
  stage.session().view().frame = 60.0; // past the sound's end
  stage.frame();
  CHECK_FALSE(output.isPlaying());
}

TEST_CASE("Of all images that are dropped the least by its number begins the series, a sound comes along") {
  Referring stage;
  REQUIRE(writePng(stage.folder / "film-10.png", filled(40, 2, {1.0F, 0.0F, 0.0F})));
  stage.drop({stage.folder / "film-10.png", stage.sound, stage.imageFile(2), stage.imageFile(3)});
  stage.settle();
  CHECK(stage.reference().images.file == stage.imageFile(2).string());
  CHECK(stage.reference().sound.file == stage.sound.string());
}

TEST_CASE("An image beside a file of another kind is no reference") {
  Referring stage;
  const fs::path other = stage.folder / "other.glb";
  fs::copy_file(STRETCH_SOURCE_DIR "/assets/dummy_leap.glb", other);
  stage.drop({stage.imageFile(1), other});
  stage.frames(2);
  CHECK(stage.reference() == app::Reference{});
}

TEST_CASE("Images that were drawn anew are read when they are chosen again, and a broken one shows none") {
  Referring stage;
  stage.session().view().frame = 1.0;
  stage.dropAndSettle(stage.imageFile(1));
  CHECK(stage.shownWidth() == 8);
  REQUIRE(writePng(stage.imageFile(2), filled(20, 2, {1.0F, 0.0F, 0.0F})));
  stage.dropAndSettle(stage.imageFile(1));
  CHECK(stage.shownWidth() == 20);
  stage.folder.write("film-3.png", "no image");
  stage.dropAndSettle(stage.imageFile(1));
  CHECK(stage.shownWidth() == 20);
  stage.session().view().frame = 2.0;
  stage.frames(2);
  CHECK(stage.shownWidth() == 0); // and not the one before
}

TEST_CASE("While something is dragged no reference is taken, which is told") {
  Referring stage;
  stage.session().begin("Drag");
  stage.drop({stage.imageFile(1)});
  CHECK_THAT(stage.shell.refused, Catch::Contains("Finish what is being dragged"));
  CHECK_FALSE(stage.shell.ui.dialogs.reference.open);
  stage.session().cancel();
  CHECK(stage.reference() == app::Reference{});
}

TEST_CASE("Another file without a reference shows and plays nothing of the one before") {
  Referring stage;
  stage.dropAndSettle(stage.imageFile(1));
  stage.dropAndSettle(stage.sound);
  REQUIRE(stage.session().save(stage.folder / "dummy.glb", false));
  fs::copy_file(STRETCH_SOURCE_DIR "/assets/dummy_leap.glb", stage.folder / "leap.glb");
  openFile(stage.shell, {stage.folder / "leap.glb"});
  stage.frames(2);
  stage.settle();
  CHECK(stage.reference() == app::Reference{});
  CHECK_FALSE(stage.shell.viewport.look.reference);
  CHECK(stage.shell.ui.time.sound.sound == nullptr);
  CHECK_FALSE(stage.shell.ui.dialogs.reference.open);
  CHECK_FALSE(isReadingReference(stage.shell.beside.reference));
}

TEST_CASE("A reference is no work that a file could lose: nothing is asked at its end") {
  Referring stage;
  stage.dropAndSettle(stage.imageFile(1));
  CHECK_FALSE(app::hasUnsavedWork(stage.shell.open));
  stage.session().edit(app::setLooping(stage.session().document(), 0, true), "Loop");
  CHECK(app::hasUnsavedWork(stage.shell.open));
  stage.session().undo();
  CHECK_FALSE(app::hasUnsavedWork(stage.shell.open));
}

TEST_CASE("On twos the sound runs by the clock, not by the frame that is held on the screen") {
  Referring stage;
  stage.session().view().frame = 0.0;
  stage.dropAndSettle(stage.sound);
  TimelineState& time = stage.shell.ui.time.timeline;
  time.onTwos = true;
  time.playing = true;
  bool parted = false;
  for (int i = 0; i < 12; ++i) {
    stage.frame();
    REQUIRE(stage.shell.beside.reference.heardFrame);
    CHECK(*stage.shell.beside.reference.heardFrame == time.clock);
    parted = parted || std::abs(time.clock - stage.session().view().frame) > 0.5;
  }
  CHECK(parted);
}
