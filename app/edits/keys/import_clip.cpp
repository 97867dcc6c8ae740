#include "app/edits/keys/import_clip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "app/edits/pose/prop_file_edits.h"
#include "app/named.h"
#include "app/retarget/touch_shifts.h"
#include "core/base/number.h"
#include "core/gltf/load/load_as_it_stands.h"
#include "core/gltf/patch/new_clips.h"
#include "core/interchange/file_kind.h"
#include "rig/retarget/copy_tracks.h"
#include "rig/retarget/retarget.h"

namespace stretch::app {

namespace {

// Another file whose clips are wanted.
struct Donor {
  Document document;
  std::optional<rig::Skeleton> skeleton; // a biped's
  bool isForeign = false;                // a file of another program
  std::vector<std::string> warnings;     // what reading says of it
};

bool movesJoints(const Clip& clip) {
  return std::ranges::any_of(
      clip.tracks, [](const CopyOnWrite<Track>& track) { return track->channel != Channel::weights; });
}

std::string titleOfClip(const Document& document, int clip) {
  const std::string& name = clipOf(document, clip).name;
  return name.empty() ? fmt::format("#{}", clip) : name;
}

// The donor is not moved from here on: its skeleton refers to its scene.
Result<Donor> readDonor(const std::filesystem::path& file) {
  Result<gltf::Loaded> loaded = gltf::loadAsItStands(file, gltf::Pictures::headers);
  if (!loaded) {
    return loaded.error();
  }
  Donor donor;
  donor.document.scene = loaded->scene;
  donor.document.source = loaded->source;
  donor.document.clips = std::make_shared<const std::vector<Clip>>(std::move(loaded->clips));
  donor.document.body = bodyOfSource(donor.document);
  if (donor.document.clips->empty()) {
    return Error{"the file holds no clip", file.string(), "give a file with an animation"};
  }
  donor.warnings = std::move(loaded.value().warnings);
  donor.isForeign = interchange::isForeignName(file.extension().string());
  donor.skeleton = rig::skeletonOf(*donor.document.scene, donor.document.body);
  return donor;
}

// What reading says of the clips that are wanted; of a foreign file, of all of it.
std::vector<std::string> warningsOf(const Donor& donor, const std::vector<int>& wanted,
                                    const std::string& name) {
  std::vector<std::string> lines;
  for (const std::string& line : donor.warnings) {
    const bool isWanted = std::ranges::any_of(
        wanted, [&](int clip) { return line.starts_with(fmt::format("animations[{}]", clip)); });
    if (donor.isForeign || isWanted) {
      lines.push_back(donor.isForeign ? line : name + ": " + line);
    }
  }
  return lines;
}

// Which clips are meant: by name, "#2", or 2.
Result<std::vector<int>> wantedClips(const Donor& donor, const ClipRequest& request) {
  std::vector<int> clips;
  if (request.clip.empty()) {
    for (std::size_t i = 0; i < donor.document.clips->size(); ++i) {
      clips.push_back(static_cast<int>(i));
    }
    return clips;
  }
  Result<int> found = findClip(donor.document, request.clip, request.file.string());
  if (!found && parseNumber<std::size_t>(request.clip)) {
    const Result<int> counted = findClip(donor.document, "#" + request.clip, request.file.string());
    found = counted ? counted : found;
  }
  if (!found) {
    return found.error();
  }
  clips.push_back(*found);
  return clips;
}

std::size_t animatedNodes(const rig::CopiedTracks& copied) {
  return copied.joints + copied.missing.size();
}

// Names decide where most of the joints are there; a biped's keys mean the same only on bones that are alike.
bool isCopied(const Donor& donor, const Clip& clip, const rig::CopiedTracks& copied, const Document& document,
              bool canRetarget) {
  const bool hasMost = copied.joints > 0 && copied.joints * 2 >= animatedNodes(copied);
  return hasMost && (!canRetarget || rig::haveSameBones(*donor.document.scene, clip, *document.scene,
                                                        document.body.hips, donor.document.body.hips));
}

// Whether no joint moves by more than numbers of files are off.
bool isStill(const Clip& clip) {
  const auto isAlike = [](float a, float b) { return std::abs(a - b) <= 1e-6F * std::abs(b) + 1e-9F; };
  return std::ranges::none_of(clip.tracks, [&](const CopyOnWrite<Track>& track) {
    const std::vector<float>& values = track->values;
    return track->channel != Channel::weights &&
           !std::equal(values.begin() + track->width, values.end(), values.begin(), isAlike);
  });
}

// What of a clip goes no way, neither copied nor retargeted.
std::vector<std::string> notesOf(const Clip& clip, const NewClip& brought,
                                 const std::vector<std::string>& ofOthers) {
  std::vector<std::string> notes;
  if (!ofOthers.empty()) {
    const std::string names = brought.isRetargeted
                                  ? std::string()
                                  : fmt::format(": {} of them, {} first", ofOthers.size(), ofOthers.front());
    notes.push_back("left out what moves another character of the file, which has nodes of the same names" +
                    names);
  }
  const auto weights = std::ranges::count_if(
      clip.tracks, [](const CopyOnWrite<Track>& track) { return track->channel == Channel::weights; });
  if (brought.isRetargeted && weights > 0) {
    notes.push_back(fmt::format("left out {} {} of morph weights: a clip of another skeleton moves joints "
                                "alone",
                                weights, weights == 1 ? "channel" : "channels"));
  }
  if (brought.isRetargeted && isStill(brought.clip) && !isStill(clip)) {
    notes.emplace_back(
        "nothing of it moves this character: it moves other nodes than the limbs that were found "
        "in the file");
  }
  return notes;
}

// Why a body takes no clip of another skeleton, or gives none.
std::string lackOf(const rig::Body& body) {
  const bool lacksLeg =
      std::ranges::any_of(std::array{rig::biped::leftLeg, rig::biped::rightLeg},
                          [&](const auto& place) { return rig::limbAt(body.limbs, place) == nullptr; });
  return body.isBiped && lacksLeg ? "has not both legs of a biped" : "is no biped";
}

Error cannotFollow(const Donor& donor, const rig::CopiedTracks& copied, const Document& document,
                   const std::string& file) {
  const std::string names =
      fmt::format("{} of the {} animated joints of the clip have names of this character", copied.joints,
                  animatedNodes(copied));
  if (donor.document.scene->skins.empty() && donor.document.body.limbs.empty() && copied.joints == 0) {
    return {"the file holds no skeleton that this character could follow", file,
            "give a clip of a biped, or of joints with the same names"};
  }
  const std::string who =
      !donor.skeleton ? "its body " + lackOf(donor.document.body) : "this character " + lackOf(document.body);
  const bool isOfCharacter = donor.skeleton && document.source != nullptr;
  return {fmt::format("the clip cannot be brought to this character: {}, and {}", who, names),
          isOfCharacter ? document.source->path.string() : file,
          document.body.isBiped ? "give a clip of a biped, or of joints with the same names"
                                : "give a clip of joints with the same names"};
}

Result<NewClip> broughtOver(const Donor& donor, int index, const Document& document,
                            const std::optional<rig::Skeleton>& own, const ClipRequest& request,
                            const std::function<bool(double)>& proceed) {
  const std::string file = request.file.string();
  const Clip& clip = clipOf(donor.document, index);
  const std::string title = titleOfClip(donor.document, index);
  rig::CopiedTracks copied = rig::copyTracks(*donor.document.scene, clip, *document.scene, document.body.hips,
                                             donor.document.body.hips);
  const bool canRetarget = donor.skeleton && own && movesJoints(clip);
  if (isCopied(donor, clip, copied, document, canRetarget)) {
    NewClip same{std::move(copied.clip), title, false, std::move(copied.missing)};
    same.notes = notesOf(clip, same, copied.ofOthers);
    return same;
  }
  if (!movesJoints(clip)) {
    return Error{fmt::format("the clip '{}' moves no joints", title), file,
                 "give a clip that moves a skeleton"};
  }
  if (!canRetarget) {
    return cannotFollow(donor, copied, document, file);
  }
  Result<rig::Retargeted> brought =
      rig::retarget(*donor.skeleton, clip, *own, proceed, rig::Correction::feetAndHands,
                    touchShifts({*donor.skeleton, clip}, *own, request.settings.touch));
  if (!brought) {
    return Error{brought.error().what, file + ": " + title, brought.error().remedy};
  }
  const Result<rig::Retargeted> mapped =
      rig::retarget(*donor.skeleton, clip, *own, proceed, rig::Correction::none);
  if (!mapped) {
    return mapped.error();
  }
  RetargetReport report =
      retargetReport({*donor.skeleton, clip}, {*own, mapped->clip}, {*own, brought->clip});
  NewClip other{std::move(brought->clip), title, true, std::move(brought->left), report};
  other.notes = notesOf(clip, other, copied.ofOthers);
  return other;
}

std::string freeClipName(const std::vector<Clip>& clips, const std::string& wanted) {
  const auto isTaken = [&](const std::string& name) {
    return std::ranges::find(clips, name, &Clip::name) != clips.end();
  };
  std::string name = wanted;
  for (int number = 2; isTaken(name); ++number) {
    name = fmt::format("{} {}", wanted, number);
  }
  return name;
}

// As the file's import answers it.
void settleClip(std::size_t index, Clip& clip) {
  clip.sourceIndex = static_cast<int>(index);
  for (std::size_t i = 0; i < clip.tracks.size(); ++i) {
    clip.tracks[i].edit([&](Track& track) { track.sourceChannel = static_cast<int>(i); });
  }
  setEndsFromKeys(clip);
}

// "Walk, Run and 7 more".
std::string listOf(const std::vector<std::string>& names, std::size_t most) {
  std::string list;
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i) {
    list += (i == 0 ? "" : ", ") + names[i];
  }
  return names.size() > most ? list + fmt::format(" and {} more", names.size() - most) : list;
}

// Parts that a clip moves and the character lacks; empty where it has all of them.
std::string leftText(const NewClip& clip) {
  if (clip.left.empty()) {
    return {};
  }
  constexpr std::size_t most = 6;
  const std::string names = listOf(clip.left, most);
  return clip.isRetargeted ? "left out what this character has no joints for: " + names
                           : fmt::format("left out {} {} that this character lacks: {}", clip.left.size(),
                                         clip.left.size() == 1 ? "joint" : "joints", names);
}

// One line for all clips of which the same is told.
std::vector<std::string> leftLines(const std::vector<NewClip>& clips) {
  std::vector<std::pair<std::string, std::vector<std::string>>> clipsOfText;
  for (const NewClip& clip : clips) {
    std::vector<std::string> texts = clip.notes;
    if (const std::string text = leftText(clip); !text.empty()) {
      texts.insert(texts.begin(), text);
    }
    for (const std::string& text : texts) {
      auto known = std::ranges::find(clipsOfText, text,
                                     [](const auto& one) -> const std::string& { return one.first; });
      if (known == clipsOfText.end()) {
        known = clipsOfText.insert(known, {text, {}});
      }
      known->second.push_back(clip.from);
    }
  }
  constexpr std::size_t mostClips = 3;
  std::vector<std::string> lines;
  lines.reserve(clipsOfText.size());
  for (const auto& [text, names] : clipsOfText) {
    lines.push_back(listOf(names, mostClips) + ": " + text);
  }
  return lines;
}

// Feet of other proportions may sink in: farther below the floor than the source's do, of either's height.
std::optional<std::string> sinkingLine(const Scene& scene, const NewClip& brought) {
  constexpr double seen = 0.01;
  if (!brought.report) {
    return std::nullopt;
  }
  const RetargetFigures& own = brought.report->result;
  const double sourceShare = brought.report->source.floor.value_or(0.0);
  if (own.floor.value_or(0.0) - sourceShare <= seen) {
    return std::nullopt;
  }
  const std::string part = own.below.node.exists() ? scene.nodes[at(own.below.node)].name : std::string();
  return fmt::format(
      "{}: what follows \"{}\" gets {:.1f} % of the height below the floor at {:.2f} s (in the source "
      "{:.1f} %); pose it higher there",
      brought.from, part, 100.0 * *own.floor, own.below.seconds, 100.0 * sourceShare);
}

} // namespace

