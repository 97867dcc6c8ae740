#include <algorithm>
#include <system_error>

#include "app/sequence/open_any.h"
#include "ui/panels/dialog_frame.h"
#include "ui/panels/file_listing.h"
#include "ui/widgets/dropdown.h"
#include "ui/widgets/fuzzy.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/layout.h"

namespace stretch::ui {

namespace {

namespace fs = std::filesystem;

void goTo(FileDialogState& dialog, const fs::path& folder) {
  dialog.folder = folder;
  dialog.highlighted = -1;
  dialog.message.clear();
  dialog.confirmOverwrite = false;
  if (!isSaving(dialog.purpose)) {
    dialog.typed.clear();
  }
}

void refresh(FileDialogState& dialog) {
  if (dialog.folder.empty()) {
    std::error_code ignored;
    dialog.folder = fs::current_path(ignored);
  }
  if (dialog.listedFolder == dialog.folder) {
    return;
  }
  Result<std::vector<FileEntry>> listed = listFolder(dialog.folder, dialog.purpose);
  dialog.message = listed ? std::string() : listed.error().line();
  dialog.entries = listed ? std::move(listed).value() : std::vector<FileEntry>();
  dialog.listedFolder = dialog.folder;
  dialog.listsSequence = dialog.purpose == FilePurpose::openModel && app::holdsSequence(dialog.folder);
}

/// Rows that answer what is typed: all of them while saving, or while a path is being typed.
std::vector<const FileEntry*> shownEntries(const FileDialogState& dialog) {
  const bool filters = !isSaving(dialog.purpose) && dialog.typed.find('/') == std::string::npos;
  std::vector<const FileEntry*> shown;
  for (const FileEntry& entry : dialog.entries) {
    if (!filters || fuzzyScore(dialog.typed, entry.name)) {
      shown.push_back(&entry);
    }
  }
  return shown;
}

void accept(PanelContext& context, const fs::path& path) {
  FileDialogState& dialog = context.ui.fileDialog;
  std::error_code ignored;
  if (isSaving(dialog.purpose) && fs::exists(path, ignored) && !dialog.confirmOverwrite &&
      dialog.purpose != FilePurpose::saveFrames) {
    dialog.confirmOverwrite = true;
    dialog.message = path.filename().string() + " exists. Press Replace to write over it.";
    return;
  }
  context.ui.answers.file = FileChoice{dialog.purpose, path};
  dialog.open = false;
  ImGui::CloseCurrentPopup();
}

void enter(PanelContext& context, const FileEntry& entry) {
  FileDialogState& dialog = context.ui.fileDialog;
  if (entry.isFolder) {
    goTo(dialog, dialog.folder / entry.name);
  } else if (isSaving(dialog.purpose)) {
    dialog.typed = entry.name;
  } else {
    accept(context, dialog.folder / entry.name);
  }
}

/// What Enter and the primary button do with the typed text.
void acceptTyped(PanelContext& context) {
  FileDialogState& dialog = context.ui.fileDialog;
  const fs::path path = typedPath(dialog.folder, dialog.typed);
  std::error_code ignored;
  if (fs::is_directory(path, ignored) &&
      (dialog.purpose != FilePurpose::saveFrames || path != dialog.folder)) {
    dialog.typed.clear();
    goTo(dialog, path);
  } else if (isSaving(dialog.purpose)) {
    if (dialog.typed.empty() && dialog.purpose != FilePurpose::saveFrames) {
      dialog.message = "Type a name for the file.";
    } else {
      accept(context, withExtension(path, dialog.purpose));
    }
  } else if (fs::is_regular_file(path, ignored)) {
    accept(context, path);
  } else {
    dialog.message = "There is no file called \"" + dialog.typed + "\" here.";
  }
}

void acceptHighlightedOrTyped(PanelContext& context) {
  const FileDialogState& dialog = context.ui.fileDialog;
  const std::vector<const FileEntry*> shown = shownEntries(dialog);
  const bool valid = dialog.highlighted >= 0 && dialog.highlighted < static_cast<int>(shown.size());
  if (valid) {
    enter(context, FileEntry(*shown[static_cast<std::size_t>(dialog.highlighted)]));
  } else if (!isSaving(dialog.purpose) && shown.size() == 1 && !dialog.typed.empty()) {
    enter(context, FileEntry(*shown.front()));
  } else {
    acceptTyped(context);
  }
}

/// A row with an icon, a name and a quiet detail at the right; true when clicked.
bool fileRow(PanelContext& context, const std::string& id, const char* iconText, const std::string& name,
             const std::string& detail, bool highlighted) {
  const Theme& theme = context.theme;
  const WidgetContext widgets = widgetsOf(context);
  const Control row = takePlace(widgets, id, {ImGui::GetContentRegionAvail().x, theme.rowHeight()});
  if (row.visible) {
    const ThemeColours& colours = theme.colours;
    if (highlighted || row.hovered) {
      ImGui::GetWindowDrawList()->AddRectFilled(
          row.box.min, row.box.max, highlighted ? colours.accentQuiet : colours.raised, theme.corner());
    }
    float left = row.box.min.x + theme.unit();
    if (theme.fonts.hasIcons) {
      drawText(widgets, theme.fonts.body, {{left, row.box.min.y}, {left + theme.px(20.0F), row.box.max.y}},
               colours.quietText, iconText);
      left += theme.px(26.0F);
    }
    const float detailWidth = detail.empty() ? 0.0F : theme.px(84.0F);
    drawText(widgets, theme.fonts.body,
             {{left, row.box.min.y}, {row.box.max.x - detailWidth - theme.unit(), row.box.max.y}},
             colours.text, name);
    drawText(widgets, theme.fonts.label,
             {{row.box.max.x - detailWidth, row.box.min.y}, {row.box.max.x - theme.unit(), row.box.max.y}},
             colours.quietText, detail, 1.0F);
  }
  tooltip(widgets, {name, "", {}});
  return row.clicked;
}

void places(PanelContext& context) {
  FileDialogState& dialog = context.ui.fileDialog;
  ImGui::BeginChild("files/places",
                    {context.theme.px(176.0F), ImGui::GetContentRegionAvail().y - context.theme.px(80.0F)});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, context.theme.px(1.0F)));
  if (fileRow(context, "files/home", icon::home, "Home", "", false)) {
    goTo(dialog, homeFolder());
  }
  if (dialog.purpose == FilePurpose::openModel && !context.ui.recentFiles.empty()) {
    verticalSpace(widgetsOf(context), 12.0F);
    note(widgetsOf(context), "Recent");
    const std::vector<fs::path> recent = context.ui.recentFiles;
    for (const fs::path& path : recent) {
      if (fileRow(context, "files/recent/" + path.string(), icon::file, path.filename().string(), "",
                  false)) {
        accept(context, path);
      }
    }
  }
  ImGui::PopStyleVar();
  ImGui::EndChild();
}

