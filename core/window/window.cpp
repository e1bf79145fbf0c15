#include "core/window/window.h"

#include <SDL.h>
#include <backends/imgui_impl_opengl3.h>
#include <epoxy/gl.h>
#include <imgui.h>

#include <algorithm>

#include "core/base/check.h"
#include "core/base/error.h"
#include "core/image/png.h"
#include "core/window/imgui_input.h"
#include "core/window/input_queue.h"
#include "core/window/script_player.h"
#include "core/window/sdl_input.h"
#include "core/window/sdl_window.h"
#include "core/window/ui_state.h"

namespace seesaw {

namespace {

// A button's look settles in the frames after the pointer's.
constexpr int frames_after_an_event = 3;
// A caret blinks, and programs save now and then.
constexpr int wait_while_typing = 200, wait_at_rest = 1000;  // milliseconds

double clamped_scale(double scale) { return scale >= 0.5 ? std::min(scale, 4.0) : 0.5; }

SDL_SystemCursor sdl_cursor(ImGuiMouseCursor cursor) {
  switch (cursor) {
    case ImGuiMouseCursor_TextInput:
      return SDL_SYSTEM_CURSOR_IBEAM;
    case ImGuiMouseCursor_ResizeAll:
      return SDL_SYSTEM_CURSOR_SIZEALL;
    case ImGuiMouseCursor_ResizeNS:
      return SDL_SYSTEM_CURSOR_SIZENS;
    case ImGuiMouseCursor_ResizeEW:
      return SDL_SYSTEM_CURSOR_SIZEWE;
    case ImGuiMouseCursor_ResizeNESW:
      return SDL_SYSTEM_CURSOR_SIZENESW;
    case ImGuiMouseCursor_ResizeNWSE:
      return SDL_SYSTEM_CURSOR_SIZENWSE;
    case ImGuiMouseCursor_Hand:
      return SDL_SYSTEM_CURSOR_HAND;
    case ImGuiMouseCursor_NotAllowed:
      return SDL_SYSTEM_CURSOR_NO;
    default:
      return SDL_SYSTEM_CURSOR_ARROW;
  }
}

/// Dear ImGui's context and its OpenGL side.
struct ImGuiParts {
  detail::UiState state;
  std::string pasted;  // what Dear ImGui reads of the clipboard

  ImGuiParts() {
    const bool is_the_only_window = ImGui::GetCurrentContext() == nullptr;
    SEESAW_CHECK_EQ(is_the_only_window, true);
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.UserData = &state;
    io.BackendPlatformName = "seesaw";
    io.BackendFlags |= ImGuiBackendFlags_HasMouseCursors;
    io.ConfigWindowsMoveFromTitleBarOnly = true;
    io.SetClipboardTextFn = [](void*, const char* text) { SDL_SetClipboardText(text); };
    io.GetClipboardTextFn = [](void* self) -> const char* {
      char* const text = SDL_GetClipboardText();
      std::string& kept = static_cast<ImGuiParts*>(self)->pasted;
      kept = text ? text : "";
      SDL_free(text);
      return kept.c_str();
    };
    io.ClipboardUserData = this;
    detail::start_imgui_input();
    ImGui_ImplOpenGL3_Init("#version 330 core");
  }
  ~ImGuiParts() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui::DestroyContext();
  }
  ImGuiParts(const ImGuiParts&) = delete;
  ImGuiParts& operator=(const ImGuiParts&) = delete;
};

struct Cursors {
  SDL_Cursor* made[SDL_NUM_SYSTEM_CURSORS] = {};
  int shown = -1;
  void show(SDL_SystemCursor which) {
    if (which == shown) return;
    shown = which;
    if (!made[which]) made[which] = SDL_CreateSystemCursor(which);
    if (made[which]) SDL_SetCursor(made[which]);
  }
  ~Cursors() {
    for (SDL_Cursor* cursor : made)
      if (cursor) SDL_FreeCursor(cursor);
  }
};

}  // namespace

