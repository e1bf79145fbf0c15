// The see-saw view: the function as a plate that one orbits, in a panel beside its curve.
//
//     plate.show(field, document, seen, profile, 64, version);     each frame; does nothing where nothing
//     changed const Texture& picture = plate.draw(width_px, height_px, ui::colors());
//     plate.use(ui::picture("Plate", picture, width, height), shift_held);
//     if (!plate.settled()) window.stay_awake();
//
// The plate's height follows the values and not the picture's frame: pulling a constraint from 1 to 2 lifts
// the plate to twice its height, and what lies beyond the boundary constraints goes down. So the vertical
// scale is chosen once and kept; anew only when the part of the scene that is seen has another size, when
// rescale() asks for it (a new document, "fit"), and when what is to be shown has become three times as high
// as it was chosen for, or a third. What is pulled beyond the picture before that is seen from farther away.
//
// While something moves edges are drawn rough, and once more smooth when all is at rest: without a graphics
// card smooth edges cost several times as much. settled() says whether that is still to come.
//
// Before it: plate_mesh.h, plate_parts.h.  After it: the panel that shows it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/window/ui.h"
#include "core/window/view_3d.h"
#include "sandbox2d/plate_parts.h"

namespace seesaw {

class Plate {
 public:
  /// A Window must exist, now and when it goes.
  Plate();

  /// What is to be seen. `version` stands for field and document: the same number, the same content. `cells`
  /// along the longest side of `seen`, which has width and height. Throws Error where it has not.
  void show(const Field<2>& field, const Document<2>& document, const Box<2>& seen,
            const std::optional<ProfileLine>& profile, int cells, std::uint64_t version);
  /// There is no function: the zero plane alone.
  void clear();
  /// The next show() chooses the vertical scale anew.
  void rescale() { height_ = 0; }

  /// The picture, of so many real pixels, at least 1 each; drawn only where something changed. `pixel_ratio`
  /// times the widths of lines are real pixels: Window::pixel_ratio() times ui::scale().
  const Texture& draw(int width, int height, const UiColors& colors, double pixel_ratio = 1);
  /// Whether another draw() would give a smoother picture.
  bool settled() const { return settled_; }
  /// The picture as draw() left it.
  Image image() const;

  /// The left button orbits; the right or middle one, or any with shift, pans; the wheel comes nearer; a
  /// double click goes back to the first view.
  void use(const ui::PictureUse& use, bool shift = false);
  /// Back to the first view.
  void reset_view();

  const OrbitCamera& camera() const { return camera_; }
  /// The value of f that the vertical scale was chosen for.
  double height() const { return height_; }
  /// What is shown.
  const PlateMesh& mesh() const { return mesh_; }

 private:
  void build_plate(const Field<2>& field, const Document<2>& document, int cells);
  void build_profile(const Field<2>& field);
  void build_plane();
  void build_poles();
  void frame(int width, int height);
  void frame_all(int width, int height);
  void draw_into(View3D& view, int width, int height, const UiColors& colors, double pixel_ratio);
  void draw_heads(View3D& view, double pixel_ratio, bool hidden);

  View3D rough_, smooth_;
  const Texture* picture_ = nullptr;
  bool picture_is_smooth_ = false;

  OrbitCamera camera_;
  bool at_first_view_ = true;
  std::vector<Point<3>> present_;  // points all over the plate
  std::vector<Point<3>> framed_;   // what the first view shows: those when its scale was chosen, and later

  Box<2> seen_;
  std::optional<ProfileLine> line_;
  int cells_ = 0;
  std::optional<std::uint64_t> version_;
  double height_ = 0;  // 0: to be chosen
  PlateMesh mesh_;
  std::vector<PlatePole> poles_;
  Drawable surface_, grid_, zero_, plane_, rim_;
  Drawable stems_, dashes_, cores_;
  std::array<Drawable, 3> heads_;  // boundary, value, normal
  Drawable profile_, curtain_above_, curtain_below_;

  // What the picture was drawn for.
  struct Drawn {
    std::uint64_t content = 0;
    int width = 0, height = 0;
    double pixel_ratio = 1, azimuth = 0, elevation = 0, distance = 0;
    Point<3> target = Point<3>::Zero();
    Color background, ink;
    bool operator==(const Drawn&) const = default;
  };
  Drawn drawn_;
  std::uint64_t content_ = 1;
  bool settled_ = false;
};

}  // namespace seesaw
