#include "app/batch/weight_report.h"

#include <fmt/core.h>

#include "app/evaluate/evaluate.h"
#include "core/gltf/json.h"

namespace stretch::app {

gltf::Json weightJson(const Document& document, int clip) {
  gltf::Json limbs = gltf::Json::array();
  for (const WeightReport& report : weightReports(document, clip)) {
    limbs.push_back({{"limb", report.limb},
                     {"young", report.youngModulus},
                     {"widths", report.widths},
                     {"masses", report.masses},
                     {"shortest", report.shortest},
                     {"shortest_frame", report.shortestFrame},
                     {"longest", report.longest},
                     {"longest_frame", report.longestFrame},
                     {"warnings", report.warnings}});
  }
  return limbs;
}

void printWeight(const gltf::Json& limbs) {
  for (const gltf::Json& limb : limbs) {
    fmt::print("{}: {:.3g} to {:.3g} times its length (frames {:.4g} and {:.4g}), modulus {:.3g} Pa\n",
               limb["limb"].get<std::string>(), limb["shortest"].get<double>(), limb["longest"].get<double>(),
               limb["shortest_frame"].get<double>(), limb["longest_frame"].get<double>(),
               limb["young"].get<double>());
    for (const gltf::Json& warning : limb["warnings"]) {
      fmt::print(stderr, "warning: {}\n", warning.get<std::string>());
    }
  }
}

} // namespace stretch::app
