#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/document.h"

namespace stretch::app {

/// Work that was not saved when the program went away. The work is small (trails and settings), so it is
/// written to the side every few seconds; the character itself only when a rig or a binding has changed it.
struct Autosave {
  std::filesystem::path file;   ///< Path of the autosave itself.
  std::filesystem::path source; ///< File that was being edited.
};

/// Path at which this process keeps the unsaved work on a file: each window that is open on it has its own.
[[nodiscard]] std::filesystem::path autosavePath(const std::filesystem::path& source);

/// Clip and frame at which the artist was.
struct WorkPlace {
  int clip = 0;
  double frame = 0.0;
  std::vector<std::string> limbs; ///< Selected.
  int trail = 0;                  ///< Selected; 0 none.

  friend bool operator==(const WorkPlace&, const WorkPlace&) = default;
};

/// The autosave as text: what was edited, by which process, the work, and where it was worked. `hasSource`:
/// the document's source is kept beside it (keepSourceAside).
[[nodiscard]] std::string autosaveText(const Document& document, const WorkPlace& place,
                                       const std::filesystem::path& source, bool hasSource = false);

/// Writes a source that is another than its file's, as after a rig was built or a mesh bound, beside its
/// autosave.
[[nodiscard]] Status keepSourceAside(const gltf::Source& source, const std::filesystem::path& autosave);

/// Nothing where the autosave does not say.
[[nodiscard]] std::optional<WorkPlace> placeOfAutosave(const std::filesystem::path& autosave);

/// The newest autosave that no living process owns: of this file, or of any when `source` is empty.
[[nodiscard]] std::optional<Autosave> findAutosave(const std::filesystem::path& source);

/// The document with the autosaved work in place of its own.
[[nodiscard]] Result<Document> withAutosave(const Document& document, const std::filesystem::path& autosave);

/// Forgets it, and what was kept beside it: the work was saved, or the user does not want it.
void removeAutosave(const std::filesystem::path& autosave);

} // namespace stretch::app
