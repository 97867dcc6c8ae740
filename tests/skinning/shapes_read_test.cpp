#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "skinning/bind/bind_weights.h"
#include "skinning/compress/compress.h"
#include "skinning/geometry/geodesic_distance.h"
#include "skinning/geometry/shape_diameter.h"
#include "skinning/locate/fit_biped.h"
#include "tests/support/recorded.h"
#include "tests/support/skinning/bodies.h"
#include "tests/support/skinning/shapes.h"
#include "tests/support/skinning/tube_person.h"

using namespace stretch;
using namespace stretch::skinning;
using test::TubePerson;
using test::TubePose;

namespace {

constexpr double recordTolerance = 1e-3;

std::string vectorText(const Vec3& value) {
  return fmt::format(" {:.4f} {:.4f} {:.4f}", value.x, value.y, value.z);
}

std::string fitText(const std::string& title, const TubePerson& person) {
  std::string text = title + "\n";
  const Result<FittedBiped> fitted = fitBiped(person.positions, person.triangles);
  if (!fitted) {
    return text + "  refused: " + fitted.error().line() + "\n";
  }
  for (const FittedJoint& joint : fitted->joints) {
    text +=
        "  " + joint.name + vectorText(joint.position) + fmt::format(" , {:.3f} sure\n", joint.confidence);
  }
  for (const std::string& warning : fitted->warnings) {
    text += "  warns: " + warning + "\n";
  }
  return text;
}

std::vector<BindJoint> jointsOf(const TubePerson& person) {
  std::vector<BindJoint> joints;
  for (const auto& [name, place] : person.joints) {
    joints.push_back({place, joints.empty() ? -1 : static_cast<int>(joints.size()) / 2});
  }
  return joints;
}

std::vector<glm::vec3> floatsOf(const std::vector<Vec3>& positions) {
  return {positions.begin(), positions.end()};
}

std::string weightsText(const std::string& title, const Result<BoundBody>& bound) {
  if (!bound) {
    return title + " refused: " + bound.error().line() + "\n";
  }
  std::string text = fmt::format("{} , {} cubes\n", title, bound->cubes);
  const std::size_t step = std::max<std::size_t>(1, bound->influences.size() / 40);
  for (std::size_t v = 0; v < bound->influences.size(); v += step) {
    text += fmt::format("  {} :", v);
    const Influences& row = bound->influences[v];
    for (std::size_t i = 0; i < Influences::capacity && row.weights[i] > 0.0F; ++i) {
      text += fmt::format(" {} {:.4f}", row.bones[i], row.weights[i]);
    }
    text += "\n";
  }
  return text;
}

std::string compressionText(const std::string& title, const MeshSequence& sequence,
                            const CompressSettings& settings) {
  const Result<CompressedSequence> made = compress(sequence, settings);
  if (!made) {
    return title + " refused: " + made.error().line() + "\n";
  }
  std::string text =
      fmt::format("{}\n  rmse {:.4f} , largest {:.4f} , kg {:.4f} , sted {:.5f} {:.5f} {:.5f} , bones {} , "
                  "fitted from {} , chained {}\n",
                  title, made->metrics.rmsePercent, made->metrics.largestPercent, made->metrics.kgError,
                  made->metrics.sted, made->metrics.stedSpatial, made->metrics.stedTemporal,
                  made->skinned.bones.size(), made->firstFittedFrame, made->skinned.chained);
  text +=
      fmt::format("  weights {} , geodesic {:.4f} , fitted {:.4f}\n", static_cast<int>(made->weights.used),
                  made->weights.geodesicPercent.value_or(-1.0), made->weights.fittedPercent.value_or(-1.0));
  for (std::size_t bone = 0; bone < made->skinned.bones.size(); ++bone) {
    const SkinBone& at = made->skinned.bones[bone];
    const BonePose& pose = made->skinned.pose(made->skinned.frameCount() - 1, bone);
    text += fmt::format("  bone {} on {} :", bone, at.parent) + vectorText(at.pivot) + vectorText(at.end) +
            " ," + vectorText(pose.position) + " , scaled" + vectorText(pose.scale) + "\n";
  }
  for (const double width : made->segmentWidths) {
    text += fmt::format("  width {:.4f}\n", width);
  }
  if (made->model) {
    const BodyStretch& model = *made->model;
    text += fmt::format(
        "  rest {:.4f} , mass {:.2f} , young {:.1f} , fitted {} , volumes {:.3f} {:.3f} , turns {}\n",
        model.restLength, model.mass, model.youngModulus, model.modulusFitted, model.gravityVolume,
        model.muscleVolume, model.loadTurns);
    text += fmt::format("  line {:.4f} {:.4f} {:.4f} , monotone {:.4f} , mean {:.4f} {}\n",
                        model.length.line.slope, model.length.line.intercept, model.length.line.rSquared,
                        model.length.monotone.rSquared, model.length.meanLength, model.length.remark);
    for (std::size_t i = 0; i < model.compressions.size(); ++i) {
      text += fmt::format("  segment {} pressed {:.4f} , load", i, model.compressions[i]) +
              vectorText(model.loadAxes.at(i)) + "\n";
    }
    for (const std::string& warning : model.warnings) {
      text += "  model warns: " + warning + "\n";
    }
  }
  for (const std::string& warning : made->warnings) {
    text += "  warns: " + warning + "\n";
  }
  return text;
}

} // namespace

