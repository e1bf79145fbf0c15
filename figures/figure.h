// What a figure is: panels that draw themselves, facts that were measured, checks that must hold.
//
// Before it: one file a figure, figures/<id>.cpp, which fits scenes and measures them.
// After it: figures/compose.h lays the panels out, figures/output.h writes PNG and JSON, figures/gallery.h
// the page.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/image/canvas.h"

namespace seesaw {

/// Measured numbers by name. The names that several figures share are listed in figures/facts.h.
using Facts = nlohmann::ordered_json;

/// A claim of the paper with the number that decides it.
struct Check {
  enum class Relation { at_most, at_least, equal };

  std::string name;
  double value = 0;
  double bound = 0;
  Relation relation = Relation::at_most;

  bool holds() const;  // false for a value that is not a number
};

Check at_most(std::string name, double value, double bound);
Check at_least(std::string name, double value, double bound);
Check equal(std::string name, double value, double wanted);

/// One picture of a figure; also a PNG of its own.
struct Panel {
  std::string name = {};             ///< "left"; part of the file's name
  std::string title = {};            ///< set above the picture
  double width = 380, height = 380;  ///< of the picture, points
  std::function<void(Canvas&, const Rect&)> draw = {};
  Facts facts = Facts::object();
};

struct Figure {
  std::string id = {};     ///< "turk2002-fig01"
  std::string paper = {};  ///< where the figure is from
  std::string title = {};
  std::string shows = {};    ///< what the paper says that it shows
  std::string caption = {};  ///< what ours shows, with measured numbers; set below the panels
  std::vector<Panel> panels = {};
  std::size_t columns = 0;  ///< panels side by side; 0 for all of them
  std::vector<Check> checks = {};
  /// The picture shows this machine's times, so no two are alike: tests compare its layout only.
  bool shows_times = false;

  bool holds() const;
};

/// A figure wants a model from a package that is not installed. The others are made all the same.
class MissingPackage : public Error {
 public:
  MissingPackage(const std::string& package, const std::filesystem::path& file)
      : Error("needs the Debian package " + package + " (no file " + file.string() +
              "); ./run setup installs it") {}
};

/// What every figure is given.
struct FigureContext {
  std::filesystem::path scenes;    ///< the folder of scene files
  std::filesystem::path data;      ///< the folder of polygon models
  std::filesystem::path sessions;  ///< the folder of recorded editing sessions
  /// Of ray-traced pictures; drawings are sharp at any size.
  double pixels_per_point = 2;
  Progress progress = {};
};

/// How the catalog knows a figure before making it.
struct FigureEntry {
  std::string id;
  std::string summary;
  Figure (*make)(const FigureContext&);
};

}  // namespace seesaw
