#include "app/schema/reference_schema.h"

#include "app/schema/schema_rows.h"

namespace stretch::app {

namespace {

constexpr double farthestFrame = 1e6; ///< From the clip's start.

template <typename Settings>
Setting<Settings> fileSetting(const char* name, const char* help) {
  return setting<Settings>({.name = name, .help = help}, &Settings::file);
}

template <typename Settings>
Setting<Settings> startSetting(const char* help) {
  return setting<Settings>({.name = "start_frame",
                            .minimum = -farthestFrame,
                            .maximum = farthestFrame,
                            .unit = "frames",
                            .help = help,
                            .row = {.section = "reference",
                                    .label = "Start",
                                    .minimum = -200.0,
                                    .maximum = 200.0,
                                    .step = 1.0,
                                    .fineStep = 0.1}},
                           &Settings::startFrame);
}

template <typename Settings, typename Member>
Setting<Settings> shareSetting(const char* name, const char* help, double most, Member member) {
  return setting<Settings>({.name = name,
                            .maximum = most,
                            .help = help,
                            .row = {.section = "reference", .step = 0.05, .fineStep = 0.01, .percent = true}},
                           member);
}

} // namespace

const Schema<ReferenceImages>& referenceImagesSchema() {
  using R = ReferenceImages;
  static const Schema<R> schema{
      fileSetting<R>("first_image", "The first image of the series, or a single one."),
      startSetting<R>("Frame of the clip that shows the first image."),
      setting<R>({.name = "images_per_second",
                  .minimum = 0.1,
                  .maximum = 1000.0,
                  .help = "Images for each second of the clip; left out: one for each frame.",
                  .row = {.section = "reference",
                          .label = "Images/s",
                          .minimum = 1.0,
                          .maximum = 120.0,
                          .step = 1.0,
                          .fineStep = 0.1}},
                 &R::imagesPerSecond),
      setting<R>({.name = "where",
                  .choices = {{"behind", "In the middle of the view, behind the character."},
                              {"left", "At the left end of the view."},
                              {"right", "At the right end of the view."}},
                  .help = "Where the images stand in the view.",
                  .row = {.section = "reference", .label = "Place"}},
                 &R::place),
      shareSetting<R>("size", "Height of the images: of the view's, or beside it of half the view's.", 4.0,
                      &R::size),
      shareSetting<R>("opacity", "How much of the background the images cover.", 1.0, &R::opacity),
  };
  return schema;
}

const Schema<ReferenceSound>& referenceSoundSchema() {
  using R = ReferenceSound;
  static const Schema<R> schema{
      fileSetting<R>("sound_file", "The sound: WAV, AIFF, FLAC, Ogg or MP3."),
      startSetting<R>("Frame of the clip at which the sound begins."),
      shareSetting<R>("volume", "How loud it is played.", 1.0, &R::volume),
  };
  return schema;
}

} // namespace stretch::app
