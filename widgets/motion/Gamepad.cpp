// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/motion/Gamepad.h"

#include <SDL.h>

#include <algorithm>

namespace widgets {
/// SDL's game controller subsystem, initialized as long as this object lives, and the gamepad that is open.
struct Gamepad::Device {
  Device() {
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");
    available = SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER) == 0;
  }
  ~Device() {
    close();
    if (available) SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
  }
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  void close() {
    if (pad != nullptr) SDL_GameControllerClose(pad);
    pad = nullptr;
  }

  void openFirst() {
    for (int i = 0; pad == nullptr && i < SDL_NumJoysticks(); ++i) {
      if (SDL_IsGameController(i) == SDL_TRUE) pad = SDL_GameControllerOpen(i);
    }
  }

  /// The names of axes and buttons are in SDL's order; older versions of it know fewer buttons.
  GamepadReading read() const {
    GamepadReading reading;
    for (std::size_t i = 0; i < std::min<std::size_t>(reading.axes.size(), SDL_CONTROLLER_AXIS_MAX); ++i)
      reading.axes[i] = SDL_GameControllerGetAxis(pad, static_cast<SDL_GameControllerAxis>(i)) / 32767.0;
    for (std::size_t i = 0; i < std::min<std::size_t>(reading.buttons.size(), SDL_CONTROLLER_BUTTON_MAX); ++i)
      reading.buttons[i] = SDL_GameControllerGetButton(pad, static_cast<SDL_GameControllerButton>(i)) != 0;
    return reading;
  }

  bool available = false;
  SDL_GameController* pad = nullptr;
};

Gamepad::Gamepad() : device_(std::make_unique<Device>()) {}
Gamepad::~Gamepad() = default;

Gamepad::State Gamepad::poll(const GamepadBindings& bindings) {
  State state;
  if (!device_->available) return state;
  SDL_GameControllerUpdate();
  if (device_->pad != nullptr && SDL_GameControllerGetAttached(device_->pad) == SDL_FALSE) device_->close();
  if (device_->pad == nullptr) device_->openFirst();
  if (device_->pad == nullptr) return state;
  state.connected = true;
  const char* name = SDL_GameControllerName(device_->pad);
  state.name = QString::fromUtf8(name != nullptr ? name : "");
  const GamepadReading reading = device_->read();
  state.axes = walkAxes(reading, bindings);
  state.kick = isPressedAsShipped(reading, bindings, "a");
  state.stop = isPressedAsShipped(reading, bindings, "b");
  state.commands = pressedCommands(reading, bindings);
  return state;
}

}  // namespace widgets
