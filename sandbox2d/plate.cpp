#include "sandbox2d/plate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>

#include "core/image/theme.h"

namespace seesaw {

namespace {

constexpr double plate_radians = std::numbers::pi / 180;
constexpr double first_azimuth = -62 * plate_radians, first_elevation = 32 * plate_radians;
constexpr double rescale_beyond = 3;
constexpr double through_all = 5;  // a lift that nothing hides
constexpr std::size_t boundary_head = 0, value_head = 1, normal_head = 2;

Points<3> sheet_corners(const PlateSpace& space, const Box<2>& box) {
  Points<3> corners(3, 4);
  Index k = 0;
  for (const auto corner : {Box<2>::BottomLeft, Box<2>::BottomRight, Box<2>::TopRight, Box<2>::TopLeft})
    corners.col(k++) = space.at(box.corner(corner), 0);
  return corners;
}

Points<3> plate_columns(const std::vector<Point<3>>& points) {
  Points<3> result(3, static_cast<Index>(points.size()));
  for (std::size_t k = 0; k < points.size(); ++k) result.col(static_cast<Index>(k)) = points[k];
  return result;
}

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
  for (Drawable* each : {&surface_, &grid_, &zero_, &profile_, &curtain_above_, &curtain_below_, &stems_,
                         &dashes_, &heads_[0], &heads_[1], &heads_[2], &cores_})
    *each = Drawable();
  poles_.clear();
  ++content_;
}

void Plate::build_plate(const Field<2>& field, const Document<2>& document, int cells) {
  const double present = typical_height(field, document, seen_);
  const bool choose =
      height_ == 0 || present > rescale_beyond * height_ || present < height_ / rescale_beyond;
  if (choose) height_ = present;
  mesh_ =
      make_plate(field, seen_, {.cells = cells, .lines_every = std::max(1, cells / 12), .height = height_});
  poles_ = plate_poles(document, mesh_.space, seen_);
  const Points<3> sheet = sheet_corners(mesh_.space, seen_);
  const Index every = std::max<Index>(1, mesh_.mesh.vertices.cols() / 500);
  present_.assign(sheet.colwise().begin(), sheet.colwise().end());
  for (Index k = 0; k < mesh_.mesh.vertices.cols(); k += every)
    present_.push_back(mesh_.mesh.vertices.col(k));
  for (const PlatePole& pole : poles_) present_.push_back(pole.head);
  if (choose) framed_ = present_;
  surface_.set_triangles(mesh_.mesh, mesh_.colors);
  grid_.set_segments(mesh_.grid, mesh_.grid_colors);
  zero_.set_segments(mesh_.zero);
  build_plane();
  build_poles();
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

// Where the plate was seen whole when its scale was chosen; what has been pulled beyond that picture moves
// the eye farther away.
void Plate::frame(int width, int height) {
  if (framed_.empty()) return;
  frame_all(width, height);
  const Box<2> picture(Point<2>(0, 0), Point<2>(width, height));
  const auto beyond = [&](const Point<3>& p) {
    return !picture.contains(camera_.pixel_of(p, width, height).head<2>());
  };
  const std::size_t before = framed_.size();
  std::ranges::copy_if(present_, std::back_inserter(framed_), beyond);
  if (framed_.size() > before) frame_all(width, height);
}

// The nearest stand from which that is seen.
void Plate::frame_all(int width, int height) {
  camera_.target = Point<3>::Zero();
  const double up = std::tan(camera_.field / 2) * 0.94, aside = up * width / height;
  for (int round = 0; round < 5; ++round) {
    double distance = 0.1;
    for (const Point<3>& each : framed_) {
      const Point<3> p = each - camera_.target;
      distance = std::max(
          distance, std::max(std::abs(p.dot(camera_.right())) / aside, std::abs(p.dot(camera_.up())) / up) -
                        p.dot(camera_.forward()));
    }
    camera_.distance = distance;
    Box<2> place;
    for (const Point<3>& each : framed_) place.extend(camera_.pixel_of(each, width, height).head<2>());
    camera_.pan(width / 2.0 - place.center().x(), height / 2.0 - place.center().y(), height);
  }
}

const Texture& Plate::draw(int width, int height, const UiColors& colors, double pixel_ratio) {
  width = std::max(width, 1);
  height = std::max(height, 1);
  if (at_first_view_ && !seen_.isEmpty()) frame(width, height);
  const Drawn now{content_,         width,           height,
                  pixel_ratio,      camera_.azimuth, camera_.elevation,
                  camera_.distance, camera_.target,  colors.background,
                  colors.ink};
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

void Plate::build_poles() {
  std::vector<Point<3>> stems, dashes;
  std::vector<Color> stem_colors, dash_colors;
  std::array<std::vector<Point<3>>, 3> at;
  std::array<std::vector<Color>, 3> colors;
  for (const PlatePole& pole : poles_) {
    const Color color = pole.highlight ? theme::moved : theme::constraint;
    const std::size_t kind = pole.open ? boundary_head : pole.small ? normal_head : value_head;
    at[kind].push_back(pole.head);
    colors[kind].push_back(color);
    if (pole.open) continue;
    stems.insert(stems.end(), {pole.foot, pole.head});
    stem_colors.insert(stem_colors.end(), 2, color);
    const Point<3> run = pole.head - pole.foot;
    const int pieces = static_cast<int>(std::min(run.norm() / 0.016, 400.0)) | 1;
    for (int k = 0; k < pieces; k += 2) {
      for (const int end : {k, k + 1}) dashes.push_back(pole.foot + static_cast<double>(end) / pieces * run);
      dash_colors.insert(dash_colors.end(), 2, color);
    }
  }
  stems_.set_segments(plate_columns(stems), stem_colors);
  dashes_.set_segments(plate_columns(dashes), dash_colors);
  for (std::size_t kind = 0; kind < 3; ++kind) heads_[kind].set_points(plate_columns(at[kind]), colors[kind]);
  cores_.set_points(plate_columns(at[boundary_head]));
}

// Lines that cross keep an order by their lifts: the curve lies over the grid, the profile over the curve.
void Plate::draw_into(View3D& view, int width, int height, const UiColors& colors, double pixel_ratio) {
  view.begin(width, height, camera_, colors.background);
  view.draw(surface_);
  view.draw(grid_, {.size = 0.8 * pixel_ratio, .lift = 0.003});
  view.draw(zero_, {.color = theme::curve, .size = 2.6 * pixel_ratio, .lift = 0.006});
  view.draw(profile_, {.color = theme::moved, .size = 2.4 * pixel_ratio, .lift = 0.008});
  // What the plate hides of the poles is seen through it, faintly.
  view.draw(dashes_, {.opacity = 0.5, .size = 1.2 * pixel_ratio, .lift = through_all});
  draw_heads(view, pixel_ratio, true);
  view.draw(stems_, {.size = 1.8 * pixel_ratio, .lift = 0.002});
  draw_heads(view, pixel_ratio, false);
  // Translucent things from far to near: what is on the other side of the zero plane comes before it.
  const bool from_above = camera_.eye().z() >= 0;
  const DrawLook curtain{.color = theme::moved, .opacity = 0.2, .lit = false};
  view.draw(from_above ? curtain_below_ : curtain_above_, curtain);
  view.draw(plane_, {.color = mix(hex("#F4F6F9"), colors.background, 0.3), .opacity = 0.42, .lit = false});
  view.draw(rim_, {.color = colors.soft_ink, .size = pixel_ratio, .lift = 0.002});
  view.draw(from_above ? curtain_above_ : curtain_below_, curtain);
}

void Plate::draw_heads(View3D& view, double pixel_ratio, bool hidden) {
  // Hundreds would merge into a rope.
  const double head =
      pixel_ratio * std::clamp(std::sqrt(80.0 / static_cast<double>(poles_.size() + 1)), 0.35, 1.0);
  // Half of a head lies in the plate; lifted by about its radius it is seen whole.
  const double lift = hidden ? through_all : 0.02, opacity = hidden ? 0.22 : 1;
  view.draw(heads_[value_head], {.opacity = opacity, .size = 9 * head, .lift = lift});
  view.draw(heads_[normal_head], {.opacity = opacity, .size = 5 * head, .lift = lift});
  view.draw(heads_[boundary_head], {.opacity = opacity, .size = 9 * head, .lit = false, .lift = lift});
  if (hidden) return;
  view.draw(cores_, {.color = theme::paper, .size = 5 * head, .lit = false, .lift = lift});
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
