#pragma once

#include <span>
#include <vector>

#include "app/document.h"

namespace stretch::app {

// Trails that were made as one: listed together, chosen and changed together, until the group is taken apart.

/// Ids of the trails that stand in one group with this one, itself included, in the order of the document;
/// none for a trail that stands alone.
[[nodiscard]] std::vector<int> groupMembers(const Document& document, int trailId);

/// Makes one group of these trails, which leave the groups that they were in. Refused for fewer than two
/// trails, for trails of several clips and for two trails of one limb.
[[nodiscard]] Result<Document> groupTrails(const Document& document, std::span<const int> trailIds);

/// Takes the groups apart that these trails belong to; the trails stay as they are.
[[nodiscard]] Document takeApart(const Document& document, std::span<const int> trailIds);

/// A number that no group has yet.
[[nodiscard]] int freeGroup(const Document& document);

} // namespace stretch::app
