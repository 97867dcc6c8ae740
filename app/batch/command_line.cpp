#include "app/batch/command_line.h"

#include <map>

#include <CLI/CLI.hpp>

namespace stretch::app {

namespace {

// A text that is given and empty is a slip: an unset variable of a script, mostly.
CLI::Option& filled(CLI::Option* option) {
  option->check([](const std::string& text) {
    return text.empty() ? std::string("is empty: give a text, or leave the option out") : std::string();
  });
  return *option;
}

} // namespace

const DeclaredOption& DeclaredOption::required() const {
  option_->required();
  return *this;
}

const DeclaredOption& DeclaredOption::takes(int least, int most) const {
  option_->expected(least, most);
  return *this;
}

const DeclaredOption& DeclaredOption::check(const Check& problemOf) const {
  option_->check(problemOf);
  return *this;
}

const DeclaredOption& DeclaredOption::between(int least, int most) const {
  option_->check(CLI::Range(least, most));
  return *this;
}

const DeclaredOption& DeclaredOption::oneOf(const std::vector<std::string>& choices) const {
  option_->check(CLI::IsMember(choices));
  return *this;
}

const DeclaredOption& DeclaredOption::excludes(const DeclaredOption& other) const {
  option_->excludes(other.option_);
  return *this;
}

const DeclaredOption& DeclaredOption::needs(const DeclaredOption& other) const {
  option_->needs(other.option_);
  return *this;
}

const DeclaredOption& DeclaredOption::showDefault() const {
  option_->capture_default_str();
  return *this;
}

const DeclaredOption& DeclaredOption::group(const std::string& heading) const {
  option_->group(heading);
  return *this;
}

CommandLine::CommandLine(CLI::App& verb)
    : verb_(&verb), checks_(std::make_shared<std::vector<std::function<void()>>>()) {
  verb.parse_complete_callback([checks = checks_] {
    for (const std::function<void()>& check : *checks) {
      check();
    }
  });
}

void CommandLine::requireOne(const DeclaredOption& one, const DeclaredOption& other) {
  checks_->emplace_back([one = one.option_, other = other.option_] {
    if (one->empty() && other->empty()) {
      throw CLI::RequiredError(one->get_name() + " or " + other->get_name());
    }
  });
}

void CommandLine::checkTogether(const std::function<Status(const CommandLine&)>& problem) {
  checks_->emplace_back([problem, verb = verb_] { // which owns the check: no shared pointer back to it
    if (const Status right = problem(CommandLine(verb, nullptr)); !right) {
      throw CLI::ValidationError(right.error().line());
    }
  });
}

DeclaredOption CommandLine::option(const std::string& name, std::string& value, const std::string& help) {
  return DeclaredOption(filled(verb_->add_option(name, value, help)));
}

DeclaredOption CommandLine::option(const std::string& name, int& value, const std::string& help) {
  return DeclaredOption(*verb_->add_option(name, value, help));
}

DeclaredOption CommandLine::option(const std::string& name, std::size_t& value, const std::string& help) {
  return DeclaredOption(*verb_->add_option(name, value, help));
}

DeclaredOption CommandLine::option(const std::string& name, double& value, const std::string& help) {
  return DeclaredOption(*verb_->add_option(name, value, help));
}

DeclaredOption CommandLine::options(const std::string& name, std::vector<std::string>& values,
                                    const std::string& help) {
  return DeclaredOption(filled(verb_->add_option(name, values, help)));
}

DeclaredOption CommandLine::repeated(const std::string& name, std::vector<std::string>& values,
                                     const std::string& help) {
  return DeclaredOption(filled(verb_->add_option(name, values, help)->take_all()->expected(1)));
}

DeclaredOption CommandLine::flag(const std::string& name, bool& value, const std::string& help) {
  return DeclaredOption(*verb_->add_flag(name, value, help));
}

DeclaredOption CommandLine::ordered(const std::string& name, const std::string& help) {
  return DeclaredOption(filled(verb_->add_option(name)->description(help)->take_all()->expected(1)));
}

DeclaredOption CommandLine::orderedFlag(const std::string& name, const std::string& help) {
  return DeclaredOption(*verb_->add_flag(name)->description(help));
}

void CommandLine::examples(const std::vector<std::string>& lines) {
  std::string text = lines.size() == 1 ? "Example:" : "Examples:";
  for (const std::string& line : lines) {
    text += "\n  stretch-engine " + verb_->get_name() + ' ' + line;
  }
  verb_->footer(text);
}

std::vector<std::pair<std::string, std::string>> CommandLine::inOrder() const {
  std::vector<std::pair<std::string, std::string>> given;
  std::map<const CLI::Option*, std::size_t> seen;
  for (const CLI::Option* option : verb_->parse_order()) {
    const std::vector<std::string> results = option->results();
    const std::size_t index = seen[option]++;
    given.emplace_back(option->get_name(), index < results.size() ? results[index] : std::string());
  }
  return given;
}

} // namespace stretch::app
