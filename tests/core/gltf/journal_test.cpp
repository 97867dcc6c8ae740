// Changes of a document that can be taken back, order of keys included.
#include <catch2/catch.hpp>

#include "core/gltf/patch/journal.h"

using namespace stretch;
using gltf::Journal;
using gltf::Json;

namespace {

using Pointer = Json::json_pointer;

const char* const document =
    R"({"z": 1, "list": [1, 2, 3], "a": {"y": true, "x": [0], "b": null}, "text": "ö"})";

/// The document after the changes of a journal were taken back.
std::string takenBack(const Journal& journal) {
  Json json = journal.json();
  CHECK(gltf::takeBack(json, journal.undo()));
  return json.dump();
}

bool isTakenBack(const char* undo) {
  Json json = Json::parse(document);
  return gltf::takeBack(json, Json::parse(undo));
}

} // namespace

TEST_CASE("A journal sets, adds and takes away, and gives back the document as it was") {
  const std::string before = Json::parse(document).dump();
  Journal journal(Json::parse(document));
  CHECK(takenBack(journal) == before);
  journal.set(Pointer("/z"), 5);
  CHECK(journal.json()["z"] == 5);
  journal.set(Pointer("/new"), Json{{"k", 1}});
  journal.set(Pointer("/new/k"), 2);
  CHECK(journal.json()["new"]["k"] == 2);
  CHECK(journal.append(Pointer("/list"), 4) == 3);
  CHECK(journal.append(Pointer("/list"), 5) == 4);
  CHECK(journal.append(Pointer("/made"), "first") == 0);
  CHECK(journal.append(Pointer("/made"), "second") == 1);
  CHECK(journal.json()["made"] == Json{"first", "second"});
  journal.erase(Pointer("/a/y"));
  CHECK_FALSE(journal.json()["a"].contains("y"));
  journal.erase(Pointer("/a/nothing"));
  CHECK(journal.json()["list"] == Json{1, 2, 3, 4, 5});
  CHECK(takenBack(journal) == before);
  const Json last = std::move(journal).takeJson();
  CHECK(last["z"] == 5);
}

TEST_CASE("A list is cut once, to the length that it had before the first was added") {
  Journal journal(Json::parse(document));
  journal.append(Pointer("/list"), 4);
  journal.append(Pointer("/list"), 5);
  CHECK(journal.undo() == Json::parse(R"([["cut", "/list", 3]])"));
  journal.append(Pointer("/a/x"), 1);
  CHECK(journal.undo() == Json::parse(R"([["cut", "/a/x", 1], ["cut", "/list", 3]])"));
  Journal fresh(Json::parse(document));
  fresh.append(Pointer("/made"), 1);
  fresh.append(Pointer("/made"), 2);
  CHECK(fresh.undo() == Json::parse(R"([["remove", "/made"]])"));
  Journal nothing(Json::parse(document));
  nothing.erase(Pointer("/gone"));
  CHECK(nothing.undo() == Json::array());
}

TEST_CASE("Steps that do not fit the document take nothing back") {
  CHECK(isTakenBack("[]"));
  CHECK(isTakenBack(R"([["set", "/z", 3], ["remove", "/a"], ["cut", "/list", 0]])"));
  CHECK(isTakenBack(R"([["cut", "/list", 3]])"));
  for (const char* const undo : {"{}",
                                 "3",
                                 "[3]",
                                 "[[]]",
                                 R"([["set"]])",
                                 R"([["set", "/z"]])",
                                 R"([["set", "/z", 1, 2]])",
                                 R"([["set", "", 1]])",
                                 R"([["set", "/gone", 1]])",
                                 R"([["remove", "/list/0"]])",
                                 R"([["remove", "/gone"]])",
                                 R"([["cut", "/list", 4]])",
                                 R"([["cut", "/list", -1]])",
                                 R"([["cut", "/list", 1.5]])",
                                 R"([["cut", "/list", "1"]])",
                                 R"([["cut", "/list"]])",
                                 R"([["cut", "/z", 0]])",
                                 R"([["other", "/list", 0]])",
                                 R"([["set", "no pointer", 1]])",
                                 R"([[1, "/z", 1]])",
                                 R"([["set", 1, 1]])"}) {
    INFO(undo);
    CHECK_FALSE(isTakenBack(undo));
  }
}
