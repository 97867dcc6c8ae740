#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/batch/command_line.h"
#include "core/base/result.h"

namespace stretch::app {

/// A verb of the command line: adds its options to a subcommand and answers what to do when it was chosen.
struct Verb {
  std::string name;
  std::string help; ///< One sentence.
  std::function<std::function<Status()>(CommandLine&)> declare;
};

/// The verbs that need no screen. `render` is registered by the program from ui/.
[[nodiscard]] std::vector<Verb> batchVerbs();

/// Runs one verb by command line, whose first word is the program's name. Exit code: 0 done, 1 could not be
/// done (one line on standard error), 2 wrong arguments. `version` is what `--version` prints.
[[nodiscard]] int runVerbs(const std::vector<Verb>& verbs, const std::string& version, int argumentCount,
                           const char* const* arguments);

[[nodiscard]] Verb infoVerb();
[[nodiscard]] Verb momentsVerb();
[[nodiscard]] Verb stylesVerb();
[[nodiscard]] Verb trailVerb();
[[nodiscard]] Verb exaggerateVerb();
[[nodiscard]] Verb poseVerb();
[[nodiscard]] Verb importClipVerb();
[[nodiscard]] Verb rigVerb();
[[nodiscard]] Verb resaveVerb();
[[nodiscard]] Verb checkVerb();
[[nodiscard]] Verb compressVerb();
[[nodiscard]] Verb compareVerb();
[[nodiscard]] Verb elasticVerb();
[[nodiscard]] Verb flattenVerb();
[[nodiscard]] Verb bindVerb();
/// Many commands of these verbs, one in each line of a list.
[[nodiscard]] Verb batchVerb(const std::vector<Verb>& verbs);

} // namespace stretch::app
