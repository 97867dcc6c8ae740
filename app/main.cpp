#include <algorithm>
#include <csignal>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include "app/batch/verb.h"
#include "app/build_name.h"
#include "core/base/number.h"
#include "core/interchange/reader_process.h"
#include "skinning/sequence/mesh_file.h"
#include "ui/batch/render_verb.h"
#include "ui/shell/editor.h"

namespace {

using stretch::app::Verb;

/// What the editor is started with: `[--ui-scale FACTOR] [PATH [PATH]]`.
struct EditorStart {
  std::vector<std::filesystem::path> files;
  stretch::ui::EditorOptions options;
};

/// The two paths of a sequence: a base mesh and its cache, in any order.
bool isMeshAndCache(const std::vector<std::string_view>& words) {
  using namespace stretch::skinning;
  return (isBaseMesh(words[0]) && isPointCache(words[1])) || (isPointCache(words[0]) && isBaseMesh(words[1]));
}

/// Everything that is no verb and no other option starts the editor.
bool startsEditor(const std::vector<Verb>& verbs, const std::vector<std::string_view>& words) {
  if (words.empty() || words.front() == "--ui-scale") {
    return true;
  }
  const bool verb =
      std::any_of(verbs.begin(), verbs.end(), [&](const Verb& known) { return known.name == words.front(); });
  // A word without an ending that no file has is a verb gone wrong.
  std::error_code ignored;
  const std::filesystem::path path(words.front());
  const bool isPath =
      path.has_extension() || path.has_parent_path() || std::filesystem::exists(path, ignored);
  const bool fewEnough = words.size() == 1 || (words.size() == 2 && isMeshAndCache(words));
  return !verb && isPath && words.front().substr(0, 1) != "-" && fewEnough;
}

EditorStart editorStart(const std::vector<std::string_view>& words) {
  EditorStart start;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == "--ui-scale" && i + 1 < words.size()) {
      start.options.scale = stretch::parseNumber<float>(words[++i]).value_or(0.0F);
    } else {
      start.files.emplace_back(words[i]);
    }
  }
  return start;
}

// Files that are opened later never stand where a closed standard stream was.
void openStandardStreams() {
  for (int descriptor = STDIN_FILENO; descriptor <= STDERR_FILENO; ++descriptor) {
    if (fcntl(descriptor, F_GETFD) < 0) {
      // Output that is closed cannot be written to, and is told so.
      static_cast<void>(open("/dev/null", descriptor == STDERR_FILENO ? O_WRONLY : O_RDONLY));
    }
  }
}

} // namespace

int main(int argumentCount, char** arguments) {
  openStandardStreams();
  if (const std::optional<int> status = stretch::interchange::runAsReader(argumentCount, arguments)) {
    return *status;
  }
  std::signal(SIGXFSZ, SIG_IGN); // A limit on the size of files is an error of writing, and told as one.
  std::vector<Verb> verbs = stretch::app::batchVerbs();
  verbs.push_back(stretch::ui::renderVerb());
  verbs.push_back(stretch::app::batchVerb(verbs));
  const std::vector<std::string_view> words(arguments + std::min(argumentCount, 1),
                                            arguments + argumentCount);
  if (startsEditor(verbs, words)) {
    const EditorStart start = editorStart(words);
    for (const std::filesystem::path& file : start.files) {
      if (std::error_code ignored; !std::filesystem::exists(file, ignored)) {
        fmt::print(stderr, "stretch-engine: {}: there is no such file; check the path\n", file.string());
        return 1;
      }
    }
    return stretch::ui::runEditor(start.files, start.options);
  }
  return stretch::app::runVerbs(verbs, "stretch-engine " + std::string(stretch::app::buildName()),
                                argumentCount, arguments);
}
