#pragma once

#include <string>

#include "app/batch/command_line.h"
#include "app/document.h"
#include "core/base/result.h"
#include "skinning/elastic/moduli.h"

namespace stretch::app {

/// The character file that a verb works on.
struct FileArguments {
  std::string file;
  bool tolerant = false;
  double framesPerSecond = 0.0; ///< 0: as guessed from the keys.
};

/// Declares FILE and --tolerant; `arguments` has to live as long as the subcommand.
void addFileArguments(CommandLine& line, FileArguments& arguments);

/// Declares --fps, for verbs that count in frames.
void addFramesPerSecond(CommandLine& line, FileArguments& arguments);

[[nodiscard]] Result<Document> openDocument(const FileArguments& arguments);

/// "A:B": first and last frame, real numbers, A <= B.
[[nodiscard]] Result<Vec2> parseRange(const std::string& text);

/// The same for a clip: an error when all of it lies outside.
[[nodiscard]] Result<Vec2> rangeOf(const std::string& text, const Clip& clip);

/// "x,y,z": three numbers; `where` names the option in errors.
[[nodiscard]] Result<Vec3> parseVector(const std::string& text, const std::string& where);

/// Index of a clip by name or by "#index"; an empty text is the first clip. Names that repeat ask for an
/// index.
[[nodiscard]] Result<int> findClip(const Document& document, const std::string& text);

/// A limb by id, or a chain "JOINT_A..JOINT_B", which is added to the document's chains.
[[nodiscard]] Result<rig::Limb> findOrAddLimb(Document& document, const std::string& text);

/// Reads a file of moduli; an error names the file.
[[nodiscard]] Result<skinning::SegmentModuli> loadModuli(const std::string& path);

/// "3 clips: walk, run, jump": for messages.
[[nodiscard]] std::string clipList(const Document& document);

} // namespace stretch::app
