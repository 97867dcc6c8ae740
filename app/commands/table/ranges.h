#pragma once

#include <optional>
#include <string>

#include "app/session.h"

namespace stretch::app {

// Which frames the next trail takes. One rule: selecting a trail makes its range the working range; a range
// that is set by hand deselects a trail that does not lie in it; without either one of the limb's strokes is
// proposed.

/// The moment that is proposed for a limb (rig/moments/moments.h): the one at the playhead, the strongest
/// near it, or the clip's strongest while the playhead stands at its start. Nothing where the limb makes
/// none.
[[nodiscard]] std::optional<rig::Moment> proposedMoment(const Session& session, const std::string& limbId);

/// The range that is proposed for a limb: its proposed moment, or half a second about the playhead where it
/// makes none. At least one frame long where the clip is.
[[nodiscard]] Vec2 proposedRange(const Session& session, const rig::Limb& limb);

/// Whether the working range was set, by hand or by selecting a trail.
[[nodiscard]] bool isRangeSet(const ViewState& view);

/// The working range (x start, y end) within the clip, or the proposed one when none is set.
[[nodiscard]] Vec2 workingRange(const Session& session, const rig::Limb& limb);

/// The range that the timeline shows: the working range of the first selected limb; without one the range
/// that is set, else the whole clip.
[[nodiscard]] Vec2 shownRange(const Session& session);

/// The range of a limb that is exaggerated together with one that leads over its range: its own stroke, as if
/// it were alone, but the leading range where the two share most of their time (limbs that move as one stay
/// together, and one of a limb's strokes that goes along is as good as its strongest if it is half as
/// strong), where the limb makes no stroke, or none there while the playhead stands at a place in time.
[[nodiscard]] Vec2 rangeBeside(const Session& session, const rig::Limb& limb, const Vec2& leading);

/// Returns the range about another stroke of the leading limb, wherever the playhead stands.
[[nodiscard]] Vec2 rangeBesideStroke(const Session& session, const rig::Limb& limb, const Vec2& leading);

/// Whether the stroke goes on where the clip begins again: a limb that is in full swing at both ends of a
/// clip whose last pose is its first makes one stroke there, of which a range holds a part.
[[nodiscard]] bool crossesSeam(const Session& session, const rig::Limb& limb, const rig::Moment& stroke);

/// Sets the working range by hand: a selected trail that does not lie in it is selected no longer.
void setRangeByHand(Session& session, const Vec2& range);

/// The part of the range in which the limb has no trail yet: the one that holds `frame`, else the longest.
/// Nothing when less than a frame is free.
[[nodiscard]] std::optional<Vec2> freeRange(const Document& document, const std::string& limbId, int clip,
                                            const Vec2& range, double frame);

/// A range that was set for new trails, and a trail that is there already and shares only a part of it.
struct RangeClash {
  std::string limb; ///< Limb id.
  Vec2 present{0.0};
  Vec2 wanted{0.0};
  std::optional<Vec2> beside; ///< Range where there is room for another one.
};
/// Nothing when exaggerating the selection leaves no doubt about what is meant.
[[nodiscard]] std::optional<RangeClash> rangeClash(const Session& session);

} // namespace stretch::app
