#include "app/commands/trail/exaggerate.h"

#include <algorithm>

#include "app/commands/table/frames.h"
#include "app/commands/table/ranges.h"
#include "app/commands/table/selection.h"
#include "app/edits/trail/group_edits.h"
#include "app/edits/trail/place_trails.h"
#include "app/edits/trail/starting_settings.h"
#include "app/edits/trail/trail_edits.h"
#include "app/evaluate/way_back.h"
#include "app/standing_floor.h"
#include "rig/motion/solve.h"

namespace stretch::app {

namespace {

/// The trail of the limb that is meant without being selected: the one in the range that was set, else the
/// one at the playhead, else the one that has most of the range that is proposed. 0 for none.
int meantTrail(const Session& session, const std::string& limbId, const Vec2& proposed) {
  constexpr double most = 0.5; // Of the shorter one.
  const ViewState& view = session.view();
  const auto trailWhere = [&](auto&& isThere) {
    const auto& trails = session.document().trails;
    const auto found = std::ranges::find_if(trails, [&](const rig::Trail& trail) {
      return trail.limb == limbId && trail.clip == view.clip &&
             isThere(Vec2(trail.settings.startFrame, trail.settings.endFrame));
    });
    return found == trails.end() ? 0 : found->id;
  };
  if (isRangeSet(view)) {
    return trailWhere(
        [&](const Vec2& range) { return range.x < view.rangeEnd && view.rangeStart < range.y; });
  }
  const int here =
      trailWhere([&](const Vec2& range) { return range.x <= view.frame && view.frame <= range.y; });
  return here != 0 ? here : trailWhere([&](const Vec2& range) {
    const double shared = std::min(range.y, proposed.y) - std::max(range.x, proposed.x);
    return shared > most * std::min(range.y - range.x, proposed.y - proposed.x);
  });
}

/// Of the selected limbs the one whose proposed moment is the strongest; the first where none makes any.
Result<const rig::Limb*> leadingLimb(const Session& session) {
  std::optional<rig::Moment> strongest;
  for (const std::string& limbId : session.view().selection.limbs()) {
    const rig::Limb* const limb = findLimb(session.document(), limbId);
    if (limb == nullptr) {
      return Error{"the character has no such limb", limbId, "pick a limb that was found"};
    }
    const std::optional<rig::Moment> moment = proposedMoment(session, limbId);
    strongest = moment && (!strongest || moment->strength > strongest->strength) ? moment : strongest;
  }
  return findLimb(session.document(), strongest ? strongest->limb : session.view().selection.limbs().front());
}

/// What is exaggerated at once: limbs, and the range of the one that leads.
struct Wanted {
  std::string leadingLimb;
  Vec2 leadingRange{0.0};
};

Result<Wanted> wantedOf(const Session& session) {
  const Result<const rig::Limb*> leading = leadingLimb(session);
  return leading ? Result<Wanted>(Wanted{(*leading)->id, workingRange(session, **leading)})
                 : Result<Wanted>(leading.error());
}

/// A range that was set counts for all limbs; else each has its own.
Vec2 rangeOf(const Session& session, const std::string& limbId, const Wanted& wanted) {
  const rig::Limb* const limb = findLimb(session.document(), limbId);
  return limb == nullptr || limbId == wanted.leadingLimb || isRangeSet(session.view())
             ? wanted.leadingRange
             : rangeBeside(session, *limb, wanted.leadingRange);
}

/// Adds a trail of the limb in what is free of the range.
Status addTrail(const Session& session, const std::string& limbId, const Vec2& range, bool exaggerated,
                ExaggerateTargets& targets) {
  const rig::Limb* const limb = findLimb(targets.document, limbId);
  if (limb == nullptr) {
    return Error{"the character has no such limb", limbTitle(targets.document, limbId),
                 "pick a limb that was found"};
  }
  const ViewState& view = session.view();
  const auto free = freeRange(targets.document, limbId, view.clip, range, view.frame);
  if (!free) {
    return Error{"a trail is there already", limbTitle(targets.document, limbId),
                 "select it, or set another range"};
  }
  rig::TrailSettings settings = newTrailSettings(session, *limb, *free);
  settings.scale = exaggerated ? firstScale : 1.0;
  Result<CreatedTrail> created =
      createTrail(targets.document, {limbId, view.clip, settings, exaggerated, exaggerated});
  if (!created) {
    return created.error();
  }
  targets.trailIds.push_back(created->trailId);
  targets.document = std::move(created->document);
  return Success{};
}

/// The limb's trail that is meant, else a new one over its range; where its range is taken, what takes it
/// acts with the other limbs.
Status addMeantTrail(const Session& session, const std::string& limbId, const Wanted& wanted,
                     ExaggerateTargets& targets) {
  const ViewState& view = session.view();
  const Vec2 range = rangeOf(session, limbId, wanted);
  if (const int meant = meantTrail(session, limbId, range); meant != 0) {
    targets.trailIds.push_back(meant);
    return Success{};
  }
  if (view.selection.limbs().size() > 1 &&
      !freeRange(targets.document, limbId, view.clip, range, view.frame)) {
    targets.trailIds.push_back(overlappingTrail(targets.document, limbId, view.clip, range.x, range.y)->id);
    return Success{};
  }
  return addTrail(session, limbId, range, true, targets);
}

/// The trail of the limb that leads comes first.
void leadWith(const std::string& limbId, ExaggerateTargets& targets) {
  const auto leads = [&](int id) { return findTrail(targets.document, id)->limb == limbId; };
  std::stable_partition(targets.trailIds.begin(), targets.trailIds.end(), leads);
}

/// New trails that were made at once are one group.
Status groupNew(const Document& before, ExaggerateTargets& targets) {
  std::vector<int> made;
  for (const int id : targets.trailIds) {
    if (findTrail(before, id) == nullptr) {
      made.push_back(id);
    }
  }
  if (made.size() < 2) {
    return Success{};
  }
  Result<Document> grouped = groupTrails(targets.document, made);
  if (!grouped) {
    return grouped.error();
  }
  targets.document = std::move(grouped).value();
  return Success{};
}

/// Limbs that were selected beside the trail's act with it: over its range, as one group.
Status joinOtherLimbs(const Session& session, const rig::Trail& selected, ExaggerateTargets& targets) {
  const Vec2 range(selected.settings.startFrame, selected.settings.endFrame);
  const std::size_t before = targets.trailIds.size();
  for (const std::string& limbId : session.view().selection.limbs()) {
    const bool acts = std::any_of(targets.trailIds.begin(), targets.trailIds.end(), [&](int id) {
      const rig::Trail* const trail = findTrail(targets.document, id);
      return trail != nullptr && trail->limb == limbId;
    });
    if (acts) {
      continue;
    }
    const rig::Trail* const present =
        overlappingTrail(targets.document, limbId, selected.clip, range.x, range.y);
    if (present != nullptr) {
      targets.trailIds.push_back(present->id);
    } else if (Status added = addTrail(session, limbId, range, true, targets); !added) {
      return added;
    }
  }
  if (targets.trailIds.size() == before) {
    return Success{};
  }
  Result<Document> grouped = groupTrails(targets.document, targets.trailIds);
  if (!grouped) {
    return grouped.error();
  }
  targets.document = std::move(grouped).value();
  return Success{};
}

/// Whether every target was made just now.
bool areNew(const Document& before, const ExaggerateTargets& targets) {
  return std::ranges::none_of(targets.trailIds, [&](int id) { return findTrail(before, id) != nullptr; });
}

/// The first trail of a clip says how it is meant; what is marked or not after it stays so. Weight that is
/// there already would move otherwise on a loop.
void loopWhereItHelps(const Document& before, int clip, ExaggerateTargets& targets) {
  const bool isFirst =
      std::ranges::none_of(before.trails, [&](const rig::Trail& trail) { return trail.clip == clip; });
  const auto hasNoRoom = [&](int id) {
    const rig::TrailSettings& settings = findTrail(targets.document, id)->settings;
    return lastFrame(before, clip) - settings.endFrame < settings.endFrame - settings.startFrame;
  };
  if (isFirst && !isLooping(before, clip) && !hasWeight(before, clip) &&
      std::ranges::any_of(targets.trailIds, hasNoRoom) && endsMeet(before, clip)) {
    targets.document = setLooping(targets.document, clip, true);
    targets.madeLoop = true;
  }
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

rig::TrailSettings newTrailSettings(const Session& session, const rig::Limb& limb, const Vec2& range) {
  const int clip = session.view().clip;
  rig::TrailSettings settings = startingTrail(session.document(), clip, limb, range);
  if (isLeg(limb) && !settings.stopAt) {
    settings.stopAt = floorForLeg(session.document(), clip, limb, range.y);
  }
  settings.viewAxes = session.view().cameraAxes;
  return settings;
}

Result<ExaggerateTargets> newTrails(const Session& session, bool exaggerated) {
  const ViewState& view = session.view();
  if (view.selection.limbs().empty()) {
    return Error{"no limb is selected", "", "press the key of one, or click it"};
  }
  if (!hasClip(session.document(), view.clip)) {
    return Error{"the file has no animation", "", "open a file with a clip"};
  }
  const Result<Wanted> wanted = wantedOf(session);
  if (!wanted) {
    return wanted.error();
  }
  ExaggerateTargets targets{session.document(), {}};
  for (const std::string& limbId : view.selection.limbs()) {
    const Vec2 range = rangeOf(session, limbId, *wanted);
    if (const Status added = addTrail(session, limbId, range, exaggerated, targets); !added) {
      return added.error();
    }
  }
  leadWith(wanted->leadingLimb, targets);
  if (const Status grouped = groupNew(session.document(), targets); !grouped) {
    return grouped.error();
  }
  return targets;
}

namespace {

Result<ExaggerateTargets> foundOrMade(const Session& session, OverlapChoice choice) {
  ExaggerateTargets targets{session.document(), {}};
  if (const rig::Trail* const selected = selectedTrail(session)) {
    targets.trailIds = targetTrails(session);
    if (const Status joined = joinOtherLimbs(session, *selected, targets); !joined) {
      return joined.error();
    }
  } else {
    if (session.view().selection.limbs().empty() || choice == OverlapChoice::beside) {
      return newTrails(session, true);
    }
    if (!hasClip(session.document(), session.view().clip)) {
      return Error{"the file has no animation", "", "open a file with a clip"};
    }
    const Result<Wanted> wanted = wantedOf(session);
    if (!wanted) {
      return wanted.error();
    }
    for (const std::string& limbId : session.view().selection.limbs()) {
      if (const Status added = addMeantTrail(session, limbId, *wanted, targets); !added) {
        return added.error();
      }
    }
    leadWith(wanted->leadingLimb, targets);
  }
  for (const int id : targets.trailIds) {
    exaggerate(*findTrail(targets.document, id));
  }
  if (const Status grouped = groupNew(session.document(), targets); !grouped) {
    return grouped.error();
  }
  return targets;
}

} // namespace

Result<ExaggerateTargets> exaggerateTargets(const Session& session, OverlapChoice choice) {
  Result<ExaggerateTargets> targets = foundOrMade(session, choice);
  if (targets) {
    loopWhereItHelps(session.document(), session.view().clip, *targets);
  }
  return targets;
}

std::optional<Vec2> nextStroke(const Session& session, const ExaggerateTargets& targets, bool forwards) {
  const Document& before = session.atBegin();
  const rig::Trail& leading = *findTrail(targets.document, targets.trailIds.front());
  const rig::Limb* const limb = findLimb(before, leading.limb);
  if (limb == nullptr || !areNew(before, targets)) {
    return std::nullopt;
  }
  std::vector<Vec2> free;
  for (const rig::Moment& stroke : session.momentsOf(limb->id)) {
    if (overlappingTrail(before, limb->id, leading.clip, stroke.startFrame, stroke.endFrame) == nullptr) {
      free.emplace_back(stroke.startFrame, stroke.endFrame);
    }
  }
  const double here = leading.settings.startFrame;
  std::erase_if(free, [&](const Vec2& range) {
    return range == Vec2(leading.settings.startFrame, leading.settings.endFrame);
  });
  if (free.empty()) {
    return std::nullopt;
  }
  const auto after = std::find_if(free.begin(), free.end(), [&](const Vec2& r) { return r.x > here; });
  return forwards ? (after == free.end() ? free.front() : *after)
                  : (after == free.begin() ? free.back() : *(after - 1));
}

Result<ExaggerateTargets> movedTo(const Session& session, const ExaggerateTargets& targets,
                                  const Vec2& range) {
  ExaggerateTargets moved = targets;
  for (const int id : targets.trailIds) {
    const rig::Trail& trail = *findTrail(targets.document, id);
    const rig::Limb& limb = *findLimb(targets.document, trail.limb);
    const bool leads = id == targets.trailIds.front();
    const Vec2 own = leads ? range : rangeBesideStroke(session, limb, range);
    rig::TrailSettings settings = newTrailSettings(session, limb, own);
    settings.scale = trail.settings.scale;
    Result<Document> changed = setTrailSettings(moved.document, id, settings);
    if (!changed) {
      return changed.error();
    }
    moved.document = std::move(changed).value();
  }
  if (!moved.madeLoop) {
    loopWhereItHelps(session.atBegin(), session.view().clip, moved);
  }
  return moved;
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
