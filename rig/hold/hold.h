#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/math/types.h"
#include "rig/controllers/adjustment.h"

namespace stretch::rig {

// Holds keep the end of a limb, or a thing in a hand, over a part of one clip (docs/holds.md). Hands and feet
// are named by their limb: "left-arm", "right-leg".

enum class HoldKind { pin, grip, prop };

/// When something is held. It is fully held over the range and comes and goes beside it.
struct HoldTime {
  Vec2 rangeFrames{0.0};
  Vec2 blendFrames{0.0}; ///< How long it takes to come before the range, and to go after it.

  friend bool operator==(const HoldTime&, const HoldTime&) = default;
};

/// A place in the world, and how the joint of a hand or foot is turned there.
struct HeldPlace {
  Vec3 position{0.0};
  Quat orientation{1.0, 0.0, 0.0, 0.0};

  friend bool operator==(const HeldPlace&, const HeldPlace&) = default;
};

/// A hand or foot that stays at a place in the world.
struct Pin {
  std::string limb;
  int clip = 0; ///< Index into the file's animations.
  HoldTime time;
  double atFrame = 0.0; ///< Holds it where the adjusted clip has it at this frame, unless `place` is given.
  std::optional<HeldPlace> place; ///< Instead of that.
  bool turns = true;              ///< Its orientation is held, too.
  double stretch = 1.0;           ///< 0..1: 1: the limb stretches to stay; 0: it falls short.

  friend bool operator==(const Pin&, const Pin&) = default;
};

/// A hand or foot that stays where it is seen from another one.
struct Grip {
  std::string follower;
  std::string leader;
  int clip = 0;
  HoldTime time;
  std::optional<double> relationFrame; ///< Frame whose relation holds, in the adjusted clip; none: at each
                                       ///< frame its own.
  double stretch = 1.0;                ///< Read like Pin::stretch.

  friend bool operator==(const Grip&, const Grip&) = default;
};

/// Between two `auto` keys of firmness the value of the first is held; over so many frames before the second,
/// or all that there are, it becomes the second's.
inline constexpr double firmnessFadeFrames = 3.0;

/// How firmly one hand holds a prop, over time.
struct PropHand {
  std::string limb;
  std::vector<OffsetKey> keys; ///< Values 0..1, ascending by frame; held before the first and after the last.

  friend bool operator==(const PropHand&, const PropHand&) = default;
};

/// A node that is held by one hand or by both. It stands between the hands by their shares, and each hand
/// stays on it as firmly as it holds it.
struct Prop {
  std::string node; ///< Its name, or "#index".
  int clip = 0;
  std::optional<HoldTime> time;           ///< None: the whole clip.
  std::optional<double> boundFrame = 0.0; ///< Hands and prop are related as the adjusted clip has them at
                                          ///< this frame; none: as it has them at each frame.
  Vec3 move{0.0}; ///< How far the prop is brought from there before it is bound: world units and
  Vec3 turn{0.0}; ///< a rotation vector about its place, along the scene's axes.
  std::vector<PropHand> hands;
  double stretch = 1.0; ///< Read like Pin::stretch, for the arms.

  friend bool operator==(const Prop&, const Prop&) = default;
};

/// All holds of a clip, or of a document.
struct Holds {
  std::vector<Pin> pins;
  std::vector<Grip> grips;
  std::vector<Prop> props;

  [[nodiscard]] bool empty() const { return pins.empty() && grips.empty() && props.empty(); }
  friend bool operator==(const Holds&, const Holds&) = default;
};

/// The frames over which a hold has any effect: its range with the blends beside it.
[[nodiscard]] inline Vec2 touchedFrames(const HoldTime& time) {
  return {time.rangeFrames.x - time.blendFrames.x, time.rangeFrames.y + time.blendFrames.y};
}

} // namespace stretch::rig
