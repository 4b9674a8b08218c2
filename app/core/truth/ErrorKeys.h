// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

namespace robotlink {
struct Preset;
}

namespace app {

/// A preset with which programs publish what TruthErrors compares, in addition to `chosen`, which may be
/// null.
std::shared_ptr<const robotlink::Preset> presetForErrors(
    const std::shared_ptr<const robotlink::Preset>& chosen);

}  // namespace app
