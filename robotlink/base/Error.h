// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace robotlink {

/// Where in a text file something is wrong. Lines and columns count from 1; 0 means unknown.
struct FilePosition {
  std::string file;
  int line = 0;
  int column = 0;
  bool operator==(const FilePosition&) const = default;
};

/// An expected failure: a file that does not parse, a request that is refused. A plain value.
///
/// `id` is stable and machine-readable ("layout.unknown-task"), so that a window can translate by it;
/// `text` is the English sentence that says what is wrong and what to do; `arguments` are what the
/// sentence names, in its order.
struct Error {
  std::string id;
  std::string text;
  std::vector<std::string> arguments;
  FilePosition where;

  /// "file:line:column: text", leaving out what is unknown.
  std::string describe() const;
  bool operator==(const Error&) const = default;
};

template <typename T>
using Result = tl::expected<T, Error>;

/// Several errors of one file, all of them reported at once.
using Errors = std::vector<Error>;

/// One `describe()` a line.
std::string describe(const Errors& errors);

inline tl::unexpected<Error> failure(std::string id, std::string text, FilePosition where = {},
                                     std::vector<std::string> arguments = {}) {
  return tl::unexpected<Error>(Error{std::move(id), std::move(text), std::move(arguments), std::move(where)});
}

}  // namespace robotlink
