#include <algorithm>
#include <cctype>
#include <system_error>

#include "app/sequence/open_any.h"
#include "ui/panels/context/dialog_frame.h"
#include "ui/panels/context/setting_rows.h"
#include "ui/panels/context/view_schema.h"
#include "ui/panels/files/file_facts_pane.h"
#include "ui/panels/files/file_listing.h"
#include "ui/widgets/button.h"
#include "ui/widgets/dropdown.h"
#include "ui/widgets/fuzzy.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/layout.h"

namespace stretch::ui {

namespace {

namespace fs = std::filesystem;

constexpr float factsWidth = 228.0F;

/// What is typed names a place, not a row.
bool isPathTyped(const FileDialogState& dialog) {
  return dialog.typed.find('/') != std::string::npos;
}

/// Without regard to case.
bool beginsWith(const std::string& name, const std::string& start) {
  const auto same = [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); };
  return name.size() >= start.size() && std::equal(start.begin(), start.end(), name.begin(), same);
}

void goTo(FileDialogState& dialog, const fs::path& folder) {
  dialog.folder = folder;
  dialog.highlighted = -1;
  dialog.message.clear();
  dialog.confirmOverwrite = false;
  dialog.newFolder.reset();
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
  const bool filters = !isSaving(dialog.purpose) && !isPathTyped(dialog);
  const std::vector<FileType> types = fileTypesOf(dialog.purpose);
  const auto isType = [&](const FileEntry& entry) {
    return entry.isFolder || types.empty() ||
           hasExtension(entry.name, types[static_cast<std::size_t>(dialog.type)].extensions);
  };
  std::vector<const FileEntry*> shown;
  for (const FileEntry& entry : dialog.entries) {
    if (isType(entry) && (!filters || fuzzyScore(dialog.typed, entry.name))) {
      shown.push_back(&entry);
    }
  }
  return shown;
}

void accept(PanelContext& context, const fs::path& path) {
  FileDialogState& dialog = context.ui.dialogs.file;
  std::error_code ignored;
  if (isSaving(dialog.purpose) && fs::exists(path, ignored) && !dialog.confirmOverwrite) {
    dialog.confirmOverwrite = true;
    dialog.message = path.filename().string() + " exists. Press Replace to write over it.";
    return;
  }
  context.ui.answers.file = FileChoice{dialog.purpose, path};
  dialog.open = false;
  ImGui::CloseCurrentPopup();
}

/// What is typed jumps to the first row that begins with it, else to the first that fits.
void jumpToTyped(FileDialogState& dialog) {
  dialog.highlighted = -1;
  dialog.confirmOverwrite = false;
  dialog.message.clear();
  if (isSaving(dialog.purpose) || dialog.typed.empty() || isPathTyped(dialog)) {
    return;
  }
  const std::vector<const FileEntry*> shown = shownEntries(dialog);
  const auto first = std::find_if(shown.begin(), shown.end(), [&](const FileEntry* entry) {
    return beginsWith(entry->name, dialog.typed);
  });
  dialog.highlighted = shown.empty()          ? -1
                       : first == shown.end() ? 0
                                              : static_cast<int>(first - shown.begin());
}

/// Makes the folder whose name was typed, and goes there.
void makeFolder(FileDialogState& dialog) {
  const std::string name = *dialog.newFolder;
  const fs::path path = typedPath(dialog.folder, name);
  std::error_code problem;
  if (name.empty()) {
    dialog.message = "Type a name for the folder.";
  } else if (fs::create_directories(path, problem)) {
    goTo(dialog, path);
  } else {
    dialog.message =
        problem ? "The folder cannot be made: " + problem.message() : "There is one of this name already.";
  }
}

/// What Enter and the primary button do with the typed text.
void acceptTyped(PanelContext& context) {
  FileDialogState& dialog = context.ui.dialogs.file;
  const bool isNamed = !dialog.typed.empty(); // Else the path is that of the folder which is shown.
  const fs::path path = typedPath(dialog.folder, dialog.typed);
  std::error_code ignored;
  if (isNamed && fs::is_directory(path, ignored)) {
    dialog.typed.clear();
    goTo(dialog, path);
  } else if (isSaving(dialog.purpose) && isNamed) {
    accept(context, withExtension(path, dialog.purpose));
  } else if (!isNamed) {
    dialog.message = isSaving(dialog.purpose) ? "Type a name for the file." : "";
  } else if (fs::is_regular_file(path, ignored)) {
    accept(context, path);
  } else {
    dialog.message = "There is no file called \"" + dialog.typed + "\" here.";
  }
}

void enter(PanelContext& context, const FileEntry& entry) {
  FileDialogState& dialog = context.ui.dialogs.file;
  if (entry.isFolder) {
    goTo(dialog, dialog.folder / entry.name);
  } else if (isSaving(dialog.purpose)) {
    dialog.typed = entry.name;
    acceptTyped(context);
  } else {
    accept(context, dialog.folder / entry.name);
  }
}

/// The file that the keys are on; empty for none and for a folder.
fs::path highlightedPath(const FileDialogState& dialog) {
  const std::vector<const FileEntry*> shown = shownEntries(dialog);
  const bool valid = dialog.highlighted >= 0 && dialog.highlighted < static_cast<int>(shown.size());
  const FileEntry* const entry = valid ? shown[static_cast<std::size_t>(dialog.highlighted)] : nullptr;
  return entry == nullptr || entry->isFolder ? fs::path() : dialog.folder / entry->name;
}

void acceptHighlightedOrTyped(PanelContext& context) {
  const FileDialogState& dialog = context.ui.dialogs.file;
  const std::vector<const FileEntry*> shown = shownEntries(dialog);
  const bool valid = dialog.highlighted >= 0 && dialog.highlighted < static_cast<int>(shown.size());
  if (valid) {
    enter(context, FileEntry(*shown[static_cast<std::size_t>(dialog.highlighted)]));
  } else if (!isSaving(dialog.purpose) && shown.size() == 1 && !dialog.typed.empty() &&
             !isPathTyped(dialog)) {
    enter(context, FileEntry(*shown.front()));
  } else {
    acceptTyped(context);
  }
}

/// A row with an icon, a name and a quiet detail at the right; true when clicked.
bool fileRow(PanelContext& context, const std::string& id, const char* iconText, const std::string& name,
             const std::string& detail, bool highlighted, const std::string& help = {}) {
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
  tooltip(widgets, {name, help, {}});
  return row.clicked;
}

struct Place {
  std::string id;
  const char* icon;
  std::string title;
  fs::path path;
};

/// Where people keep things: those that there are.
std::vector<Place> placesOf(const PanelContext& context) {
  std::vector<Place> places{{"home", icon::home, "Home", homeFolder()}};
  std::error_code ignored;
  if (const fs::path desktop = homeFolder() / "Desktop"; fs::is_directory(desktop, ignored)) {
    places.push_back({"desktop", icon::columns, "Desktop", desktop});
  }
  const app::Session* const character = context.open.character();
  if (character != nullptr && character->document().source->path.has_parent_path()) {
    places.push_back(
        {"project", icon::cube, "Folder of this file",
         fs::absolute(character->document().source->path, ignored).parent_path().lexically_normal()});
  }
  places.push_back({"computer", icon::grid, "Computer", homeFolder().root_path()});
  return places;
}

void places(PanelContext& context) {
  FileDialogState& dialog = context.ui.dialogs.file;
  ImGui::BeginChild("files/places",
                    {context.theme.px(176.0F), ImGui::GetContentRegionAvail().y - context.theme.px(80.0F)});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, context.theme.px(1.0F)));
  for (const Place& place : placesOf(context)) {
    if (fileRow(context, "files/" + place.id, place.icon, place.title, "", false, place.path.string())) {
      goTo(dialog, place.path);
    }
  }
  const std::vector<fs::path> folders = recentFolders(context.ui.recentFiles, 4);
  if (!folders.empty()) {
    verticalSpace(widgetsOf(context), 8.0F);
    note(widgetsOf(context), "Recent folders");
  }
  for (std::size_t i = 0; i < folders.size(); ++i) {
    if (fileRow(context, "files/recent-folder-" + std::to_string(i), icon::folder,
                folders[i].filename().empty() ? folders[i].string() : folders[i].filename().string(), "",
                false, folders[i].string())) {
      goTo(dialog, folders[i]);
    }
  }
  if (dialog.purpose == FilePurpose::openModel && !context.ui.recentFiles.empty()) {
    verticalSpace(widgetsOf(context), 8.0F);
    note(widgetsOf(context), "Recent files");
    const std::vector<fs::path> recent = context.ui.recentFiles;
    for (const fs::path& path : recent) {
      if (fileRow(context, "files/recent/" + path.string(), icon::file, path.filename().string(), "", false,
                  path.parent_path().string())) {
        accept(context, path);
      }
    }
  }
  ImGui::PopStyleVar();
  ImGui::EndChild();
}

