#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/commands/table/ranges.h"
#include "app/commands/trail/exaggerate.h"
#include "app/edits/keys/retime.h"
#include "app/file_work.h"
#include "app/files/file_facts.h"
#include "rig/motion/motion.h"
#include "ui/widgets/curve_view.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/timeline.h"

namespace stretch::ui {

enum class NavigationStyle { maya, blender };

/// What the viewport draws over the character.
struct ViewportOverlays {
  bool controllers = false; ///< Else only while one is selected.
  bool skeleton = false;
  bool wire = false;
  bool jointNames = false;
  bool heatMap = false; ///< Stretch of the mesh as colour.
  bool weights = false; ///< Of one joint (WeightView), as colour.
  bool ghosts = false;
  bool grid = true;
  bool trailFrameNumbers = false;
  bool trailTicks = true;
  bool sideBySide = false;             ///< Original beside exaggerated.
  bool trailsOnlyWhenSelected = false; ///< Else every visible trail is drawn.
  int ghostsBefore = 3;
  int ghostsAfter = 3;
  int ghostStepFrames = 2;
  bool trailWindow = false; ///< Draw only `trailWindowFrames` around the playhead.
  int trailWindowFrames = 12;
  float trailThickness = 3.0F; ///< Design pixels.
  float sphereSize = 7.0F;     ///< Radius, design pixels.
  double trailIncrement = 0.5; ///< Frames between drawn samples.

  friend bool operator==(const ViewportOverlays&, const ViewportOverlays&) = default;
};

/// Time as the bottom panes show it, and how it plays.
struct TimelineState {
  double viewStart = 0.0; ///< First visible frame.
  double viewEnd = -1.0;  ///< Last visible frame; < viewStart: fit the clip.
  bool playing = false;
  bool loop = true;
  double speed = 1.0; ///< Of real time.
  bool snapToFrames = true;
  bool everyFrame = false; ///< Each frame is shown, however long it takes; else time runs as it is.
  bool onTwos = false;     ///< Every second frame stands for two.
  double clock = 0.0;      ///< Where playing has come to, in frames, between what is shown.
  int seenClip = -1;       ///< What viewStart and viewEnd belong to:
  double seenRate = 0.0;   ///< frames per second.
};

/// What a menu at the mouse is about.
enum class MenuTarget { nothing, limb, trail, group, sphere, controller, hold, key, range, time, viewport };

/// A trail, or a group of trails, that is given a name.
struct RenameState {
  bool open = false;
  int trail = 0; ///< Id; of one in the group.
  bool ofGroup = false;
  std::string present = {}; ///< What it is called.
  std::string typed = {};
  bool wasOpen = false; ///< In the frame before.
};

/// The list of what was done.
struct HistoryState {
  bool open = false;
  int highlighted = -1; ///< Row that the keys are on.
  bool wasOpen = false; ///< In the frame before.
};

enum class GraphChannels { translation, rotation, scale, stretch };
enum class BottomTab { timeline, graph, dopeSheet };

/// What the curves and keys of one row were made from, but for the frames.
struct GraphRowKey {
  std::optional<CopyOnWrite<Track>> track = {}; ///< Of the clip, and as the source has it.
  std::optional<CopyOnWrite<Track>> source = {};
  std::vector<rig::Adjustment> adjustments = {};  ///< Of offset keys.
  std::shared_ptr<const rig::MotionState> motion; ///< Where the result is drawn beside it.

  friend bool operator==(const GraphRowKey&, const GraphRowKey&) = default;
};

/// What all curves of the graph have in common.
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
  GraphChannels channels = GraphChannels::rotation;          ///< Of joints,
  GraphChannels offsetChannels = GraphChannels::translation; ///< of controllers.
  int joint = 0; ///< Index into what the list of joints and controllers offers.
  bool fitPending = true;
  bool fitPicked = false; ///< The pending fit is about the picked keys.
  bool isolated = false;  ///< Only curves with picked keys are drawn.
  double valueMin = -1.0;
  double valueMax = 1.0;
  std::vector<bool> hidden = std::vector<bool>(3, false); ///< Components switched off in the legend.
  std::vector<Curve> curves;                              ///< As last made, from:
  std::optional<GraphKey> madeFrom;
  std::vector<app::KeyRow> rows;     ///< Whose curves they are,
  std::vector<GraphRowKey> madeRows; ///< each made from one of these; curves of a row follow each other.
  std::vector<Span> madeFrames;      ///< The frames that the points of each row are over.
  bool complete = true;              ///< No row waits for a later frame of the window.
  std::optional<app::KeySelection> shownPicks; ///< As the curves mark them.
  CurveGesture gesture;
  app::KeySelection heldKeys; ///< Picked when a drag of keys began.
};

