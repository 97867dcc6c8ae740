// What becomes of each line of a list of commands, by verbs that say, fail and fall as they are told.
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <sys/stat.h>
#include <unistd.h>

#include "app/batch/verb.h"
#include "core/base/file.h"
#include "core/gltf/json/json.h"
#include "tests/support/app/captured_stream.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::app;
using gltf::Json;

namespace {

Verb verbOf(const char* name, Status (*does)(const std::string& word)) {
  return {name, "Does it.", [does](CommandLine& line) {
            const auto word = std::make_shared<std::string>();
            line.option("WORD", *word, "A word");
            return [does, word] { return does(*word); };
          }};
}

Status say(const std::string& word) {
  std::cout << word << "\n\n";
  return Success{};
}

Status warn(const std::string& word) {
  std::cerr << "stretch-engine: " << word << "\n";
  return Success{};
}

Status tellReport(const std::string& word) {
  std::cout << Json{{"word", word}} << "\n";
  return Success{};
}

Status refuse(const std::string& word) {
  return Error{"cannot be done", word, "ask for another"};
}

Status fall(const std::string&) {
  std::raise(SIGKILL);
  return Success{};
}

Status leave(const std::string&) {
  _exit(7);
}

// Reads what it is not to read.
Status listen(const std::string&) {
  char letter = 0;
  std::cout << (read(STDIN_FILENO, &letter, 1) == 0 ? "nothing" : "something") << "\n";
  return Success{};
}

Status tellProcess(const std::string&) {
  std::cout << getpid() << "\n";
  return Success{};
}

std::string textIn(const std::string& file) {
  return readText(file).value();
}

struct Told {
  int exitCode = 0;
  std::string output;
  std::string told;
};

std::vector<Verb> verbs() {
  return {verbOf("say", say),       verbOf("warn", warn),          verbOf("report", tellReport),
          verbOf("refuse", refuse), verbOf("fall", fall),          verbOf("leave", leave),
          verbOf("listen", listen), verbOf("process", tellProcess)};
}

Told batch(std::vector<std::string> words) {
  words.insert(words.begin(), {"stretch-engine", "batch"});
  std::vector<const char*> arguments(words.size());
  std::ranges::transform(words, arguments.begin(), [](const std::string& word) { return word.c_str(); });
  const test::CapturedStream errors(stderr);
  const test::CapturedStream output(stdout);
  const int exitCode =
      runVerbs({batchVerb(verbs())}, "under test", static_cast<int>(arguments.size()), arguments.data());
  std::cout.flush();
  return {exitCode, output.text(), errors.text()};
}

// Lines of JSON by the line of the list that they answer.
std::vector<Json> answersIn(const std::string& text) {
  std::vector<Json> answers;
  for (std::size_t at = 0; at < text.size(); at = text.find('\n', at) + 1) {
    answers.push_back(Json::parse(text.substr(at, text.find('\n', at) - at)));
  }
  std::ranges::sort(answers, {}, [](const Json& answer) { return answer["line"].get<int>(); });
  return answers;
}

// Each kind of line that a list may hold: the third is empty, the sixth is a remark.
constexpr const char* everyKind = "say one\n"
                                  "report two\n"
                                  "\n"
                                  "refuse four\n"
                                  "fall\n"
                                  "# say six\n"
                                  "leave\n"
                                  "say 'eight\n"
                                  "unheard\n"
                                  "stretch-engine say ten\n"
                                  "/usr/bin/stretch-engine say eleven\n"
                                  "warn twelve\n"
                                  "say 'thir\xff'\n"
                                  "listen\n"
                                  "say last";

Json answer(int line, const char* command, int exitCode, const char* kind = "", const Json& said = {}) {
  Json json{{"line", line}, {"command", command}, {"exit", exitCode}};
  if (kind[0] != '\0') {
    json[kind] = said;
  }
  return json;
}

std::vector<Json> everyAnswer() {
  return {answer(1, "say one", 0, "report", "one"),
          answer(2, "report two", 0, "report", {{"word", "two"}}),
          answer(4, "refuse four", 1, "error", "four: cannot be done; ask for another"),
          answer(5, "fall", 1, "error", "the command was ended by signal 9"),
          answer(7, "leave", 1, "error", "the command ended the program"),
          answer(8, "say 'eight", 2, "error", ""),
          answer(9, "unheard", 2, "error", ""),
          answer(10, "stretch-engine say ten", 0, "report", "ten"),
          answer(11, "/usr/bin/stretch-engine say eleven", 0, "report", "eleven"),
          answer(12, "warn twelve", 0, "told", "twelve"),
          answer(13, "say 'thir\xef\xbf\xbd'", 0, "report", "thir\xef\xbf\xbd"),
          answer(14, "listen", 0, "report", "nothing"),
          answer(15, "say last", 0, "report", "last")};
}

// The answers as they came, but for what the reader of command lines says of a line that is no command.
void checkEvery(const std::vector<Json>& told) {
  const std::vector<Json> wanted = everyAnswer();
  REQUIRE(told.size() == wanted.size());
  for (std::size_t i = 0; i < told.size(); ++i) {
    Json one = told[i];
    if (one["line"] == 8) {
      CHECK_THAT(one["error"].get<std::string>(), Catch::Contains("is not closed"));
      one["error"] = "";
    }
    if (one["line"] == 9) {
      CHECK_THAT(one["error"].get<std::string>(), Catch::Contains("unheard"));
      one["error"] = "";
    }
    CHECK(one == wanted[i]);
  }
}

} // namespace

