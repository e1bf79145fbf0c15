// From a model of any size to a fitted surface in one call: what `seesaw fit` does.
//
// Before it: a mesh or a cloud as core/mesh/mesh_file.h reads it, with holes, crowds and doubtful normals.
// After it: constraints for a document, the function, and a report of everything that was decided.
//
// Small models are taken whole. Of large ones a choice is made: the points farthest from each other
// (point_sampling.h) with the normals of the full model, or a simplified mesh (core/mesh/simplify.h); with a
// tolerance, centers are added until it is met (adaptive_fit.h). Whichever, the error is measured at every
// point of the model. Measured on the bunny, 34,835 vertices, of which 1,200 were chosen: rms error 0.0020 of
// its size by farthest points, 0.0036 by simplification, which saves vertices where polygons can be large and
// a smooth surface then bulges.
//
// Across the holes of an open model a smooth function goes on as it left: the surface balloons, or never
// closes. So open models get a cage: 26 exterior constraints on a box around, which ask for minus their
// distance from the model, in offsets. Measured: a terrain, one open sheet, becomes a closed slab, a bunny
// cut off at the bottom loses most of its balloon, and where there is data the error does not change.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/modelling/adaptive_fit.h"

namespace seesaw {

struct FitModelOptions {
  /// Boundary constraints: exactly so many, if the model has them and no tolerance is given; with one, to
  /// begin with. None: all up to `whole`, of larger models `usual`.
  std::optional<Index> vertices = std::nullopt;
  /// As AdaptiveFitOptions'. None: no centers are added.
  std::optional<double> tolerance = std::nullopt;
  /// Simplify meshes instead of sampling them. No meaning with a tolerance.
  bool simplify = false;
  /// With a tolerance, no more than this.
  Index most = 3000;
  ModelConstraintOptions constraints = {};
  std::optional<Kernel> kernel = std::nullopt;
  /// Turn the normals of a cloud or of an open mesh that lead in.
  bool turn_normals = true;
  /// Leave out a cloud's strays, and normals that their neighbors contradict (clean_cloud.h).
  bool clean = true;
  /// Put a cage around a cloud or an open mesh, unless its normals lead in.
  bool cage = true;

  static constexpr Index whole = 1500, usual = 1200;
};

/// How the vertices were chosen.
enum class Choice { all, simplified, farthest, adaptive };

struct FittedModel {
  ModelConstraints made;
  Fit<3> fitted;
  Choice choice = Choice::all;
  /// Over all points of the model, as fractions of its longest side.
  double max_error = 0, rms_error = 0;
  Index points = 0;        ///< of the model: where the error was measured
  Index strays = 0;        ///< points of a cloud left out because they stand apart from all others
  Index contradicted = 0;  ///< normals of a cloud left out because its neighbors look the other way
  bool turned = false;     ///< the normals led in, and were turned
  Index left_out = 0;      ///< constraints that were left out because the solver could not tell them apart
  Index cage = 0;          ///< exterior constraints around, the last of `made.constraints`
  bool open = false;       ///< the mesh has holes, or is a cloud
  bool met = true;         ///< the tolerance, if there was one
  std::vector<AdaptiveStep> history = {};  ///< of adaptive fitting
  std::string trouble = {};                ///< why a mesh was sampled instead of simplified; empty if not
};

/// Throws Error where nothing can be fitted: no faces, no points, no usable normals at all; ConstraintError;
/// Cancelled.
FittedModel fit_model(const TriangleMesh& mesh, const FitModelOptions& options = {},
                      const Progress& progress = {});
FittedModel fit_model(const PointCloud& cloud, const FitModelOptions& options = {},
                      const Progress& progress = {});

/// How much the normals lead out, from -1 (all straight to the middle) to 1: the average of (x - middle) . n
/// / |x - middle|, weighted by area where there are faces.
double outwardness(const TriangleMesh& mesh);
double outwardness(const PointCloud& cloud);

}  // namespace seesaw
