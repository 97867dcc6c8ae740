#include "ui/shell/questions.h"

#include <imgui.h>

#include "ui/panels/dialog_frame.h"
#include "ui/shell/file_work.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/layout.h"

namespace stretch::ui {

void drawOverwriteQuestion(Shell& shell, PanelContext& context) {
  const std::filesystem::path path = shell.files.changedSavePath;
  bool open = !path.empty();
  if (!beginDialog(
          context,
          {.id = "overwrite", .icon = icon::warning, .title = "Changed by another program", .width = 460.0F},
          open)) {
    return;
  }
  const WidgetContext widgets{context.theme, context.items};
  note(widgets, path.filename().string() + " is not as it was when it was opened or saved here. Overwriting "
                                           "it loses what the other program changed.");
  verticalSpace(widgets, 8.0F);
  const int clicked = dialogButtons(context, "overwrite",
                                    {{.id = "", .text = "Overwrite", .emphasis = Emphasis::danger},
                                     {.id = "", .text = "Cancel"},
                                     {.id = "", .text = "Save as"}});
  const bool answered = !open || clicked >= 0;
  if (answered) {
    ImGui::CloseCurrentPopup();
  }
  endDialog();
  if (!answered) {
    return;
  }
  shell.files.changedSavePath.clear();
  if (clicked == 0) {
    saveFileAs(shell, path, false);
  } else if (clicked == 2) {
    askForFile(shell, FilePurpose::saveModel);
  } else {
    shell.files.afterUnsaved = AfterUnsaved::nothing;
  }
}

} // namespace stretch::ui
