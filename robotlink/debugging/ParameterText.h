// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <google/protobuf/text_format.h>

#include <string>

#include "robotlink/base/Error.h"

// Parameter files, which are messages in protobuf's text format. What controls a solution while it is
// debugged (messages of the type robotcontrol.BehaviorControl) is never written to one.
namespace robotlink {

/// Clears what controls a solution while it is debugged, in a message and those in it.
void clearControls(google::protobuf::Message& message);

/// Reads the text of a parameter file, which is named in errors only, into `message`; `places` gets where its
/// fields are. Fails with all errors, each with its line and column.
tl::expected<void, Errors> readParameterText(const std::string& text, const std::string& file,
                                             google::protobuf::Message& message,
                                             google::protobuf::TextFormat::ParseInfoTree* places = nullptr);

/// Writes each field whose value differs between `before` and `after`, which have one type, into the text of
/// a parameter file: in its place, or where its message ends if the text does not have it. All other bytes
/// stay as they are: comments, order, blanks, and values that others have changed. Fails, also if the
/// text cannot be read, rather than to return a text with other values.
tl::expected<std::string, Errors> editedParameterText(const std::string& text, const std::string& file,
                                                      const google::protobuf::Message& before,
                                                      const google::protobuf::Message& after);

/// All values of a message as the text of a new parameter file.
std::string parameterText(const google::protobuf::Message& message);

}  // namespace robotlink
