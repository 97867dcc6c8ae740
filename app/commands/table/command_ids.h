#pragma once

#include <array>

/// Ids of all commands: the tables define what each does, panels and keys ask for it. A test fails when one
/// has no command, or when an id is spelled out anywhere else.
namespace stretch::app::command {

inline constexpr const char* fileOpen = "file.open";
inline constexpr const char* fileSave = "file.save";
inline constexpr const char* fileSaveAs = "file.save-as";
inline constexpr const char* fileSaveIncremental = "file.save-incremental";
inline constexpr const char* fileExportClean = "file.export-clean";
inline constexpr const char* fileFilm = "file.film";
inline constexpr const char* fileQuit = "file.quit";
inline constexpr const char* recipeSave = "recipe.save";
inline constexpr const char* recipeLoad = "recipe.load";
inline constexpr const char* styleTake = "style.take";
inline constexpr const char* styleImport = "style.import";
inline constexpr const char* styleExport = "style.export";

inline constexpr const char* undo = "edit.undo";
inline constexpr const char* redo = "edit.redo";
inline constexpr const char* history = "edit.history";
inline constexpr const char* copyTrail = "trail.copy";
inline constexpr const char* pasteTrail = "trail.paste";
inline constexpr const char* mirrorTrail = "trail.mirror";

inline constexpr const char* selectLeftArm = "limb.left-arm";
inline constexpr const char* selectRightArm = "limb.right-arm";
inline constexpr const char* selectLeftLeg = "limb.left-leg";
inline constexpr const char* selectRightLeg = "limb.right-leg";
inline constexpr const char* selectSpine = "limb.spine";
inline constexpr const char* selectNeck = "limb.neck";
inline constexpr const char* selectSeventh = "limb.seventh";
inline constexpr const char* selectEighth = "limb.eighth";
inline constexpr const char* selectNinth = "limb.ninth";
/// Commands of the keys 1 to 9: limbs in the order in which the diagram shows them. Named by a biped's.
inline constexpr std::array<const char*, 9> limbSlots{selectLeftArm,  selectRightArm, selectLeftLeg,
                                                      selectRightLeg, selectSpine,    selectNeck,
                                                      selectSeventh,  selectEighth,   selectNinth};
inline constexpr const char* selectNone = "limb.none";
inline constexpr const char* selectionKeep = "selection.keep";
inline constexpr const char* selectionRename = "selection.rename";
inline constexpr const char* selectionForget = "selection.forget";
inline constexpr const char* selectionNext = "selection.next";
inline constexpr const char* pickChain = "limb.chain";
inline constexpr const char* detectAgain = "rig.detect";
inline constexpr const char* locatorsFit = "locators.fit";
inline constexpr const char* locatorsFitPrefix = "locators.fit-"; ///< And the plan's id.
inline constexpr const char* locatorsReset = "locators.reset";
inline constexpr const char* locatorsMirror = "locators.mirror";
inline constexpr const char* locatorsSnap = "locators.snap";
inline constexpr const char* rigBuild = "rig.build";
inline constexpr const char* rigBack = "rig.back";
inline constexpr const char* bindMesh = "rig.bind";
inline constexpr const char* planPrefix = "rig.plan-"; ///< And the plan's id.
inline constexpr const char* workStop = "work.stop";

inline constexpr const char* rangeStart = "range.start";
inline constexpr const char* rangeEnd = "range.end";
inline constexpr const char* trailToggle = "trail.toggle";
inline constexpr const char* trailExaggerate = "trail.exaggerate";
inline constexpr const char* clipExaggerate = "clip.exaggerate";
inline constexpr const char* trailConnect = "trail.connect";
inline constexpr const char* trailFollow = "trail.follow";
inline constexpr const char* trailApply = "trail.apply";
inline constexpr const char* trailApplyAll = "trail.apply-all";
inline constexpr const char* trailDelete = "trail.delete";
inline constexpr const char* trailDeleteAll = "trail.delete-all";
inline constexpr const char* trailRename = "trail.rename";
inline constexpr const char* trailNextColour = "trail.colour";
inline constexpr const char* trailBlend = "trail.blend";
inline constexpr const char* trailShowOriginal = "trail.show-original";
inline constexpr const char* weightToggle = "weight.toggle";
inline constexpr const char* weightAll = "weight.all";
inline constexpr const char* weightRemove = "weight.remove";
inline constexpr const char* sphereNext = "sphere.next";
inline constexpr const char* spherePrevious = "sphere.previous";

inline constexpr const char* timePlay = "time.play";
inline constexpr const char* timeBack = "time.back";
inline constexpr const char* timeForward = "time.forward";
inline constexpr const char* timeFarBack = "time.far-back";
inline constexpr const char* timeFarForward = "time.far-forward";
inline constexpr const char* timePreviousKey = "time.previous-key";
inline constexpr const char* timeNextKey = "time.next-key";
inline constexpr const char* momentNext = "moment.next";
inline constexpr const char* momentPrevious = "moment.previous";
inline constexpr const char* warningNext = "warning.next";
inline constexpr const char* timeStart = "time.start";
inline constexpr const char* timeEnd = "time.end";

inline constexpr const char* timeEveryFrame = "play.every-frame";
inline constexpr const char* timeOnTwos = "play.on-twos";
inline constexpr const char* clipImport = "clip.import";
inline constexpr const char* clipNext = "clip.next";
inline constexpr const char* clipPrevious = "clip.previous";
inline constexpr const char* clipChoose = "clip.choose";
inline constexpr const char* clipRate24 = "clip.rate-24";
inline constexpr const char* clipRate25 = "clip.rate-25";
inline constexpr const char* clipRate30 = "clip.rate-30";
inline constexpr const char* clipRateOwn = "clip.rate-own";

inline constexpr const char* viewGhosts = "view.ghosts";
inline constexpr const char* viewSkeleton = "view.skeleton";
inline constexpr const char* viewWire = "view.wire";
inline constexpr const char* viewJointNames = "view.joint-names";
inline constexpr const char* viewHeatMap = "view.heat-map";
inline constexpr const char* viewShadeAs = "view.shade-as";
inline constexpr const char* viewWeights = "view.weights";
inline constexpr const char* viewGrid = "view.grid";
inline constexpr const char* viewCube = "view.cube";
inline constexpr const char* viewReference = "view.reference";
inline constexpr const char* viewFrameNumbers = "view.frame-numbers";
inline constexpr const char* viewSideBySide = "view.side-by-side";
inline constexpr const char* viewFrameSelection = "view.frame-selection";
inline constexpr const char* viewFrameAll = "view.frame-all";
inline constexpr const char* viewFront = "view.front";
inline constexpr const char* viewSide = "view.side";
inline constexpr const char* viewTop = "view.top";
inline constexpr const char* viewPerspective = "view.perspective";
inline constexpr const char* viewCamera = "view.camera";
inline constexpr const char* viewBest = "view.best";
inline constexpr const char* viewSafeFrame = "view.safe-frame";
/// Commands of the keys Ctrl+1 to Ctrl+9: the view is kept under that number.
inline constexpr std::array<const char*, 9> keepView{"view.keep-1", "view.keep-2", "view.keep-3",
                                                     "view.keep-4", "view.keep-5", "view.keep-6",
                                                     "view.keep-7", "view.keep-8", "view.keep-9"};
/// Commands of the keys 1 to 9 of the numpad: to that view.
inline constexpr std::array<const char*, 9> keptView{"view.kept-1", "view.kept-2", "view.kept-3",
                                                     "view.kept-4", "view.kept-5", "view.kept-6",
                                                     "view.kept-7", "view.kept-8", "view.kept-9"};

inline constexpr const char* sequenceCompress = "sequence.compress";
inline constexpr const char* sequenceCancel = "sequence.cancel";
inline constexpr const char* sequenceOriginal = "sequence.original";
inline constexpr const char* sequenceSkinned = "sequence.skinned";
inline constexpr const char* moduliLoad = "sequence.moduli-load";
inline constexpr const char* moduliSave = "sequence.moduli-save";
inline constexpr const char* skeletonTake = "sequence.skeleton-take";
inline constexpr const char* skeletonLeave = "sequence.skeleton-leave";

inline constexpr const char* palette = "help.palette";
inline constexpr const char* keys = "help.keys";
inline constexpr const char* settings = "help.settings";
inline constexpr const char* about = "help.about";

inline constexpr const char* rangeDefault = "range.default";
inline constexpr const char* clipLoop = "clip.loop";
inline constexpr const char* trailExaggerateOnce = "trail.exaggerate-once";
inline constexpr const char* editDelete = "edit.delete";
inline constexpr const char* trailGroup = "trail.group";
inline constexpr const char* trailTakeApart = "trail.take-apart";
inline constexpr const char* trailSelectGroup = "trail.select-group";
inline constexpr const char* selectAllLimbs = "limb.all";
inline constexpr const char* sphereAdd = "sphere.add";
inline constexpr const char* sphereReset = "sphere.reset";
inline constexpr const char* sphereSmooth = "sphere.smooth";
inline constexpr const char* sphereAll = "sphere.all";
inline constexpr const char* sphereAlongBack = "sphere.along-back";
inline constexpr const char* sphereAlongForward = "sphere.along-forward";
inline constexpr const char* sphereGrab = "sphere.grab";
inline constexpr const char* viewLeftPane = "view.left-pane";
inline constexpr const char* viewBottomPane = "view.bottom-pane";
inline constexpr const char* viewRightPane = "view.right-pane";
inline constexpr const char* viewViewportOnly = "view.viewport-only";
inline constexpr const char* viewNavigation = "view.navigation";
inline constexpr const char* keysExport = "keys.export";
inline constexpr const char* viewControllers = "view.controllers";
inline constexpr const char* controllerMove = "controller.move";
inline constexpr const char* controllerTurn = "controller.turn";

inline constexpr const char* controllersOfLeftArm = "controller.left-arm";
inline constexpr const char* controllersOfRightArm = "controller.right-arm";
inline constexpr const char* controllersOfLeftLeg = "controller.left-leg";
inline constexpr const char* controllersOfRightLeg = "controller.right-leg";
inline constexpr const char* controllersOfSpine = "controller.spine";
inline constexpr const char* controllersOfNeck = "controller.neck";
inline constexpr const char* controllersOfHips = "controller.hips";
inline constexpr const char* controllersOfEighth = "controller.eighth";
inline constexpr const char* controllersOfNinth = "controller.ninth";
/// Commands of the keys Alt+1 to Alt+9: controllers of the limbs in the same order, then the hips.
inline constexpr std::array<const char*, 9> controllerSlots{
    controllersOfLeftArm,  controllersOfRightArm, controllersOfLeftLeg,
    controllersOfRightLeg, controllersOfSpine,    controllersOfNeck,
    controllersOfHips,     controllersOfEighth,   controllersOfNinth};
inline constexpr const char* controllerNext = "controller.next";
inline constexpr const char* controllerPrevious = "controller.previous";
inline constexpr const char* controllersAll = "controller.all";
inline constexpr const char* controllersKeyed = "controller.keyed";
inline constexpr const char* poseKey = "pose.key";
inline constexpr const char* poseAutoKey = "pose.auto-key";
inline constexpr const char* poseWholeClip = "pose.whole-clip";
inline constexpr const char* poseDeleteKey = "pose.delete-key";
inline constexpr const char* poseReset = "pose.reset";
inline constexpr const char* poseResetRig = "pose.reset-rig";
inline constexpr const char* poseResetRange = "pose.reset-range";
inline constexpr const char* poseResetRigRange = "pose.reset-rig-range";
inline constexpr const char* poseMirror = "pose.mirror";
inline constexpr const char* poseCopy = "pose.copy";
inline constexpr const char* poseLibrary = "pose.library";
inline constexpr const char* poseKeep = "pose.keep";
inline constexpr const char* poseForget = "pose.forget";
inline constexpr const char* posePaste = "pose.paste";
inline constexpr const char* posePasteMirrored = "pose.paste-mirrored";
inline constexpr const char* poseCopyOffsets = "pose.copy-offsets";
inline constexpr const char* poseTween = "pose.tween";
inline constexpr const char* poseCurlMore = "pose.curl-more";
inline constexpr const char* poseCurlLess = "pose.curl-less";
inline constexpr const char* poseKeyAutomatic = "pose.key-auto";
inline constexpr const char* poseKeyFlat = "pose.key-flat";
inline constexpr const char* poseKeyLinear = "pose.key-linear";
inline constexpr const char* poseKeyStepped = "pose.key-stepped";
inline constexpr const char* poseKeyFree = "pose.key-free";

inline constexpr const char* holdPin = "hold.pin";
inline constexpr const char* holdPinFeet = "hold.pin-feet";
inline constexpr const char* holdMatch = "hold.match";
inline constexpr const char* holdProp = "hold.prop";
inline constexpr const char* holdLetGo = "hold.let-go";
inline constexpr const char* holdRemove = "hold.remove";
inline constexpr const char* propAdd = "prop.add";
inline constexpr const char* keysGrab = "key.grab";
inline constexpr const char* keysScale = "key.scale";
inline constexpr const char* keysInsert = "key.insert";
inline constexpr const char* keysDelete = "key.delete";
inline constexpr const char* keysCopy = "key.copy";
inline constexpr const char* keysPaste = "key.paste";
inline constexpr const char* keysAll = "key.all";
inline constexpr const char* keysSnap = "key.snap";
inline constexpr const char* keysAuto = "key.auto";
inline constexpr const char* keysFlat = "key.flat";
inline constexpr const char* keysLinear = "key.linear";
inline constexpr const char* keysStepped = "key.stepped";
inline constexpr const char* keysFree = "key.free";
inline constexpr const char* keysRestore = "key.restore";
inline constexpr const char* keysRestoreAll = "key.restore-all";
inline constexpr const char* keysRetime = "key.retime";
inline constexpr const char* showTimeline = "pane.timeline";
inline constexpr const char* showGraph = "pane.graph";
inline constexpr const char* showDopeSheet = "pane.dope-sheet";
inline constexpr const char* graphFit = "graph.fit";
inline constexpr const char* graphFitAll = "graph.fit-all";
inline constexpr const char* graphIsolate = "graph.isolate";

inline constexpr const char* reference = "reference.open";
inline constexpr const char* referenceImages = "reference.images";
inline constexpr const char* referenceNoImages = "reference.no-images";
inline constexpr const char* referenceSound = "reference.sound";
inline constexpr const char* referenceNoSound = "reference.no-sound";

inline constexpr const char* bundledPunch = "help.bundled-punch";
inline constexpr const char* bundledSwing = "help.bundled-swing";
inline constexpr const char* bundledLeap = "help.bundled-leap";
inline constexpr const char* tour = "help.tour";
inline constexpr const char* tourEnd = "help.tour-end";

} // namespace stretch::app::command
