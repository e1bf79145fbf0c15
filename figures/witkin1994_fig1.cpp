// W&H 1994, Fig. 1: a blobby cylinder is stretched so fast that simple repulsion leaves the floaters behind;
// then adaptive repulsion and fission are switched on.
#include "core/implicit/parametric_shapes.h"
#include "core/particles/differential_step.h"
#include "core/polygonize/polygonize.h"
#include "figures/facts.h"
#include "figures/floater_scene.h"
#include "figures/studio.h"

namespace seesaw {

namespace {

ParametricBlobbyCylinders<3> cylinder() {
  return ParametricBlobbyCylinders<3>(
      BlobbyCylinders<3>(0.5, Point<3>(-0.35, 0, 0), Point<3>(0.35, 0, 0), Values::Constant(1, 0.6)));
}

}  // namespace

Figure witkin1994_fig1(const FigureContext& context) {
  Figure figure{
      .id = "witkin1994-fig1",
      .paper = "Witkin & Heckbert 1994, Figure 1",
      .title = "Adaptive repulsion and fission recover a stretched cylinder",
      .shows =
          "The topmost image shows a deliberately poor sampling of a blobby cylinder produced using simple "
          "repulsion: the cylinder was rapidly stretched, leaving the sample points behind. The remaining "
          "images show the recovery of good sampling when adaptive repulsion is enabled. The particles at "
          "the frontier increase their radii of repulsion, rapidly filling the voids. As the particles slow "
          "down, they fission, restoring the desired sampling density."};
  ParametricBlobbyCylinders<3> surface = cylinder();
  const FloaterOptions options{.desired_radius = 0.045, .diameter = 1.6, .seed = 3};
  Floaters floaters(surface, options);
  floaters.equilibrate(surface);
  const Index at_first = floaters.size();
  const double wanted = options.desired_radius * options.diameter;

  // The stretch: the ends fly apart, five lengths in ten steps, and the floaters only repel each other.
  FloaterOptions simple = options;
  simple.repulsion = Repulsion::simple;
  floaters.set_options(simple);
  constexpr int stretching = 10;
  ControlPoints<3> nobody;
  ControlOptions stretch;
  stretch.desired_rates = Values::Zero(surface.parameters());
  const std::vector<std::string> names = surface.names();
  for (std::size_t i = 0; i < names.size(); ++i) {
    const double speed = 1.4 / (stretching * options.time_step);
    if (names[i] == "a0.x") stretch.desired_rates[static_cast<Index>(i)] = -speed;
    if (names[i] == "b0.x") stretch.desired_rates[static_cast<Index>(i)] = speed;
  }
  double most_off = 0;
  const auto note_off = [&] { most_off = std::max(most_off, measure(floaters, surface).most_off / wanted); };
  for (int step = 0; step < stretching; ++step) {
    differential_step(surface, nobody, floaters, stretch);
    note_off();
  }
  const Index lost = floaters.counts().lost;

  const TriangleMesh mesh = polygonize(surface, Points<3>(3, 0), {.cells = 120, .exhaustive = true}).mesh;
  Scene whole;
  whole.meshes.push_back(smooth_surface(mesh, surface::blue));
  const PinholeCamera camera = frame(whole, {.direction = {0.1, 0.45, 1}, .aspect = 3.1, .margin = 0.04});
  double gaps[6], variations[6], widest[6];
  Index count[6];
  const auto take = [&](int k, const std::string& title) {
    Scene scene;
    for (const DiscsObject& discs : floater_discs_by_radius(floaters, 1.35 * wanted))
      scene.discs.push_back(facing(discs, camera.eye));
    const std::string name = "frame" + std::to_string(k + 1);
    figure.panels.push_back(
        studio_panel(context, name, title, scene, {.camera = camera, .width = 470, .height = 152}));
    add_floater_facts(figure.panels.back().facts, floaters, surface, mesh.vertices);
    const Spacing spacing = spacing_of(floaters.positions(), floaters.normals());
    gaps[k] = largest_gap(floaters.positions(), mesh.vertices) / wanted;
    variations[k] = spacing.variation;
    widest[k] = floaters.radii().maxCoeff() / wanted;
    count[k] = floaters.size();
  };
  take(0, "stretched under simple repulsion");
  floaters.set_options(options);
  const int moments[] = {6, 14, 26, 45};
  int step = 0;
  for (int k = 0; k < 4; ++k) {
    for (; step < moments[k]; ++step) {
      differential_step(surface, nobody, floaters);
      note_off();
    }
    take(k + 1, std::to_string(step) + " steps of adaptive repulsion");
  }
  step += static_cast<int>(floaters.equilibrate(surface));
  take(5, "at rest");
  figure.columns = 2;

  const Index births_of_recovery = floaters.counts().births;
  figure.checks.push_back(at_least("stretched: largest gap, desired radii", gaps[0], 6));
  figure.checks.push_back(equal("stretched: nobody is born under simple repulsion",
                                static_cast<double>(count[0]), static_cast<double>(at_first - lost)));
  figure.checks.push_back(at_least("recovery: widest radius on the frontier, desired radii",
                                   *std::max_element(widest + 1, widest + 4), 1.8));
  figure.checks.push_back(at_least("at rest: floaters over those at first",
                                   static_cast<double>(count[5]) / static_cast<double>(at_first), 1.8));
  figure.checks.push_back(at_most("at rest: variation of neighbor distances", variations[5], 0.05));
  figure.checks.push_back(at_most("at rest: largest gap, desired radii", gaps[5], 3));
  figure.checks.push_back(at_most("at rest: steps", step, 1500));
  figure.panels.back().facts["births_in_all"] = births_of_recovery;
  figure.panels.back().facts["steps"] = step;
  figure.panels.front().facts["most_off_surface_while_stretched_radii"] = most_off;
  figure.caption =
      "A blobby cylinder grows by " + in_words(2.8, 2) + " in " + std::to_string(stretching) + " steps; " +
      std::to_string(at_first) + " floaters are left with gaps of " + in_words(gaps[0], 2) +
      " desired radii (a). Sand-colored discs have a radius of more than 1.35 times the desired one: the "
      "frontier. At rest (f) there are " +
      std::to_string(count[5]) + " floaters, with a variation of " + in_words(variations[5], 2) +
      " and no gap above " + in_words(gaps[5], 2) + " radii.";
  return figure;
}

}  // namespace seesaw
