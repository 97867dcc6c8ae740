#pragma once

#include <string>
#include <vector>

#include "app/batch/verb.h"

namespace stretch::test {

struct VerbAnswer {
  int exitCode = 0;
  std::string output; ///< On standard output.
  std::string told;   ///< On standard error.
};

/// The program without a window, with these words on its command line. `others`: verbs that are not of
/// app::batchVerbs().
[[nodiscard]] VerbAnswer runVerb(const std::vector<std::string>& words,
                                 const std::vector<app::Verb>& others = {});

/// As runVerb, with what it says left where it goes.
int exitCodeOf(const std::vector<std::string>& words, const std::vector<app::Verb>& others = {});

/// A text without what the clock says of the work: "; 0.9 s, ".
[[nodiscard]] std::string withoutClock(const std::string& told);

} // namespace stretch::test
