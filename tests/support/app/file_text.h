#pragma once

#include <string>

#include "core/base/file.h"

namespace stretch::test {

/// What a written character holds, summed up: a change of any key, weight or place shows. Of a file that is
/// no character, how large it is.
[[nodiscard]] std::string fileText(const std::string& name, const Bytes& bytes);

} // namespace stretch::test
