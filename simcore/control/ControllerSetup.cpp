// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/control/ControllerSetup.h"

#include <algorithm>
#include <stdexcept>

#include "simcore/control/ControllerCheck.h"

namespace simcore {

ControllerSetup::ControllerSetup(const ControllerKind& kind, const ControllerDescription& description,
                                 const std::string& model, ControlledWorld& world,
                                 std::deque<ControllerOutput>& outputs)
    : kind_(kind), description_(description), model_(model), world_(world), outputs_(outputs) {}

const std::string& ControllerSetup::text(const std::string& parameter) const {
  const auto declared = std::ranges::find(kind_.parameters, parameter, &ControllerParameter::name);
  if (declared == kind_.parameters.end())
    throw std::logic_error("the kind '" + kind_.name + "' declares no parameter '" + parameter + "'");
  const auto& given = description_.arguments;
  const auto argument = std::ranges::find(given, parameter, &ControllerArgument::name);
  return argument == given.end() ? declared->initial : argument->value;
}

std::vector<double> ControllerSetup::numbers(const std::string& parameter) const {
  auto all = numbersOf(text(parameter));
  if (!all) throw std::logic_error("the parameter '" + parameter + "' is no list of numbers");
  return std::move(*all);
}

double ControllerSetup::number(const std::string& parameter) const {
  const std::vector<double> all = numbers(parameter);
  if (all.size() != 1) throw std::logic_error("the parameter '" + parameter + "' is no number");
  return all.front();
}

std::string ControllerSetup::port(const std::string& parameter) const {
  const std::vector<std::string> all = portsOf(parameter);
  return all.empty() ? std::string() : all.front();
}

std::vector<std::string> ControllerSetup::portsOf(const std::string& parameter) const {
  const auto all = world_.ports();
  const std::vector<Port> ports(all.begin(), all.end());
  std::vector<std::string> paths = wordsOf(text(parameter));
  for (std::string& path : paths) path = portPath(description_, model_, path, ports);
  return paths;
}

ControllerOutput& ControllerSetup::add(const std::string& name, const std::string& type,
                                       ControllerOutput::Kind kind) {
  const std::string path = (model_.empty() ? "" : model_ + "/") + description_.name + "/" + name;
  const auto isTaken = [&](const ControllerOutput& each) { return each.info.path == path; };
  if (name.empty() || std::ranges::any_of(outputs_, isTaken))
    throw std::logic_error("the controller has another output '" + name + "'");
  if (outputs_.size() >= kMaxOutputs) throw std::length_error("a controller has 100 outputs at most");
  ControllerOutput& output = outputs_.emplace_back();
  output.info.path = path;
  output.info.robot = model_;
  output.info.type = type;
  output.kind = kind;
  return output;
}

ControllerOutput& ControllerSetup::addValues(const std::string& name, const std::string& type,
                                             std::vector<int> shape, const std::string& unit, double minimum,
                                             double maximum) {
  std::size_t count = 1;
  for (const int size : shape) {
    count *= static_cast<std::size_t>(std::max(size, 0));
    if (count == 0 || count > kMaxValues)
      throw std::length_error("the output '" + name + "' has 1 to 100000 values");
  }
  ControllerOutput& output = add(name, type, ControllerOutput::Kind::kValues);
  output.info.shape = std::move(shape);
  output.info.unit = unit;
  output.info.minimum = minimum;
  output.info.maximum = maximum;
  output.values.assign(count, 0);
  return output;
}

ControllerOutput& ControllerSetup::addImage(const std::string& name, int width, int height,
                                            robotlink::PixelFormat format) {
  if (width < 1 || height < 1 || width > kMaxImageSide || height > kMaxImageSide)
    throw std::length_error("the image '" + name + "' has 1 to 4096 pixels at a side");
  if (format != robotlink::PixelFormat::kRgb8 && format != robotlink::PixelFormat::kMono8)
    throw std::logic_error("the image '" + name + "' is neither RGB nor gray");
  ControllerOutput& output = add(name, "image", ControllerOutput::Kind::kImage);
  const int channels = robotlink::bytesPerPixel(format);
  output.info.shape = {height, width, channels};
  output.image.width = width;
  output.image.height = height;
  output.image.format = format;
  output.image.data.assign(
      static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * static_cast<std::size_t>(channels),
      0);
  return output;
}

ControllerOutput& ControllerSetup::addDrawing(const std::string& name) {
  return add(name, "drawing", ControllerOutput::Kind::kDrawing);
}

}  // namespace simcore
