#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

#include "app/retarget/smooth_course.h"

using namespace stretch::app;

TEST_CASE("A smooth course without stiffness is what is wanted, and a straight line is kept by any") {
  const std::vector<double> wanted{0.0, 3.0, -1.0, 2.0, 2.0};
  const std::vector<double> loose = smoothCourse(wanted, std::vector<double>(5, 2.0), 0.0);
  REQUIRE(loose.size() == wanted.size());
  const std::vector<double> line = smoothCourse({1.0, 1.5, 2.0, 2.5, 3.0}, {1.0, 5.0, 1.0, 9.0, 1.0}, 1e4);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    CHECK(loose[i] == Approx(wanted[i]).margin(1e-12));
    CHECK(line[i] == Approx(1.0 + 0.5 * static_cast<double>(i)));
  }
  CHECK(smoothCourse({}, {}, 1.0).empty());
  CHECK(smoothCourse({4.0}, {1.0}, 1.0) == std::vector<double>{4.0});
}

TEST_CASE("A smooth course is the least of distance and bend: a little more or less anywhere costs more") {
  const std::vector<double> wanted{0.0, 0.0, 1.0, 1.0, 0.0, 0.0, -2.0};
  const std::vector<double> confidences{1.0, 1.0, 40.0, 40.0, 1.0, 1.0, 3.0};
  constexpr double stiffness = 5.0;
  const auto cost = [&](const std::vector<double>& course) {
    double sum = 0.0;
    for (std::size_t i = 0; i < course.size(); ++i) {
      sum += confidences[i] * std::pow(course[i] - wanted[i], 2.0);
      if (i > 0 && i + 1 < course.size()) {
        sum += stiffness * std::pow(course[i - 1] - 2.0 * course[i] + course[i + 1], 2.0);
      }
    }
    return sum;
  };
  const std::vector<double> course = smoothCourse(wanted, confidences, stiffness);
  for (std::size_t i = 0; i < course.size(); ++i) {
    for (const double change : {-1e-3, 1e-3}) {
      std::vector<double> other = course;
      other[i] += change;
      CHECK(cost(other) > cost(course));
    }
  }
  CHECK(course[2] == Approx(1.0).margin(0.1)); // what is trusted is reached
}
