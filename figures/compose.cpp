#include "figures/compose.h"

#include <algorithm>

namespace seesaw {

namespace {

constexpr double margin = 26, gap = 26, title_height = 22, caption_gap = 16;
const TextStyle heading{.size = 14, .bold = true, .vertical = VerticalAlign::top};
const TextStyle panel_title{.size = 10.5, .bold = true, .vertical = VerticalAlign::top};
const TextStyle caption_style{.size = 10, .color = theme::soft_ink};
const TextStyle source_style{.size = 8.5, .color = theme::soft_ink, .italic = true};

std::string with_letter(std::size_t i, const Panel& panel) {
  const std::string letter = "(" + std::string(1, static_cast<char>('a' + i)) + ")";
  return panel.title.empty() ? letter : letter + "  " + panel.title;
}

// The caption's height, by setting it on a sheet that nobody sees.
double caption_height(const Figure& figure, double width) {
  Canvas trial(std::max(width, 1.0), 10);
  const double text = trial.text_block({0, 0}, width, figure.caption, caption_style);
  return text + 8 + trial.text_block({0, 0}, width, figure.paper, source_style);
}

}  // namespace

Canvas compose(const Figure& figure) {
  const std::size_t columns = figure.columns ? figure.columns : figure.panels.size();
  // Rows as high as their highest panel, columns as wide as their widest.
  std::vector<double> widths(columns, 0.0), heights;
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    if (i % columns == 0) heights.push_back(0.0);
    widths[i % columns] = std::max(widths[i % columns], figure.panels[i].width);
    heights.back() = std::max(heights.back(), figure.panels[i].height);
  }
  double width = gap * static_cast<double>(columns - 1), height = 0;
  for (const double w : widths) width += w;
  for (const double h : heights) height += h + title_height + gap;
  const double heading_height = 28;
  const double below = caption_height(figure, width);
  Canvas canvas(width + 2 * margin, margin + heading_height + height - gap + caption_gap + below + margin);

  canvas.text({margin, margin}, figure.title, heading);
  double y = margin + heading_height;
  for (std::size_t row = 0; row < heights.size(); ++row) {
    double x = margin;
    for (std::size_t column = 0; column < columns; ++column) {
      const std::size_t i = row * columns + column;
      if (i < figure.panels.size()) {
        const Panel& panel = figure.panels[i];
        canvas.text({x, y}, with_letter(i, panel), panel_title);
        panel.draw(canvas, {x, y + title_height, panel.width, panel.height});
      }
      x += widths[column] + gap;
    }
    y += heights[row] + title_height + gap;
  }
  y += caption_gap - gap;
  y += canvas.text_block({margin, y}, width, figure.caption, caption_style) + 8;
  canvas.text_block({margin, y}, width, figure.paper, source_style);
  return canvas;
}

Canvas compose_panel(const Panel& panel) {
  constexpr double rim = 10;
  Canvas canvas(panel.width + 2 * rim, panel.height + 2 * rim);
  panel.draw(canvas, {rim, rim, panel.width, panel.height});
  return canvas;
}

}  // namespace seesaw
