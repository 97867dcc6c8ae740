#include <functional>
#include <string>

#include <catch2/catch.hpp>

#include "app/edits/trail/trail_edits.h"
#include "app/history.h"
#include "tests/support/app/boxer.h"

using namespace stretch;
using namespace stretch::app;

namespace {

Document looping(const Document& document, bool loops) {
  return setLooping(document, 0, loops);
}

// A document that counts how often any of its kind is copied or moved.
struct Counted {
  explicit Counted(int value) : number(value) {}
  Counted(const Counted& other) : number(other.number) { ++moves; }
  Counted(Counted&& other) noexcept : number(other.number) { ++moves; }
  Counted& operator=(const Counted& other) {
    number = other.number;
    ++moves;
    return *this;
  }
  Counted& operator=(Counted&& other) noexcept {
    number = other.number;
    ++moves;
    return *this;
  }
  ~Counted() = default;

  int number;
  static inline int moves = 0;
};
bool sameDocument(const Counted& a, const Counted& b) {
  return a.number == b.number;
}
std::size_t bytesBeyond(const Counted& /*document*/, const Counted& /*other*/) {
  return 1;
}

} // namespace

TEST_CASE("A step at the most that a history holds moves no other step") {
  constexpr int most = 1000;
  History<Counted> history(Counted(0), most);
  for (int i = 1; i <= 2 * most; ++i) {
    REQUIRE(history.push(Counted(i), "Step"));
  }
  REQUIRE(history.bytes() == most);
  Counted::moves = 0;
  for (int i = 1; i <= 100; ++i) {
    REQUIRE(history.push(Counted(-i), "Step"));
  }
  CHECK(Counted::moves <= 100 * 4);
  CHECK(history.position() == most);
  CHECK(history.at(0).number == most + 100);
  CHECK(history.current().number == -100);
}

TEST_CASE("A new history has nothing to undo and is saved") {
  History<Document> history(test::boxer());
  CHECK_FALSE(history.canUndo());
  CHECK_FALSE(history.canRedo());
  CHECK_FALSE(history.undo());
  CHECK_FALSE(history.redo());
  CHECK(history.undoLabel().empty());
  CHECK(history.redoLabel().empty());
  CHECK(history.isSaved());
}

TEST_CASE("Undo and redo walk between documents and name what they take back or bring") {
  const Document start = test::boxer();
  History<Document> history(start);
  REQUIRE(history.push(looping(start, true), "Loop the clip"));
  CHECK(history.undoLabel() == "Loop the clip");
  REQUIRE(history.undo());
  CHECK(sameDocument(history.current(), start));
  CHECK(history.redoLabel() == "Loop the clip");
  REQUIRE(history.redo());
  CHECK(history.current().loopingClips == std::vector<int>{0});
}

TEST_CASE("A state equal to the current one is no step") {
  const Document start = test::boxer();
  History<Document> history(start);
  CHECK_FALSE(history.push(looping(start, false), "Nothing"));
  CHECK_FALSE(history.canUndo());
}

TEST_CASE("A new edit drops what was undone") {
  const Document start = test::boxer();
  History<Document> history(start);
  history.push(looping(start, true), "First");
  history.undo();
  Document other = start;
  other.limbsCorrected = true;
  history.push(other, "Second");
  CHECK_FALSE(history.canRedo());
  CHECK(history.undoLabel() == "Second");
}

TEST_CASE("A document is saved where it was marked, and nowhere once that state is dropped") {
  const Document start = test::boxer();
  History<Document> history(start);
  history.push(looping(start, true), "First");
  CHECK_FALSE(history.isSaved());
  history.markSaved();
  CHECK(history.isSaved());
  history.undo();
  CHECK_FALSE(history.isSaved());
  Document other = start;
  other.limbsCorrected = true;
  history.push(other, "Second");
  CHECK_FALSE(history.isSaved());
  history.undo();
  CHECK_FALSE(history.isSaved());
}

