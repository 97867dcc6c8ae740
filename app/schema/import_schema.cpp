#include "app/schema/import_schema.h"

#include "app/schema/schema_rows.h"

namespace stretch::app {

const Schema<ImportSettings>& importSchema() {
  static const Schema<ImportSettings> schema{setting<ImportSettings>(
      {.name = "touch",
       .maximum = 1.0,
       .help = "How far the hands of an imported clip are brought to what the source's touch, and its arms "
               "out of trunk and head; 0 leaves them where the joints take them.",
       .row = {.section = "file", .label = "Hands touch", .percent = true}},
      &ImportSettings::touch)};
  return schema;
}

} // namespace stretch::app
