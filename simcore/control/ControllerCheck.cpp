// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/control/ControllerCheck.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>
#include <sstream>

#include "robotlink/base/Spelling.h"

namespace simcore {
namespace {

using Type = ControllerParameter::Type;

template <typename Named>
std::vector<std::string> namesOf(const std::vector<Named>& all) {
  std::vector<std::string> names;
  for (const auto& each : all) names.push_back(each.name);
  return names;
}

std::string shortNumberOf(double value) {
  std::ostringstream stream;
  stream << value;
  return stream.str();
}

/// Returns the problem with a value; empty if it is valid.
std::string wrongValue(const ControllerParameter& parameter, const std::string& value) {
  if (parameter.type != Type::kNumber && parameter.type != Type::kNumbers)
    return value.empty() && parameter.required ? "is empty" : "";
  const auto numbers = numbersOf(value);
  const bool isOne = parameter.type == Type::kNumber;
  if (!numbers || (isOne && numbers->size() != 1))
    return std::string("must be ") + (isOne ? "one finite number" : "finite numbers") + ", not '" +
           value.substr(0, 60) + "'";
  if (parameter.maximum <= parameter.minimum) return {};
  for (const double number : *numbers) {
    if (number >= parameter.minimum && number <= parameter.maximum) continue;
    return "must be between " + shortNumberOf(parameter.minimum) + " and " +
           shortNumberOf(parameter.maximum) + ", not " + shortNumberOf(number);
  }
  return {};
}

/// Reports errors of one controller.
class ControllerChecker {
 public:
  ControllerChecker(const ControllerDescription& description, const std::string& object,
                    robotlink::Errors& errors)
      : description_(description),
        path_((object.empty() ? "" : object + "/") + description.name),
        errors_(errors) {}

  void check() {
    const ControllerKind* kind = controllerKind(description_.kind);
    if (kind == nullptr) {
      return fail(description_.where,
                  "there is no controller '" + description_.kind + "'" +
                      robotlink::suggestion(description_.kind, namesOf(controllerKinds())));
    }
    std::set<std::string> given;
    for (const ControllerArgument& argument : description_.arguments) checkArgument(*kind, argument, given);
    for (const ControllerParameter& parameter : kind->parameters) {
      if (!parameter.required || given.contains(parameter.name)) continue;
      fail(description_.where, "the controller '" + kind->name + "' needs the parameter '" + parameter.name +
                                   "': " + parameter.help);
    }
  }

  void checkNamed(const WorldDescription& world, const std::string& model, const std::vector<Port>& ports) {
    const ControllerKind* kind = controllerKind(description_.kind);
    if (kind == nullptr) return;
    for (const ControllerArgument& argument : description_.arguments) {
      const auto parameter = std::ranges::find(kind->parameters, argument.name, &ControllerParameter::name);
      if (parameter == kind->parameters.end() || argument.value.empty()) continue;
      if (parameter->type == Type::kModel) checkModel(world, argument);
      if (parameter->type == Type::kSensor || parameter->type == Type::kActuator)
        checkPort(model, *parameter, argument, argument.value, ports);
      if (parameter->type != Type::kSensors) continue;
      for (const std::string& named : wordsOf(argument.value))
        checkPort(model, *parameter, argument, named, ports);
    }
  }

  void fail(const robotlink::FilePosition& where, const std::string& text) {
    errors_.push_back({"scene.controller", path_ + ": " + text, {description_.name}, where});
  }

 private:
  void checkArgument(const ControllerKind& kind, const ControllerArgument& argument,
                     std::set<std::string>& given) {
    const auto parameter = std::ranges::find(kind.parameters, argument.name, &ControllerParameter::name);
    if (parameter == kind.parameters.end()) {
      const std::string none = kind.parameters.empty() ? "; it has none" : "";
      return fail(argument.where, "the controller '" + kind.name + "' has no parameter '" + argument.name +
                                      "'" + none +
                                      robotlink::suggestion(argument.name, namesOf(kind.parameters)));
    }
    if (!given.insert(argument.name).second)
      return fail(argument.where, "the parameter '" + argument.name + "' is given twice");
    if (const std::string wrong = wrongValue(*parameter, argument.value); !wrong.empty())
      fail(argument.where, "the parameter '" + argument.name + "' " + wrong);
  }

