#include "sandbox2d/help_dialog.h"

#include <algorithm>

#include "core/base/text.h"
#include "core/editing/desk_bindings.h"
#include "core/window/ui.h"

namespace seesaw {

namespace {

constexpr const char* help_title = "Keys and gestures";

}  // namespace

void HelpDialog::ask() { ui::open_dialog(help_title); }

void HelpDialog::frame(double width, double height) {
  const double s = ui::scale();
  const auto dialog = ui::dialog(help_title, std::min(width - 40, 860 * s));
  if (!dialog) return;
  {
    const auto area = ui::scroll_area("keys", 0, std::min(height - 150 * s, 620 * s));
    const std::vector<HelpLine> lines = help_lines();
    for (std::size_t i = 0; i < lines.size();) {
      const std::string section = lines[i].section;
      ui::bold_text(section);
      {
        const auto table = ui::table(section, {"", ""}, true, {1, 2});
        for (; i < lines.size() && lines[i].section == section; ++i) {
          if (!table) continue;
          ui::next_cell();
          ui::paragraph(lines[i].keys);
          ui::next_cell();
          ui::paragraph(capitalized(lines[i].words));
        }
      }
      ui::gap(6 * s);
    }
  }
  if (ui::main_button("Close")) ui::close_dialog();
}

}  // namespace seesaw