TEST_CASE("Each line of a list is answered with what it printed, told or was refused for", "[batch-lists]") {
  const test::TemporaryFolder folder;
  const std::string list = folder.write("list", everyKind).string();
  const char* const jobs = GENERATE("1", "2", "5");
  const Told told = batch({list, "--jobs", jobs, "--json-lines"});
  CHECK(told.exitCode == 1);
  CHECK(told.told == "stretch-engine: " + list +
                         ": 5 of 13 commands could not be done; each says why; the others are done\n");
  checkEvery(answersIn(told.output));
}

TEST_CASE("In plain words a list tells what is done, and which line could not be done for which reason",
          "[batch-lists]") {
  const test::TemporaryFolder folder;
  const std::string list = folder.write("list", "say one\n\nrefuse three\nfall\nreport five\n").string();
  const Told told = batch({list});
  CHECK(told.exitCode == 1);
  CHECK(told.output == "done: say one\ndone: report five\n");
  CHECK(told.told == "stretch-engine: line 3: three: cannot be done; ask for another\n"
                     "stretch-engine: line 4: the command was ended by signal 9\n"
                     "stretch-engine: " +
                         list + ": 2 of 4 commands could not be done; each says why; the others are done\n");
  const Told fine = batch({folder.write("fine", "say one\nreport two\n").string()});
  CHECK(fine.exitCode == 0);
  CHECK(fine.told.empty());
  CHECK(fine.output == "done: say one\ndone: report two\n");
}

TEST_CASE("One process does one command after the other, and as many as asked for do them side by side",
          "[batch-lists]") {
  const test::TemporaryFolder folder;
  const std::string list = folder.write("list", "process\nprocess\nfall\nprocess\nprocess\n").string();
  const std::vector<Json> told = answersIn(batch({list, "--json-lines"}).output);
  REQUIRE(told.size() == 5);
  CHECK(told[0]["report"] == told[1]["report"]);
  CHECK(told[3]["report"] == told[4]["report"]);
  CHECK(told[0]["report"] != told[3]["report"]); // The first one fell.
  CHECK(told[0]["report"] != getpid());
}

