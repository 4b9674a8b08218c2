// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of SdfConversion.h that read sensors, motors and radiation. Internal to the sources that include
// libsdformat.
#pragma once

#include "simcore/sdf/SdfConversion.h"

namespace simcore {

/// The number in one of our own elements, or `otherwise` if it is missing, or left out because it is not in
/// its range; `name` is without the namespace.
double ownNumber(const sdf::ElementPtr& parent, const char* name, double otherwise, double minimum,
                 double maximum, const SdfContext& context);
/// The texts of all our own elements of a name.
std::vector<std::string> ownTexts(const sdf::ElementPtr& parent, const char* name);
/// The descendant of `element` along a path of names; null if there is none.
sdf::ElementPtr descendant(sdf::ElementPtr element, std::initializer_list<const char*> path);

/// Reads a <noise> of SDFormat; its standard deviation must be at most `most`.
NoiseModel readNoise(const sdf::Noise& noise, double most, const sdf::ElementPtr& element,
                     const SdfContext& context);
/// Reads our own elements of noise and timing, which count for all channels, into `errors`.
void readOwnErrors(const sdf::ElementPtr& element, SensorErrors& errors, const SdfContext& context);

/// Reads a camera of any type.
void readCamera(const sdf::Sensor& sensor, SensorDescription& result, const SdfContext& context);
/// Reads <robotcontrol:facette>.
void readFacettes(const sdf::ElementPtr& sensor, SensorDescription& result, const SdfContext& context);
/// The image sensors that belong to a camera that was read: the depth of an rgbd_camera.
std::vector<SensorDescription> depthOfColorCamera(const sdf::Sensor& sensor, const SensorDescription& color);

/// Reads the sensors of the joints; joints must be in their final order.
void readJointSensors(const sdf::Model& source, ModelDescription& model, const SdfContext& context);
/// Reads how a <robotcontrol:servo> is controlled, and the sensors of its joint.
void readMotor(const sdf::ElementPtr& joint, JointDescription& result, const SdfContext& context);
/// Reads the <robotcontrol:door>s of the joints; all sensors must have been read before.
void readDoors(const sdf::Model& source, ModelDescription& model, const SdfContext& context);
/// The reason why a joint cannot carry a wheel; null if it can.
const char* unfitAsWheel(const ModelDescription& model, const JointDescription& joint);
/// Reads <robotcontrol:vehicle>, <robotcontrol:walk> and <robotcontrol:motion> of a model, if it has them;
/// its joints, drive and <robotcontrol:guided> must have been read before.
void readVehicle(const sdf::Model& source, ModelDescription& model, const SdfContext& context);
void readWalk(const sdf::ElementPtr& element, ModelDescription& model, const SdfContext& context);
void readMotion(const sdf::ElementPtr& element, ModelDescription& model, const SdfContext& context);
/// Reads <robotcontrol:guided> of a model, if it has one.
void readGuided(const sdf::ElementPtr& element, ModelDescription& model, const SdfContext& context);

/// Reads the <robotcontrol:controller>s of a model or a world; the names of parts of a model in a model begin
/// with `prefix`.
void readControllers(const sdf::ElementPtr& element, const std::string& prefix,
                     std::vector<ControllerDescription>& to, const SdfContext& context);

/// Reads what a visual reflects and emits, the emitters of a link, what a lamp emits, and the classes of a
/// world.
std::vector<SurfaceRadiation> readSurface(const sdf::ElementPtr& visual, const SdfContext& context);
std::vector<Emitter> readEmitters(const sdf::ElementPtr& link, const SdfContext& context);
std::vector<ClassIntensity> readIntensities(const sdf::ElementPtr& element, const SdfContext& context);
std::vector<RadiationClass> readClasses(const sdf::ElementPtr& world, const SdfContext& context);

}  // namespace simcore