TEST_CASE("Where joints are put into made-up persons of many stances is as it was looked at") {
  std::string text;
  for (const double down : {0.0, 0.4, 0.9, 1.3}) {
    text += fitText(fmt::format("arms {} down", down), test::tubePerson({.armsDown = down}));
  }
  text += fitText("broad shoulders", test::tubePerson({.armsDown = 0.5, .shoulders = 0.3}));
  text += fitText("narrow shoulders", test::tubePerson({.armsDown = 0.5, .shoulders = 0.14}));
  text += fitText("no arms", test::tubePerson({.hasArms = false}));
  text += fitText("rods", test::tubePerson({.armsDown = 0.5, .hasRods = true}));
  text += fitText("a stick in the right hand", test::tubePerson({.armsDown = 0.4, .holdsInRight = 0.6}));
  text += fitText("sticks in both hands",
                  test::tubePerson({.armsDown = 0.4, .holdsInRight = 0.4, .holdsInLeft = 0.3}));
  text += fitText("holes", test::tubePerson({.armsDown = 0.4, .everyNthHole = 7}));
  text += fitText("blocks", test::blockPerson());
  TubePerson oneArm = test::tubePerson({.armsDown = 0.3});
  std::erase_if(oneArm.triangles, [&](const Triangle& triangle) {
    return std::ranges::any_of(triangle, [&](std::uint32_t v) { return oneArm.positions[v].x > 0.26; });
  });
  text += fitText("the right arm alone", oneArm);
  for (Vec3& place : oneArm.positions) {
    place.x = -place.x;
  }
  text += fitText("the left arm alone", oneArm);
  TubePerson half = test::tubePerson();
  std::erase_if(half.triangles, [&](const Triangle& triangle) {
    return std::ranges::any_of(triangle, [&](std::uint32_t v) { return half.positions[v].y < 0.95; });
  });
  text += fitText("a bust", half);
  test::compareWithRecord("fitted-joints", text, recordTolerance);
}

