#include <memory>
#include <vector>

#include <catch2/catch.hpp>

#include "app/evaluate/cache.h"
#include "app/evaluate/evaluate.h"
#include "app/history.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/random_edits.h"

using namespace stretch;
using namespace stretch::app;

TEST_CASE("random edits, all undone, give the start back, and all redone, the end") {
  for (const unsigned seed : {1U, 2U, 3U}) {
    test::Dice dice(seed);
    const Document start = test::boxer();
    History<Document> history(start);
    int pushed = 0;
    for (int i = 0; i < 300; ++i) {
      const Document before = history.current();
      const bool isNew = history.push(test::randomEdit(before, dice), "edit");
      pushed += isNew ? 1 : 0;
      CHECK(isNew != sameDocument(before, history.current()));
    }
    CHECK(pushed > 100);
    const Document end = history.current();
    int undone = 0;
    while (history.undo()) {
      ++undone;
    }
    CHECK(undone == pushed);
    CHECK(sameDocument(history.current(), start));
    while (history.redo()) {
    }
    CHECK(sameDocument(history.current(), end));
  }
}

TEST_CASE("what the cache answers is what evaluation without one gives, over random edits") {
  test::Dice dice(7);
  Document document = test::boxer();
  EvaluationCache cache;
  for (int i = 0; i < 200; ++i) {
    document = test::randomEdit(document, dice);
    const double seconds = dice.below(21) / 30.0;
    const FrameState& cached = cache.frame(document, 0, seconds);
    const FrameState fresh = evaluate(document, prepareMotion(document, 0), seconds);
    CHECK(cached.worlds == fresh.worlds);
    CHECK(cached.stretch == fresh.stretch);
    const std::vector<TrailPaths>& cachedPaths = cache.paths(document, 0, 2);
    const std::vector<TrailPaths> freshPaths = trailPaths(document, prepareMotion(document, 0), 2);
    REQUIRE(cachedPaths.size() == freshPaths.size());
    for (std::size_t k = 0; k < freshPaths.size(); ++k) {
      CHECK(cachedPaths[k].drawn.frames == freshPaths[k].drawn.frames);
      CHECK(cachedPaths[k].drawn.original == freshPaths[k].drawn.original);
      CHECK(cachedPaths[k].drawn.exaggerated == freshPaths[k].drawn.exaggerated);
      CHECK(cachedPaths[k].spheres.frames == freshPaths[k].spheres.frames);
      CHECK(cachedPaths[k].spheres.exaggerated == freshPaths[k].spheres.exaggerated);
    }
  }
}

TEST_CASE("the cache keeps what it keys on, so that no other document is taken for it") {
  EvaluationCache cache;
  std::weak_ptr<const Scene> scene;
  std::weak_ptr<const std::vector<Clip>> clips;
  {
    const Document document = test::boxer();
    scene = document.scene;
    clips = document.clips;
    static_cast<void>(cache.frame(document, 0, 0.0));
    static_cast<void>(cache.original(document, 0, 0.0));
  }
  CHECK_FALSE(scene.expired());
  CHECK_FALSE(clips.expired());
}
