// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "robotlink/base/Error.h"

namespace tinyxml2 {
class XMLElement;
}  // namespace tinyxml2

namespace simcore {

/// What is wrong with a URDF, with its lines. libsdformat, which converts it, writes its reasons to the
/// console only, if it has any, and leaves links out whose numbers it cannot read. Also URDFs are refused
/// whose conversion would take more than 700 MB.
robotlink::Errors problemsOfUrdf(const tinyxml2::XMLElement& robot, const std::string& file);

/// The SDFormat text of a URDF text, as libsdformat converts it. `file` is the name that the error carries.
robotlink::Result<std::string> sdfOfUrdf(const std::string& text, const std::string& file);

}  // namespace simcore
