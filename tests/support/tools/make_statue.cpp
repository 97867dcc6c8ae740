// Writes a person without a skeleton, for scripts that drive the window: a .gltf of one mesh.
//   make-statue FILE.gltf
#include <iostream>

#include "tests/support/app/mesh_file.h"
#include "tests/support/skinning/tube_person.h"

int main(int argumentCount, char** arguments) {
  if (argumentCount != 2) {
    std::cerr << "usage: make-statue FILE.gltf\n";
    return 2;
  }
  const stretch::test::TubePerson person = stretch::test::tubePerson();
  stretch::test::writeMeshFile(arguments[1], person.positions, person.triangles);
  return 0;
}
