// A document: everything that one picture of Seesaw is made from, as plain data.
//
// Before it: a person in an editor, a figure's script, a model converter; or core/scene/document_json.h from
// a file. After it: core/rbf fits its constraints; the editors and figures draw what its display and camera
// ask for.
//
// A document is a value: copy it, compare it, keep a hundred for undo. It may hold constraints that no
// function can obey (two values at one place); that is found by the solver and shown by the editor. What it
// cannot hold in a file are the faults of core/scene/document_rules.h.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "core/base/types.h"
#include "core/rbf/constraints.h"
#include "core/rbf/kernel.h"

namespace seesaw {

/// A key that this program does not know, found in a file and kept for the program that does.
struct Extra {
  std::string key;
  /// Its value: one JSON value on one line.
  std::string json;
  bool operator==(const Extra&) const = default;
};
/// The unknown keys of one JSON object, in the order of the file.
using Extras = std::vector<Extra>;

/// A constraint and how a person wants to see it.
template <int Dim>
struct SceneConstraint {
  Constraint<Dim> constraint;
  /// Drawn red: the figures' way to say "new" or "moved".
  bool highlight = false;
  /// Its normal constraint alone drawn red.
  bool highlight_normal = false;
  /// Written beside it; empty for none.
  std::string label = {};
  Extras extras = {};
};

/// What a drawing shows besides the curve or surface.
template <int Dim>
struct Display {
  /// The part of the scene to show, in scene units; nothing lets the program choose.
  std::optional<Box<Dim>> view;
  Extras view_extras = {};
  /// The function's value as color.
  bool field = false;
  /// Curves of equal value.
  bool isolines = false;
  /// Arrows along grad f.
  bool gradient = false;
  bool constraints = true;
  bool normals = true;
  bool scale_bar = false;
  bool grid = false;
  /// Bit i: the file spelled out display_switches[i] although it has its default, so it is spelled out again.
  std::uint32_t spelled_out = 0;
  Extras extras = {};
};

template <int Dim>
struct DisplaySwitch {
  const char* key;
  bool Display<Dim>::*member;
};
/// The booleans of Display by the names they have in files.
template <int Dim>
inline constexpr DisplaySwitch<Dim> display_switches[] = {
    {"field", &Display<Dim>::field},       {"isolines", &Display<Dim>::isolines},
    {"gradient", &Display<Dim>::gradient}, {"constraints", &Display<Dim>::constraints},
    {"normals", &Display<Dim>::normals},   {"scale_bar", &Display<Dim>::scale_bar},
    {"grid", &Display<Dim>::grid},
};

/// Where a 3D scene is seen from, in scene units.
struct Camera {
  Point<3> position = {0, 0, 3};
  Point<3> target = {0, 0, 0};
  Point<3> up = Point<3>::UnitY();
  /// The full angle from the bottom of the picture to its top, in degrees.
  double field_of_view = 40.0;
  Extras extras = {};
};
/// A 2D document has no camera; its display's view box says what is seen.
struct NoCamera {
  bool operator==(const NoCamera&) const = default;
};

template <int Dim>
struct Document {
  Kernel kernel = papers_kernel(Dim);
  /// 0 interpolates; positive values let the function miss its constraints for a smoother shape.
  double smoothing = 0.0;
  std::vector<SceneConstraint<Dim>> constraints = {};

  std::string title = {};
  /// What the picture shows, for a caption.
  std::string description = {};
  /// The figure that this document reproduces, such as "turk2002-fig01"; empty for none.
  std::string figure = {};
  Display<Dim> display = {};
  std::conditional_t<Dim == 3, std::optional<Camera>, NoCamera> camera = {};
  Extras extras = {};
};

/// A document of a dimension that only its file knows.
using AnyDocument = std::variant<Document<2>, Document<3>>;

/// The constraints alone, in order, for the solver: index i here is index i there.
template <int Dim>
Constraints<Dim> constraints_of(const Document<Dim>& document) {
  Constraints<Dim> result;
  result.reserve(document.constraints.size());
  for (const SceneConstraint<Dim>& each : document.constraints) result.push_back(each.constraint);
  return result;
}

/// The positions of its boundary constraints, Dim x N.
template <int Dim>
Points<Dim> boundary_points(const Document<Dim>& document) {
  return boundary_points(constraints_of(document));
}

// Equal means equal in everything that a file holds, numbers as == has them (so -0.0 equals 0.0). For Dim 2
// and 3.

template <int Dim>
bool operator==(const SceneConstraint<Dim>& a, const SceneConstraint<Dim>& b);
template <int Dim>
bool operator==(const Display<Dim>& a, const Display<Dim>& b);
template <int Dim>
bool operator==(const Document<Dim>& a, const Document<Dim>& b);
bool operator==(const Camera& a, const Camera& b);

}  // namespace seesaw
