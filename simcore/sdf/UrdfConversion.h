// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <string>

#include "robotlink/base/Error.h"
#include "simcore/world/LeftOut.h"

namespace tinyxml2 {
class XMLElement;
}  // namespace tinyxml2

namespace simcore {

/// The parts of a URDF that are needed after its conversion.
struct UrdfParts {
  /// Lines in the URDF.
  int line = 1;
  std::map<std::string, int> links, joints;
  /// Joints that leave their links apart; they are converted as others.
  std::set<std::string> apart;
  /// Links that move relative to another one; libsdformat makes those that do not a part of that.
  std::set<std::string> moving;
};

/// Returns the problems with a URDF, with their lines. libsdformat, which converts it, writes its reasons to
/// the console only, if it has any, and leaves links out whose numbers it cannot read. Refuses also URDFs
/// whose conversion would take more than 700 MB. Adds what SDFormat does not have, and prepares `robot` for
/// being converted.
robotlink::Errors checkUrdf(tinyxml2::XMLElement& robot, const std::string& file, UrdfParts& parts,
                            LeftOuts& leftOut);

/// The SDFormat text of a URDF text, as libsdformat converts it. `file` is the name that the error carries.
robotlink::Result<std::string> sdfOfUrdf(const std::string& text, const std::string& file);

/// Completes the SDFormat of a URDF: its elements get the lines that they come from, joints that leave their
/// links apart become frames, and links that libsdformat has left out are reported.
void finishUrdf(tinyxml2::XMLElement& sdf, const std::string& file, const UrdfParts& parts,
                LeftOuts& leftOut);

}  // namespace simcore
