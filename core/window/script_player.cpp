#include "core/window/script_player.h"

#include <algorithm>

#include "core/base/error.h"

namespace seesaw::detail {

namespace {

Modifiers both(const Modifiers& a, const Modifiers& b) {
  return {a.shift || b.shift, a.ctrl || b.ctrl, a.alt || b.alt};
}

bool* modifier_of(Modifiers& modifiers, Key key) {
  if (key == Key::shift) return &modifiers.shift;
  if (key == Key::ctrl) return &modifiers.ctrl;
  if (key == Key::alt) return &modifiers.alt;
  return nullptr;
}

Point<2> resolved(const ScriptStage& stage, const ScriptPlace& place) {
  return place.widget.empty() ? place.at : Point<2>(stage.find(place.widget) + place.at);
}

constexpr Key modifier_keys[] = {Key::ctrl, Key::shift, Key::alt};

/// SDL's event holds 31 bytes of text; a letter may not be cut.
void push_text(const ScriptStage& stage, std::string_view text) {
  while (!text.empty()) {
    std::size_t length = std::min<std::size_t>(text.size(), 31);
    while (length < text.size() && length > 1 && (static_cast<unsigned char>(text[length]) & 0xC0) == 0x80)
      --length;
    stage.push(TextTyped{std::string(text.substr(0, length))});
    text.remove_prefix(length);
  }
}

}  // namespace

void ScriptPlayer::move(const ScriptStage& stage, const Point<2>& to) {
  // Whole pixels, as a mouse has them.
  pointer_ = to.array().round();
  stage.push(MouseMoved{pointer_, held_});
}

/// How each command becomes beats.
struct ScriptPlayer::Expand {
  ScriptPlayer& player;

  void beat(Beat beat) const { player.beats_.push_back(std::move(beat)); }
  void press(MouseButton button, int clicks) const {
    beat([p = &player, button, clicks](const ScriptStage& s) {
      s.push(MousePressed{p->pointer_, button, p->held_, clicks});
    });
  }
  void release(MouseButton button) const {
    beat([p = &player, button](const ScriptStage& s) {
      s.push(MouseReleased{p->pointer_, button, p->held_});
    });
  }
  void move(const ScriptPlace& to) const {
    beat([p = &player, to](const ScriptStage& s) { p->move(s, resolved(s, to)); });
  }

  void operator()(const script::Size& size) const {
    beat([size](const ScriptStage& s) { s.resize(size.width, size.height); });
    beat([](const ScriptStage&) {});
  }
  void operator()(const script::MoveTo& command) const { move(command.to); }
  void operator()(const script::Press& command) const { press(command.button, 1); }
  void operator()(const script::Release& command) const { release(command.button); }
  void operator()(const script::Click& click) const {
    move(click.at);
    for (int i = 1; i <= click.times; ++i) {
      press(click.button, i);
      release(click.button);
    }
  }
  void operator()(const script::Drag& drag) const {
    move(drag.from);
    press(drag.button, 1);
    // Widgets may move while they are dragged, so where the way ends is decided when it begins.
    beat([drag, p = &player](const ScriptStage& s) {
      const Point<2> from = p->pointer_, to = resolved(s, drag.to);
      std::deque<Beat> way;
      for (int i = 1; i <= drag.steps; ++i)
        way.push_back([p, from, to, t = static_cast<double>(i) / drag.steps](const ScriptStage& stage) {
          p->move(stage, from + t * (to - from));
        });
      way.front()(s);
      way.pop_front();
      p->beats_.insert(p->beats_.begin(), way.begin(), way.end());
    });
    release(drag.button);
  }
  void operator()(const script::Wheel& wheel) const {
    beat([p = &player, wheel](const ScriptStage& s) {
      s.push(WheelMoved{p->pointer_, wheel.right, wheel.up, p->held_});
    });
  }
  void operator()(const script::Type& type) const {
    beat([p = &player, type](const ScriptStage& s) {
      Modifiers held = p->held_, wanted = type.chord.modifiers;
      for (const Key key : modifier_keys)
        if (*modifier_of(wanted, key) && !*modifier_of(held, key)) {
          *modifier_of(held, key) = true;
          s.push(KeyPressed{key, held});
        }
      s.push(KeyPressed{type.chord.key, held});
    });
    beat([p = &player, type](const ScriptStage& s) {
      Modifiers held = both(p->held_, type.chord.modifiers);
      s.push(KeyReleased{type.chord.key, held});
      for (const Key key : modifier_keys)
        if (*modifier_of(held, key) && !*modifier_of(p->held_, key)) {
          *modifier_of(held, key) = false;
          s.push(KeyReleased{key, held});
        }
    });
  }
  void operator()(const script::Hold& hold) const {
    beat([p = &player, hold](const ScriptStage& s) {
      if (bool* modifier = modifier_of(p->held_, hold.key)) *modifier = hold.down;
      if (hold.down)
        s.push(KeyPressed{hold.key, p->held_});
      else
        s.push(KeyReleased{hold.key, p->held_});
    });
  }
  void operator()(const script::Text& text) const {
    beat([text](const ScriptStage& s) { push_text(s, text.words); });
  }
  void operator()(const script::Drop& drop) const {
    beat([drop](const ScriptStage& s) { s.push(FileDropped{drop.file}); });
  }
  void operator()(const script::Frames& frames) const {
    for (int i = 0; i < frames.count; ++i) beat([](const ScriptStage&) {});
  }
  void operator()(const script::Screenshot& shot) const {
    beat([shot](const ScriptStage& s) { s.screenshot(shot.file); });
  }
  void operator()(const script::Quit&) const {
    beat([](const ScriptStage& s) { s.push(CloseAsked{}); });
  }
};

void ScriptPlayer::refuse(const std::string& message) const { throw FileError(script_.name, line_, message); }

void ScriptPlayer::beat(const ScriptStage& stage) {
  if (over()) return;
  if (beats_.empty()) {
    const ScriptLine& line = script_.lines[next_++];
    line_ = line.line;
    std::visit(Expand{*this}, line.command);
  }
  const Beat now = std::move(beats_.front());
  beats_.pop_front();
  try {
    now(stage);
  } catch (const Error& error) {
    refuse(error.what());
  }
}

}  // namespace seesaw::detail
