// A window for tests: no screen, a fixed clock, and a script that drives it.
#pragma once

#include <dlfcn.h>
#include <gtest/gtest.h>
#include <link.h>

#include <cstring>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/window/window.h"

namespace seesaw {

/// Keeps Mesa's driver loaded until the program ends. Unloaded with the last window, it takes along the only
/// pointers to what it keeps for the next, and the leak checker counts that as lost.
inline void keep_driver_loaded() {
  dl_iterate_phdr(
      [](dl_phdr_info* info, std::size_t, void*) {
        if (std::strstr(info->dlpi_name, "_dri.so"))
          dlopen(info->dlpi_name, RTLD_LAZY | RTLD_NOLOAD | RTLD_NODELETE);
        return 0;
      },
      nullptr);
}

/// A window of 320 x 200 that nobody sees; null, and the test is skipped, where there is no OpenGL 3.3.
inline std::unique_ptr<Window> window_for_tests(WindowOptions options = {.width = 320, .height = 200}) {
  options.screen = Screen::none;
  options.fixed_step = 1.0 / 64;
  try {
    auto window = std::make_unique<Window>(options);
    keep_driver_loaded();
    return window;
  } catch (const Error& error) {
    // A machine that has what the run script installs must really run these.
    if (std::filesystem::exists("/usr/lib/x86_64-linux-gnu/dri/swrast_dri.so")) ADD_FAILURE() << error.what();
    return nullptr;
  }
}

#define SEESAW_WINDOW_OR_SKIP(name, ...)                        \
  const auto name##_owner = window_for_tests(__VA_ARGS__);      \
  if (!name##_owner) GTEST_SKIP() << "no OpenGL 3.3 to be had"; \
  [[maybe_unused]] Window& name = *name##_owner

/// Plays the script to its end with `draw` drawing each frame. Returns every event, and the last frame.
struct Played {
  std::vector<Input> inputs;
  Image picture;
  long frames = 0;

  template <class Event>
  std::vector<Event> only() const {
    std::vector<Event> result;
    for (const Input& input : inputs)
      if (const auto* event = std::get_if<Event>(&input.event)) result.push_back(*event);
    return result;
  }
};

inline Played play(
    Window& window, const std::string& text, const std::function<void()>& draw = [] {}) {
  Played played;
  window.play(parse_script(text, "test.script", ::testing::TempDir()));
  while (!window.script_over()) {
    const auto& inputs = window.begin_frame();
    played.inputs.insert(played.inputs.end(), inputs.begin(), inputs.end());
    draw();
    played.picture = window.end_frame_with_picture();
    ++played.frames;
  }
  return played;
}

}  // namespace seesaw
