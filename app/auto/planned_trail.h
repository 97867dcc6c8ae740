#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/auto/clip_ground.h"
#include "app/auto/exaggerate_clip.h"

namespace stretch::app {

inline constexpr double shortestRange = 2.0; ///< Frames of a trail.
inline constexpr double fullStrength = 6.0;  ///< Reaches per second: from here on a moment gets all of a
                                             ///< style.
inline constexpr double fullChain = 2.0;     ///< Likewise of necks, tails and the like, as long as the body.

/// A trail that is thought of for a moment.
struct PlannedTrail {
  std::size_t moment = 0; ///< Place in the list of moments.
  rig::Trail trail;
  std::string why = {};                          ///< Why it has less than its style asks for.
  std::optional<rig::TrailSettings> looked = {}; ///< Settings with which it looked right by itself.
  bool follows = false; ///< The spine's, which goes along with the moment's limb and has no moment of its
                        ///< own.
  bool isBent = false;  ///< Its bend is part of the pose that it comes to: straightened, its end would point
                        ///< elsewhere.
};

/// Trails for a clip, and why the other moments have none.
struct AutoPlan {
  std::vector<PlannedTrail> trails;
  std::vector<std::string> leftOut; ///< One for each moment; empty: not left out.
  rig::Holds holds;                 ///< Grips and props that keep hands on things.
  bool loops = false;               ///< The clip is to be played as a loop.
};

/// Chooses range, way back and settings of a trail for each moment that can have one; of one that is weak
/// where the other side does the same. `refused`: moments that cannot have one, by their place, and why.
[[nodiscard]] AutoPlan planTrails(const ClipGround& ground, const std::vector<rig::Moment>& moments,
                                  const AutoSettings& settings,
                                  const std::map<std::size_t, std::string>& refused);

/// Lowers or leaves out what does not look right: first each trail by itself, then all together; a limb that
/// goes round and round does so only with its counterpart on the other side, and what both do at once is as
/// large on both. `moments`: those of the plan.
void settle(const ClipGround& ground, const std::vector<rig::Moment>& moments, const AutoSettings& settings,
            AutoPlan& plan);

/// Whether two moments are of both sides, which do the same: at once or, going round, in turn.
[[nodiscard]] bool arePartners(const ClipGround& ground, const rig::Moment& one, const rig::Moment& other);

/// Whether a limb is a neck, a spine, a tail or a feeler.
[[nodiscard]] bool isChain(const rig::Limb& limb);

/// fullStrength or fullChain.
[[nodiscard]] double fullStrengthOf(const rig::Limb& limb);

/// Whether a wing does it over and over, which carries the body.
[[nodiscard]] bool isBeat(const rig::Limb& limb, const rig::Moment& moment);

/// Whether a flying body does something by it: a clear stroke of what is neither a wing nor a chain. Wings
/// hang on a spine: stretched, it would tear them off.
[[nodiscard]] bool isAct(const rig::Limb& limb, const rig::Moment& moment);

/// Frames over which a trail does anything, its way back included as far as it is known.
[[nodiscard]] Vec2 windowOf(const rig::TrailSettings& settings);

/// Settings with a share of the exaggeration of `wanted`: of its scale and of what its spheres are pulled.
[[nodiscard]] rig::TrailSettings withShare(rig::TrailSettings wanted, double share);

/// Pulls a trail's path by spheres: not at all at the start of its range, evenly more along it, and by
/// `pull` (world units) at its tip.
void pullAlong(PlannedTrail& planned, const Vec3& pull);

/// Takes the trail at `place` out of the plan, and what goes along with it.
void leaveOut(AutoPlan& plan, std::size_t place, const std::string& why);

} // namespace stretch::app