  void checkModel(const WorldDescription& world, const ControllerArgument& argument) {
    if (std::ranges::find(world.models, argument.value, &ModelInstance::name) != world.models.end()) return;
    fail(argument.where, "there is no model '" + argument.value + "'" +
                             robotlink::suggestion(argument.value, namesOf(world.models)));
  }

  void checkPort(const std::string& model, const ControllerParameter& parameter,
                 const ControllerArgument& argument, const std::string& named,
                 const std::vector<Port>& ports) {
    const bool acts = parameter.type == Type::kActuator;
    const char* what = acts ? "actuator" : "sensor";
    const std::string path = portPath(description_, model, named, ports);
    const auto port = std::ranges::find(ports, path, [](const Port& each) { return each.info.path; });
    if (port != ports.end() && port->isActuator() == acts) return;
    std::vector<std::string> known;
    for (const Port& each : ports) {
      if (each.isActuator() == acts && known.size() < kMaxKnown) known.push_back(each.info.path);
    }
    fail(argument.where,
         std::string("there is no ") + what + " '" + named + "'" + robotlink::suggestion(named, known));
  }

  /// The most ports that are named in an error.
  static constexpr std::size_t kMaxKnown = 20;

  const ControllerDescription& description_;
  const std::string path_;
  robotlink::Errors& errors_;
};

void checkAll(const std::vector<ControllerDescription>& all, const std::string& model,
              const WorldDescription& world, const std::vector<Port>& ports, robotlink::Errors& errors) {
  std::set<std::string> names;
  for (const ControllerDescription& description : all) {
    ControllerChecker checker(description, model, errors);
    checker.checkNamed(world, model, ports);
    if (!names.insert(description.name).second)
      checker.fail(description.where, "there is another controller '" + description.name +
                                          "' here; give it a name with the attribute 'as'");
    const std::string path = (model.empty() ? "" : model + "/") + description.name + "/";
    const bool taken =
        std::ranges::any_of(ports, [&](const Port& port) { return port.info.path.starts_with(path); });
    if (taken)
      checker.fail(description.where, "the ports of '" + description.name +
                                          "' would have the same paths as others; give it a name with the "
                                          "attribute 'as'");
  }
}

}  // namespace

std::vector<std::string> wordsOf(const std::string& text) {
  std::vector<std::string> words;
  std::istringstream stream(text);
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::optional<std::vector<double>> numbersOf(const std::string& text) {
  std::vector<double> numbers;
  for (const std::string& word : wordsOf(text)) {
    char* end = nullptr;
    numbers.push_back(std::strtod(word.c_str(), &end));
    if (end != word.c_str() + word.size() || !std::isfinite(numbers.back())) return std::nullopt;
  }
  return numbers;
}

std::string portPath(const ControllerDescription& description, const std::string& model,
                     const std::string& named, const std::vector<Port>& ports) {
  const auto exists = [&](const std::string& path) {
    return std::ranges::any_of(ports, [&](const Port& port) { return port.info.path == path; });
  };
  if (!model.empty()) {
    for (const std::string& own : {model + "/" + description.prefix + named, model + "/" + named}) {
      if (exists(own)) return own;
    }
  }
  return exists(named) ? named : std::string();
}

void checkController(const ControllerDescription& description, const std::string& object,
                     robotlink::Errors& errors) {
  ControllerChecker(description, object, errors).check();
}

void checkControllers(const WorldDescription& world, const std::vector<Port>& ports,
                      robotlink::Errors& errors) {
  checkAll(world.controllers, {}, world, ports, errors);
  for (const ModelInstance& model : world.models)
    checkAll(model.type->controllers, model.name, world, ports, errors);
}

}  // namespace simcore
