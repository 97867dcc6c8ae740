// Keeps unsaved work aside as the editor does, again and again, until it is killed; or tells what was left:
//   keep-aside FILE          edits the file by turns and keeps each state aside, as fast as it can
//   keep-aside FILE found    how many states were left, and whether each can be taken up whole
#include <filesystem>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "app/edits/trail/trail_edits.h"
#include "app/file_work.h"
#include "app/files/save.h"

namespace {

using namespace stretch;

/// Somebody who edits without a window.
class Editing : public app::FileUser {
public:
  app::OpenDocument& open() override { return document_; }
  void tell(app::Tone tone, const std::string& text) override {
    if (tone == app::Tone::error || tone == app::Tone::warning) {
      fmt::print(stderr, "{}\n", text);
    }
  }
  void closing() override {}
  void opened() override {}
  void saved(const std::filesystem::path&) override {}
  void quit() override {}

private:
  app::OpenDocument document_;
};

Result<app::Document> withPunch(const app::Document& document, double scale) {
  app::NewTrail wanted{"left-arm", 0, {}, true, true};
  wanted.settings.startFrame = 21.0;
  wanted.settings.endFrame = 27.0;
  wanted.settings.scale = scale;
  Result<app::CreatedTrail> created = app::createTrail(document, wanted);
  return created ? Result<app::Document>(std::move(created->document)) : created.error();
}

int keepUntilKilled(const std::filesystem::path& file) {
  Editing user;
  app::FileWork work;
  work.openFile(user, {file});
  for (double seconds = 0.0; work.isOpening(); seconds += 10.0) {
    work.update(user, seconds);
  }
  if (user.open().character() == nullptr) {
    return 1;
  }
  app::Session& session = *user.open().character();
  const app::Document source = session.document();
  for (double seconds = 1e6;; seconds += 10.0) {
    const Result<app::Document> punch = withPunch(source, session.history().position() % 2 == 0 ? 2.0 : 3.0);
    if (!punch || !session.edit(*punch, "Punch")) {
      return 1;
    }
    work.update(user, seconds);
  }
}

int tellFound(const std::filesystem::path& file) {
  const Result<app::Document> source = app::openDocument(file);
  int found = 0;
  while (const auto kept = app::findAutosave({})) {
    const Result<app::Document> restored = app::withAutosave(*source, kept->file);
    if (!restored || restored->trails.size() != 1) {
      fmt::print("broken: {}\n", restored ? "not all of the work is there" : restored.error().line());
      return 1;
    }
    app::removeAutosave(kept->file);
    ++found;
  }
  fmt::print("{}\n", found);
  return 0;
}

} // namespace

int main(int argumentCount, char** arguments) {
  if (argumentCount < 2) {
    fmt::print(stderr, "usage: keep-aside FILE [found]\n");
    return 2;
  }
  return argumentCount > 2 ? tellFound(arguments[1]) : keepUntilKilled(arguments[1]);
}