/// Graph and dope sheet: the pane under the mouse owns the keys of the keyboard.
struct KeyPane {
  bool hovered = false;     ///< The mouse is over its keys,
  bool valuesShown = false; ///< which have values there,
  double frame = 0.0;       ///< here.
  double value = 0.0;       ///< Shown units.
  double valueStep = 1.0;   ///< What Up and Down move keys by.
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
  std::string ends = {};                  ///< Where the clip will end,
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
  std::vector<std::vector<app::KeyRow>> keyed = {}; ///< What each of the rows stands for.
  std::optional<app::KeySelection> shownPicks = {}; ///< As the rows mark them.
};

/// What an animator would stumble over in the selected trail, as last looked for.
struct LookState {
  std::shared_ptr<const rig::MotionState> motion = {}; ///< Looked at in this one; null: not yet.
  int trailId = 0;
  std::vector<std::string> warnings = {};
  bool clipCouldLoop = false;                      ///< Marking the clip as a loop mends the way back.
  std::shared_ptr<const rig::MotionState> waiting; ///< A newer one, while it still changes,
  double waitingSince = 0.0;                       ///< seconds of the window's clock.
  bool bodyTravels = false;                        ///< Why a new trail there starts in the space root.
};

/// The style that was taken last, and for which trails of which character.
struct TakenStyle {
  std::shared_ptr<const Scene> scene = {}; ///< Null: none was taken.
  std::vector<int> trails = {};            ///< Ids.
  int style = 0;                           ///< Into app::styles().
};

/// Where a menu opens that leaves uncovered what it is about, window units.
struct MenuPlace {
  float x = 0.0F;
  float top = 0.0F;    ///< Of what it is about:
  float bottom = 0.0F; ///< the menu ends above it, or begins below it.
};

/// Choosing joints from the skeleton tree: a limb's correction or a new chain.
struct JointPick {
  bool open = false;
  std::string limbId; ///< Limb to correct; empty: a new chain.
  NodeIndex baseNode;
  NodeIndex endNode;
  std::string filter;
  std::string message; ///< Why the last try was refused.
};

/// Whose weights the viewport shows (ui/panels/body/weight_view.h).
struct WeightView {
  NodeIndex joint;                           ///< None, or one that no mesh follows: the first that one does.
  std::vector<std::string> limbs = {};       ///< That were selected when it was chosen,
  std::vector<std::string> controllers = {}; ///< and controllers.
  std::string filter = {};                   ///< Typed into the list of joints.
};

enum class FilePurpose {
  openModel,
  saveModel,
  exportClean,
  openRecipe,
  openProp,
  openClip,
  saveRecipe,
  saveFrames,
  exportSequence,
  openModuli,
  saveModuli,
  openSkeleton
};

/// One row of a folder's listing.
struct FileEntry {
  std::string name;
  bool isFolder = false;
  std::uintmax_t bytes = 0;
};

/// What the editor offers while nothing is open.
struct WelcomeState {
  int highlighted = 0;  ///< Entry that the keys are on.
  int columns = 1;      ///< Of the entries that have pictures, as they were drawn last.
  bool entered = false; ///< The highlighted entry is to be opened.
  bool moved = false;   ///< The highlight has not been scrolled to yet.
};

/// The tour through the first punch.
struct TourState {
  bool pending = false; ///< It begins when the bundled punch is opened.
  int step = -1;        ///< -1: it does not run.
};

/// To open: set `open`, `purpose`, and, where known, `folder` and `typed` (the proposed name); the rest as it
/// is here.
struct FileDialogState {
  bool open = false;
  FilePurpose purpose = FilePurpose::openModel;
  std::filesystem::path folder;
  std::string typed;    ///< Name, path, or part of a name, as typed.
  int highlighted = -1; ///< Row that the keys are on; -1 none.
  std::string message;
  bool confirmOverwrite = false;      ///< The file exists; saving once more replaces it.
  std::filesystem::path listedFolder; ///< What `entries` lists.
  std::vector<FileEntry> entries;
  bool listsSequence = false;           ///< The listed folder can be opened as a mesh sequence.
  int type = 0;                         ///< Of files that are shown: index into fileTypesOf().
  std::optional<std::string> newFolder; ///< Name of a folder to be made, while it is typed.
  std::filesystem::path factsPath;      ///< What `facts` tells of.
  app::FileFacts facts;
  bool wasOpen = false; ///< In the frame before.
};

struct PaletteState {
  bool open = false;
  std::string typed;
  int highlighted = 0;
  bool wasOpen = false; ///< In the frame before.
};

struct KeysOverviewState {
  bool open = false;
  std::string filter;
  std::string waitingFor; ///< Command id whose new key is awaited; empty: none.
  std::string clash;      ///< Told after a refused or shared key.
};

using ToastKind = app::Tone;

struct Toast {
  ToastKind kind = ToastKind::info;
  std::string text;
  float secondsLeft = 4.0F;
};

struct KeyHint {
  std::string key;  ///< "Enter"
  std::string does; ///< "keep"
};

struct FileChoice {
  FilePurpose purpose = FilePurpose::openModel;
  std::filesystem::path path;
};

/// A file that was dropped on the open character, and that need not be opened in its place.
struct DroppedFile {
  std::filesystem::path path; ///< Empty: none is asked about.
  bool canBeHeld = false;     ///< By a hand: it is a thing.
  bool hasClips = false;
};