/// A click chooses the row and tells of it; a double click opens it.
void clickEntry(PanelContext& context, const FileEntry& entry, int row) {
  FileDialogState& dialog = context.ui.dialogs.file;
  const bool again = dialog.highlighted == row && ImGui::GetIO().MouseClickedLastCount[0] >= 2;
  dialog.highlighted = row;
  dialog.confirmOverwrite = false;
  dialog.message.clear();
  if (again) {
    enter(context, entry);
  } else if (isSaving(dialog.purpose) && !entry.isFolder) {
    dialog.typed = entry.name;
  } else if (!isSaving(dialog.purpose) && isPathTyped(dialog)) {
    dialog.typed.clear();
  }
}

/// The field in which a new folder gets its name.
void newFolderRow(PanelContext& context) {
  FileDialogState& dialog = context.ui.dialogs.file;
  if (!dialog.newFolder) {
    return;
  }
  const float width = context.theme.px(88.0F);
  const bool again = dialog.newFolder->empty() || !dialog.message.empty(); // Refused: it is typed anew.
  if (textField(widgetsOf(context), "files/new-folder-name", "Name of the new folder", *dialog.newFolder,
                ImGui::GetContentRegionAvail().x - width - context.theme.unit(), again)) {
    dialog.message.clear();
  }
  ImGui::SameLine();
  ButtonSpec make{.id = "files/make-folder", .icon = "", .text = "Make"};
  make.width = width;
  make.help = {"Make the folder", "Enter does it as well.", {}};
  if (button(widgetsOf(context), make)) {
    makeFolder(dialog);
  }
}

