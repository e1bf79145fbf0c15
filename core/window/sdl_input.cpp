#include "core/window/sdl_input.h"

#include <SDL.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/error.h"

namespace seesaw {

namespace {

constexpr std::pair<SDL_Keycode, Key> special_keys[] = {
    {SDLK_ESCAPE, Key::escape},
    {SDLK_RETURN, Key::enter},
    {SDLK_TAB, Key::tab},
    {SDLK_SPACE, Key::space},
    {SDLK_BACKSPACE, Key::backspace},
    {SDLK_DELETE, Key::del},
    {SDLK_HOME, Key::home},
    {SDLK_END, Key::end},
    {SDLK_LEFT, Key::left},
    {SDLK_RIGHT, Key::right},
    {SDLK_UP, Key::up},
    {SDLK_DOWN, Key::down},
    {SDLK_PLUS, Key::plus},
    {SDLK_MINUS, Key::minus},
    {SDLK_LEFTBRACKET, Key::left_bracket},
    {SDLK_RIGHTBRACKET, Key::right_bracket},
    {SDLK_COMMA, Key::comma},
    {SDLK_PERIOD, Key::period},
    {SDLK_PAGEUP, Key::page_up},
    {SDLK_PAGEDOWN, Key::page_down},
    {SDLK_INSERT, Key::insert},
    {SDLK_SLASH, Key::slash},
    {SDLK_SEMICOLON, Key::semicolon},
    {SDLK_QUOTE, Key::apostrophe},
    {SDLK_BACKSLASH, Key::backslash},
    {SDLK_BACKQUOTE, Key::grave},
    {SDLK_LSHIFT, Key::shift},
    {SDLK_LCTRL, Key::ctrl},
    {SDLK_LALT, Key::alt},
    // The first of each key's rows is what key_code gives; these are the others.
    {SDLK_EQUALS, Key::plus},
    {SDLK_KP_PLUS, Key::plus},
    {SDLK_KP_MINUS, Key::minus},
    {SDLK_KP_ENTER, Key::enter},
    {SDLK_RSHIFT, Key::shift},
    {SDLK_RCTRL, Key::ctrl},
    {SDLK_LGUI, Key::ctrl},
    {SDLK_RGUI, Key::ctrl},
    {SDLK_RALT, Key::alt},
};

std::optional<Key> key_of(SDL_Keycode code) {
  const auto counted_from = [code](SDL_Keycode first, Key key) {
    return static_cast<Key>(static_cast<int>(key) + (code - first));
  };
  if (code >= SDLK_a && code <= SDLK_z) return counted_from(SDLK_a, Key::a);
  if (code >= SDLK_0 && code <= SDLK_9) return counted_from(SDLK_0, Key::digit0);
  if (code >= SDLK_F1 && code <= SDLK_F12) return counted_from(SDLK_F1, Key::f1);
  for (const auto& [special, key] : special_keys)
    if (special == code) return key;
  return std::nullopt;
}

SDL_Keycode code_of(Key key) {
  const auto within = [key](Key first, Key last) { return key >= first && key <= last; };
  const auto offset = [key](Key first) { return static_cast<int>(key) - static_cast<int>(first); };
  if (within(Key::a, Key::z)) return SDLK_a + offset(Key::a);
  if (within(Key::digit0, Key::digit9)) return SDLK_0 + offset(Key::digit0);
  if (within(Key::f1, Key::f12)) return SDLK_F1 + offset(Key::f1);
  return std::find_if(std::begin(special_keys), std::end(special_keys),
                      [key](const auto& row) { return row.second == key; })
      ->first;
}

Modifiers modifiers_of(int state) {
  return {(state & KMOD_SHIFT) != 0, (state & (KMOD_CTRL | KMOD_GUI)) != 0, (state & KMOD_ALT) != 0};
}

SDL_Keymod state_of(const Modifiers& modifiers) {
  return static_cast<SDL_Keymod>((modifiers.shift ? KMOD_LSHIFT : 0) | (modifiers.ctrl ? KMOD_LCTRL : 0) |
                                 (modifiers.alt ? KMOD_LALT : 0));
}

// Events of the pointer do not say which modifiers are held.
Modifiers held_now() { return modifiers_of(SDL_GetModState()); }

std::optional<MouseButton> button_of(int button) {
  if (button == SDL_BUTTON_LEFT) return MouseButton::left;
  if (button == SDL_BUTTON_MIDDLE) return MouseButton::middle;
  if (button == SDL_BUTTON_RIGHT) return MouseButton::right;
  return std::nullopt;
}

std::uint8_t sdl_button(MouseButton button) {
  return static_cast<std::uint8_t>(button == MouseButton::left     ? SDL_BUTTON_LEFT
                                   : button == MouseButton::middle ? SDL_BUTTON_MIDDLE
                                                                   : SDL_BUTTON_RIGHT);
}

Point<2> pixel_of(int x, int y) { return {x, y}; }

// Wheel events of this SDL may or may not know where the pointer is (2.26 began to say it).
Point<2> wheel_position(const SDL_MouseWheelEvent& wheel) {
#if SDL_VERSION_ATLEAST(2, 26, 0)
  return pixel_of(wheel.mouseX, wheel.mouseY);
#else
  (void)wheel;
  int x = 0, y = 0;
  SDL_GetMouseState(&x, &y);
  return pixel_of(x, y);
#endif
}

std::optional<InputEvent> button_event(const SDL_MouseButtonEvent& event) {
  const auto button = button_of(event.button);
  if (!button) return std::nullopt;
  if (event.state == SDL_PRESSED)
    return MousePressed{pixel_of(event.x, event.y), *button, held_now(), std::max<int>(event.clicks, 1)};
  return MouseReleased{pixel_of(event.x, event.y), *button, held_now()};
}

std::optional<InputEvent> key_event(const SDL_KeyboardEvent& event) {
  const auto key = key_of(event.keysym.sym);
  if (!key) return std::nullopt;
  const Modifiers modifiers = modifiers_of(event.keysym.mod);
  if (event.state == SDL_PRESSED) return KeyPressed{*key, modifiers, event.repeat != 0};
  return KeyReleased{*key, modifiers};
}

std::optional<InputEvent> window_event(const SDL_WindowEvent& event) {
  switch (event.event) {
    case SDL_WINDOWEVENT_SIZE_CHANGED:
      return WindowResized{event.data1, event.data2};
    case SDL_WINDOWEVENT_FOCUS_LOST:
      return WindowLeft{};
    case SDL_WINDOWEVENT_LEAVE:
      return MouseLeft{};
    // Uncovered, shown again: to be painted anew.
    case SDL_WINDOWEVENT_EXPOSED:
    case SDL_WINDOWEVENT_SHOWN:
    case SDL_WINDOWEVENT_RESTORED:
      return Woken{};
    default:
      return std::nullopt;
  }
}

// How an event of ours is written in SDL's words.
struct ToSdl {
  std::uint32_t window;

