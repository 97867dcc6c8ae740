#include "app/commands/table/command_ids.h"
#include "app/commands/table/document_commands.h"
#include "app/commands/table/tables.h"

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
       .label = "Cancel the compression or export",
       .help = "Stops what is being made of the sequence; what was made before stays.",
       .keys = {},
       .enabledOnSequence = [](const SequenceSession& session) { return session.isWorking(); },
       .runOnSequence = doing([](SequenceSession& session) { session.cancelWork(); }),
       .needs = "nothing is being made"},
      {.id = command::skeletonLeave,
       .label = "Leave the bones of the file",
       .help = "The sequence gets bones of its own again.",
       .keys = {},
       .enabledOnSequence =
           [](const SequenceSession& session) { return !session.document().settings.skeleton.empty(); },
       .runOnSequence = doing([](SequenceSession& session) {
         session.edit(withoutSkeleton(session.document()), "Leave the bones of the file");
       }),
       .needs = "no bones were taken from a file"},
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
