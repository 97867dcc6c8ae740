#include "ui/shell/clip_import.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "app/commands/keys/clips.h"
#include "app/files/file_facts.h"
#include "ui/panels/context/panel_support.h"

namespace stretch::ui {

namespace {

void tellImported(Shell& shell, const app::Document& document, const app::NewClips& brought) {
  const std::size_t count = brought.clips.size();
  const std::string name = document.clips->at(document.clips->size() - count).name;
  tell(shell, ToastKind::success,
       count > 1 ? fmt::format("{} clips imported", count)
       : brought.clips.front().isRetargeted
           ? fmt::format("{} is brought to this character", name)
           : fmt::format("{} is imported: its keys are as in its file", name));
  const std::vector<std::string> news = app::newsOf(brought);
  if (!news.empty()) {
    constexpr std::size_t mostTold = 2;
    const std::vector<std::string> first(
        news.begin(), news.begin() + static_cast<std::ptrdiff_t>(std::min(news.size(), mostTold)));
    const std::string more =
        news.size() > mostTold ? fmt::format(" (and {} more)", news.size() - mostTold) : std::string();
    tell(shell, ToastKind::warning, capitalised(fmt::format("{}{}", fmt::join(first, "; "), more)));
  }
}

void takeImported(Shell& shell, app::Session& session, const app::NewClips& brought) {
  std::vector<Clip> clips;
  for (const app::NewClip& clip : brought.clips) {
    clips.push_back(clip.clip);
  }
  Result<app::Document> changed = app::withNewClips(session.document(), clips);
  if (!changed) {
    tell(shell, ToastKind::error, changed.error().line());
    return;
  }
  const auto first = static_cast<int>(session.document().clips->size());
  session.edit(std::move(changed).value(), clips.size() == 1 ? "Import a clip" : "Import clips");
  app::showClip(session, first);
  shell.ui.time.timeline.viewEnd = TimelineState{}.viewEnd;
  shell.ui.time.timeline.viewStart = TimelineState{}.viewStart;
  tellImported(shell, session.document(), brought);
}

} // namespace

void askForClip(Shell& shell, const std::filesystem::path& file) {
  app::FileFacts facts = app::factsOf(file);
  if (facts.clips.size() > 1) {
    shell.ui.dialogs.clipPick = {};
    shell.ui.dialogs.clipPick.file = file;
    shell.ui.dialogs.clipPick.clips = std::move(facts.clips);
  } else {
    importClip(shell, {file, -1});
  }
}

void importClip(Shell& shell, const ClipAnswer& wanted) {
  ClipImport& import = shell.beside.clipImport;
  if (shell.open.character() == nullptr || import.job != nullptr) {
    tell(shell, ToastKind::info,
         import.job != nullptr ? "Another clip is being imported" : "Open a character first");
    return;
  }
  const app::Document& document = shell.open.character()->document();
  app::ClipRequest request{
      wanted.file, wanted.clip < 0 ? std::string() : fmt::format("#{}", wanted.clip), {}, shell.ui.imports};
  import.file = wanted.file;
  import.scene = document.scene;
  import.job = std::make_unique<app::Job<app::NewClips>>(
      [document, request](const skinning::Proceed& proceed) {
        return app::clipsFromFile(document, request, proceed);
});
} // namespace stretch::ui

void updateClipImport(Shell& shell) {
  ClipImport& import = shell.beside.clipImport;
  app::Session* const session = shell.open.character();
  const bool isDragging = (session != nullptr && session->isDragging()) || isRunning(shell.tool);
  if (import.job == nullptr || !import.job->isFinished() || isDragging) {
    return;
  }
  const bool isStopped = import.job->isCancelled();
  const Result<app::NewClips> brought = import.job->take();
  const ClipImport done = std::exchange(import, {});
  if (isStopped) {
    return;
  }
  if (!brought) {
    tell(shell, ToastKind::error, brought.error().line());
  } else if (session == nullptr || session->document().scene != done.scene) {
    tell(shell, ToastKind::info,
         done.file.filename().string() + " was for a character that is not open any more");
  } else {
    takeImported(shell, *session, *brought);
  }
}

} // namespace stretch::ui