/// What is to become of it.
struct DropAnswer {
  std::filesystem::path file;
  FilePurpose purpose = FilePurpose::openModel; ///< Or openProp, or openClip.
};

/// Which clips of another file are to be imported.
struct ClipAnswer {
  std::filesystem::path file;
  int clip = -1; ///< Of `file`; -1: all of them.
};

/// Choosing one of the clips of another file.
struct ClipPick {
  std::filesystem::path file; ///< Empty: nothing is asked.
  std::vector<app::FileFacts::ClipFacts> clips;
  std::string filter;
  int highlighted = 0;  ///< Of those that the filter leaves.
  bool wasOpen = false; ///< In the frame before.
};

struct KeyChange {
  std::string commandId;
  std::string keyText; ///< As Command::keys spells it; empty: no key.
};

/// What the user decided in a dialog, for the shell to take (and reset) in the same frame.
struct UiAnswers {
  std::optional<FileChoice> file;
  std::optional<app::FileAnswer> question; ///< To EditorStatus::question.
  std::optional<NavigationStyle> navigation;
  std::optional<KeyChange> keyChange;
  std::optional<app::OverlapChoice> overlap; ///< To UiState::rangeClash.
  std::optional<DropAnswer> drop;            ///< To UiState::dropped.
  std::optional<ClipAnswer> clip;            ///< To UiState::clipPick.
  bool resetKeys = false;
  bool themeChanged = false; ///< `theme` or `scale` below was changed.
  bool keepSettings = false; ///< The user's settings are to be written at once.
};

/// One step of the tour, as its card shows it.
struct TourCard {
  int step = 0; ///< From 0.
  int steps = 0;
  std::string title;
  std::string text;
  std::string key; ///< What to press.
};

/// What is going on in this frame, as the panels show it: made anew for each one.
struct EditorStatus {
  std::string fileName;          ///< Of what is open; empty: nothing is.
  bool unsaved = false;          ///< It holds work that no file has.
  app::FileQuestion question;    ///< Answered by UiAnswers::question.
  std::string modalText;         ///< "left arm x3.00, axes X Z": empty outside a modal.
  std::vector<KeyHint> keyHints; ///< What the keys do in a modal.
  std::string busyText;          ///< "Opening punch.glb": work in progress; empty: none.
  float busyFraction = -1.0F;    ///< 0..1; < 0 unknown.
  std::string pressedKey;       ///< Pressed in this frame, as Command::keys spells it: for the keys overview.
  std::optional<TourCard> tour; ///< While it runs.
};

/// View state of all panels: no widget keeps anything anywhere else. Not part of the document, not undone.
struct UiState {
  ThemeKind theme = ThemeKind::dark;
  float scale = 1.0F; ///< The user's factor on top of the screen's.
  NavigationStyle navigation = NavigationStyle::maya;
  bool exaggerateAtTip = false; ///< E moves the playhead to the tip; else a ghost shows the pose there.
  ViewportOverlays overlays;
  TimelineState timeline;
  GraphState graph;
  KeyPane keyPane;
  RetimeState retime;
  KeyRowsState keyRows;
  LookState look;
  TakenStyle takenStyle;
  BottomTab bottomTab = BottomTab::timeline;
  JointPick jointPick;
  WeightView weights;
  FileDialogState fileDialog;
  PaletteState palette;
  KeysOverviewState keys;
  MenuTarget menuAsked = MenuTarget::nothing;  ///< To be opened in this frame.
  MenuTarget menuTarget = MenuTarget::nothing; ///< Of the menu that was opened last.
  int menuHold = 0;                            ///< TimelineBar::id of the hold that the menu is about.
  double menuFrame = 0.0;                      ///< Where it was opened in the timeline.
  std::optional<MenuPlace> menuPlace;          ///< Else at the mouse.
  RenameState rename;
  std::string clipFilter;  ///< Typed into the list of clips.
  std::string jointFilter; ///< Typed into the list of joints.
  double tween = 0.5;      ///< Of the tween that is dragged, from key (0) to key (1).
  HistoryState history;
  std::map<std::string, std::string> typedTexts; ///< Text of settings that are typed, for each field.
  bool settingsOpen = false;
  bool aboutOpen = false;
  bool navigationChoiceOpen = false; ///< The first start.
  WelcomeState welcome;
  TourState tour;
  std::optional<app::RangeClash> rangeClash; ///< Asked about; none: nothing is.
  DroppedFile dropped;
  ClipPick clipPick;
  std::vector<std::filesystem::path> recentFiles;
  std::vector<Toast> toasts;
  std::string expandedLimb;                ///< Limb whose reasons the rig panel shows.
  std::vector<std::string> closedSections; ///< Ids of collapsed sections of panels.
  bool allWarnings = false;                ///< Every warning of the trail is listed, not the first alone.

  UiAnswers answers;

  // Between frames of one gesture.
  bool panelDrag = false; ///< The session's drag was begun by a panel.
  TimelineGesture timelineGesture;
};

} // namespace stretch::ui
