// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "robotlink/base/Error.h"

namespace colortool {

/// Returns whether the bytes begin with the signature of a bzip2 stream; they may be damaged nevertheless.
bool isBzip2(std::string_view bytes);
/// Returns the contents of a bzip2 stream. Fails, with the offset in the stream, on damage and on bytes
/// behind the end of the stream; also as soon as the contents exceed `mostBytes`, so that a small file cannot
/// fill the memory. `file` is the name that errors carry.
robotlink::Result<std::string> decompressBzip2(std::string_view bytes, std::size_t mostBytes,
                                               const std::string& file);

}  // namespace colortool
