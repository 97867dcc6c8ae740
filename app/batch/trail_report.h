#pragma once

#include <memory>
#include <vector>

#include "app/document.h"
#include "core/gltf/json/json_document.h"

namespace stretch::app {

class CharacterFacts;
class EvaluationCache;

/// Outcome of these trails of a clip, and the weight of its limbs, as `exaggerate` reports it.
/// `character`: of that document, for several clips; null: its own.
[[nodiscard]] gltf::Json exaggerationJson(const Document& document, int clip, const std::vector<int>& ids,
                                          const std::shared_ptr<CharacterFacts>& character = {});

/// Adds to the warnings of each of these trails, in a report of exaggerationJson, where its limb flips
/// (limbPops) on its way there or back.
void addFlips(const Document& document, int clip, const std::vector<int>& ids, gltf::Json& report);

/// Prints the outcome as lines of text; warnings on standard error, behind the clip's name where one is
/// given.
void printExaggeration(const gltf::Json& report, const std::string& clip = {});

/// The files that were added to the document, each with the node that carries its thing.
[[nodiscard]] gltf::Json addedFilesToJson(const Document& document);

/// The document's warnings and those about its body, as verbs report them.
[[nodiscard]] gltf::Json documentWarnings(const Document& document);

/// Adds what of `before` gave way (gaveWay) to a report's warnings.
void addGaveWay(const Document& before, const Document& after, gltf::Json& report);

/// Each of the list on standard error, behind the clip's name where one is given.
void printWarnings(const gltf::Json& warnings, const std::string& clip = {});

/// Outcome of the weight of each limb of a clip, as `elastic` and `exaggerate` report it.
[[nodiscard]] gltf::Json weightJson(const Document& document, int clip, EvaluationCache& cache);

/// Prints it as lines of text; warnings on standard error.
void printWeight(const gltf::Json& limbs, const std::string& clip = {});

} // namespace stretch::app
