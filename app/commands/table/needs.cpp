#include "app/commands/table/needs.h"

#include "app/commands/table/frames.h"
#include "app/commands/table/selection.h"

namespace stretch::app {

namespace {

bool viewsAClip(const Session& session) {
  return hasClip(session.document(), session.view().clip);
}

bool hasLimbInClip(const Session& session) {
  return !session.view().selection.limbs().empty() && viewsAClip(session);
}

bool hasTargetTrail(const Session& session) {
  return !targetTrails(session).empty();
}

} // namespace

Need clipNeeded() {
  return {viewsAClip, "open a character with a clip"};
}

Need limbNeeded() {
  return {hasLimbInClip, "select a limb first"};
}

Need targetNeeded() {
  return {hasTargetTrail, "select a trail first"};
}

Need selectedTrailNeeded() {
  return {hasSelectedTrail, "select a trail first"};
}

} // namespace stretch::app
