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

/// A body with the joint names of the scheme of that title.
[[nodiscard]] SyntheticBiped makeNamedBody(const std::string& scheme, const BodyOptions& options = {});

} // namespace stretch::test
