// seesaw raytrace SCENE... -o PNG: surfaces as a picture, whole or cut by one another.

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "cli/commands.h"
#include "cli/output.h"
#include "cli/scene_file.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/image/png.h"
#include "core/mesh/mesh_file.h"
#include "core/raytrace/csg_expression.h"
#include "core/raytrace/evaluation_counts.h"
#include "core/raytrace/heuristic_tracer.h"
#include "core/raytrace/render.h"
#include "core/raytrace/rigorous_tracer.h"
#include "core/scene/document_json.h"

namespace seesaw {

namespace {

struct RaytraceArguments {
  std::vector<std::string> inputs;
  std::string output, evaluations, csg, size = "800x600", method = "rigorous", floor = "plain";
  std::string eye, target, up, fov;
  int samples = 4;
  double mirror = 0;
};

void need_png(const std::string& path) {
  if (ending_of(path) != ".png") throw Error(path + ": expected a name that ends in .png");
  refuse_unless_writable(path);
}

Point<3> triple(const char* flag, const std::string& text) {
  Point<3> result;
  std::size_t begin = 0;
  for (int d = 0; d < 3; ++d) {
    const std::size_t end = d < 2 ? text.find(',', begin) : text.size();
    const std::optional<double> number =
        end == std::string::npos ? std::nullopt : parse_number(text.substr(begin, end - begin));
    if (!number || !std::isfinite(*number))
      throw Error(std::string(flag) + ": expected three numbers X,Y,Z, found \"" + text + "\"");
    result[d] = *number;
    begin = end + 1;
  }
  return result;
}

std::pair<int, int> picture_size(const std::string& text) {
  const std::size_t cross = text.find('x');
  const auto whole = [&](const std::string& part) {
    const bool digits = !part.empty() && part.size() < 6 &&
                        std::all_of(part.begin(), part.end(), [](char c) { return c >= '0' && c <= '9'; });
    return digits ? std::stoi(part) : 0;
  };
  const int width = cross == std::string::npos ? 0 : whole(text.substr(0, cross));
  const int height = cross == std::string::npos ? 0 : whole(text.substr(cross + 1));
  if (width < 1 || height < 1 || width > 16384 || height > 16384)
    throw Error("--size: expected WIDTHxHEIGHT in pixels, 1 to 16384 each, found \"" + text + "\"");
  return {width, height};
}

std::shared_ptr<const SurfaceTracer> tracer_of(std::shared_ptr<const Field<3>> field,
                                               const std::string& method) {
  if (method == "heuristic") return std::make_shared<HeuristicTracer>(std::move(field));
  return std::make_shared<RigorousTracer>(std::move(field));
}

Floor::Look floor_look(const std::string& name) {
  if (name == "none") return Floor::Look::none;
  if (name == "checker") return Floor::Look::checker;
  if (name == "plain") return Floor::Look::plain;
  throw Error("--floor: expected plain, checker or none, found \"" + name + "\"");
}

// The flags' camera: what they leave open comes from `own`, the document's, or from framing the scene.
PinholeCamera camera_of(const RaytraceArguments& options, const Scene& scene,
                        const std::optional<PinholeCamera>& own, double aspect) {
  Framing framing;
  framing.aspect = aspect;
  if (!options.up.empty()) {
    framing.up = triple("--up", options.up);
    if (framing.up.isZero()) throw Error("--up: expected a direction, found " + options.up);
    // From the same side above as for the usual up.
    framing.direction =
        Eigen::Quaterniond::FromTwoVectors(Point<3>::UnitY(), framing.up) * Framing().direction;
  }
  if (!options.fov.empty()) {
    const std::optional<double> fov = parse_number(options.fov);
    if (!fov || !(*fov > 0 && *fov < 180))
      throw Error("--fov: expected degrees between 0 and 180, found \"" + options.fov + "\"");
    framing.field_of_view = *fov;
  }
  PinholeCamera camera = own ? *own : frame(scene, framing);
  if (!options.up.empty()) camera.up = framing.up;
  if (!options.fov.empty()) camera.field_of_view = framing.field_of_view;
  if (!options.eye.empty()) camera.eye = triple("--eye", options.eye);
  if (!options.target.empty()) camera.target = triple("--target", options.target);
  if (camera.eye == camera.target) throw Error("the camera's eye and target are the same point");
  return camera;
}

void run(const RaytraceArguments& options) {
  need_png(options.output);
  if (!options.evaluations.empty()) need_png(options.evaluations);
  const auto [width, height] = picture_size(options.size);
  if (options.method != "rigorous" && options.method != "heuristic")
    throw Error("--method: expected rigorous or heuristic, found \"" + options.method + "\"");
  const Floor::Look look = floor_look(options.floor);
  if (!(options.mirror >= 0 && options.mirror <= 1))
    throw Error("--mirror: expected 0 to 1, found " + to_text(options.mirror));
  if (options.samples < 1 || options.samples > 1024)
    throw Error("--samples: expected 1 to 1024, found " + std::to_string(options.samples));

  Scene scene;
  std::optional<PinholeCamera> own;
  for (std::size_t i = 0; i < options.inputs.size(); ++i) {
    const std::string& path = options.inputs[i];
    const Material material = {
        .color = options.inputs.size() == 1 ? surface::clay : surface::of_object(static_cast<int>(i)),
        .mirror = options.mirror};
    if (ending_of(path) != ".json") {
      if (!options.csg.empty()) throw FileError(path, "is not a scene (.json), and --csg cuts scenes only");
      scene.meshes.push_back({.mesh = read_mesh(path).mesh, .material = material});
      continue;
    }
    const AnyDocument any = read_document(path);
    if (!std::holds_alternative<Document<3>>(any))
      throw FileError(path, "is a 2D scene; rays are traced through 3D scenes (a curve is drawn by contour)");
    const Document<3>& document = std::get<Document<3>>(any);
    auto field = std::make_shared<Interpolant<3>>(fit_scene(path, document).function);
    scene.solids.push_back(Solid(tracer_of(std::move(field), options.method), material));
    if (document.camera && options.inputs.size() == 1)
      own = PinholeCamera{.eye = document.camera->position,
                          .target = document.camera->target,
                          .up = document.camera->up,
                          .field_of_view = document.camera->field_of_view};
  }
  if (!options.csg.empty()) {
    try {
      scene.solids = {csg_solid(options.csg, scene.solids)};
    } catch (const Error& error) {
      throw Error(std::string("--csg: ") + error.what());
    }
  }
  const Box<3> subject = bounding_box(scene);
  if (subject.isEmpty()) throw Error("there is nothing to see: no surface within the scene's box");
  const PinholeCamera camera = camera_of(options, scene, own, static_cast<double>(width) / height);
  if (look != Floor::Look::none) scene.floor = floor_under(subject, camera.up, look);

  const RenderOptions render_options = {.width = width, .height = height, .samples = options.samples};
  write_png(options.output, render(scene, camera, render_options, percent("ray tracing")));
  std::string report = to_flags(camera) + "\n";
  if (!options.evaluations.empty()) {
    const EvaluationCounts counts =
        count_evaluations(scene, camera, render_options, percent("counting evaluations"));
    write_png(options.evaluations, heat_image(counts));
    report += "evaluations: " + std::to_string(counts.total()) + " in all, at most " +
              std::to_string(counts.largest()) + " for a pixel\n";
  }
  print(report);
}

}  // namespace

void add_raytrace(CLI::App& program) {
  const auto options = std::make_shared<RaytraceArguments>();
  CLI::App* command = program.add_subcommand("raytrace", "Make a picture of 3D scenes and meshes");
  command->add_option("SCENE", options->inputs, "3D documents in JSON, or meshes (.obj, .ply, .stl, .off)")
      ->required()
      ->type_name("...");
  command->add_option("-o,--output", options->output, "A name that ends in .png")
      ->required()
      ->type_name("FILE");
  command
      ->add_option(
          "--csg", options->csg,
          "One solid made of the scenes, by their numbers from 0: | unites, & intersects, - subtracts")
      ->type_name("EXPR");
  command->add_option("--size", options->size, "Of the picture, pixels")
      ->type_name("WIDTHxHEIGHT")
      ->capture_default_str();
  command->add_option("--samples", options->samples, "Rays a pixel, 1 to 1024: more are smoother")
      ->type_name("N")
      ->capture_default_str();
  command->add_option("--floor", options->floor, "plain, checker or none")
      ->type_name("LOOK")
      ->capture_default_str();
  command->add_option("--mirror", options->mirror, "How much the surfaces reflect, 0 to 1")
      ->type_name("PART")
      ->capture_default_str();
  command
      ->add_option("--method", options->method,
                   "rigorous: no ray can miss the surface; heuristic: as in the paper, by 2,000 samples")
      ->type_name("NAME")
      ->capture_default_str();
  command
      ->add_option("--evaluations", options->evaluations,
                   "Also a picture of how often each pixel's ray had the functions evaluated")
      ->type_name("FILE");
  command->add_option("--eye", options->eye, "Where the camera stands")->type_name("X,Y,Z");
  command->add_option("--target", options->target, "What is in the middle of the picture")
      ->type_name("X,Y,Z");
  command->add_option("--up", options->up, "What is up")->type_name("X,Y,Z");
  command->add_option("--fov", options->fov, "From the picture's bottom to its top")->type_name("DEGREES");
  command->footer(
      "Without flags the camera is the document's own, or frames what is to be seen. It is printed as\n"
      "flags, so that a picture can be taken again from the same place. The heat picture is pale where\n"
      "there were no evaluations and darkest where there were most; its numbers are printed.");
  command->callback([options] { run(*options); });
}

}  // namespace seesaw
