#include "sandbox2d/tour.h"

#include <algorithm>

#include "core/window/ui.h"
#include "sandbox2d/gallery.h"

namespace seesaw {

namespace {

Document<2> with_view(double reach, const char* title) {
  Document<2> document;
  document.title = title;
  document.display.view = Box<2>(Point<2>(-reach, -reach), Point<2>(reach, reach));
  document.display.field = document.display.isolines = true;
  return document;
}

SceneConstraint<2> boundary_at(double x, double y) {
  SceneConstraint<2> result;
  result.constraint.at = {x, y};
  return result;
}

Document<2> four_zeros() {
  Document<2> document = with_view(1.75, "Four boundary constraints");
  for (const auto& [x, y] : {std::pair(-1.0, -0.3), {0.35, -0.85}, {1.05, 0.2}, {-0.2, 0.9}})
    document.constraints.push_back(boundary_at(x, y));
  return document;
}

Document<2> two_zeros() {
  Document<2> document = with_view(3.6, "Two boundary constraints");
  document.constraints = {boundary_at(-1.5, -0.5), boundary_at(1.5, 0.5)};
  return document;
}

Document<2> of_gallery(const char* scene) {
  for (const GalleryEntry& entry : gallery())
    if (std::string(entry.scene) == scene) return read_scene(entry);
  throw Error(std::string("the gallery has no ") + scene);
}

std::size_t count(const Document<2>& document, ConstraintKind kind) { return all_of(document, kind).size(); }

// Of the constraints that were there, any has another place.
bool any_moved(const Document<2>& scene, const Document<2>& now) {
  for (std::size_t i = 0; i < std::min(scene.constraints.size(), now.constraints.size()); ++i)
    if (scene.constraints[i].constraint.at != now.constraints[i].constraint.at) return true;
  return false;
}

constexpr Index north_west = 2;  // in turk2002-fig05-left.json

std::vector<TourStep> make_steps() {
  std::vector<TourStep> steps;
  steps.push_back(
      {.title = "Two kinds of constraints",
       .words =
           "Each circle is a boundary constraint: f is to be 0 there, so the curve is to pass there. The "
           "smoothest function that is 0 at all of them is 0 everywhere, and there is no curve yet. One "
           "interior constraint, f = 1, says where inside is.",
       .task = "Press I, then click in the middle of the circles.",
       .scene = four_zeros,
       .done = [](const Document<2>&, Desk& desk) {
         return count(desk.document(), ConstraintKind::interior) > 0;
       }});
  steps.push_back(
      {.title = "One linear system",
       .words =
           "f is a sum of one kernel a constraint and a plane. One linear system gives its weights: the "
           "function that obeys and bends least. Where it is 0 is the curve; orange is inside, blue outside.",
       .task = "Drag a circle, or the plus sign: the system is solved anew in every frame.",
       .scene = [] { return of_gallery("turk2002-fig01-left.json"); },
       .done = [](const Document<2>& scene, Desk& desk) { return any_moved(scene, desk.document()); }});
  steps.push_back(
      {.title = "Exterior constraints",
       .words = "Exterior constraints, f = \u22121, say what is outside. A cage of them around everything "
                "closes whatever passes through the boundary constraints within (Turk & O\u2019Brien 2002, "
                "Figure 4).",
       .task = "Press K for a cage of eight. Then drag one of the two circles.",
       .scene = two_zeros,
       .done = [](const Document<2>&, Desk& desk) {
         return count(desk.document(), ConstraintKind::exterior) >= 8;
       }});
  steps.push_back(
      {.title = "Normal constraints",
       .words = "A normal constraint asks for a small value just inside a boundary constraint, and so says "
                "which way is out. It is drawn as a spike (Figure 5).",
       .task = "Drag the free end of the spike that is marked.",
       .scene = [] { return of_gallery("turk2002-fig05-left.json"); },
       .done =
           [](const Document<2>& scene, Desk& desk) {
             if (desk.editor().size() <= north_west) return false;
             const auto& before = scene.constraints[north_west].constraint.normal;
             const auto& now = desk.constraint(north_west).normal;
             return before && now && before->direction != now->direction;
           },
       .pointed = {north_west}});
  steps.push_back(
      {.title = "The see-saw",
       .words =
           "At the right f stands as a plate over the plane f = 0. Each boundary constraint acts much like a "
           "see-saw: pull the plate up on one side, and the other side goes down. So f changes its sign at "
           "every "
           "boundary constraint, and the curve closes. (With one interior constraint all of f grows, and the "
           "curve "
           "itself stands still.)",
       .task =
           "Pull \u201cinterior value\u201d in the side panel up to 2, or press ], and watch the plate tip.",
       .scene = [] { return of_gallery("seesaw.json"); },
       .done =
           [](const Document<2>&, Desk& desk) {
             for (const auto& each : desk.document().constraints)
               if (each.constraint.kind == ConstraintKind::interior && each.constraint.value >= 1.8)
                 return true;
             return false;
           },
       .plate = true,
       .profile = ProfileLine{{-0.3, 0.7286}, {0.63, -1.53}},
       .pointed = {}});
  steps.push_back(
      {.title = "New constraints",
       .words =
           "On the curve f is 0 already. A boundary constraint placed there asks for nothing new, and the "
           "least bent function stays what it is (section 5). So a curve is refined without being disturbed.",
       .task = "Double-click the curve: nothing moves. Then drag the new circle.",
       .scene = [] { return of_gallery("knot-insertion.json"); },
       .done =
           [](const Document<2>& scene, Desk& desk) {
             return count(desk.document(), ConstraintKind::boundary) > count(scene, ConstraintKind::boundary);
           }});
  steps.push_back(
      {.title = "That is all",
       .words =
           "F2 opens the papers\u2019 figures, each with something to try. F1 lists every key. Nothing can "
           "be broken: Ctrl+Z goes back as far as you like.",
       .task = "",
       .scene = [] { return of_gallery("turk2002-fig01-right.json"); },
       .done = [](const Document<2>&, Desk&) { return true; }});
  return steps;
}

}  // namespace

const std::vector<TourStep>& tour_steps() {
  static const std::vector<TourStep> steps = make_steps();
  return steps;
}

void Tour::go_to(int step, Desk& desk) {
  const int last = static_cast<int>(tour_steps().size()) - 1;
  step = std::clamp(step, 0, last);
  const TourStep& next = tour_steps()[static_cast<std::size_t>(step)];
  start_ = next.scene();
  desk.start(start_);
  desk.take(next.tool);
  desk.set_profile(next.profile);
  step_ = step;
  done_ = false;
}

void Tour::watch(Desk& desk) {
  if (!running() || done_) return;
  done_ = tour_steps()[static_cast<std::size_t>(step_)].done(start_, desk);
}

std::vector<Index> Tour::pointed() const {
  if (!running() || done_) return {};
  return tour_steps()[static_cast<std::size_t>(step_)].pointed;
}

Tour::Wish Tour::frame(const Rect& place) {
  if (!running()) return Wish::none;
  const TourStep& step = tour_steps()[static_cast<std::size_t>(step_)];
  const int steps = static_cast<int>(tour_steps().size());
  const auto panel = ui::panel("Tour", place, {.title = false});
  if (!panel) return Wish::none;
  // First, so that they are there however little room the words have.
  Wish wish = Wish::none;
  {
    const auto off = ui::disabled(step_ == 0);
    if (ui::button("Back")) wish = Wish::back;
  }
  ui::same_line();
  const bool last = step_ + 1 == steps;
  if (!last) {
    if (ui::tool_button("Next", done_)) wish = Wish::next;
    ui::same_line();
  }
  if (ui::button(last ? "End the tour" : "Stop")) wish = Wish::stop;
  ui::same_line();
  ui::soft_text(std::to_string(step_ + 1) + " of " + std::to_string(steps));
  ui::bold_text(step.title);
  if (*step.task)
    ui::colored_text(done_ ? "\u2713 Done. Go on, or play with it." : step.task, ui::colors().accent);
  ui::paragraph(step.words);
  return wish;
}

}  // namespace seesaw
