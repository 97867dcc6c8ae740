#include "tests/support/app/option_rows.h"

namespace stretch::test {

std::vector<OptionRow> rowsBehind(const std::string& words, const std::vector<OptionRow>& rows) {
  std::vector<OptionRow> behind;
  behind.reserve(rows.size());
  for (const OptionRow& row : rows) {
    behind.push_back({row.option, words + ' ' + row.without, words + ' ' + row.with});
  }
  return behind;
}

std::vector<OptionRow> joinedRows(std::vector<OptionRow> rows, const std::vector<OptionRow>& more) {
  rows.insert(rows.end(), more.begin(), more.end());
  return rows;
}

std::vector<OptionRow> styleRows() {
  const std::string punch = "IN/dummy.glb -o OUT/out.glb";
  const std::string automatic = punch + " --auto";
  const std::vector<OptionRow> ofTheStyle = rowsBehind(
      automatic,
      {{"--all-clips", "--clip Guard", "--all-clips"},
       {"--style", "", "--style Subtle"},
       {"--strength", "", "--strength 1.5"},
       {"--style-axes", "", "--style-axes level"},
       {"--style-reference", "", "--style-reference rest"},
       {"--style-bend", "", "--style-bend keep"},
       {"--style-remap", "", "--style-remap linear"},
       {"--style-ease-in", "", "--style-ease-in 0.5,0.2"},
       {"--style-ease-out", "", "--style-ease-out 0.3,0.5"},
       {"--style-overshoot", "", "--style-overshoot 0.5"},
       {"--style-volume", "", "--style-volume 0"},
       {"--style-spread-trunk", "", "--style-spread-trunk 0.4"},
       {"--style-weight", "", "--style-weight 0.5"},
       {"--style-weight-stiffness", "--style-weight 0.5", "--style-weight 0.5 --style-weight-stiffness 2"},
       {"--style-weight-damping", "--style-weight 0.5", "--style-weight 0.5 --style-weight-damping 0.2"}});
  const std::vector<OptionRow> ofArms =
      rowsBehind(automatic, {{"--style-arm", "", "--style-arm 3"},
                             {"--style-arm-least", "--strength 0.1", "--strength 0.1 --style-arm-least 2"},
                             {"--style-arm-most", "--strength 2", "--strength 2 --style-arm-most 2.5"}});
  const std::vector<OptionRow> ofTrunk =
      rowsBehind(automatic + " --style-spread-trunk 1",
                 {{"--style-torso", "", "--style-torso 3"},
                  {"--style-torso-least", "--strength 0.1", "--strength 0.1 --style-torso-least 1.5"},
                  {"--style-torso-most", "--strength 2", "--strength 2 --style-torso-most 1.52"},
                  {"--style-spread-late", "", "--style-spread-late 3"}});
  const std::vector<OptionRow> ofLegs =
      rowsBehind("IN/leap.glb -o OUT/out.glb --auto",
                 {{"--style-leg", "", "--style-leg 3"},
                  {"--style-leg-least", "--strength 0.1", "--strength 0.1 --style-leg-least 2"},
                  {"--style-leg-most", "--strength 2", "--strength 2 --style-leg-most 1.2"},
                  {"--style-release", "", "--style-release 3"},
                  {"--style-spread-limbs", "", "--style-spread-limbs 0.3"}});
  const std::vector<OptionRow> ofChains =
      rowsBehind(automatic + " --plan other",
                 {{"--style-other", "", "--style-other 3"},
                  {"--style-other-least", "--strength 0.1", "--strength 0.1 --style-other-least 2"},
                  {"--style-other-most", "--strength 2", "--strength 2 --style-other-most 2.5"}});
  return joinedRows(joinedRows(joinedRows(ofTheStyle, ofArms), ofTrunk),
                    joinedRows(joinedRows(ofLegs, ofChains),
                               {{"--auto", punch + " --limb left-arm --scale 2", automatic}}));
}

} // namespace stretch::test
