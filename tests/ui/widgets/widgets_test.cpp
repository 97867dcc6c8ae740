#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

#include <catch2/catch.hpp>

#include "core/math/srgb.h"
#include "rig/plan/body_plan.h"
#include "ui/widgets/arithmetic.h"
#include "ui/widgets/axis.h"
#include "ui/widgets/curve_view.h"
#include "ui/widgets/fuzzy.h"
#include "ui/widgets/limb_diagram.h"
#include "ui/widgets/remap_editor.h"
#include "ui/widgets/slider.h"
#include "ui/widgets/theme.h"

using namespace stretch;
using namespace stretch::ui;

namespace {

/// Relative luminance and contrast as WCAG 2.1 defines them.
double luminance(ImU32 colour) {
  const ImVec4 c = ImGui::ColorConvertU32ToFloat4(colour);
  return 0.2126 * linearFromSrgb(static_cast<double>(c.x)) +
         0.7152 * linearFromSrgb(static_cast<double>(c.y)) +
         0.0722 * linearFromSrgb(static_cast<double>(c.z));
}

double contrast(ImU32 a, ImU32 b) {
  const double first = luminance(a) + 0.05;
  const double second = luminance(b) + 0.05;
  return std::max(first, second) / std::min(first, second);
}

/// Points of the box, two pixels apart, at which this part is hit.
std::vector<ImVec2> pointsOf(const Rect& box, const std::vector<DiagramPart>& parts, std::size_t part) {
  std::vector<ImVec2> points;
  for (float x = box.min.x; x <= box.max.x; x += 2.0F) {
    for (float y = box.min.y; y <= box.max.y; y += 2.0F) {
      if (partAt(box, parts, {x, y}) == part) {
        points.emplace_back(x, y);
      }
    }
  }
  return points;
}

} // namespace

TEST_CASE("Text stands out from what it is drawn on in every theme") {
  for (const ThemeKind kind : {ThemeKind::dark, ThemeKind::light, ThemeKind::highContrast}) {
    const ThemeColours c = coloursOf(kind);
    CAPTURE(static_cast<int>(kind));
    constexpr double readable = 4.5;
    CHECK(contrast(c.text, c.panel) > 7.0);
    CHECK(contrast(c.text, c.raised) > 7.0);
    CHECK(contrast(c.quietText, c.panel) > readable);
    CHECK(contrast(c.quietText, c.sunken) > readable);
    CHECK(contrast(c.onAccent, c.accent) > readable);
    CHECK(contrast(c.accent, c.accentQuiet) > readable);
    CHECK(contrast(c.warning, c.panel) > readable);
    CHECK(contrast(c.error, c.panel) > readable);
  }
}

TEST_CASE("A font that is not installed is not found") {
  CHECK(findFont("No Such Family At All", 80).empty());
}

TEST_CASE("Every part of the drawn body is hit at its own place") {
  const Rect box{{100.0F, 50.0F}, {340.0F, 330.0F}};
  for (const rig::BodyPlan& plan : rig::bodyPlans()) {
    CAPTURE(plan.id);
    std::vector<DiagramPart> parts;
    for (const rig::PlannedLimb& limb : plan.limbs) {
      DiagramPart part{.id = limb.id};
      for (const rig::FigureBone& bone : limb.bones) {
        part.bones.push_back(
            {{bone.fromX, bone.fromY}, bone.fromRadius, {bone.toX, bone.toY}, bone.toRadius});
      }
      parts.push_back(part);
    }
    for (std::size_t i = 0; i < parts.size(); ++i) {
      CAPTURE(parts[i].id);
      const std::vector<ImVec2> inside = pointsOf(box, parts, i);
      REQUIRE_FALSE(inside.empty());
      const float middle = std::accumulate(inside.begin(), inside.end(), 0.0F,
                                           [](float sum, const ImVec2& point) { return sum + point.x; }) /
                           static_cast<float>(inside.size());
      const bool onTheRight = middle > box.centre().x + 1.0F;
      const bool isLeft = plan.limbs[i].place.side == rig::LimbSide::left;
      if (plan.limbs[i].place.side != rig::LimbSide::middle) {
        CHECK((onTheRight == isLeft) == (plan.view == rig::FigureView::front));
      }
    }
    CHECK_FALSE(partAt(box, parts, {101.0F, 51.0F}));
  }
}

