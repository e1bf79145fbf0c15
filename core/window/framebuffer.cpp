#include "core/window/framebuffer.h"

#include <epoxy/gl.h>

#include <algorithm>

#include "core/base/check.h"
#include "core/base/error.h"
#include "core/window/readback.h"

namespace seesaw {

Framebuffer::Framebuffer(int samples) : samples_(0) {
  GLint most = 0;
  glGetIntegerv(GL_MAX_SAMPLES, &most);
  samples_ = samples > 1 ? std::min(samples, most) : 0;
  glGenFramebuffers(1, &target_);
  glGenRenderbuffers(1, &depth_);
  if (samples_ > 0) {
    glGenFramebuffers(1, &smooth_target_);
    glGenRenderbuffers(1, &smooth_color_);
  }
}

Framebuffer::~Framebuffer() {
  glDeleteFramebuffers(1, &target_);
  glDeleteRenderbuffers(1, &depth_);
  if (samples_ > 0) {
    glDeleteFramebuffers(1, &smooth_target_);
    glDeleteRenderbuffers(1, &smooth_color_);
  }
}

void Framebuffer::begin(int width, int height) {
  SEESAW_CHECK_GE(width, 1);
  SEESAW_CHECK_GE(height, 1);
  if (width != texture_.width() || height != texture_.height()) {
    texture_.reserve(width, height, true);
    glBindRenderbuffer(GL_RENDERBUFFER, depth_);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples_, GL_DEPTH_COMPONENT24, width, height);
    glBindFramebuffer(GL_FRAMEBUFFER, target_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_.name(), 0);
    if (samples_ > 0) {
      glBindRenderbuffer(GL_RENDERBUFFER, smooth_color_);
      glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples_, GL_RGBA8, width, height);
      glBindFramebuffer(GL_FRAMEBUFFER, smooth_target_);
      glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, smooth_color_);
    }
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
      throw Error("the graphics card cannot draw a picture of " + std::to_string(width) + " x " +
                  std::to_string(height) + " pixels");
  }
  glBindFramebuffer(GL_FRAMEBUFFER, samples_ > 0 ? smooth_target_ : target_);
  glViewport(0, 0, width, height);
}

void Framebuffer::finish() {
  if (samples_ > 0) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, smooth_target_);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target_);
    glBlitFramebuffer(0, 0, width(), height(), 0, 0, width(), height(), GL_COLOR_BUFFER_BIT, GL_NEAREST);
  }
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  // Begun now: whoever draws goes on meanwhile, with the processor's other cores where there is no card.
  glFlush();
}

Image Framebuffer::image() const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, target_);
  Image image = read_pixels(width(), height());
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  return image;
}

}  // namespace seesaw
