#include "sandbox2d/app.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "core/window/ui.h"
#include "sandbox2d/desk_input.h"

namespace seesaw {

namespace {

// How long a message stays before the tool's hint is back, seconds.
constexpr double message_stays = 6;

DeskOptions desk_options(Window& window, const BackgroundSolver<2>& solver,
                         const BackgroundSolver<2>& other) {
  DeskOptions options;
  options.editor.solver = solver;
  options.editor.solve_at_once = false;
  options.other_solver = other;
  options.clipboard.get = [&window] { return window.clipboard(); };
  options.clipboard.set = [&window](const std::string& text) { window.set_clipboard(text); };
  return options;
}

// The smoothest function that is 0 at some places is 0.
bool asks_for_zero_alone(const Document<2>& document) {
  for (const auto& each : document.constraints)
    if (each.constraint.value != 0 || (each.constraint.normal && each.constraint.normal->value != 0))
      return false;
  return true;
}

std::filesystem::path in_state(const std::filesystem::path& state, const char* name) {
  return state.empty() ? std::filesystem::path() : state / name;
}

}  // namespace

App::App(Window& window, const AppOptions& options)
    : window_(window),
      solver_({.arrived = [&window] { window.wake(); }}),
      other_solver_({.arrived = [&window] { window.wake(); }}),
      desk_({}, desk_options(window, solver_, other_solver_)),
      painter_([&window] { window.wake(); }),
      settings_(in_state(options.state, "sandbox2d.settings")),
      recent_(in_state(options.state, "sandbox2d.recent")),
      autosave_(in_state(options.state, "autosave")),
      autosave_folder_(in_state(options.state, "autosave")) {
  panels_ = settings_.settings().shows("panels");
  shown_.plate = options.plate.value_or(settings_.settings().shows("plate", false));
  shown_.weights = settings_.settings().shows("weights", false);
  place_everything();
  if (!options.file.empty()) open(options.file);
  if (options.file.empty() || desk_.message().trouble) {
    // Also in place of a file that cannot be read; what is wrong with it is still said.
    const DeskMessage trouble = desk_.message();
    show_entry(gallery().front());
    if (trouble.trouble) desk_.say(trouble.text, true);
  }
  if (!autosave_folder_.empty()) offer_recovered();
  if (options.offer_tour && options.file.empty() && !settings_.settings().tour_seen && !questions_.open())
    questions_.ask(
        {"Welcome to Seesaw",
         "You say where a curve passes and which way is in; one linear system gives the smoothest "
         "function that obeys, and its zero set is the curve.\nA short tour shows the three kinds of "
         "constraints and the see-saw, in a few minutes. F3 starts it at any time.",
         {{"Take the tour", [this] { act(DeskCommand::tour); }}, {"Look around myself", {}}}});
}

App::~App() {
  // What is left unsaved on purpose, or saved, needs no copy.
  if (done_) autosave_.clear();
}

void App::handle(const Input& input) {
  changed_ = true;
  if (const auto* dropped = std::get_if<FileDropped>(&input.event)) {
    const auto path = dropped->path;
    if (!desk_.can_open(path)) {
      recent_.remove(path);
      return;
    }
    return when_kept([this, path] { open(path); });
  }
  if (std::holds_alternative<CloseAsked>(input.event)) return act(DeskCommand::quit);
  if (const auto* moved = std::get_if<MouseMoved>(&input.event)) {
    pointer_in_scene_ = !input.for_ui && layout_.scene.contains(moved->at);
    shift_ = moved->modifiers.shift;
  }
  if (std::holds_alternative<MouseLeft>(input.event)) pointer_in_scene_ = false;
  if (input.for_ui) {
    // A key that is held when a panel takes over must not stay down for the desk.
    if (!std::holds_alternative<KeyReleased>(input.event)) return;
  }
  const auto event = desk_event(input.event, desk_.view(), {layout_.scene.left(), layout_.scene.top()});
  if (!event) return;
  // Presses between the panels, on their rims, are nobody's.
  if (const auto* down = std::get_if<MousePressed>(&input.event))
    if (!layout_.scene.contains(down->at)) return;
  if (const auto* wheel = std::get_if<WheelMoved>(&input.event))
    if (!layout_.scene.contains(wheel->at)) return;
  // A hand takes over from a replay.
  const bool hand = std::holds_alternative<PointerDown>(*event) || std::holds_alternative<KeyDown>(*event);
  if (hand && playback_.running()) {
    playback_.stop(desk_);
    return desk_.say("stopped; what was done can be undone");
  }
  const auto* key = std::get_if<KeyDown>(&*event);
  act_on(desk_.handle(*event));
  if (key && command_of(key->key, key->held) == DeskCommand::fit) {
    plate_.rescale();
    shown_view_ = desk_.view();
  }
}

void App::place_everything() {
  const bool had_chart = layout_.profile.width > 0;
  layout_ = layout_of({.width = static_cast<double>(window_.width()),
                       .height = static_cast<double>(window_.height()),
                       .menu = ui::menu_height(),
                       .scale = window_.scale(),
                       .panels = panels_,
                       .plate = shown_.plate,
                       .profile = desk_.profile().has_value(),
                       .tour = tour_.running()});
  if (shown_view_ && !(*shown_view_ == desk_.view())) shown_view_.reset();
  const bool resized =
      desk_.view().width() != layout_.scene.width || desk_.view().height() != layout_.scene.height;
  if (!had_chart && layout_.profile.width > 0) line_to_be_seen_ = true;
  if (resized) resize_view();
  // The chart's place was the scene's, where an end of the line may have been.
  if (line_to_be_seen_ && desk_.gesture() == Gesture::none) {
    line_to_be_seen_ = false;
    desk_.show_profile_whole();
  }
}

void App::resize_view() {
  // What was shown as a whole, by its document's view or by F, stays so when panels come and go.
  const bool as_saved = shows_as_saved(), whole = shown_view_.has_value();
  desk_.view().resize(layout_.scene.width, layout_.scene.height);
  if (as_saved)
    desk_.show_as_saved();
  else if (whole)
    desk_.fit();
  if (whole) shown_view_ = desk_.view();
}

bool App::shows_as_saved() const {
  if (!desk_.display().view) return false;
  View2D saved = desk_.view();
  saved.show(*desk_.display().view);
  return saved == desk_.view();
}

void App::frame() {
  const double s = window_.scale();
  desk_.set_scale(s);
  const bool dialog = ui::any_dialog();  // is drawn once more, even if it ends now
  if (scripted() && (solver_.busy() || other_solver_.busy())) {
    solver_.wait();
    other_solver_.wait();
    desk_.solve_again();
  }
  const bool news = solver_.poll(), other_news = other_solver_.poll();
  if (news || other_news) desk_.solve_again();
  if (playback_.running()) {
    playback_.step(desk_, window_.clock().time());
    changed_ = true;
    window_.stay_awake();
  }
  place_everything();

  const auto do_it = [this](DeskCommand command) { act(command); };
  draw_menu_bar(desk_,
                {.recent = recent_,
                 .shown = shown_,
                 .panels = panels_,
                 .dark = window_.dark(),
                 .full_screen = window_.full_screen()},
                {.act = do_it, .open = [this](const std::filesystem::path& path) {
                   when_kept([this, path] { open(path); });
                 }});
  if (layout_.tools.width > 0) draw_tools(layout_.tools, desk_, do_it);
  if (layout_.side.width > 0) {
    const Shape<2>& shape = desk_.shape();
    const auto measured = [this](double seconds) {
      return scripted() ? std::nullopt : std::optional<double>(seconds);
    };
    side_panel_.draw(layout_.side, desk_, shown_,
                     {.curve = painter_.picture().curve,
                      .solve_seconds = measured(shape.report.seconds),
                      .draw_seconds = measured(painter_.draft_seconds()),
                      .refit_difference = solver_.last_difference(),
                      .solving = shape.pending},
                     do_it);
  }
  tour_.watch(desk_);
  switch (tour_.frame(layout_.tour)) {
    case Tour::Wish::back:
      when_recorded([this] { tour_to(tour_.step() - 1); });
      break;
    case Tour::Wish::next:
      when_recorded([this] { tour_to(tour_.step() + 1); });
      break;
    case Tour::Wish::stop:
      tour_.stop();
      break;
    case Tour::Wish::none:
      break;
  }
  help_.frame(window_.width(), window_.height());
  values_.frame(desk_);
  gallery_.frame(window_.width(), window_.height(), window_.pixel_ratio(), window_.dark());
  files_.frame();
  questions_.frame();

  place_everything();
  // The plate first: without a graphics card other threads draw it while this one paints the scene.
  draw_plate();
  draw_scene();
  draw_profile_chart();
  draw_status();
  look_after_settings();
  look_after_autosave();
  const std::string title = desk_.name() + " \u2013 Seesaw";
  if (title != title_) window_.set_title(title_ = title);
  if (!window_picture_.empty()) export_window(dialog || ui::any_dialog());
  changed_ = false;
}

bool App::settled() const {
  return painter_.picture().fine && !solver_.busy() && !other_solver_.busy() &&
         (!shown_.plate || layout_.plate.width == 0 || plate_.settled());
}

void App::draw_status() {
  const auto panel = ui::panel("Status", layout_.status, {.title = false, .scrolls = false});
  if (!panel) return;
  const double now = window_.clock().time();
  const DeskMessage& message = desk_.message();
  if (message.number != message_seen_) {
    message_seen_ = message.number;
    message_since_ = now;
    message_of_ = {desk_.revision(), desk_.tool()};
  }
  const Shape<2>& shape = desk_.shape();
  const auto reading = [&]() -> std::string {
    const auto cursor = desk_.cursor();
    if (!cursor || !pointer_in_scene_) return "";
    const double pixel = desk_.view().pixel();
    std::string words = "x " + to_text(cursor->x(), digits_for(cursor->x(), pixel)) + "   y " +
                        to_text(cursor->y(), digits_for(cursor->y(), pixel));
    if (shape.function) words += "   f " + to_text(shape.function->value(*cursor), 3);
    return words;
  }();
  const double room = ui::width_left() - ui::text_width(reading) - 24 * window_.scale();
  const UiColors colors = ui::colors();
  std::string words;
  Color color = colors.soft_ink;
  // Until its time is over, or something else has been done.
  const bool fresh = message.number > 0 && !message.text.empty() && now - message_since_ < message_stays &&
                     message_of_ == std::pair(desk_.revision(), desk_.tool());
  // What was just asked for and refused comes before what has been wrong for a while.
  const bool first = fresh && (message.trouble || desk_.editor().size() == 0);
  const auto count = [&](ConstraintKind kind) { return all_of(desk_.document(), kind).size(); };
  const bool unbounded = count(ConstraintKind::boundary) == 0 &&
                         (count(ConstraintKind::interior) == 0) != (count(ConstraintKind::exterior) == 0);
  if (shape.impossible && !first && desk_.editor().size() > 0) {
    words = shape.impossible->message;
    color = colors.warning;
  } else if (fresh) {
    words = message.text;
    color = message.trouble ? colors.warning : colors.ink;
  } else if (shape.pending) {
    words = "solving " + std::to_string(desk_.editor().size()) + " constraints\u2026";
    if (const auto fraction = solver_.fraction(); fraction && *fraction > 0.0)
      words += " " + std::to_string(std::lround(100 * *fraction)) + " %";
    color = colors.accent;
  } else if (shape.function && asks_for_zero_alone(desk_.document())) {
    words = "f is 0 everywhere: an interior, exterior or normal constraint says which side is which";
    color = colors.accent;
  } else if (shape.function && unbounded) {
    words =
        count(ConstraintKind::interior) > 0 ? "all constraints are inside" : "all constraints are outside";
    words += ": press B and click where the curve is to pass";
    color = colors.accent;
  } else {
    words = tool_infos()[static_cast<std::size_t>(desk_.tool())].hint;
  }
  if (desk_.recording()) {
    ui::colored_text("\u25cf recording", colors.warning);
    ui::same_line();
  }
  const std::string shown = ui::shortened(words, room);
  ui::colored_text(shown, color);
  if (shown != words && ui::last_hovered()) ui::tooltip(words);
  if (!reading.empty()) {
    ui::same_line();
    ui::flush_right(ui::text_width(reading));
    ui::soft_text(reading);
  }
  // So that it goes when its time is over.
  if (fresh && now - message_since_ > message_stays - 0.5) window_.stay_awake();
}

void App::look_after_settings() {
  Settings settings = settings_.settings();
  settings.scale = window_.scale();
  settings.dark = window_.dark();
  if (!window_.full_screen()) {
    settings.window_width = window_.width();
    settings.window_height = window_.height();
  }
  settings.tour_seen = settings.tour_seen || tour_seen_;
  if (!files_.folder().empty()) settings.last_folder = files_.folder();
  settings.panels["panels"] = panels_;
  settings.panels["plate"] = shown_.plate;
  settings.panels["weights"] = shown_.weights;
  settings_.keep(settings);
}

void App::look_after_autosave() {
  if (autosave_folder_.empty()) return;
  autosave_.tick(desk_.unsaved(), desk_.revision(), window_.clock().time(), [this] {
    return Keepsake{AnyDocument(desk_.to_save()), desk_.path()};
  });
  if (discard_when_saved_ && !desk_.unsaved()) {
    discard(*discard_when_saved_);
    discard_when_saved_.reset();
  }
  const std::string trouble = autosave_.trouble();
  if (!trouble.empty()) desk_.say(trouble, true);
}

}  // namespace seesaw
