#include "app/files/autosave.h"

#include <csignal>
#include <fstream>
#include <sstream>
#include <string>
#include <system_error>

#include <fmt/format.h>
#include <unistd.h>

#include "app/edits/pose/prop_file_edits.h"
#include "app/files/imported_clips.h"
#include "app/files/saved_work.h"
#include "app/files/user_files.h"
#include "core/gltf/json/json.h"
#include "core/gltf/json/json_integers.h"
#include "core/gltf/patch/edits.h"
#include "core/gltf/source/added_file.h"
#include "core/gltf/source/json_text.h"

namespace stretch::app {

namespace {

namespace fs = std::filesystem;
using gltf::Json;

fs::path autosaveFolder() {
  return stateFolder() / "autosave";
}

std::string absoluteText(const fs::path& path) {
  std::error_code ignored;
  return fs::absolute(path, ignored).lexically_normal().string();
}

/// A folder of its own, as pictures may come to lie beside it.
fs::path sourceBeside(const fs::path& autosave) {
  return fs::path(autosave).replace_extension("source") / "source.glb";
}

/// The document on the source that was kept beside the autosave, as if it had been opened from its own file.
Result<Document> onKeptSource(Document document, const fs::path& autosave) {
  Result<gltf::Loaded> loaded = gltf::load(sourceBeside(autosave), gltf::Tolerance::warn);
  if (!loaded) {
    return loaded.error();
  }
  gltf::Source source = *loaded->source;
  source.path = document.source->path;
  document.source = std::make_shared<const gltf::Source>(std::move(source));
  document.scene = loaded->scene;
  document.clips = std::make_shared<const std::vector<Clip>>(std::move(loaded->clips));
  document.sourceClips = nullptr;
  document.importedClips = 0; // It has them.
  document.body = bodyOfSource(document);
  return document;
}

/// The file's content; null when it is none of ours.
Json readAutosave(const fs::path& file) {
  const Result<std::string> text = readText(file);
  const Json json = gltf::parseAnyJson(text ? *text : "");
  const bool ours = json.is_object() && json.contains("source") && json["source"].is_string() &&
                    json.contains("process") && json["process"].is_number_integer() && json.contains("work");
  return ours ? json : Json();
}

/// When a process began, in ticks since the system did (proc(5), stat, the 22nd field); 0: unknown, or it has
/// ended and nobody has asked how yet.
std::uint64_t beginOf(long process) {
  std::ifstream file(fmt::format("/proc/{}/stat", process));
  std::string line;
  std::getline(file, line);
  // The second field, a name in parentheses, may hold anything.
  const std::size_t end = line.rfind(')');
  std::istringstream fields(end == std::string::npos ? std::string() : line.substr(end + 1));
  std::string word;
  std::string state;
  fields >> state;
  for (int field = 4; field < 22; ++field) {
    fields >> word;
  }
  std::uint64_t ticks = 0;
  fields >> ticks;
  return fields && state != "Z" && state != "X" ? ticks : 0;
}

/// The numbers of processes are given out again: the one that kept the work is the one that began when it
/// did.
bool isAlive(const Json& autosave) {
  const auto process = autosave["process"].get<long>();
  const bool runs =
      process > 0 && process != static_cast<long>(getpid()) && kill(static_cast<pid_t>(process), 0) == 0;
  const Json began = autosave.value("began", Json());
  return runs && (!began.is_number_unsigned() || began.get<std::uint64_t>() == beginOf(process));
}

} // namespace

fs::path autosavePath(const fs::path& source) {
  return autosaveFolder() / fmt::format("{}-{}.json", nameFor(source), getpid());
}

std::string autosaveText(const Document& document, const WorkPlace& place, const fs::path& source,
                         bool hasSource) {
  return Json{
      {"version", 1},
      {"source", absoluteText(source)},
      {"process", static_cast<long>(getpid())},
      {"began", beginOf(getpid())},
      {"work", workOf(document)},
      {"patched", hasSource},
      {"imported_clips", importedClipsToJson(document)},
      {"added", document.addedFiles.empty() ? Json() : gltf::addedToJson(document.addedFiles)},
      {"view",
       {{"clip", place.clip}, {"frame", place.frame}, {"limbs", place.limbs}, {"trail", place.trail}}}}
      .dump(-1, ' ', false, Json::error_handler_t::replace);
}

Status keepSourceAside(const gltf::Source& source, const fs::path& autosave) {
  const fs::path file = sourceBeside(autosave);
  std::error_code problem;
  fs::create_directories(file.parent_path(), problem);
  return problem ? Status(Error{"cannot be made: " + problem.message(), file.parent_path().string(), ""})
                 : gltf::save(source, file);
}

std::optional<WorkPlace> placeOfAutosave(const fs::path& autosave) {
  const Json json = readAutosave(autosave);
  try {
    const Json& view = json.at("view");
    return WorkPlace{gltf::integerOf(view.at("clip")), view.at("frame").get<double>(),
                     view.at("limbs").get<std::vector<std::string>>(), gltf::integerOf(view.at("trail"))};
  } catch (const Json::exception&) {
    return std::nullopt; // Of an earlier version, or damaged.
  }
}

std::optional<Autosave> findAutosave(const fs::path& source) {
  std::error_code problem;
  std::optional<Autosave> newest;
  fs::file_time_type newestTime{};
  for (fs::directory_iterator entry(autosaveFolder(), problem), end; !problem && entry != end;
       entry.increment(problem)) {
    const Json json = entry->path().extension() == ".json" ? readAutosave(entry->path()) : Json();
    if (json.is_null() || isAlive(json)) {
      continue;
    }
    std::error_code gone;
    const std::string edited = json["source"].get<std::string>();
    const fs::file_time_type time = entry->last_write_time(gone);
    const bool wanted = source.empty() ? fs::exists(edited, gone) : edited == absoluteText(source);
    if (wanted && (!newest || time > newestTime)) {
      newest = Autosave{entry->path(), edited};
      newestTime = time;
    }
  }
  return newest;
}

Result<Document> withAutosave(const Document& document, const fs::path& autosave) {
  const Json json = readAutosave(autosave);
  if (json.is_null()) {
    return Error{"the unsaved work cannot be read", autosave.string(), "go on with the file as it was saved"};
  }
  Document restored = withoutWork(document);
  if (json.value("patched", Json()) == true) {
    Result<Document> with = onKeptSource(restored, autosave);
    if (!with) {
      return with.error();
    }
    restored = std::move(with).value();
  } else if (json.contains("imported_clips")) {
    Result<Document> with = withImportedClips(restored, json["imported_clips"]);
    if (!with) {
      return with.error();
    }
    restored = std::move(with).value();
  }
  if (json["work"].is_null()) {
    return restored;
  }
  if (json.contains("added") && json["added"].is_object()) {
    Result<Document> with = withAddedFiles(restored, gltf::addedFromJson(json["added"]));
    if (!with) {
      return with.error();
    }
    restored = std::move(with).value();
  }
  const Status done = restoreWork(json["work"], restored);
  return done ? Result<Document>(restored) : Result<Document>(done.error());
}

void removeAutosave(const fs::path& autosave) {
  std::error_code ignored;
  fs::remove(autosave, ignored);
  fs::remove_all(sourceBeside(autosave).parent_path(), ignored);
}

} // namespace stretch::app
