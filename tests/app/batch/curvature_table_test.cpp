// The table that `compress --curvature` writes.
#include <catch2/catch.hpp>

#include "app/batch/sequence_report.h"

using namespace stretch;

TEST_CASE(
    "Every frame has a line with its name, what was measured and what the model makes of its curvature") {
  MeshSequence sequence;
  sequence.frameNames = {"worm \"one\".obj"};
  skinning::BodyStretch model;
  model.measured = {{0.5, 2.5}, {0.25, 3.75}};
  model.length.model = skinning::LengthModel::line;
  model.length.line.slope = -1.0;
  model.length.line.intercept = 4.75;
  // A name may not end its cell, and a frame may have none.
  CHECK(app::curvatureTable(sequence, model) == "frame,name,curvature_radians,length,modelled_length\n"
                                                "0,\"worm 'one'.obj\",0.5,2.5,4.25\n"
                                                "1,\"\",0.25,3.75,4.5\n");
}
