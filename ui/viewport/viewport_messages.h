#pragma once

#include "ui/viewport/viewport_context.h"

namespace stretch::ui {

/// Draws what was told over the picture: beside the character as it stood when the first of the messages
/// came, so that they do not hop while it plays, and off the selected trail's tip, the handles of a
/// controller, the tour and the entries of the start page; off the legends and the label of the lens too
/// where there is room.
void showMessages(ViewportContext& context);

/// Takes the message away that the left button is pressed on in this frame, and answers whether there is one:
/// the press is none for what lies below. A running tool has all presses.
bool pressMessage(ViewportContext& context);

} // namespace stretch::ui
