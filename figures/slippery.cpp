// W&H 1994, conclusions ("implicit surfaces are slippery"), beside T&O 2002, section 5: the same drag on a
// blobby model under control points and on an interpolating surface through the same points.
#include <numbers>

#include "core/implicit/parametric_shapes.h"
#include "core/particles/differential_step.h"
#include "core/polygonize/polygonize.h"
#include "core/rbf/fit.h"
#include "figures/facts.h"
#include "figures/floater_scene.h"
#include "figures/studio.h"

namespace seesaw {

namespace {

// Points of the blobby surface in twelve directions from its middle, by bisection.
Points<3> points_on(const Field<3>& field) {
  Points<3> points(3, 12);
  constexpr double golden = 2.399963229728653;
  for (Index i = 0; i < points.cols(); ++i) {
    const double z = 1 - (2 * static_cast<double>(i) + 1) / 12.0, r = std::sqrt(1 - z * z);
    const Point<3> direction(r * std::cos(golden * static_cast<double>(i)), z,
                             r * std::sin(golden * static_cast<double>(i)));
    double inside = 0, outside = 4;
    for (int step = 0; step < 60; ++step) {
      const double middle = 0.5 * (inside + outside);
      (field.value(middle * direction) >= 0 ? inside : outside) = middle;
    }
    points.col(i) = inside * direction;
  }
  return points;
}

// How far each point is from the surface: by Newton's way along the gradient, which is right for points that
// are near it, and an upper bound otherwise.
Values distances_to(const Field<3>& field, const Points<3>& points) {
  Values result(points.cols());
  for (Index i = 0; i < points.cols(); ++i) {
    const Point<3> start = points.col(i);
    Point<3> at = start;
    for (int step = 0; step < 50; ++step) {
      const Point<3> gradient = field.gradient(at);
      if (!(gradient.squaredNorm() > 0)) break;
      at -= std::clamp(field.value(at) / gradient.squaredNorm(), -0.2 / gradient.norm(),
                       0.2 / gradient.norm()) *
            gradient;
    }
    result[i] = (at - start).norm();
  }
  return result;
}

struct DragOutcome {
  double grabbed = 0;    // from the cursor to the surface
  double held = 0;       // the farthest of the other held points from the surface
  double turned = 0;     // the surface's normal at the grabbed point, degrees
  Index unfollowed = 0;  // steps in which not all points could be followed
};

}  // namespace

Figure slippery_figure(const FigureContext& context) {
  Figure figure{
      .id = "slippery",
      .paper = "Companion to Witkin & Heckbert 1994, section 5, and Turk & O\u2019Brien 2002, section 5",
      .title = "Implicit surfaces are slippery; interpolating ones less so",
      .shows =
          "We have discovered that implicit surfaces are slippery: when you attempt to move them using "
          "control points they often slip out of your grasp."};
  Points<3> centers(3, 3);
  centers << -0.55, 0.55, 0.0, -0.1, -0.1, 0.45, 0.0, 0.05, -0.05;
  const BlobbySpheres<3> blobs(0.4, centers, Values::Constant(3, 0.75));
  const Points<3> held = points_on(blobs);
  Index grabbed = 0;
  held.row(0).maxCoeff(&grabbed);
  const Point<3> from = held.col(grabbed), cursor = from + Point<3>(0.75, 0.35, 0);

  // Control points on the blobby model: all are held, one is dragged.
  ParametricBlobbySpheres<3> surface(blobs);
  ControlPoints<3> points;
  for (Index i = 0; i < held.cols(); ++i) points.add(held.col(i));
  Floaters floaters(surface, {.desired_radius = 0.1, .diameter = 1.2, .seed = 2});
  floaters.equilibrate(surface);
  const Floaters at_first = floaters;
  DragOutcome blobby;
  constexpr int steps = 250;
  for (int step = 0; step < steps; ++step) {
    report(context.progress, step / double{steps});
    const double gone = std::min(1.0, step / 150.0);
    points.velocities.setZero();
    points.velocities.col(grabbed) =
        spring_velocity<3>(points.positions.col(grabbed), from + gone * (cursor - from));
    const SurfaceMotion motion = differential_step(surface, points, floaters).motion;
    blobby.unfollowed += motion.method != ControlMethod::cholesky;
  }
  // The interpolating surface through the same points, and one of them moved: section 5 of T&O.
  Constraints<3> constraints;
  for (Index i = 0; i < held.cols(); ++i) {
    const Point<3> outward = -blobs.gradient(held.col(i));
    constraints.push_back(boundary<3>(held.col(i), outward, 0.05, 1));
  }
  const Interpolant<3> before = fit(constraints).function;
  Constraints<3> moved = constraints;
  moved[static_cast<std::size_t>(grabbed)].at = cursor;
  const Interpolant<3> after = fit(moved).function;

  Points<3> others(3, held.cols() - 1);
  for (Index i = 0, k = 0; i < held.cols(); ++i)
    if (i != grabbed) others.col(k++) = held.col(i);
  blobby.grabbed = distances_to(surface, cursor)[0];
  blobby.held = distances_to(surface, others).maxCoeff();
  DragOutcome interpolating;
  interpolating.grabbed = distances_to(after, cursor)[0];
  interpolating.held = distances_to(after, others).maxCoeff();

  // Untouched points: floaters of the start on the half away from the grabbed point.
  const auto untouched = [&](const Floaters& start) {
    std::vector<Index> which;
    for (Index i = 0; i < start.size(); ++i)
      if (start.positions()(0, i) < 0) which.push_back(i);
    return Points<3>(start.positions()(Eigen::all, which));
  };
  Floaters smooth(before, held, {.desired_radius = 0.1, .diameter = 1.2, .seed = 2});
  smooth.equilibrate(before);
  const Values blobby_wander = distances_to(surface, untouched(at_first)),
               smooth_wander = distances_to(after, untouched(smooth));

  const auto degrees = [](const Point<3>& a, const Point<3>& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi;
  };
  blobby.turned = degrees(blobs.gradient(from), surface.gradient(cursor));
  interpolating.turned = degrees(before.gradient(from), after.gradient(cursor));

  std::optional<PinholeCamera> camera;
  const auto take = [&](const std::string& name, const std::string& title, const Field<3>& field,
                        const Floaters& its, const Points<3>& red) {
    if (!camera)
      camera = frame(Box<3>(Point<3>(-1.45, -1.05, -0.9), Point<3>(2.0, 1.3, 0.9)),
                     {.direction = {0.15, 0.25, 1}, .aspect = 1.25});
    Scene scene;
    scene.discs.push_back(facing(floater_discs(its), camera->eye));
    add_discs(scene, field, red, 0.07, camera->eye);
    SpheresObject ball = markers(cursor, 0.07, surface::orange);
    scene.spheres.push_back(ball);
    figure.panels.push_back(
        studio_panel(context, name, title, scene, {.camera = *camera, .width = 380, .height = 304}));
  };
  floaters.equilibrate(surface);
  Floaters dragged(after,
                   [&] {
                     Points<3> seeds = held;
                     seeds.col(grabbed) = cursor;
                     return seeds;
                   }(),
                   {.desired_radius = 0.1, .diameter = 1.2, .seed = 2});
  dragged.equilibrate(after);
  Points<3> red = held;
  red.col(grabbed) = cursor;
  take("blobby-before", "blobby spheres, 12 control points", blobs, at_first, held);
  take("blobby-after", "one control point dragged", surface, floaters, points.positions);
  take("interpolating-before", "interpolating surface, the same 12 points", before, smooth, held);
  take("interpolating-after", "one boundary constraint dragged", after, dragged, red);
  figure.columns = 2;
  for (const auto& [panel, outcome, wander] :
       {std::tuple{1, blobby, blobby_wander}, std::tuple{3, interpolating, smooth_wander}}) {
    Facts& facts = figure.panels[static_cast<std::size_t>(panel)].facts;
    facts["cursor_from_the_surface"] = outcome.grabbed;
    facts["held_points_from_the_surface_at_most"] = outcome.held;
    facts["normal_at_the_grabbed_point_turned_degrees"] = outcome.turned;
    facts["untouched_half_wandered_rms"] =
        std::sqrt(wander.squaredNorm() / static_cast<double>(wander.size()));
    facts["untouched_half_wandered_at_most"] = wander.maxCoeff();
  }
  figure.panels[1].facts["steps_not_followed_by_cholesky"] = blobby.unfollowed;
  figure.panels[1].facts["parameters"] = surface.parameters();
  const auto rms = [](const Values& v) { return std::sqrt(v.squaredNorm() / static_cast<double>(v.size())); };
  figure.checks.push_back(at_most("interpolating: the cursor from the surface", interpolating.grabbed, 1e-8));
  figure.checks.push_back(at_most("interpolating: held points from the surface", interpolating.held, 1e-8));
  figure.checks.push_back(at_least("untouched half: blobby over interpolating, rms distance wandered",
                                   rms(blobby_wander) / rms(smooth_wander), 1.5));
  figure.caption =
      "Of twelve points eleven are held and one is dragged to the cursor (orange). Both surfaces meet it. "
      "But the blobby "
      "model, " +
      std::to_string(surface.parameters()) +
      " parameters for 12 control points, has slid about under it: its normal there has turned by " +
      in_words(blobby.turned, 2) + " degrees (" + in_words(interpolating.turned, 2) +
      " for the interpolating surface), and the half that nobody touched has wandered by " +
      in_words(rms(blobby_wander), 2) + " against " + in_words(rms(smooth_wander), 2) + " (rms).";
  return figure;
}

}  // namespace seesaw
