#pragma once

#include <string>
#include <vector>

#include "tests/support/rig/synthetic_biped.h"

namespace stretch::test {

/// Names that rigs of many programs and languages give to the joints of makeBody(); "no names" is one of
/// them.
[[nodiscard]] const std::vector<NamingScheme>& namingSchemes();

/// The scheme with this title.
[[nodiscard]] const NamingScheme& namingScheme(const std::string& title);

} // namespace stretch::test
