// seesaw check MESH: what a mesh or point cloud is worth, and what had to be repaired to read it.
#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "cli/commands.h"
#include "cli/output.h"
#include "cli/table.h"
#include "core/base/text.h"
#include "core/mesh/mesh_check.h"
#include "core/mesh/mesh_file.h"
#include "core/mesh/self_intersections.h"

namespace seesaw {

namespace {

struct CheckArguments {
  std::string mesh;
  bool json = false, intersections = false;
};

// A number that JSON has no word for is null.
nlohmann::ordered_json json_of(double value) {
  if (std::isfinite(value)) return value;
  return nullptr;
}

nlohmann::ordered_json json_of(const Box<3>& box) {
  const auto corner = [](const Point<3>& p) { return nlohmann::ordered_json{p.x(), p.y(), p.z()}; };
  return {{"min", corner(box.min())}, {"max", corner(box.max())}};
}

nlohmann::ordered_json json_of(const LoadedMesh& loaded, const MeshReport& report,
                               std::optional<Index> intersections) {
  nlohmann::ordered_json json;
  json["kind"] = "mesh";
  json["vertices"] = report.vertices;
  json["faces"] = report.faces;
  json["normals"] = loaded.mesh.has_normals();
  json["closed"] = report.closed;
  json["manifold"] = report.manifold;
  json["oriented"] = report.oriented;
  json["components"] = report.components;
  json["euler_characteristic"] = report.euler_characteristic;
  json["genus"] = report.genus >= 0 ? nlohmann::ordered_json(report.genus) : nullptr;
  json["boundary_edges"] = report.boundary_edges;
  json["boundary_loops"] = report.boundary_loops;
  json["nonmanifold_edges"] = report.nonmanifold_edges;
  json["nonmanifold_vertices"] = report.nonmanifold_vertices;
  json["misoriented_edges"] = report.misoriented_edges;
  json["area"] = json_of(report.area);
  json["volume"] = json_of(report.volume);
  json["smallest_angle"] = report.smallest_angle;
  json["largest_angle"] = report.largest_angle;
  json["box"] = json_of(report.box);
  if (intersections) json["self_intersections"] = *intersections;
  for (const auto& [name, n] : loaded.repairs.named()) json["repairs"][name] = n;
  return json;
}

std::string yes(bool answer, const std::string& otherwise) { return answer ? "yes" : "no: " + otherwise; }

std::string in_words(const Box<3>& box) {
  std::string words;
  for (int d = 0; d < 3; ++d)
    words += (d == 0   ? "x "
              : d == 1 ? ", y "
                       : ", z ") +
             to_text(box.min()[d]) + " to " + to_text(box.max()[d]);
  return words;
}

Table table_of(const LoadedMesh& loaded, const MeshReport& report, std::optional<Index> intersections) {
  Table table;
  table.emplace_back("mesh", counted(report.vertices, "vertex", "vertices") + ", " +
                                 counted(report.faces, "face", "faces") +
                                 (loaded.mesh.has_normals() ? ", with normals" : ""));
  std::string open = counted(report.boundary_edges, "boundary edge", "boundary edges") + " in " +
                     counted(report.boundary_loops, "loop", "loops");
  if (report.boundary_edges == 0) open = "edges with an odd number of faces";
  table.emplace_back("closed", yes(report.closed, open));
  table.emplace_back(
      "manifold", yes(report.manifold,
                      counted(report.nonmanifold_edges, "edge", "edges") + " of more than two faces, " +
                          counted(report.nonmanifold_vertices, "vertex", "vertices") + " where fans meet"));
  table.emplace_back("oriented", yes(report.oriented, counted(report.misoriented_edges, "edge", "edges") +
                                                          " whose faces disagree"));
  table.emplace_back("components", std::to_string(report.components));
  table.emplace_back("Euler characteristic", std::to_string(report.euler_characteristic));
  if (report.genus >= 0) table.emplace_back("genus", std::to_string(report.genus));
  table.emplace_back("area", to_text(report.area));
  if (!std::isnan(report.volume)) table.emplace_back("volume", to_text(report.volume));
  table.emplace_back(
      "angles", to_text(report.smallest_angle, 3) + " to " + to_text(report.largest_angle, 3) + " degrees");
  table.emplace_back("box", in_words(report.box));
  if (intersections)
    table.emplace_back("self-intersections", counted(*intersections, "pair of faces", "pairs of faces"));
  const std::vector<std::string> repairs = loaded.repairs.in_words();
  if (repairs.empty()) table.emplace_back("repairs", "none");
  for (std::size_t i = 0; i < repairs.size(); ++i) table.emplace_back(i == 0 ? "repairs" : "", repairs[i]);
  return table;
}

// Normals that say something: not zero, not NaN.
Index known_normals(const PointCloud& cloud) {
  Index known = 0;
  for (Index i = 0; i < cloud.normals.cols(); ++i) known += cloud.normals.col(i).squaredNorm() > 0;
  return known;
}

void run(const CheckArguments& options) {
  const Model model = read_model(options.mesh);
  if (const auto* loaded = std::get_if<LoadedMesh>(&model)) {
    const MeshReport report = check_mesh(loaded->mesh);
    std::optional<Index> intersections;
    if (options.intersections) intersections = static_cast<Index>(self_intersections(loaded->mesh).size());
    print(options.json ? json_of(*loaded, report, intersections).dump(2) + "\n"
                       : aligned_text(table_of(*loaded, report, intersections)));
    return;
  }
  const auto& cloud = std::get<PointCloud>(model);
  const Box<3> box = bounding_box_of<3>(cloud.points);
  if (options.json) {
    const nlohmann::ordered_json json = {{"kind", "point_cloud"},
                                         {"points", cloud.points.cols()},
                                         {"normals", known_normals(cloud)},
                                         {"box", json_of(box)}};
    print(json.dump(2) + "\n");
  } else {
    print(aligned_text({{"points", std::to_string(cloud.points.cols())},
                        {"normals", std::to_string(known_normals(cloud))},
                        {"box", in_words(box)}}));
  }
}

}  // namespace

void add_check(CLI::App& program) {
  const auto options = std::make_shared<CheckArguments>();
  CLI::App* command = program.add_subcommand("check", "Read a mesh or point cloud and say what it is worth");
  command
      ->add_option("MESH", options->mesh,
                   "A model: OBJ, PLY, OFF, STL, glTF ..., or points: .xyz, .pwn, .csv, PLY")
      ->required()
      ->type_name("");
  command->add_flag("--json", options->json, "Print one JSON object instead of a table");
  command->add_flag("--intersections", options->intersections,
                    "Look for faces that run through one another; takes longer");
  command->footer(
      "The file is repaired in memory (welded, oriented ...), and what was repaired is listed; the\n"
      "facts are those of the repaired mesh. In JSON, what does not exist is null: the volume of\n"
      "an open mesh, the genus of one that is not closed, manifold and oriented.");
  command->callback([options] { run(*options); });
}

}  // namespace seesaw
