// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "robotlink/base/Error.h"

namespace simcore {

/// The SDFormat text of a URDF text, as libsdformat converts it. `file` is the name that the error carries.
robotlink::Result<std::string> sdfOfUrdf(const std::string& text, const std::string& file);

}  // namespace simcore
