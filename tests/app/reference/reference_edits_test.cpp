#include <catch2/catch.hpp>

#include "app/edits/keys/rate_edits.h"
#include "app/files/saved_work.h"
#include "app/recipe/recipe.h"
#include "app/recipe/replay.h"
#include "app/reference/reference_edits.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/posed_file.h"
#include "tests/support/refusal.h"

using namespace stretch;
using namespace stretch::app;
using gltf::Json;

namespace {

/// Every setting is another than its default.
Reference whole(int clip = 0) {
  return {clip,
          {"/films/film-1.png", 12.0, 25.0, ReferencePlace::left, 0.75, 0.5},
          {"/sounds/beat.wav", -6.0, 0.25}};
}

std::string referenceProblem(const Json& json) {
  const Result<Reference> read = referenceFromJson(json, 0, "/recipes");
  return read ? std::string() : read.error().where + ": " + read.error().what;
}

} // namespace

TEST_CASE("A clip refers to one thing at a time: another takes its place, and none takes it away") {
  const Document document = test::boxer();
  CHECK(referenceOf(document, 0) == Reference{});
  const Document refers = withReference(document, whole());
  CHECK(referenceOf(refers, 0) == whole());
  CHECK(referenceOf(refers, 1) == Reference{.clip = 1});
  CHECK_FALSE(sameDocument(document, refers));
  Reference soundAlone = whole();
  soundAlone.images = {};
  const Document changed = withReference(refers, soundAlone);
  REQUIRE(changed.references.size() == 1);
  CHECK(changed.references[0] == soundAlone);
  Reference imagesAlone = whole();
  imagesAlone.sound = {};
  CHECK(withReference(refers, imagesAlone).references.size() == 1);
  CHECK(withReference(refers, {}).references.empty());
  const Document both = withReference(withReference(document, whole(1)), whole(0));
  REQUIRE(both.references.size() == 2);
  CHECK(both.references[0].clip == 0);
  CHECK(both.references[1].clip == 1);
}

TEST_CASE("Each part of a reference makes another document") {
  const Document document = withReference(test::boxer(), whole());
  const auto differs = [&](auto&& change) {
    Reference other = whole();
    change(other);
    return !sameDocument(document, withReference(document, other));
  };
  CHECK_FALSE(differs([](Reference&) {}));
  CHECK(differs([](Reference& r) { r.images.file = "/films/other-1.png"; }));
  CHECK(differs([](Reference& r) { r.images.startFrame = 1.0; }));
  CHECK(differs([](Reference& r) { r.images.imagesPerSecond.reset(); }));
  CHECK(differs([](Reference& r) { r.images.place = ReferencePlace::right; }));
  CHECK(differs([](Reference& r) { r.images.size = 1.0; }));
  CHECK(differs([](Reference& r) { r.images.opacity = 1.0; }));
  CHECK(differs([](Reference& r) { r.sound.file = "/sounds/other.wav"; }));
  CHECK(differs([](Reference& r) { r.sound.startFrame = 1.0; }));
  CHECK(differs([](Reference& r) { r.sound.volume = 1.0; }));
}

TEST_CASE("A reference is read as it was written, and where it lies beside the recipe by that") {
  const Result<Reference> read = referenceFromJson(referenceToJson(whole()), 0, "/recipes");
  REQUIRE(read);
  CHECK(*read == whole());
  const Result<Reference> beside = referenceFromJson(
      {{"images", {{"first_image", "film/f-1.png"}}}, {"sound", {{"sound_file", "beat.wav"}}}}, 2,
      "/recipes");
  REQUIRE(beside);
  CHECK(beside->clip == 2);
  CHECK(beside->images == ReferenceImages{.file = "/recipes/film/f-1.png"});
  CHECK(beside->sound == ReferenceSound{.file = "/recipes/beat.wav"});
  CHECK(referenceToJson({}).empty());
}

TEST_CASE("What is no reference is refused with the key and what is wrong") {
  CHECK(referenceProblem(3) == ": is not an object");
  CHECK(referenceProblem({{"film", {{"file", "a.png"}}}}) == "film: is not a part of a reference");
  CHECK(referenceProblem({{"images", 3}}) == "images: is not an object");
  CHECK(referenceProblem({{"sound", "a.wav"}}) == "sound: is not an object");
  CHECK(referenceProblem({{"images", Json::object()}}) == "images: names no file");
  CHECK(referenceProblem({{"sound", {{"volume", 0.5}}}}) == "sound: names no file");
  CHECK_THAT(referenceProblem({{"images", {{"first_image", "a.png"}, {"where", "above"}}}}),
             Catch::StartsWith("images.where: "));
  CHECK_THAT(referenceProblem({{"images", {{"first_image", "a.png"}, {"images_per_second", 0}}}}),
             Catch::StartsWith("images.images_per_second: "));
  CHECK_THAT(referenceProblem({{"sound", {{"sound_file", "a.wav"}, {"volume", 2}}}}),
             Catch::StartsWith("sound.volume: "));
  CHECK(referenceProblem({{"sound", {{"sound_file", "a.wav"}, {"speed", 2}}}}) ==
        "sound.speed: is not a setting of a reference");
}