struct Window::Parts {
  explicit Parts(const WindowOptions& options)
      : window(options), clock(options.fixed_step), scale(clamped_scale(options.scale)), dark(options.dark) {}

  detail::SdlWindow window;
  Cursors cursors;
  ImGuiParts imgui;
  FrameClock clock;
  InputQueue queue;
  detail::InputRouter router;
  std::vector<Input> inputs;
  std::unique_ptr<detail::ScriptPlayer> player;
  std::vector<std::filesystem::path> screenshots;       // of this frame
  std::vector<std::function<void(const Image&)>> uses;  // of this frame's picture
  double scale;
  bool dark;
  // What the fonts and colors were made for.
  double styled_scale = 0, styled_ratio = 0;
  bool styled_dark = false;
  int awake = frames_after_an_event;
  bool in_frame = false;

  double pixel_ratio() const {
    return static_cast<double>(window.pixel_width()) / std::max(1, window.width());
  }

  void style() {
    const double ratio = pixel_ratio();
    const bool new_fonts = scale != styled_scale || ratio != styled_ratio;
    if (!new_fonts && dark == styled_dark) return;
    detail::set_style(dark, scale);
    if (new_fonts) {
      imgui.state.fonts = detail::build_fonts(scale, ratio);
      ImGui_ImplOpenGL3_DestroyFontsTexture();
      ImGui_ImplOpenGL3_CreateFontsTexture();
    }
    imgui.state.scale = styled_scale = scale;
    imgui.state.dark = styled_dark = dark;
    styled_ratio = ratio;
  }

  void take(const SDL_Event& event) {
    if (auto input = input_of(event)) queue.push(std::move(*input));
  }

  /// All that SDL has; where there is nothing at all to do, the next thing that comes.
  void collect() {
    SDL_Event event;
    const bool playing = player && !player->over();
    if (queue.empty() && awake <= 0 && !clock.is_fixed() && !playing) {
      const int wait = ImGui::GetIO().WantTextInput ? wait_while_typing : wait_at_rest;
      if (SDL_WaitEventTimeout(&event, wait)) take(event);
    }
    while (SDL_PollEvent(&event)) take(event);
    awake = queue.empty() ? awake - 1 : frames_after_an_event;
  }

  void play_a_beat() {
    if (!player || player->over()) return;
    player->beat({
        .push = [this](const InputEvent& event) { push_to_sdl(event, window.id()); },
        .resize = [this](int width, int height) { SDL_SetWindowSize(window.get(), width, height); },
        .screenshot = [this](const std::filesystem::path& path) { screenshots.push_back(path); },
        .find = [this](const std::string& name) -> Point<2> {
          if (const auto* item = imgui.state.find(name)) return item->place.center();
          throw Error("there is nothing called \"" + name + "\" in the window; there is " +
                      imgui.state.names());
        },
    });
  }

  void draw() {
    ImGui::Render();
    window.begin_drawing();
    const Color back = ui_colors(dark).background;
    glDisable(GL_SCISSOR_TEST);
    glClearColor(static_cast<float>(back.r), static_cast<float>(back.g), static_cast<float>(back.b), 1);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    if (ImGui::GetMouseCursor() != ImGuiMouseCursor_None) cursors.show(sdl_cursor(ImGui::GetMouseCursor()));
  }

  std::optional<Image> end_frame(bool with_picture) {
    SEESAW_CHECK_EQ(in_frame, true);
    in_frame = false;
    draw();
    auto image = window.show(with_picture || !screenshots.empty() || !uses.empty());
    for (const auto& use : std::exchange(uses, {})) use(*image);
    for (const auto& path : std::exchange(screenshots, {})) {
      try {
        if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path());
        write_png(path, *image);
      } catch (const std::exception& error) {
        player->refuse(error.what());
      }
    }
    return image;
  }
};

Window::Window(const WindowOptions& options) : parts_(std::make_unique<Parts>(options)) {}
Window::~Window() = default;

