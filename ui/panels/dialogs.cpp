#include "ui/panels/panels.h"

namespace stretch::ui {

void drawDialogs(PanelContext& context) {
  (void)context;
}

} // namespace stretch::ui
