#include "ui/batch/render_verb.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>

#include <fmt/core.h>

#include "app/batch/options.h"
#include "app/document.h"
#include "app/edits/trail/place_trails.h"
#include "app/evaluate/evaluate.h"
#include "app/evaluate/seen.h"
#include "app/files/save.h"
#include "app/named.h"
#include "app/recipe/replay.h"
#include "app/schema/parse_text.h"
#include "app/sequence/open_any.h"
#include "core/anim/frames.h"
#include "core/base/file.h"
#include "core/base/file_series.h"
#include "core/gltf/json/json.h"
#include "skinning/sequence/read_sequence.h"
#include "ui/batch/film.h"
#include "ui/batch/sequence_pictures.h"
#include "ui/batch/video_writer.h"
#include "ui/panels/body/weight_view.h"
#include "ui/panels/context/view_schema.h"
#include "ui/render/picture/image_edits.h"
#include "ui/render/picture/picture.h"

namespace stretch::ui {

namespace {

struct RenderArguments {
  std::vector<std::string> files;
  app::FileArguments input;
  app::SettingTexts look;
  app::SettingTexts overlays;
  std::string output;
  std::string frame;
  std::string frames;
  std::string size = "1280x720";
  std::string view = "three-quarter";
  std::string camera;
  std::string video;
  std::string beside;
  std::string trails;
  std::string over;
  std::string weights;
  int ghosts = 0;
  int bones = 0; ///< 0: as many as the editor begins with.
  bool sheet = false;
  bool skeleton = false;
  bool withoutTrails = false;
  bool stages = false;
  bool safeFrame = false;
};

constexpr const char* bestViewName = "best";

struct PixelSize {
  int width = 0;
  int height = 0;
};

Result<PixelSize> parseSize(const std::string& text) {
  const std::size_t times = text.find('x');
  const Error wrong{"'" + text + "' is not a size", "--size",
                    "give width and height in pixels from 16 to 8192, such as 1280x720"};
  if (times == std::string::npos) {
    return wrong;
  }
  const Result<double> width = app::parseNumber(text.substr(0, times), "--size");
  const Result<double> height = app::parseNumber(text.substr(times + 1), "--size");
  const auto fits = [](double pixels) { return pixels >= 16.0 && pixels <= 8192.0; };
  if (!width || !height || !fits(*width) || !fits(*height)) {
    return wrong;
  }
  return PixelSize{static_cast<int>(*width), static_cast<int>(*height)};
}

Result<ViewDirection> parseView(const std::string& text) {
  for (const auto& [name, view] :
       {std::pair{"front", ViewDirection::front}, std::pair{"side", ViewDirection::side},
        std::pair{"top", ViewDirection::top}, std::pair{"three-quarter", ViewDirection::threeQuarter},
        std::pair{bestViewName, ViewDirection::threeQuarter}}) {
    if (text == name) {
      return view;
    }
  }
  return Error{"there is no view '" + text + "'", "--view", "give front, side, top, three-quarter or best"};
}

constexpr double nothingMoves = -1.0; // in place of the last frame

/// `lastFrame` of what is drawn; < 0: nothing moves.
Result<std::vector<double>> framesOf(const RenderArguments& arguments, double lastFrame) {
  if (!arguments.frames.empty()) {
    return parseFrames(arguments.frames);
  }
  if (!arguments.frame.empty()) {
    const Result<double> frame = app::parseNumber(arguments.frame, "--frame");
    return frame ? Result<std::vector<double>>(std::vector<double>{*frame})
                 : Result<std::vector<double>>(frame.error());
  }
  if (!arguments.video.empty() && lastFrame >= 0.0) {
    return parseFrames(fmt::format("0:{:.0f}", std::floor(lastFrame + 1e-3)));
  }
  if (!arguments.sheet || lastFrame < 0.0) {
    return std::vector<double>{0.0};
  }
  // A sheet without frames shows the whole clip in twelve pictures, a shorter one frame by frame.
  const int steps = static_cast<int>(std::clamp(std::floor(lastFrame), 1.0, 11.0));
  std::vector<double> frames;
  for (int i = 0; i <= steps; ++i) {
    frames.push_back(std::round(lastFrame * i / steps));
  }
  return frames;
}

Status takeTrails(const RenderArguments& arguments, app::Document& document, int& clip) {
  if (arguments.trails.empty()) {
    return Success{};
  }
  const Result<app::Recipe> recipe = app::loadRecipe(arguments.trails, document);
  if (!recipe) {
    return recipe.error();
  }
  Result<app::PlacedTrails> placed = app::withRecipe(document, *recipe);
  if (!placed) {
    return placed.error();
  }
  clip = recipe->clip;
  document = std::move(placed->document);
  return Success{};
}

/// The one file, or the numbered ones, that the arguments ask for.
Status draw(const RenderArguments& arguments, const Film& film, const PictureOptions& options) {
  removeLeftParts(std::filesystem::path(arguments.output).parent_path());
  if (arguments.sheet) {
    const Result<Image> sheet = renderSheet(*film.sides.front().scene, film.sides.front().pictures, options);
    return sheet ? writePng(arguments.output, *sheet) : Status(sheet.error());
  }
  if (!arguments.video.empty()) {
    if (std::filesystem::path(arguments.video).extension() != ".gif" &&
        (options.widthPixels % 2 != 0 || options.heightPixels % 2 != 0)) {
      fmt::print(stderr, "warning: a video is of even sizes: a line of pixels is added to {}x{}\n",
                 options.widthPixels, options.heightPixels);
    }
    return writeFilm(film, options, arguments.video, app::terminalProgress("drawing"));
  }
  if (film.frames.size() == 1 && arguments.frames.empty()) {
    return drawFilm(film, options,
                    [&](std::size_t, const Image& image) { return writePng(arguments.output, image); });
  }
  return writeFilm(film, options, arguments.output, app::terminalProgress("drawing"));
}

/// Of pictures that are so many frames apart.
double filmRate(double framesPerSecond, const std::vector<double>& frames) {
  return frames.size() > 1 ? framesPerSecond / (frames[1] - frames[0]) : framesPerSecond;
}

Result<PictureOptions> optionsOf(const RenderArguments& arguments) {
  const Result<PixelSize> size = parseSize(arguments.size);
  const Result<ViewDirection> view = parseView(arguments.view);
  if (!size || !view) {
    return size ? view.error() : size.error();
  }
  if (!arguments.video.empty() && !isVideoName(arguments.video)) {
    return Error{"the name of a video ends in .mp4, .webm or .gif", arguments.video,
                 "give a name such as punch.mp4"};
  }
  if (arguments.video.empty() && std::filesystem::path(arguments.output).extension() != ".png") {
    return Error{"the name of a picture has to end in .png", arguments.output,
                 "give a name such as picture.png"};
  }
  PictureOptions options;
  options.widthPixels = size->width;
  options.heightPixels = size->height;
  options.view = *view;
  options.safeFrame = arguments.safeFrame;
  return options;
}

/// Whether an option was given that only a mesh sequence has.
bool asksForSequence(const RenderArguments& arguments) {
  const bool hasLook = app::textOf(arguments.look, sequenceViewSchema().front()) != nullptr;
  return hasLook || arguments.stages || arguments.bones > 0 || !arguments.over.empty();
}

/// Whether the look needs the sequence compressed first.
bool needsResult(const RenderArguments& arguments, app::SequenceLook look) {
  return arguments.stages || arguments.bones > 0 ||
         (look == app::SequenceLook::error && arguments.over.empty());
}

Result<SequenceContent> analysedContent(const RenderArguments& arguments, app::SequenceLook look) {
  Result<app::SequenceDocument> document =
      app::openSequence({arguments.files.begin(), arguments.files.end()});
  if (!document) {
    return document.error();
  }
  const bool bySegments =
      arguments.skeleton || look == app::SequenceLook::segments || look == app::SequenceLook::cylinders;
  if (needsResult(arguments, look) || (bySegments && document->analysis->joints.empty())) {
    document->settings.bones = arguments.bones > 0 ? arguments.bones : document->settings.bones;
    Result<app::Compression> made = app::makeCompression(*document->mesh, document->settings);
    if (!made) {
      return made.error();
    }
    document->result = std::make_shared<const app::Compression>(std::move(made).value());
  }
  if (!app::canShow(*document, look)) {
    return Error{"there is nothing to show for this look", arguments.files.back(),
                 document->analysis->problem};
  }
  return contentOf(*document);
}

Result<SequenceContent> shownContent(const RenderArguments& arguments, app::SequenceLook look) {
  const bool plain = look == app::SequenceLook::material || look == app::SequenceLook::compare ||
                     (look == app::SequenceLook::error && !arguments.over.empty());
  const bool needsAnalysis = !plain || arguments.stages || arguments.skeleton || arguments.bones > 0;
  if (needsAnalysis && !arguments.over.empty()) {
    return Error{"a clip that was read has no bones to show", "--over",
                 "leave --skeleton, --bones and --stages out, and take the look material, compare or error"};
  }
  if (needsAnalysis) {
    return analysedContent(arguments, look);
  }
  Result<MeshSequence> sequence = skinning::readSequence({arguments.files.begin(), arguments.files.end()});
  if (!sequence) {
    return sequence.error();
  }
  for (const std::string& warning : sequence->warnings) {
    fmt::print(stderr, "warning: {}\n", warning);
  }
  SequenceContent content;
  if (!arguments.over.empty()) {
    Result<MeshSequence> over = skinning::readAnimatedGltf(arguments.over);
    if (!over) {
      return over.error();
    }
    skinning::joinUntilAlike(*sequence, *over);
    content.resultFrames = std::make_shared<const MeshSequence>(std::move(over).value());
  }
  content.original = std::make_shared<const MeshSequence>(std::move(sequence).value());
  return content;
}

/// A clip over a sequence is compared with it, unless another look is asked for.
Result<app::SequenceView> viewOf(const RenderArguments& arguments) {
  app::SequenceView view;
  view.look = arguments.over.empty() ? app::SequenceLook::material : app::SequenceLook::compare;
  if (const Status set = app::setFromTexts(sequenceViewSchema(), arguments.look, view); !set) {
    return set.error();
  }
  return view;
}

const app::Setting<ViewportOverlays>& shadeAsSetting() {
  return *app::findSetting(overlaySchema(), "shade_as");
}

Status renderSequence(const RenderArguments& arguments) {
  if (app::textOf(arguments.overlays, shadeAsSetting()) != nullptr) {
    return Error{"a mesh sequence has no joints that turn normals", "--shade-as", "leave it out"};
  }
  if (!arguments.input.clip.empty() || !arguments.trails.empty() || arguments.ghosts > 0 ||
      !arguments.camera.empty() || !arguments.beside.empty() || arguments.view == bestViewName) {
    return Error{"a mesh sequence has no clips, trails, ghosts or cameras, and nothing to stand beside",
                 "render", "leave --clip, --trails, --ghosts, --camera, --beside and --view best out"};
  }
  Result<PictureOptions> options = optionsOf(arguments);
  const Result<app::SequenceView> view = viewOf(arguments);
  if (!options || !view) {
    return options ? view.error() : options.error();
  }
  const Result<SequenceContent> content = shownContent(arguments, view->look);
  if (!content) {
    return content.error();
  }
  const Result<std::vector<double>> frames =
      framesOf(arguments, static_cast<double>(content->original->frameCount() - 1));
  if (!frames) {
    return frames.error();
  }
  if (arguments.stages) {
    removeLeftParts(std::filesystem::path(arguments.output).parent_path());
    const Result<Image> sheet = drawStages(*content, *frames, *options);
    return sheet ? writePng(arguments.output, *sheet) : Status(sheet.error());
  }
  const Result<SequencePictures> pictures =
      picturesOfSequence(*content, *view, {arguments.skeleton, {}}, *frames, *options);
  if (!pictures) {
    return pictures.error();
  }
  options->camera = pictures->camera;
  return draw(arguments,
              {{{&pictures->drawing->scene(), pictures->pictures}},
               *frames,
               filmRate(content->original->framesPerSecond, *frames)},
              *options);
}

/// Null where none is asked for.
Result<const SceneCamera*> cameraOf(const Scene& scene, const std::string& name) {
  const SceneCamera* const camera = cameraNamed(scene, name);
  if (camera != nullptr || name.empty()) {
    return camera;
  }
  std::string cameras;
  for (const SceneCamera& one : scene.cameras) {
    cameras += (cameras.empty() ? "" : ", ") + one.name;
  }
  return Error{"there is no camera '" + name + "'", "--camera",
               cameras.empty() ? "the file has none; take a --view" : "the file has " + cameras};
}

/// The view that shows the first trail best.
Status takeBestView(const RenderArguments& arguments, const app::Document& document,
                    const rig::MotionState& motion, PictureOptions& options) {
  if (arguments.view != bestViewName) {
    return Success{};
  }
  if (motion.trails.empty()) {
    return Error{"the best view is that of a trail, and there is none", "--view",
                 "name a recipe by --trails, or a file that was saved with its work"};
  }
  options.towardsEye = app::bestViewOf(document, motion, motion.trails.front());
  return Success{};
}

/// None where no weights are asked for.
Result<NodeIndex> weightJoint(const Scene& scene, const std::string& name) {
  if (name.empty()) {
    return NodeIndex::none;
  }
  for (const NodeIndex joint : weightedJoints(scene)) {
    if (scene.nodes[at(joint)].name == name) {
      return joint;
    }
  }
  return Error{"no mesh follows a joint '" + name + "'", "--weights", "info --json lists the joints"};
}

/// The file that stands on the left, with the clip by its name; nothing where none is asked for.
Result<std::optional<app::Document>> besideOf(const RenderArguments& arguments, const app::Document& document,
                                              int clip) {
  if (arguments.beside.empty()) {
    return std::optional<app::Document>();
  }
  if (clip < 0) {
    return Error{"has no clip to show beside another", arguments.input.file, "name a file with a clip"};
  }
  app::FileArguments input = arguments.input;
  input.file = arguments.beside;
  Result<app::Document> source = app::openDocument(input);
  const Result<int> same = source ? app::findClip(*source, app::clipOf(document, clip).name, "--beside")
                                  : Result<int>(source.error());
  return same ? Result<std::optional<app::Document>>(std::move(source).value())
              : Result<std::optional<app::Document>>(same.error());
}

std::vector<PictureFrame> picturesBeside(const app::Document& source, const std::string& clip,
                                         const std::vector<double>& frames, double framesPerSecond,
                                         CharacterLook look) {
  const int number = app::findClip(source, clip, "--beside").value();
  look.camera = look.camera != nullptr ? cameraNamed(*source.scene, look.camera->name) : nullptr;
  look.weightsOf = NodeIndex::none;
  look.backdrops = {};
  const auto motion = std::make_shared<const rig::MotionState>(app::prepareMotion(source, number));
  std::vector<double> own = frames; // the same moments, counted as this file counts
  for (double& frame : own) {
    frame *= motion->framesPerSecond / framesPerSecond;
  }
  std::vector<PictureFrame> pictures = picturesOfCharacter(source, motion, own, look);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    std::string& label = pictures[i].label;
    label = label.empty() ? std::string("before") : fmt::format("before, frame {:g}", frames[i]);
  }
  return pictures;
}

Result<CharacterLook> lookOf(const RenderArguments& arguments, const app::Document& document, int clip,
                             std::size_t frameCount) {
  const Result<NodeIndex> joint = weightJoint(*document.scene, arguments.weights);
  const Result<const SceneCamera*> camera = cameraOf(*document.scene, arguments.camera);
  if (!joint || !camera) {
    return joint ? camera.error() : joint.error();
  }
  ViewportOverlays overlays;
  if (Status set = app::setFromTexts(overlaySchema(), arguments.overlays, overlays); !set) {
    return set.error();
  }
  Result<Backdrops> backdrops = backdropsOf(document, clip);
  if (!backdrops) {
    return backdrops.error();
  }
  return CharacterLook{.skeleton = arguments.skeleton,
                       .trails = !arguments.withoutTrails,
                       .ghosts = arguments.ghosts,
                       .weightsOf = *joint,
                       .labelled = clip >= 0 && (frameCount > 1 || arguments.sheet),
                       .shadeAs = overlays.shadeAs,
                       .camera = *camera,
                       .backdrops = std::move(*backdrops)};
}

Status renderCharacter(const RenderArguments& arguments) {
  Result<app::Document> document = app::openDocument(arguments.input);
  Result<PictureOptions> options = optionsOf(arguments);
  if (!document || !options) {
    return document ? options.error() : document.error();
  }
  int clip = document->clips->empty() ? -1 : 0;
  if (!arguments.input.clip.empty()) {
    const Result<int> named = app::clipOfArguments(arguments.input, *document);
    if (!named) {
      return named.error();
    }
    clip = *named;
  }
  if (Status trails = takeTrails(arguments, *document, clip); !trails) {
    return trails;
  }
  const double lastFrame = clip < 0 ? nothingMoves : endInFrames(app::clipOf(*document, clip));
  const Result<std::vector<double>> frames = framesOf(arguments, lastFrame);
  if (!frames) {
    return frames.error();
  }
  if (Status there = checkFrames(*document, clip, *frames); !there) {
    return there;
  }
  const Result<CharacterLook> look = lookOf(arguments, *document, clip, frames->size());
  if (!look) {
    return look.error();
  }
  const auto motion = std::make_shared<const rig::MotionState>(app::prepareMotion(*document, clip));
  if (Status best = takeBestView(arguments, *document, *motion, *options); !best) {
    return best;
  }
  Film film{{}, *frames, filmRate(motion->framesPerSecond, *frames)};
  const Result<std::optional<app::Document>> source = besideOf(arguments, *document, clip);
  if (!source) {
    return source.error();
  }
  const SceneCamera* const camera = look->camera;
  if (*source && camera != nullptr && cameraNamed(*(*source)->scene, camera->name) == nullptr) {
    return Error{"has no camera '" + camera->name + "'", arguments.beside,
                 "name a file with it, or look by --view"};
  }
  if (*source) {
    film.sides.push_back({(*source)->scene.get(), picturesBeside(**source, app::clipOf(*document, clip).name,
                                                                 *frames, motion->framesPerSecond, *look)});
  }
  film.sides.push_back({document->scene.get(), picturesOfCharacter(*document, motion, *frames, *look)});
  Result<std::optional<FilmSound>> sound = filmSoundOf(*document, clip, *frames);
  if (!sound && !arguments.video.empty()) {
    return sound.error();
  }
  film.sound = sound ? std::move(*sound) : std::nullopt;
  return draw(arguments, film, *options);
}

/// Whether what is to be written can be, before anything is drawn.
Status checkPlaces(const RenderArguments& arguments) {
  const std::filesystem::path target = arguments.video.empty() ? arguments.output : arguments.video;
  Status free = checkPlace(target);
  if (arguments.frames.empty() || arguments.sheet || arguments.stages || !arguments.video.empty()) {
    return free;
  }
  const Result<std::vector<double>> frames = parseFrames(arguments.frames);
  free = frames ? Status(Success{}) : Status(frames.error());
  for (std::size_t i = 0; free && i < frames->size(); ++i) {
    free = checkPlace(numberedName(target, (*frames)[i]));
  }
  return free;
}

/// Refuses what is wrong whatever the file holds.
Status checkArguments(const RenderArguments& arguments) {
  if (arguments.sheet && (!arguments.video.empty() || !arguments.beside.empty())) {
    return Error{"a contact sheet is one picture of one file", "--sheet",
                 "leave it out, or --video and --beside"};
  }
  if (arguments.stages && !arguments.video.empty()) {
    return Error{"the stages are one picture", "--stages", "leave it out, or --video"};
  }
  if (const Result<PictureOptions> options = optionsOf(arguments); !options) {
    return options.error();
  }
  const Result<std::vector<double>> frames = framesOf(arguments, nothingMoves);
  return frames ? Status(Success{}) : Status(frames.error());
}

Status runRender(RenderArguments arguments) {
  if (Status free = checkPlaces(arguments); !free) {
    return free;
  }
  if (app::namesSequence({arguments.files.begin(), arguments.files.end()}) || asksForSequence(arguments)) {
    return renderSequence(arguments);
  }
  arguments.input.file = arguments.files.front();
  return renderCharacter(arguments);
}

void addSequenceOptions(app::CommandLine& line, RenderArguments& arguments) {
  constexpr const char* heading = "Mesh sequences";
  line.option("--over", arguments.over, "A clip that was compressed from the sequence, drawn over it")
      .group(heading);
  app::addSettingOptions(line, sequenceViewSchema(), arguments.look, heading);
  line.option("--bones", arguments.bones, "Compress the sequence first, to this many bones")
      .between(1, 1000)
      .group(heading);
  line.flag("--stages", arguments.stages,
            "Mesh, skeleton, segments and stretched mesh beside each other, a row for each frame")
      .group(heading);
}

} // namespace

