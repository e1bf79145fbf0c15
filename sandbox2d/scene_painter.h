// The picture of the scene in the window: at once while something moves, as fine as in print when it rests.
//
// The same draw_document that makes the figures draws both. What it costs is evaluations of f. A draft of
// many centers is drawn from a grid with as many points as fit into a few milliseconds, measured on the draft
// before; the fine picture, which takes as long as it takes, is made by another thread while the draft is
// shown.
//
//     painter.paint(what, now);                      // every frame; does nothing where nothing changed
//     texture.upload(pixels of painter.picture().raster)
//
// Before it: a document, its function and a view (core/editing/desk.h). After it: overlay.h draws what is in
// hand over it; numbers in the side panel.
#pragma once

#include <future>
#include <memory>

#include "core/image/raster.h"
#include "core/rbf/interpolant.h"
#include "core/scene/picture.h"

namespace seesaw {

/// All that the picture depends on.
struct SceneWish {
  /// With the display that is asked for; its view is not looked at.
  Document<2> document;
  /// Grows with every change of the document.
  std::uint64_t revision = 0;
  /// Null for none: constraints alone are drawn.
  std::shared_ptr<const Interpolant<2>> function;
  /// Another shape, dashed; null for none. Compared by address: keep it while it is shown.
  std::shared_ptr<const Interpolant<2>> other;
  /// A page of one point a logical pixel.
  PlanView view;
  double pixel_ratio = 1;
  /// Symbols, lines and letters are this many times as large.
  double scale = 1;

  bool operator==(const SceneWish& b) const;
};

struct ScenePicture {
  Raster raster;
  Contour curve;  ///< in what is seen
  PlanView view;
  bool fine = false;
  double seconds = 0;           ///< what it took
  double sampling_seconds = 0;  ///< of it, the grid
};

struct SceneDetail {
  PictureDetail picture = {};
  /// Cells across, where the picture is drawn from a grid of the function (core/implicit/grid_field.h); 0 for
  /// the function itself.
  int grid_columns = 0;
};

/// Draws what is wished for, as fine as `detail` says.
ScenePicture paint_scene(const SceneWish& wish, const SceneDetail& detail, Raster reuse = {});

/// The printed page's; with fewer samples of the colors where thousands of centers would take seconds.
SceneDetail fine_detail(const SceneWish& wish);

class ScenePainter {
 public:
  /// `draft_seconds` is what a draft may take; fine pictures come when nothing changed for `rest` seconds.
  /// `arrived` is called from another thread when one is done.
  explicit ScenePainter(std::function<void()> arrived = {}, double draft_seconds = 0.008, double rest = 0.12)
      : arrived_(std::move(arrived)), draft_seconds_(draft_seconds), rest_(rest) {}
  ~ScenePainter();

  /// Makes picture() that of `wish`, or begins to. `now` in seconds. `moving` puts the fine one off. With
  /// `wait` a fine one that is due is there on return: for scripts, whose pictures do not depend on time.
  void paint(SceneWish wish, double now, bool moving, bool wait);
  /// Whether paint() has nothing to draw for it, its document's constraints not looked at.
  bool shows(const SceneWish& wish) const { return wish_ && *wish_ == wish; }
  const ScenePicture& picture() const { return picture_; }
  /// What the last draft took.
  double draft_seconds() const { return draft_took_; }
  /// Grows with every new picture.
  std::uint64_t number() const { return number_; }
  /// True while something is still to come: the program should not fall asleep.
  bool busy() const { return !picture_.fine; }
  /// How a draft of so many centers is drawn at present.
  SceneDetail draft_detail(const SceneWish& wish) const;

 private:
  void take(ScenePicture picture);
  void collect(bool wait);

  std::function<void()> arrived_;
  double draft_seconds_, rest_;
  std::optional<SceneWish> wish_;
  ScenePicture picture_;
  Raster spare_;
  std::uint64_t number_ = 0;
  double changed_ = 0, draft_took_ = 0;
  double seconds_a_sum_ = 2e-9;  // of one kernel at one point, all cores together
  std::future<ScenePicture> fine_;
  std::optional<SceneWish> fine_wish_;
};

}  // namespace seesaw
