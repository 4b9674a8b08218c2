// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/SceneLayers.h"

#include <algorithm>
#include <iterator>

#include "robotcontrol/World.pb.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/session/Session.h"
#include "widgets/scene/SceneAssembly.h"
#include "widgets/scene/SceneModes.h"
#include "widgets/scene/ShownParts.h"

namespace widgets {
namespace {

template <typename T>
void append(std::vector<T> from, std::vector<T>& to) {
  std::ranges::move(from, std::back_inserter(to));
}

}  // namespace

void SceneLayers::add(const Sources& sources, VisibleScene& contents) {
  const SceneModes& modes = sources.modes;
  contents.shadows = modes.shows(SceneLayer::kShadows);
  if (!modes.shows(SceneLayer::kVisuals))
    std::erase_if(contents.bodies, [](const SceneBody& body) { return body.object != nullptr; });
  if (modes.shows(SceneLayer::kSolids)) addSolids(sources, contents);
  addMarkers(sources, contents);
  addNames(sources, contents);
}

void SceneLayers::addSolids(const Sources& sources, VisibleScene& contents) {
  const auto* stream = sources.session.store().find(robotlink::streams::kSolids);
  if (stream == nullptr || stream->messages.empty()) return;
  // Edges over other shapes are highlighted by the color of the message; as surfaces it would glare.
  const bool areEdges = sources.modes.shows(SceneLayer::kVisuals);
  auto solids = sources.assembly.solids(stream->messages.back().value, sources.scene,
                                        areEdges ? nullptr : &sources.palette);
  std::erase_if(
      solids, [&](const SceneBody& solid) { return solid.object && !sources.parts.isShown(*solid.object); });
  if (areEdges) {
    contents.solids = std::move(solids);
    return;
  }
  for (SceneBody& solid : solids) solid.surface = sources.modes.surface();
  append(std::move(solids), contents.bodies);
}

void SceneLayers::addMarkers(const Sources& sources, VisibleScene& contents) {
  const SceneModes& modes = sources.modes;
  const SceneObjects& objects = sources.parts.objects();
  const ObjectFilter isShown = [&](const std::string& path) { return sources.parts.isShown(path); };
  const auto shown = sources.session.timeline().shown();
  if (modes.shows(SceneLayer::kForces))
    append(forces_.bodies(sources.session, shown, sources.parts.revision(), isShown), contents.markers);
  if (modes.shows(SceneLayer::kJoints))
    append(markers_.joints(objects, sources.scene, isShown), contents.markers);
  if (modes.shows(SceneLayer::kFrames))
    append(markers_.frames(objects, sources.scene, isShown), contents.markers);
  if (modes.shows(SceneLayer::kCenters))
    append(markers_.centers(objects, sources.scene, isShown), contents.markers);
  if (modes.shows(SceneLayer::kSensors))
    append(sensors_.bodies(sources.session, objects, sources.scene, shown, isShown), contents.drawings);
}

void SceneLayers::addNames(const Sources& sources, VisibleScene& contents) {
  const SceneObjects& objects = sources.parts.objects();
  if (sources.modes.shows(SceneLayer::kNames))
    append(modelNames(objects, sources.scene,
                      [&](const std::string& path) { return sources.parts.isShown(path); }),
           contents.labels);
  const auto* selected = objects.find(sources.selected);
  if (!sources.modes.shows(SceneLayer::kJoints) || selected == nullptr) return;
  append(jointNames(objects, sources.scene,
                    [&](const std::string& path) {
                      return objects.isWithin(path, selected->path()) && sources.parts.isShown(path);
                    }),
         contents.labels);
}

}  // namespace widgets
