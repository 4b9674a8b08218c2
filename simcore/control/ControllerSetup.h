// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "simcore/control/ControllerKind.h"
#include "simcore/world/ControllerDescription.h"

namespace simcore {

/// The inputs from which a controller is created: the parameters in its scene, and the views that it adds.
/// Only valid while it is made. A parameter that its kind does not declare throws std::logic_error.
class ControllerSetup {
 public:
  /// More outputs of one controller, more values in one, or larger images throw std::length_error.
  static constexpr std::size_t kMaxOutputs = 100, kMaxValues = 100'000;
  static constexpr int kMaxImageSide = 4096;

  /// All must outlive it. `model` is the name of the controller's model, empty for one of the world.
  ControllerSetup(const ControllerKind& kind, const ControllerDescription& description,
                  const std::string& model, ControlledWorld& world, std::deque<ControllerOutput>& outputs);

  const std::string& model() const { return model_; }
  ControlledWorld& world() { return world_; }

  double number(const std::string& parameter) const;
  std::vector<double> numbers(const std::string& parameter) const;
  const std::string& text(const std::string& parameter) const;
  /// The whole path of the port that the parameter names; empty if it names none. And of several.
  std::string port(const std::string& parameter) const;
  std::vector<std::string> portsOf(const std::string& parameter) const;

  // The outputs live as long as the controller; it may keep the references. Names are those of paths, such as
  // "floor" or "panel/image"; one that is taken throws std::logic_error.
  /// Adds numbers, which are 0 at first. The shape is empty for one number.
  ControllerOutput& addValues(const std::string& name, const std::string& type, std::vector<int> shape = {},
                              const std::string& unit = {}, double minimum = 0, double maximum = 0);
  /// Adds an image of this size, kRgb8 or kMono8, which is black at first.
  ControllerOutput& addImage(const std::string& name, int width, int height,
                             robotlink::PixelFormat format = robotlink::PixelFormat::kRgb8);
  /// Adds a drawing in the world, which is empty at first.
  ControllerOutput& addDrawing(const std::string& name);

 private:
  ControllerOutput& add(const std::string& name, const std::string& type, ControllerOutput::Kind kind);

  const ControllerKind& kind_;
  const ControllerDescription& description_;
  const std::string& model_;
  ControlledWorld& world_;
  std::deque<ControllerOutput>& outputs_;
};

}  // namespace simcore
