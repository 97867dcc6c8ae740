#include "ui/viewport/welcome.h"

#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "app/files/bundled_folder.h"
#include "ui/panels/context/panel_support.h"
#include "ui/panels/files/welcome_entries.h"
#include "ui/render/gl/picture_texture.h"
#include "ui/render/picture/image_edits.h"
#include "ui/widgets/control.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/layout.h"

namespace stretch::ui {

namespace {

constexpr float widestCard = 220.0F; ///< Design pixels.
constexpr float smallestCard = 150.0F;
constexpr float pictureRatio = 1.6F; ///< Width over height.

void loadPictures(WelcomePictures& pictures) {
  pictures.tried = true;
  const std::optional<std::filesystem::path> folder = app::bundledFolder();
  for (const app::BundledClip& clip : app::bundledClips()) {
    const Result<Image> image =
        folder ? readImage(*folder / clip.picture) : Result<Image>(Error{"no folder", clip.picture, ""});
    pictures.textures.push_back(image ? uploadPicture(*image) : GlTexture());
  }
}

void open(ViewportContext& context, const WelcomeEntry& entry) {
  switch (entry.kind) {
  case WelcomeEntry::Kind::bundled:
    request(context, entry.clip->commandId);
    break;
  case WelcomeEntry::Kind::dialog:
    request(context, command::fileOpen);
    break;
  case WelcomeEntry::Kind::recent:
    context.ui.answers.file = FileChoice{FilePurpose::openModel, entry.file};
    break;
  }
}

/// Frame of an entry: lit under the mouse, outlined while the keys are on it.
void drawFrame(const Theme& theme, const Control& place, bool highlighted) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(place.box.min, place.box.max,
                      place.hovered ? theme.colours.hovered : theme.colours.raised, theme.px(6.0F));
  list->AddRect(place.box.min, place.box.max, highlighted ? theme.colours.accent : theme.colours.border,
                theme.px(6.0F), 0, theme.px(highlighted ? 2.0F : 1.0F));
}

/// Where the parts of a bundled clip's entry lie: the picture over the text, or beside it where the entries
/// stand one under the other.
struct CardPlan {
  ImVec2 size;
  Rect picture; ///< From the entry's corner.
  Rect text;
};

CardPlan planCard(const Theme& theme, float width, bool upright) {
  const float pad = theme.px(8.0F);
  const float textHeight = theme.px(58.0F);
  if (!upright) {
    const Rect picture{{pad, pad}, {pad + std::floor(pictureRatio * textHeight), pad + textHeight}};
    const float tall = theme.px(76.0F); // A name on two rows.
    return {{width, tall + 2.0F * pad}, picture, {{picture.max.x + pad, pad}, {width - pad, pad + tall}}};
  }
  const float inner = width - 2.0F * pad;
  const float end = pad + std::floor(inner / pictureRatio);
  const Rect text{{pad, end + 0.5F * pad}, {width - pad, end + 0.5F * pad + textHeight}};
  return {{width, text.max.y + pad}, {{pad, pad}, {width - pad, end}}, text};
}

Rect shifted(const Rect& rect, const ImVec2& by) {
  return {{rect.min.x + by.x, rect.min.y + by.y}, {rect.max.x + by.x, rect.max.y + by.y}};
}

/// The name of a clip and its line, on up to two rows each, as many as have room.
void drawClipText(const WidgetContext& widgets, const app::BundledClip& clip, const Rect& box) {
  const Theme& theme = widgets.theme;
  ImFont* const strong = theme.fonts.strong != nullptr ? theme.fonts.strong : ImGui::GetFont();
  ImFont* const label = theme.fonts.label != nullptr ? theme.fonts.label : ImGui::GetFont();
  const std::vector<std::string_view> name = wrapped(strong, clip.name, box.width(), 2);
  float y = box.min.y;
  for (const std::string_view text : name) {
    const float height = theme.px(name.size() > 1 ? 19.0F : 22.0F);
    drawText(widgets, theme.fonts.strong, {{box.min.x, y}, {box.max.x, y + height}}, theme.colours.text,
             text);
    y += height;
  }
  const std::size_t rows = box.max.y - y < theme.px(34.0F) ? 1 : 2;
  for (const std::string_view text : wrapped(label, clip.line, box.width(), rows)) {
    drawText(widgets, theme.fonts.label, {{box.min.x, y}, {box.max.x, y + theme.px(18.0F)}},
             theme.colours.quietText, text);
    y += theme.px(18.0F);
  }
}

/// A bundled clip: its picture, its name and a line. True when it was clicked.
bool clipCard(ViewportContext& context, const app::BundledClip& clip, const GlTexture& picture,
              const CardPlan& plan, bool highlighted) {
  const WidgetContext widgets = widgetsOf(context);
  const Control place = takePlace(widgets, std::string("welcome/") + clip.file, plan.size);
  drawFrame(context.theme, place, highlighted);
  drawThumbnail(context.theme, textureOf(picture.name()), shifted(plan.picture, place.box.min));
  drawClipText(widgets, clip, shifted(plan.text, place.box.min));
  tooltip(widgets, {clip.name, clip.line, {}});
  return place.clicked;
}

/// A recent file: its name, and its folder where there is room. True when it was clicked.
bool recentRow(ViewportContext& context, const std::filesystem::path& file, std::size_t index,
               bool highlighted) {
  const Theme& theme = context.theme;
  const WidgetContext widgets = widgetsOf(context);
  const float width = ImGui::GetContentRegionAvail().x;
  const Control place =
      takePlace(widgets, "welcome/recent/" + std::to_string(index + 1), {width, theme.rowHeight()});
  drawFrame(theme, place, highlighted);
  const float pad = theme.px(8.0F);
  const std::string name = app::shownName(file);
  const float nameWidth = std::min(textSize(theme.fonts.body, name).x + pad, width - 2.0F * pad);
  const Rect row{{place.box.min.x + pad, place.box.min.y}, {place.box.max.x - pad, place.box.max.y}};
  drawText(widgets, theme.fonts.body, {row.min, {row.min.x + nameWidth, row.max.y}}, theme.colours.text,
           name);
  const float rest = row.width() - nameWidth - pad;
  if (rest > theme.px(60.0F)) {
    drawText(widgets, theme.fonts.label, {{row.min.x + nameWidth + pad, row.min.y}, row.max},
             theme.colours.quietText, cutInMiddle(theme.fonts.label, file.parent_path().string(), rest),
             1.0F);
  }
  tooltip(widgets, {name, file.parent_path().string(), {}});
  return place.clicked;
}

/// Scrolls to the last widget if the keys have just come to it.
void showHighlighted(ViewportContext& context, bool highlighted) {
  if (highlighted && context.ui.welcome.moved) {
    ImGui::SetScrollHereY();
    context.ui.welcome.moved = false;
  }
}

/// Entries with pictures, as many beside each other as have room.
void clipCards(ViewportContext& context, const WelcomePictures& pictures,
               const std::vector<WelcomeEntry>& entries) {
  const Theme& theme = context.theme;
  const float room = ImGui::GetContentRegionAvail().x;
  const float gap = theme.unit();
  const int fitting = static_cast<int>((room + gap) / (theme.px(smallestCard) + gap));
  const int columns = std::clamp(fitting, 1, static_cast<int>(app::bundledClips().size()));
  context.ui.welcome.columns = columns;
  const float width =
      std::floor((room - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns));
  const CardPlan plan = planCard(theme, width, columns > 1);
  for (std::size_t i = 0; i < app::bundledClips().size(); ++i) {
    if (i % static_cast<std::size_t>(columns) != 0) {
      ImGui::SameLine(0.0F, gap);
    }
    const bool highlighted = context.ui.welcome.highlighted == static_cast<int>(i);
    if (clipCard(context, *entries[i].clip, pictures.textures[i], plan, highlighted)) {
      open(context, entries[i]);
    }
    showHighlighted(context, highlighted);
  }
}

void recentFiles(ViewportContext& context, const std::vector<WelcomeEntry>& entries, std::size_t first) {
  const WidgetContext widgets = widgetsOf(context);
  verticalSpace(widgets, 6.0F);
  if (first == entries.size()) {
    note(widgets, "Recent files will be listed here.");
    return;
  }
  note(widgets, "Recent files");
  for (std::size_t i = first; i < entries.size(); ++i) {
    if (recentRow(context, entries[i].file, i - first,
                  context.ui.welcome.highlighted == static_cast<int>(i))) {
      open(context, entries[i]);
    }
    showHighlighted(context, context.ui.welcome.highlighted == static_cast<int>(i));
  }
}

void welcomeContent(ViewportContext& context, const WelcomePictures& pictures) {
  const Theme& theme = context.theme;
  const WidgetContext widgets = widgetsOf(context);
  WelcomeState& welcome = context.ui.welcome;
  const std::vector<WelcomeEntry> entries = welcomeEntries(context.ui);
  welcome.highlighted = std::clamp(welcome.highlighted, 0, static_cast<int>(entries.size()) - 1);
  ImGui::PushFont(theme.fonts.heading);
  ImGui::TextUnformatted("Begin with a clip");
  ImGui::PopFont();
  note(widgets, "Arrows choose, Enter opens. Or drop a file here.");
  verticalSpace(widgets, 4.0F);
  clipCards(context, pictures, entries);
  verticalSpace(widgets, 4.0F);
  const std::size_t dialog = app::bundledClips().size();
  ButtonSpec button{.id = "viewport/open", .icon = icon::folderOpen, .text = "Open a file"};
  button.emphasis = welcome.highlighted == static_cast<int>(dialog) ? Emphasis::primary : Emphasis::normal;
  button.width = ImGui::GetContentRegionAvail().x;
  if (ui::button(widgets, button)) {
    open(context, entries[dialog]);
  }
  showHighlighted(context, welcome.highlighted == static_cast<int>(dialog));
  recentFiles(context, entries, dialog + 1);
  if (std::exchange(welcome.entered, false)) {
    open(context, entries[static_cast<std::size_t>(welcome.highlighted)]);
  }
}

void drawBusy(ViewportContext& context, const Rect& box) {
  const Theme& theme = context.theme;
  const float width = std::min(theme.px(320.0F), box.width() - 2.0F * theme.unit());
  ImGui::SetCursorScreenPos({box.centre().x - 0.5F * width, box.centre().y - theme.px(90.0F)});
  ImGui::BeginChild("viewport-empty", {width, theme.px(200.0F)}, false, ImGuiWindowFlags_NoBackground);
  emptyState(widgetsOf(context), icon::clock, context.status.busyText, "The window stays alive meanwhile.");
  ImGui::EndChild();
}

} // namespace

void drawWelcome(ViewportContext& context, WelcomePictures& pictures, const Rect& box) {
  const Theme& theme = context.theme;
  ImGui::GetWindowDrawList()->AddRectFilled(box.min, box.max, theme.colours.background);
  if (!context.status.busyText.empty()) {
    drawBusy(context, box);
    return;
  }
  if (!pictures.tried) {
    loadPictures(pictures);
  }
  const float margin = 2.0F * theme.unit();
  const float widest = 3.0F * theme.px(widestCard) + 2.0F * theme.unit();
  const float width = std::min(widest, box.width() - 2.0F * margin);
  ImGui::SetCursorScreenPos({std::floor(box.centre().x - 0.5F * width), box.min.y + margin});
  ImGui::BeginChild("viewport-welcome", {width, std::max(box.height() - 1.5F * margin, 1.0F)}, false,
                    ImGuiWindowFlags_NoBackground);
  welcomeContent(context, pictures);
  ImGui::EndChild();
}

} // namespace stretch::ui
