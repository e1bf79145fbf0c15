#include "core/image/compare.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/image/colormap.h"
#include "core/image/theme.h"

namespace seesaw {
namespace {

constexpr double full_heat = 20;  // Delta E drawn in the darkest color
constexpr int gap = 8;            // pixels between the panels

// L, a and b of every pixel, one plane after another.
struct LabPlanes {
  int width, height;
  std::array<std::vector<float>, 3> planes;
};

LabPlanes lab_planes(const Image& image) {
  LabPlanes lab{image.width(), image.height(), {}};
  const std::size_t count = image.bytes().size() / 4;
  for (auto& plane : lab.planes) plane.resize(count);
  Color last{-1, 0, 0};
  Lab last_lab;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint8_t* p = image.bytes().data() + 4 * i;
    const Color color = mix(theme::paper, {p[0] / 255.0, p[1] / 255.0, p[2] / 255.0}, p[3] / 255.0);
    if (!(color == last)) {  // pictures are mostly runs of one color
      last = color;
      last_lab = lab_of(color);
    }
    lab.planes[0][i] = static_cast<float>(last_lab.L);
    lab.planes[1][i] = static_cast<float>(last_lab.a);
    lab.planes[2][i] = static_cast<float>(last_lab.b);
  }
  return lab;
}

// A Gaussian along rows, then along columns; beyond the rim the picture goes on with its last pixel.
void blur(std::vector<float>& plane, int width, int height, double deviation) {
  if (!(deviation > 0) || plane.empty()) return;
  const int radius = std::max(1, static_cast<int>(std::ceil(3 * std::min(deviation, 100.0))));
  std::vector<float> weights;
  float sum = 0;
  for (int k = -radius; k <= radius; ++k) {
    weights.push_back(static_cast<float>(std::exp(-0.5 * k * k / (deviation * deviation))));
    sum += weights.back();
  }
  for (float& w : weights) w /= sum;

  std::vector<float> other(plane.size());
  const auto pass = [&](const std::vector<float>& from, std::vector<float>& to, int along, int lines,
                        int step, int line_step) {
    for (int line = 0; line < lines; ++line)
      for (int i = 0; i < along; ++i) {
        float value = 0;
        for (int k = -radius; k <= radius; ++k) {
          const auto j = static_cast<std::ptrdiff_t>(std::clamp(i + k, 0, along - 1));
          value += weights[static_cast<std::size_t>(k + radius)] *
                   from[static_cast<std::size_t>(j * step + static_cast<std::ptrdiff_t>(line) * line_step)];
        }
        to[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) * step +
                                    static_cast<std::ptrdiff_t>(line) * line_step)] = value;
      }
  };
  pass(plane, other, width, height, 1, width);
  pass(other, plane, height, width, width, 1);
}

// Delta E of every pixel of two images of one size.
std::vector<float> differences(const Image& a, const Image& b, double deviation) {
  LabPlanes p = lab_planes(a);
  const LabPlanes q = lab_planes(b);
  std::vector<float> squares(p.planes[0].size());
  for (std::size_t part = 0; part < 3; ++part) {
    // The blur is linear: blurring the difference is blurring both.
    std::vector<float>& plane = p.planes[part];
    for (std::size_t i = 0; i < plane.size(); ++i) plane[i] -= q.planes[part][i];
    blur(plane, p.width, p.height, deviation);
    for (std::size_t i = 0; i < plane.size(); ++i) squares[i] += plane[i] * plane[i];
  }
  for (float& s : squares) s = std::sqrt(s);
  return squares;
}

Image on_larger_sheet(const Image& image, int width, int height, const Color& around) {
  Image sheet(width, height, around);
  for (int y = 0; y < image.height(); ++y)
    std::copy_n(image.pixel(0, y), 4 * image.width(), sheet.pixel(0, y));
  return sheet;
}

}  // namespace

Comparison compare_images(const Image& a, const Image& b, const CompareOptions& options) {
  Comparison result;
  result.same_size = a.width() == b.width() && a.height() == b.height();
  if (!result.same_size) return result;
  if (a.empty()) return {true, 0, 0, 0, 0};
  std::vector<float> delta = differences(a, b, options.blur);
  double sum = 0;
  std::size_t noticeable = 0;
  for (const float d : delta) {
    sum += static_cast<double>(d);
    noticeable += static_cast<double>(d) > options.just_noticeable;
  }
  const double count = static_cast<double>(delta.size());
  result.mean = sum / count;
  result.noticeable = static_cast<double>(noticeable) / count;
  const auto place = delta.begin() + static_cast<std::ptrdiff_t>(0.999 * (count - 1));
  std::nth_element(delta.begin(), place, delta.end());
  result.percentile = static_cast<double>(*place);
  result.worst = static_cast<double>(*std::max_element(place, delta.end()));
  return result;
}

Image difference_picture(const Image& a, const Image& b, const CompareOptions& options) {
  const int width = std::max(a.width(), b.width()), height = std::max(a.height(), b.height());
  if (width == 0 || height == 0) return {};
  Image sheet(3 * width + 2 * gap, height, theme::paper);
  const auto place = [&](const Image& panel, int left) {
    for (int y = 0; y < panel.height(); ++y)
      std::copy_n(panel.pixel(0, y), 4 * panel.width(), sheet.pixel(left, y));
  };
  place(a, 0);
  place(b, width + gap);

  const std::vector<float> delta = differences(on_larger_sheet(a, width, height, theme::paper),
                                               on_larger_sheet(b, width, height, theme::paper), options.blur);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const bool in_a = x < a.width() && y < a.height(), in_b = x < b.width() && y < b.height();
      const double d = static_cast<double>(
          delta[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)]);
      sheet.set(2 * (width + gap) + x, y, sequential_color(in_a && in_b ? d / full_heat : 1));
    }
  return sheet;
}

}  // namespace seesaw
