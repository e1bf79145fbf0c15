#include "sandbox2d/scene_painter.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/base/parallel.h"
#include "core/editing/hit_test.h"
#include "core/implicit/grid_field.h"
#include "core/scene/crowding.h"

namespace seesaw {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// From so many centers on a draft is drawn from a grid of the function: sampled once, for colors, isolines
// and curve together. Fewer are as quick themselves, and exact.
constexpr Index gridded_draft = 150;

}  // namespace

bool SceneWish::operator==(const SceneWish& b) const {
  return revision == b.revision && function == b.function && other == b.other &&
         pixel_ratio == b.pixel_ratio && scale == b.scale && document.display == b.document.display &&
         view.page.width == b.view.page.width && view.page.height == b.view.page.height &&
         view.scale == b.view.scale && view.scene.min() == b.view.scene.min() &&
         view.scene.max() == b.view.scene.max();
}

ScenePicture paint_scene(const SceneWish& wish, const SceneDetail& detail, Raster reuse) {
  const auto start = Clock::now();
  const Rect page = wish.view.page;
  Canvas canvas(page.width, page.height);
  ScenePicture result;
  result.raster = std::move(reuse);
  result.view = wish.view;
  Document<2> document = wish.document;
  document.display.view = wish.view.scene;
  const Reaches sizes;
  const double share =
      wish.scale * symbol_share(usual_spacing(document), wish.view.scale, wish.scale * sizes.symbol_size);
  PictureOptions options{.symbol_size = share * sizes.symbol_size,
                         .curve_width = 2.2 * wish.scale,
                         .spike_length = share * sizes.spike_length,
                         .text_size = 10 * wish.scale,
                         .detail = detail.picture};
  const auto drawn_from =
      [&](const std::shared_ptr<const Interpolant<2>>& f) -> std::shared_ptr<const Field<2>> {
    if (!f || detail.grid_columns == 0) return f;
    const int rows = std::max(1, static_cast<int>(detail.grid_columns * page.height / page.width));
    return std::make_shared<GridField>(*f, wish.view.scene, detail.grid_columns, rows);
  };
  const std::shared_ptr<const Field<2>> function = drawn_from(wish.function), other = drawn_from(wish.other);
  result.sampling_seconds = seconds_since(start);
  if (other)
    options.ghosts = detail.picture.every_component
                         ? contour(document, *other, wish.view.scene).polylines
                         : contour(*other, wish.view.scene, {.find_hidden = false}).polylines;
  if (function)
    result.curve = draw_document(canvas, page, document, *function, options).curve;
  else
    draw_plain_document(canvas, page, document, options);
  result.raster.paint(canvas, wish.pixel_ratio);
  result.seconds = seconds_since(start);
  return result;
}

SceneDetail fine_detail(const SceneWish& wish) {
  SceneDetail detail;
  // Numbers are measured on this curve, too.
  detail.picture.curve_cells = 256;
  detail.picture.most_vertices = 50'000;
  const double centers = wish.function ? static_cast<double>(wish.function->size()) : 0;
  const double sums = centers * wish.view.page.width * wish.view.page.height;
  constexpr double most = 4e8;  // half a second
  if (sums > most) detail.picture.field_samples = std::sqrt(most / sums);
  return detail;
}

ScenePainter::~ScenePainter() {
  if (fine_.valid()) fine_.wait();
}

SceneDetail ScenePainter::draft_detail(const SceneWish& wish) const {
  SceneDetail detail;
  detail.picture = {.curve_cells = 64, .isoline_cells = 64, .field_samples = 0.25, .most_vertices = 10'000};
  const Index centers = wish.function ? wish.function->size() : 0;
  if (centers < gridded_draft) return detail;
  // A gradient is about two sums, and a function to compare with is as many again.
  const double points =
      draft_seconds_ / (seconds_a_sum_ * static_cast<double>(centers) * (wish.other ? 4 : 2));
  const Rect page = wish.view.page;
  detail.grid_columns =
      std::clamp(static_cast<int>(std::sqrt(points * page.width / std::max(1.0, page.height))), 24, 160);
  detail.picture.every_component = false;
  return detail;
}

void ScenePainter::take(ScenePicture picture) {
  spare_ = std::move(picture_.raster);
  picture_ = std::move(picture);
  ++number_;
}

void ScenePainter::collect(bool wait) {
  if (!fine_.valid()) return;
  if (!wait && fine_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
  ScenePicture done = fine_.get();
  done.fine = true;
  // What has changed meanwhile was drawn as a draft, and is finer than nothing but newer than this.
  if (wish_ && fine_wish_ && *fine_wish_ == *wish_) take(std::move(done));
  fine_wish_.reset();
}

void ScenePainter::paint(SceneWish wish, double now, bool moving, bool wait) {
  collect(false);
  if (!wish_ || !(*wish_ == wish)) {
    const SceneDetail detail = draft_detail(wish);
    ScenePicture draft = paint_scene(wish, detail, std::move(spare_));
    spare_ = {};
    if (detail.grid_columns > 0) {
      const double sums = 2.0 * detail.grid_columns * detail.grid_columns * wish.view.page.height /
                          wish.view.page.width * static_cast<double>(wish.function->size());
      // Half the way to what was seen: one slow frame is no slow machine.
      const double seen = draft.sampling_seconds / sums / (wish.other ? 2 : 1);
      seconds_a_sum_ = std::clamp(0.5 * (seconds_a_sum_ + seen), 1e-10, 1e-6);
    }
    draft_took_ = draft.seconds;
    take(std::move(draft));
    wish_ = std::move(wish);
    changed_ = now;
  }
  const bool due = !picture_.fine && !moving && now - changed_ >= rest_;
  if (due && !fine_.valid()) {
    fine_wish_ = wish_;
    fine_ = std::async(std::launch::async, [job = *wish_, arrived = arrived_] {
      // Whoever drags meanwhile keeps a core.
      ScenePicture picture;
      leaving_a_core([&] { picture = paint_scene(job, fine_detail(job)); });
      if (arrived) arrived();
      return picture;
    });
  }
  if (due && wait) collect(true);
}

}  // namespace seesaw
