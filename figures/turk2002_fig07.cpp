// T&O 2002, Fig. 7: a ball as sculpting begins, and the torus that a recorded session makes of it; both as
// floaters.
#include "core/editing/replay.h"
#include "core/mesh/mesh_check.h"
#include "core/polygonize/polygonize.h"
#include "figures/facts.h"
#include "figures/floater_scene.h"
#include "figures/studio.h"
#include "figures/surface.h"

namespace seesaw {

namespace {

// What a sculptor sees at one moment.
struct View {
  std::shared_ptr<const Interpolant<3>> function;
  Constraints<3> constraints;
  TriangleMesh mesh;
  Floaters floaters;
};

View view_of(Editor<3>& editor, Floaters floaters) {
  View view{editor.shape().function, constraints_of(editor.document()), {}, std::move(floaters)};
  view.mesh =
      polygonize(*view.function, boundary_points(editor.document()), {.cells = 80, .exhaustive = true}).mesh;
  view.floaters.equilibrate(*view.function);
  return view;
}

}  // namespace

Figure turk2002_fig07(const FigureContext& context) {
  Figure figure{
      .id = "turk2002-fig07",
      .paper = "Turk & O\u2019Brien 2002, Figure 7",
      .title = "Interactive sculpting",
      .shows =
          "Interactive sculpting of interpolating implicit surfaces. The left image shows an initial "
          "configuration with four boundary constraints (the red markers). The right surface is a sculpted "
          "torus."};
  const Session<3> session = read_session<3>(context.sessions / "turk2002-fig07-torus.json");
  // Floaters live through the whole session, as they would in the window: a few steps after each command.
  std::optional<Floaters> floaters;
  std::optional<View> start;
  Index lost_on_the_way = 0;
  const FloaterOptions options{.desired_radius = 0.03, .diameter = 1.6, .seed = 7};
  const Editor<3> end = [&] {
    ReplayOptions<3> replaying;
    replaying.at_label = [&](const std::string& text, Editor<3>& editor) {
      if (text != "start") return;
      floaters.emplace(*editor.shape().function, boundary_points(editor.document()), options);
      start = view_of(editor, *floaters);
      floaters = start->floaters;
    };
    replaying.after_each = [&](Index, Editor<3>& editor) {
      if (!floaters) return;
      const auto function = editor.shape().function;
      floaters->seed(*function, boundary_points(editor.document()));
      for (int step = 0; step < 5; ++step) floaters->step(*function);
    };
    return replay(session, replaying, context.progress);
  }();
  lost_on_the_way = floaters->counts().lost;
  Editor<3> editor(end.document());
  const View views[2] = {*start, view_of(editor, *floaters)};

  const char* const names[] = {"left", "right"};
  const char* const titles[] = {"four boundary constraints", "a sculpted torus"};
  for (int i = 0; i < 2; ++i) {
    const View& view = views[i];
    Scene whole;
    whole.meshes.push_back(smooth_surface(view.mesh, surface::blue));
    const PinholeCamera camera = frame(
        whole, {.direction = {i == 0 ? 1.0 : 0.4, -1, 0.8}, .up = {0, 0, 1}, .margin = i == 0 ? 0.16 : 0.06});
    Scene scene;
    scene.discs.push_back(facing(floater_discs(view.floaters), camera.eye));
    add_constraint_discs(scene, *view.function, view.constraints, i == 0 ? 0.085 : 0.06, camera.eye);
    figure.panels.push_back(studio_panel(context, names[i], titles[i], scene, {.camera = camera}));
    Facts& facts = figure.panels.back().facts;
    const MeshReport report = check_mesh(view.mesh);
    add_mesh_facts(facts, report);
    add_floater_facts(facts, view.floaters, *view.function, view.mesh.vertices);
    facts["commands"] = i == 0 ? 0 : session.commands.size();
    check_topology(figure, names[i], report, 1, i);
    const Spacing spacing = spacing_of(view.floaters.positions(), view.floaters.normals());
    const std::string panel = std::string(names[i]) + ": ";
    figure.checks.push_back(
        at_most(panel + "variation of neighbor distances", spacing.variation, i == 0 ? 0.05 : 0.12));
    figure.checks.push_back(at_most(
        panel + "largest gap, mean radii",
        largest_gap(view.floaters.positions(), view.mesh.vertices) / view.floaters.radii().mean(), 3));
  }
  const Points<3>& ball = views[0].mesh.vertices;
  const Point<3> middle = ball.rowwise().mean();
  const Values radii = (ball.colwise() - middle).colwise().norm();
  figure.panels[0].facts["largest_radius_over_smallest"] = radii.maxCoeff() / radii.minCoeff();
  figure.panels[1].facts["lost_on_the_way"] = lost_on_the_way;
  figure.checks.push_back(
      at_most("left: largest radius over smallest", radii.maxCoeff() / radii.minCoeff(), 1.25));
  const FloaterMeasures last = measure(views[1].floaters, *views[1].function);
  figure.checks.push_back(at_most("right: farthest off the surface, radii", last.most_off_radii, 1e-3));
  figure.caption =
      "Left: radii about the middle differ by a factor of " + in_words(radii.maxCoeff() / radii.minCoeff()) +
      ". Right: after " + std::to_string(session.commands.size()) +
      " recorded commands, which add boundary constraints on the surface and drag them; the same " +
      "floaters, from " + std::to_string(views[0].floaters.size()) + " to " +
      std::to_string(views[1].floaters.size()) + ", have followed all the way.";
  return figure;
}

}  // namespace seesaw