  SDL_Event blank(std::uint32_t type) const {
    SDL_Event e = {};
    e.type = type;
    return e;
  }
  SDL_Event operator()(const MouseMoved& moved) const {
    SDL_Event e = blank(SDL_MOUSEMOTION);
    e.motion.windowID = window;
    e.motion.x = static_cast<int>(std::lround(moved.at.x()));
    e.motion.y = static_cast<int>(std::lround(moved.at.y()));
    return e;
  }
  SDL_Event button(std::uint32_t type, const Point<2>& at, MouseButton which, int clicks) const {
    SDL_Event e = blank(type);
    e.button.windowID = window;
    e.button.button = sdl_button(which);
    e.button.state = type == SDL_MOUSEBUTTONDOWN ? SDL_PRESSED : SDL_RELEASED;
    e.button.clicks = static_cast<std::uint8_t>(clicks);
    e.button.x = static_cast<int>(std::lround(at.x()));
    e.button.y = static_cast<int>(std::lround(at.y()));
    return e;
  }
  SDL_Event operator()(const MousePressed& pressed) const {
    return button(SDL_MOUSEBUTTONDOWN, pressed.at, pressed.button, pressed.clicks);
  }
  SDL_Event operator()(const MouseReleased& released) const {
    return button(SDL_MOUSEBUTTONUP, released.at, released.button, 1);
  }
  SDL_Event operator()(const WheelMoved& wheel) const {
    SDL_Event e = blank(SDL_MOUSEWHEEL);
    e.wheel.windowID = window;
    e.wheel.x = static_cast<int>(std::lround(wheel.right));
    e.wheel.y = static_cast<int>(std::lround(wheel.up));
    e.wheel.preciseX = static_cast<float>(wheel.right);
    e.wheel.preciseY = static_cast<float>(wheel.up);
#if SDL_VERSION_ATLEAST(2, 26, 0)
    e.wheel.mouseX = static_cast<int>(std::lround(wheel.at.x()));
    e.wheel.mouseY = static_cast<int>(std::lround(wheel.at.y()));
#endif
    return e;
  }
  SDL_Event key(std::uint32_t type, Key which, const Modifiers& modifiers, bool repeat) const {
    SDL_SetModState(state_of(modifiers));
    SDL_Event e = blank(type);
    e.key.windowID = window;
    e.key.state = type == SDL_KEYDOWN ? SDL_PRESSED : SDL_RELEASED;
    e.key.repeat = repeat ? 1 : 0;
    e.key.keysym.sym = code_of(which);
    e.key.keysym.scancode = SDL_GetScancodeFromKey(e.key.keysym.sym);
    e.key.keysym.mod = static_cast<std::uint16_t>(state_of(modifiers));
    return e;
  }
  SDL_Event operator()(const KeyPressed& pressed) const {
    return key(SDL_KEYDOWN, pressed.key, pressed.modifiers, pressed.repeat);
  }
  SDL_Event operator()(const KeyReleased& released) const {
    return key(SDL_KEYUP, released.key, released.modifiers, false);
  }
  SDL_Event operator()(const TextTyped& typed) const {
    SDL_Event e = blank(SDL_TEXTINPUT);
    e.text.windowID = window;
    if (typed.text.size() >= sizeof e.text.text) throw Error("too much text for one event of SDL");
    std::copy(typed.text.begin(), typed.text.end(), e.text.text);
    return e;
  }
  SDL_Event operator()(const FileDropped& dropped) const {
    SDL_Event e = blank(SDL_DROPFILE);
    e.drop.windowID = window;
    e.drop.file = SDL_strdup(dropped.path.string().c_str());
    return e;
  }
  SDL_Event operator()(const WindowResized& resized) const {
    SDL_Event e = window_event(SDL_WINDOWEVENT_SIZE_CHANGED);
    e.window.data1 = resized.width;
    e.window.data2 = resized.height;
    return e;
  }
  SDL_Event window_event(SDL_WindowEventID what) const {
    SDL_Event e = blank(SDL_WINDOWEVENT);
    e.window.windowID = window;
    e.window.event = static_cast<std::uint8_t>(what);
    return e;
  }
  SDL_Event operator()(const MouseLeft&) const { return window_event(SDL_WINDOWEVENT_LEAVE); }
  SDL_Event operator()(const WindowLeft&) const { return window_event(SDL_WINDOWEVENT_FOCUS_LOST); }
  SDL_Event operator()(const CloseAsked&) const { return blank(SDL_QUIT); }
  SDL_Event operator()(const Woken&) const { return blank(SDL_USEREVENT); }
};

}  // namespace

std::optional<InputEvent> input_of(const SDL_Event& event) {
  switch (event.type) {
    case SDL_MOUSEMOTION:
      return MouseMoved{pixel_of(event.motion.x, event.motion.y), held_now()};
    case SDL_MOUSEBUTTONDOWN:
    case SDL_MOUSEBUTTONUP:
      return button_event(event.button);
    case SDL_MOUSEWHEEL: {
      const double turn = event.wheel.direction == SDL_MOUSEWHEEL_FLIPPED ? -1 : 1;
      return WheelMoved{wheel_position(event.wheel), turn * static_cast<double>(event.wheel.preciseX),
                        turn * static_cast<double>(event.wheel.preciseY), held_now()};
    }
    case SDL_KEYDOWN:
    case SDL_KEYUP:
      return key_event(event.key);
    case SDL_TEXTINPUT:
      return TextTyped{event.text.text};
    case SDL_DROPFILE: {
      const FileDropped dropped{event.drop.file ? event.drop.file : ""};
      SDL_free(event.drop.file);
      return dropped;
    }
    case SDL_DROPTEXT:
      SDL_free(event.drop.file);
      return std::nullopt;
    case SDL_WINDOWEVENT:
      return window_event(event.window);
    case SDL_QUIT:
      return CloseAsked{};
    case SDL_USEREVENT:
      return Woken{};
    default:
      return std::nullopt;
  }
}

void push_to_sdl(const InputEvent& event, std::uint32_t window) {
  SDL_Event e = std::visit(ToSdl{window}, event);
  if (SDL_PushEvent(&e) < 0) throw Error(std::string("SDL refuses an event: ") + SDL_GetError());
}

void push_wake_to_sdl() {
  SDL_Event e = {};
  e.type = SDL_USEREVENT;
  // A full queue wakes the window as well.
  SDL_PushEvent(&e);
}

}  // namespace seesaw
