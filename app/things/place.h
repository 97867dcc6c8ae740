#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/things/thing.h"

namespace stretch::app {

// The one door for things in time: the command line, recipes, the editor and the work that a file carries all
// pass through it, by the same rules. A thing's limb, controller or node and its clip are in the document,
// each of its numbers has a value that it takes, its range has a length and shares frames with the clip, and
// no two things of one kind and subject meet in time.

/// Who brings the things, which decides what happens to those that are in their way.
enum class Entry {
  request, ///< Command line, recipe or command: what meets them gives way.
  hand,    ///< The editor's ranges and new trails: an overlap is refused.
  file,    ///< Saved work: an overlap is refused; a range may lie outside the clip, which other programs may
           ///< have cut.
};

struct Placed {
  Document document;
  std::vector<int> trailIds; ///< In the order in which trails were wanted.
};

/// Places all of them or none. A trail with the id 0 gets the next free one. Errors name the limb, controller
/// or node. Two of `wanted` that meet are refused whoever brings them. What `before` has past the end of its
/// clip, which may have become shorter, may be wanted there again.
[[nodiscard]] Result<Placed> place(const Document& document, const Things& wanted, Entry entry,
                                   const Document& before);
[[nodiscard]] Result<Placed> place(const Document& document, const Things& wanted, Entry entry);

/// One line for each thing of `before`, weight left out, in whose place `after` has another one.
[[nodiscard]] std::vector<std::string> gaveWay(const Document& before, const Document& after);

/// Answers the document alone.
[[nodiscard]] Result<Document> documentOf(Result<Placed> placed);

/// Places things of one kind.
template <typename T>
[[nodiscard]] Result<Placed> placeOf(const Document& document, std::vector<T> wanted, Entry entry) {
  Things things;
  listOf<T>(things) = std::move(wanted);
  return place(document, things, entry);
}

/// Whether everything that stands in the time of a clip is such as the door lets in, as saved work.
[[nodiscard]] Status checkThings(const Document& document, int clip);

} // namespace stretch::app
