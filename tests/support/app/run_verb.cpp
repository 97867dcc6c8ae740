#include "tests/support/app/run_verb.h"

#include <iostream>
#include <sstream>

#include "tests/support/app/captured_errors.h"

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
  const CapturedErrors errors;
  const std::ostringstream output;
  std::streambuf* const original = std::cout.rdbuf(output.rdbuf());
  const int exitCode = exitCodeOf(words, others);
  std::cout.rdbuf(original);
  return {exitCode, output.str(), errors.text()};
}

} // namespace stretch::test
