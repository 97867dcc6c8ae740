// What commands do in the second clip of two that are alike: the same as in the first, and nothing to that.
#include <algorithm>
#include <iterator>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "app/commands/keys/clips.h"
#include "app/commands/keys/keys.h"
#include "app/commands/table/command_ids.h"
#include "app/commands/table/document_commands.h"
#include "app/commands/table/selection.h"
#include "app/open_document.h"
#include "app/things/place.h"
#include "tests/support/app/things_of_clip.h"

using namespace stretch;
using namespace stretch::app;

namespace {

/// Two clips that are alike, with a thing of each kind in both: those of `clip` came first.
Document withBoth(int clip) {
  Document document = test::twoPunches();
  for (const int each : {clip, 1 - clip}) {
    const Result<Placed> made = place(document, test::oneOfEach(each, 0.5), Entry::request);
    REQUIRE(made);
    document = made->document;
  }
  return document;
}

/// The document with both clips in each other's place, and all that says which clip it is of.
Document withClipsSwapped(Document document) {
  const auto swap = [](auto& list) {
    for (auto& thing : list) {
      thing.clip = 1 - thing.clip;
    }
  };
  swap(document.trails);
  swap(document.adjustments);
  swap(document.holds.pins);
  swap(document.holds.grips);
  swap(document.holds.props);
  swap(document.weights);
  swap(document.rates);
  swap(document.followingKeys);
  for (int& looping : document.loopingClips) {
    looping = 1 - looping;
  }
  for (auto* const clips : {&document.clips, &document.sourceClips}) {
    if (*clips != nullptr && (*clips)->size() == 2) {
      std::vector<Clip> other{(**clips)[1], (**clips)[0]};
      for (std::size_t i = 0; i < other.size(); ++i) {
        other[i].name = (**clips)[i].name;
        other[i].sourceIndex = (**clips)[i].sourceIndex;
      }
      *clips = std::make_shared<const std::vector<Clip>>(std::move(other));
    }
  }
  return document;
}

// But for the order of things of different clips, which does not show.
void checkAlike(Document a, Document b) {
  for (Document* const document : {&a, &b}) {
    const auto ofClip = [](const auto& thing) { return thing.clip; };
    std::ranges::stable_sort(document->trails, {}, ofClip);
    std::ranges::stable_sort(document->adjustments, {}, ofClip);
    std::ranges::stable_sort(document->holds.pins, {}, ofClip);
    std::ranges::stable_sort(document->holds.grips, {}, ofClip);
    std::ranges::stable_sort(document->holds.props, {}, ofClip);
    std::ranges::stable_sort(document->weights, {}, ofClip);
    std::ranges::stable_sort(document->rates, {}, ofClip);
    std::ranges::stable_sort(document->followingKeys, {}, ofClip);
    std::ranges::sort(document->loopingClips);
  }
  CHECK(a.trails == b.trails);
  CHECK(a.adjustments == b.adjustments);
  CHECK(a.holds.pins == b.holds.pins);
  CHECK(a.holds.grips == b.holds.grips);
  CHECK(a.holds.props == b.holds.props);
  CHECK(a.weights == b.weights);
  CHECK(a.rates == b.rates);
  CHECK(a.loopingClips == b.loopingClips);
  CHECK(a.followingKeys == b.followingKeys);
  REQUIRE(a.clips->size() == b.clips->size());
  for (std::size_t i = 0; i < a.clips->size(); ++i) {
    CHECK((*a.clips)[i].tracks == (*b.clips)[i].tracks);
    CHECK((*a.clips)[i].framesPerSecond == (*b.clips)[i].framesPerSecond);
  }
}

template <typename Thing>
std::vector<Thing> thingsIn(const std::vector<Thing>& all, int clip) {
  std::vector<Thing> some;
  std::ranges::copy_if(all, std::back_inserter(some), [&](const Thing& thing) { return thing.clip == clip; });
  return some;
}

/// That a clip has what it had: all that stands in its time, its keys, its rate and its loop.
void checkLeftAlone(const Document& before, const Document& after, int clip) {
  CHECK(thingsIn(after.trails, clip) == thingsIn(before.trails, clip));
  CHECK(thingsIn(after.adjustments, clip) == thingsIn(before.adjustments, clip));
  CHECK(thingsIn(after.holds.pins, clip) == thingsIn(before.holds.pins, clip));
  CHECK(thingsIn(after.holds.grips, clip) == thingsIn(before.holds.grips, clip));
  CHECK(thingsIn(after.holds.props, clip) == thingsIn(before.holds.props, clip));
  CHECK(thingsIn(after.weights, clip) == thingsIn(before.weights, clip));
  CHECK(clipOf(after, clip).tracks == clipOf(before, clip).tracks);
  CHECK(clipOf(after, clip).framesPerSecond == clipOf(before, clip).framesPerSecond);
  CHECK(isLooping(after, clip) == isLooping(before, clip));
}

/// Whether a command is one that acts on the whole work: on the last step, on the limbs, on all keys.
bool isOfAllClips(const std::string& id) {
  return id == command::undo || id == command::redo || id == command::detectAgain ||
         id == command::keysRestoreAll || id.starts_with(command::planPrefix);
}

/// What is selected before, in the clip that is looked at.
struct Selected {
  const char* name;
  void (*prepare)(Session& session, int clip);
};

int trailIn(const Session& session, int clip) {
  return std::ranges::find(session.document().trails, clip, &rig::Trail::clip)->id;
}

void pickSome(Session& session, double firstFrame, double lastFrame) {
  selectLimb(session, "left-arm", false);
  session.view().keyRows = rowsOfSelection(session);
  pickKeys(
      session,
      keysBetween(session.document(), session.view().clip, session.view().keyRows, firstFrame, lastFrame),
      false);
}

const std::vector<Selected> selections{
    {"nothing", [](Session&, int) {}},
    {"an arm that leads", [](Session& session, int) { selectLimb(session, "left-arm", false); }},
    {"an arm that follows", [](Session& session, int) { selectLimb(session, "right-arm", false); }},
    {"a trail", [](Session& session, int clip) { selectTrail(session, trailIn(session, clip)); }},
    {"controllers",
     [](Session& session, int) {
       selectControllers(session, {"left-hand", "hips"});
     }},
    {"keys", [](Session& session, int) { pickSome(session, 4.0, 11.0); }},
    {"keys that were copied",
     [](Session& session, int) {
       pickSome(session, 4.0, 11.0);
       session.view().copiedKeys = copyKeys(session.document(), session.view().clip, pickedKeys(session));
     }},
};

struct Done {
  Document document;
  std::string refusal;
  std::string label;
  ViewState view;
};

Done doneIn(const DocumentCommand& command, const Selected& selected, int clip) {
  OpenDocument open{Opened{test::twoPunches()}};
  Session& session = *open.character();
  session.view().clip = clip;
  session.edit(withBoth(clip), "Place");
  session.view().frame = 8.0;
  selected.prepare(session, clip);
  Done done{session.document(), whyOff(command, open), {}, {}};
  if (isEnabled(command, open)) {
    const Status ran = run(command, open);
    done = {session.document(), ran ? std::string() : ran.error().line(), session.history().undoLabel(), {}};
  }
  done.view = session.view();
  return done;
}

// What they do hangs on where the clip stands among the others.
const std::set<std::string>& orderOfClips() {
  static const std::set<std::string> ids{command::clipNext, command::clipPrevious};
  return ids;
}

} // namespace

