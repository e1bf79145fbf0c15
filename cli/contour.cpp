// seesaw contour SCENE -o FILE: the curve of a 2D scene, as a picture or as numbers.
#include <array>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "cli/commands.h"
#include "cli/scene_file.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/mesh/polyline.h"
#include "core/scene/document_json.h"
#include "core/scene/document_picture.h"

namespace seesaw {

namespace {

struct ContourArguments {
  std::string scene, output;
  std::array<std::string, 4> box;
  bool has_box = false, has_cells = false;
  double size = 400;
  int cells = ContourOptions().cells;
  bool field = false, isolines = false;
};

Box<2> parse_box(const std::array<std::string, 4>& words) {
  std::array<double, 4> x{};
  for (std::size_t i = 0; i < 4; ++i) {
    const std::optional<double> number = parse_number(words[i]);
    if (!number || !std::isfinite(*number))
      throw Error("--box: expected four finite numbers XMIN YMIN XMAX YMAX, found \"" + words[i] + "\"");
    x[i] = *number;
  }
  if (!(x[0] < x[2] && x[1] < x[3]))
    throw Error("--box: expected XMIN below XMAX and YMIN below YMAX, found " + words[0] + " " + words[1] +
                " " + words[2] + " " + words[3]);
  if (!std::isfinite(x[2] - x[0]) || !std::isfinite(x[3] - x[1]))
    throw Error("--box: its sides are longer than a double can say");
  return {Point<2>(x[0], x[1]), Point<2>(x[2], x[3])};
}

void run(const ContourArguments& options) {
  const std::string ending = ending_of(options.output);
  const bool picture = ending == ".svg" || ending == ".png" || ending == ".pdf";
  if (!picture && ending != ".csv")
    throw Error(options.output + ": expected a name that ends in .svg, .png, .pdf or .csv");
  if (picture && options.has_cells) throw Error("--cells is for .csv: a picture finds its own resolution");
  if (!(options.size >= 10 && options.size <= 10000))
    throw Error("--size: expected 10 to 10000 points, found " + to_text(options.size));
  if (options.cells < 1 || options.cells > 8192)
    throw Error("--cells: expected 1 to 8192, found " + std::to_string(options.cells));
  refuse_unless_writable(options.output);
  std::optional<Box<2>> box;
  if (options.has_box) box = parse_box(options.box);

  const AnyDocument any = read_document(options.scene);
  if (!std::holds_alternative<Document<2>>(any))
    throw FileError(options.scene, "is a 3D scene; a contour is a curve in the plane and needs a 2D scene");
  Document<2> document = std::get<Document<2>>(any);
  const Fit<2> fitted = fit_scene(options.scene, document);
  document.display.view = box ? *box : view_box(document, fitted.function);
  document.display.field |= options.field;
  document.display.isolines |= options.isolines;

  Contour curve;
  if (picture) {
    Canvas canvas = sheet_for(*document.display.view, options.size);
    curve = draw_document(canvas, canvas.bounds(), document, fitted.function).curve;
    canvas.save(options.output);
  } else {
    curve = contour(document, fitted.function, *document.display.view, {.cells = options.cells});
    write_file(options.output, to_csv(curve.polylines));
  }
  // No failure, and yet most likely not what was wanted.
  if (curve.components == 0)
    std::cerr << "seesaw: note: no part of the curve lies in the view box" << std::endl;
  if (!curve.complete)
    std::cerr << "seesaw: note: the curve is coarser than asked for: f varies too much" << std::endl;
}

}  // namespace

void add_contour(CLI::App& program) {
  const auto options = std::make_shared<ContourArguments>();
  CLI::App* command =
      program.add_subcommand("contour", "Draw the curve of a 2D scene, or write it as numbers");
  command->add_option("SCENE", options->scene, "A 2D document in JSON")->required()->type_name("");
  command->add_option("-o,--output", options->output, "A name that ends in .svg, .png, .pdf or .csv")
      ->required()
      ->type_name("FILE");
  const CLI::Option* box =
      command
          ->add_option("--box", options->box, "Show this part of the scene instead of the scene's own view")
          ->type_name("XMIN YMIN XMAX YMAX");
  command
      ->add_option("--size", options->size,
                   "Longer side of a picture in points, 1/72 inch; a .png has two pixels a point")
      ->type_name("POINTS")
      ->capture_default_str();
  const CLI::Option* cells =
      command->add_option("--cells", options->cells, "Lattice cells along the box's longer side, for .csv")
          ->type_name("N")
          ->capture_default_str();
  command->add_flag("--field", options->field, "Show the function's value as color, whatever the scene says");
  command->add_flag("--isolines", options->isolines, "Show curves of equal value, whatever the scene says");
  command->footer(
      "A .csv has the line polyline,closed,x,y and then one line a vertex: polylines are counted\n"
      "from 0, closed is 0 or 1, and the inside lies on the left.");
  command->callback([options, box, cells] {
    options->has_box = box->count() > 0;
    options->has_cells = cells->count() > 0;
    run(*options);
  });
}

}  // namespace seesaw
