// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string>

namespace widgets {

struct ViewContext;

/// Returns a hint why a view has no image from the stream `path`, and what to do about it: the robot may have
/// no camera, or its platform reported as the last thing that something does not work, such as a camera that
/// cannot be opened. GUI thread.
QString imageHint(const ViewContext& context, const std::string& path);

}  // namespace widgets
