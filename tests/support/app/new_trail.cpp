#include "tests/support/app/new_trail.h"

#include <catch2/catch.hpp>

#include "app/edits/trail/trail_edits.h"

namespace stretch::test {

app::Document withNewTrail(const app::Document& document, const WantedTrail& wanted) {
  app::NewTrail trail;
  trail.limb = wanted.limb;
  trail.settings.startFrame = wanted.startFrame;
  trail.settings.endFrame = wanted.endFrame;
  trail.settings.scale = wanted.scale;
  trail.exaggerated = true;
  trail.connected = wanted.connected;
  const Result<app::CreatedTrail> created = app::createTrail(document, trail);
  REQUIRE(created);
  return created->document;
}

} // namespace stretch::test