TEST_CASE("Commands are found by a few of their letters, the best match first") {
  CHECK(fuzzyScore("", "anything"));
  CHECK(fuzzyScore("mt", "Motion trail"));
  CHECK_FALSE(fuzzyScore("xq", "Motion trail"));
  CHECK_FALSE(fuzzyScore("liart", "trail"));
  CHECK(*fuzzyScore("tra", "Motion trail") > *fuzzyScore("tra", "Forget the range"));
  CHECK(*fuzzyScore("save", "Save") > *fuzzyScore("save", "Save as"));
  CHECK(fuzzyScore("save  ", "Save")); // A blank behind the word asks for nothing.
  CHECK(fuzzyScore(std::string(200, 'a'), std::string(2000, 'a')));
}

TEST_CASE("Words are found as words, as beginnings and inside, and scattered letters are not") {
  CHECK(wordScore("", "anything"));
  CHECK(wordScore("  ", "anything"));
  CHECK(wordScore("SELECTION", "Frame the selection"));
  CHECK(wordScore("sel fra", "Frame the selection"));
  CHECK(wordScore("lection", "Frame the selection"));
  CHECK(wordScore("frsel", "Frame the selection"));
  CHECK(wordScore("fts", "Frame the selection"));
  CHECK_FALSE(wordScore("film", "Find the limbs again"));
  CHECK_FALSE(wordScore("light", "Select right arm"));
  CHECK_FALSE(wordScore("frame view", "Frame the selection"));
  CHECK_FALSE(wordScore("le", "Frame the selection")); // two letters inside of a word
  CHECK_FALSE(wordScore("stf", "Frame the selection"));
  CHECK_FALSE(wordScore("fts", "Frame the selection", false));
  CHECK(wordScore("sel fra", "Frame the selection", false));
  CHECK(*wordScore("save", "Save") > *wordScore("save", "Save incremental"));
  CHECK(*wordScore("save", "Save as") > *wordScore("save", "Export and save"));
  CHECK(*wordScore("sav", "Save") < *wordScore("save", "Save"));
  CHECK(*wordScore("range", "Forget the range") > *wordScore("range", "Arrangement"));
  CHECK(*wordScore("sel", "Frame the selection") > *wordScore("fts", "Frame the selection"));
  CHECK_FALSE(wordScore(std::string(40, 'a'), "a a a a a a a a a a a a a a a a a a a a a a a a a b"));
}

TEST_CASE("A name is found by its words in any order, however they are parted and written") {
  CHECK(holdsWords("melee attack", "1H_Melee_Attack_Chop"));
  CHECK(holdsWords("CHOP 1h", "1H_Melee_Attack_Chop"));
  CHECK(holdsWords("jab left", "Fighting Left Jab"));
  CHECK(holdsWords("leftjab", "fighting.left-jab"));
  CHECK(holdsWords(" left_jab ", "Fighting Left Jab"));
  CHECK(holdsWords("", "anything"));
  CHECK_FALSE(holdsWords("jab right", "Fighting Left Jab"));
  CHECK_FALSE(holdsWords("right jab", "Fighting Left Jab"));
}

TEST_CASE("Numbers are read as people type them") {
  CHECK(typedNumber("2.5", 0.0) == 2.5);
  CHECK(typedNumber("2,5", 0.0) == 2.5);
  CHECK(typedNumber(" x3 ", 0.0) == 3.0);
  CHECK(typedNumber("-12 %", 0.0) == -12.0);
  CHECK_FALSE(typedNumber("", 0.0));
  CHECK_FALSE(typedNumber("two", 0.0));
  CHECK_FALSE(typedNumber("1e999", 0.0));
  CHECK_FALSE(typedNumber("nan", 0.0));
}

TEST_CASE("Marks of an axis are round numbers, far enough apart") {
  const Axis axis{0.0, 60.0, 0.0F, 600.0F};
  CHECK(markStep(axis, 50.0F, true) == Approx(5.0));
  CHECK(markStep(axis, 51.0F, true) == Approx(10.0));
  CHECK(markStep(axis, 1.0F, true) == Approx(1.0));
  CHECK(markStep(axis, 1.0F, false) == Approx(0.1));
  CHECK(marks(axis, 20.0) == std::vector<double>{0.0, 20.0, 40.0, 60.0});
  CHECK(axis.toValue(axis.toPixel(17.0)) == Approx(17.0));
}

