// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/motion/Gamepad.h"

#include <SDL.h>

#include <algorithm>
#include <cmath>

namespace widgets {
namespace {

constexpr double kDeadZone = 0.15;

double axisValue(Sint16 raw) {
  const double value = std::clamp(raw / 32767.0, -1.0, 1.0);
  const double magnitude = std::max(0.0, std::abs(value) - kDeadZone) / (1 - kDeadZone);
  return std::copysign(magnitude, value) + 0.0;
}

}  // namespace

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

  double axis(SDL_GameControllerAxis which) const { return axisValue(SDL_GameControllerGetAxis(pad, which)); }
  bool button(SDL_GameControllerButton which) const { return SDL_GameControllerGetButton(pad, which) != 0; }

  bool available = false;
  SDL_GameController* pad = nullptr;
};

Gamepad::Gamepad() : device_(std::make_unique<Device>()) {}
Gamepad::~Gamepad() = default;

Gamepad::State Gamepad::poll() {
  State state;
  if (!device_->available) return state;
  SDL_GameControllerUpdate();
  if (device_->pad != nullptr && SDL_GameControllerGetAttached(device_->pad) == SDL_FALSE) device_->close();
  if (device_->pad == nullptr) device_->openFirst();
  if (device_->pad == nullptr) return state;
  state.connected = true;
  const char* name = SDL_GameControllerName(device_->pad);
  state.name = QString::fromUtf8(name != nullptr ? name : "");
  state.axes = {-device_->axis(SDL_CONTROLLER_AXIS_LEFTY), -device_->axis(SDL_CONTROLLER_AXIS_LEFTX),
                -device_->axis(SDL_CONTROLLER_AXIS_RIGHTX)};
  state.kick = device_->button(SDL_CONTROLLER_BUTTON_A);
  state.stop = device_->button(SDL_CONTROLLER_BUTTON_B);
  return state;
}

}  // namespace widgets
