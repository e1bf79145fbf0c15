// The papers' 2D figures as scenes that one opens and drags, each with a sentence on what to try.
//
// Before it: figures/scenes. After it: a dialog; the tour; core/editing/desk.h opens a copy, which has no
// file.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/editing/hit_test.h"
#include "core/scene/document.h"
#include "core/window/texture.h"

namespace seesaw {

struct GalleryEntry {
  const char* scene;  ///< its file in the scenes' folder
  const char* title;
  const char* shows;  ///< one sentence
  const char* try_this;
  bool plate = false;  ///< best seen with the see-saw view
  std::optional<ProfileLine> profile = {};
};

/// In the order of the papers.
const std::vector<GalleryEntry>& gallery();

/// PREFIX/share/seesaw/scenes if the running program is PREFIX/bin/..., else figures/scenes of the source
/// tree.
std::filesystem::path scenes_folder();

/// Throws FileError where the scene cannot be read.
Document<2> read_scene(const GalleryEntry& entry);

/// The gallery as a dialog, with a picture of each scene.
class GalleryDialog {
 public:
  /// Opens at the next frame().
  void ask(std::function<void(const GalleryEntry&)> chosen);
  /// Each frame, outside of all panels. `width`, `height`: the window's; `dark`: pictures to match.
  void frame(double width, double height, double pixel_ratio, bool dark);

 private:
  void draw_pictures(double side, double pixel_ratio, bool dark);

  std::function<void(const GalleryEntry&)> chosen_;
  std::vector<Texture> pictures_;
  double side_ = 0;
  bool dark_ = false;
};

}  // namespace seesaw
