#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/editing.h"
#include "app/edits/keys/key_edits.h"
#include "app/edits/pose/offset_edits.h"
#include "app/edits/pose/seen_pose.h"
#include "app/evaluate/cache.h"
#include "app/evaluate/pops.h"
#include "app/schema/saved_form.h"
#include "app/selection.h"
#include "rig/moments/moments.h"
#include "rig/rekey/key_places.h"

namespace stretch::app {

/// Offsets of controllers at one frame without a key: what was posed while auto-key is off. It is
/// dropped when the playhead leaves the frame.
struct UnkeyedPose {
  int clip = 0;
  double frame = 0.0;
  std::map<std::string, ControllerOffset> offsets; ///< By id, and so are values.
  std::map<std::string, double> values;

  [[nodiscard]] bool empty() const { return offsets.empty() && values.empty(); }
  friend bool operator==(const UnkeyedPose&, const UnkeyedPose&) = default;
};

/// Selection and playhead: not part of the document, not undone (except that undo
/// keeps it valid).
struct ViewState {
  int clip = 0;
  double frame = 0.0; ///< Playhead, in frames of the clip.
  Selection selection;
  bool mirrorLocators = true; ///< Whatever moves a locator moves its counterpart.
  bool showLocators = false;  ///< Also while joints stand at them: to be moved and bound again.
  bool autoKey = true;        ///< A pose is keyed at once.
  bool wholeClip = false;     ///< First keys act on the whole clip, not in the working range alone.
  UnkeyedPose unkeyed;
  double rangeStart = 0.0;   ///< The working range, for new trails.
  double rangeEnd = -1.0;    ///< < rangeStart: the stroke around the playhead is proposed.
  bool showOriginal = false; ///< While held: the character as it was.
  Mat3 cameraAxes{1.0}; ///< World columns of the view: right, up, towards the viewer; kept by the viewport.
  CameraPlace camera;   ///< The view itself; kept by the viewport.
  std::optional<rig::Trail> copiedTrail; ///< Trail that Paste pastes.
  /// The same while controllers are selected: what was seen, or offsets with moves in lengths of the
  /// controller (rig::Controller::length).
  std::optional<std::variant<SeenPose, OffsetPose>> copiedPose;
  KeySelection pickedKeys;                           ///< Keys of the viewed clip, in graph and dope sheet.
  int pickedClip = 0;                                ///< The clip that they are of.
  rig::KeyPlaces keyPlaces = rig::KeyPlaces::needed; ///< Places where saving writes keys; kept by the window.
  std::vector<KeyRow> keyRows;                       ///< Those that the graph or the dope sheet shows,
  std::map<KeyRow, unsigned> keyComponents;          ///< and bits of the components that do; none: all.
  std::optional<CopiedKeys> copiedKeys;              ///< Keys that Paste pastes there.
};

/// Whether something is posed at the playhead without a key.
[[nodiscard]] bool isPosedWithoutKey(const ViewState& view);

/// One open character being edited: the door for its edits, what is looked at, and the caches.
class Session : public Editing<Document> {
public:
  explicit Session(Document document);

  [[nodiscard]] ViewState& view() { return view_; }
  [[nodiscard]] const ViewState& view() const { return view_; }

  /// The character at a frame of the viewed clip, trails and weight included, at the playhead with what is
  /// posed there without a key; cached by identity.
  [[nodiscard]] const FrameState& frameAt(double frame);
  /// Returns what is looked at: the bind pose while locators are shown, which stand there; else as frameAt
  /// says.
  [[nodiscard]] const FrameState& shownAt(double frame);
  /// Returns the frame without any of them.
  [[nodiscard]] const FrameState& originalAt(double frame);
  /// The document with what is posed at the playhead without a key.
  [[nodiscard]] const Document& posedDocument();
  /// Returns the places of all controllers at a frame of the viewed clip, as frameAt shows it, and what each
  /// is drawn as.
  [[nodiscard]] const std::vector<rig::PlacedController>& controllersAt(double frame);
  [[nodiscard]] const std::vector<rig::ControllerShape>& controllerShapes();
  /// The prepared trails of the viewed clip.
  [[nodiscard]] const rig::MotionState& motion();
  /// Returns the motion, kept alive: another one is there as soon as anything about the trails is different.
  [[nodiscard]] std::shared_ptr<const rig::MotionState> sharedMotion();
  /// The paths of these trails, one for each trail of motion(). The document has clips.
  [[nodiscard]] const std::vector<TrailPaths>& paths(std::size_t samplesPerFrame);

