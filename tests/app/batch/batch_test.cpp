#include <csignal>
#include <cstdio>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "app/batch/list/command_words.h"
#include "app/batch/list/worker.h"
#include "tests/support/refusal.h"

using namespace stretch;
using namespace stretch::app;

namespace {

CommandAnswer answerOf(Worker& worker, const std::string& command) {
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
  CHECK(commandWords("trail a.glb --clip #1").value() == Words{"trail", "a.glb", "--clip", "#1"});
  CHECK(commandWords("info a\\").value() == Words{"info", "a\\"}); // before nothing
  CHECK(commandWords("info ''b'c'\"d\"").value() == Words{"info", "bcd"});
  CHECK(commandWords("# a remark").value().empty());
  CHECK(commandWords("   ").value().empty());
  CHECK(test::refusal(commandWords("info 'a")).find("is not closed") != std::string::npos);
}

TEST_CASE("A worker answers one command after another") {
  Worker worker([](const std::string& command) {
    std::printf("out %s", command.c_str());
    std::fprintf(stderr, "told %s", command.c_str());
    return static_cast<int>(command.size());
  });
  REQUIRE(worker.isAlive());
  for (const std::string command : {"info", "resave", ""}) {
    const CommandAnswer answer = answerOf(worker, command);
    CHECK(answer.exitCode == static_cast<int>(command.size()));
    CHECK(answer.output == "out " + command);
    CHECK(answer.told == "told " + command);
    CHECK_FALSE(worker.isBusy());
  }
}

TEST_CASE("A long answer comes whole") {
  Worker worker([](const std::string&) {
    std::fputs(std::string(3000000, 'x').c_str(), stdout);
    return 0;
  });
  CHECK(answerOf(worker, "info").output == std::string(3000000, 'x'));
}

TEST_CASE("A command that brings its worker down is answered, and costs nothing else") {
  Worker worker([](const std::string& command) {
    if (command == "fall") {
      std::raise(SIGKILL);
    }
    return 0;
  });
  CHECK(answerOf(worker, "info").exitCode == 0);
  const CommandAnswer answer = answerOf(worker, "fall");
  CHECK(answer.exitCode == 1);
  CHECK(answer.told == "the command was ended by signal 9");
  CHECK_FALSE(worker.isAlive());
  CHECK_FALSE(worker.isBusy());
}
