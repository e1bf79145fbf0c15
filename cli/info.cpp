// seesaw info SCENE: what a scene asks for, and what its fit has to say; for people as a table, for programs
// as JSON.
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
#include "cli/scene_file.h"
#include "cli/table.h"
#include "core/base/text.h"
#include "core/rbf/energy.h"
#include "core/scene/document_json.h"
#include "core/scene/picture.h"

namespace seesaw {

namespace {

/// The curve of a 2D scene in its view box; there is none in 3D.
struct CurveFacts {
  Box<2> view;
  Contour curve;
};

std::optional<CurveFacts> curve_facts(const Document<2>& document, const Field<2>& field) {
  const Box<2> view = view_box(document, field);
  return CurveFacts{view, contour(document, field, view)};
}
std::optional<CurveFacts> curve_facts(const Document<3>&, const Field<3>&) { return std::nullopt; }

// E(f) is the integral of all derivatives of this order, squared (core/rbf/energy.h); 2.5 is a fractional
// one.
double energy_order(Kernel kernel, int dimension) { return (dimension + growth_of(kernel)) / 2; }

template <int Dim>
std::string energy_in_words(Kernel kernel) {
  const double order = energy_order(kernel, Dim);
  std::string words = "integral of the squared derivatives of order " + to_text(order);
  if (order == 2.0) words += Dim == 2 ? ": eq. 3 of the paper" : ": eq. 3 of the paper, in 3D";
  if (order != std::floor(order)) words += " (Duchon's semi-norm)";
  return words;
}

// What kept the centers from fixing the polynomial.
template <int Dim>
std::string degenerate_in_words(Index rank) {
  if (rank == 1) return "all centers stand at one point; the function is constant";
  if (rank == 2) return "all centers lie on one line; the function is the same on all sides of it";
  return Dim == 3 ? "all centers lie in one plane; the polynomial does not change across it" : "";
}

template <int Dim>
nlohmann::ordered_json json_of(const Document<Dim>& document, const Fit<Dim>& fitted,
                               const std::optional<CurveFacts>& facts) {
  const FitReport& report = fitted.report;
  nlohmann::ordered_json json;
  json["title"] = document.title;
  json["dimension"] = Dim;
  json["kernel"] = name_of(report.kernel);
  json["smoothing"] = report.smoothing;
  json["constraints"] = {{"boundary", report.boundary},
                         {"interior", report.interior},
                         {"exterior", report.exterior},
                         {"normal", report.normal},
                         {"total", report.constraints()}};
  json["rows"] = report.rows;
  json["merged"] = report.merged;
  json["polynomial_rank"] = report.polynomial_rank;
  json["degenerate"] = report.degenerate;
  json["max_residual"] = report.max_residual;
  json["reciprocal_condition"] = report.reciprocal_condition;
  json["energy"] = report.energy;
  json["energy_order"] = energy_order(report.kernel, Dim);
  json["weights_sum_abs"] = fitted.function.weights().cwiseAbs().sum();
  json["fit_seconds"] = report.seconds;
  if (facts) {
    const auto& [view, curve] = *facts;
    json["view"] = {{"min", {view.min().x(), view.min().y()}}, {"max", {view.max().x(), view.max().y()}}};
    json["components"] = curve.components;
    json["closed"] = curve.closed;
    json["area"] = curve.area;
    json["length"] = curve.length;
    json["complete"] = curve.complete;
  }
  return json;
}

template <int Dim>
Table table_of(const Document<Dim>& document, const Fit<Dim>& fitted,
               const std::optional<CurveFacts>& facts) {
  const FitReport& report = fitted.report;
  Table table;
  if (!document.title.empty()) table.emplace_back("title", document.title);
  table.emplace_back("dimension", std::to_string(Dim));
  table.emplace_back("kernel", std::string(name_of(report.kernel)));
  table.emplace_back("smoothing", report.smoothing == 0 ? "0 (interpolates)" : to_text(report.smoothing));
  table.emplace_back("constraints", std::to_string(report.constraints()) + ": " +
                                        std::to_string(report.boundary) + " boundary, " +
                                        std::to_string(report.interior) + " interior, " +
                                        std::to_string(report.exterior) + " exterior, " +
                                        std::to_string(report.normal) + " normal");
  table.emplace_back("centers",
                     std::to_string(report.rows) +
                         (report.merged ? ", after merging " + std::to_string(report.merged) : ""));
  if (report.degenerate) table.emplace_back("degenerate", degenerate_in_words<Dim>(report.polynomial_rank));
  table.emplace_back("max residual", to_text(report.max_residual, 3));
  table.emplace_back("reciprocal condition", to_text(report.reciprocal_condition, 3));
  table.emplace_back("energy", to_text(report.energy) + ", " + energy_in_words<Dim>(report.kernel));
  table.emplace_back("sum of |weights|", to_text(fitted.function.weights().cwiseAbs().sum()));
  table.emplace_back("fit", to_text(report.seconds, 3) + " s");
  if (facts) {
    const auto& [view, curve] = *facts;
    table.emplace_back("view box", "x " + to_text(view.min().x()) + " to " + to_text(view.max().x()) +
                                       ", y " + to_text(view.min().y()) + " to " + to_text(view.max().y()));
    table.emplace_back("curve in it", counted(curve.components, "component", "components") + ", " +
                                          std::to_string(curve.closed) + " closed" +
                                          (curve.complete ? "" : " (coarse: f varies too much)"));
    table.emplace_back("area inside", to_text(curve.area));
    table.emplace_back("length", to_text(curve.length));
  }
  return table;
}

template <int Dim>
void run(const std::string& scene, bool json, const Document<Dim>& document) {
  const Fit<Dim> fitted = fit_scene(scene, document, true);
  const auto facts = curve_facts(document, fitted.function);
  print(json ? json_of(document, fitted, facts).dump(2) + "\n"
             : aligned_text(table_of(document, fitted, facts)));
}

}  // namespace

void add_info(CLI::App& program) {
  struct Options {
    std::string scene;
    bool json = false;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("info", "Fit a scene and print what there is to know about it");
  command->add_option("SCENE", options->scene, "A document in JSON, 2D or 3D")->required()->type_name("");
  command->add_flag("--json", options->json, "Print one JSON object instead of a table");
  command->footer("Of a 2D scene's curve, what lies in the view box is measured.");
  command->callback([options] {
    std::visit([&](const auto& document) { run(options->scene, options->json, document); },
               read_document(options->scene));
  });
}

}  // namespace seesaw