TEST_CASE("What a log says is done is left out, and what failed or was cut off is tried again",
          "[batch-lists]") {
  const test::TemporaryFolder folder;
  const std::string list = folder.write("list", everyKind).string();
  const std::string log = (folder / "log").string();
  const Told first = batch({list, "--json-lines", "--resume", log});
  CHECK(textIn(log) == first.output);
  checkEvery(answersIn(textIn(log)));
  const std::vector<Json> again = answersIn(batch({list, "--json-lines", "--resume", log}).output);
  std::vector<int> lines(again.size());
  std::ranges::transform(again, lines.begin(), [](const Json& answer) { return answer["line"].get<int>(); });
  CHECK(lines == std::vector<int>{4, 5, 7, 8, 9});
  // A line that a kill cut off tells nothing, and the next answer begins a line of its own.
  const std::string torn = R"({"line":1,"command":"say one","exit":0)";
  const std::string cut = folder.write("cut", torn).string();
  const std::string two = folder.write("two", "say one\nsay two\n").string();
  CHECK(batch({two, "--resume", cut}).output == "done: say one\ndone: say two\n");
  CHECK(textIn(cut).starts_with(torn + "\n{"));
  CHECK(batch({two, "--resume", cut}).output.empty());
  for (const char* const answer :
       {R"({"line":1,"command":"say one","exit":1})", R"({"line":1,"command":"say one"})",
        R"({"line":1,"command":3,"exit":0})", R"({"line":1,"exit":0})", R"(["say one",0])", "say one"}) {
    CAPTURE(answer);
    const std::string before = R"({"line":7,"command":"say seven","exit":0})" + std::string("\n") + answer;
    const std::string other = folder.write("other", before + "\n").string();
    CHECK(batch({two, "--resume", other}).output == "done: say one\ndone: say two\n");
    CHECK(textIn(other).starts_with(before + "\n{")); // without an empty line between
  }
  const std::string done = folder.write("done", R"({"line":9,"command":"say one","exit":0})").string();
  CHECK(batch({two, "--resume", done}).output == "done: say two\n");
}

TEST_CASE("A file that does not begin as a log does is refused, and stays as it is", "[batch-lists]") {
  const test::TemporaryFolder folder;
  const std::string list = folder.write("list", "say one\n").string();
  for (const char* const text : {"say one", "{\"asset\":{}}\n", "glTF", "{\"lines\":1}", "\n"}) {
    CAPTURE(text);
    const std::string other = folder.write("other", text).string();
    const Told told = batch({list, "--resume", other});
    CHECK(told.exitCode == 1);
    CHECK_THAT(told.told, Catch::Contains(other + ": holds something else than answers of an earlier run"));
    CHECK(textIn(other) == text);
  }
  for (const char* const text : {"", "{", "{\"line\":", "{\"line\":3"}) { // cut off by a kill
    CAPTURE(text);
    CHECK(batch({list, "--resume", folder.write("cut", text).string()}).exitCode == 0);
  }
}

TEST_CASE("A list without a command, and a log that keeps nothing, are refused for that", "[batch-lists]") {
  const test::TemporaryFolder folder;
  const std::string list = folder.write("list", "say one\n").string();
  const auto refusal = [](const std::vector<std::string>& words) {
    const Told told = batch(words);
    CHECK(told.exitCode == 1);
    CHECK(told.output.empty());
    return told.told;
  };
  for (const char* const nothing : {"", "\n\n", "# a remark\n", "  \n#"}) {
    const std::string empty = folder.write("empty", nothing).string();
    CHECK_THAT(refusal({empty}), Catch::Contains(empty + ": holds no command; write one in each line"));
  }
  CHECK_THAT(refusal({(folder / "missing").string()}), Catch::Contains("missing"));
  CHECK_THAT(refusal({list, "--resume", list}), Catch::Contains("is the list itself"));
  CHECK(textIn(list) == "say one\n");
  const std::string pipe = (folder / "pipe").string();
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  CHECK_THAT(refusal({list, "--resume", pipe}), Catch::Contains("is a pipe, which keeps nothing"));
  CHECK_THAT(refusal({list, "--resume", (folder / "no/log").string()}), Catch::Contains("cannot be written"));
  const Told full = batch({list, "--resume", "/dev/full"});
  CHECK(full.exitCode == 1);
  CHECK(full.output == "done: say one\n");
  CHECK_THAT(full.told, Catch::Contains("/dev/full: could not be written to the end"));
  CHECK(batch({list, "--resume", "/dev/null"}).exitCode == 0);
  for (const char* const jobs : {"0", "257", "two"}) {
    CHECK(batch({list, "--jobs", jobs}).exitCode == 2);
  }
  CHECK(batch({list, "--jobs", "256"}).exitCode == 0);
  CHECK(batch({}).exitCode == 2);
}
