// A sheet of paper to draw on, and the files it turns into.
//
// A Canvas remembers its marks and paints them only when a picture is asked for; so one drawing gives the
// PNG for the slide, the SVG for the web and the PDF for the paper, and all three agree. The same calls
// always give the same bytes. The unit is the point, 1/72 inch; x runs right and y *down* from the top left
// corner.
//
//     Canvas canvas(200, 100);
//     canvas.fill_circle({50, 50}, 20, theme::moved);
//     canvas.text({80, 50}, "a new constraint", {.size = 11, .vertical = VerticalAlign::middle});
//     canvas.save("figure.pdf");
//
// Marks with coordinates that are not numbers are left out (a polyline breaks there); marks far outside the
// sheet are cut off exactly. So a curve that runs off to infinity harms nothing.
//
// Before it: points on the page, from whoever maps a scene to it (chart.h, height_plot.h, a figure).
// After it: Image (image.h), pixels that are kept and painted again (raster.h), bytes of SVG or PDF, or a
// file.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/types.h"
#include "core/image/image.h"
#include "core/image/rect.h"
#include "core/image/text_style.h"
#include "core/image/theme.h"

namespace seesaw {

enum class Cap { round, butt };
enum class FillRule { even_odd, winding };
enum class Sampling { smooth, nearest };

/// How a line is drawn.
struct Stroke {
  Color color = theme::ink;
  double width = 1;               ///< points; nothing is drawn unless > 0
  std::vector<double> dash = {};  ///< lengths on, off, on, ... in points; empty for a solid line
  Cap cap = Cap::round;           ///< corners are round too
};

class Canvas {
 public:
  /// A sheet of width x height points, > 0. A background with alpha 0 leaves the paper transparent. Throws
  /// Error for a size that is not a positive number.
  Canvas(double width, double height, const Color& background = theme::paper);
  ~Canvas();
  Canvas(Canvas&&) noexcept;
  Canvas& operator=(Canvas&&) noexcept;

  double width() const;
  double height() const;
  /// The whole sheet.
  Rect bounds() const { return {0, 0, width(), height()}; }

  // Lines. Points are 2 x N, one a column.

  void line(const Point<2>& from, const Point<2>& to, const Stroke& stroke = {});
  void polyline(const PointsRef<2>& points, const Stroke& stroke = {});
  /// Closed: the last point is joined to the first.
  void polygon(const PointsRef<2>& points, const Stroke& stroke = {});
  /// The outlines of several closed rings as one mark, so that a translucent stroke does not overlap
  /// itself.
  void rings(const std::vector<Points<2>>& rings, const Stroke& stroke = {});
  void circle(const Point<2>& center, double radius, const Stroke& stroke = {});
  void rectangle(const Rect& rect, const Stroke& stroke = {});
  /// A line with a filled, pointed head of `head` points length that ends exactly at `to`.
  void arrow(const Point<2>& from, const Point<2>& to, const Stroke& stroke = {}, double head = 7);

  // Areas.

  void fill_polygon(const PointsRef<2>& points, const Color& color);
  /// Several closed rings as one area. Under `even_odd` a ring within a ring is a hole; under `winding` it
  /// is one when it turns the other way.
  void fill_rings(const std::vector<Points<2>>& rings, const Color& color,
                  FillRule rule = FillRule::even_odd);
  void fill_circle(const Point<2>& center, double radius, const Color& color);
  /// `corner` is the radius of rounded corners, points.
  void fill_rectangle(const Rect& rect, const Color& color, double corner = 0);
  /// Fills and strokes in one color: neighboring facets then show no hairline of background between them.
  void facet(const PointsRef<2>& points, const Color& color, double overlap = 0.6);

  // Text and pictures.

  /// One line of UTF-8 text at the anchor `at`, placed about it by the style. Bytes that are not UTF-8 show
  /// as U+FFFD.
  void text(const Point<2>& at, std::string_view text, const TextStyle& style = {});
  /// Text broken into lines at most `width` points long, the first line's top at `top_left`; '\n' forces a
  /// break and a word longer than a line stands alone. Aligned within the width by style.align;
  /// style.vertical and style.rotation do not apply. Returns the height in points, from the top of the
  /// first line's capitals to the bottom of the last line's descenders.
  double text_block(const Point<2>& top_left, double width, std::string_view text,
                    const TextStyle& style = {}, double line_spacing = 1.4);
  /// `image` stretched over `rect`. `nearest` shows its pixels as sharp squares.
  void picture(const Image& image, const Rect& rect, Sampling sampling = Sampling::smooth);

  // What holds for all marks until the Scope ends. Scopes nest.

  class Scope;
  /// Marks show only inside `rect` (and inside the clips around this one). A rect of NaNs shows nothing.
  [[nodiscard]] Scope clip(const Rect& rect);
  /// Marks are painted together, then laid down with `opacity` 0 .. 1: overlaps do not add up.
  [[nodiscard]] Scope layer(double opacity);

  // Pictures of all marks so far. None of these changes the canvas.

  /// `scale` pixels a point (2 is right for slides; at least 1 pixel a side). Throws Error when that is not
  /// a positive number or gives more than 32767 pixels a side.
  Image image(double scale = 2) const;
  /// A stand-alone SVG document. Text is drawn as outlines, the same everywhere; the words stand in its
  /// <desc>.
  std::string svg() const;
  /// A PDF of one page with its fonts inside.
  std::string pdf() const;
  /// Writes .png (with `png_scale` pixels a point), .svg or .pdf, by the ending of the path, whatever its
  /// case. Throws Error for another ending, FileError when writing fails.
  void save(const std::filesystem::path& path, double png_scale = 2) const;

  struct Marks;  ///< the recorded marks; known to core/image alone

 private:
  friend class Raster;
  std::unique_ptr<Marks> marks_;
};

/// Ends what Canvas::clip or Canvas::layer began. The canvas must outlive it.
class Canvas::Scope {
 public:
  ~Scope() { close(); }
  Scope(Scope&& other) noexcept : marks_(std::exchange(other.marks_, nullptr)) {}
  Scope& operator=(Scope&&) = delete;
  /// Ends it early.
  void close();

 private:
  friend class Canvas;
  explicit Scope(Marks* marks) : marks_(marks) {}
  Marks* marks_;
};

}  // namespace seesaw
