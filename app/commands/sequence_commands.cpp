#include "app/commands/command_ids.h"
#include "app/commands/document_commands.h"
#include "app/commands/tables.h"

namespace stretch::app {

namespace {

bool hasResult(const SequenceSession& session) {
  return session.document().result != nullptr;
}

} // namespace

std::vector<DocumentCommand> sequenceCommands() {
  return {
      {.id = command::sequenceCompress,
       .label = "Compress the sequence",
       .help = "Makes a skinned clip of the mesh sequence, with the settings of the panel.",
       .keys = {"Shift+Enter"},
       .enabledOnSequence = [](const SequenceSession& session) { return !session.isCompressing(); },
       .runOnSequence = [](SequenceSession& session) { return session.startCompression(); },
       .needs = "it is being compressed"},
      {.id = command::sequenceCancel,
       .label = "Cancel the compression",
       .help = "Stops it; what was compressed before stays.",
       .keys = {},
       .enabledOnSequence = [](const SequenceSession& session) { return session.isCompressing(); },
       .runOnSequence = doing([](SequenceSession& session) { session.cancelCompression(); }),
       .needs = "nothing is being compressed"},
      {.id = command::sequenceOriginal,
       .label = "Show the original sequence",
       .help = "Shows the meshes as they were simulated, in red.",
       .keys = {},
       .enabledOnSequence = [](const SequenceSession&) { return true; },
       .runOnSequence = doing(
           [](SequenceSession& session) { session.view().showOriginal = !session.view().showOriginal; })},
      {.id = command::sequenceSkinned,
       .label = "Show the skinned result",
       .help = "Shows what the compressed clip makes of them, in green.",
       .keys = {},
       .enabledOnSequence = hasResult,
       .runOnSequence =
           doing([](SequenceSession& session) { session.view().showSkinned = !session.view().showSkinned; }),
       .needs = "compress the sequence first"},
  };
}

} // namespace stretch::app
