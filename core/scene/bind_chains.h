#pragma once

#include "core/math/types.h"
#include "core/scene/scene.h"

namespace stretch {

/// Takes the bind leaves of a file that this program wrote for what they are: what deforms with a leaf
/// follows its joint again, as in the file that was stretched, and Scene::bindChains says which leaves give
/// each joint its stretch. So limbs are found and stretched as without leaves, and what is written next
/// reuses them. Leaves that another program changed (moved, or with children of their own) stay ordinary
/// nodes.
void foldBindLeaves(Scene& scene);

/// The influences with each joint once, with all of its weight, and those without weight left out.
[[nodiscard]] VertexInfluences withoutRepeats(const VertexInfluences& vertex);

/// Null when the joint has none.
[[nodiscard]] const BindChain* findBindChain(const Scene& scene, NodeIndex joint);

} // namespace stretch
