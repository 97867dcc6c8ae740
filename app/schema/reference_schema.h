#pragma once

#include "app/clip_reference.h"
#include "app/schema/schema.h"

namespace stretch::app {

/// Settings of the images and of the sound of a reference: recipes, the user's settings of a file and the
/// rows of the dialog.
[[nodiscard]] const Schema<ReferenceImages>& referenceImagesSchema();
[[nodiscard]] const Schema<ReferenceSound>& referenceSoundSchema();

} // namespace stretch::app
