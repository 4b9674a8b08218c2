// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "robotlink/base/Error.h"

namespace robotcontrol {
class ParameterValues;
class Request;
}  // namespace robotcontrol
namespace robotlink {
class Session;
}

// Functions that save the parameters of a solution to a text file. Only in the GUI's thread.
namespace widgets {

class ParameterModel;

/// The file on this computer that a robot's program has read these parameters from. Fails if there is none:
/// the program runs remotely, or does not say which one it is.
robotlink::Result<std::filesystem::path> parameterFileHere(const robotlink::Session& session,
                                                           const std::string& robot,
                                                           const robotcontrol::ParameterValues& values);

/// Writes what differs from the defaults into a file, whose other contents stay: comments, order, blanks. A
/// file that does not exist gets all values. Fails without a change if that cannot be read or written, and
/// says what to do.
robotlink::Result<void> saveParameters(const ParameterModel& model, const std::filesystem::path& file);

/// The request that makes the model's values the defaults of the program, once they are in its own file.
robotcontrol::Request savedParameters(const ParameterModel& model, const robotcontrol::ParameterValues& of);

}  // namespace widgets