TEST_CASE("The weights of bound bodies are as they were looked at") {
  std::string text;
  for (const double down : {0.2, 1.2}) {
    const TubePerson person = test::tubePerson({.armsDown = down});
    const std::vector<glm::vec3> positions = floatsOf(person.positions);
    text += weightsText(fmt::format("person, arms {} down", down),
                        bindWeights(positions, person.triangles, jointsOf(person), {.cubesAlong = 60}));
    text += weightsText("sharper", bindWeights(positions, person.triangles, jointsOf(person),
                                               {.cubesAlong = 40, .blend = 0.2, .sections = 0.4}));
  }
  const test::Shape tube = test::tube(10.0, 1.0, 40, 12);
  const std::vector<BindJoint> bones{
      {Vec3(0, 0, 0), -1}, {Vec3(4, 0, 0), 0}, {Vec3(7, 0, 0), 1}, {Vec3(9.5, 0, 0), 2}};
  text += weightsText("tube", bindWeights(tube.positions, tube.triangles, bones));
  text += weightsText("tube on its surface", bindWeightsOnSurface(tube.positions, tube.triangles, bones));
  test::compareWithRecord("bound-weights", text, recordTolerance);
}

TEST_CASE("Ways over surfaces and how thick bodies are is as it was looked at") {
  std::string text;
  const std::vector<std::pair<std::string, test::Shape>> shapes{
      {"sphere", test::sphere(3)},
      {"uneven plane", test::plane(12, 0.4)},
      {"torus", test::torus(2.0, 0.6, 24, 14)},
      {"tube", test::tube(6.0, 0.5, 20, 10)},
      {"steps", test::cubes({0, 0, 0}, {5, 4, 3}, 0.5, [](int x, int y, int) { return x + y < 6; })}};
  for (const auto& [title, shape] : shapes) {
    const GeodesicSolver solver(shape.positions, shape.triangles);
    const std::vector<double> ways = solver.distances({0, 7}, 4.0);
    const Result<ShapeDiameters> thick = shapeDiameters(shape.positions, shape.triangles, {.rays = 24});
    const Result<ShapeDiameters> rough = shapeDiameters(
        shape.positions, shape.triangles, {.coneDegrees = 60.0, .rays = 9, .smoothingRounds = 0});
    text += fmt::format("{} , {} without a hit\n", title, thick ? thick->facesWithoutHit : 0);
    for (std::size_t v = 0; v < shape.positions.size();
         v += std::max<std::size_t>(1, shape.positions.size() / 24)) {
      text += fmt::format("  {} : way {:.4f} , thick {:.4f} {:.4f}\n", v, ways[v],
                          thick ? thick->vertices[v] : -1.0, rough ? rough->vertices[v] : -1.0);
    }
  }
  test::compareWithRecord("ways-and-thickness", text, recordTolerance);
}

TEST_CASE(
    "What sequences are compressed to, with each way of stretching and hanging, is as it was looked at") {
  std::string text;
  const MeshSequence tube = test::shorteningTube(9, 0.15, 0.4, 0.1);
  const MeshSequence strong = test::shorteningTube(12, 0.3, 0.1, 0.25);
  for (const StretchOption stretch : {StretchOption::none, StretchOption::elastic, StretchOption::measured}) {
    for (const WeightOption weights :
         {WeightOption::automatic, WeightOption::geodesic, WeightOption::fitted}) {
      CompressSettings settings;
      settings.bones = 5;
      settings.stretch = stretch;
      settings.weights = weights;
      const std::string title =
          fmt::format("stretch {} , weights {}", static_cast<int>(stretch), static_cast<int>(weights));
      text += compressionText("tube, " + title, tube, settings);
      settings.joints = JointOption::free;
      settings.body.youngModulus = 90000.0;
      settings.body.mass = 4.0;
      settings.body.metresPerUnit = 0.5;
      settings.body.gravityVolume = std::nullopt;
      settings.body.muscleVolume = 0.3;
      settings.body.firstFittedFrame = 2;
      settings.body.gravity = Vec3(1.0, -8.0, 2.0);
      settings.body.lengthModel = LengthModel::monotone;
      text += compressionText("strong tube, " + title, strong, settings);
    }
  }
  test::compareWithRecord("compressions", text, recordTolerance);
}
