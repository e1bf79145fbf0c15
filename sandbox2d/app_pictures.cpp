// What a frame draws itself: the scene with what is in hand over it, the plate, the profile.
#include <algorithm>
#include <cmath>

#include "core/window/ui.h"
#include "sandbox2d/app.h"
#include "sandbox2d/overlay.h"

namespace seesaw {

namespace {

Pixels pixels_of(const Raster& raster) {
  return {raster.data(), raster.width(), raster.height(), raster.stride(), PixelOrder::bgra};
}

// The plate stands on the largest square in the middle of what is seen.
Box<2> square_within(const Box<2>& seen) {
  const double half = 0.5 * seen.sizes().minCoeff();
  return {seen.center() - Point<2>(half, half), seen.center() + Point<2>(half, half)};
}

}  // namespace

bool App::moving() const { return desk_.gesture() != Gesture::none || desk_.sliding(); }

void App::draw_scene() {
  const Rect place = layout_.scene;
  const Shape<2>& shape = desk_.shape();
  SceneWish wish;
  wish.revision = desk_.revision();
  wish.function = shape.function;
  wish.other = desk_.other();
  wish.view = desk_.view().plan();
  wish.pixel_ratio = window_.pixel_ratio();
  wish.scale = window_.scale();
  wish.document.display = desk_.display();
  if (!painter_.shows(wish)) wish.document = desk_.to_save();
  painter_.paint(std::move(wish), window_.clock().time(), moving(), scripted());
  if (painter_.busy()) window_.stay_awake();

  const SceneLook look{painter_.number(), window_.scale(), window_.dark(), shown_.weights, pointer_in_scene_};
  if (changed_ || !(look == look_)) {
    look_ = look;
    Canvas over(place.width, place.height, Color{0, 0, 0, 0});
    draw_overlay(over, desk_,
                 {.weights = shown_.weights,
                  .scale = window_.scale(),
                  .pointer_here = pointer_in_scene_,
                  .pointed = tour_.pointed()});
    shown_raster_.copy(painter_.picture().raster);
    shown_raster_.paint_over(over);
    if (window_.dark()) shown_raster_.negative(window_.colors().background);
    if (!shown_raster_.empty()) scene_texture_.upload(pixels_of(shown_raster_));
  }
  ui::background(scene_texture_, place);
  if (pointer_in_scene_ && !ui::any_dialog()) {
    const Over over = desk_.hover().over;
    if (desk_.tool() == Tool::pan || desk_.gesture() == Gesture::pan)
      ui::pointer(ui::Pointer::move);
    else if (over == Over::constraint || over == Over::spike || over == Over::profile_start ||
             over == Over::profile_end)
      ui::pointer(ui::Pointer::hand);
  }
}

void App::draw_plate() {
  if (layout_.plate.width <= 0) return;
  const auto panel = ui::panel("See-saw", layout_.plate, {.title = false, .padded = false, .scrolls = false});
  if (!panel) return;
  const Shape<2>& shape = desk_.shape();
  if (shape.function) {
    // A plate of so many kernels is as fine as a frame allows.
    const double most = std::sqrt(4e6 / static_cast<double>(std::max<Index>(1, shape.function->size())));
    const int cells = std::clamp(static_cast<int>(most), 16, moving() ? 56 : 96);
    plate_.show(*shape.function, desk_.document(), square_within(desk_.view().scene()), desk_.profile(),
                cells, 2 * desk_.revision() + (shape.pending ? 1 : 0));
  } else {
    plate_.clear();
  }
  const double ratio = window_.pixel_ratio();
  const auto pixels = [&](double length) {
    return std::max(1, static_cast<int>(std::lround(length * ratio)));
  };
  const Texture& picture = plate_.draw(pixels(layout_.plate.width), pixels(layout_.plate.height),
                                       ui::colors(), ratio * window_.scale());
  plate_.use(ui::picture("Plate", picture, layout_.plate.width, layout_.plate.height), shift_);
  if (!plate_.settled()) window_.stay_awake();
}

void App::draw_profile_chart() {
  if (layout_.profile.width <= 0 || !desk_.profile()) return;
  const auto panel =
      ui::panel("Profile", layout_.profile, {.title = false, .padded = false, .scrolls = false});
  if (!panel) return;
  const double s = window_.scale();
  const Rect place = layout_.profile;
  const ChartLook look{desk_.revision(),
                       desk_.shape().function,
                       desk_.other(),
                       *desk_.profile(),
                       place.width,
                       place.height,
                       s,
                       2.5 * s * desk_.view().pixel(),
                       window_.dark(),
                       moving()};
  if (!(look == chart_look_) || chart_texture_.empty()) {
    chart_look_ = look;
    Canvas chart(place.width, place.height, ui::colors().background);
    if (look.function) {
      const ProfileData data =
          profile_of(*look.function, look.line, desk_.document(), look.other.get(), look.near);
      // Another line has another range; while it is dragged the axis stands still.
      if (!look.moving && profile_line_ != look.line) {
        profile_range_.reset();
        profile_line_ = look.line;
      }
      look.moving ? profile_range_.include(data) : profile_range_.settle(data);
      draw_profile(chart, chart.bounds().inset(6 * s), data, profile_range_,
                   {.text_size = 11 * s, .colors = ui::colors()});
    }
    chart_raster_.paint(chart, window_.pixel_ratio());
    chart_texture_.upload(pixels_of(chart_raster_));
  }
  ui::picture("Chart", chart_texture_, place.width, place.height);
}

}  // namespace seesaw