void entryList(PanelContext& context) {
  FileDialogState& dialog = context.ui.dialogs.file;
  const std::vector<FileEntry> entries = [&] {
    std::vector<FileEntry> copies;
    for (const FileEntry* entry : shownEntries(dialog)) {
      copies.push_back(*entry);
    }
    return copies;
  }();
  const float facts = isSaving(dialog.purpose) ? 0.0F : context.theme.px(factsWidth);
  ImGui::BeginChild("files/list", {ImGui::GetContentRegionAvail().x - facts,
                                   ImGui::GetContentRegionAvail().y - context.theme.px(80.0F)});
  newFolderRow(context);
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
      clickEntry(context, entry, static_cast<int>(i));
    }
  }
  if (entries.empty() && dialog.message.empty()) {
    note(widgetsOf(context), isSaving(dialog.purpose) ? "No files of this kind are here yet."
                             : dialog.typed.empty()   ? "Nothing here that could be opened."
                                                      : "Nothing here matches what you typed.");
  }
  ImGui::PopStyleVar();
  ImGui::EndChild();
}

/// Characters that no text field takes are typed all the same.
void typeAhead(FileDialogState& dialog) {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.WantTextInput || isSaving(dialog.purpose)) {
    return;
  }
  const std::size_t before = dialog.typed.size();
  if (keyPressed(ImGuiKey_Backspace) && !dialog.typed.empty()) {
    dialog.typed.pop_back();
    jumpToTyped(dialog);
    return;
  }
  for (const ImWchar c : io.InputQueueCharacters) {
    if (c >= ' ' && c < 127) {
      dialog.typed.push_back(static_cast<char>(c));
    }
  }
  if (dialog.typed.size() != before) {
    jumpToTyped(dialog);
  }
}

