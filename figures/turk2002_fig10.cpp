// Turk & O'Brien 2002, Figure 10: two interpolating surfaces ray traced, with shadows and reflections; and
// what constructive solid geometry makes of them.
#include <cmath>

#include "core/base/random.h"
#include "core/implicit/boxed.h"
#include "core/raytrace/rigorous_tracer.h"
#include "figures/studio.h"
#include "figures/surface.h"

namespace seesaw {

namespace {

// An interpolating solid that can be traced: its constraints turned about the vertical and moved, then
// fitted.
struct TracedObject {
  std::shared_ptr<const Interpolant<3>> function;
  FitReport report;
  MeshReport mesh;  ///< of all that lies in the function's own box
  Solid solid;
};

TracedObject object_of(const Document<3>& document, const Point<3>& at, double degrees,
                       const Material& material) {
  Constraints<3> constraints = constraints_of(document);
  const Eigen::AngleAxisd turn(degrees * M_PI / 180, Point<3>::UnitY());
  for (Constraint<3>& each : constraints) each.at = turn * each.at + at;
  Fit<3> fitted = fit(constraints);
  const auto function = std::make_shared<const Interpolant<3>>(std::move(fitted.function));
  const MeshReport mesh =
      check_mesh(polygonize(*function, Points<3>(3, 0), {.cells = 100, .exhaustive = true}).mesh);
  // The cage is far away; rays need not look there.
  const auto near = share(Boxed<3>(function, grown(mesh.box, 0.02)));
  return {function, fitted.report, mesh, Solid(std::make_shared<RigorousTracer>(near), material)};
}

// What one object shows of another, counted over a grid of camera rays.
struct Sight {
  Index seen = 0;       // rays that meet the object
  Index reflected = 0;  // of them, how many are reflected onto the other
  Index shadowed = 0;   // of them, how many lie in the other's shadow
};

std::vector<SolidCrossings> trace(const Solid& solid, const std::vector<Ray>& rays) {
  std::vector<SolidCrossings> found(rays.size());
  solid.trace(rays, HowMany::first, found);
  return found;
}

Sight sight_of(const Solid& object, const Solid& other, const PinholeCamera& camera,
               const Point<3>& to_light) {
  constexpr int n = 96;
  std::vector<Ray> rays;
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) rays.push_back(ray_through(camera, (x + 0.5) / n, (y + 0.5) / n, 1));
  const auto hits = trace(object, rays), blocked = trace(other, rays);
  std::vector<Ray> mirrored, lit;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (hits[i].crossings.empty()) continue;
    const double t = hits[i].crossings[0].t;
    if (!blocked[i].crossings.empty() && blocked[i].crossings[0].t < t) continue;
    const Point<3> place = rays[i].at(t);
    const Point<3> normal = object.normals(0, place, std::vector<char>{0}).col(0);
    const Point<3> d = rays[i].direction;
    mirrored.push_back({place, d - 2 * d.dot(normal) * normal, 1e-6});
    if (normal.dot(to_light) > 0) lit.push_back({place, to_light.normalized(), 1e-6});
  }
  const auto count = [&](const std::vector<Ray>& from) {
    Index hit = 0;
    for (const SolidCrossings& each : trace(other, from)) hit += !each.crossings.empty();
    return hit;
  };
  return {static_cast<Index>(mirrored.size()), count(mirrored), count(lit)};
}

// Rays that miss a solid although a point on them is inside: cracks. Dense samples know nothing of Roth's
// intervals.
Index cracks_of(const Solid& solid, const Field<3>& field, const PinholeCamera& camera) {
  constexpr int n = 64, samples = 400;
  Index cracks = 0;
  std::vector<Ray> rays;
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) rays.push_back(ray_through(camera, (x + 0.5) / n, (y + 0.5) / n, 1));
  const auto hits = trace(solid, rays);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (!hits[i].crossings.empty()) continue;
    const Ray inside = within(rays[i], solid.box());
    if (inside.end < inside.begin) continue;
    Points<3> points(3, samples);
    for (int k = 0; k < samples; ++k)
      points.col(k) = rays[i].at(inside.begin + (inside.end - inside.begin) * (k + 0.5) / samples);
    cracks += (field.values(points).array() > 0).any();
  }
  return cracks;
}

// Random points for which the traced solid and the boolean of the functions disagree.
Index disagreements(const Solid& solid, const Field<3>& field, const Box<3>& box, Random& random) {
  const Points<3> points = random.points_in<3>(box, 10'000);
  const std::vector<bool> inside = solid.contains(points);
  const Values values = field.values(points);
  Index wrong = 0;
  for (Index i = 0; i < points.cols(); ++i) wrong += inside[static_cast<std::size_t>(i)] != (values[i] >= 0);
  return wrong;
}

}  // namespace

