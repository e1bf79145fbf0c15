#include "sandbox2d/gallery.h"

#include <algorithm>
#include <cmath>

#include "core/base/file.h"
#include "core/image/raster.h"
#include "core/scene/document_json.h"
#include "core/scene/picture.h"
#include "core/window/ui.h"

namespace seesaw {

namespace {

constexpr const char* gallery_title = "The papers' figures";

Raster thumbnail(const GalleryEntry& entry, double side, double pixel_ratio, bool dark) {
  Document<2> document = read_scene(entry);
  document.display.isolines = document.display.scale_bar = false;
  const auto fitted = fit(document);
  Canvas canvas(side, side);
  draw_document(canvas, canvas.bounds(), document, fitted.function,
                {.symbol_size = std::max(4.0, side / 26),
                 .curve_width = std::max(1.2, side / 90),
                 .spike_length = side / 9,
                 .detail = {.curve_cells = 96, .field_samples = 0.5}});
  Raster raster;
  raster.paint(canvas, pixel_ratio);
  if (dark) raster.negative(ui_colors(true).background);
  return raster;
}

}  // namespace

const std::vector<GalleryEntry>& gallery() {
  static const std::vector<GalleryEntry> entries = {
      {"turk2002-fig01-left.json",
       "Figure 1, left",
       "Four boundary constraints and one interior constraint: a closed curve.",
       "Drag the plus sign toward a circle and beyond: the curve follows what is inside.",
       false,
       {}},
      {"turk2002-fig01-right.json",
       "Figure 1, right",
       "Three more boundary constraints, in red, refine the curve.",
       "Drag a red circle: the curve follows, and hardly moves elsewhere.",
       false,
       {}},
      {"turk2002-fig04-left.json",
       "Figure 4, left",
       "A cage of exterior constraints closes the curve through two boundary constraints.",
       "Select the cage with Shift+E and delete it: nothing says what is outside, and there is no curve. "
       "Undo.",
       false,
       {}},
      {"turk2002-fig04-right.json",
       "Figure 4, right",
       "The same cage around more boundary constraints.",
       "Drag a boundary constraint toward the middle and make the curve concave, then tear it in two.",
       false,
       {}},
      {"turk2002-fig05-left.json",
       "Figure 5, left",
       "Six boundary constraints, each with a normal constraint.",
       "Drag the free end of the north-west spike; with Ctrl its length becomes its value.",
       false,
       {}},
      {"turk2002-fig05-right.json",
       "Figure 5, right",
       "Only the north-west normal constraint has moved.",
       "Drag the red spike back, and compare: M remembers, O shows what was remembered.",
       false,
       {}},
      {"seesaw.json", "The see-saw",
       "Each boundary constraint acts much like a see-saw: pull up on one side, and the other side goes "
       "down.",
       "Pull the interior value up with the slider: the plate tips about the circles, which stay at 0.", true,
       ProfileLine{{-0.3, 0.7286}, {0.63, -1.53}}},
      {"knot-insertion.json",
       "New constraints",
       "A boundary constraint that is placed on the curve changes it nowhere.",
       "Double-click the curve: nothing moves. Then drag the new constraint.",
       false,
       {}},
      {"height-field.json",
       "Not a height field",
       "Eight points of a circle that no height field can close, and one interior constraint that does.",
       "Delete the interior constraint: no inside, no curve. Undo.",
       true,
       {}},
      {"kernels-2d.json",
       "Three kernels",
       "The same constraints under r\u00b2 log r, r\u00b3 and r: the smoother the kernel, the rounder the "
       "curve.",
       "Press Shift+O to lay another kernel's curve over this one.",
       false,
       {}},
  };
  return entries;
}

std::filesystem::path scenes_folder() { return shipped_folder("scenes", SEESAW_FIGURES_DIR); }

Document<2> read_scene(const GalleryEntry& entry) { return read_document<2>(scenes_folder() / entry.scene); }

void GalleryDialog::ask(std::function<void(const GalleryEntry&)> chosen) {
  chosen_ = std::move(chosen);
  ui::open_dialog(gallery_title);
}

void GalleryDialog::draw_pictures(double side, double pixel_ratio, bool dark) {
  if (side == side_ && dark == dark_ && pictures_.size() == gallery().size()) return;
  side_ = side;
  dark_ = dark;
  pictures_.clear();
  for (const GalleryEntry& entry : gallery()) {
    Texture& texture = pictures_.emplace_back();
    try {
      const Raster raster = thumbnail(entry, side, pixel_ratio, dark);
      texture.upload({raster.data(), raster.width(), raster.height(), raster.stride(), PixelOrder::bgra});
    } catch (const Error&) {
      // A scene that is missing has no picture; opening it says why.
    }
  }
}

void GalleryDialog::frame(double width, double height, double pixel_ratio, bool dark) {
  const double s = ui::scale(), margin = 24 * s;
  const auto dialog = ui::dialog(gallery_title, std::min(width - margin, 1120 * s));
  if (!dialog) return;
  const int columns = std::clamp(static_cast<int>(ui::width_left() / (205 * s)), 1, 5);
  // With its title and what to try beneath it.
  const double area_height = std::min(height - 190 * s, 640 * s);
  const double cell = ui::width_left() / columns;
  const double side = std::floor(std::max(60.0, std::min(cell - 24 * s, area_height - 110 * s)));
  draw_pictures(side, pixel_ratio, dark);
  ui::soft_text("Each opens as a copy that you can drag, change and save under a name of its own.");
  {
    const auto area = ui::scroll_area("figures", 0, area_height);
    const auto n = static_cast<std::size_t>(columns);
    const auto table =
        ui::table("gallery", std::vector<std::string>(n, ""), false, std::vector<double>(n, 1));
    for (std::size_t i = 0; table && i < gallery().size(); ++i) {
      const GalleryEntry& entry = gallery()[i];
      ui::next_cell();
      const auto scope = ui::id(static_cast<long>(i));
      const ui::PictureUse use = ui::picture(entry.title, pictures_[i], side, side);
      if (use.hovered) ui::pointer(ui::Pointer::hand);
      const bool clicked = use.hovered && use.held && use.button == 0;
      ui::bold_text(entry.title);
      ui::paragraph(entry.try_this);
      ui::gap(8 * s);
      if (clicked) {
        ui::close_dialog();
        const auto chosen = std::move(chosen_);
        chosen_ = {};
        if (chosen) chosen(entry);
        return;
      }
    }
  }
  if (ui::button("Close")) ui::close_dialog();
}

}  // namespace seesaw
