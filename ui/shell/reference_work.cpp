#include "ui/shell/reference_work.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/core.h>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/frames.h"
#include "app/commands/table/tables.h"
#include "app/reference/reference_edits.h"
#include "core/anim/frames.h"
#include "ui/shell/file_work.h"
#include "ui/shell/shell_command.h"
#include "ui/viewport/shown/shown_reference.h"

namespace stretch::ui {

namespace {

namespace command = app::command;

app::Reference shownReference(const Shell& shell) {
  const app::Session& session = *shell.open.character();
  return app::referenceOf(session.document(), session.view().clip);
}

double framesPerSecondOf(const Shell& shell) {
  const app::Session& session = *shell.open.character();
  return app::clipOf(session.document(), session.view().clip).framesPerSecond;
}

/// The image of the playhead and some of those that playing shows next.
std::vector<std::filesystem::path> wantedImages(const Shell& shell, const app::ReferenceImages& images) {
  constexpr int ahead = 8;
  std::vector<std::filesystem::path> wanted;
  const double frame = shell.open.character()->view().frame;
  for (int i = 0; i <= ahead; ++i) {
    const std::filesystem::path* const file =
        app::imageAt(shell.beside.reference.series, images, frame + i, framesPerSecondOf(shell));
    if (file != nullptr && (wanted.empty() || wanted.back() != *file)) {
      wanted.push_back(*file);
    } else if (i == 0) {
      wanted.emplace_back();
    }
  }
  return wanted;
}

void updateImages(Shell& shell, const app::ReferenceImages& images) {
  ReferenceWork& work = shell.beside.reference;
  if (std::exchange(work.seriesOf, images.file) != images.file) {
    Result<app::ImageSeries> series = images.file.empty() ? Result<app::ImageSeries>(app::ImageSeries{})
                                                          : app::imageSeriesFrom(images.file);
    work.series = series ? std::move(*series) : app::ImageSeries{};
    work.shown = nullptr;
    work.images = {};
    work.brokenTold = false;
    tellProblem(shell, series ? Status(Success{}) : Status(series.error()));
  }
  shell.ui.dialogs.reference.imageCount = work.series.images.size();
  std::vector<std::filesystem::path> wanted = wantedImages(shell, images);
  const std::filesystem::path now = wanted.front();
  std::erase(wanted, std::filesystem::path{});
  if (images.file.empty() || !shell.ui.overlays.reference) {
    wanted.clear();
  }
  const Status read = work.images.update(wanted);
  if (!read && !std::exchange(work.brokenTold, true)) {
    tellProblem(shell, read);
  }
  // While one is read the one before stays.
  std::shared_ptr<const Image> image = work.images.at(now);
  const bool isNone = now.empty() || work.images.isBroken(now);
  work.shown = isNone ? nullptr : image != nullptr ? std::move(image) : work.shown;
  shell.viewport.look.reference =
      shell.ui.overlays.reference && work.shown != nullptr
          ? std::optional(backdropOf(images, [shown = work.shown] { return shown; }))
          : std::nullopt;
}

void readSoundOf(Shell& shell, const std::string& file) {
  ReferenceWork& work = shell.beside.reference;
  if (std::exchange(work.soundOf, file) != file) {
    work.output.stop();
    work.sound = nullptr;
    work.heardFrame.reset();
    work.silent = false;
    work.reading = file.empty()
                       ? nullptr
                       : std::make_unique<app::Job<app::Sound>>([file](const skinning::Proceed& proceed) {
                           return app::readSound(file, [&] { return proceed(0.0); });
                         });
  }
  if (work.reading != nullptr && work.reading->isFinished()) {
    Result<app::Sound> read = work.reading->take();
    work.reading.reset();
    if (read) {
      work.sound = std::make_shared<const app::Sound>(std::move(*read));
    } else {
      tellProblem(shell, read.error());
    }
  }
}

/// Plays from where the playhead is; that nothing can be heard is told once.
void hear(Shell& shell, const app::ReferenceSound& settings, double seconds, double speed) {
  ReferenceWork& work = shell.beside.reference;
  if (work.silent || settings.volume <= 0.0 || seconds < 0.0 || seconds >= work.sound->seconds()) {
    work.output.stop();
    return;
  }
  const Status heard = work.output.play(work.sound, seconds, speed, settings.volume);
  work.silent = !heard;
  tellProblem(shell, heard);
}

/// Playing, the sound runs along with the playhead and is set right where they part; a playhead that is moved
/// lets a frame of it be heard.
void updateHearing(Shell& shell, const app::ReferenceSound& settings, double nowSeconds) {
  constexpr double mostApart = 0.1;   // Seconds: three frames, before lips are seen to be late.
  constexpr double leastHeard = 0.06; // Seconds: less is a click.
  ReferenceWork& work = shell.beside.reference;
  const TimelineState& time = shell.ui.time.timeline;
  // What is drawn may be held for some frames: the clock runs on.
  const double frame = time.playing ? time.clock : shell.open.character()->view().frame;
  const double rate = framesPerSecondOf(shell);
  const double seconds = (frame - settings.startFrame) / rate;
  const bool moved = work.heardFrame && *work.heardFrame != frame;
  work.heardFrame = frame;
  const bool wasPlaying = std::exchange(work.plays, time.playing);
  work.output.setVolume(settings.volume);
  if (time.playing) {
    const bool isInside = seconds >= 0.0 && seconds < work.sound->seconds();
    const bool isApart = !work.output.isPlaying() || std::abs(work.output.seconds() - seconds) > mostApart;
    if (isApart || !isInside) {
      hear(shell, settings, seconds, time.speed);
    }
    work.silentAtSeconds = nowSeconds;
  } else if (moved && !wasPlaying) {
    hear(shell, settings, seconds, 1.0);
    work.silentAtSeconds = nowSeconds + std::max(leastHeard, 1.0 / rate);
  } else if (nowSeconds >= work.silentAtSeconds) {
    work.output.stop();
  }
}

void updateSound(Shell& shell, const app::ReferenceSound& settings, double nowSeconds) {
  ReferenceWork& work = shell.beside.reference;
  readSoundOf(shell, settings.file);
  shell.ui.time.sound = {work.sound, settings.startFrame,
                         std::filesystem::path(settings.file).filename().string()};
  if (work.sound == nullptr) {
    return;
  }
  updateHearing(shell, settings, nowSeconds);
}

/// False while something else is dragged, which is told.
bool editReference(Shell& shell, const app::Reference& reference, const char* label) {
  app::Session& session = *shell.open.character();
  if (session.isDragging()) {
    refuse(shell, "Finish what is being dragged first");
    return false;
  }
  session.edit(app::withReference(session.document(), reference), label);
  return true;
}

bool refersToImages(const Shell& shell) {
  return showsClip(shell) && !shownReference(shell).images.file.empty();
}

bool refersToSound(const Shell& shell) {
  return showsClip(shell) && !shownReference(shell).sound.file.empty();
}

void takeOffImages(Shell& shell) {
  app::Reference reference = shownReference(shell);
  reference.images = {};
  static_cast<void>(editReference(shell, reference, "Take off the reference images"));
}

void takeOffSound(Shell& shell) {
  app::Reference reference = shownReference(shell);
  reference.sound = {};
  static_cast<void>(editReference(shell, reference, "Take off the reference sound"));
}

} // namespace

void forgetReference(Shell& shell) {
  ReferenceWork& work = shell.beside.reference;
  work.output.stop();
  work.seriesOf.reset();
  work.series = {};
  work.images = {};
  work.shown = nullptr;
  work.soundOf.reset();
  work.sound = nullptr;
  work.reading.reset();
  shell.viewport.look.reference.reset();
  shell.ui.time.sound = {};
  shell.ui.dialogs.reference = {};
}

bool isReadingReference(const ReferenceWork& work) {
  return work.images.isReading() || work.reading != nullptr;
}

void takeReferences(Shell& shell, const std::string& viewText) {
  app::Session& session = *shell.open.character();
  app::Document document = session.document();
  document.references = app::referencesFromJson(referencesOfView(viewText), document);
  shell.beside.reference.kept = document.references;
  if (!document.references.empty()) {
    session.restore(std::move(document));
  }
}

void updateReference(Shell& shell, double nowSeconds) {
  if (!showsClip(shell)) {
    forgetReference(shell);
    return;
  }
  const app::Reference reference = shownReference(shell);
  updateImages(shell, reference.images);
  updateSound(shell, reference.sound, nowSeconds);
  const app::Session& session = *shell.open.character();
  if (!session.isDragging() && shell.beside.reference.kept != session.document().references) {
    shell.beside.reference.kept = session.document().references;
    keepView(shell); // At once: a program that is killed loses no reference.
  }
}

void referToImages(Shell& shell, const std::filesystem::path& first) {
  const Result<app::ImageSeries> series = app::imageSeriesFrom(first);
  if (!series) {
    tellProblem(shell, series.error());
    return;
  }
  app::Reference reference = shownReference(shell);
  reference.images.file = std::filesystem::absolute(first).lexically_normal().string();
  if (editReference(shell, reference, "Refer to images")) {
    shell.beside.reference.seriesOf.reset(); // The same one again is read anew.
    shell.ui.overlays.reference = true;
    shell.ui.dialogs.reference.open = true;
  }
}

void referToSound(Shell& shell, const std::filesystem::path& file) {
  app::Reference reference = shownReference(shell);
  reference.sound.file = std::filesystem::absolute(file).lexically_normal().string();
  if (editReference(shell, reference, "Refer to a sound")) {
    shell.beside.reference.soundOf.reset();
    shell.ui.dialogs.reference.open = true;
  }
}

bool takeDroppedReference(Shell& shell, const std::vector<std::filesystem::path>& files) {
  std::vector<std::filesystem::path> images;
  std::vector<std::filesystem::path> sounds;
  std::ranges::copy_if(files, std::back_inserter(images), app::isImageName);
  std::ranges::copy_if(files, std::back_inserter(sounds), app::isSoundName);
  if (files.empty() || images.size() + sounds.size() != files.size()) {
    return false;
  }
  if (!images.empty()) { // "film-2" comes before "film-10".
    referToImages(shell, std::ranges::min(images, {}, [](const std::filesystem::path& file) {
                    const std::string name = file.string();
                    return std::pair(name.size(), name);
                  }));
  }
  if (!sounds.empty()) {
    referToSound(shell, sounds.front());
  }
  return true;
}

std::vector<ShellCommand> referenceCommands() {
  constexpr ShellNeed clipNeeded{showsClip, "open a character with a clip first"};
  const auto asking = [](FilePurpose purpose) {
    return app::doing([purpose](Shell& shell) { askForFile(shell, purpose); });
  };
  return {
      shellCommand(command::reference, "Reference...",
                   "Images behind the character or beside it, and a sound in the timeline, to animate after.",
                   {}, clipNeeded, app::doing([](Shell& shell) { shell.ui.dialogs.reference.open = true; })),
      shellCommand(command::referenceImages, "Choose reference images...",
                   "A series of images that the clip is animated after: the first of them is chosen.", {},
                   clipNeeded, asking(FilePurpose::openReferenceImages)),
      shellCommand(command::referenceNoImages, "Take off the reference images", "The clip refers to none.",
                   {}, {refersToImages, "choose reference images first"}, app::doing(takeOffImages)),
      shellCommand(command::referenceSound, "Choose a reference sound...",
                   "A sound that the clip is timed to, in the timeline.", {}, clipNeeded,
                   asking(FilePurpose::openReferenceSound)),
      shellCommand(command::referenceNoSound, "Take off the reference sound", "The clip refers to none.", {},
                   {refersToSound, "choose a reference sound first"}, app::doing(takeOffSound))};
}

} // namespace stretch::ui