const std::vector<Input>& Window::begin_frame() {
  Parts& p = *parts_;
  SEESAW_CHECK_EQ(p.in_frame, false);
  p.play_a_beat();
  p.collect();
  p.clock.tick();
  p.style();
  std::vector<InputEvent> events = p.queue.next_frame();
  for (const InputEvent& event : events) detail::tell_imgui(event);
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(p.window.width()), static_cast<float>(p.window.height())};
  const auto ratio = static_cast<float>(p.pixel_ratio());
  io.DisplayFramebufferScale = {ratio, ratio};
  io.DeltaTime = p.clock.step() > 0 ? static_cast<float>(p.clock.step()) : 1.0f / 60;
  ImGui_ImplOpenGL3_NewFrame();
  ImGui::NewFrame();
  p.imgui.state.begin_frame();
  p.in_frame = true;
  p.inputs.clear();
  for (InputEvent& event : events) {
    const bool for_ui = p.router.for_ui(event);
    p.inputs.push_back({std::move(event), for_ui});
  }
  return p.inputs;
}

void Window::end_frame() { parts_->end_frame(false); }
Image Window::end_frame_with_picture() { return std::move(*parts_->end_frame(true)); }
void Window::hand_over(std::function<void(const Image&)> use) { parts_->uses.push_back(std::move(use)); }
void Window::stay_awake() { parts_->awake = std::max(parts_->awake, 1); }
void Window::wake() { push_wake_to_sdl(); }
const FrameClock& Window::clock() const { return parts_->clock; }

void Window::play(Script script) {
  parts_->player = std::make_unique<detail::ScriptPlayer>(std::move(script));
}
bool Window::script_over() const { return parts_->player && parts_->player->over() && parts_->queue.empty(); }

int Window::width() const { return parts_->window.width(); }
int Window::height() const { return parts_->window.height(); }
double Window::pixel_ratio() const { return parts_->pixel_ratio(); }
void Window::set_size(int width, int height) {
  SEESAW_CHECK_GE(width, 1);
  SEESAW_CHECK_GE(height, 1);
  SDL_SetWindowSize(parts_->window.get(), width, height);
}
void Window::set_title(const std::string& title) { SDL_SetWindowTitle(parts_->window.get(), title.c_str()); }
void Window::set_full_screen(bool on) {
  SDL_SetWindowFullscreen(parts_->window.get(), on ? SDL_WINDOW_FULLSCREEN_DESKTOP : 0);
}
bool Window::full_screen() const {
  return (SDL_GetWindowFlags(parts_->window.get()) & SDL_WINDOW_FULLSCREEN_DESKTOP) ==
         SDL_WINDOW_FULLSCREEN_DESKTOP;
}
void Window::set_scale(double scale) {
  parts_->scale = clamped_scale(scale);
  stay_awake();
}
double Window::scale() const { return parts_->scale; }
void Window::set_dark(bool dark) {
  parts_->dark = dark;
  stay_awake();
}
bool Window::dark() const { return parts_->dark; }

std::string Window::clipboard() const {
  char* const text = SDL_GetClipboardText();
  std::string result = text ? text : "";
  SDL_free(text);
  return result;
}
void Window::set_clipboard(const std::string& text) { SDL_SetClipboardText(text.c_str()); }

std::string Window::driver() const { return SDL_GetCurrentVideoDriver(); }
int Window::opengl_version() const { return epoxy_gl_version(); }
std::string Window::description() const {
  GLint profile = 0;
  glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
  const auto gl = [](GLenum what) { return std::string(reinterpret_cast<const char*>(glGetString(what))); };
  return "OpenGL " + gl(GL_VERSION) + " on " + gl(GL_RENDERER) +
         (profile & GL_CONTEXT_CORE_PROFILE_BIT ? ", core profile" : "") + ", SDL driver " + driver() +
         ", Dear ImGui " + ImGui::GetVersion();
}

}  // namespace seesaw
