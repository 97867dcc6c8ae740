#pragma once

#include <string>
#include <vector>

#include "app/batch/verb.h"

namespace stretch::test {

struct VerbAnswer {
  int exitCode = 0;
  std::string output; ///< On standard output, as far as it goes through std::cout.
  std::string told;   ///< On standard error.
};

/// The program without a window, with these words on its command line. `others`: verbs that are not of
/// app::batchVerbs().
[[nodiscard]] VerbAnswer runVerb(const std::vector<std::string>& words,
                                 const std::vector<app::Verb>& others = {});

/// The same, with what it says left where it goes.
int exitCodeOf(const std::vector<std::string>& words, const std::vector<app::Verb>& others = {});

} // namespace stretch::test
