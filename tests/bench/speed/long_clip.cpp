#include "tests/bench/speed/long_clip.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <utility>

#include "app/files/save.h"
#include "core/anim/sampling.h"
#include "core/base/check.h"

namespace stretch::bench {

namespace {

// Where a clip of this length is at a time, played there and back.
double thereAndBack(double timeSeconds, double lengthSeconds) {
  const double turn = std::fmod(timeSeconds, 2.0 * lengthSeconds);
  return turn <= lengthSeconds ? turn : 2.0 * lengthSeconds - turn;
}

Track longTrack(const Track& source, const Clip& clip, int frames) {
  Track track = source;
  track.interpolation = Interpolation::linear;
  track.times.clear();
  track.values.clear();
  std::array<double, 4> value{};
  for (int frame = 0; frame < frames; ++frame) {
    const double time = frame / clip.framesPerSecond;
    sampleTrack(source, thereAndBack(time, clip.endSeconds), value.data());
    track.times.push_back(static_cast<float>(time));
    for (int i = 0; i < track.width; ++i) {
      track.values.push_back(static_cast<float>(value[static_cast<std::size_t>(i)]));
    }
  }
  return track;
}

} // namespace

app::Document withLongClip(const app::Document& document, int frames) {
  app::Document made = document;
  std::vector<Clip> clips = *document.clips;
  Clip& clip = clips.front();
  for (CopyOnWrite<Track>& track : clip.tracks) {
    track = longTrack(*track, sourceClipOf(document, 0), frames);
  }
  clip.endSeconds = (frames - 1) / clip.framesPerSecond;
  made.sourceClips = sourceClipsOf(document);
  made.clips = std::make_shared<const std::vector<Clip>>(std::move(clips));
  const std::filesystem::path path = std::filesystem::temp_directory_path() / "stretch-engine-long-clip.glb";
  const Status saved = app::saveDocument(made, path, {.clean = true});
  check(saved.ok(), "the long clip of a bench can be saved");
  Result<app::Document> opened = app::openDocument(path);
  check(opened.ok(), "the long clip of a bench can be opened");
  std::filesystem::remove(path);
  return std::move(*opened);
}

void addTrail(app::Document& document, std::size_t limb, double start, double end) {
  rig::Trail trail;
  trail.id = document.nextTrailId++;
  trail.limb = document.body.limbs[limb].id;
  trail.settings.startFrame = start;
  trail.settings.endFrame = end;
  trail.settings.scale = 1.5;
  trail.exaggerated = true;
  trail.connected = true;
  trail.applied = true;
  document.trails.push_back(std::move(trail));
}

} // namespace stretch::bench
