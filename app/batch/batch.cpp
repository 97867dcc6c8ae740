#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <set>
#include <sstream>
#include <string>

#include <fmt/core.h>
#include <poll.h>

#include "app/batch/command_words.h"
#include "app/batch/verb.h"
#include "app/batch/worker.h"
#include "core/base/file.h"
#include "core/gltf/json/json.h"
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
  std::vector<std::string> words;
  std::string problem; // Why it is no command; empty for one.
};

Result<std::string> listText(const std::string& list) {
  if (list != "-") {
    return readText(list);
  }
  return std::string(std::istreambuf_iterator<char>(std::cin), {});
}

// The program's own name may stand before the verb, as in a script.
std::vector<ListedCommand> listedCommands(const std::string& text) {
  std::vector<ListedCommand> commands;
  std::istringstream lines(text);
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    Result<std::vector<std::string>> words = commandWords(line);
    if (words && words->empty()) {
      continue;
    }
    ListedCommand command{number, line, {}, words ? std::string() : words.error().line()};
    if (words) {
      command.words = std::move(words).value();
      const std::string& first = command.words.front();
      if (command.words.size() > 1 && first.substr(first.find_last_of('/') + 1) == "stretch-engine") {
        command.words.erase(command.words.begin());
      }
    }
    commands.push_back(std::move(command));
  }
  return commands;
}

// Commands that a log says are done. A line that was cut off by a kill says nothing.
std::set<std::string> doneBefore(const std::string& log) {
  std::set<std::string> done;
  std::ifstream file(log);
  for (std::string line; std::getline(file, line);) {
    const Json answer = gltf::parseAnyJson(line);
    if (answer.is_object() && answer.contains("command") && answer["command"].is_string() &&
        answer.contains("exit") && answer["exit"] == 0) {
      done.insert(answer["command"].get<std::string>());
    }
  }
  return done;
}

// A text as a line of JSON gives it back: what is no UTF-8 is replaced there.
std::string asLogged(const std::string& text) {
  return Json::parse(Json(text).dump(-1, ' ', false, Json::error_handler_t::replace)).get<std::string>();
}

Status checkLog(const BatchArguments& arguments) {
  std::error_code none;
  if (!arguments.log.empty() && std::filesystem::equivalent(arguments.list, arguments.log, none)) {
    return Error{"is the list itself", arguments.log, "name another file for the answers"};
  }
  const std::filesystem::file_status log = std::filesystem::status(arguments.log, none);
  const bool canHang = !arguments.log.empty() && std::filesystem::is_fifo(log);
  return canHang ? Status(Error{"is a pipe, which keeps nothing", arguments.log, "name a file"})
                 : Status(Success{});
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
      const Result<std::string> before = readText(arguments.log);
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

int runCommand(const std::vector<Verb>& verbs, const ListedCommand& command) {
  std::vector<const char*> words{"stretch-engine"};
  for (const std::string& word : command.words) {
    words.push_back(word.c_str());
  }
  return runVerbs(verbs, "stretch-engine", static_cast<int>(words.size()), words.data());
}

// Gives commands to workers as they become free; a worker that a command brought down is replaced.
class Dispatch {
public:
  Dispatch(const std::vector<ListedCommand>& commands, const std::vector<Verb>& verbs, Answers& answers)
      : commands_(commands), answers_(answers),
        run_([&commands, &verbs](std::size_t i) { return runCommand(verbs, commands[i]); }) {}

  Status all(std::size_t jobs) {
    jobs = std::min(jobs, commands_.size());
    for (std::size_t i = 0; i < jobs; ++i) {
      workers_.push_back(std::make_unique<Worker>(run_));
    }
    while (feed()) {
      if (std::ranges::none_of(workers_, [](const auto& worker) { return worker->isBusy(); })) {
        return Error{"no process could be started for the commands", "", "close other programs"};
      }
      collect();
    }
    return Success{};
  }

private:
  // Whether something is under way or left to do.
  bool feed() {
    for (std::unique_ptr<Worker>& worker : workers_) {
      while (next_ < commands_.size() && !commands_[next_].problem.empty()) {
        answers_.put(commands_[next_], {2, {}, commands_[next_].problem});
        ++next_;
      }
      if (next_ < commands_.size() && !worker->isAlive()) {
        worker = std::make_unique<Worker>(run_);
      }
      if (next_ < commands_.size() && worker->isAlive() && !worker->isBusy()) {
        worker->give(next_++);
      }
    }
    return next_ < commands_.size() ||
           std::ranges::any_of(workers_, [](const auto& worker) { return worker->isBusy(); });
  }

  void collect() {
    std::vector<pollfd> waited;
    std::vector<Worker*> busy;
    for (const std::unique_ptr<Worker>& worker : workers_) {
      if (worker->isBusy()) {
        waited.push_back({worker->readyDescriptor(), POLLIN, 0});
        busy.push_back(worker.get());
      }
    }
    if (poll(waited.data(), waited.size(), -1) <= 0) {
      return;
    }
    for (std::size_t i = 0; i < busy.size(); ++i) {
      if (waited[i].revents == 0) {
        continue;
      }
      const std::size_t command = busy[i]->command();
      if (const std::optional<CommandAnswer> answer = busy[i]->take()) {
        answers_.put(commands_[command], *answer);
      }
    }
  }

  const std::vector<ListedCommand>& commands_;
  Answers& answers_;
  Worker::Run run_;
  std::vector<std::unique_ptr<Worker>> workers_;
  std::size_t next_ = 0;
};

Status runBatch(const BatchArguments& arguments, const std::vector<Verb>& verbs) {
  const Result<std::string> text = listText(arguments.list);
  if (!text) {
    return text.error();
  }
  std::vector<ListedCommand> commands = listedCommands(*text);
  const std::size_t listed = commands.size();
  if (listed == 0) {
    return Error{"holds no command", arguments.list, "write one in each line, as behind the program's name"};
  }
  if (Status log = checkLog(arguments); !log) {
    return log;
  }
  if (!arguments.log.empty()) {
    const std::set<std::string> done = doneBefore(arguments.log);
    std::erase_if(commands,
                  [&](const ListedCommand& command) { return done.contains(asLogged(command.text)); });
  }
  Answers answers(arguments);
  if (!answers.canBeWritten()) {
    return Error{"cannot be written", arguments.log, "name a file in a folder that can be written"};
  }
  std::signal(SIGPIPE, SIG_IGN); // A worker that died is found by its answer.
  if (Status done = Dispatch(commands, verbs, answers).all(static_cast<std::size_t>(arguments.jobs)); !done) {
    return done;
  }
  if (!answers.canBeWritten()) {
    return Error{"could not be written to the end", arguments.log,
                 "check that the disk has room, and resume"};
  }
  if (answers.failed() > 0) {
    return Error{fmt::format("{} of {} commands could not be done", answers.failed(), listed), arguments.list,
                 "each says why; the others are done"};
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
                    "input")
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