app::Verb renderVerb() {
  return {"render",
          "Draws a file or mesh sequence without a display: a frame, a numbered series, a contact sheet, a "
          "video.",
          [](app::CommandLine& line) {
            const auto arguments = std::make_shared<RenderArguments>();
            arguments->input.pictures = gltf::Pictures::decoded;
            line.examples({"punch.glb -o punch.png --frame 27 --size 960x540",
                           "punch.glb -o sheet.png --sheet --frames 18:36:2",
                           "punch.glb --video punch.mp4 --beside dummy.glb --safe-frame"});
            line.options("FILE", arguments->files,
                         std::string("A .glb, .gltf, .vrm, .fbx, .bvh or .dae file, or a mesh sequence: ") +
                             app::sequenceWords)
                .required()
                .takes(1, 2);
            app::addTolerant(line, arguments->input);
            app::addPlan(line, arguments->input);
            const app::DeclaredOption output =
                line.option("-o,--output", arguments->output, "The .png to write; a series adds -NNNN");
            const app::DeclaredOption video =
                line.option("--video", arguments->video,
                            "The .mp4, .webm or .gif to write by ffmpeg, in place of -o; default: the whole "
                            "clip, at its speed");
            video.excludes(output);
            line.requireOne(output, video);
            app::addClipArguments(line, arguments->input);
            const app::DeclaredOption frame =
                line.option("--frame", arguments->frame, "One frame; default: 0").excludes(video);
            line.option("--frames", arguments->frames, "A numbered series, A:B or A:B:STEP").excludes(frame);
            line.option("--beside", arguments->beside,
                        "Another file with the clip, such as the source, drawn on the left");
            line.flag("--sheet", arguments->sheet,
                      "One contact sheet: the frames of --frames, else twelve over the whole clip");
            line.option("--size", arguments->size, "Pixels of a picture, WxH").showDefault();
            const app::DeclaredOption view =
                line.option("--view", arguments->view,
                            "front, side, top, three-quarter, or best: what shows the first trail best")
                    .showDefault();
            line.option("--camera", arguments->camera, "A camera of the file, which the clip may move")
                .excludes(view);
            line.flag("--safe-frame", arguments->safeFrame,
                      "Outline the nine tenths of the picture that every screen shows");
            line.option("--trails", arguments->trails, "A recipe whose trails are drawn and followed");
            line.flag("--no-trails", arguments->withoutTrails,
                      "Draw the character alone: trails of the file or recipe move it, and are not drawn");
            line.option("--ghosts", arguments->ghosts, "Ghosts before and after, every second frame")
                .between(0, 20);
            line.flag("--skeleton", arguments->skeleton, "Draw the skeleton over the mesh");
            line.option(
                "--weights", arguments->weights,
                "A joint: the mesh is coloured by how much it follows it, yellow wholly, grey not at all");
            app::addSettingOption(line, shadeAsSetting(), arguments->overlays, "Options");
            addSequenceOptions(line, *arguments);
            line.checkTogether([arguments](const app::CommandLine&) { return checkArguments(*arguments); });
            return [arguments] { return runRender(*arguments); };
          }};
}

} // namespace stretch::ui
