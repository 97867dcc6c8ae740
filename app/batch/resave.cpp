#include <memory>

#include "app/batch/options.h"
#include "app/batch/output.h"
#include "app/batch/output_file.h"
#include "app/batch/trail_report.h"
#include "app/batch/verb.h"
#include "app/document.h"
#include "app/files/save.h"
#include "core/gltf/json/json.h"

namespace stretch::app {

namespace {

struct ResaveArguments {
  FileArguments input;
  OutputFile output;
};

Status runResave(const ResaveArguments& arguments) {
  if (Status apart = checkOutput(arguments.output, {arguments.input.file}); !apart) {
    return apart;
  }
  Result<Document> document = openDocument(arguments.input);
  if (!document) {
    return document.error();
  }
  printWarnings(documentWarnings(*document));
  Document sourceAlone; // the scene goes before the file as it will be stands beside it
  sourceAlone.source = document->source;
  const gltf::Edits edits = editsOf(*document, {}).edits;
  document = Error{};
  printWarnings(besideLines(*sourceAlone.source, arguments.output.path));
  return saveEdits(sourceAlone, edits, arguments.output.path);
}

} // namespace

Verb resaveVerb() {
  return {"resave", "Opens a file and saves it without an edit (.glb and .gltf, both directions).",
          [](CommandLine& line) {
            const auto arguments = std::make_shared<ResaveArguments>();
            line.examples({"punch.glb -o punch.gltf"});
            addFileArguments(line, arguments->input);
            addOutputFile(line, arguments->output, "The .glb or .gltf to write");
            return [arguments] { return runResave(*arguments); };
          }};
}

} // namespace stretch::app
