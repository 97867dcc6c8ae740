#include "app/batch/verb.h"

#include <cstdio>
#include <iostream>
#include <new>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

namespace stretch::app {

namespace {

constexpr int couldNotBeDone = 1;
constexpr int wrongArguments = 2;

int report(const Error& error) {
  fmt::print(stderr, "stretch-engine: {}\n", error.line());
  return couldNotBeDone;
}

Status runWithinMemory(const std::function<Status()>& verb) {
  try {
    return verb();
  } catch (const std::bad_alloc&) {
    return Error{"there is not enough memory for this", "", "shorten the range, or use a smaller file"};
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

} // namespace

std::vector<Verb> batchVerbs() {
  return {infoVerb(),    trailVerb(),      exaggerateVerb(), poseVerb(),  elasticVerb(),
          rigVerb(),     importClipVerb(), resaveVerb(),     checkVerb(), compressVerb(),
          compareVerb(), flattenVerb(),    bindVerb()};
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
  try {
    program.parse(argumentCount, arguments);
  } catch (const CLI::ParseError& problem) {
    if (problem.get_exit_code() == 0) {
      return program.exit(problem); // prints the help that was asked for
    }
    fmt::print(stderr, "stretch-engine: {}\n", problem.what());
    return wrongArguments;
  }
  Status done = runWithinMemory(chosen);
  if (done) {
    done = outputWritten();
  }
  return done ? 0 : report(done.error());
}

} // namespace stretch::app
