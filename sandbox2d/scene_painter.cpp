#include "sandbox2d/scene_painter.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace seesaw {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// Boundary constraints from which on a draft does not follow the curve at each of them.
constexpr std::size_t seeded_draft = 300;

}  // namespace

bool SceneWish::operator==(const SceneWish& b) const {
  return revision == b.revision && function == b.function && other == b.other &&
         pixel_ratio == b.pixel_ratio && scale == b.scale && document.display == b.document.display &&
         view.page.width == b.view.page.width && view.page.height == b.view.page.height &&
         view.scale == b.view.scale && view.scene.min() == b.view.scene.min() &&
         view.scene.max() == b.view.scene.max();
}

ScenePicture paint_scene(const SceneWish& wish, const PictureDetail& detail, Raster reuse) {
  const auto start = Clock::now();
  const Rect page = wish.view.page;
  Canvas canvas(page.width, page.height);
  ScenePicture result;
  result.raster = std::move(reuse);
  result.view = wish.view;
  Document<2> document = wish.document;
  document.display.view = wish.view.scene;
  PictureOptions options{.symbol_size = 11 * wish.scale,
                         .curve_width = 2.2 * wish.scale,
                         .spike_length = 26 * wish.scale,
                         .text_size = 10 * wish.scale,
                         .detail = detail};
  if (wish.other) {
    const Contour other = detail.every_component
                              ? contour(document, *wish.other, wish.view.scene)
                              : contour(*wish.other, wish.view.scene, {.find_hidden = false});
    options.ghosts = other.polylines;
  }
  if (wish.function)
    result.curve = draw_document(canvas, page, document, *wish.function, options).curve;
  else
    draw_plain_document(canvas, page, document, options);
  result.raster.paint(canvas, wish.pixel_ratio);
  result.seconds = seconds_since(start);
  return result;
}

ScenePainter::~ScenePainter() {
  if (fine_.valid()) fine_.wait();
}

PictureDetail ScenePainter::draft_detail(const SceneWish& wish) const {
  const auto centers = static_cast<double>(wish.function ? wish.function->size() : 1);
  const double points = draft_seconds_ / (seconds_a_sum_ * std::max(1.0, centers));
  const Rect page = wish.view.page;
  const double columns = std::sqrt(0.6 * points * page.width / std::max(1.0, page.height));
  PictureDetail detail;
  detail.field_samples = std::clamp(columns / page.width, 0.03, 0.25);
  detail.curve_cells = std::clamp(static_cast<int>(std::sqrt(0.2 * points)), 32, 128);
  detail.isoline_cells = std::clamp(static_cast<int>(std::sqrt(0.2 * points)), 24, 64);
  detail.every_component = wish.document.constraints.size() <= seeded_draft && points > 30'000;
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
    const PictureDetail detail = draft_detail(wish);
    ScenePicture draft = paint_scene(wish, detail, std::move(spare_));
    spare_ = {};
    if (wish.function && wish.document.display.field) {
      const Rect page = wish.view.page;
      const double sums = page.width * page.height * detail.field_samples * detail.field_samples *
                          static_cast<double>(wish.function->size());
      // Half the way to what was seen: one slow frame is no slow machine.
      seconds_a_sum_ =
          std::clamp(0.5 * seconds_a_sum_ + 0.25 * draft.seconds / std::max(1.0, sums), 1e-10, 1e-6);
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
      ScenePicture picture = paint_scene(job, {});
      if (arrived) arrived();
      return picture;
    });
  }
  if (due && wait) collect(true);
}

}  // namespace seesaw
