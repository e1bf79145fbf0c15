// A sculpture of blobby cylinders: a shape, and the drags that made another of it. The program of Witkin &
// Heckbert 1994, without its window.
//
// Before it: a file, or a mouse.  After it: figures, and the 3D sandbox.
//
//     {
//       "seesaw_sculpture": 1,
//       "title": "Three limbs",
//       "threshold": 0.5,
//       "cylinders": [{"from": [-0.4, 0, 0], "to": [0.4, 0, 0], "deviation": 0.3}, ...],
//       "frozen": ["bias", "s0"],
//       "desired_radius": 0.08,
//       "drags": [{"grab": [0.5, 0, 0], "to": [1.2, 0.3, 0]}, ...]
//     }
//
// A drag takes hold of the control point nearest to `grab`, or where none is within two desired radii, of a
// new one where the surface is nearest to it. Its cursor then goes straight to `to` at an even speed, and the
// point follows by the cursor spring (section 5); all others stay where they are. Every step is the paper's
// differential step (core/particles/differential_step.h), so that floaters follow all the way.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/implicit/parametric_shapes.h"
#include "core/particles/differential_step.h"

namespace seesaw {

struct Drag {
  Point<3> grab = Point<3>::Zero();  ///< near the surface, scene units
  Point<3> to = Point<3>::Zero();    ///< where the cursor goes, scene units
};

struct Sculpture {
  std::string title = {};
  double threshold = 0.5;
  Points<3> starts = Points<3>(3, 0), ends = Points<3>(3, 0);  ///< of the cylinders, 3 x K
  Values deviations = {};                                      ///< K, > 0
  std::vector<std::string> frozen = {};                        ///< names of parametric_shapes.h
  double desired_radius = 0.08;                                ///< of the floaters, scene units, > 0
  std::vector<Drag> drags = {};
};

/// Throws FileError with line and path of what is wrong. `name` is what errors call the text.
Sculpture parse_sculpture(std::string_view text, const std::string& name = "sculpture");
Sculpture read_sculpture(const std::filesystem::path& path);

/// What became of a drag.
struct DragReport {
  Index point = -1;         ///< the control point
  bool is_new = false;      ///< it was made for the drag
  int steps = 0;            ///< differential steps
  double miss = 0;          ///< how far the point ended from the cursor, scene units
  double most_off = 0;      ///< max |f| / |grad f| of the control points on the way, scene units
  Index least_squares = 0;  ///< steps in which the points could not all be followed by Cholesky
  Index waited = 0;         ///< steps in which the points stood still, since the surface could not follow
};

class Sculptor {
 public:
  explicit Sculptor(const Sculpture& sculpture, const ControlOptions& options = {});

  /// Does it, until the point is within a thousandth of a desired radius of the cursor that has arrived, or
  /// for `most_steps`. Throws Error where the surface cannot be met near `drag.grab`, Cancelled.
  DragReport drag(const Drag& drag, int most_steps = 600, const Progress& progress = {});

  const ParametricBlobbyCylinders<3>& surface() const { return surface_; }
  const ControlPoints<3>& points() const { return points_; }
  const Floaters& floaters() const { return floaters_; }
  /// Steps with nobody dragging until the floaters are at rest.
  void rest() { floaters_.equilibrate(surface_); }

 private:
  Index grab(const Point<3>& at, bool& is_new);

  ParametricBlobbyCylinders<3> surface_;
  ControlOptions options_;
  ControlPoints<3> points_;
  double desired_radius_;
  Floaters floaters_;
};

}  // namespace seesaw
