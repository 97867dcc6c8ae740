// Each figure of a retargeted clip with its words, its unit and what is seen of it.
#include <optional>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/core.h>

#include "app/retarget/retarget_figures.h"
#include "core/gltf/json/json.h"

using namespace stretch;
using namespace stretch::app;

namespace {

struct Figure {
  const char* key;
  const char* words;
  const char* unit;
  std::optional<double> RetargetFigures::*value;
  double factor; ///< From the value to the figure that is told.
  double seen;   ///< Value above the source's from which on it is told.
};

const std::vector<Figure>& figures() {
  static const std::vector<Figure> all{
      {"slide_percent", "feet that stand slide", "% of the height", &RetargetFigures::slide, 100, 0.005},
      {"contact_cm", "hands that touch are off by", "cm at 1.7 m", &RetargetFigures::contact, 170, 0.021},
      {"inside_percent", "inside trunk and head are", "% of forearms, hands, shins and feet",
       &RetargetFigures::inside, 100, 0.02},
      {"deepest_percent", "arms or legs are inside trunk or head by up to", "% of the height",
       &RetargetFigures::deepest, 100, 0.01},
      {"held_percent", "what the hands hold is inside trunk or head by up to", "% of the height",
       &RetargetFigures::held, 100, 0.05},
      {"floor_percent", "the body is below the floor by up to", "% of the height", &RetargetFigures::floor,
       100, 0.005},
      {"hands_widths", "hands that work together are off by", "widths of the shoulders",
       &RetargetFigures::hands, 1, 0.05},
  };
  return all;
}

} // namespace

TEST_CASE("Each figure is told as worse from what is seen of it on, beyond the source's") {
  for (const Figure& figure : figures()) {
    CAPTURE(figure.key);
    for (const double source : {0.0, 0.3}) {
      RetargetReport report;
      if (source > 0.0) { // Else there is none.
        report.source.*figure.value = source;
      }
      report.mapped.*figure.value = 0.9; // No part of what is told.
      report.result.*figure.value = source + 0.99 * figure.seen;
      CHECK(worseLines(report).empty());
      report.result.*figure.value = source + 1.01 * figure.seen;
      const std::vector<std::string> lines = worseLines(report);
      REQUIRE(lines.size() == 1);
      CHECK_THAT(lines[0], Catch::StartsWith(figure.words) && Catch::Contains(figure.unit));
      CHECK_THAT(lines[0], Catch::Contains(" (") && Catch::EndsWith(" in the source)"));
    }
    RetargetReport better;
    better.source.*figure.value = 0.3;
    CHECK(worseLines(better).empty());
  }
}

TEST_CASE("What is worse is told in the order of how far it is beyond what is seen of it") {
  RetargetReport report;
  double times = 2.0;
  for (const Figure& figure : figures()) {
    report.result.*figure.value = figure.seen * times;
    times += 1.0;
  }
  const std::vector<std::string> lines = worseLines(report);
  REQUIRE(lines.size() == figures().size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    CHECK_THAT(lines[i], Catch::StartsWith(figures()[figures().size() - 1 - i].words));
  }
}

TEST_CASE("Each figure that there is has a line, as it came out, as mapped, and of the source") {
  for (const Figure& figure : figures()) {
    CAPTURE(figure.key);
    RetargetReport report;
    CHECK(reportLines(report).empty());
    report.source.*figure.value = 0.5;
    report.mapped.*figure.value = 0.25;
    CHECK(reportLines(report).empty()); // The result has none.
    report.result.*figure.value = 0.125;
    const auto told = [&](double value) { return fmt::format("{:.2f}", figure.factor * value); };
    const std::string words = figure.words;
    CHECK(reportLines(report) == std::vector{words + " " + told(0.125) + " " + figure.unit + " (as mapped " +
                                             told(0.25) + ", source " + told(0.5) + ")"});
    report.source = {};
    report.mapped = {};
    CHECK(reportLines(report) ==
          std::vector{words + " " + told(0.125) + " " + figure.unit + " (as mapped none, source none)"});
  }
}

TEST_CASE("A report as JSON holds every figure of source, mapped and result, null where there is none") {
  for (const Figure& figure : figures()) {
    RetargetReport report;
    report.source.*figure.value = 0.5;
    report.mapped.*figure.value = 0.25;
    report.result.*figure.value = 0.125;
    const gltf::Json json = reportToJson(report);
    CHECK(json["source"][figure.key].get<double>() == Approx(0.5 * figure.factor));
    CHECK(json["mapped"][figure.key].get<double>() == Approx(0.25 * figure.factor));
    CHECK(json["result"][figure.key].get<double>() == Approx(0.125 * figure.factor));
    for (const Figure& other : figures()) {
      CHECK(json["result"].contains(other.key));
      CHECK(json["result"][other.key].is_null() == (&other != &figure));
    }
    const bool slides = figure.value == &RetargetFigures::slide;
    CHECK(json["result"]["slide_cm"].is_null() == !slides);
    if (slides) {
      CHECK(json["result"]["slide_cm"].get<double>() == Approx(0.125 * 170.0));
    }
  }
}
