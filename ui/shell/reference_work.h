#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/commands/table/command.h"
#include "app/reference/image_series.h"
#include "app/sequence/job.h"
#include "ui/shell/reference/image_cache.h"
#include "ui/shell/reference/sound_output.h"

namespace stretch::ui {

struct Shell;

/// Images and sound of the clip's reference, as they are read, shown and heard beside the work.
struct ReferenceWork {
  std::optional<std::string> seriesOf; ///< First image of `series`; nothing: it is to be looked for.
  app::ImageSeries series;
  bool brokenTold = false; ///< That an image of it cannot be read.
  ImageCache images;
  std::shared_ptr<const Image> shown;
  std::optional<std::string> soundOf; ///< File of `sound`; nothing: it is to be read.
  std::shared_ptr<const app::Sound> sound;
  std::unique_ptr<app::Job<app::Sound>> reading; ///< Null: it is there, or cannot be read.
  SoundOutput output;
  std::optional<double> heardFrame; ///< Playhead when something was heard last.
  double silentAtSeconds = 0.0;     ///< Time of the clock at which what a scrub made heard ends.
  bool plays = false;               ///< The playhead ran when something was heard last.
  bool silent = false;              ///< No device plays: it was told.
  std::vector<app::Reference> kept; ///< References as the user's settings of the file have them.
};

/// Takes the references that are kept with the user's settings of the file. Once, when a file was opened.
void takeReferences(Shell& shell, const std::string& viewText);

/// Once a frame, when the playhead has come to where it is drawn: reads what the clip's reference names,
/// shows the image of the playhead and plays the sound along with it. `nowSeconds`: of the program's clock.
void updateReference(Shell& shell, double nowSeconds);

/// Nothing is referred to any more: what was read, shown and heard goes.
void forgetReference(Shell& shell);

/// Something is still being read.
[[nodiscard]] bool isReadingReference(const ReferenceWork& work);

/// Makes this image, and those that follow it by number, or this sound, the reference of the shown clip.
void referToImages(Shell& shell, const std::filesystem::path& first);
void referToSound(Shell& shell, const std::filesystem::path& file);

/// Does so for files that were dropped, of which the least image by its number counts; false where any is of
/// another kind.
[[nodiscard]] bool takeDroppedReference(Shell& shell, const std::vector<std::filesystem::path>& files);

/// Commands that choose, show and take off references.
[[nodiscard]] std::vector<app::Command<Shell>> referenceCommands();

} // namespace stretch::ui
