#include "core/window/texture.h"

#include <epoxy/gl.h>

#include "core/base/check.h"
#include "core/base/error.h"

namespace seesaw {

Texture::~Texture() {
  if (name_ != 0) glDeleteTextures(1, &name_);
}

void Texture::reserve(int width, int height, bool bottom_up) {
  SEESAW_CHECK_GE(width, 0);
  SEESAW_CHECK_GE(height, 0);
  bottom_up_ = bottom_up;
  if (width == width_ && height == height_) return;
  if (width > 0 && height > 0) {
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    if (width > most || height > most)
      throw Error("a picture of " + std::to_string(width) + " x " + std::to_string(height) +
                  " pixels is too large to show: this graphics card takes " + std::to_string(most) +
                  " a side");
    const bool is_new = name_ == 0;
    if (is_new) glGenTextures(1, &name_);
    glBindTexture(GL_TEXTURE_2D, name_);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    if (is_new) {
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
      set_sharp(false);
    }
  }
  width_ = width;
  height_ = height;
}

void Texture::set_sharp(bool sharp) {
  if (name_ == 0) return;
  glBindTexture(GL_TEXTURE_2D, name_);
  const GLint filter = sharp ? GL_NEAREST : GL_LINEAR;
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
}

void Texture::upload(const Pixels& pixels) {
  reserve(pixels.width, pixels.height, false);
  if (empty()) return;
  SEESAW_CHECK_GE(pixels.stride, 4 * pixels.width);
  SEESAW_CHECK_EQ(pixels.stride % 4, 0);
  glBindTexture(GL_TEXTURE_2D, name_);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, pixels.stride / 4);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, pixels.width, pixels.height,
                  pixels.order == PixelOrder::bgra ? GL_BGRA : GL_RGBA, GL_UNSIGNED_BYTE, pixels.data);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
}

void Texture::upload(const Image& image) {
  upload({image.bytes().data(), image.width(), image.height(), 4 * image.width(), PixelOrder::rgba});
}

}  // namespace seesaw
