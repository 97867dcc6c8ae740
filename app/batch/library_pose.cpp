#include "app/batch/library_pose.h"

#include <algorithm>
#include <iterator>
#include <optional>

#include <fmt/core.h>

#include "app/commands/pose/library_posing.h"
#include "app/files/user_poses.h"
#include "app/schema/parse_text.h"
#include "core/anim/frames.h"

namespace stretch::app {

namespace {

Result<std::optional<Vec2>> rangeOf(const PoseRequest& request) {
  if (request.range.empty()) {
    return std::optional<Vec2>();
  }
  const Result<Vec2> range = parseRange(request.range, "--pose-range");
  return range ? Result<std::optional<Vec2>>(*range) : Result<std::optional<Vec2>>(range.error());
}

} // namespace

void addPoseRequest(CommandLine& line, PoseRequest& request) {
  const DeclaredOption pose = line.option(
      "--pose", request.pose, "A pose of the library, by its name or its file, that the clip takes");
  line.option("--pose-frame", request.frame, "Frame at which it does").showDefault().needs(pose);
  line.option("--pose-range", request.range,
              "First and last frame, A:B, between which the clip gives way to it; default: the whole clip")
      .needs(pose);
  line.option("--pose-amount", request.amount, "How far it is taken: 0 not at all, 1 wholly")
      .showDefault()
      .needs(pose);
  line.flag("--pose-mirrored", request.isMirrored, "Exchanges left and right").needs(pose);
}

Result<TakenPose> withPose(const Document& document, int clip, const PoseRequest& request) {
  const double last = lastFrame(clipOf(document, clip));
  if (!(request.frame >= 0.0 && request.frame <= last)) {
    return Error{
        fmt::format("frame {:g} lies outside the clip, which has the frames 0 to {:g}", request.frame, last),
        "--pose-frame", "give a frame of the clip"};
  }
  if (!(request.amount >= 0.0 && request.amount <= 1.0)) {
    return Error{fmt::format("{:g} is no amount", request.amount), "--pose-amount", "give 0 to 1"};
  }
  const Result<std::optional<Vec2>> range = rangeOf(request);
  if (range && *range && !((*range)->x <= request.frame && request.frame <= (*range)->y)) {
    return Error{fmt::format("the range {} does not hold frame {:g}", request.range, request.frame),
                 "--pose-range", "give a range around --pose-frame"};
  }
  const Result<LibraryPose> found = findPose(request.pose, posesFolder());
  if (!found || !range) {
    return !found ? found.error() : range.error();
  }
  Session session(document);
  session.view().clip = clip;
  session.view().frame = request.frame;
  session.view().wholeClip = !*range;
  session.view().rangeStart = *range ? (*range)->x : 0.0;
  session.view().rangeEnd = *range ? (*range)->y : last;
  const Result<PoseBlend> blend =
      blendInto(session, request.isMirrored ? mirroredPose(document, found->pose) : found->pose);
  if (!blend) {
    return Error{blend.error().what, "--pose", "give another pose, or another frame"};
  }
  const OffsetPose pose = blended(*blend, request.amount);
  Result<Document> posed =
      setOffsets(document, clip, request.frame, pose.offsets, pose.values, KeyRange{*range});
  if (!posed) {
    return posed.error();
  }
  TakenPose taken{std::move(*posed), found->name, {}, blend->missed};
  std::ranges::transform(pose.offsets, std::back_inserter(taken.controllers), &ControllerOffset::id);
  return taken;
}

} // namespace stretch::app
