#include <utility>
#include <vector>

#include <fmt/core.h>
#include <imgui_internal.h>

#include "app/commands/pose/hold.h"
#include "app/commands/table/selection.h"
#include "ui/panels/context/dialog_frame.h"
#include "ui/panels/context/panel_support.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/layout.h"

namespace stretch::ui {

namespace {

void paragraph(const std::string& text) {
  ImGui::PushTextWrapPos(0.0F);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
}

/// Goes from answer to answer by Tab and the arrows, round and round; from `entered` where the question is
/// new.
int focusOf(QuestionFocus& focus, const std::string& question, int count, int entered) {
  if (std::exchange(focus.question, question) != question) {
    focus.button = entered;
  }
  const int step = keyPressed(ImGuiKey_RightArrow) || keyPressed(ImGuiKey_Tab) ? 1
                   : keyPressed(ImGuiKey_LeftArrow)                            ? -1
                                                                               : 0;
  if (step != 0) {
    focus.button = focus.button < 0 ? (step > 0 ? 0 : count - 1) : (focus.button + step + count) % count;
  }
  return focus.button;
}

/// Ends a question's content with its answers. The one that was clicked, or that Enter stands for, which has
/// an edge; -1: none. `entered`: the one that Enter stands for at first.
int answerOf(PanelContext& context, const std::string& question, std::vector<ButtonSpec> buttons,
             int entered) {
  const int focused =
      focusOf(context.ui.dialogs.question, question, static_cast<int>(buttons.size()), entered);
  if (focused >= 0) {
    buttons[static_cast<std::size_t>(focused)].focused = true;
  }
  const int clicked = dialogButtons(context, question, buttons);
  return clicked < 0 && enterPressed() ? focused : clicked;
}

/// A question about files: what is said, and what each button answers.
struct AskedDialog {
  app::FileQuestion::Kind kind;
  DialogSpec dialog;
  std::string text;
  std::vector<ButtonSpec> buttons;
  std::vector<app::FileAnswer> answers; ///< One for each button.
  int entered = -1;                     ///< Button that Enter stands for; -1: none.
};

AskedDialog unexportedDialog() {
  return {app::FileQuestion::Kind::unsaved,
          {.id = "unsaved", .icon = icon::warning, .title = "Discard your changes?", .width = 440.0F},
          "There are changes to the sequence that were not exported. They are lost if you go on; to keep the "
          "result, cancel and export it.",
          {{.id = "", .text = "Discard", .emphasis = Emphasis::danger}, {.id = "", .text = "Cancel"}},
          {app::FileAnswer::discard, app::FileAnswer::cancel},
          1};
}

AskedDialog unsavedDialog(const app::OpenDocument& open) {
  if (open.sequence() != nullptr) {
    return unexportedDialog();
  }
  const app::Session* const session = open.character();
  std::string lost = "There are changes that are not saved. They are lost if you go on without saving.";
  if (session != nullptr && app::isPosedWithoutKey(session->view())) {
    lost +=
        fmt::format(" The pose at frame {:g} has no key: Save keys it, as S does.", session->view().frame);
  }
  return {app::FileQuestion::Kind::unsaved,
          {.id = "unsaved", .icon = icon::warning, .title = "Save your changes?", .width = 440.0F},
          lost,
          {{.id = "", .text = "Don't save", .emphasis = Emphasis::danger},
           {.id = "", .text = "Cancel"},
           {.id = "", .text = "Save"}},
          {app::FileAnswer::discard, app::FileAnswer::cancel, app::FileAnswer::save},
          2};
}

AskedDialog overwriteDialog(const std::filesystem::path& file) {
  return {app::FileQuestion::Kind::overwrite,
          {.id = "overwrite", .icon = icon::warning, .title = "Changed by another program", .width = 460.0F},
          file.filename().string() + " is not as it was when it was opened or saved here. Overwriting it "
                                     "loses what the other program changed.",
          {{.id = "", .text = "Overwrite", .emphasis = Emphasis::danger},
           {.id = "", .text = "Cancel"},
           {.id = "", .text = "Save as"}},
          {app::FileAnswer::overwrite, app::FileAnswer::cancel, app::FileAnswer::otherName}};
}

AskedDialog restoreDialog(const std::filesystem::path& file) {
  return {app::FileQuestion::Kind::restore,
          {.id = "restore",
           .icon = icon::clock,
           .title = "Restore your work?",
           .width = 460.0F,
           .closable = false},
          "The program ended before the last changes to " + file.string() +
              " were saved. They were kept to the side.",
          {{.id = "", .text = "Discard", .emphasis = Emphasis::danger}, {.id = "", .text = "Restore"}},
          {app::FileAnswer::discard, app::FileAnswer::restore},
          1};
}

void drawAsked(PanelContext& context, const AskedDialog& asked) {
  bool open = context.status.question.kind == asked.kind;
  if (!beginDialog(context, asked.dialog, open)) {
    return;
  }
  paragraph(asked.text);
  const int answer = answerOf(context, asked.dialog.id, asked.buttons, asked.entered);
  if (answer >= 0) {
    context.ui.answers.question = asked.answers[static_cast<std::size_t>(answer)];
    ImGui::CloseCurrentPopup();
  } else if (!open) {
    context.ui.answers.question = app::FileAnswer::cancel; // closed by Esc or the cross
  }
  endDialog();
}

std::string framesText(const Vec2& range) {
  return shortNumber(range.x, 1) + " to " + shortNumber(range.y, 1);
}

/// The range that was set shares time with a trail: is that one meant, or another one beside it?
void drawClash(PanelContext& context) {
  UiState& ui = context.ui;
  bool open = ui.dialogs.rangeClash.has_value() && context.open.character() != nullptr;
  if (!beginDialog(context, {.id = "clash", .icon = icon::bolt, .title = "Which trail?", .width = 500.0F},
                   open)) {
    return;
  }
  if (ui.dialogs.rangeClash) {
    const app::RangeClash clash = *ui.dialogs.rangeClash;
    const std::string limb = limbHeading(context.open.character()->document(), clash.limb);
    paragraph(limb + " has a trail from frame " + framesText(clash.present) + ". The range that is set is " +
              framesText(clash.wanted) + ".");
    std::vector<ButtonSpec> buttons{{.id = "", .text = "Cancel"}};
    if (clash.beside) {
      paragraph("Another one would take frame " + framesText(*clash.beside) + ".");
      buttons.push_back({.id = "", .text = "Another"});
    }
    buttons.push_back({.id = "", .text = "Edit"});
    const int last = static_cast<int>(buttons.size()) - 1;
    const int clicked = answerOf(context, "clash", buttons, last);
    if (clicked > 0) {
      ui.answers.overlap = clicked == last ? app::OverlapChoice::edit : app::OverlapChoice::beside;
    }
    open = open && clicked < 0;
  }
  if (!open) {
    ui.dialogs.rangeClash.reset();
    ImGui::CloseCurrentPopup();
  }
  endDialog();
}

/// "the left arm and right arm": whose hands take what is added.
std::string takingArms(const app::Session& session) {
  std::vector<std::string> arms;
  for (const std::string& hand : app::handsForProp(session)) {
    arms.push_back(app::limbTitle(session.document(), hand));
  }
  return "the " + app::listed(arms);
}

/// What may become of a dropped file, and what says so; the last is what Enter takes.
struct DropChoice {
  const char* text = "";
  std::optional<FilePurpose> purpose; ///< None: nothing.
};

std::vector<DropChoice> dropChoices(const DroppedFile& dropped) {
  std::vector<DropChoice> choices{{"Open", FilePurpose::openModel}, {"Cancel", std::nullopt}};
  if (dropped.hasClips) {
    choices.push_back({"Import", FilePurpose::openClip});
  }
  if (dropped.canBeHeld) {
    choices.push_back({"Hold", FilePurpose::openProp});
  }
  return choices;
}

std::string dropText(const PanelContext& context, const DroppedFile& dropped) {
  const std::string held = dropped.canBeHeld ? " can be held by " + takingArms(*context.open.character()) +
                                                   " and saved with the character,"
                                             : std::string();
  const std::string imported = dropped.hasClips ? std::string(held.empty() ? "" : " or") +
                                                      " has clips that can be imported to the character,"
                                                : std::string();
  return dropped.path.filename().string() + held + imported + " or opened in the character's place.";
}

/// A file that a hand could hold, or that has clips, was dropped on the open character: taken, or opened in
/// its place?
void drawDropQuestion(PanelContext& context) {
  UiState& ui = context.ui;
  bool open = !ui.dialogs.dropped.path.empty() && context.open.character() != nullptr;
  const char* const title = !ui.dialogs.dropped.hasClips   ? "Hold or open?"
                            : ui.dialogs.dropped.canBeHeld ? "Hold, import or open?"
                                                           : "Import or open?";
  if (!beginDialog(context, {.id = "drop", .icon = icon::cube, .title = title, .width = 500.0F}, open)) {
    return;
  }
  paragraph(dropText(context, ui.dialogs.dropped));
  const std::vector<DropChoice> choices = dropChoices(ui.dialogs.dropped);
  std::vector<ButtonSpec> buttons;
  buttons.reserve(choices.size());
  for (const DropChoice& choice : choices) {
    buttons.push_back({.id = "", .text = choice.text});
  }
  const int clicked = answerOf(context, "drop", buttons, static_cast<int>(choices.size()) - 1);
  if (clicked >= 0 && choices[static_cast<std::size_t>(clicked)].purpose) {
    ui.answers.drop =
        DropAnswer{ui.dialogs.dropped.path, *choices[static_cast<std::size_t>(clicked)].purpose};
  }
  if (!open || clicked >= 0) {
    ui.dialogs.dropped = {};
    ImGui::CloseCurrentPopup();
  }
  endDialog();
}

/// A large button with a title and what it means; true when it was clicked.
bool card(PanelContext& context, const std::string& id, const std::string& title,
          const std::vector<std::string>& lines, float width, bool focused) {
  const Theme& theme = context.theme;
  const WidgetContext widgets = widgetsOf(context);
  const float line = theme.px(20.0F);
  const float height = theme.px(52.0F) + line * static_cast<float>(lines.size());
  const Control place = takePlace(widgets, id, {width, height});
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(place.box.min, place.box.max,
                      place.hovered ? theme.colours.hovered : theme.colours.raised, theme.px(6.0F));
  list->AddRect(place.box.min, place.box.max,
                place.hovered || focused ? theme.colours.accent : theme.colours.border, theme.px(6.0F), 0,
                theme.px(focused ? 2.0F : 1.0F));
  float y = place.box.min.y + theme.px(12.0F);
  const float left = place.box.min.x + theme.px(14.0F);
  drawText(widgets, theme.fonts.strong, {{left, y}, {place.box.max.x, y + theme.px(22.0F)}},
           theme.colours.text, title);
  y += theme.px(28.0F);
  for (const std::string& text : lines) {
    drawText(widgets, theme.fonts.label, {{left, y}, {place.box.max.x, y + line}}, theme.colours.quietText,
             text);
    y += line;
  }
  tooltip(widgets, {title, "It can be changed in the settings.", {}});
  return place.clicked;
}

void drawNavigationQuestion(PanelContext& context) {
  UiState& ui = context.ui;
  if (!beginDialog(context,
                   {.id = "navigation",
                    .icon = icon::person,
                    .title = "Welcome to Stretch-Engine",
                    .width = 560.0F,
                    .closable = false},
                   ui.dialogs.navigationChoiceOpen)) {
    return;
  }
  paragraph("How does your hand turn the view?");
  verticalSpace(widgetsOf(context), 8.0F);
  const float width = columnWidth(2);
  const int focused = focusOf(ui.dialogs.question, "navigation", 2, 0);
  const bool maya =
      card(context, "navigation/maya", "As in Maya",
           {"Alt + left: orbit", "Alt + middle: pan", "Alt + right, wheel: zoom"}, width, focused == 0);
  ImGui::SameLine();
  const bool blender = card(context, "navigation/blender", "As in Blender",
                            {"Middle: orbit", "Shift + middle: pan", "Wheel: zoom"}, width, focused == 1);
  verticalSpace(widgetsOf(context), 8.0F);
  note(widgetsOf(context), "Tab goes to the other, Enter takes it. Settings change it at any time.");
  const bool entered = enterPressed();
  if (maya || blender || entered || keyPressed(ImGuiKey_Escape)) {
    const bool asBlender = blender || (entered && focused == 1);
    ui.navigation = asBlender ? NavigationStyle::blender : NavigationStyle::maya;
    ui.answers.navigation = ui.navigation;
    ui.dialogs.navigationChoiceOpen = false;
    ImGui::CloseCurrentPopup();
  }
  endDialog();
}

/// A video is still being drawn: is it given up?
void drawFilmQuestion(PanelContext& context) {
  UiState& ui = context.ui;
  bool open = !ui.dialogs.lostFilm.empty();
  if (!beginDialog(context,
                   {.id = "film", .icon = icon::film, .title = "Quit while drawing?", .width = 440.0F},
                   open)) {
    return;
  }
  paragraph(ui.dialogs.lostFilm + " is still being drawn. Nothing of it is kept if you quit now.");
  const int answer =
      answerOf(context, "film",
               {{.id = "", .text = "Quit", .emphasis = Emphasis::danger}, {.id = "", .text = "Go on"}}, 1);
  ui.answers.quitWithoutFilm = answer == 0;
  if (!open || answer >= 0) {
    ui.dialogs.lostFilm.clear();
    ImGui::CloseCurrentPopup();
  }
  endDialog();
}

void drawAbout(PanelContext& context) {
  UiState& ui = context.ui;
  if (!beginDialog(context, {.id = "about", .icon = icon::info, .title = "Stretch-Engine", .width = 480.0F},
                   ui.dialogs.aboutOpen)) {
    return;
  }
  paragraph("Exaggerates the motion of a rigged biped: pick a limb, make its path bigger, and the limb "
            "squashes and stretches to follow, as in the cartoons of the 1940s.");
  verticalSpace(widgetsOf(context), 8.0F);
  note(widgetsOf(context), "Opens and saves glTF 2.0 (.glb, .gltf, .vrm). What it does not edit comes back "
                           "as it was. FBX, BVH and Collada open as a new glTF.");
  if (dialogButtons(context, "about", {{.id = "", .text = "Close"}}) == 0) {
    ui.dialogs.aboutOpen = false;
    ImGui::CloseCurrentPopup();
  }
  endDialog();
}

} // namespace

void drawQuestions(PanelContext& context) {
  if (ImGui::GetTopMostPopupModal() == nullptr) {
    context.ui.dialogs.question = {};
  }
  const std::filesystem::path& file = context.status.question.about;
  drawAsked(context, unsavedDialog(context.open));
  drawAsked(context, overwriteDialog(file));
  drawAsked(context, restoreDialog(file));
  drawClash(context);
  drawDropQuestion(context);
  drawNavigationQuestion(context);
  drawFilmQuestion(context);
  drawAbout(context);
}

} // namespace stretch::ui