void keyboard(PanelContext& context) {
  FileDialogState& dialog = context.ui.dialogs.file;
  if (dialog.newFolder) {
    if (enterPressed()) {
      makeFolder(dialog);
    }
    return;
  }
  if (keyPressed(ImGuiKey_Backspace) && dialog.typed.empty() && dialog.folder.has_parent_path()) {
    goTo(dialog, dialog.folder.parent_path());
    return;
  }
  typeAhead(dialog);
  const int count = static_cast<int>(shownEntries(dialog).size());
  if (keyPressed(ImGuiKey_DownArrow, true) || keyPressed(ImGuiKey_UpArrow, true)) {
    moveHighlight(dialog.highlighted, count);
  }
  if (enterPressed()) {
    acceptHighlightedOrTyped(context);
  }
}

void typedField(PanelContext& context, bool focus) {
  FileDialogState& dialog = context.ui.dialogs.file;
  const char* hint = isSaving(dialog.purpose) ? "Name of the file" : "Type a name or a path";
  const bool proposes = isSaving(dialog.purpose);
  if (editText(widgetsOf(context), "files/typed", hint, dialog.typed, 0.0F, focus, proposes).changed) {
    jumpToTyped(dialog);
  }
}

/// Which kinds of files are listed, and the button for a new folder.
void typesRow(PanelContext& context) {
  FileDialogState& dialog = context.ui.dialogs.file;
  const float side = context.theme.px(116.0F);
  const std::vector<FileType> types = fileTypesOf(dialog.purpose);
  if (!types.empty()) {
    std::vector<Choice> choices;
    for (const FileType& type : types) {
      std::string extensions;
      for (const std::string& extension : type.extensions) {
        extensions += (extensions.empty() ? "" : " ") + extension;
      }
      choices.push_back({type.title, {type.title, "Lists " + extensions + ".", {}}});
    }
    ImGui::BeginChild("files/types", {ImGui::GetContentRegionAvail().x - side - context.theme.unit(),
                                      context.theme.rowHeight()});
    const int chosen = segmented(widgetsOf(context), "files/type", choices, dialog.type);
    ImGui::EndChild();
    dialog.highlighted = chosen >= 0 && chosen != dialog.type ? -1 : dialog.highlighted;
    dialog.type = chosen >= 0 ? chosen : dialog.type;
    ImGui::SameLine();
  } else if (dialog.purpose == FilePurpose::saveModel || dialog.purpose == FilePurpose::exportClean) {
    ImGui::BeginChild("files/form", {ImGui::GetContentRegionAvail().x - side - context.theme.unit(),
                                     context.theme.rowHeight()});
    viewRow(context, "files/", *app::findSetting(windowSchema(), "form"), context.ui);
    ImGui::EndChild();
    ImGui::SameLine();
  }
  ButtonSpec make{.id = "files/new-folder", .icon = icon::plus, .text = "New folder"};
  make.width = side;
  make.help = {"New folder", "Makes a folder in the one that is shown.", {}};
  if (button(widgetsOf(context), make)) {
    dialog.newFolder = std::string();
  }
}

} // namespace

void drawFileDialog(PanelContext& context) {
  FileDialogState& dialog = context.ui.dialogs.file;
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
                    .width = isSaving(dialog.purpose) ? 760.0F : 900.0F,
                    .height = 520.0F},
                   dialog.open)) {
    return;
  }
  refresh(dialog);
  keyboard(context);
  note(widgetsOf(context), dialog.folder.string());
  typesRow(context);
  places(context);
  ImGui::SameLine();
  entryList(context);
  if (!isSaving(dialog.purpose)) {
    ImGui::SameLine();
    fileFacts(context, highlightedPath(dialog));
  }
  typedField(context, ImGui::IsWindowAppearing());
  const char* accepts = dialog.confirmOverwrite ? "Replace" : isSaving(dialog.purpose) ? "Save" : "Open";
  if (const std::string& told = dialog.message.empty() ? dialog.remark : dialog.message; !told.empty()) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float right = corner.x + ImGui::GetContentRegionAvail().x - context.theme.px(256.0F);
    drawText(widgetsOf(context), context.theme.fonts.label,
             {{corner.x, corner.y + context.theme.px(4.0F)}, {right, corner.y + context.theme.px(28.0F)}},
             dialog.message.empty() ? context.theme.colours.quietText : context.theme.colours.warning, told);
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