TEST_CASE("Every command does in the second clip what it does in the first", "[clip-symmetry]") {
  std::size_t changes = 0;
  for (const DocumentCommand& command : documentCommands()) {
    if (!command.run || orderOfClips().contains(command.id)) {
      continue;
    }
    for (const Selected& selected : selections) {
      INFO(command.id << " with " << selected.name);
      const Done first = doneIn(command, selected, 0);
      const Done second = doneIn(command, selected, 1);
      checkAlike(first.document, withClipsSwapped(second.document));
      if (!isOfAllClips(command.id)) {
        checkLeftAlone(withBoth(0), first.document, 1);
      }
      CHECK(first.refusal == second.refusal);
      CHECK(first.label == second.label);
      CHECK(first.view.frame == second.view.frame);
      CHECK(first.view.rangeStart == second.view.rangeStart);
      CHECK(first.view.rangeEnd == second.view.rangeEnd);
      CHECK(first.view.clip == 1 - second.view.clip);
      CHECK(first.view.pickedKeys == second.view.pickedKeys);
      CHECK((first.view.pickedKeys.empty() || first.view.pickedClip == first.view.clip));
      CHECK((second.view.pickedKeys.empty() || second.view.pickedClip == second.view.clip));
      changes += sameDocument(first.document, withBoth(0)) ? 0U : 1U;
    }
  }
  CHECK(changes > 60);
}

TEST_CASE("Keys that are picked are those of the clip that was looked at then", "[clip-symmetry]") {
  const int clip = GENERATE(0, 1);
  Session session(test::twoPunches());
  session.view().clip = clip;
  pickSome(session, 4.0, 11.0);
  CHECK(session.view().pickedClip == clip);
  REQUIRE(keyCount(pickedKeys(session)) == 2);
  CHECK(hasPickedKeys(session));
  const KeySelection ofFirst = pickedKeys(session);
  session.view().clip = 1 - clip;
  CHECK_FALSE(hasPickedKeys(session));
  CHECK(pickedKeys(session).empty());
  // Added to those of another clip they stand alone.
  const KeySelection more = keysBetween(session.document(), 1 - clip, session.view().keyRows, 0.0, 1.0);
  pickKeys(session, more, true);
  CHECK(pickedKeys(session) == more);
  CHECK(session.view().pickedClip == 1 - clip);
  pickKeys(session, keysBetween(session.document(), 1 - clip, session.view().keyRows, 19.0, 20.0), true);
  CHECK(keyCount(pickedKeys(session)) == 2);
  session.view().clip = clip;
  pickKeys(session, ofFirst, false);
  CHECK(pickedKeys(session) == ofFirst);
}

TEST_CASE("Where the rate of a clip changes that was just gone to, the playhead stays where it is in time",
          "[clip-symmetry]") {
  const int clip = GENERATE(0, 1);
  OpenDocument open{Opened{test::twoPunches()}};
  Session& session = *open.character();
  showClip(session, 1);
  showClip(session, clip);
  session.view().frame = 10.0;
  session.view().rangeStart = 5.0;
  session.view().rangeEnd = 15.0;
  const std::vector<DocumentCommand> commands = documentCommands();
  const auto slower = std::ranges::find(commands, std::string(command::clipRate24), &DocumentCommand::id);
  REQUIRE(run(*slower, open));
  CHECK(session.view().frame == 8.0);
  CHECK(session.view().rangeStart == 4.0);
  CHECK(session.view().rangeEnd == 12.0);
}