Result<NewClips> clipsFromFile(const Document& document, const ClipRequest& request,
                               const std::function<bool(double)>& proceed) {
  const std::string file = request.file.string();
  const Result<Donor> donor = readDonor(request.file);
  if (!donor) {
    return donor.error();
  }
  const Result<std::vector<int>> wanted = wantedClips(*donor, request);
  if (!wanted) {
    return wanted.error();
  }
  if (!request.name.empty() && wanted->size() > 1) {
    return Error{fmt::format("{} clips cannot have one name", wanted->size()), file,
                 "name the clip that is wanted"};
  }
  const std::optional<rig::Skeleton> own = rig::skeletonOf(*document.scene, document.body);
  NewClips brought{{}, warningsOf(*donor, *wanted, request.file.filename().string())};
  std::optional<Error> first;
  double done = 0.0;
  bool isStopped = false;
  const auto goesOn = [&](double share) {
    isStopped = isStopped || (proceed && !proceed((done + share) / static_cast<double>(wanted->size())));
    return !isStopped;
  };
  for (const int index : *wanted) {
    if (!goesOn(0.0)) {
      return Error{"stopped before the clips were brought over", file, "import them again"};
    }
    Result<NewClip> clip = broughtOver(*donor, index, document, own, request, goesOn);
    done += 1.0;
    if (!clip) {
      first = first ? first : clip.error();
      brought.warnings.push_back(clip.error().line());
      continue;
    }
    clip->clip.name = !request.name.empty()     ? request.name
                      : clip->clip.name.empty() ? request.file.stem().string()
                                                : clip->clip.name;
    if (std::optional<std::string> line = sinkingLine(*document.scene, *clip)) {
      brought.warnings.push_back(*std::move(line));
    }
    brought.clips.push_back(std::move(clip).value());
  }
  if (brought.clips.empty()) {
    return *first;
  }
  for (std::string& line : leftLines(brought.clips)) {
    brought.warnings.push_back(std::move(line));
  }
  return brought;
}

