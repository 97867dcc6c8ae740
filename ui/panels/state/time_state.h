#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/edits/keys/retime.h"
#include "app/reference/sound.h"
#include "rig/moments/moments.h"
#include "rig/motion/motion.h"
#include "ui/widgets/curve_view.h"
#include "ui/widgets/timeline.h"

namespace stretch::ui {

/// Time as the bottom panes show it, and how it plays.
struct TimelineState {
  double viewStart = 0.0; ///< First visible frame.
  double viewEnd = -1.0;  ///< Last visible frame; < viewStart: fit the clip.
  bool playing = false;
  bool loop = true;
  double speed = 1.0; ///< Multiple of real time.
  bool snapToFrames = true;
  bool everyFrame = false; ///< Each frame is shown, however long it takes; else time runs as it is.
  bool onTwos = false;     ///< Every second frame stands for two.
  double clock = 0.0;      ///< Place that playing has come to, in frames, between what is shown.
  int seenClip = -1;       ///< Clip that viewStart and viewEnd belong to:
  double seenRate = 0.0;   ///< frames per second.
};

enum class GraphChannels { translation, rotation, scale, stretch };
enum class BottomTab { timeline, graph, dopeSheet };

/// Inputs that the curves and keys of one row were made from, but for the frames.
struct GraphRowKey {
  std::optional<CopyOnWrite<Track>> track = {}; ///< Track of the clip, and as the source has it.
  std::optional<CopyOnWrite<Track>> source = {};
  std::vector<rig::Adjustment> adjustments = {};  ///< Adjustments of offset keys.
  std::shared_ptr<const rig::MotionState> motion; ///< Motion, where the result is drawn beside it.

  friend bool operator==(const GraphRowKey&, const GraphRowKey&) = default;
};

/// Inputs that all curves of the graph have in common.
struct GraphKey {
  std::shared_ptr<const std::vector<Clip>> clips = {};
  std::shared_ptr<const rig::MotionState> motion = {};
  std::vector<NodeIndex> nodes = {};
  std::string controller = {};
  GraphChannels channels = GraphChannels::rotation;
  std::string lengthOf = {}; ///< The limb whose length is drawn, and no rows.
  double firstFrame = 0.0;
  double lastFrame = 0.0;
  int clip = 0;
  int theme = 0;

  friend bool operator==(const GraphKey&, const GraphKey&) = default;
};

struct GraphState {
  GraphChannels channels = GraphChannels::rotation;          ///< Channels of joints,
  GraphChannels offsetChannels = GraphChannels::translation; ///< of controllers.
  int joint = 0; ///< Index into what the list of joints and controllers offers.
  bool fitPending = true;
  bool fitPicked = false; ///< The pending fit is about the picked keys.
  bool isolated = false;  ///< Only curves with picked keys are drawn.
  double valueMin = -1.0;
  double valueMax = 1.0;
  std::vector<bool> hidden = std::vector<bool>(3, false); ///< Components switched off in the legend.
  std::vector<Curve> curves;                              ///< Curves as last made, from:
  std::optional<GraphKey> madeFrom;
  std::vector<app::KeyRow> rows;     ///< Rows whose curves they are,
  std::vector<GraphRowKey> madeRows; ///< each made from one of these; curves of a row follow each other.
  std::vector<Span> madeFrames;      ///< The frames that the points of each row are over.
  bool complete = true;              ///< No row waits for a later frame of the window.
  std::optional<app::KeySelection> shownPicks; ///< Picks as the curves mark them.
  CurveGesture gesture;
  app::KeySelection heldKeys; ///< Picked when a drag of keys began.
};

/// Graph and dope sheet: the pane under the mouse owns the keys of the keyboard.
struct KeyPane {
  bool hovered = false;     ///< The mouse is over its keys,
  bool valuesShown = false; ///< which have values there,
  double frame = 0.0;       ///< here.
  double value = 0.0;       ///< Shown units.
  double valueStep = 1.0;   ///< Step by which Up and Down move keys.
  bool pressTaken = false;  ///< The press that ended a tool means nothing else.
};

/// A range of keys that is to take another time.
struct RetimeState {
  bool open = false;
  bool wasOpen = false; ///< In the frame before.
  double firstFrame = 0.0;
  double lastFrame = 0.0;
  double newFrames = 0.0;
  bool movesAfter = true;
  std::string limb = {};                  ///< Only its keys; empty: those of the whole clip.
  std::optional<app::Retime> looked = {}; ///< What follows is about this.
  std::string ends = {};                  ///< Frame where the clip will end,
  std::vector<std::string> past = {};     ///< and what will stand past its end that does not now.
  std::string problem = {};               ///< Why it cannot be done; empty: it can.
};

/// Keys of the rows of the timeline and the dope sheet, as last gathered.
struct KeyRowsState {
  std::shared_ptr<const rig::MotionState> motion = {};
  std::shared_ptr<const std::vector<Clip>> clips = {};
  std::vector<std::string> selected = {}; ///< Limbs and controllers.
  bool everyLimb = false;
  std::vector<KeyRow> rows = {};
  std::vector<std::vector<app::KeyRow>> keyed = {}; ///< Keyed rows that each of the rows stands for.
  std::optional<app::KeySelection> shownPicks = {}; ///< Picks as the rows mark them.
};

/// Keys that were picked, and what was selected then.
struct KeptPicks {
  app::KeySelection keys = {};
  int clip = 0;
  std::vector<std::string> limbs = {};
  std::vector<std::string> controllers = {};
  std::weak_ptr<const std::vector<Clip>> clips = {}; ///< That they are of: places of keys say nothing of
                                                     ///< others.
};

/// The sound of the clip's reference.
struct ShownSound {
  std::shared_ptr<const app::Sound> sound = {}; ///< Null: none, or not read yet.
  double startFrame = 0.0;
  std::string name = {};
};

/// The panes below the picture: timeline, graph and dope sheet.
struct TimePanes {
  TimelineState timeline;
  GraphState graph;
  ShownSound sound;
  KeyPane keys;
  KeyRowsState rows;
  std::shared_ptr<const KeptPicks> picks = {};                          ///< In the last frame,
  std::map<std::size_t, std::shared_ptr<const KeptPicks>> picksAt = {}; ///< and at places of the history.
  RetimeState retime;
  BottomTab tab = BottomTab::timeline;
  TimelineGesture gesture;
  std::string clipFilter;                   ///< Typed into the list of clips.
  std::optional<rig::Moment> hoveredMoment; ///< Its mark lies under the mouse: the viewport shows the path.
};

} // namespace stretch::ui
