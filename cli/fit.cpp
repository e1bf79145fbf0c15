// seesaw fit MODEL -o SCENE: a polygon model or a scan becomes a scene of constraints.
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <type_traits>
#include <variant>

#include "cli/commands.h"
#include "cli/output.h"
#include "cli/table.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/mesh/mesh_check.h"
#include "core/mesh/mesh_file.h"
#include "core/modelling/fit_model.h"
#include "core/scene/document_json.h"

namespace seesaw {

namespace {

struct FitArguments {
  std::string model, output, kernel, side = "inside";
  Index vertices = 0, most = FitModelOptions().most;
  double offset = ModelConstraintOptions().offset, tolerance = 0;
  bool has_vertices = false, has_tolerance = false, simplify = false, fixed_offset = false, unit_cube = false,
       keep_normals = false, no_cage = false, keep_strays = false;
};

FitModelOptions checked(const FitArguments& options) {
  FitModelOptions result;
  constexpr Index largest = 20000;  // rows^2 doubles: 13 GB
  if (options.has_vertices && (options.vertices < 4 || options.vertices > largest))
    throw Error("--vertices: expected 4 to 20000, found " + std::to_string(options.vertices));
  if (options.most < 4 || options.most > largest)
    throw Error("--most: expected 4 to 20000, found " + std::to_string(options.most));
  if (!(options.offset > 0 && options.offset <= 0.5))
    throw Error("--offset: expected more than 0 and at most 0.5 of the model's longest side, found " +
                to_text(options.offset));
  if (options.has_tolerance && !(options.tolerance > 0 && options.tolerance <= 1))
    throw Error("--tolerance: expected more than 0 and at most 1 of the model's longest side, found " +
                to_text(options.tolerance));
  if (options.has_vertices) result.vertices = options.vertices;
  if (options.has_tolerance) result.tolerance = options.tolerance;
  result.most = options.most;
  result.simplify = options.simplify;
  result.turn_normals = !options.keep_normals;
  result.cage = !options.no_cage;
  result.clean = !options.keep_strays;
  if (!options.kernel.empty()) {
    result.kernel = kernel_named(options.kernel);
    if (!result.kernel)
      throw Error("--kernel: expected thin_plate_spline, cubic or linear, found \"" + options.kernel + "\"");
  }
  ModelConstraintOptions& making = result.constraints;
  making.offset = options.offset;
  making.shrink = !options.fixed_offset;
  making.to_unit_cube = options.unit_cube;
  if (options.side == "outside")
    making.side = NormalSide::outside;
  else if (options.side == "both")
    making.side = NormalSide::both;
  else if (options.side != "inside")
    throw Error("--side: expected inside, outside or both, found \"" + options.side + "\"");
  return result;
}

std::string closed_or_not(const MeshReport& report) {
  if (report.closed) return "closed";
  if (report.boundary_edges > 0)
    return "open: " + counted(report.boundary_loops, "hole", "holes") + " with " +
           counted(report.boundary_edges, "edge", "edges");
  return "not closed: " + counted(report.nonmanifold_edges, "edge", "edges") + " of more than two faces";
}

Table table_of_model(const Model& model) {
  Table table;
  if (const auto* loaded = std::get_if<LoadedMesh>(&model)) {
    const MeshReport report = check_mesh(loaded->mesh);
    table.emplace_back("model", counted(report.vertices, "vertex", "vertices") + ", " +
                                    counted(report.faces, "face", "faces") + ", " + closed_or_not(report));
    for (const std::string& repair : loaded->repairs.in_words()) table.emplace_back("repair", repair);
  } else {
    const auto& cloud = std::get<PointCloud>(model);
    table.emplace_back("model", counted(cloud.points.cols(), "point", "points"));
  }
  return table;
}

std::string in_words(Choice choice, Index of) {
  switch (choice) {
    case Choice::all:
      return "all";
    case Choice::simplified:
      return "simplified from " + std::to_string(of);
    case Choice::farthest:
      return "of " + std::to_string(of) + ", the farthest from each other";
    case Choice::adaptive:
      return "of " + std::to_string(of) + ", where the error was largest";
  }
  return "";
}

// A fraction of the longest side, and what it is in the units of the scene.
std::string in_both(double fraction, double unit) {
  return to_text(fraction, 3) + " of the longest side" +
         (unit == 1.0 ? "" : ", " + to_text(fraction * unit, 3) + " units");
}

void report_on(Table& table, const FittedModel& fitted, const FitArguments& options) {
  const ModelConstraintReport& made = fitted.made.report;
  const FitReport& fit = fitted.fitted.report;
  const double unit = options.unit_cube ? 1.0 : made.cube.scale;
  table.emplace_back("longest side", to_text(made.cube.scale));
  table.emplace_back("vertices",
                     std::to_string(made.vertices) + ", " + in_words(fitted.choice, fitted.points));
  table.emplace_back("constraints",
                     std::to_string(fit.constraints()) + ": " + std::to_string(fit.boundary) + " boundary, " +
                         std::to_string(fit.normal) + " normal" +
                         (fit.exterior ? ", " + std::to_string(fit.exterior) + " exterior" : ""));
  if (fitted.cage > 0)
    table.emplace_back("cage", counted(fitted.cage, "exterior constraint", "exterior constraints") +
                                   " around, since the model is open");
  table.emplace_back("offset", in_both(options.offset, unit));
  if (made.shrunk > 0)
    table.emplace_back("", "shrunk at " + std::to_string(made.shrunk) +
                               " where the model is too thin for it, down to " + to_text(made.smallest, 3));
  if (made.lowered > 0)
    table.emplace_back("", "value lowered at " + std::to_string(made.lowered) + " in sharp wedges");
  if (fitted.strays > 0)
    table.emplace_back("left out", counted(fitted.strays, "point", "points") + " astray");
  if (fitted.contradicted > 0)
    table.emplace_back("left out", counted(fitted.contradicted, "normal", "normals") +
                                       " of the cloud against all neighbors'");
  if (made.normals_unknown > 0)
    table.emplace_back("left out", counted(made.normals_unknown, "normal", "normals") + " not known");
  if (made.no_room > 0)
    table.emplace_back("left out", counted(made.no_room, "normal", "normals") + " for want of room");
  if (made.crowded > 0)
    table.emplace_back("left out", counted(made.crowded, "vertex", "vertices") + " too near to others");
  if (fitted.left_out > 0)
    table.emplace_back("left out",
                       counted(fitted.left_out, "constraint", "constraints") + " the solver could not take");
  table.emplace_back("kernel", std::string(name_of(fit.kernel)));
  for (const AdaptiveStep& step : fitted.history)
    table.emplace_back("round", std::to_string(step.vertices) + " vertices: largest error " +
                                    to_text(step.max_error, 3) + ", rms " + to_text(step.rms_error, 3));
  table.emplace_back("fit", to_text(fit.seconds, 3) + " s");
  table.emplace_back("max residual", to_text(fit.max_residual, 3));
  table.emplace_back("largest error", in_both(fitted.max_error, unit) + ", over " +
                                          counted(fitted.points, "point", "points") + " of the model");
  table.emplace_back("rms error", in_both(fitted.rms_error, unit));
}

void note(const std::string& text) { std::cerr << "seesaw: note: " << text << std::endl; }

// No failures, and yet things a person should know.
void print_notes(const FittedModel& fitted, const FitArguments& options) {
  if (fitted.turned)
    note("the normals lead into the model; they were turned (--keep-normals takes them as they are)");
  if (!fitted.trouble.empty()) note("the mesh was sampled instead of simplified: " + fitted.trouble);
  if (!options.has_vertices && !options.has_tolerance && fitted.choice != Choice::all)
    note("a dense solver cannot take all " + std::to_string(fitted.points) + " vertices: " +
         std::to_string(fitted.made.report.vertices) + " stand for them; see --vertices and --tolerance");
  if (!fitted.met)
    note("the tolerance was not met with " + std::to_string(fitted.made.report.boundary) +
         " vertices; see --most");
}

Document<3> document_of(const FittedModel& fitted, const FitArguments& options) {
  Document<3> document;
  document.kernel = fitted.fitted.report.kernel;
  const std::string name = std::filesystem::path(options.model).filename().string();
  document.title = std::filesystem::path(options.model).stem().string();
  document.description = "Fitted to " + name + " by " +
                         counted(fitted.fitted.report.constraints(), "constraint", "constraints") + ".";
  for (const Constraint<3>& each : fitted.made.constraints) {
    document.constraints.emplace_back();
    document.constraints.back().constraint = each;
  }
  return document;
}

void run(const FitArguments& options) {
  const FitModelOptions fitting = checked(options);
  refuse_unless_writable(options.output);
  const Model model = read_model(options.model);
  Table table = table_of_model(model);
  const auto fitted = [&] {
    try {
      return std::visit(
          [&](const auto& given) {
            if constexpr (std::is_same_v<std::decay_t<decltype(given)>, LoadedMesh>)
              return fit_model(given.mesh, fitting);
            else
              return fit_model(given, fitting);
          },
          model);
    } catch (const Error& error) {
      throw FileError(options.model, error.what());
    }
  }();
  write_document(options.output, document_of(fitted, options));
  report_on(table, fitted, options);
  print_notes(fitted, options);
  print(aligned_text(table));
}

}  // namespace

void add_fit(CLI::App& program) {
  const auto options = std::make_shared<FitArguments>();
  CLI::App* command =
      program.add_subcommand("fit", "Make a scene of a polygon model or a scan, and say how well it fits");
  command
      ->add_option("MODEL", options->model,
                   "A mesh (.ply, .obj, .off, .stl ...) or points with normals (.ply, .xyz, .pwn, .csv)")
      ->required()
      ->type_name("");
  command->add_option("-o,--output", options->output, "The scene to write, a document in JSON")
      ->required()
      ->type_name("SCENE");
  const CLI::Option* vertices =
      command
          ->add_option(
              "--vertices", options->vertices,
              "Use so many vertices, those farthest from each other. With --tolerance, begin with so many")
          ->type_name("N");
  command
      ->add_option(
          "--offset", options->offset,
          "How far inside its vertex a normal constraint stands, as a fraction of the longest side; less "
          "where the model is thin")
      ->type_name("D")
      ->capture_default_str();
  const CLI::Option* tolerance =
      command
          ->add_option(
              "--tolerance", options->tolerance,
              "Add vertices where the error is largest until no point of the model is farther from the "
              "surface than this fraction of the longest side")
          ->type_name("T");
  command->add_option("--most", options->most, "With --tolerance, no more vertices than this")
      ->type_name("N")
      ->capture_default_str();
  command->add_option("--kernel", options->kernel, "thin_plate_spline, cubic or linear; the papers use cubic")
      ->type_name("K");
  command->add_option("--side", options->side, "Normal constraints inside the surface, outside, or both")
      ->type_name("SIDE")
      ->capture_default_str();
  command->add_flag("--simplify", options->simplify,
                    "Choose vertices of a mesh by simplification, instead of those farthest from each other");
  command->add_flag("--fixed-offset", options->fixed_offset,
                    "The papers' fixed offset, even where it leaves the model");
  command->add_flag("--unit-cube", options->unit_cube, "Move and scale the model to the unit cube");
  command->add_flag("--keep-normals", options->keep_normals,
                    "Take the normals of points and open meshes as they are, even if they lead in");
  command->add_flag(
      "--keep-strays", options->keep_strays,
      "Keep points that stand apart from all others, and normals that all neighbors contradict");
  command->add_flag(
      "--no-cage", options->no_cage,
      "No exterior constraints around points and open meshes, which keep the surface from ballooning");
  command->footer(
      "Models of up to 1500 vertices are taken whole; of larger ones 1200 are chosen unless you say\n"
      "otherwise. Then: seesaw polygonize SCENE -o MESH.");
  command->callback([options, vertices, tolerance] {
    options->has_vertices = vertices->count() > 0;
    options->has_tolerance = tolerance->count() > 0;
    run(*options);
  });
}

}  // namespace seesaw
