#include "sandbox2d/plate.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/image/theme.h"

namespace seesaw {

namespace {

constexpr double plate_radians = std::numbers::pi / 180;
constexpr double first_azimuth = -62 * plate_radians, first_elevation = 32 * plate_radians;
constexpr double rescale_beyond = 3;

// The level rectangle z = 0 over the box, a little wider than the plate so that it is seen all around.
Points<3> sheet_corners(const PlateSpace& space, const Box<2>& box) {
  Points<3> corners(3, 4);
  Index k = 0;
  for (const auto corner : {Box<2>::BottomLeft, Box<2>::BottomRight, Box<2>::TopRight, Box<2>::TopLeft})
    corners.col(k++) = space.at(box.corner(corner), 0);
  return corners;
}

// The same pixel, nearer to the eye: by the fraction `by` of its distance.
Point<3> toward(const Point<3>& eye, const Point<3>& p, double by) { return p + by * (eye - p); }

}  // namespace

Plate::Plate() : rough_(0), smooth_(4) { reset_view(); }

void Plate::show(const Field<2>& field, const Document<2>& document, const Box<2>& seen,
                 const std::optional<ProfileLine>& profile, int cells, std::uint64_t version) {
  const bool other_box = seen_.isEmpty() || seen.min() != seen_.min() || seen.max() != seen_.max();
  const bool other_plate = other_box || version_ != version || cells_ != cells || height_ == 0;
  if (!other_plate && line_ == profile) return;
  if (other_box && !seen_.isEmpty()) {
    const double growth = seen.sizes().maxCoeff() / seen_.sizes().maxCoeff();
    if (std::abs(growth - 1) > 1e-6) rescale();
  }
  seen_ = seen;
  line_ = profile;
  cells_ = cells;
  version_ = version;
  if (other_plate) build_plate(field, document, cells);
  build_profile(field);
  ++content_;
}

void Plate::clear() {
  if (!version_) return;
  version_.reset();
  for (Drawable* each : {&surface_, &grid_, &zero_, &profile_, &curtain_above_, &curtain_below_})
    *each = Drawable();
  poles_.clear();
  ++content_;
}

void Plate::build_plate(const Field<2>& field, const Document<2>& document, int cells) {
  const double present = typical_height(field, document, seen_);
  const bool choose =
      height_ == 0 || present > rescale_beyond * height_ || present < height_ / rescale_beyond;
  if (choose) height_ = present;
  mesh_ = make_plate(field, seen_, {.cells = cells, .lines_every = std::max(1, cells / 12), .height = height_});
  if (choose) {
    framed_low_ = std::min(mesh_.lowest, 0.0);
    framed_high_ = std::max(mesh_.highest, 0.0);
  }
  poles_ = plate_poles(document, mesh_.space, seen_);
  surface_.set_triangles(mesh_.mesh, mesh_.colors);
  grid_.set_segments(mesh_.grid, mesh_.grid_colors);
  zero_.set_segments(mesh_.zero);
  build_plane();
}

void Plate::build_plane() {
  TriangleMesh sheet;
  sheet.vertices = sheet_corners(mesh_.space, seen_);
  sheet.faces.resize(3, 2);
  sheet.faces << 0, 0, 1, 2, 2, 3;
  plane_.set_triangles(sheet);
  rim_.set_polyline(sheet.vertices, true);
}

void Plate::build_profile(const Field<2>& field) {
  PlateProfile profile;
  if (line_) profile = plate_profile(field, *line_, mesh_.space, seen_);
  profile_.set_polyline(profile.line);
  curtain_above_.set_triangles(profile.above);
  curtain_below_.set_triangles(profile.below);
}

void Plate::reset_view() {
  camera_ = OrbitCamera{.azimuth = first_azimuth, .elevation = first_elevation, .field = 0.5};
  at_first_view_ = true;
}

// The nearest stand from which the box of the plate, as high as when its scale was chosen, is seen whole.
void Plate::frame(int width, int height) {
  const Point<2> half = 0.5 * mesh_.space.scale * seen_.sizes();
  camera_.target = Point<3>(0, 0, (framed_low_ + framed_high_) / 2);
  const double up = std::tan(camera_.field / 2) * 0.95, aside = up * width / height;
  for (int round = 0; round < 4; ++round) {
    double distance = 0, lowest = infinity, highest = -infinity;
    std::vector<Point<3>> corners;
    for (const double x : {-half.x(), half.x()})
      for (const double y : {-half.y(), half.y()})
        for (const double z : {framed_low_, 0.0, framed_high_}) corners.emplace_back(x, y, z);
    for (const Point<3>& corner : corners) {
      const Point<3> p = corner - camera_.target;
      const double depth = p.dot(camera_.forward());
      distance = std::max({distance, std::abs(p.dot(camera_.right())) / aside - depth,
                           std::abs(p.dot(camera_.up())) / up - depth});
    }
    camera_.distance = std::max(distance, 0.1);
    for (const Point<3>& corner : corners) {
      const double y = camera_.pixel_of(corner, width, height).y();
      lowest = std::min(lowest, y);
      highest = std::max(highest, y);
    }
    camera_.pan(0, height / 2.0 - (lowest + highest) / 2, height);
  }
}

const Texture& Plate::draw(int width, int height, const UiColors& colors, double pixel_ratio) {
  width = std::max(width, 1);
  height = std::max(height, 1);
  if (at_first_view_ && !seen_.isEmpty()) frame(width, height);
  const Drawn now{content_,          width,           height,          pixel_ratio,       camera_.azimuth,
                  camera_.elevation, camera_.distance, camera_.target, colors.background, colors.ink};
  const bool changed = picture_ == nullptr || !(now == drawn_);
  drawn_ = now;
  if (changed || !picture_is_smooth_) {
    picture_is_smooth_ = !changed;
    View3D& view = picture_is_smooth_ ? smooth_ : rough_;
    draw_into(view, width, height, colors, pixel_ratio);
    picture_ = &view.end();
  }
  settled_ = picture_is_smooth_;
  return *picture_;
}

Image Plate::image() const { return picture_is_smooth_ ? smooth_.image() : rough_.image(); }

void Plate::draw_into(View3D& view, int width, int height, const UiColors& colors, double pixel_ratio) {
  view.begin(width, height, camera_, colors.background);
  view.draw(surface_);
  view.draw(grid_, {.size = 0.8 * pixel_ratio});
  view.draw(rim_, {.color = colors.soft_ink, .size = pixel_ratio});
  view.draw(zero_, {.color = theme::curve, .size = 2.6 * pixel_ratio});
  view.draw(profile_, {.color = theme::moved, .size = 2.2 * pixel_ratio});
  draw_poles(view, colors, width, height, pixel_ratio);
  // Translucent things from far to near: what is on the other side of the zero plane comes before it.
  const bool from_above = camera_.eye().z() >= 0;
  const DrawLook curtain{.color = theme::moved, .opacity = 0.16, .lit = false};
  view.draw(from_above ? curtain_below_ : curtain_above_, curtain);
  view.draw(plane_, {.color = hex("#F4F6F9"), .opacity = 0.5, .lit = false});
  view.draw(from_above ? curtain_above_ : curtain_below_, curtain);
}

void Plate::draw_poles(View3D& view, const UiColors& colors, int width, int height, double pixel_ratio) {
  const Point<3> eye = camera_.eye();
  // Through the plate they are seen faintly and dashed: drawn before everything, since nothing is so near.
  constexpr double in_front = 0.8, at_hand = 0.02;
  std::vector<Point<3>> dashes, stems;
  std::vector<Color> dash_colors, stem_colors;
  for (const PlatePole& pole : poles_) {
    if (pole.open) continue;
    const Color color = pole.highlight ? theme::moved : theme::constraint;
    stems.insert(stems.end(), {pole.foot, pole.head});
    stem_colors.insert(stem_colors.end(), 2, color);
    const double pixels =
        (camera_.pixel_of(pole.foot, width, height) - camera_.pixel_of(pole.head, width, height))
            .head<2>()
            .norm();
    const int pieces = static_cast<int>(std::clamp(pixels / (2.5 * pixel_ratio), 1.0, 400.0)) | 1;
    for (int k = 0; k < pieces; k += 2) {
      for (const int end : {k, k + 1})
        dashes.push_back(
            toward(eye, pole.foot + static_cast<double>(end) / pieces * (pole.head - pole.foot), in_front));
      dash_colors.insert(dash_colors.end(), 2, color);
    }
  }
  const auto columns = [](const std::vector<Point<3>>& points) {
    Points<3> result(3, static_cast<Index>(points.size()));
    for (std::size_t k = 0; k < points.size(); ++k) result.col(static_cast<Index>(k)) = points[k];
    return result;
  };
  Drawable lines;
  lines.set_segments(columns(dashes), dash_colors);
  view.draw(lines, {.opacity = 0.5, .size = 1.1 * pixel_ratio});
  lines.set_segments(columns(stems), stem_colors);
  view.draw(lines, {.size = 1.8 * pixel_ratio});

  // Heads lie half in the plate; a little nearer they show whole. Hidden ones are faint.
  for (const bool hidden : {true, false})
    for (const bool core : {false, true})
      for (const bool open : {false, true})
        for (const bool small : {false, true}) {
          if (core && !open) continue;
          std::vector<Point<3>> at;
          std::vector<Color> ball_colors;
          for (const PlatePole& pole : poles_) {
            if (pole.open != open || pole.small != small) continue;
            at.push_back(toward(eye, pole.head, hidden ? in_front : at_hand));
            ball_colors.push_back(core             ? theme::paper
                                  : pole.highlight ? theme::moved
                                                   : theme::constraint);
          }
          Drawable balls;
          balls.set_points(columns(at), ball_colors);
          const double size = (small ? 5 : core ? 5 : 9) * pixel_ratio;
          view.draw(balls, {.opacity = hidden ? 0.3 : 1, .size = size, .lit = !core});
        }
  static_cast<void>(colors);
}

void Plate::use(const ui::PictureUse& use, bool shift) {
  if (use.double_clicked) {
    reset_view();
    return;
  }
  const int height = std::max(1, static_cast<int>(use.place.height));
  if (use.held && (use.dx != 0 || use.dy != 0)) {
    if (use.button == 0 && !shift)
      camera_.orbit(use.dx, use.dy, height);
    else
      camera_.pan(use.dx, use.dy, height);
    at_first_view_ = false;
  }
  if (use.wheel != 0) {
    camera_.zoom(use.wheel);
    camera_.distance = std::clamp(camera_.distance, 0.5, 40.0);
    at_first_view_ = false;
  }
}

}  // namespace seesaw
