#pragma once

#include <string>

#include "core/scene/scene.h"

namespace stretch::test {

/// Compares a picture with tests/render/baselines/NAME.png. Small differences of drivers pass: on average one
/// step of 255 per channel, and no more than 1 % of the pixels far off. Otherwise, or without a baseline, the
/// picture is written to `render-differences` beside the test program, and the answer says where and what to
/// do; empty when equal.
[[nodiscard]] std::string differenceFromBaseline(const std::string& name, const Image& picture);

} // namespace stretch::test