  /// The viewed clip with the keys that its applied trails make: what timeline and graph show. The document
  /// has clips.
  [[nodiscard]] const Clip& shownClip();

  /// Reports what the limbs of the viewed clip that have weight come to.
  [[nodiscard]] const std::vector<WeightReport>& weightReports();

  /// Pops of elbows and knees (limbPops) for some two seconds around the playhead; during a drag those before
  /// it.
  [[nodiscard]] const std::vector<LimbPop>& pops();

  /// Returns where the next plain save goes: back to a file that carries our work; else empty until the user
  /// saved once, so that the source is never overwritten by the first save.
  [[nodiscard]] const std::filesystem::path& savePath() const { return savePath_; }
  /// That, or another name beside the source; in the user's documents for a bundled clip and for one whose
  /// folder cannot be written.
  [[nodiscard]] std::filesystem::path proposedSavePath() const;
  /// Returns SavedEdits::missOfHeight.
  Result<double> save(const std::filesystem::path& path, bool clean, const SavedForm& form = {});

  /// The moments of the viewed clip, which exists, strongest first; while something is dragged those before.
  [[nodiscard]] const std::vector<rig::Moment>& moments() const;
  /// Those of one limb, in order of time.
  [[nodiscard]] std::vector<rig::Moment> momentsOf(const std::string& limbId) const;

  /// The working range follows the selected trail: whenever another one is selected, or its range changes.
  void followSelection();
  /// Returns the working range that was set by hand, also while a selected trail's has taken its place;
  /// nothing where none was.
  [[nodiscard]] std::optional<Vec2> rangeByHand() const;

private:
  /// Drops what is selected and is not there any more; selects the one trail that came back.
  void documentChanged() override;

  struct MomentsKey {
    std::shared_ptr<const Scene> scene;
    std::shared_ptr<const std::vector<Clip>> clips;
    int clip = -1;
    std::vector<rig::Limb> limbs;
    NodeIndex hips;
    friend bool operator==(const MomentsKey&, const MomentsKey&) = default;
  };
  struct Followed {
    int trail = 0;
    double startFrame = 0.0;
    double endFrame = 0.0;
    friend bool operator==(const Followed&, const Followed&) = default;
  };

  /// The document with what is posed at this frame without a key; null where nothing is.
  [[nodiscard]] const Document* posedWithoutKey(double frame);

  struct Posed {
    UnkeyedPose pose;
    Document made; ///< From this one:
    Document from;
    EvaluationCache cache;
  };

  struct PopsKey {
    std::shared_ptr<const rig::MotionState> motion;
    FrameSpan frames;
    friend bool operator==(const PopsKey&, const PopsKey&) = default;
  };

  ViewState view_;
  EvaluationCache cache_;
  LastAnswer<PopsKey, std::vector<LimbPop>> pops_;
  FrameState bindPose_; ///< Bind pose of this scene:
  std::shared_ptr<const Scene> bindPoseOf_;
  std::optional<Posed> posed_;
  mutable LastAnswer<MomentsKey, std::vector<rig::Moment>> moments_;
  void followClips(); ///< The viewed clip is one that is there.
  void followRate();  ///< Playhead, range and what was copied stay where they are in time.
  void keepSelectedTrail(const std::vector<int>& appeared);
  void keepHandles();
  void keepPickedKeys();

  struct Viewed {
    int clip = 0;
    double frame = 0.0;
  };
  std::size_t knownClips_ = 0;                 ///< Number of clips, as last shown.
  std::map<std::size_t, Viewed> viewedBefore_; ///< Place viewed when there came to be so many.
  Followed followed_;
  std::optional<Vec2> rangeBefore_; ///< The working range before a trail's took its place; nothing: none was
                                    ///< set.
  Followed lost_; ///< Selection that was there when undo took it away: redo selects it again.
  std::vector<double> lostSpheres_;
  int ratedClip_ = -1; ///< Clip whose rate was this:
  double rate_ = 0.0;
  std::vector<int> knownTrails_; ///< Ids, as last shown.
  std::filesystem::path savePath_;
};

} // namespace stretch::app
