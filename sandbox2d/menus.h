// The menu bar and the tools at the left: every command of the desk by name, with its key beside it.
//
// Before it: core/editing/desk_bindings.h, whose table also writes F1. After it: App::act.
#pragma once

#include <filesystem>
#include <functional>

#include "core/editing/desk.h"
#include "core/editing/recent_files.h"
#include "sandbox2d/side_panel.h"

namespace seesaw {

struct MenuState {
  const RecentFiles& recent;
  Shown shown;
  bool panels = true;
  bool dark = false;
  bool full_screen = false;
};

struct MenuActions {
  std::function<void(DeskCommand)> act;
  std::function<void(const std::filesystem::path&)> open;
};

void draw_menu_bar(Desk& desk, const MenuState& state, const MenuActions& actions);

/// One button a tool, with its letter; below, what lines and circles are made of.
void draw_tools(const Rect& place, Desk& desk, const std::function<void(DeskCommand)>& act);

}  // namespace seesaw
