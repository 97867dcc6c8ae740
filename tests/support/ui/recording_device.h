#pragma once

#include <filesystem>

namespace stretch::test {

/// From the first call on, sounds of this program go into this WAV instead of a device that is heard: what
/// was played since the device was opened last, whole once it is closed. The sound library reads its settings
/// once, so whatever plays a sound in a test calls this before.
[[nodiscard]] std::filesystem::path recordedSound();

} // namespace stretch::test