TEST_CASE("A recipe brings its reference along, at frames as it counts them") {
  Document document = test::boxer();
  const Json recipe = recipeToJson(withReference(document, whole()), 0);
  const Result<Recipe> read = recipeFromJson(recipe, document);
  REQUIRE(read);
  CHECK(read->reference == whole());
  const Result<PlacedTrails> placed = withRecipe(document, *read);
  REQUIRE(placed);
  CHECK(referenceOf(placed->document, 0) == whole());
  // What a recipe leaves out of it stays.
  Reference imagesAlone = whole();
  imagesAlone.sound = {};
  imagesAlone.images.opacity = 0.125;
  Document other = test::boxer();
  const Result<Recipe> half = recipeFromJson(recipeToJson(withReference(other, imagesAlone), 0), other);
  REQUIRE(half);
  const Reference mixed = referenceOf(withRecipe(withReference(other, whole()), *half)->document, 0);
  CHECK(mixed.images == imagesAlone.images);
  CHECK(mixed.sound == whole().sound);
  // One that has none leaves what is there.
  const Document refers = withReference(document, whole());
  Document fresh = test::boxer();
  const Result<Recipe> without = recipeFromJson({{"version", 1}, {"trails", Json::array()}}, fresh);
  REQUIRE(without);
  CHECK(referenceOf(withRecipe(refers, *without)->document, 0) == whole());
  // Counted twice as fast, the recipe's frame 12 is the clip's frame 6.
  const double rate = clipOf(document, 0).framesPerSecond;
  Json twice{{"version", 1}, {"frames_per_second", 2.0 * rate}, {"references", recipe["references"]}};
  const Result<Recipe> slower = recipeFromJson(twice, document);
  REQUIRE(slower);
  CHECK(slower->reference.images.startFrame == Approx(6.0));
  CHECK(slower->reference.sound.startFrame == Approx(-3.0));
  twice["references"] = 3;
  const Result<Recipe> wrong = recipeFromJson(twice, document);
  REQUIRE_FALSE(wrong);
  CHECK(wrong.error().where == "references");
}

TEST_CASE("At another rate of the clip a reference begins at the same time, those of other clips stay") {
  Document document = withReference(test::boxer(), whole(0));
  document.references.push_back(whole(1));
  const double rate = clipOf(document, 0).framesPerSecond;
  const Document twice = workAtRate(document, 0, 2.0 * rate);
  CHECK(twice.references[0].images.startFrame == Approx(24.0));
  CHECK(twice.references[0].sound.startFrame == Approx(-12.0));
  CHECK(twice.references[1] == whole(1));
}

TEST_CASE("The file knows nothing of a reference, the user's settings keep it by the clip's name") {
  const Document document = withReference(test::boxer(), whole());
  CHECK(workOf(document).is_null());
  CHECK(referencesFromJson(referencesToJson(document), document) == document.references);
  CHECK(referencesFromJson({}, document).empty());
  CHECK(referencesFromJson(Json::array(), document).empty());
  const auto kept = [&](const Json& clip, const Json& name, const Json& reference) {
    const Json entry{{"clip", clip}, {"name", name}, {"refers_to", reference}};
    return referencesFromJson(Json::array({entry}), document);
  };
  const std::string clip = clipOf(document, 0).name;
  CHECK(kept(0, clip, referenceToJson(whole())) == document.references);
  CHECK(kept(7, clip, referenceToJson(whole())) == document.references); // it has another number now
  CHECK(kept(0, "another clip", referenceToJson(whole())).empty());
  // What cannot be understood is left out.
  CHECK(kept(0, 3, referenceToJson(whole())).empty());
  CHECK(kept(0, clip, {{"images", 3}}).empty());
  CHECK(kept(0, clip, Json::object()).empty());
  CHECK(referencesFromJson(Json::array({3, Json::object()}), document).empty());
  // Whatever stands for the number, the name tells the clip.
  CHECK(kept("first", clip, referenceToJson(whole())) == document.references);
  const Json unnumbered{{"name", clip}, {"refers_to", referenceToJson(whole())}};
  CHECK(referencesFromJson(Json::array({unnumbered}), document) == document.references);
  const Json bare{{"clip", 0}, {"name", clip}};
  CHECK(referencesFromJson(Json::array({bare}), document).empty());
}

TEST_CASE("Of two references that are kept of one clip the first counts, and they come in the clips' order") {
  Document document = test::boxer();
  std::vector<Clip> clips(2, document.clips->front());
  clips[1].name = "second punch";
  document.clips = std::make_shared<const std::vector<Clip>>(clips);
  document.references = {whole(0), whole(1)};
  const Json kept = referencesToJson(document);
  CHECK(referencesFromJson(Json::array({kept[1], kept[0]}), document) == document.references);
  Json other = kept[0];
  other["refers_to"]["images"]["first_image"] = "/films/other-1.png";
  CHECK(referencesFromJson(Json::array({kept[0], other, kept[1]}), document) == document.references);
}

TEST_CASE("Of clips that have one name each keeps its own reference") {
  Document document = test::boxer();
  auto clips = std::make_shared<std::vector<Clip>>(2, document.clips->front());
  document.clips = clips;
  document.references = {whole(0), whole(1)};
  document.references[1].images.file = "/films/second-1.png";
  CHECK(referencesFromJson(referencesToJson(document), document) == document.references);
  // By the name alone nobody knows which of them is meant.
  Json moved = referencesToJson(document);
  moved[0]["clip"] = 5;
  const std::vector<Reference> read = referencesFromJson(moved, document);
  REQUIRE(read.size() == 1);
  CHECK(read[0] == document.references[1]);
}

TEST_CASE("The user's settings count frames in the clip's own rate, whatever it is worked on at") {
  const Document document = withReference(test::boxer(), whole());
  const Document twice = workAtRate(document, 0, 2.0 * clipOf(document, 0).framesPerSecond);
  CHECK(referencesToJson(twice) == referencesToJson(document));
  CHECK(referencesFromJson(referencesToJson(document), twice) == twice.references);
}
