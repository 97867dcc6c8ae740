#include <csignal>
#include <cstdio>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "app/batch/command_words.h"
#include "app/batch/worker.h"
#include "tests/support/refusal.h"

using namespace stretch;
using namespace stretch::app;

namespace {

CommandAnswer answerOf(Worker& worker, std::size_t command) {
  worker.give(command);
  for (;;) {
    if (std::optional<CommandAnswer> answer = worker.take()) {
      return *answer;
    }
  }
}

} // namespace

TEST_CASE("A command is taken apart as a shell does") {
  using Words = std::vector<std::string>;
  CHECK(commandWords("info a.glb --json").value() == Words{"info", "a.glb", "--json"});
  CHECK(commandWords("  info\t'my file.glb'  ").value() == Words{"info", "my file.glb"});
  CHECK(commandWords("info \"my \\\"own\\\" file\"").value() == Words{"info", "my \"own\" file"});
  CHECK(commandWords("info my\\ file ''").value() == Words{"info", "my file", ""});
  CHECK(commandWords("info 'a\\b' a#b").value() == Words{"info", "a\\b", "a#b"});
  CHECK(commandWords("info a.glb\r").value() == Words{"info", "a.glb"});
  CHECK(commandWords("# a remark").value().empty());
  CHECK(commandWords("   ").value().empty());
  CHECK(test::refusal(commandWords("info 'a")).find("is not closed") != std::string::npos);
}

TEST_CASE("A worker answers one command after another") {
  Worker worker([](std::size_t command) {
    std::printf("out %zu", command);
    std::fprintf(stderr, "told %zu", command);
    return static_cast<int>(command) + 1;
  });
  REQUIRE(worker.isAlive());
  for (const std::size_t command : {std::size_t{0}, std::size_t{7}}) {
    const CommandAnswer answer = answerOf(worker, command);
    CHECK(answer.exitCode == static_cast<int>(command) + 1);
    CHECK(answer.output == "out " + std::to_string(command));
    CHECK(answer.told == "told " + std::to_string(command));
    CHECK_FALSE(worker.isBusy());
  }
}

TEST_CASE("A long answer comes whole") {
  Worker worker([](std::size_t) {
    std::fputs(std::string(3000000, 'x').c_str(), stdout);
    return 0;
  });
  CHECK(answerOf(worker, 0).output == std::string(3000000, 'x'));
}

TEST_CASE("A command that brings its worker down is answered, and costs nothing else") {
  Worker worker([](std::size_t command) {
    if (command == 1) {
      std::raise(SIGKILL);
    }
    return 0;
  });
  CHECK(answerOf(worker, 0).exitCode == 0);
  const CommandAnswer answer = answerOf(worker, 1);
  CHECK(answer.exitCode == 1);
  CHECK(answer.told == "the command was ended by signal 9");
  CHECK_FALSE(worker.isAlive());
  CHECK_FALSE(worker.isBusy());
}
