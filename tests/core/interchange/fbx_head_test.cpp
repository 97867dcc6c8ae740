#include "core/interchange/fbx_head.h"

#include <cstring>

#include <catch2/catch.hpp>

#include "tests/support/refusal.h"

using namespace stretch;
using interchange::BvhFrames;
using interchange::FbxHead;

namespace {

std::span<const std::uint8_t> spanOf(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

std::string number(std::uint32_t value) {
  std::string bytes(4, '\0');
  std::memcpy(bytes.data(), &value, 4);
  return bytes;
}

std::string binaryOf(const std::string& rest, std::uint32_t version = 7400) {
  return "Kaydara FBX Binary  " + std::string("\0\x1a\0", 3) + number(version) + rest;
}

/// A record of flags in a binary file.
std::string flags(const std::vector<std::uint32_t>& values, char kind = 'i', std::uint32_t encoding = 0) {
  std::string bytes = "KeyAttrFlags";
  bytes += kind;
  bytes += number(static_cast<std::uint32_t>(values.size())) + number(encoding) +
           number(static_cast<std::uint32_t>(4 * values.size()));
  for (const std::uint32_t value : values) {
    bytes += number(value);
  }
  return bytes;
}

FbxHead headOf(const std::string& text) {
  const Result<FbxHead> head = interchange::fbxHeadOf(spanOf(text));
  REQUIRE(head);
  return *head;
}

std::string refusalOfHead(const std::string& text) {
  return test::refusal(interchange::fbxHeadOf(spanOf(text)));
}

BvhFrames framesIn(const std::string& text) {
  return interchange::bvhFramesOf(spanOf(text));
}

} // namespace

TEST_CASE("An FBX is read from version 7.1 on, as text and as binary") {
  CHECK(refusalOfHead(binaryOf("", 7100)) == "accepted");
  CHECK(refusalOfHead(binaryOf("", 7099)).find("is an FBX of version 7.0; it is read from 7.1 (2011) on") !=
        std::string::npos);
  CHECK(refusalOfHead(binaryOf("", 6150)).find("is an FBX of version 6.1;") != std::string::npos);
  CHECK(refusalOfHead("FBXVersion: 7100\n") == "accepted");
  CHECK(refusalOfHead("FBXVersion: 6100\n").find("version 6.1;") != std::string::npos);
  CHECK(refusalOfHead("no version at all") == "accepted");
  CHECK(refusalOfHead("FBXVersion: soon\n") == "accepted");
  // The version of a binary file is in its head, whatever its texts say.
  CHECK(refusalOfHead(binaryOf("FBXVersion: 6100")) == "accepted");
  CHECK(
      refusalOfHead("Kaydara FBX Binary  " + std::string("\0\x1a\1", 3) + number(7400)).find("big endian") !=
      std::string::npos);
}

TEST_CASE("Layers beyond the first of each take are counted") {
  const std::string stack = "  AnimationStack: 60, \"one\"\n";
  const std::string layer = "  AnimationLayer: 70, \"one\"\n";
  CHECK(headOf("").layersOnTop == 0);
  CHECK(headOf(stack + layer).layersOnTop == 0);
  CHECK(headOf(stack + layer + layer + layer).layersOnTop == 2);
  CHECK(headOf(stack + layer + stack + layer).layersOnTop == 0);
  CHECK(headOf(stack + stack + layer).layersOnTop == 0);
  // Only an entry with a number is one: not a reference, not a definition.
  CHECK(headOf(stack + layer + "ObjectType: \"AnimationLayer\" {\nAnimationLayer: \"x\"\nAnimationLayer:")
            .layersOnTop == 0);
  const std::string binaryStack = std::string("\x0e") + "AnimationStackL";
  const std::string binaryLayer = std::string("\x0e") + "AnimationLayerL";
  CHECK(headOf(binaryOf(binaryStack + "..." + binaryLayer + "..." + binaryLayer + "...")).layersOnTop == 1);
  CHECK(headOf(binaryOf(binaryStack + "..." + binaryLayer + "...")).layersOnTop == 0);
  CHECK(headOf(binaryOf(binaryStack + "..." + binaryLayer +
                        "...\x0f"
                        "AnimationLayerL"))
            .layersOnTop == 0);
  CHECK(headOf(binaryOf(binaryStack + "..." + binaryLayer +
                        "...\x0e"
                        "AnimationLayerS"))
            .layersOnTop == 0);
  CHECK(headOf(binaryOf(binaryStack + "..." + binaryLayer +
                        "...\x0e"
                        "AnimationLayer"))
            .layersOnTop == 0);
  CHECK(headOf(binaryOf(binaryStack + "..." + binaryLayer + "AnimationLayer: 7")).layersOnTop == 0);
}

TEST_CASE("Curves that bend or step between keys show in any of their flags") {
  const auto bends = [](const std::string& list) {
    return headOf("KeyAttrFlags: *3 {\n a: " + list + "\n}\n").hasTangents;
  };
  CHECK_FALSE(bends("4,4,4"));
  CHECK(bends("8,4,4"));
  CHECK(bends("4,8,4"));
  CHECK(bends("4,4,8"));
  CHECK(bends("2"));
  CHECK(bends("24840,4"));
  CHECK_FALSE(bends("24836,4"));
  CHECK_FALSE(bends(""));
  CHECK_FALSE(bends("4, 16"));
  // What the list itself does not hold is none of it.
  CHECK_FALSE(headOf("KeyAttrFlags: *1 {\n}\n a: 8 }").hasTangents);
  CHECK_FALSE(headOf("KeyAttrFlags: *8 { a: 4 } 8").hasTangents);
  CHECK_FALSE(headOf("KeyAttrFlags: *1 { a: 8").hasTangents);
  CHECK(
      headOf("KeyAttrFlags: *1 { a: 4 }\nKeyAttrFlags: *1 { a: 8 }\nKeyAttrFlags: *1 { a: 4 }").hasTangents);
}

TEST_CASE("Flags of a binary FBX are read where they lie plain, as far as the file goes") {
  CHECK_FALSE(headOf(binaryOf(flags({4, 4}) + "....")).hasTangents);
  CHECK(headOf(binaryOf(flags({8, 4}) + "....")).hasTangents);
  CHECK(headOf(binaryOf(flags({4, 2}))).hasTangents);
  CHECK_FALSE(headOf(binaryOf(flags({8}, 'f'))).hasTangents);
  CHECK_FALSE(headOf(binaryOf(flags({8}, 'i', 1))).hasTangents);
  CHECK_FALSE(headOf(binaryOf("KeyAttrFlagsi")).hasTangents);
  const std::string cut = flags({4, 8});
  CHECK_FALSE(headOf(binaryOf(cut.substr(0, cut.size() - 4))).hasTangents);
  CHECK(headOf(binaryOf(flags({4}) + flags({8}) + flags({4}))).hasTangents);
}

TEST_CASE("Curves that go on beyond their keys other than held are noted") {
  const auto repeats = [](const std::string& text) { return headOf(text).hasRepetition; };
  CHECK_FALSE(repeats(""));
  CHECK_FALSE(repeats("Post-Extrapolation: {\n Type: C: \"C\"\n}"));
  CHECK(repeats("Post-Extrapolation: {\n Type: C: \"R\"\n}"));
  CHECK(repeats("Pre-Extrapolation: {\n Type: C: \"M\"\n}"));
  CHECK(repeats("Pre-Extrapolation: { Type: C: \"C\" } Post-Extrapolation: { Type: C: \"K\" } "
                "Pre-Extrapolation: { Type: C: \"C\" }"));
  CHECK_FALSE(repeats("Post-Extrapolation: { Type: C: \""));
  CHECK_FALSE(repeats("Post-Extrapolation: {" + std::string(80, ' ') + "Type: C: \"R\" }"));
  CHECK(repeats(binaryOf("Post-Extrapolation....TypeCR....")));
  CHECK_FALSE(repeats(binaryOf("Post-Extrapolation....TypeCC....")));
  CHECK_FALSE(repeats(binaryOf("Post-Extrapolation....TypeC")));
  CHECK_FALSE(repeats(binaryOf("Post-Extrapolation....C: \"R\"")));
}

TEST_CASE("A BVH says how many frames it has, and holds a line for each") {
  const auto check = [](const std::string& text, std::size_t said, std::size_t held) {
    INFO(text);
    const BvhFrames frames = framesIn(text);
    CHECK(frames.said == said);
    CHECK(frames.held == held);
  };
  check("MOTION\nFrames: 3\nFrame Time: 0.02\n1 2\n3 4\n5 6\n", 3, 3);
  check("MOTION\nFrames: 3\nFrame Time: 0.02\n1 2\n3 4\n5 6", 3, 3);
  check("MOTION\nFrames: 12\nFrame Time: 0.02\n1 2\n\n   \n3 4\r\n", 12, 2);
  check("MOTION\nFrames:\t120 \r\nFrame Time: 0.02\n", 120, 0);
  check("MOTION\nFrames: 7\nFrame Time: 0.02", 7, 0);
  check("MOTION\nFrames: 7\n1 2\n", 0, 0);
  check("MOTION\nFrame Time: 0.02\n1 2\n", 0, 0);
  check("", 0, 0);
}
