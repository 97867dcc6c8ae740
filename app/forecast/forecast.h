#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/document.h"
#include "app/forecast/engines.h"
#include "core/gltf/source/problems.h"

namespace stretch::app {

/// One thing that an engine shows otherwise than it was made.
struct ForecastFinding {
  std::string id; ///< Stable in every version: "shading-plain-matrix" (docs/engines.md, Findings).
  gltf::Severity severity = gltf::Severity::warning;
  std::string clip = {}; ///< Name of the clip; empty: of the file.
  std::string limb = {}; ///< Empty: none of the limbs, or more than one.
  std::optional<double> frame = {};
  std::optional<double> share = {}; ///< 0..1: of the moved vertices, or of the vertices.
  std::string what = {};
  std::string remedy = {};
};

struct EngineForecast {
  std::string engine; ///< Engine::id
  std::vector<ForecastFinding> findings;
  std::vector<std::string> notJudged; ///< Subjects.
};

/// Returns what the engines make of a file; of all of them, or of those whose ids are named. `document`: the
/// file as it stands (openAsItStands).
[[nodiscard]] std::vector<EngineForecast> forecast(const Document& document,
                                                   const std::vector<std::string>& engineIds);

/// A document of the file as any viewer reads it, a stretched one of ours too.
[[nodiscard]] Result<Document> openAsItStands(const std::string& path);

/// The engines that "three,godot" or "all" names. An error names the word that is none.
[[nodiscard]] Result<std::vector<std::string>> engineIdsOf(const std::string& text);

} // namespace stretch::app
