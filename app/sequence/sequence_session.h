#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "app/editing.h"
#include "app/sequence/job.h"
#include "app/sequence/sequence_document.h"

namespace stretch::app {

/// Outcome of a compression: the result, and how it would be written.
struct CompressedClip {
  std::shared_ptr<const Compression> result;
  std::shared_ptr<const ExportedClip> clip;
};

/// Looks in which a sequence is shown.
enum class SequenceLook {
  material,  ///< The materials of its source.
  compare,   ///< Red for the original, green for the skinned result.
  error,     ///< How far the result is from the original, vertex by vertex, as colour.
  thickness, ///< The shape diameter as colour.
  segments,  ///< A colour for each bone, mixed by the weights.
  cylinders  ///< The segments as cylinders, as the elastic model sees them.
};

/// View of a sequence: not part of the document.
struct SequenceView {
  double frame = 0.0; ///< Playhead.
  bool showOriginal = true;
  bool showSkinned = true; ///< Shown where there is a result.
  SequenceLook look = SequenceLook::material;
};

/// An open mesh sequence: the door for its edits, what is looked at, and the work beside the caller: a
/// compression, the result encoded as the document asks for, and a file that is written.
class SequenceSession : public Editing<SequenceDocument> {
public:
  explicit SequenceSession(SequenceDocument document) : Editing(std::move(document)) {}

  [[nodiscard]] SequenceView& view() { return view_; }
  [[nodiscard]] const SequenceView& view() const { return view_; }

  /// Compresses with the document's settings, beside the caller; refused while a compression is being made.
  Status startCompression();
  [[nodiscard]] bool isCompressing() const { return compression_ != nullptr; }
  [[nodiscard]] double compressedShare() const { return shareOf(compression_); } ///< 0..1.
  /// Takes up what a finished compression made, as an edit; not while something is dragged. Empty while
  /// there is none to take; an error when it failed, not when it was cancelled.
  [[nodiscard]] std::optional<Status> takeCompression();

  /// The document's result as it would be written; null while that is not known.
  [[nodiscard]] std::shared_ptr<const ExportedClip> clip() const;
  /// Once per frame: has the result encoded again beside the caller after it or the encoding was changed.
  void keepClip();
  [[nodiscard]] bool isEncoding() const { return encoding_ != nullptr; }
  [[nodiscard]] double encodedShare() const { return shareOf(encoding_); } ///< 0..1.

  /// Writes the document's result beside the caller; refused without one and while a file is being written.
  Status startExport(const std::filesystem::path& path);
  [[nodiscard]] bool isExporting() const { return export_ != nullptr; }
  [[nodiscard]] double exportedShare() const { return shareOf(export_); } ///< 0..1.
  /// What was written, once; empty while there is nothing to tell, and when it was cancelled. The history
  /// counts as saved where the document is still what was written.
  [[nodiscard]] std::optional<Result<WrittenClip>> takeExport();

  [[nodiscard]] bool isWorking() const { return isCompressing() || isEncoding() || isExporting(); }
  /// Asks what is being made to end soon.
  void cancelWork();

private:
  template <typename Made>
  static double shareOf(const std::unique_ptr<Job<Made>>& job) {
    return job == nullptr ? 0.0 : job->share();
  }
  /// Whether the clip was asked for with what the document has now.
  [[nodiscard]] bool isWanted(const ExportedClip& clip) const { return isClipOf(clip, document()); }

  SequenceView view_;
  std::shared_ptr<const ExportedClip> clip_; ///< The last that was encoded; may be left from other settings.
  ExportedClip encodes_;                     ///< Export that `encoding_` was asked for; its clip is empty.
  ExportedClip unwanted_; ///< Export that was cancelled: not encoded again by itself. Its clip is empty.
  std::unique_ptr<Job<CompressedClip>> compression_; ///< Null: none is being made; so the others.
  std::unique_ptr<Job<ExportedClip>> encoding_;
  std::unique_ptr<Job<WrittenClip>> export_;
  SequenceDocument exported_; ///< Document whose result `export_` writes.
};

/// Whether there is what the look shows: the error needs a result, the thickness a surface that encloses
/// something, segments and cylinders a centre line or a result.
[[nodiscard]] bool canShow(const SequenceDocument& document, SequenceLook look);

/// The last frame, >= 0.
[[nodiscard]] double lastFrame(const SequenceSession& session);
/// The frame that is shown: sequences are not interpolated.
[[nodiscard]] std::size_t shownFrame(const SequenceSession& session);

} // namespace stretch::app
