// sandbox2d: drag the constraints of an interpolating implicit curve, and everything answers at once.
//
//     sandbox2d                                          the first figure of the papers
//     sandbox2d figures/scenes/turk2002-fig05-left.json
//     sandbox2d --script tour.script --screenshot tour.png   without a screen: a written-down hand, then a
//     picture
#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <vector>

#include "core/base/error.h"
#include "core/image/png.h"
#include "sandbox2d/app.h"

namespace seesaw {
namespace {

struct Arguments {
  std::string file, script, screenshot, size, state;
  double scale = 0;
  bool dark = false, light = false, plate = false, times = false;
};

// What frames took, as JSON: for the benchmark, and for who wonders why it is slow.
void print_times(std::vector<double> seconds) {
  if (seconds.empty()) return;
  std::sort(seconds.begin(), seconds.end());
  const auto at = [&](double part) {
    return 1e3 * seconds[static_cast<std::size_t>(part * static_cast<double>(seconds.size() - 1))];
  };
  std::cout << "{\"frames\": " << seconds.size() << ", \"median_ms\": " << at(0.5)
            << ", \"p90_ms\": " << at(0.9) << ", \"longest_ms\": " << at(1) << "}\n";
}

void run(const Arguments& arguments) {
  const bool scripted = !arguments.script.empty() || !arguments.screenshot.empty();
  AppOptions options{.file = arguments.file};
  if (!arguments.state.empty())
    options.state = arguments.state;
  else if (!scripted)
    options.state = state_folder(std::getenv("XDG_STATE_HOME"), std::getenv("HOME"));
  if (arguments.plate) options.plate = true;
  options.offer_tour = !scripted;

  const Settings settings =
      SettingsFile(options.state.empty() ? options.state : options.state / "sandbox2d.settings").settings();
  WindowOptions look{.title = "Seesaw",
                     .width = settings.window_width,
                     .height = settings.window_height,
                     .scale = arguments.scale > 0 ? arguments.scale : settings.scale,
                     .dark = arguments.dark || (settings.dark && !arguments.light)};
  if (!arguments.size.empty()) {
    char cross = 0;
    std::istringstream words(arguments.size);
    if (!(words >> look.width >> cross >> look.height) || cross != 'x' || look.width < 320 ||
        look.height < 240 || look.width > 16384 || look.height > 16384 || !(words >> std::ws).eof())
      throw Error("--size \"" + arguments.size +
                  "\": expected WIDTHxHEIGHT, at least 320x240 and at most 16384x16384");
  }
  if (scripted) {
    look.screen = Screen::none;
    look.fixed_step = 1.0 / 60;
  }
  Window window(look);
  App app(window, options);
  if (!arguments.script.empty()) window.play(read_script(arguments.script));

  // What a person waits for: from the inputs' arrival on.
  auto start = std::chrono::steady_clock::now();
  const auto step = [&] {
    const std::vector<Input>& inputs = window.begin_frame();
    start = std::chrono::steady_clock::now();
    for (const Input& input : inputs) app.handle(input);
    app.frame();
  };
  std::vector<double> times;
  while (!app.done() && !(scripted && (arguments.script.empty() || window.script_over()))) {
    step();
    window.end_frame();
    times.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  if (arguments.times) print_times(std::move(times));
  if (arguments.screenshot.empty()) return;
  for (int frames = 0; frames < 600 && (frames < 3 || !app.settled()); ++frames) {
    step();
    window.end_frame();
  }
  step();
  write_png(arguments.screenshot, window.end_frame_with_picture());
}

}  // namespace
}  // namespace seesaw

int main(int argc, char** argv) {
  using namespace seesaw;
  Arguments arguments;
  CLI::App app{"Drag the constraints of an interpolating implicit curve. F1 in the window lists all keys."};
  app.add_option("file", arguments.file, "a scene or a recorded session (JSON)");
  app.add_option("--script", arguments.script,
                 "play a script of input, without a screen (core/window/script.h)");
  app.add_option("--screenshot", arguments.screenshot, "at its end write what is shown to this PNG");
  app.add_option("--size", arguments.size, "of the window, as 1280x800");
  app.add_option("--scale", arguments.scale, "of letters and symbols; about 2 for a hall")
      ->check(CLI::Range(0.5, 4.0));
  app.add_flag("--dark", arguments.dark, "dark instead of light");
  app.add_flag("--light", arguments.light, "light instead of dark");
  app.add_flag("--plate", arguments.plate, "with the see-saw view");
  app.add_flag("--times", arguments.times, "at the end print what frames took, as JSON");
  app.add_option("--state", arguments.state, "folder for settings, recent files and autosaves");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  try {
    run(arguments);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "sandbox2d: " << error.what() << '\n';
    return 2;
  }
}
