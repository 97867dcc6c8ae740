#pragma once

#include <string>
#include <vector>

#include "app/batch/command_line.h"
#include "app/recipe/recipe.h"

namespace stretch::app {

/// One "--limb" with the options that follow it; options before the first one hold for every trail.
struct TrailRequest {
  std::string limb;
  std::string range;
  std::vector<std::pair<std::string, std::string>> settings; ///< Option and text.
};

/// Declares --limb, --range and the option of every setting of a trail.
void addTrailOptions(CommandLine& line);

/// Trails that were asked for, in the order of the command line. To be asked after the line was parsed.
[[nodiscard]] std::vector<TrailRequest> requestsOf(const CommandLine& line);

/// Options of trails that were given, --limb and --range among them, in the order of the command line.
[[nodiscard]] std::vector<std::string> trailOptionsOf(const CommandLine& line);

/// Whether each is given once for its limb: of two values one would be lost. What stands before the first
/// --limb gives way to what stands behind it.
[[nodiscard]] Status checkTrailOptions(const CommandLine& line);

/// Checks what holds in every clip: that each request names a limb of the document, and a scale.
[[nodiscard]] Status checkRequests(const std::vector<TrailRequest>& requests, const Document& document);

/// The trails that were asked for, as a recipe would name them; chains join the document. Errors name the
/// option.
[[nodiscard]] Result<Recipe> recipeOf(const std::vector<TrailRequest>& requests, int clip,
                                      Document& document);

} // namespace stretch::app