TEST_CASE("Zooming keeps what is under the mouse where it is") {
  const Span span = zoomed({0.0, 100.0}, 25.0, 0.5, 4.0, 1000.0);
  CHECK(span.end - span.start == Approx(50.0));
  CHECK((25.0 - span.start) / (span.end - span.start) == Approx(0.25));
  CHECK(zoomed({0.0, 10.0}, 5.0, 0.01, 4.0, 1000.0).end - zoomed({0.0, 10.0}, 5.0, 0.01, 4.0, 1000.0).start ==
        Approx(4.0));
}

TEST_CASE("Ease points stay where the specification allows them") {
  const RemapPoints clamped = clampedRemap({{0.8, 0.9}, {0.7, 0.1}});
  CHECK(clamped.easeIn.x + clamped.easeOut.x < 1.0);
  CHECK(clamped.easeIn.y == Approx(0.5));
  CHECK(clamped.easeOut.y == Approx(0.5));
  const RemapPoints off = clampedRemap({{-0.2, 0.1}, {0.0, 0.9}});
  CHECK(off.easeIn.x == 0.0);
}

TEST_CASE("A curve is read between its points and held outside") {
  const std::vector<Vec2> points{{0.0, 1.0}, {10.0, 3.0}};
  CHECK(curveValue(points, -5.0) == 1.0);
  CHECK(curveValue(points, 5.0) == Approx(2.0));
  CHECK(curveValue(points, 50.0) == 3.0);
  CHECK(curveValue({}, 1.0) == 0.0);
}

TEST_CASE("Fitting shows every visible value and leaves hidden curves out") {
  Curve low{.label = "low", .points = {{0.0, -2.0}, {1.0, 0.0}}};
  Curve high{.label = "high", .points = {{0.0, 50.0}}, .hidden = true};
  const Span span = fittedValues({low, high});
  CHECK(span.start < -2.0);
  CHECK(span.end > 0.0);
  CHECK(span.end < 50.0);
  CHECK(fittedValues({}).end > fittedValues({}).start);
  CHECK(fittedValues({Curve{.label = "flat", .points = {{0.0, 1.0}}}}).end > 1.0);
}

TEST_CASE("Three letters inside of a word find it, two do not, and beginnings are at most twelve letters") {
  CHECK(wordScore("lec", "Frame the selection"));
  CHECK_FALSE(wordScore("ec", "Frame the selection"));
  CHECK(wordScore("fratheselect", "Frame the selection"));
  CHECK_FALSE(wordScore("fratheselecti", "Frame the selection"));
  // Letters of other languages are letters.
  CHECK(*wordScore("T\xC3\xBCr", "T\xC3\xBCr zu") == *wordScore("Tuer", "Tuer zu"));
}

TEST_CASE("Colours of trails repeat after the last, and are darker on light ground, brighter on black") {
  const int count = static_cast<int>(trailPalette.size());
  for (int i = 0; i < count; ++i) {
    const auto place = static_cast<std::size_t>(i);
    for (const int turns : {-2, -1, 0, 1, 3}) {
      CHECK(trailColour(i + turns * count, ThemeKind::dark) == trailPalette[place]);
      CHECK(trailColour(i + turns * count, ThemeKind::light) == lightTrailPalette[place]);
    }
    CHECK(trailColour(i, ThemeKind::highContrast) ==
          (i + 1 == count ? contrastBlueTrailColour : trailPalette[place]));
  }
  CHECK(originalColour(ThemeKind::dark) == originalTrailColour);
  CHECK(originalColour(ThemeKind::highContrast) == originalTrailColour);
  CHECK(originalColour(ThemeKind::light) == lightOriginalTrailColour);
}

TEST_CASE("A colour fades by its opacity alone, and is mixed from one to the other") {
  const ImU32 colour = IM_COL32(200, 100, 50, 200);
  CHECK(faded(colour, 1.0F) == colour);
  CHECK(faded(colour, 0.5F) == IM_COL32(200, 100, 50, 100));
  CHECK(faded(colour, 0.0F) == IM_COL32(200, 100, 50, 0));
  CHECK(faded(colour, 3.0F) == colour);
  CHECK(faded(colour, -1.0F) == IM_COL32(200, 100, 50, 0));
  CHECK(mixed(colour, IM_COL32(0, 0, 0, 0), 0.0F) == colour);
  CHECK(mixed(colour, IM_COL32(0, 20, 250, 40), 1.0F) == IM_COL32(0, 20, 250, 40));
  CHECK(mixed(colour, IM_COL32(100, 200, 150, 100), 0.5F) == IM_COL32(150, 150, 100, 150));
}
