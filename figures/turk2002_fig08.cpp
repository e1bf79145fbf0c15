// T&O 2002, Fig. 8: the spike of a normal constraint is turned, and the surface follows.
#include <numbers>

#include "core/editing/replay.h"
#include "core/polygonize/polygonize.h"
#include "figures/facts.h"
#include "figures/floater_scene.h"
#include "figures/studio.h"
#include "figures/surface.h"

namespace seesaw {

namespace {

double degrees_between(const Point<3>& a, const Point<3>& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi;
}

}  // namespace

Figure turk2002_fig08(const FigureContext& context) {
  Figure figure{.id = "turk2002-fig08",
                .paper = "Turk & O\u2019Brien 2002, Figure 8",
                .title = "Changing a normal constraint",
                .shows =
                    "Changing a normal constraint. Left image shows the original surface, and right image "
                    "shows the same surface after changing a normal constraint (shown as a red spike)."};
  const Session<3> session = read_session<3>(context.sessions / "turk2002-fig08.json");
  std::optional<Floaters> floaters;
  std::optional<PinholeCamera> camera;
  // Of the normal constraint: where its spike points and where the surface faces, before and after.
  Point<3> spike[2], faces[2];
  ReplayOptions<3> replaying;
  replaying.after_each = [&](Index, Editor<3>& editor) {
    if (floaters) floaters->step(*editor.shape().function);
  };
  replaying.at_label = [&](const std::string&, Editor<3>& editor) {
    const auto function = editor.shape().function;
    const Points<3> at = boundary_points(editor.document());
    if (!floaters)
      floaters.emplace(*function, at, FloaterOptions{.desired_radius = 0.04, .diameter = 1.6, .seed = 8});
    floaters->equilibrate(*function);
    const TriangleMesh mesh = polygonize(*function, at, {.cells = 80}).mesh;
    const Constraints<3> constraints = constraints_of(editor.document());
    Scene scene, whole;
    whole.meshes.push_back(smooth_surface(mesh, surface::blue));
    if (!camera) camera = frame(whole, {.direction = {0.4, -1, 0.8}, .up = {0, 0, 1}});
    scene.discs.push_back(facing(floater_discs(*floaters), camera->eye));
    add_constraint_discs(scene, *function, constraints, 0.06, camera->eye);
    const bool before = figure.panels.empty();
    figure.panels.push_back(studio_panel(context, before ? "left" : "right",
                                         before ? "the original surface" : "its normal constraint turned",
                                         scene, {.camera = *camera}));
    Facts& facts = figure.panels.back().facts;
    const MeshReport report = check_mesh(mesh);
    add_mesh_facts(facts, report);
    add_floater_facts(facts, *floaters, *function, mesh.vertices);
    check_topology(figure, before ? "left" : "right", report, 1, 1);
    const std::size_t k = before ? 0 : 1;
    for (const Constraint<3>& constraint : constraints) {
      if (!constraint.normal) continue;
      spike[k] = constraint.normal->direction;
      faces[k] = -function->gradient(constraint.at);
      facts["surface_normal_differs_from_the_spike_degrees"] = degrees_between(spike[k], faces[k]);
      facts["spike_turned_degrees"] = degrees_between(spike[0], spike[k]);
      facts["surface_normal_turned_degrees"] = degrees_between(faces[0], faces[k]);
    }
  };
  replay(session, replaying, context.progress);
  figure.checks.push_back(equal("panels", static_cast<double>(figure.panels.size()), 2));
  // One value a little inside says how fast f falls along the spike, not that it falls along nothing else:
  // the surface follows, but not all the way.
  const double turned = degrees_between(spike[0], spike[1]), followed = degrees_between(faces[0], faces[1]);
  const double before = degrees_between(spike[0], faces[0]), after = degrees_between(spike[1], faces[1]);
  figure.checks.push_back(at_most("left: surface normal against the spike, degrees", before, 5));
  figure.checks.push_back(at_least("the spike has turned, degrees", turned, 20));
  figure.checks.push_back(
      at_least("the surface normal has turned, of the spike\u2019s turn", followed / turned, 0.4));
  figure.checks.push_back(at_most("right: surface normal against the spike, degrees", after, turned));
  figure.caption = "The free end of the spike has been dragged by " + in_words(turned, 2) +
                   " degrees; the surface\u2019s normal at its foot has turned by " + in_words(followed, 2) +
                   " (it differed from the spike by " + in_words(std::round(10 * before) / 10, 2) +
                   " degrees, and does by " + in_words(after, 2) + ").";
  return figure;
}

}  // namespace seesaw