Figure turk2002_fig10(const FigureContext& context) {
  Figure figure{
      .id = "turk2002-fig10",
      .paper = "Turk & O\u2019Brien 2002, Figure 10 (Figure 7 of the 1999 report)",
      .title = "Ray traced interpolating surfaces",
      .shows =
          "Ray tracing of interpolating implicit surfaces. The left image shows reflection and shadows "
          "of two implicit surfaces, and the right image illustrates constructive solid geometry: "
          "intersection and subtraction, from left to right."};
  const Document<3> cushion = scene_named(context, "turk2002-fig10-cushion");
  const Document<3> bone = scene_named(context, "turk2002-fig10-bone");
  Material blue{.color = surface::blue, .highlight = 0.35, .gloss = 90, .mirror = 0.22};
  Material sand{.color = surface::sand, .highlight = 0.35, .gloss = 90, .mirror = 0.22};
  const std::vector<Light> lights = {
      {.at = {-0.55, 1.0, 0.55}, .intensity = 0.72, .softness = 2.5},
      {.at = {0.9, 0.5, 0.6}, .intensity = 0.22, .shadows = false},
  };

  // Left: beside each other on a floor.
  {
    const TracedObject a = object_of(cushion, {-0.85, 0, 0.1}, 0, blue),
                       b = object_of(bone, {1.05, 0.1, -0.35}, 0, sand);
    Scene scene;
    scene.solids = {a.solid, b.solid};
    scene.lights = lights;
    scene.floor = floor_under(bounding_box(scene), Point<3>::UnitY(), Floor::Look::checker);
    scene.floor.tile = 0.7;
    scene.floor.mirror = 0.12;
    const PinholeCamera camera = frame(scene, {.direction = {0.25, 0.5, 1}, .margin = 0.08});
    Panel panel =
        studio_panel(context, "left", "shadows and reflections", scene,
                     {.camera = camera, .width = 420, .height = 420, .samples = 6, .ambient_rays = 1});
    Facts& facts = panel.facts;
    facts["cushion"] = fit_facts(a.report);
    facts["bone"] = fit_facts(b.report);
    const Sight on_a = sight_of(a.solid, b.solid, camera, lights[0].at);
    const Sight on_b = sight_of(b.solid, a.solid, camera, lights[0].at);
    const auto share = [](Index part, Index whole) {
      return static_cast<double>(part) / static_cast<double>(std::max<Index>(whole, 1));
    };
    facts["bone_seen_in_cushion"] = share(on_a.reflected, on_a.seen);
    facts["cushion_seen_in_bone"] = share(on_b.reflected, on_b.seen);
    facts["bone_in_the_cushions_shadow"] = share(on_b.shadowed, on_b.seen);
    for (const auto& [name, object] : {std::pair("cushion", &a), std::pair("bone", &b)}) {
      figure.checks.push_back(residual_check(name, object->report));
      // Nothing hides within, and nothing floats about.
      check_topology(figure, name, object->mesh, 1, 0);
    }
    figure.checks.push_back(
        at_least("left: part of the cushion that mirrors the bone", share(on_a.reflected, on_a.seen), 0.02));
    figure.checks.push_back(
        at_least("left: part of the bone that mirrors the cushion", share(on_b.reflected, on_b.seen), 0.02));
    figure.checks.push_back(at_least("left: part of the bone in the cushion\u2019s shadow",
                                     share(on_b.shadowed, on_b.seen), 0.01));
    figure.panels.push_back(std::move(panel));
  }

  // Right: the same two, one within the other; intersection, then subtraction.
  {
    const Point<3> places[] = {{-1.2, 0, 0}, {1.25, 0, 0}};
    Scene scene;
    scene.lights = lights;
    std::vector<TracedObject> objects;
    for (const Point<3>& at : places) {
      objects.push_back(object_of(cushion, at, 0, blue));
      objects.push_back(object_of(bone, at, -30, sand));
    }
    scene.solids = {objects[0].solid & objects[1].solid, objects[2].solid - objects[3].solid};
    const Intersection<3> both({objects[0].function, objects[1].function});
    const Difference<3> cut(objects[2].function, objects[3].function);
    scene.floor = floor_under(bounding_box(scene), Point<3>::UnitY(), Floor::Look::checker);
    scene.floor.tile = 0.7;
    scene.floor.mirror = 0.12;
    const PinholeCamera camera = frame(scene, {.direction = {0.3, 0.5, 1}, .margin = 0.08});
    Panel panel =
        studio_panel(context, "right", "intersection, and subtraction", scene,
                     {.camera = camera, .width = 420, .height = 420, .samples = 6, .ambient_rays = 1});
    Random random(10);
    const Index wrong[] = {disagreements(scene.solids[0], both, scene.solids[0].box(), random),
                           disagreements(scene.solids[1], cut, scene.solids[1].box(), random)};
    const Index cracks[] = {cracks_of(scene.solids[0], both, camera),
                            cracks_of(scene.solids[1], cut, camera)};
    const char* const names[] = {"intersection", "subtraction"};
    for (int i = 0; i < 2; ++i) {
      const std::string name = names[i];
      panel.facts[name + "_points_that_disagree"] = wrong[i];
      panel.facts[name + "_rays_through_cracks"] = cracks[i];
      figure.checks.push_back(equal(name + ": of 10,000 points, in or out otherwise than the functions say",
                                    static_cast<double>(wrong[i]), 0));
      figure.checks.push_back(
          equal(name + ": of 4,096 rays, through a crack", static_cast<double>(cracks[i]), 0));
    }
    figure.panels.push_back(std::move(panel));
  }
  figure.caption =
      "Left: a cushion and a bone, each of 14 boundary constraints and an interior one or two, in a cage of "
      "8 exterior ones; a soft "
      "shadow falls on the floor and on the bone, and each mirrors the other. Right: the same two, the "
      "bone within the cushion: what both share, and the cushion without the bone, by Roth\u2019s "
      "intervals along each ray. Sphere tracing with proven bounds on the gradient.";
  return figure;
}

}  // namespace seesaw
