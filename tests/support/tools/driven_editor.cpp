#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "core/interchange/reader_process.h"
#include "tests/support/ui_driver/script.h"

// The editor as the product runs it, with a script for a hand: SCRIPT [FILE [FILE]]. The environment's
// STRETCH_UI_SCALE and STRETCH_UI_SIZE ("1280x720") set the window up.
namespace {

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string() : std::string(value);
}

int failWith(const std::string& line) {
  std::fprintf(stderr, "script: %s\n", line.c_str());
  return 1;
}

} // namespace

int main(int argumentCount, char** arguments) {
  using namespace stretch;
  if (const auto status = interchange::runAsReader(argumentCount, arguments)) {
    return *status;
  }
  Result<test::Script> script = test::Script::read(argumentCount > 1 ? arguments[1] : "");
  if (!script) {
    return failWith(script.error().line());
  }
  ui::EditorOptions options;
  options.hand = &*script;
  options.scale = std::strtof(environment("STRETCH_UI_SCALE").c_str(), nullptr);
  options.firstStart = !environment("STRETCH_UI_FIRST").empty();
  const std::string size = environment("STRETCH_UI_SIZE");
  if (const std::size_t cross = size.find('x'); cross != std::string::npos) {
    options.width = std::atoi(size.c_str());
    options.height = std::atoi(size.c_str() + cross + 1);
  }
  const std::vector<std::filesystem::path> files(arguments + 2, arguments + argumentCount);
  const int ended = ui::runEditor(files, options);
  return script->failure().empty() ? ended : failWith(script->failure());
}
