// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "robotlink/base/Error.h"

namespace colortool {

bool isBzip2(std::string_view bytes);
/// The contents of a bzip2 stream. Fails, with the offset in the stream, on damage, on what follows the
/// stream, and as soon as the contents exceed `mostBytes`. `file` is the name that errors carry.
robotlink::Result<std::string> decompressBzip2(std::string_view bytes, std::size_t mostBytes,
                                               const std::string& file);

}  // namespace colortool
