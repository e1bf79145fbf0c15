// figures: makes the papers' figures, each as pictures and measured facts.
//
//     figures list
//     figures make all --out out/figures
//     figures make turk2002-fig05
//     figures render figures/scenes/turk2002-fig05-left.json -o fig05.svg
#include <CLI/CLI.hpp>
#include <chrono>
#include <iostream>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/scene/culprits.h"
#include "core/scene/document_json.h"
#include "core/scene/document_picture.h"
#include "figures/catalog.h"
#include "figures/gallery.h"
#include "figures/output.h"
#include "figures/paths.h"

namespace seesaw {
namespace {

void list_figures() {
  std::size_t width = 0;
  for (const FigureEntry& entry : catalog()) width = std::max(width, entry.id.size());
  for (const FigureEntry& entry : catalog())
    std::cout << entry.id << std::string(width + 2 - entry.id.size(), ' ') << entry.summary << '\n';
}

std::vector<const FigureEntry*> entries_of(const std::vector<std::string>& ids) {
  std::vector<const FigureEntry*> entries;
  for (const std::string& id : ids) {
    if (id == "all") {
      for (const FigureEntry& entry : catalog()) entries.push_back(&entry);
    } else if (const FigureEntry* entry = figure_named(id)) {
      entries.push_back(entry);
    } else {
      throw Error("there is no figure " + id + "; 'figures list' names them all");
    }
  }
  return entries;
}

// 0 when every check holds, 1 when one does not.
int make_figures(const std::vector<std::string>& ids, const std::filesystem::path& folder, double scale,
                 bool update_references) {
  const auto entries = entries_of(ids);
  const bool all = std::find(ids.begin(), ids.end(), "all") != ids.end();
  std::vector<Facts> descriptions;
  FigureContext context = figure_context();
  context.pixels_per_point = scale;
  bool holds = true;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    std::cout << '[' << i + 1 << '/' << entries.size() << "] " << entries[i]->id << std::flush;
    const auto start = std::chrono::steady_clock::now();
    Figure figure;
    try {
      figure = entries[i]->make(context);
    } catch (const MissingPackage& missing) {
      std::cout << "  not made: " << missing.what() << '\n';
      descriptions.push_back(description_of_missing(*entries[i], missing.what()));
      continue;
    }
    write_figure(figure, folder, scale);
    if (update_references) write_reference(figure, reference_folder());
    descriptions.push_back(description_of(figure));
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::cout << "  " << to_text(seconds, 2) << " s";
    for (const Check& check : figure.checks)
      if (!check.holds())
        std::cout << "\n    FAILS: " << check.name << ": " << to_text(check.value) << ", bound "
                  << to_text(check.bound);
    std::cout << '\n';
    holds = holds && figure.holds();
  }
  if (all) {
    write_file(folder / "index.html", gallery_page(descriptions));
    std::cout << "The gallery is " << (folder / "index.html").string() << '\n';
  }
  return holds ? 0 : 1;
}

int render(const std::string& scene, const std::string& output, double size) {
  const Document<2> document = read_document<2>(scene);
  try {
    picture_of(document, fit(document).function, size).save(output);
  } catch (const ConstraintError& error) {
    throw FileError(scene, in_words(error, constraints_of(document)));
  }
  return 0;
}

int run(int argc, char** argv) {
  CLI::App app("Makes the figures of the papers on interpolating implicit surfaces.", "figures");
  app.require_subcommand(1);

  auto* list = app.add_subcommand("list", "name all figures");

  auto* make =
      app.add_subcommand("make", "make figures: pictures, facts and checks; exit status 1 if a check fails");
  std::vector<std::string> ids = {"all"};
  std::string folder = "out/figures";
  double scale = 2;
  make->add_option("ID", ids, "figures to make, or 'all'");
  make->add_option("--out", folder, "the folder for the files")->capture_default_str();
  make->add_option("--scale", scale, "pixels a point")->check(CLI::Range(0.1, 16.0))->capture_default_str();
  bool update_references = false;
  make->add_flag(
      "--update-references", update_references,
      "also replace the pictures in figures/reference that tests compare with; look at them first");

  auto* rendering = app.add_subcommand("render", "draw a 2D scene");
  std::string scene, output;
  double size = usual_picture_size;
  rendering->add_option("SCENE", scene, "a scene file (JSON)")->required();
  rendering->add_option("-o,--output", output, "a .png, .svg or .pdf file")->required();
  rendering->add_option("--size", size, "the longer side, points")
      ->check(CLI::Range(16.0, 8192.0))
      ->capture_default_str();

  if (argc == 1) {
    std::cout << app.help();
    return 0;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  if (list->parsed()) list_figures();
  if (make->parsed()) return make_figures(ids, folder, scale, update_references);
  if (rendering->parsed()) return render(scene, output, size);
  return 0;
}

}  // namespace
}  // namespace seesaw

int main(int argc, char** argv) {
  try {
    return seesaw::run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "figures: " << error.what() << '\n';
    return 2;
  }
}
