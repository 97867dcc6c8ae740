#include "ui/panels/toasts.h"

#include <algorithm>

namespace stretch::ui {

void tell(UiState& ui, ToastKind kind, const std::string& text) {
  const bool shown =
      std::any_of(ui.toasts.begin(), ui.toasts.end(), [&](const Toast& toast) { return toast.text == text; });
  if (!shown) {
    ui.toasts.push_back({kind, text, kind == ToastKind::error ? 8.0F : 4.0F});
  }
}

void tellProblem(UiState& ui, const Status& status) {
  if (!status) {
    tell(ui, ToastKind::error, status.error().line());
  }
}

} // namespace stretch::ui
