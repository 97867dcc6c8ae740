#include "tests/support/ui/recording_device.h"

#include <cstdlib>
#include <string>

#include "tests/support/temporary_folder.h"

namespace stretch::test {

std::filesystem::path recordedSound() {
  static const TemporaryFolder folder;
  static const std::filesystem::path file = [] {
    const std::filesystem::path sounds = folder / "sounds";
    std::filesystem::create_directory(sounds);
    const std::string settings =
        "[general]\ndrivers = wave\nfrequency = 44100\n[wave]\nfile = " + (sounds / "heard.wav").string() +
        "\n";
    setenv("ALSOFT_CONF", folder.write("device.conf", settings).c_str(), 1);
    return sounds / "heard.wav";
  }();
  return file;
}

} // namespace stretch::test