TEST_CASE("Steps that take more than they may go, the oldest first, and the last can always be taken back") {
  const Document start = test::boxer();
  const std::size_t ofStep = bytesBeyond(looping(start, true), start);
  History<Document> history(start, 10 * ofStep + ofStep / 2);
  history.markSaved();
  for (int i = 0; i < 100; ++i) {
    REQUIRE(history.push(looping(start, i % 2 == 0), "Loop " + std::to_string(i)));
  }
  CHECK(history.bytes() <= 10 * ofStep + ofStep / 2);
  CHECK_FALSE(history.isSaved()); // The saved state went.
  int undone = 0;
  while (history.undo()) {
    ++undone;
  }
  CHECK(undone >= 9);
  CHECK(undone <= 12);
  while (history.redo()) {
  }
  CHECK(history.undoLabel() == "Loop 99");

  History<Document> small(start, 0);
  REQUIRE(small.push(looping(start, true), "Loop"));
  REQUIRE(small.undo());
  CHECK(sameDocument(small.current(), start));
  CHECK(small.isSaved());
}

TEST_CASE("A step of keys counts the tracks that it makes, and not those that it shares") {
  const Document start = test::boxer();
  Document edited = start;
  auto clips = *start.clips;
  clips[0].tracks[0].edit([](Track& track) { track.values[0] += 0.25F; });
  edited.clips = std::make_shared<const std::vector<Clip>>(clips);
  const Track& track = *clips[0].tracks[0];
  const std::size_t ofKeys = 4 * (track.times.size() + track.values.size());
  const std::size_t alone = bytesBeyond(start, start);
  CHECK(bytesBeyond(edited, start) >= alone + ofKeys);
  CHECK(bytesBeyond(edited, edited) == alone);
}

TEST_CASE("Whatever a step adds is counted with the texts and lists that it holds") {
  const Document start = test::boxer();
  const std::size_t alone = bytesBeyond(start, start);
  const std::string text(1000, 'x');
  struct Addition {
    const char* says;
    std::function<void(Document&)> add;
    std::size_t bytes; ///< At least.
  };
  const Addition additions[] = {
      {"images",
       [&](Document& d) {
         d.references.push_back({0, {.file = text}, {}});
       },
       sizeof(Reference) + 1000},
      {"a sound",
       [&](Document& d) {
         d.references.push_back({0, {}, {.file = text}});
       },
       sizeof(Reference) + 1000},
      {"a warning", [&](Document& d) { d.warnings.push_back(text); }, 1000},
      {"a set's name",
       [&](Document& d) {
         d.selectionSets.push_back({text, {}, {}});
       },
       1000},
      {"a set's limbs",
       [&](Document& d) {
         d.selectionSets.push_back({"", {text, text}, {}});
       },
       2000},
      {"a set's controllers",
       [&](Document& d) {
         d.selectionSets.push_back({"", {}, {text}});
       },
       1000},
      {"loops", [](Document& d) { d.loopingClips.assign(100, 0); }, 100 * sizeof(int)},
      {"rates", [](Document& d) { d.rates.resize(100); }, 100 * sizeof(ClipRate)},
      {"a chain's joints", [](Document& d) { d.chains.emplace_back().joints.resize(100); },
       100 * sizeof(NodeIndex)},
      {"a chain's reasons", [&](Document& d) { d.chains.emplace_back().reasons = {text}; }, 1000},
      {"a limb", [](Document& d) { d.body.limbs.push_back(d.body.limbs.front()); }, sizeof(rig::Limb)},
      {"a trail", [](Document& d) { d.trails.emplace_back(); }, sizeof(rig::Trail)},
      {"offsets", [](Document& d) { d.adjustments.emplace_back().keys.resize(10); },
       10 * sizeof(rig::OffsetKey)},
      {"weight", [](Document& d) { d.weights.emplace_back(); }, sizeof(WeightedLimb)},
      {"keys that follow", [](Document& d) { d.followingKeys.emplace_back().keys.resize(100); }, 100}};
  for (const Addition& addition : additions) {
    CAPTURE(addition.says);
    Document more = start;
    addition.add(more);
    CHECK(bytesBeyond(more, start) >= alone + addition.bytes);
  }
}
