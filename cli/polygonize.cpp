// seesaw polygonize SCENE -o MESH: the surface of a 3D scene as triangles.
#include "core/polygonize/polygonize.h"

#include <array>
#include <chrono>
#include <cmath>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <variant>

#include "cli/commands.h"
#include "cli/output.h"
#include "cli/scene_file.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/mesh/mesh_check.h"
#include "core/mesh/mesh_file.h"
#include "core/scene/document_json.h"

namespace seesaw {

namespace {

struct PolygonizeArguments {
  std::string scene, output;
  std::array<std::string, 6> box;
  bool has_box = false, exhaustive = false, raw = false, text = false, json = false;
  int cells = PolygonizeOptions().cells;
  double megabytes = static_cast<double>(PolygonizeOptions().memory_limit) / 1e6;
};

Box<3> parse_box(const std::array<std::string, 6>& words) {
  std::array<double, 6> x{};
  for (std::size_t i = 0; i < 6; ++i) {
    const std::optional<double> number = parse_number(words[i]);
    if (!number || !std::isfinite(*number))
      throw Error("--box: expected six finite numbers XMIN YMIN ZMIN XMAX YMAX ZMAX, found \"" + words[i] +
                  "\"");
    x[i] = *number;
  }
  for (std::size_t d = 0; d < 3; ++d)
    if (!(x[d] < x[d + 3]) || !std::isfinite(x[d + 3] - x[d]))
      throw Error("--box: expected XMIN below XMAX, YMIN below YMAX and ZMIN below ZMAX, found " + words[d] +
                  " and " + words[d + 3]);
  return {Point<3>(x[0], x[1], x[2]), Point<3>(x[3], x[4], x[5])};
}

// All that can be wrong with the output, before long work and not after it.
void refuse_unknown_ending(const std::string& output) {
  const auto dot = output.find_last_of("./\\");
  std::string ending = dot == std::string::npos ? "" : output.substr(dot);
  for (char& c : ending)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  if (ending != ".obj" && ending != ".ply" && ending != ".stl" && ending != ".off")
    throw Error(output + ": expected a name that ends in .obj, .ply, .stl or .off");
}

nlohmann::ordered_json json_of(const Polygonization& result, const MeshReport& report, double fit_seconds,
                               double seconds) {
  nlohmann::ordered_json json;
  json["vertices"] = report.vertices;
  json["faces"] = report.faces;
  json["components"] = report.components;
  json["closed"] = report.closed;
  json["manifold"] = report.manifold;
  json["oriented"] = report.oriented;
  json["euler_characteristic"] = report.euler_characteristic;
  json["genus"] = report.genus >= 0 ? nlohmann::ordered_json(report.genus) : nullptr;
  json["boundary_edges"] = report.boundary_edges;
  json["area"] = report.area;
  json["volume"] = report.volume;  // null for an open mesh: JSON has no NaN
  json["clipped"] = result.clipped;
  json["cell"] = result.cell;
  json["halved"] = result.halved;
  json["smallest_angle_raw"] = result.smallest_angle_raw;
  json["smallest_angle"] = result.smallest_angle;
  json["seeds"] = {{"on_surface", result.seeds_on_surface},
                   {"outside_box", result.seeds_outside},
                   {"nowhere", result.seeds_nowhere},
                   {"missed", result.seeds_missed}};
  json["small_components"] = result.small_components;
  json["evaluations"] = result.evaluations;
  json["gradient_evaluations"] = result.gradient_evaluations;
  json["fit_seconds"] = fit_seconds;
  json["polygonize_seconds"] = seconds;
  return json;
}

std::string in_words(Index n, const std::string& noun) {
  return std::to_string(n) + " " + noun + (n == 1 ? "" : "s");
}

std::string line_of(const Polygonization& result, const MeshReport& report, double seconds) {
  std::string line = in_words(report.faces, "triangle") + ", " + in_words(report.components, "component");
  if (report.closed)
    line += ", closed, genus " + std::to_string(report.genus) + ", volume " + to_text(report.volume);
  else
    line += ", " + in_words(report.boundary_edges, "boundary edge");
  return line + ", smallest angle " + to_text(result.smallest_angle, 3) + " degrees, " + to_text(seconds, 3) +
         " s";
}

void notes(const Polygonization& result, bool has_box) {
  const auto note = [](const std::string& text) { std::cerr << "seesaw: note: " << text << std::endl; };
  if (result.mesh.faces.cols() == 0) note("no part of the surface was found");
  if (result.clipped)
    note(has_box ? "the surface leaves the box and is cut there"
                 : "the surface leads far away and is cut; --box says where to cut it");
  if (result.seeds_missed > 0)
    note("the mesh misses " + in_words(result.seeds_missed, "boundary constraint") +
         ": the shape is thin there; try more --cells");
  if (result.halved > 0)
    note("thin parts asked for " + std::to_string(1 << result.halved) + " times the --cells");
}

void run(const PolygonizeArguments& options) {
  refuse_unknown_ending(options.output);
  refuse_unless_writable(options.output);
  if (options.cells < 1 || options.cells > 65536)
    throw Error("--cells: expected 1 to 65536, found " + std::to_string(options.cells));
  if (!(options.megabytes >= 1 && options.megabytes <= 1e9))
    throw Error("--memory: expected 1 to 1e9 megabytes, found " + to_text(options.megabytes));
  PolygonizeOptions how;
  how.cells = options.cells;
  if (options.has_box) how.box = parse_box(options.box);
  how.exhaustive = options.exhaustive;
  how.improve = !options.raw;
  how.memory_limit = static_cast<std::size_t>(options.megabytes * 1e6);

  const AnyDocument any = read_document(options.scene);
  if (!std::holds_alternative<Document<3>>(any))
    throw FileError(options.scene, "is a 2D scene, which has a curve and no surface; see seesaw contour");
  const Document<3>& document = std::get<Document<3>>(any);
  const Fit<3> fitted = fit_scene(options.scene, document);
  const auto start = std::chrono::steady_clock::now();
  const Polygonization result = polygonize(fitted.function, boundary_points(document), how);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  write_mesh(options.output, result.mesh, {.text = options.text});

  const MeshReport report = check_mesh(result.mesh);
  notes(result, options.has_box);
  if (options.json)
    print(json_of(result, report, fitted.report.seconds, seconds).dump(2) + "\n");
  else
    print(line_of(result, report, seconds) + "\n");
}

}  // namespace

void add_polygonize(CLI::App& program) {
  const auto options = std::make_shared<PolygonizeArguments>();
  CLI::App* command = program.add_subcommand("polygonize", "Turn the surface of a 3D scene into triangles");
  command->add_option("SCENE", options->scene, "A 3D document in JSON")->required()->type_name("");
  command->add_option("-o,--output", options->output, "A name that ends in .obj, .ply, .stl or .off")
      ->required()
      ->type_name("MESH");
  command
      ->add_option("--cells", options->cells,
                   "Cubes along the longest side of the box, or of the boundary constraints' own box")
      ->type_name("N")
      ->capture_default_str();
  const CLI::Option* box = command->add_option("--box", options->box, "Cut the surface at this box")
                               ->type_name("XMIN YMIN ZMIN XMAX YMAX ZMAX");
  command->add_flag("--exhaustive", options->exhaustive,
                    "Look into every cube of the box, also for what no boundary constraint touches");
  command->add_flag("--raw", options->raw, "Leave the triangles as the lattice makes them, needles included");
  command->add_flag("--text", options->text, "Write .ply and .stl as text");
  command->add_option("--memory", options->megabytes, "Refuse what would take more megabytes than this")
      ->type_name("MB")
      ->capture_default_str();
  command->add_flag("--json", options->json, "Print the facts as one JSON object");
  command->footer(
      "The surface is followed from each boundary constraint. The mesh is closed, or cut at the box, and\n"
      "every vertex has the function's own normal.");
  command->callback([options, box] {
    options->has_box = box->count() > 0;
    run(*options);
  });
}

}  // namespace seesaw
