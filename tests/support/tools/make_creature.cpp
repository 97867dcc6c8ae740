// Writes a character that is no biped, for the scripts that drive the window.
//   make-creature horse|snake FILE.glb
#include <iostream>
#include <string>

#include "tests/support/rig/moving_creatures.h"

int main(int argumentCount, char** arguments) {
  const std::string name = argumentCount == 3 ? arguments[1] : "";
  if (name != "horse" && name != "snake") {
    std::cerr << "usage: make-creature horse|snake FILE.glb\n";
    return 2;
  }
  using namespace stretch::test;
  creatureFile(name == "horse" ? pawingHorse() : strikingSnake()).write(arguments[2]);
  return 0;
}
