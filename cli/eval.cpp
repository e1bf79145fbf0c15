// seesaw eval SCENE POINTS: the function of a scene, and its gradient, at the points of a file.
#include <array>
#include <charconv>
#include <memory>
#include <string>
#include <variant>

#include "cli/commands.h"
#include "cli/output.h"
#include "cli/points_file.h"
#include "cli/scene_file.h"
#include "core/base/file.h"
#include "core/scene/document_json.h"

namespace seesaw {

namespace {

struct EvalArguments {
  std::string scene, points, output;
  bool gradient = false;
};

// Seventeen digits read back to the same double; core/base/text.h says the same thing a string at a time.
void append_number(std::string& text, double value) {
  std::array<char, 32> buffer;
  const auto result =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, 17);
  text.append(buffer.data(), result.ptr);
}

// One line out per line in.
template <int Dim>
std::string text_of(const PointsText<Dim>& input, const Values& values, const Points<Dim>& gradients) {
  std::string text;
  text.reserve(
      static_cast<std::size_t>(values.size() * (1 + gradients.rows() * (gradients.cols() > 0)) * 24));
  auto remark = input.remarks.begin();
  const auto remarks_before = [&](Index i) {
    for (; remark != input.remarks.end() && remark->before == i; ++remark) (text += remark->line) += '\n';
  };
  for (Index i = 0; i < values.size(); ++i) {
    remarks_before(i);
    append_number(text, values[i]);
    if (gradients.cols() > 0)
      for (int d = 0; d < Dim; ++d) append_number(text += ' ', gradients(d, i));
    text += '\n';
  }
  remarks_before(values.size());
  return text;
}

template <int Dim>
void run(const EvalArguments& options, const Document<Dim>& document) {
  const std::string bytes = read_text(options.points);
  const PointsText<Dim> input = parse_points<Dim>(bytes, name_of_input(options.points));
  const Fit<Dim> fitted = fit_scene(options.scene, document);
  const Index n = input.points.cols();
  Values values(n);
  Points<Dim> gradients(Dim, options.gradient ? n : 0);
  if (options.gradient)
    fitted.function.evaluate(input.points, values, gradients);
  else
    fitted.function.evaluate(input.points, values);
  const std::string text = text_of<Dim>(input, values, gradients);
  if (options.output.empty())
    print(text);
  else
    write_file(options.output, text);
}

}  // namespace

void add_eval(CLI::App& program) {
  const auto options = std::make_shared<EvalArguments>();
  CLI::App* command =
      program.add_subcommand("eval", "Evaluate the function of a scene at the points of a file");
  command->add_option("SCENE", options->scene, "A document in JSON, 2D or 3D")->required()->type_name("");
  command->add_option("POINTS", options->points, "A file with one point a line; - is standard input")
      ->required()
      ->type_name("");
  command->add_option("-o,--output", options->output, "Write to this file, all or nothing")
      ->type_name("FILE");
  command->add_flag("--gradient", options->gradient, "Write the gradient behind the value");
  command->footer(
      "A point is 2 or 3 numbers, as the scene has it, with blanks or commas between them.\n"
      "For every line of POINTS one line is written: the value (f > 0 inside, f < 0 outside)\n"
      "with 17 digits, then the gradient, with spaces between them. Empty lines and lines that\n"
      "start with # are written as they are, so that line numbers match.");
  command->callback([options] {
    if (!options->output.empty()) refuse_unless_writable(options->output);
    std::visit([&](const auto& document) { run(*options, document); }, read_document(options->scene));
  });
}

}  // namespace seesaw