std::vector<std::string> newsOf(const NewClips& brought) {
  std::vector<std::string> news;
  std::vector<std::string> others;
  for (const NewClip& clip : brought.clips) {
    const std::vector<std::string> lines =
        clip.report ? worseLines(*clip.report) : std::vector<std::string>();
    for (std::size_t i = 0; i < lines.size(); ++i) {
      (i == 0 ? news : others)
          .push_back(brought.clips.size() > 1 ? fmt::format("{}: {}", clip.clip.name, lines[i]) : lines[i]);
    }
  }
  news.insert(news.end(), others.begin(), others.end());
  news.insert(news.end(), brought.warnings.begin(), brought.warnings.end());
  return news;
}

Result<Document> withNewClips(const Document& document, const std::vector<Clip>& clips) {
  std::vector<Clip> added = clips;
  std::vector<Clip> all = *document.clips;
  for (Clip& clip : added) {
    clip.name = freeClipName(all, clip.name);
    settleClip(all.size(), clip);
    all.push_back(clip);
  }
  Result<gltf::Source> source = gltf::withNewClips(*document.source, added);
  if (!source) {
    return source.error();
  }
  Document changed = document;
  changed.source = std::make_shared<const gltf::Source>(std::move(source).value());
  changed.clips = std::make_shared<const std::vector<Clip>>(std::move(all));
  if (document.sourceClips != nullptr) {
    std::vector<Clip> unedited = *document.sourceClips;
    unedited.insert(unedited.end(), added.begin(), added.end());
    changed.sourceClips = std::make_shared<const std::vector<Clip>>(std::move(unedited));
  }
  changed.importedClips += added.size();
  return changed;
}

} // namespace stretch::app
