#include "tests/support/app/run_verb.h"

#include <iostream>
#include <regex>

#include "tests/support/app/captured_stream.h"

namespace stretch::test {

int exitCodeOf(const std::vector<std::string>& words, const std::vector<app::Verb>& others) {
  std::vector<const char*> arguments{"stretch-engine"};
  for (const std::string& word : words) {
    arguments.push_back(word.c_str());
  }
  std::vector<app::Verb> verbs = app::batchVerbs();
  verbs.insert(verbs.end(), others.begin(), others.end());
  return app::runVerbs(verbs, "stretch-engine under test", static_cast<int>(arguments.size()),
                       arguments.data());
}

VerbAnswer runVerb(const std::vector<std::string>& words, const std::vector<app::Verb>& others) {
  const CapturedStream errors(stderr);
  const CapturedStream output(stdout);
  const int exitCode = exitCodeOf(words, others);
  std::cout.flush();
  return {exitCode, output.text(), errors.text()};
}

std::string withoutClock(const std::string& told) {
  static const std::regex clock("; [0-9.]+ s, ");
  return std::regex_replace(told, clock, "; ");
}

} // namespace stretch::test
