#include "app/batch/output_file.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "core/base/file_series.h"
#include "core/base/lower_case.h"

namespace stretch::app {

namespace {

std::string endingOf(const std::string& path) {
  return lowerCase(std::filesystem::path(path).extension().string());
}

bool isAvatar(const std::string& ending) {
  return ending == ".vrm" || ending == ".vrma";
}

Error wrongEnding(const OutputFile& output) {
  return {fmt::format("an output has to end in {}", fmt::join(output.endings, " or ")), output.path,
          "give it such a name"};
}

bool hasEnding(const OutputFile& output, const std::string& ending) {
  return output.endings.empty() || std::ranges::count(output.endings, ending) > 0;
}

bool isOneOf(const std::vector<std::string>& files, const std::string& path) {
  std::error_code missing; // a file that is not there yet is none of the others
  return std::ranges::any_of(
      files, [&](const std::string& file) { return std::filesystem::equivalent(file, path, missing); });
}

} // namespace

Status checkName(const OutputFile& output) {
  const std::string ending = endingOf(output.path);
  const bool mayBeAvatar = isAvatar(ending) && hasEnding(output, ".glb");
  return output.path.empty() || hasEnding(output, ending) || mayBeAvatar ? Status(Success{})
                                                                         : Status(wrongEnding(output));
}

void addOutputFile(CommandLine& line, OutputFile& output, const std::string& help) {
  line.option("-o,--output", output.path, help).required();
  line.flag("--in-place", output.inPlace, "The file to write may be one that is read");
  line.checkTogether([&output](const CommandLine&) { return checkName(output); });
}

Status checkOutput(const OutputFile& output, const std::vector<std::string>& inputs) {
  if (isOneOf(inputs, output.path) && !output.inPlace) {
    return Error{"is read and would be written over", output.path, "name another file, or add --in-place"};
  }
  if (output.path.empty()) {
    return Success{};
  }
  const std::string ending = endingOf(output.path);
  const bool staysAvatar = !inputs.empty() && endingOf(inputs.front()) == ending;
  if (isAvatar(ending) && !hasEnding(output, ending) && !staysAvatar) {
    return wrongEnding(output);
  }
  Status named = checkName(output);
  return named ? checkPlace(output.path) : named;
}

} // namespace stretch::app
