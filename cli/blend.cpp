// seesaw blend SCENE... -o SCENE: the soft union of several scenes.
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "cli/commands.h"
#include "cli/output.h"
#include "cli/scene_file.h"
#include "cli/table.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/modelling/blend.h"
#include "core/scene/document_json.h"

namespace seesaw {

namespace {

struct BlendArguments {
  std::vector<std::string> scenes;
  std::string output, kernel;
};

template <int Dim>
std::vector<Document<Dim>> all_of_dimension(const BlendArguments& options, std::vector<AnyDocument> any) {
  std::vector<Document<Dim>> documents;
  for (std::size_t i = 0; i < any.size(); ++i) {
    auto* document = std::get_if<Document<Dim>>(&any[i]);
    if (!document)
      throw FileError(options.scenes[i], "is a scene of " + std::to_string(5 - Dim) + " dimensions, but " +
                                             options.scenes[0] + " has " + std::to_string(Dim));
    documents.push_back(std::move(*document));
  }
  return documents;
}

template <int Dim>
Document<Dim> frame_of(const std::vector<Document<Dim>>& documents) {
  Document<Dim> result;
  result.kernel = documents[0].kernel;
  result.smoothing = documents[0].smoothing;
  for (std::size_t i = 0; i < documents.size(); ++i)
    if (!documents[i].title.empty()) result.title += (result.title.empty() ? "" : " + ") + documents[i].title;
  result.description = "Soft union of " + counted(static_cast<Index>(documents.size()), "object", "objects") +
                       " (Turk & O'Brien 2002, section 6).";
  for (const Document<Dim>& each : documents) {
    if (each.kernel != documents[0].kernel || each.smoothing != documents[0].smoothing)
      std::cerr << "seesaw: note: the scenes differ in kernel or smoothing; the result has those of the first"
                << std::endl;
  }
  return result;
}

template <int Dim>
void run(const BlendArguments& options, std::optional<Kernel> kernel, std::vector<AnyDocument> any) {
  const std::vector<Document<Dim>> documents = all_of_dimension<Dim>(options, std::move(any));
  std::vector<Fit<Dim>> fits;
  for (std::size_t i = 0; i < documents.size(); ++i)
    fits.push_back(fit_scene(options.scenes[i], documents[i]));
  std::vector<BlendObject<Dim>> objects;
  for (std::size_t i = 0; i < documents.size(); ++i)
    objects.push_back({constraints_of(documents[i]), &fits[i].function});
  const Blend<Dim> mixed = blend<Dim>(objects);

  Document<Dim> result = frame_of(documents);
  if (kernel) result.kernel = *kernel;
  for (std::size_t i = 0; i < mixed.constraints.size(); ++i) {
    const auto [object, index] = mixed.origins[i];
    SceneConstraint<Dim> each = documents[object].constraints[index];
    each.constraint = mixed.constraints[i];
    if (!each.constraint.normal) each.highlight_normal = false;
    result.constraints.push_back(std::move(each));
  }
  const Fit<Dim> fitted = fit_scene(options.output, result);
  write_document(options.output, result);

  Table table;
  for (std::size_t i = 0; i < documents.size(); ++i)
    table.emplace_back(options.scenes[i], std::to_string(mixed.kept[i]) + " constraints kept, " +
                                              std::to_string(mixed.dropped[i]) + " in other objects dropped");
  table.emplace_back("together", counted(fitted.report.constraints(), "constraint", "constraints") +
                                     ", max residual " + to_text(fitted.report.max_residual, 3));
  print(aligned_text(table));
}

}  // namespace

void add_blend(CLI::App& program) {
  const auto options = std::make_shared<BlendArguments>();
  CLI::App* command = program.add_subcommand("blend", "Blend scenes into one: a soft union without bulges");
  command->add_option("SCENE", options->scenes, "Documents in JSON, all 2D or all 3D, at least two")
      ->required()
      ->type_name("...");
  command->add_option("-o,--output", options->output, "The scene to write")->required()->type_name("SCENE");
  command
      ->add_option("--kernel", options->kernel,
                   "Of the result: thin_plate_spline, cubic or linear instead of the first scene's")
      ->type_name("K");
  command->footer(
      "Of every scene those constraints are kept that are outside of all others, as their own\n"
      "functions tell (Turk & O'Brien 2002, section 6).");
  command->callback([options] {
    if (options->scenes.size() < 2) throw Error("blend: expected at least two scenes, found one");
    std::optional<Kernel> kernel;
    if (!options->kernel.empty()) {
      kernel = kernel_named(options->kernel);
      if (!kernel)
        throw Error("--kernel: expected thin_plate_spline, cubic or linear, found \"" + options->kernel +
                    "\"");
    }
    refuse_unless_writable(options->output);
    std::vector<AnyDocument> any;
    for (const std::string& scene : options->scenes) any.push_back(read_document(scene));
    if (std::holds_alternative<Document<2>>(any[0]))
      run<2>(*options, kernel, std::move(any));
    else
      run<3>(*options, kernel, std::move(any));
  });
}

}  // namespace seesaw
