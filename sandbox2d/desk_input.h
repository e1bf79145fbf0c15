// What a window hears, as what a desk understands: pixels become scene units, keys keep their names.
//
// Before it: Window::begin_frame. After it: Desk::handle.
#pragma once

#include <optional>

#include "core/editing/desk_events.h"
#include "core/editing/view_2d.h"
#include "core/window/input.h"

namespace seesaw {

/// `origin` is the top left corner of the scene's place in the window, logical pixels; `view` is as wide and
/// high as that. Nothing for what a desk does not hear of: text, sizes, keys that it does not know.
std::optional<DeskEvent> desk_event(const InputEvent& input, const View2D& view, const Point<2>& origin);

}  // namespace seesaw
