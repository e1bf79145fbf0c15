// The sessions that ship: T&O 2002, Fig. 7, a torus sculpted from a ball by adding and dragging boundary
// constraints; and Fig. 8, a normal constraint turned by the free end of its spike.
#include <gmock/gmock.h>

#include <map>

#include "core/editing/replay.h"
#include "core/mesh/mesh_check.h"
#include "core/polygonize/polygonize.h"
#include "tests/core/editing/documents.h"

namespace seesaw {
namespace {

using ::testing::ElementsAre;

Session<3> shipped(const char* name) {
  return read_session<3>(std::string(SEESAW_SOURCE_DIR "/figures/sessions/") + name + ".json");
}

MeshReport surface(Editor<3>& editor, int cells) {
  EXPECT_TRUE(editor.shape().current());
  const Polygonization found =
      polygonize(*editor.shape().function, boundary_points(editor.document()), {.cells = cells});
  EXPECT_EQ(found.seeds_missed, 0);
  EXPECT_FALSE(found.clipped);
  return check_mesh(found.mesh);
}

TEST(FigureSessions, SculptATorusFromABall) {
  const Session<3> session = shipped("turk2002-fig07-torus");
  EXPECT_TRUE([&] {
    for (std::size_t i = 0; i < session.start.constraints.size(); ++i)
      if ((session.start.constraints[i].constraint.at - start_document<3>().constraints[i].constraint.at)
              .norm() > 1e-15)
        return false;
    return session.start.constraints.size() == start_document<3>().constraints.size();
  }()) << "it begins as the paper does";

  // Nothing but boundary constraints that are added on the surface, and dragged.
  Index added = 0, drags = 0;
  for (const RecordedCommand<3>& each : session.commands) {
    drags += std::holds_alternative<EndGesture>(each.command);
    const auto* action = std::get_if<Action<3>>(&each.command);
    if (!action) continue;
    added += std::holds_alternative<AddOnSurface<3>>(*action);
    const auto* move = std::get_if<MoveTo<3>>(action);
    ASSERT_TRUE(move || std::holds_alternative<AddOnSurface<3>>(*action)) << each.line;
    if (move) {
      EXPECT_FALSE(move->which >= 4 && move->which < 12) << "the cage stays";
    }
  }
  EXPECT_EQ(added, 15);
  EXPECT_EQ(drags, 19);

  std::vector<std::string> labels;
  ReplayOptions<3> options;
  options.at_label = [&](const std::string& label, Editor<3>& editor) {
    labels.push_back(label);
    const MeshReport report = surface(editor, 40);
    EXPECT_TRUE(report.closed && report.manifold && report.oriented) << label;
    EXPECT_EQ(report.components, 1) << label;
    EXPECT_EQ(report.genus, label == "hole" || label == "torus" ? 1 : 0) << label;
  };
  // Added on the surface, a constraint changes f nowhere.
  std::shared_ptr<const Field<3>> before;
  options.after_each = [&](Index index, Editor<3>& editor) {
    const auto after = editor.shape().function;
    const auto* action = std::get_if<Action<3>>(&session.commands[static_cast<std::size_t>(index)].command);
    if (action && std::holds_alternative<AddOnSurface<3>>(*action)) {
      const Box<3> box(Point<3>::Constant(-3), Point<3>::Constant(3));
      EXPECT_LE(greatest_change<3>(*before, *after, box),
                10 * rounding<3>(editor.shape().report, *after, box));
    }
    before = after;
  };
  Editor<3> editor = replay(session, options);
  EXPECT_THAT(labels, ElementsAre("start", "rim", "top", "bottom", "hole", "torus"));

  for (const int cells : {24, 60, 96}) {
    const MeshReport report = surface(editor, cells);
    EXPECT_TRUE(report.closed && report.manifold && report.oriented) << cells;
    EXPECT_EQ(report.components, 1) << cells;
    EXPECT_EQ(report.genus, 1) << cells;
  }
  // A decent one: it was aimed at the torus of radii 1 and 0.4, and strays from it by less than a tenth of
  // 0.4.
  const TriangleMesh mesh =
      polygonize(*editor.shape().function, boundary_points(editor.document()), {.cells = 60}).mesh;
  double farthest = 0;
  for (Index i = 0; i < mesh.vertices.cols(); ++i) {
    const Point<3> x = mesh.vertices.col(i);
    farthest = std::max(farthest, std::abs(std::hypot(x.head<2>().norm() - 1, x.z()) - 0.4));
  }
  EXPECT_LT(farthest, 0.06);
  RecordProperty("farthest", std::to_string(farthest));
  // The drags end at places that are written down, so the last document does not hang on where rays met.
  EXPECT_EQ(editor.document().constraints[23].constraint.at, Point<3>(0.424, 0.424, 0));
  EXPECT_EQ(editor.undo_size(), 15u + 19u);
  while (editor.undo().changed) {
  }
  EXPECT_EQ(bits_of(editor.document()), bits_of(session.start));
}

double degrees(const Point<3>& a, const Point<3>& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / M_PI;
}

TEST(FigureSessions, TurnANormal) {
  const Session<3> session = shipped("turk2002-fig08");
  const Document<3> torus = replay(shipped("turk2002-fig07-torus")).document();
  ASSERT_EQ(session.start.constraints.size(), torus.constraints.size()) << "it goes on where Fig. 7 ends";
  for (std::size_t i = 0; i < torus.constraints.size(); ++i)
    EXPECT_EQ(session.start.constraints[i], torus.constraints[i]);

  struct Moment {
    Point<3> spike, normal;  // outward, of length 1
  };
  std::map<std::string, Moment> at;
  ReplayOptions<3> options;
  options.at_label = [&](const std::string& label, Editor<3>& editor) {
    const Constraint<3>& turned = editor.document().constraints.back().constraint;
    at[label] = {turned.normal->direction.normalized(),
                 -editor.shape().function->gradient(turned.at).normalized()};
    EXPECT_LT(std::abs(editor.shape().function->value(turned.at)), 1e-12);
    EXPECT_EQ(surface(editor, 40).genus, 1);
    EXPECT_EQ(surface(editor, 40).components, 1);
  };
  replay(session, options);
  ASSERT_EQ(at.size(), 2u);
  EXPECT_LT(degrees(at["before"].spike, at["before"].normal), 1e-6) << "a new normal is the surface's own";
  EXPECT_NEAR(degrees(at["before"].spike, at["after"].spike), 45, 0.1);
  // The surface follows as far as its other constraints let it: action.h says why not all the way.
  EXPECT_NEAR(degrees(at["before"].normal, at["after"].normal), 36.4, 0.5);
  EXPECT_NEAR(degrees(at["after"].spike, at["after"].normal), 8.7, 0.5);
}

}  // namespace
}  // namespace seesaw
