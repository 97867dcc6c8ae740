// Writes a mesh sequence for checks of the program as a whole: OBJ frames of a tube that bends, shortens with
// its curvature and is flattened by gravity.
//   make-sequence FOLDER [FRAMES]
#include <cstdlib>
#include <iostream>

#include "tests/support/skinning/bodies.h"
#include "tests/support/skinning/obj_frames.h"

int main(int argumentCount, char** arguments) {
  if (argumentCount < 2) {
    std::cerr << "usage: make-sequence FOLDER [FRAMES]\n";
    return 2;
  }
  const int frames = argumentCount > 2 ? std::atoi(arguments[2]) : 24;
  stretch::test::writeObjFrames(stretch::test::shorteningTube(frames, 2.4, 0.05, 0.12), arguments[1], "tube");
  return 0;
}
