#pragma once

#include <string>
#include <vector>

#include "app/schema/schema.h"
#include "rig/controllers/adjustment.h"

namespace stretch::app {

/// Units of the numbers of an adjustment where they are written: lengths in world units, angles in
/// radians.
struct AdjustmentUnits {
  double length = 1.0;
  double angle = 1.0;
};

/// Name in an entry of the list "adjustments": a controller or an attribute.
struct AdjustedName {
  std::string id;
  bool isAttribute = false;
};

/// An error when the entry names neither, or both.
[[nodiscard]] Result<AdjustedName> adjustedName(const gltf::Json& json);

/// The keys of an adjustment, or of anything else that is keyed so.
[[nodiscard]] gltf::Json offsetKeysToJson(const std::vector<rig::OffsetKey>& keys, bool isAttribute,
                                          const AdjustmentUnits& units);
/// In the order of their frames. Errors name the key.
[[nodiscard]] Result<std::vector<rig::OffsetKey>> offsetKeysFromJson(const gltf::Json& json, bool isAttribute,
                                                                     const AdjustmentUnits& units);

/// Everything but the clip.
[[nodiscard]] gltf::Json adjustmentToJson(const rig::Adjustment& adjustment, bool isAttribute,
                                          const AdjustmentUnits& units);

/// Reads what adjustmentToJson writes. `allowed` names further keys that the caller reads itself. A key of
/// the wrong kind, an unknown one and an interpolation that does not exist are errors that name them.
[[nodiscard]] Result<rig::Adjustment> adjustmentFromJson(const gltf::Json& json, const AdjustmentUnits& units,
                                                         const std::vector<std::string>& allowed);

} // namespace stretch::app
