#include "ui/panels/files/file_facts_pane.h"

#include <algorithm>

#include "ui/panels/context/panel_support.h"
#include "ui/panels/files/file_listing.h"
#include "ui/widgets/layout.h"

namespace stretch::ui {

namespace {

/// "26 joints", "1 clip".
std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : what == "mesh" ? "es" : "s");
}

void clipLines(PanelContext& context, const app::FileFacts& facts) {
  constexpr std::size_t mostLines = 7;
  const WidgetContext widgets = widgetsOf(context);
  for (std::size_t i = 0; i < std::min(mostLines, facts.clips.size()); ++i) {
    const app::FileFacts::ClipFacts& clip = facts.clips[i];
    const std::string name = clip.name.empty() ? "clip " + std::to_string(i + 1) : clip.name;
    note(widgets, name + ", " + shortNumber(clip.seconds, 1) + " s");
  }
  if (facts.clips.size() > mostLines) {
    note(widgets, "and " + std::to_string(facts.clips.size() - mostLines) + " more");
  }
}

void sceneLines(PanelContext& context, const app::FileFacts& facts) {
  const WidgetContext widgets = widgetsOf(context);
  note(widgets, counted(static_cast<std::size_t>(facts.meshes), "mesh") + ", " +
                    (facts.joints > 0 ? counted(static_cast<std::size_t>(facts.joints), "joint")
                                      : std::string("no skin")));
  if (facts.carriesWork) {
    note(widgets, "With trails and settings of this program");
  }
  verticalSpace(widgets, 6.0F);
  note(widgets, facts.clips.empty() ? "No clip" : counted(facts.clips.size(), "clip") + ":");
  clipLines(context, facts);
}

} // namespace

void fileFacts(PanelContext& context, const std::filesystem::path& path) {
  FileDialogState& dialog = context.ui.dialogs.file;
  const WidgetContext widgets = widgetsOf(context);
  ImGui::BeginChild("files/facts", {0.0F, ImGui::GetContentRegionAvail().y - context.theme.px(80.0F)});
  if (path != dialog.factsPath) {
    dialog.factsPath = path;
    dialog.facts = path.empty() ? app::FileFacts{} : app::factsOf(path);
  }
  verticalSpace(widgets, 16.0F); // Apart from the button above.
  if (path.empty()) {
    note(widgets,
         "Click a file to see what it holds, double click it to open it. Typing jumps to a name, Backspace "
         "goes up a folder.");
  } else {
    drawText(widgets, context.theme.fonts.body,
             {ImGui::GetCursorScreenPos(),
              {ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x,
               ImGui::GetCursorScreenPos().y + context.theme.rowHeight()}},
             context.theme.colours.text, path.filename().string());
    verticalSpace(widgets, context.theme.rowHeight() / context.theme.scale);
    note(widgets, dialog.facts.kind.empty() ? "It is not there any more."
                                            : dialog.facts.kind + ", " + sizeText(dialog.facts.bytes));
    if (!dialog.facts.problem.empty()) {
      note(widgets, "It " + dialog.facts.problem + ".");
    } else if (dialog.facts.isScene) {
      sceneLines(context, dialog.facts);
    } else if (dialog.facts.kind.ends_with(" scene") || dialog.facts.kind.ends_with(" motion capture")) {
      note(widgets, "What it holds is read when it is taken.");
    } else if (dialog.facts.kind.ends_with(" mesh")) {
      note(widgets, "One of the frames: open the folder as a mesh sequence for all of them.");
    }
  }
  ImGui::EndChild();
}

} // namespace stretch::ui
