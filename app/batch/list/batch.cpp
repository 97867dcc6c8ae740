#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <poll.h>
#include <unistd.h>

#include "app/batch/list/command_words.h"
#include "app/batch/list/worker.h"
#include "app/batch/verb.h"
#include "core/base/file.h"
#include "core/gltf/json/json.h"
#include "core/gltf/json/utf8.h"
#include "core/gltf/source/json_text.h"

namespace stretch::app {

namespace {

using gltf::Json;

struct BatchArguments {
  std::string list;
  int jobs = 1;
  bool jsonLines = false;
  std::string log; // Answers of earlier runs, and of this one.
};

// A command of the list.
struct ListedCommand {
  std::size_t line = 0; // From 1.
  std::string text;
  std::string problem = {}; // Why it is no command; empty for one.
};

// The lines of a list as they come: all of a file's at once, those of standard input one after the other.
class Lines {
public:
  // Error: a file that cannot be read.
  static Result<Lines> of(const std::string& list) {
    Lines lines;
    lines.input_ = list == "-" ? STDIN_FILENO : -1;
    if (list != "-") {
      Result<std::string> text = readText(list);
      if (!text) {
        return text.error();
      }
      lines.text_ = std::move(text).value();
    }
    return lines;
  }

  // -1: nothing more comes.
  [[nodiscard]] int input() const { return input_; }

  // Takes what has come; waits where nothing has.
  void read() {
    std::array<char, 1U << 16U> part{};
    const ssize_t got = ::read(input_, part.data(), part.size());
    if (got > 0) {
      text_.append(part.data(), static_cast<std::size_t>(got));
    } else if (got == 0 || (errno != EINTR && errno != EAGAIN)) {
      input_ = -1;
    }
  }

