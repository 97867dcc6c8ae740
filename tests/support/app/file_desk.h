#pragma once

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "app/edits/trail/trail_edits.h"
#include "app/file_work.h"
#include "tests/support/temporary_folder.h"

namespace stretch::test {

/// A user without a window, with a folder for files and settings.
class Desk : public app::FileUser {
public:
  Desk() : folder(std::make_shared<const TemporaryFolder>()) {
    setenv("XDG_STATE_HOME", (folder->path() / "state").c_str(), 1);
    std::filesystem::copy_file(STRETCH_SOURCE_DIR "/assets/dummy.glb", file("a.glb"));
    std::filesystem::copy_file(STRETCH_SOURCE_DIR "/assets/dummy.glb", file("b.glb"));
  }
  /// Another user at the same files.
  explicit Desk(std::shared_ptr<const TemporaryFolder> shared) : folder(std::move(shared)) {}

  app::OpenDocument& open() override { return document; }
  void tell(app::Tone tone, const std::string& text) override { told.emplace_back(tone, text); }
  void closing() override { happened += "closing "; }
  void opened() override { happened += "opened "; }
  void saved(const std::filesystem::path& path) override {
    happened += "saved:" + path.filename().string() + " ";
  }
  void quit() override { happened += "quit "; }

  [[nodiscard]] std::filesystem::path file(const std::string& name) const { return folder->path() / name; }
  /// What happened since the last time.
  std::string news() { return std::exchange(happened, {}); }
  [[nodiscard]] app::Tone lastTone() const { return told.empty() ? app::Tone::info : told.back().first; }

  void waitWhileOpening(app::FileWork& work) {
    for (int i = 0; i < 60000 && work.isOpening() && work.question().kind == app::FileQuestion::Kind::none;
         ++i) {
      work.update(*this, clock);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  void openNow(app::FileWork& work, const std::string& name) {
    work.openFile(*this, {file(name)});
    waitWhileOpening(work);
  }
  /// Changes the open character; each call another change.
  void edit() {
    app::Session& session = *document.character();
    const bool loops = !session.document().loopingClips.empty();
    REQUIRE(session.edit(app::setLooping(session.document(), 0, !loops), "Loop"));
  }
  [[nodiscard]] bool isEdited() const { return !document.character()->document().loopingClips.empty(); }

  std::shared_ptr<const TemporaryFolder> folder;
  app::OpenDocument document;
  std::vector<std::pair<app::Tone, std::string>> told;
  std::string happened;
  double clock = 0.0;
};

} // namespace stretch::test
