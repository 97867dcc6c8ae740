#pragma once

#include "app/session.h"

namespace stretch::app {

/// Goes to another clip, which exists: to its first frame, with nothing selected in time.
void showClip(Session& session, int clip);

} // namespace stretch::app
