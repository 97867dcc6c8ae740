#include "app/commands/exaggerate.h"

#include <algorithm>

#include "app/commands/frames.h"
#include "app/commands/selection.h"
#include "app/edits/trail_edits.h"
#include "rig/motion/solve.h"

namespace stretch::app {

namespace {

rig::TrailSettings newSettings(const Session& session, const rig::Limb& limb, bool exaggerated) {
  const Vec2 range = workingRange(session, limb);
  rig::TrailSettings settings;
  settings.startFrame = range.x;
  settings.endFrame = range.y;
  settings.viewAxes = session.view().cameraAxes;
  settings.scale = exaggerated ? firstScale : 1.0;
  const Document& document = session.document();
  settings.space = rig::startingSpace(*document.scene, clipOf(document, session.view().clip), limb,
                                      document.biped.hips, range);
  return settings;
}

/// Whether a range is set in which none of these trails lies: the user wants further ones there.
bool wantsNewTrails(const Session& session, const std::vector<int>& present) {
  const ViewState& view = session.view();
  if (selectedTrail(session) != nullptr || view.rangeEnd <= view.rangeStart) {
    return present.empty();
  }
  return std::none_of(present.begin(), present.end(), [&](int id) {
    const rig::TrailSettings& settings = findTrail(session.document(), id)->settings;
    return settings.startFrame < view.rangeEnd && view.rangeStart < settings.endFrame;
  });
}

/// Exaggerates and connects one trail; one at scale 1 that never was gets the first scale.
void exaggerate(rig::Trail& trail) {
  if (!trail.exaggerated && trail.settings.scale == 1.0) {
    trail.settings.scale = firstScale;
  }
  trail.exaggerated = true;
  trail.connected = true;
}

} // namespace

Result<ExaggerateTargets> newTrails(const Session& session, bool exaggerated) {
  const ViewState& view = session.view();
  if (view.selectedLimbs.empty()) {
    return Error{"no limb is selected", "", "press 1 to 6, or click one"};
  }
  if (!hasClip(session.document(), view.clip)) {
    return Error{"the file has no animation", "", "open a file with a clip"};
  }
  ExaggerateTargets targets{session.document(), {}};
  for (const std::string& limbId : view.selectedLimbs) {
    const rig::Limb* limb = findLimb(targets.document, limbId);
    if (limb == nullptr) {
      return Error{"the character has no such limb", limbId, "pick a limb that was found"};
    }
    Result<CreatedTrail> created =
        createTrail(targets.document,
                    {limbId, view.clip, newSettings(session, *limb, exaggerated), exaggerated, exaggerated});
    if (!created) {
      return created.error();
    }
    targets.trailIds.push_back(created->trailId);
    targets.document = std::move(created->document);
  }
  return targets;
}

Result<ExaggerateTargets> exaggerateTargets(const Session& session) {
  const std::vector<int> present = targetTrails(session);
  if (wantsNewTrails(session, present)) {
    return newTrails(session, true);
  }
  ExaggerateTargets targets{session.document(), present};
  for (const int id : present) {
    exaggerate(*findTrail(targets.document, id));
  }
  return targets;
}

Result<Document> exaggeratedWith(const ExaggerateTargets& targets, const ExaggerateModal& modal) {
  Document document = targets.document;
  for (const int id : targets.trailIds) {
    const rig::Trail* trail = findTrail(document, id);
    if (trail == nullptr) {
      return missingTrail(id);
    }
    Result<Document> changed = setTrailSettings(document, id, withModal(trail->settings, modal));
    if (!changed) {
      return changed.error();
    }
    document = std::move(changed).value();
  }
  return document;
}

} // namespace stretch::app
