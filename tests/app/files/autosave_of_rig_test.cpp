// A rig that was built and a binding are kept aside with the work, and what cannot be taken up stays where it
// is.
#include <algorithm>
#include <cstdlib>

#include <catch2/catch.hpp>

#include "app/bind/bind_mesh.h"
#include "app/files/autosave.h"
#include "app/files/save.h"
#include "app/locators/build_rig.h"
#include "app/locators/fit_locators.h"
#include "core/base/file.h"
#include "tests/support/app/mesh_file.h"
#include "tests/support/skinning/tube_person.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::app;
namespace fs = std::filesystem;

namespace {

/// A person without a skeleton in a file, and the state folder beside it.
struct Statue {
  Statue() : file(folder / "person.gltf") {
    setenv("XDG_STATE_HOME", (folder.path() / "state").c_str(), 1);
    const test::TubePerson person = test::tubePerson();
    test::writeMeshFile(file, person.positions, person.triangles);
  }
  [[nodiscard]] Document opened() const {
    Result<Document> document = openDocument(file);
    REQUIRE(document);
    return std::move(*document);
  }
  [[nodiscard]] fs::path keep(const Document& document) const {
    fs::path aside = autosavePath(file);
    REQUIRE(keepSourceAside(*document.source, aside));
    REQUIRE(writeText(aside, autosaveText(document, {}, file, true)));
    return aside;
  }

  test::TemporaryFolder folder;
  fs::path file;
};

rig::Locators locatorsOf(const Document& document) {
  Result<FittedLocators> fitted = fitLocators(document);
  REQUIRE(fitted);
  return fitted->locators;
}

} // namespace

TEST_CASE("A rig that was built and not saved comes back with the work on its limbs", "[locators]") {
  const Statue statue;
  const Document before = statue.opened();
  const Result<Document> rigged = withRigAt(before, locatorsOf(before));
  REQUIRE(rigged);
  Document worked = *rigged;
  worked.limbsCorrected = true; // by joints that the file lacks
  const fs::path aside = statue.keep(worked);

  const Result<Document> back = withAutosave(statue.opened(), aside);
  REQUIRE(back);
  CHECK(back->source->path == statue.file);
  CHECK(back->scene->nodes.size() == worked.scene->nodes.size());
  REQUIRE(findLimb(*back, "left-arm") != nullptr);
  CHECK(findLimb(*back, "left-arm")->joints == findLimb(worked, "left-arm")->joints);
  CHECK(back->limbsCorrected);
  CHECK(back->locators == worked.locators);

  removeAutosave(aside);
  CHECK_FALSE(fs::exists(aside));
  CHECK(fs::is_empty(aside.parent_path()));
}

TEST_CASE("A binding that was not saved comes back though nothing else was done", "[locators]") {
  const Statue statue;
  const Document before = statue.opened();
  const Result<BoundMeshes> bound = bindMeshes(before, {.locators = locatorsOf(before)});
  REQUIRE(bound);
  const Result<Document> made = withBoundMeshes(before, *bound);
  REQUIRE(made);
  const Result<Document> back = withAutosave(statue.opened(), statue.keep(*made));
  REQUIRE(back);
  REQUIRE(back->scene->skins.size() == made->scene->skins.size());
  CHECK(back->scene->skins[0].joints == made->scene->skins[0].joints);
  const auto& now = back->scene->meshes[0].primitives[0].influences;
  const auto& then = made->scene->meshes[0].primitives[0].influences;
  CHECK_FALSE(now.empty());
  CHECK(std::ranges::equal(now, then, [](const VertexInfluences& a, const VertexInfluences& b) {
    return a.joints == b.joints && a.weights == b.weights;
  }));
}
