#pragma once

#include "app/schema/saved_form.h"
#include "app/schema/schema.h"

namespace stretch::app {

/// The settings of how a stretch is told in a file.
[[nodiscard]] const Schema<SavedForm>& formSchema();

} // namespace stretch::app
