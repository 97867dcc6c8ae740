#include "app/schema/form_schema.h"

#include "app/schema/schema_rows.h"

namespace stretch::app {

const Schema<SavedForm>& formSchema() {
  static const Schema<SavedForm> schema{
      setting<SavedForm>(
          {.name = "form",
           .choices = {{"scale", "Joints that scale: exact places, but some engines shade what is stretched "
                                 "wrongly, and some leave scale out."},
                       {"translation", "Joints that move: plays in every engine, and the limb keeps its "
                                       "thickness."},
                       {"volume",
                        "Corners that move: the places that scale gives, in every engine that reads "
                        "as many influences."}},
           .help = "How a stretch is told in the file (docs/engines.md says which engine shows what).",
           .row = {.section = "file", .label = "Stretch as"}},
          &SavedForm::form),
      setting<SavedForm>(
          {.name = "influences",
           .minimum = 4.0,
           .maximum = 8.0,
           .help =
               "With the form volume: most influences of a vertex; fewer are fitted, and the miss is told.",
           .row = {.section = "file", .label = "Influences", .step = 4.0}},
          &SavedForm::influences),
      setting<SavedForm>(
          {.name = "key_frames",
           .choices = {{"needed", "On whole frames, and between them where the motion needs it."},
                       {"whole", "On whole frames alone; how far the motion is off between them is told."},
                       {"every", "On every frame, and between them where the motion needs it."},
                       {"clip",
                        "On whole frames alone where all keys of the clip stand on them, else as needed."}},
           .help = "Where the changed motion gets keys.",
           .row = {.section = "file", .label = "Keys stand"}},
          &SavedForm::keys)};
  return schema;
}

} // namespace stretch::app
