// Everything in front of the camera: objects, lights, a floor, a background.
//
//     Scene scene;
//     scene.meshes.push_back({.mesh = bunny, .material = {.color = surface::blue}});
//     scene.floor = floor_under(bounding_box(scene), Point<3>::UnitY());
//     const Image image = render(scene, frame(scene, {.aspect = 800. / 600}), {.width = 800, .height = 600});
//
// A Scene is plain data: copy it, change a color, render again.
//
// Before it: meshes, fields, markers, from whoever makes a picture. After it: render.h.
#pragma once

#include <vector>

#include "core/base/types.h"
#include "core/image/theme.h"
#include "core/mesh/triangle_mesh.h"
#include "core/raytrace/camera.h"
#include "core/raytrace/light.h"
#include "core/raytrace/material.h"
#include "core/raytrace/solid.h"

namespace seesaw {

/// Lines drawn along the edges of a mesh, the same width everywhere in the picture.
struct EdgeLines {
  double width = 0;  ///< pixels; 0 draws none
  Color color = surface::polygon_edge;
  /// Edges between faces whose normals differ by less than this many degrees are left out: the diagonals of
  /// squares, for instance.
  double least_angle = 0;
};

struct MeshObject {
  TriangleMesh mesh;
  Material material = {};
  /// Facets as they are, or smooth: by the mesh's normals, or where it has none, by angle-weighted ones.
  bool flat = false;
  EdgeLines edges = {};
};

/// Discs of one look, such as floaters: flat, seen from both sides.
struct DiscsObject {
  Points<3> centers = Points<3>(3, 0);  ///< 3 x N
  Points<3> normals = Points<3>(3, 0);  ///< 3 x N, of any length but zero
  Values radii = {};                    ///< N, scene units
  Material material = {};
};

/// Spheres of one look, such as constraint markers.
struct SpheresObject {
  Points<3> centers = Points<3>(3, 0);  ///< 3 x N
  Values radii = {};                    ///< N, scene units
  Material material = {};
};

/// A plane under the objects; what lies beyond `fade_end` has the background's color.
struct Floor {
  enum class Look {
    none,
    plain,    ///< of the background's color, so that only shadows (and reflections) show: a photographer's
              ///< studio
    checker,  ///< squares of two colors
  };
  Look look = Look::none;
  Point<3> point = {0, 0, 0};       ///< on the plane; where the fading is centered
  Point<3> up = Point<3>::UnitY();  ///< away from the floor, any length but zero
  double tile = 1;                  ///< side of a square, scene units
  double fade_begin = 1e30;         ///< distance from `point` where it begins to fade, scene units
  double fade_end = 2e30;
  Color light = surface::floor_light;
  Color dark = surface::floor_dark;
  double mirror = 0;
};

struct Scene {
  std::vector<MeshObject> meshes = {};
  std::vector<DiscsObject> discs = {};
  std::vector<SpheresObject> spheres = {};
  /// Fields, and what CSG makes of them; traced, not meshed.
  std::vector<Solid> solids = {};
  Floor floor = {};
  /// None for `studio_lights`.
  std::vector<Light> lights = {};
  Color background = theme::paper;
  /// Light from everywhere, dimmed where other surfaces are near.
  double ambient = 0.4;
};

/// The box around all objects, without the floor; empty for none. A solid counts by its
/// surface_points, or where these see nothing, by its own box.
Box<3> bounding_box(const Scene& scene);

/// The nearest camera that sees all of the scene's objects, centered: tighter than framing the box around
/// them. The scene must not be empty.
PinholeCamera frame(const Scene& scene, const Framing& framing = {});

/// A floor just below `subject`, faded out at a few of its sizes. `gap` lowers it, relative to the size.
Floor floor_under(const Box<3>& subject, const Point<3>& up, Floor::Look look = Floor::Look::plain,
                  double gap = 0);

// Markers as meshes, for `Scene::meshes`; `segments` is the number of sides.

/// A solid disc: its bottom's center, the direction of its axis (any length but zero), scene units.
TriangleMesh disc_mesh(const Point<3>& center, const Point<3>& normal, double radius, double thickness,
                       int segments = 48);
/// A closed cylinder between two different points.
TriangleMesh cylinder_mesh(const Point<3>& from, const Point<3>& to, double radius, int segments = 32);
/// A cone whose tip is `to`: with a cylinder below it, the arrow of a normal constraint.
TriangleMesh cone_mesh(const Point<3>& from, const Point<3>& to, double radius, int segments = 32);
/// A thin cylinder and a cone at its end: the papers' spike. `radius` is the cylinder's.
TriangleMesh spike_mesh(const Point<3>& from, const Point<3>& to, double radius, int segments = 32);
/// Both meshes as one, with their own normals (a mesh without gets flat ones).
TriangleMesh joined(const TriangleMesh& a, const TriangleMesh& b);

}  // namespace seesaw
