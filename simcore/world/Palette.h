// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "simcore/world/RenderScene.h"

namespace simcore {

/// The colors that a scene's files may refer to by name.
using Palette = std::map<std::string, Rgb>;

}  // namespace simcore
