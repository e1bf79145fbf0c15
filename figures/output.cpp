#include "figures/output.h"

#include "core/base/error.h"
#include "core/base/file.h"
#include "figures/compose.h"

namespace seesaw {

namespace {

std::string panel_file(const Figure& figure, const Panel& panel) {
  return figure.id + "-" + panel.name + ".png";
}

const char* sign_of(Check::Relation relation) {
  switch (relation) {
    case Check::Relation::at_most:
      return "<=";
    case Check::Relation::at_least:
      return ">=";
    case Check::Relation::equal:
      return "==";
  }
  return "?";
}

}  // namespace

Facts description_of(const Figure& figure) {
  Facts result;
  result["figure"] = figure.id;
  result["paper"] = figure.paper;
  result["title"] = figure.title;
  result["shows"] = figure.shows;
  result["caption"] = figure.caption;
  result["panels"] = Facts::array();
  for (const Panel& panel : figure.panels)
    result["panels"].push_back({{"name", panel.name},
                                {"title", panel.title},
                                {"png", panel_file(figure, panel)},
                                {"facts", panel.facts}});
  result["checks"] = Facts::array();
  for (const Check& check : figure.checks)
    result["checks"].push_back({{"name", check.name},
                                {"value", check.value},
                                {"relation", sign_of(check.relation)},
                                {"bound", check.bound},
                                {"holds", check.holds()}});
  result["holds"] = figure.holds();
  return result;
}

Facts description_of_missing(const FigureEntry& entry, const std::string& reason) {
  Facts result;
  result["figure"] = entry.id;
  result["title"] = entry.summary;
  result["panels"] = result["checks"] = Facts::array();
  result["missing"] = reason;
  return result;
}

void write_figure(const Figure& figure, const std::filesystem::path& folder, double scale) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw FileError(folder.string(), "cannot make this folder: " + error.message());
  compose(figure).save(folder / (figure.id + ".png"), scale);
  for (const Panel& panel : figure.panels)
    compose_panel(panel).save(folder / panel_file(figure, panel), scale);
  write_file(folder / (figure.id + ".json"), description_of(figure).dump(2) + "\n");
}

void write_reference(const Figure& figure, const std::filesystem::path& folder) {
  compose(figure).save(folder / (figure.id + ".png"), 1);
}

}  // namespace seesaw