  // The next line that is there whole and holds a command.
  std::optional<ListedCommand> next() {
    for (;;) {
      const std::size_t end = text_.find('\n', at_);
      if (at_ == text_.size() || (end == std::string::npos && input_ >= 0)) {
        text_.erase(0, std::exchange(at_, 0));
        return std::nullopt;
      }
      const std::size_t stop = std::min(end, text_.size());
      ListedCommand command{++number_, text_.substr(at_, stop - at_)};
      at_ = std::min(stop + 1, text_.size());
      const Result<std::vector<std::string>> words = commandWords(command.text);
      command.problem = words ? std::string() : words.error().line();
      if (!words || !words->empty()) {
        return command;
      }
    }
  }

private:
  int input_ = -1;
  std::string text_;
  std::size_t at_ = 0;
  std::size_t number_ = 0;
};

constexpr std::string_view answerStart = "{\"line\":"; // as answerJson writes it

// A device has nothing to read, or no end.
bool holdsAnswers(const std::string& log) {
  std::error_code none;
  return std::filesystem::is_regular_file(log, none);
}

// Commands that a log says are done. A line that was cut off by a kill says nothing.
std::set<std::string> doneBefore(const std::string& log) {
  std::set<std::string> done;
  std::ifstream file(holdsAnswers(log) ? log : std::string());
  for (std::string line; std::getline(file, line);) {
    const Json answer = gltf::parseAnyJson(line);
    if (answer.is_object() && answer.contains("command") && answer["command"].is_string() &&
        answer.contains("exit") && answer["exit"] == 0) {
      done.insert(answer["command"].get<std::string>());
    }
  }
  return done;
}

// Whether a file may be a log: what is no log would be spoilt by answers at its end. An empty one may, and
// one of a run that was killed in its first line.
bool beginsAsLog(const std::string& log) {
  std::ifstream file(log);
  std::string head(answerStart.size(), '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  return answerStart.starts_with(std::string_view(head).substr(0, static_cast<std::size_t>(file.gcount())));
}

Status checkLog(const BatchArguments& arguments) {
  std::error_code none;
  if (!arguments.log.empty() && std::filesystem::equivalent(arguments.list, arguments.log, none)) {
    return Error{"is the list itself", arguments.log, "name another file for the answers"};
  }
  const std::filesystem::file_status log = std::filesystem::status(arguments.log, none);
  if (!arguments.log.empty() && std::filesystem::is_fifo(log)) {
    return Error{"is a pipe, which keeps nothing", arguments.log, "name a file"};
  }
  if (!arguments.log.empty() && holdsAnswers(arguments.log) && !beginsAsLog(arguments.log)) {
    return Error{"holds something else than answers of an earlier run", arguments.log,
                 "name another file for them"};
  }
  return Success{};
}

std::string withoutEnds(std::string text) {
  constexpr std::string_view name = "stretch-engine: ";
  text.erase(text.find_last_not_of('\n') + 1);
  return text.starts_with(name) ? text.substr(name.size()) : text;
}

Json answerJson(const ListedCommand& command, const CommandAnswer& answer) {
  Json json{{"line", command.line}, {"command", command.text}, {"exit", answer.exitCode}};
  const std::string output = withoutEnds(answer.output);
  const std::string told = withoutEnds(answer.told);
  if (!output.empty()) {
    Json report = gltf::parseAnyJson(output);
    json["report"] = report.is_discarded() ? Json(output) : std::move(report);
  }
  if (!told.empty()) {
    json[answer.exitCode == 0 ? "told" : "error"] = told;
  }
  return json;
}

// Where the answers go.
class Answers {
public:
  explicit Answers(const BatchArguments& arguments) : jsonLines_(arguments.jsonLines) {
    if (!arguments.log.empty()) {
      const Result<std::string> before =
          holdsAnswers(arguments.log) ? readText(arguments.log) : Result<std::string>(std::string());
      log_.open(arguments.log, std::ios::app);
      log_ << (before && !before->empty() && before->back() != '\n' ? "\n" : "");
      hasLog_ = true;
    }
  }

  [[nodiscard]] bool canBeWritten() const { return !hasLog_ || log_.good(); }

  void put(const ListedCommand& command, const CommandAnswer& answer) {
    const std::string line = answerJson(command, answer).dump(-1, ' ', false, Json::error_handler_t::replace);
    if (hasLog_) {
      log_ << line << "\n" << std::flush; // What is done is known even if the next one never ends.
    }
    if (jsonLines_) {
      std::cout << line << "\n" << std::flush;
    } else if (answer.exitCode == 0) {
      std::cout << "done: " << command.text << "\n" << std::flush;
    }
    if (answer.exitCode != 0) {
      ++failed_;
      if (!jsonLines_) {
        std::cerr << "stretch-engine: line " << command.line << ": " << withoutEnds(answer.told) << '\n';
      }
    }
  }

  [[nodiscard]] std::size_t failed() const { return failed_; }

private:
  bool jsonLines_;
  bool hasLog_ = false;
  std::ofstream log_;
  std::size_t failed_ = 0;
};

// The program's own name may stand before the verb, as in a script.
int runCommand(const std::vector<Verb>& verbs, const std::string& text) {
  const std::vector<std::string> given = commandWords(text).value();
  const std::string& first = given.front();
  const bool isNamed = given.size() > 1 && first.substr(first.find_last_of('/') + 1) == "stretch-engine";
  std::vector<const char*> words{"stretch-engine"};
  for (std::size_t i = isNamed ? 1 : 0; i < given.size(); ++i) {
    words.push_back(given[i].c_str());
  }
  return runVerbs(verbs, "stretch-engine", static_cast<int>(words.size()), words.data());
}

// Gives commands, as they come, to workers as they become free; a worker that a command brought down is
// replaced.
class Dispatch {
public:
  Dispatch(Lines& lines, std::set<std::string> done, const std::vector<Verb>& verbs, Answers& answers)
      : lines_(lines), done_(std::move(done)), answers_(answers),
        run_([&verbs](const std::string& text) { return runCommand(verbs, text); }) {}

  Status all(std::size_t jobs) {
    jobs_ = jobs;
    for (;;) {
      const bool isFed = feed();
      if (!isFed && lines_.input() < 0) {
        return Success{};
      }
      if (isFed && !isAnyBusy()) {
        return Error{"no process could be started for the commands", "", "close other programs"};
      }
      collect();
    }
  }

  // Commands that were listed so far.
  [[nodiscard]] std::size_t listed() const { return listed_; }

private:
  struct Place {
    std::unique_ptr<Worker> worker;
    ListedCommand command;
  };

  [[nodiscard]] bool isAnyBusy() const {
    return std::ranges::any_of(places_, [](const Place& place) { return place.worker->isBusy(); });
  }

  // The next command that a worker has to do; those that are none are answered.
  bool hasNext() {
    while (!next_) {
      next_ = lines_.next();
      if (!next_) {
        return false;
      }
      ++listed_;
      const bool isDone = done_.contains(gltf::asUtf8(next_->text)); // as the log holds it
      if (!isDone && !next_->problem.empty()) {
        answers_.put(*next_, {2, {}, next_->problem});
      }
      if (isDone || !next_->problem.empty()) {
        next_.reset();
      }
    }
    return true;
  }

  // Whether something is under way or waits.
  bool feed() {
    for (std::size_t i = 0; hasNext() && i < jobs_; ++i) {
      if (i == places_.size()) {
        places_.push_back({std::make_unique<Worker>(run_), {}});
      }
      Place& place = places_[i];
      if (!place.worker->isAlive()) {
        place.worker = std::make_unique<Worker>(run_);
      }
      if (place.worker->isAlive() && !place.worker->isBusy()) {
        place.command = *std::exchange(next_, std::nullopt);
        place.worker->give(place.command.text);
      }
    }
    return next_.has_value() || isAnyBusy();
  }

  // Waits for an answer, or for more of the list where a command that came would be begun.
  void collect() {
    std::vector<pollfd> waited;
    std::vector<Place*> busy;
    for (Place& place : places_) {
      if (place.worker->isBusy()) {
        waited.push_back({place.worker->readyDescriptor(), POLLIN, 0});
        busy.push_back(&place);
      }
    }
    if (!next_ && lines_.input() >= 0) {
      waited.push_back({lines_.input(), POLLIN, 0});
    }
    if (poll(waited.data(), waited.size(), -1) <= 0) {
      return;
    }
    for (std::size_t i = 0; i < busy.size(); ++i) {
      if (waited[i].revents == 0) {
        continue;
      }
      if (const std::optional<CommandAnswer> answer = busy[i]->worker->take()) {
        answers_.put(busy[i]->command, *answer);
      }
    }
    if (waited.size() > busy.size() && waited.back().revents != 0) {
      lines_.read();
    }
  }

  Lines& lines_;
  std::set<std::string> done_;
  Answers& answers_;
  Worker::Run run_;
  std::size_t jobs_ = 1;
  std::size_t listed_ = 0;
  std::vector<Place> places_;
  std::optional<ListedCommand> next_;
};

Error holdsNothing(const std::string& list) {
  return {"holds no command", list, "write one in each line, as behind the program's name"};
}

Status runBatch(const BatchArguments& arguments, const std::vector<Verb>& verbs) {
  Result<Lines> lines = Lines::of(arguments.list);
  if (!lines) {
    return lines.error();
  }
  if (Lines all = *lines; all.input() < 0 && !all.next()) {
    return holdsNothing(arguments.list);
  }
  if (Status log = checkLog(arguments); !log) {
    return log;
  }
  std::set<std::string> done = arguments.log.empty() ? std::set<std::string>() : doneBefore(arguments.log);
  Answers answers(arguments);
  if (!answers.canBeWritten()) {
    return Error{"cannot be written", arguments.log, "name a file in a folder that can be written"};
  }
  std::signal(SIGPIPE, SIG_IGN); // A worker that died is found by its answer.
  Dispatch dispatch(*lines, std::move(done), verbs, answers);
  if (Status did = dispatch.all(static_cast<std::size_t>(arguments.jobs)); !did) {
    return did;
  }
  if (dispatch.listed() == 0) {
    return holdsNothing(arguments.list);
  }
  if (!answers.canBeWritten()) {
    return Error{"could not be written to the end", arguments.log,
                 "check that the disk has room, and resume"};
  }
  if (answers.failed() > 0) {
    return Error{fmt::format("{} of {} commands could not be done", answers.failed(), dispatch.listed()),
                 arguments.list, "each says why; the others are done"};
  }
  return Success{};
}

} // namespace

Verb batchVerb(const std::vector<Verb>& verbs) {
  return {
      "batch",
      "Runs many commands, one in each line of a list, in processes that stay warm; goes on after one that "
      "fails.",
      [verbs](CommandLine& line) {
        const auto arguments = std::make_shared<BatchArguments>();
        line.examples({"commands.txt --jobs 4 --json-lines", "commands.txt --resume done.jsonl"});
        line.option("LIST", arguments->list,
                    "A file with one command in each line, written as behind the program's name; -: standard "
                    "input, each line as it comes")
            .required();
        line.option("--jobs", arguments->jobs, "How many commands at a time").between(1, 256).showDefault();
        line.flag("--json-lines", arguments->jsonLines,
                  "Print one line of JSON for each command, as it ends");
        line.option("--resume", arguments->log,
                    "Keep the answers in this file, and leave out what it says is done");
        return [arguments, verbs] { return runBatch(*arguments, verbs); };
      }};
}

} // namespace stretch::app
