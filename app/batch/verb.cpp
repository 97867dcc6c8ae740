#include "app/batch/verb.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <iostream>
#include <new>
#include <numeric>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

namespace stretch::app {

namespace {

constexpr int couldNotBeDone = 1;
constexpr int wrongArguments = 2;

// Where nobody can be told, the exit code alone says it.
void tell(const std::string& line) {
  std::fputs(("stretch-engine: " + line + "\n").c_str(), stderr);
}

int report(const Error& error) {
  tell(error.line());
  return couldNotBeDone;
}

Status runWithinMemory(const std::function<Status()>& verb) {
  try {
    return verb();
  } catch (const std::bad_alloc&) {
    return Error{"there is not enough memory for this", "", "shorten the range, or use a smaller file"};
  } catch (const std::system_error& problem) { // of fmt: a stream that takes nothing
    return Error{std::string("the report cannot be written: ") + problem.what(), "standard output or error",
                 "check that the disk has room"};
  }
}

// Reports go through a buffer: whether a full disk took them is known in the end.
Status outputWritten() {
  std::cout.flush();
  return std::cout.good() && std::fflush(stdout) == 0 && std::ferror(stdout) == 0
             ? Status(Success{})
             : Status(
                   Error{"the report cannot be written", "standard output", "check that the disk has room"});
}

// What people call a verb that has another name here.
constexpr std::array<std::pair<std::string_view, std::string_view>, 8> otherNames{{{"stretch", "exaggerate"},
                                                                                   {"scale", "exaggerate"},
                                                                                   {"skin", "bind"},
                                                                                   {"weights", "bind"},
                                                                                   {"import", "import-clip"},
                                                                                   {"save", "resave"},
                                                                                   {"convert", "resave"},
                                                                                   {"draw", "render"}}};

// Letters that have to be changed, added or left out to get from one word to the other (Levenshtein 1966).
std::size_t lettersApart(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({changed, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

// The verb that a word was probably meant to be; empty where none is near.
std::string meantVerb(const std::vector<Verb>& verbs, std::string_view word) {
  constexpr std::size_t mostTypos = 2;
  const auto* const other = std::ranges::find(otherNames, word, &decltype(otherNames)::value_type::first);
  if (other != otherNames.end()) {
    return std::string(other->second);
  }
  const auto nearest =
      std::ranges::min_element(verbs, {}, [&](const Verb& verb) { return lettersApart(word, verb.name); });
  return nearest != verbs.end() && lettersApart(word, nearest->name) <= mostTypos ? nearest->name
                                                                                  : std::string();
}

// What is wrong with the first word where a verb is expected; empty where it is one, or an option.
std::string unknownVerb(const std::vector<Verb>& verbs, int argumentCount, const char* const* arguments) {
  const std::string_view word = argumentCount > 1 ? arguments[1] : "-";
  const bool isKnown = std::ranges::any_of(verbs, [&](const Verb& verb) { return verb.name == word; });
  if (isKnown || word.starts_with('-')) {
    return {};
  }
  const std::string meant = meantVerb(verbs, word);
  std::string names;
  for (const Verb& verb : verbs) {
    names += (names.empty() ? "" : ", ") + std::string(verb.name);
  }
  return fmt::format("there is no verb '{}': {}the verbs are {}", word,
                     meant.empty() ? "" : "did you mean '" + meant + "'? ", names);
}

// An option that the chosen verb does not have, which explains what else is missing; nothing where all are
// known.
std::optional<std::string> unknownOption(const CLI::App& program) {
  for (const CLI::App* const verb : program.get_subcommands()) {
    const std::vector<std::string> left = verb->remaining();
    const auto option =
        std::ranges::find_if(left, [](const std::string& word) { return word.starts_with('-'); });
    if (option != left.end()) {
      return fmt::format("there is no option '{}': see {} --help", *option, verb->get_name());
    }
  }
  return std::nullopt;
}

} // namespace

std::vector<Verb> batchVerbs() {
  return {infoVerb(),  momentsVerb(),  stylesVerb(),  trailVerb(),      exaggerateVerb(),
          poseVerb(),  elasticVerb(),  rigVerb(),     importClipVerb(), resaveVerb(),
          checkVerb(), compressVerb(), compareVerb(), flattenVerb(),    bindVerb()};
}

int runVerbs(const std::vector<Verb>& verbs, const std::string& version, int argumentCount,
             const char* const* arguments) {
  CLI::App program{
      "Makes a realistic clip of a rigged character hit like a cartoon: trails, stretch, re-keyed glTF.\n"
      "Without a verb the editor opens: stretch-engine [FILE.glb|FILE.gltf|SEQUENCE]"};
  program.name("stretch-engine");
  program.require_subcommand(1);
  program.set_version_flag("--version", version);
  std::function<Status()> chosen;
  for (const Verb& verb : verbs) {
    CLI::App* const subcommand = program.add_subcommand(verb.name, verb.help);
    CommandLine line(*subcommand);
    const std::function<Status()> run = verb.declare(line);
    subcommand->callback([&chosen, run] { chosen = run; });
  }
  if (const std::string problem = unknownVerb(verbs, argumentCount, arguments); !problem.empty()) {
    tell(problem);
    return wrongArguments;
  }
  try {
    program.parse(argumentCount, arguments);
  } catch (const CLI::ParseError& problem) {
    if (problem.get_exit_code() == 0) {
      return program.exit(problem); // prints the help that was asked for
    }
    tell(unknownOption(program).value_or(problem.what()));
    return wrongArguments;
  }
  Status done = runWithinMemory(chosen);
  if (done) {
    done = outputWritten();
  }
  return done ? 0 : report(done.error());
}

} // namespace stretch::app
