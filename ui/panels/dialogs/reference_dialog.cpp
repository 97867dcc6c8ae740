#include <filesystem>
#include <string>

#include <fmt/core.h>

#include "app/commands/table/command_ids.h"
#include "app/reference/reference_edits.h"
#include "app/schema/reference_schema.h"
#include "ui/panels/context/dialog_frame.h"
#include "ui/panels/context/setting_rows.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/layout.h"

namespace stretch::ui {

namespace {

/// Rows of images or of the sound, with what chooses and takes off their file above them.
struct ReferencePart {
  std::string file;
  std::string facts; ///< "48 images".
  std::string none;  ///< Told while there is no file.
  const char* choose = "";
  const char* takeOff = "";
};

void fileRows(PanelContext& context, const ReferencePart& part) {
  const WidgetContext widgets = widgetsOf(context);
  note(widgets, part.file.empty() ? part.none
                                  : std::filesystem::path(part.file).filename().string() +
                                        (part.facts.empty() ? "" : ", " + part.facts));
  const float width = columnWidth(2);
  commandButton(context, {.command = part.choose, .text = "Choose...", .width = width});
  ImGui::SameLine();
  commandButton(context, {.command = part.takeOff, .text = "Take off", .width = width});
}

template <typename Settings>
void rowsOf(PanelContext& context, const char* prefix, const app::Schema<Settings>& schema,
            Settings app::Reference::*part) {
  const app::Session& session = context.character();
  const app::Reference reference = app::referenceOf(session.document(), session.view().clip);
  for (const app::Setting<Settings>& setting : schema) {
    if (setting.row.section.empty()) {
      continue;
    }
    RowExtras extras;
    extras.automatic = app::clipOf(session.document(), reference.clip).framesPerSecond;
    settingRow(
        context, prefix, setting, reference.*part,
        [&](const EditPhase& phase, const std::string& label, const auto& change) {
          editThrough(context, phase, label, [&](const app::Document& start) -> Result<app::Document> {
            app::Reference changed = app::referenceOf(start, reference.clip);
            change(changed.*part);
            return app::withReference(start, changed);
          });
        },
        extras);
  }
}

std::string countText(std::size_t count) {
  return count == 0 ? "not found" : count == 1 ? "one image" : fmt::format("{} images", count);
}

std::string lengthText(const PanelContext& context) {
  const std::shared_ptr<const app::Sound>& sound = context.ui.time.sound.sound;
  return sound == nullptr ? "" : fmt::format("{:.1f} s", sound->seconds());
}

void imageRows(PanelContext& context, const app::ReferenceImages& images) {
  fileRows(context, {images.file, countText(context.ui.dialogs.reference.imageCount),
                     "A series of images to animate after: choose the first one. A film becomes images by: "
                     "ffmpeg -i film.mp4 film-%04d.png",
                     app::command::referenceImages, app::command::referenceNoImages});
  if (!images.file.empty()) {
    rowsOf(context, "reference/images-", app::referenceImagesSchema(), &app::Reference::images);
  }
}

void soundRows(PanelContext& context, const app::ReferenceSound& sound) {
  fileRows(context,
           {sound.file, lengthText(context), "A sound to time the motion to: WAV, AIFF, FLAC, Ogg or MP3.",
            app::command::referenceSound, app::command::referenceNoSound});
  if (!sound.file.empty()) {
    rowsOf(context, "reference/sound-", app::referenceSoundSchema(), &app::Reference::sound);
  }
}

} // namespace

void drawReferenceDialog(PanelContext& context) {
  ReferenceDialogState& state = context.ui.dialogs.reference;
  if (!state.open || !hasViewedClip(context)) {
    return;
  }
  if (!beginDialog(context,
                   {.id = "reference",
                    .icon = icon::film,
                    .title = "Reference",
                    .width = 360.0F,
                    .across = 1.0F,
                    .darkens = false},
                   state.open)) {
    return;
  }
  const app::Session& session = context.character();
  const app::Reference reference = app::referenceOf(session.document(), session.view().clip);
  std::vector<std::string>& closed = context.ui.closedSections;
  if (section(widgetsOf(context), "reference/images", "Images", closed)) {
    imageRows(context, reference.images);
  }
  if (section(widgetsOf(context), "reference/sound", "Sound", closed)) {
    soundRows(context, reference.sound);
  }
  const int clicked = dialogButtons(context, "reference", {{.id = "", .text = "Done"}});
  const bool entered = enterPressed() && !ImGui::GetIO().WantTextInput;
  state.open = state.open && clicked != 0 && !entered;
  if (!state.open) {
    ImGui::CloseCurrentPopup();
  }
  endDialog();
}

} // namespace stretch::ui
