#include "core/window/readback.h"

#include <epoxy/gl.h>

#include <algorithm>

namespace seesaw {

Image read_pixels(int width, int height) {
  Image image(width, height);
  if (image.empty()) return image;
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, image.bytes().data());
  // OpenGL counts rows from below.
  const std::size_t row = std::size_t{4} * static_cast<std::size_t>(width);
  for (int y = 0; y < height / 2; ++y)
    std::swap_ranges(image.pixel(0, y), image.pixel(0, y) + row, image.pixel(0, height - 1 - y));
  for (std::size_t i = 3; i < image.bytes().size(); i += 4) image.bytes()[i] = 255;
  return image;
}

}  // namespace seesaw
