// SDL's events to ours and back: the border behind which nobody knows SDL's names.
//
// Before it: SDL's queue. After it: input_queue.h. The way back is the script's (script_player.cpp), which
// types and clicks by putting SDL's own events into SDL's own queue, so that a scripted run passes through
// everything that a person's does.
#pragma once

#include <cstdint>
#include <optional>

#include "core/window/input.h"

union SDL_Event;

namespace seesaw {

/// What `event` is to us, or nothing for one of those that do not matter here. Frees what SDL wants freed.
std::optional<InputEvent> input_of(const SDL_Event& event);

/// Puts the event into SDL's queue as if a hand had done it to the window of SDL's number `window`. A key
/// carries its chord's modifiers, and from then on they count as held, for the pointer too, until a key is
/// released. Throws Error where SDL refuses.
void push_to_sdl(const InputEvent& event, std::uint32_t window);

/// Puts a Woken into SDL's queue; from any thread.
void push_wake_to_sdl();

}  // namespace seesaw
