#include "tests/support/core/foreign_text.h"

#include <vector>

#include <fmt/format.h>

namespace stretch::test {

std::string personBvh(int said, int held, double unit) {
  std::string text =
      fmt::format("HIERARCHY\nROOT Hips\n{{\n  OFFSET 0 0 0\n  CHANNELS 6 Xposition Yposition Zposition "
                  "Zrotation Xrotation Yrotation\n"
                  "  JOINT Leg\n  {{\n    OFFSET 0 {0} 0\n    CHANNELS 3 Zrotation Xrotation Yrotation\n"
                  "    End Site\n    {{\n      OFFSET 0 {0} 0\n    }}\n  }}\n"
                  "  JOINT Head\n  {{\n    OFFSET 0 {1} 0\n    CHANNELS 3 Zrotation Xrotation Yrotation\n"
                  "    End Site\n    {{\n      OFFSET 0 0 {2}\n    }}\n  }}\n}}\n"
                  "MOTION\nFrames: {3}\nFrame Time: 0.02\n",
                  -40.0 * unit, 80.0 * unit, 10.0 * unit, said);
  for (int frame = 0; frame < held; ++frame) {
    text += fmt::format("{} {} 0 0 0 0 0 {} 0 0 0 0\n", 3.0 * unit * frame, 80.0 * unit, 45 * frame);
  }
  return text;
}

namespace {

std::string curve(int id, const char* values, int flags) {
  return fmt::format(
      "  AnimationCurve: {}, \"AnimCurve::\", \"\" {{\n    KeyVer: 4008\n    KeyTime: *2 {{\n      a: "
      "0,46186158000\n    }}\n"
      "    KeyValueFloat: *2 {{\n      a: {}\n    }}\n    KeyAttrFlags: *1 {{\n      a: {}\n    }}\n"
      "    KeyAttrDataFloat: *4 {{\n      a: 0,0,0,0\n    }}\n    KeyAttrRefCount: *1 {{\n      a: 2\n    "
      "}}\n  }}\n",
      id, values, flags);
}

std::string bone(int id, const char* name, const std::string& properties) {
  return fmt::format("  Model: {}, \"Model::{}\", \"LimbNode\" {{\n    Version: 232\n    Properties70: "
                     "{{\n{}    }}\n    Shading: Y\n    Culling: \"CullingOff\"\n  }}\n",
                     id, name, properties);
}

std::string property(const char* name, double x, double y, double z) {
  return fmt::format("      P: \"{0}\", \"{0}\", \"\", \"A\",{1},{2},{3}\n", name, x, y, z);
}

std::string vectorProperty(const char* name, double x, double y, double z) {
  return fmt::format("      P: \"{}\", \"Vector3D\", \"Vector\", \"\",{},{},{}\n", name, x, y, z);
}

std::string intProperty(const char* name, int value) {
  return fmt::format("      P: \"{}\", \"int\", \"Integer\", \"\",{}\n", name, value);
}

std::string objects(const FbxText& text) {
  std::string all = bone(
      10, "upper",
      property("Lcl Translation", 0, 10, 0) + vectorProperty("PreRotation", 0, 0, 90) +
          property("Lcl Scaling", text.upperScale, text.upperScale * text.upperStretch, text.upperScale) +
          (text.upperPivots
               ? vectorProperty("RotationPivot", 0, 1, 0) + vectorProperty("ScalingPivot", 0, 1, 0)
               : "") +
          intProperty("RotationActive", 1));
  all += bone(11, "lower",
              property("Lcl Translation", 0, 5, 0) +
                  (text.lowerPivots ? vectorProperty("RotationPivot", 0, 2, 0) : "") +
                  intProperty("RotationActive", 1) +
                  fmt::format("      P: \"InheritType\", \"enum\", \"\", \"\",{}\n", text.childInherits));
  all +=
      "  Model: 12, \"Model::skin\", \"Mesh\" {\n    Version: 232\n    Properties70: {\n    }\n    Shading: "
      "Y\n  }\n"
      "  Geometry: 20, \"Geometry::\", \"Mesh\" {\n    Vertices: *9 {\n      a: 0,10,0,1,10,0,0,11,0\n    }\n"
      "    PolygonVertexIndex: *3 {\n      a: 0,1,-3\n    }\n    GeometryVersion: 124\n"
      "    LayerElementMaterial: 0 {\n      Version: 101\n      Name: \"\"\n      MappingInformationType: "
      "\"AllSame\"\n      ReferenceInformationType: \"IndexToDirect\"\n      Materials: *1 {\n        a: 0\n "
      "     }\n    }\n"
      "    Layer: 0 {\n      Version: 100\n      LayerElement: {\n        Type: \"LayerElementMaterial\"\n   "
      "     TypedIndex: 0\n      }\n    }\n  }\n"
      "  Geometry: 21, \"Geometry::smile\", \"Shape\" {\n    Version: 100\n    Indexes: *1 {\n      a: 1\n   "
      " }\n    Vertices: *3 {\n      a: 0,0,2\n    }\n    Normals: *3 {\n      a: 0,0,0\n    }\n  }\n"
      "  Deformer: 22, \"Deformer::\", \"BlendShape\" {\n    Version: 100\n  }\n"
      "  Deformer: 23, \"SubDeformer::smile\", \"BlendShapeChannel\" {\n    Version: 100\n    DeformPercent: "
      "0\n    FullWeights: *1 {\n      a: 100\n    }\n  }\n"
      "  Material: 30, \"Material::red\", \"\" {\n    Version: 102\n    ShadingModel: \"phong\"\n    "
      "Properties70: {\n"
      "      P: \"DiffuseColor\", \"Color\", \"\", \"A\",1,0,0\n    }\n  }\n"
      "  Deformer: 40, \"Deformer::\", \"Skin\" {\n    Version: 101\n  }\n";
  const char* const identity = "1,0,0,0,0,1,0,0,0,0,1,0";
  for (int i = 0; i < 2; ++i) {
    all += fmt::format(
        "  Deformer: {}, \"SubDeformer::\", \"Cluster\" {{\n    Version: 100\n    UserData: \"\", \"\"\n    "
        "Indexes: *{} {{\n      a: {}\n    }}\n    Weights: *{} {{\n      a: {}\n    }}\n"
        "    Transform: *16 {{\n      a: {},0,{},0,1\n    }}\n    TransformLink: *16 {{\n      a: "
        "{},0,{},0,1\n    }}\n  }}\n",
        41 + i, i == 0 ? 2 : 1, i == 0 ? "0,1" : "2", i == 0 ? 2 : 1, i == 0 ? "1,1" : "1", identity,
        i == 0 ? -10 : -15, identity, i == 0 ? 10 : 15);
  }
  all += curve(50, "0,120", text.keyFlags) +
         "  AnimationCurveNode: 51, \"AnimCurveNode::R\", \"\" {\n    Properties70: {\n      P: \"d|X\", "
         "\"Number\", \"\", \"A\",0\n      P: \"d|Y\", \"Number\", \"\", \"A\",0\n      P: \"d|Z\", "
         "\"Number\", \"\", \"A\",0\n    }\n  }\n"
         "  AnimationStack: 60, \"AnimStack::bend\", \"\" {\n    Properties70: {\n      P: \"LocalStop\", "
         "\"KTime\", \"Time\", \"\",46186158000\n    }\n  }\n";
  for (int layer = 0; layer < text.layers; ++layer) {
    all += fmt::format("  AnimationLayer: {}, \"AnimLayer::layer{}\", \"\" {{\n  }}\n", 70 + layer, layer);
  }
  return all;
}

} // namespace

std::string twoBonesFbx(const FbxText& text) {
  const auto setting = [](const char* name, int value) { return intProperty(name, value); };
  std::string all = fmt::format(
      "; FBX {}.{}.0 project file\nFBXHeaderExtension:  {{\n  FBXHeaderVersion: 1003\n  FBXVersion: {}\n}}\n",
      text.version / 1000, text.version / 100 % 10, text.version);
  all += "GlobalSettings:  {\n  Version: 1000\n  Properties70:  {\n";
  all += setting("UpAxis", text.isZUp ? 2 : 1) + setting("UpAxisSign", 1) +
         setting("FrontAxis", text.isZUp ? 1 : 2) + setting("FrontAxisSign", text.isZUp ? -1 : 1) +
         setting("CoordAxis", 0) + setting("CoordAxisSign", 1);
  all += fmt::format("      P: \"UnitScaleFactor\", \"double\", \"Number\", \"\",{}\n      P: \"TimeMode\", "
                     "\"enum\", \"\", \"\",11\n  }}\n}}\n",
                     text.centimetresOfUnit);
  all += "Objects:  {\n" + objects(text) + "}\nConnections:  {\n";
  for (const char* link : {"10,0", "11,10", "12,0", "20,12", "30,12", "22,20", "23,22", "21,23", "40,20",
                           "41,40", "42,40", "10,41", "11,42"}) {
    all += fmt::format("  C: \"OO\",{}\n", link);
  }
  for (int layer = 0; layer < text.layers; ++layer) {
    all += fmt::format("  C: \"OO\",{},60\n", 70 + layer);
  }
  all += "  C: \"OO\",51,70\n  C: \"OP\",51,11, \"Lcl Rotation\"\n  C: \"OP\",50,51, \"d|X\"\n}\n";
  return all;
}

std::string postCollada() {
  const auto source = [](const char* id, const char* numbers, int count,
                         const std::vector<const char*>& names) {
    std::string parameters;
    for (const char* const name : names) {
      parameters += fmt::format("<param name=\"{}\" type=\"float\"/>", name);
    }
    return fmt::format(
        "<source id=\"{0}\"><float_array id=\"{0}-a\" count=\"{2}\">{1}</float_array><technique_common>"
        "<accessor source=\"#{0}-a\" count=\"{3}\" stride=\"{4}\">{5}</accessor></technique_common></source>",
        id, numbers, count, static_cast<std::size_t>(count) / names.size(), names.size(), parameters);
  };
  return "<?xml version=\"1.0\"?>\n<COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" "
         "version=\"1.4.1\"><asset><unit name=\"inch\" meter=\"0.0254\"/><up_axis>Z_UP</up_axis></asset>"
         "<library_geometries><geometry id=\"g\"><mesh>" +
         source("p", "0 0 0 1 0 0 0 0 1", 9, {"X", "Y", "Z"}) +
         "<vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/></vertices><triangles "
         "count=\"1\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p>0 1 "
         "2</p></triangles></mesh></geometry></library_geometries>"
         "<library_animations><animation id=\"a\">" +
         source("t", "0 1", 2, {"TIME"}) + source("z", "10 20", 2, {"Z"}) +
         "<source id=\"i\"><Name_array id=\"i-a\" count=\"2\">LINEAR "
         "LINEAR</Name_array><technique_common><accessor source=\"#i-a\" count=\"2\" stride=\"1\"><param "
         "name=\"INTERPOLATION\" type=\"name\"/></accessor></technique_common></source>"
         "<sampler id=\"s\"><input semantic=\"INPUT\" source=\"#t\"/><input semantic=\"OUTPUT\" "
         "source=\"#z\"/><input semantic=\"INTERPOLATION\" source=\"#i\"/></sampler><channel source=\"#s\" "
         "target=\"post/move.Z\"/></animation></library_animations>"
         "<library_visual_scenes><visual_scene id=\"scene\"><node id=\"post\" name=\"post\"><translate "
         "sid=\"move\">0 0 10</translate><instance_geometry "
         "url=\"#g\"/></node></visual_scene></library_visual_scenes>"
         "<scene><instance_visual_scene url=\"#scene\"/></scene></COLLADA>\n";
}

} // namespace stretch::test