void entryList(PanelContext& context) {
  FileDialogState& dialog = context.ui.fileDialog;
  const std::vector<FileEntry> entries = [&] {
    std::vector<FileEntry> copies;
    for (const FileEntry* entry : shownEntries(dialog)) {
      copies.push_back(*entry);
    }
    return copies;
  }();
  ImGui::BeginChild("files/list", {0.0F, ImGui::GetContentRegionAvail().y - context.theme.px(80.0F)});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, context.theme.px(1.0F)));
  if (dialog.folder.has_parent_path() && dialog.folder != dialog.folder.root_path() &&
      fileRow(context, "files/up", icon::up, "Up one folder", "", false)) {
    goTo(dialog, dialog.folder.parent_path());
  }
  if (dialog.listsSequence &&
      fileRow(context, "files/as-sequence", icon::film, "Open this folder as a mesh sequence", "", false)) {
    accept(context, dialog.folder);
  }
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const FileEntry& entry = entries[i];
    const bool highlighted = static_cast<int>(i) == dialog.highlighted;
    if (fileRow(context, "files/entry/" + entry.name, entry.isFolder ? icon::folder : icon::cube, entry.name,
                entry.isFolder ? std::string() : sizeText(entry.bytes), highlighted)) {
      enter(context, entry);
    }
  }
  if (entries.empty() && dialog.message.empty()) {
    note(widgetsOf(context), dialog.typed.empty() || isSaving(dialog.purpose)
                                 ? "Nothing here that could be opened."
                                 : "Nothing here matches what you typed.");
  }
  ImGui::PopStyleVar();
  ImGui::EndChild();
}

void keyboard(PanelContext& context) {
  FileDialogState& dialog = context.ui.fileDialog;
  const int count = static_cast<int>(shownEntries(dialog).size());
  if (keyPressed(ImGuiKey_DownArrow, true) || keyPressed(ImGuiKey_UpArrow, true)) {
    moveHighlight(dialog.highlighted, count);
  }
  if (keyPressed(ImGuiKey_Enter) || keyPressed(ImGuiKey_KeyPadEnter)) {
    acceptHighlightedOrTyped(context);
  } else if (keyPressed(ImGuiKey_Backspace) && dialog.typed.empty() && dialog.folder.has_parent_path()) {
    goTo(dialog, dialog.folder.parent_path());
  }
}

void typedField(PanelContext& context, bool focus) {
  FileDialogState& dialog = context.ui.fileDialog;
  const char* hint = isSaving(dialog.purpose) ? "Name of the file" : "Type a name or a path";
  if (textField(widgetsOf(context), "files/typed", hint, dialog.typed, 0.0F, focus)) {
    dialog.highlighted = -1;
    dialog.confirmOverwrite = false;
    dialog.message.clear();
  }
}

} // namespace

void drawFileDialog(PanelContext& context) {
  FileDialogState& dialog = context.ui.fileDialog;
  if (dialog.open && !dialog.wasOpen) {
    dialog.listedFolder.clear();
    dialog.highlighted = -1;
    dialog.confirmOverwrite = false;
  }
  dialog.wasOpen = dialog.open;
  if (!beginDialog(context,
                   {.id = "files",
                    .icon = icon::folderOpen,
                    .title = titleOf(dialog.purpose),
                    .width = 760.0F,
                    .height = 520.0F},
                   dialog.open)) {
    return;
  }
  refresh(dialog);
  keyboard(context);
  note(widgetsOf(context), dialog.folder.string());
  places(context);
  ImGui::SameLine();
  entryList(context);
  typedField(context, ImGui::IsWindowAppearing());
  const char* accepts = dialog.confirmOverwrite ? "Replace" : isSaving(dialog.purpose) ? "Save" : "Open";
  if (!dialog.message.empty()) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float right = corner.x + ImGui::GetContentRegionAvail().x - context.theme.px(256.0F);
    drawText(widgetsOf(context), context.theme.fonts.label,
             {{corner.x, corner.y + context.theme.px(4.0F)}, {right, corner.y + context.theme.px(28.0F)}},
             context.theme.colours.warning, dialog.message);
  }
  const int clicked =
      dialogButtons(context, "files", {{.id = "", .text = "Cancel"}, {.id = "", .text = accepts}});
  if (clicked == 0) {
    dialog.open = false;
    ImGui::CloseCurrentPopup();
  } else if (clicked == 1) {
    acceptHighlightedOrTyped(context);
  }
  endDialog();
}

} // namespace stretch::ui
