#pragma once

#include <array>
#include <string>
#include <string_view>

namespace stretch::rig::body {

/// Places in a biped that a joint can have.
enum class Role {
  clavicle,
  upperArm,
  foreArm,
  wrist,
  thigh,
  shin,
  ankle,
  toe,
  hips,
  spine,
  chest,
  neck,
  head
};
inline constexpr std::size_t roleCount = 13;

enum class Side { none, left, right };

/// Evidence about a joint from its name alone.
struct NameEvidence {
  std::array<double, roleCount> roles{}; ///< 0..1 each: how well the name fits the role; several may fit.
  Side side = Side::none;
  bool twist = false;
  bool control = false;
  bool end = false;
  bool finger = false;
  bool palm = false;
  bool accessory = false; ///< Belongs to neither limb nor trunk; parts of a face are among them.
  bool face = false;
  bool fin = false; ///< Named so, and nothing of an arm or a leg.
  std::string key;  ///< The name without its side and case: equal for the two of a mirrored pair. May be
                    ///< empty.

  [[nodiscard]] double role(Role which) const { return roles[static_cast<std::size_t>(which)]; }
};

/// Reads a joint name. "Shoulder", "arm", "leg" and "hip" mean different joints in different schemes, so they
/// answer several roles at once; position in the chain decides.
[[nodiscard]] NameEvidence readName(std::string_view name);

} // namespace stretch::rig::body
