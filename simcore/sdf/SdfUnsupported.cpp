// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/sdf/SdfUnsupported.h"

#include <tinyxml2.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>

#include "simcore/sdf/SdfPaths.h"

namespace simcore {
namespace {

using tinyxml2::XMLElement;

/// When an element is not worth a report.
enum class Harmless : std::uint8_t { kNever, kAlways, kIfFalse, kIfTrue, kIfZero };

struct Row {
  std::string_view name;
  /// The element that contains it; empty: any.
  std::string_view parent;
  const char* why;
  Harmless harmless = Harmless::kNever;
};

constexpr const char* kOtherSolver = "the solver's settings are the simulator's own";
constexpr const char* kNoSuchContact = "contacts have Coulomb's friction <mu> and restitution only";
constexpr const char* kDiffuseOnly = "a surface has one color, its <diffuse>";
constexpr const char* kNoSky = "the background is one color";
constexpr const char* kNoAir = "there is no air";
constexpr const char* kNoNeed = "";

constexpr Row kRows[] = {
    {"plugin", "", "plugins of other simulators are not run"},
    {"physics", "world", kOtherSolver},
    {"physics", "joint", kOtherSolver},
    {"gui", "", kNoNeed, Harmless::kAlways},
    {"state", "world", kNoNeed, Harmless::kAlways},
    {"spherical_coordinates", "world", "the world has no place on the earth"},
    {"atmosphere", "world", kNoAir},
    {"wind", "", kNoAir, Harmless::kIfZero},
    {"enable_wind", "", kNoAir, Harmless::kIfFalse},
    {"audio", "", "there is no sound"},
    {"audio_source", "", "there is no sound"},
    {"audio_sink", "", "there is no sound"},
    {"actor", "world", "there are no animated figures"},
    {"road", "world", "roads are not drawn"},
    {"population", "world", "populations are not made"},
    {"shadows", "scene", "lamps have shadows", Harmless::kIfTrue},
    {"grid", "scene", kNoNeed, Harmless::kAlways},
    {"origin_visual", "scene", kNoNeed, Harmless::kAlways},
    {"sky", "scene", kNoSky},
    {"fog", "scene", kNoAir},
    {"self_collide", "", "solids of one model do not touch each other", Harmless::kIfFalse},
    {"allow_auto_disable", "model", kNoNeed, Harmless::kAlways},
    {"must_be_base_link", "", kNoNeed, Harmless::kAlways},
    {"kinematic", "link", "links are moved by forces", Harmless::kIfFalse},
    {"gripper", "model", "grippers are only links and joints"},
    {"projector", "link", "there are no projectors"},
    {"battery", "link", "batteries do not run down"},
    {"particle_emitter", "", "there is no smoke"},
    {"light", "link", "only the world has lights"},
    {"light", "model", "only the world has lights"},
    {"max_contacts", "collision", kNoNeed, Harmless::kAlways},
    {"laser_retro", "", "lasers measure distances only", Harmless::kIfZero},
    {"mu2", "ode", kNoSuchContact},
    {"fdir1", "ode", kNoSuchContact, Harmless::kIfZero},
    {"slip1", "ode", kNoSuchContact, Harmless::kIfZero},
    {"slip2", "ode", kNoSuchContact, Harmless::kIfZero},
    {"torsional", "friction", kNoSuchContact},
    {"bullet", "", kNoNeed, Harmless::kAlways},
    {"threshold", "bounce", "surfaces bounce from 5 cm/s on"},
    {"contact", "surface", "contacts have the stiffness of the solver (kp, kd, max_vel, min_depth, ...)"},
    {"soft_contact", "surface", "bodies are rigid"},
    {"script", "material", "material scripts are not read: the color is lost"},
    {"shader", "material", kDiffuseOnly},
    {"pbr", "material", "textures are not drawn"},
    {"specular", "material", kNoNeed, Harmless::kAlways},
    {"ambient", "material", kNoNeed, Harmless::kAlways},
    {"shininess", "material", kNoNeed, Harmless::kAlways},
    {"emissive", "material", kDiffuseOnly, Harmless::kIfZero},
    {"double_sided", "material", kNoNeed, Harmless::kAlways},
    {"render_order", "material", kNoNeed, Harmless::kAlways},
    {"lighting", "material", kDiffuseOnly, Harmless::kIfTrue},
    {"transparency", "visual", "everything is opaque", Harmless::kIfZero},
    {"visibility_flags", "visual", "every camera sees everything"},
    {"meta", "visual", kNoNeed, Harmless::kAlways},
    {"spring_stiffness", "dynamics", "joints have no springs", Harmless::kIfZero},
    {"spring_reference", "dynamics", kNoNeed, Harmless::kAlways},
    {"stiffness", "limit", "stops of joints are hard", Harmless::kAlways},
    {"dissipation", "limit", "stops of joints are hard", Harmless::kAlways},
    {"mimic", "axis", "the joint turns on its own"},
    {"mimic", "axis2", "the joint turns on its own"},
    {"fluid_added_mass", "inertial", "there is no water"},
    {"density", "inertial", "masses are those of <mass>"},
    {"auto_inertia_params", "", "masses are those of <mass>"},
    {"specular", "light", kNoNeed, Harmless::kAlways},
    {"visualize", "light", kNoNeed, Harmless::kAlways},
    {"visualize", "sensor", kNoNeed, Harmless::kAlways},
    {"topic", "sensor", "streams have the names of their sensors", Harmless::kAlways},
    {"always_on", "sensor", kNoNeed, Harmless::kAlways},
    {"enable_metrics", "sensor", kNoNeed, Harmless::kAlways},
};

bool allZero(const std::string& text) {
  const char* at = text.c_str();
  for (char* end = nullptr; *at != '\0'; at = end) {
    if (std::strtod(at, &end) != 0) return false;
    if (end == at) return false;
  }
  return true;
}

bool isHarmless(const XMLElement& element, Harmless when) {
  const std::string text = trimmedText(&element);
  switch (when) {
    case Harmless::kNever:
      return false;
    case Harmless::kAlways:
      return true;
    case Harmless::kIfFalse:
      return !isTrue(text);
    case Harmless::kIfTrue:
      return text.empty() || isTrue(text);
    case Harmless::kIfZero:
      return element.FirstChildElement() == nullptr && allZero(text);
  }
  return false;
}

}  // namespace

Unsupported unsupported(const XMLElement& element) {
  const std::string_view name = element.Name();
  const auto* parent = element.Parent() != nullptr ? element.Parent()->ToElement() : nullptr;
  const std::string_view above = parent != nullptr ? parent->Name() : "";

  const auto* found = std::ranges::find_if(
      kRows, [&](const Row& row) { return row.name == name && (row.parent.empty() || row.parent == above); });
  if (found == std::end(kRows)) return {};
  const bool harmless = isHarmless(element, found->harmless);
  return {harmless ? nullptr : found->why, !harmless};
}

}  // namespace simcore
