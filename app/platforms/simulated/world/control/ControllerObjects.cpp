// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/world/control/ControllerObjects.h"

#include <string>

#include "app/platforms/simulated/world/control/ExternalControllers.h"
#include "robotcontrol/World.pb.h"
#include "simcore/Simulation.h"

namespace app {
namespace {

using robotcontrol::WorldObject;

void addProperty(WorldObject& to, const char* name, const std::string& text) {
  if (text.empty()) return;
  auto& property = *to.add_properties();
  property.set_name(name);
  property.set_text(text);
}

/// Adds the controllers, each with the views that it adds below it.
class ControllerWriter {
 public:
  explicit ControllerWriter(robotcontrol::WorldObjects& to) : to_(to) {}

  void add(const simcore::Simulation& simulation) {
    for (const simcore::ControllerStatus& each : simulation.controllers()) {
      addController(each.path, each.model, each.kind, each.trouble);
      for (const auto* output : simulation.outputs()) {
        if (!output->info.path.starts_with(each.path + "/")) continue;
        const bool isImage = output->kind == simcore::ControllerOutput::Kind::kImage;
        addOutput(output->info, each.path, each.model).set_image_stream(isImage ? output->info.path : "");
      }
    }
  }

  void add(const ExternalControllers& external) {
    for (const std::string& name : external.names()) addController(name, {}, "program elsewhere", {});
    for (const auto* output : external.outputs()) addOutput(output->info, output->info.robot, {});
  }

 private:
  /// The name of a controller's object is not that of its ports, which begin with the path of a model.
  static std::string objectPath(const std::string& path, const std::string& model) {
    return model.empty() ? "controller:" + path : model + "/controller:" + path.substr(model.size() + 1);
  }

  void addController(const std::string& path, const std::string& model, const std::string& kind,
                     const std::string& trouble) {
    WorldObject& object = *to_.add_objects();
    object.set_kind(WorldObject::CONTROLLER);
    object.set_path(objectPath(path, model));
    object.set_name(path.substr(model.empty() ? 0 : model.size() + 1));
    object.set_parent(model);
    object.set_model(model);
    addProperty(object, "type", kind);
    addProperty(object, "trouble", trouble);
  }

  robotcontrol::WorldPort& addOutput(const simcore::PortInfo& info, const std::string& controller,
                                     const std::string& model) {
    WorldObject& object = *to_.add_objects();
    object.set_kind(WorldObject::SENSOR);
    object.set_path(info.path);
    object.set_name(info.path.substr(controller.size() + 1));
    object.set_parent(objectPath(controller, model));
    object.set_model(model);
    auto& port = *object.mutable_port();
    port.set_path(info.path);
    port.set_robot(model);
    port.set_type(info.type);
    port.set_unit(info.unit);
    port.set_minimum(info.minimum);
    port.set_maximum(info.maximum);
    for (const int size : info.shape) port.add_shape(size);
    return port;
  }

  robotcontrol::WorldObjects& to_;
};

}  // namespace

void addControllers(const simcore::Simulation& simulation, const ExternalControllers* external,
                    robotcontrol::WorldObjects& to) {
  ControllerWriter writer(to);
  writer.add(simulation);
  if (external != nullptr) writer.add(*external);
}

}  // namespace app
