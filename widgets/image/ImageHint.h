// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string>

namespace robotlink {
class Session;
}

namespace widgets {

/// Why a view has no image from the stream `path` to show, and what to do about it. What a robot's platform
/// reported last as not working, such as a camera that cannot be opened, is the reason. GUI thread.
QString imageHint(robotlink::Session& session, const std::string& path);

}  // namespace widgets
