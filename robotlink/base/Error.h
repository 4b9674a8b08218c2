// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace robotlink {

/// A position in a text file. Lines and columns count from 1; 0 means unknown.
struct FilePosition {
  std::string file;
  int line = 0;
  int column = 0;
  bool operator==(const FilePosition&) const = default;
};

/// An expected failure, such as a file that does not parse or a request that is refused. A plain value.
struct Error {
  /// Stable and machine-readable ("layout.unknown-task"), so that a user interface can translate by it.
  std::string id;
  /// An English sentence that says what is wrong and what to do.
  std::string text;
  /// The names and values that `text` mentions, in its order.
  std::vector<std::string> arguments;
  /// The place in a file, if there is one; otherwise empty.
  FilePosition where;

  /// Returns "file:line:column: text", without the parts that are unknown.
  std::string describe() const;
  bool operator==(const Error&) const = default;
};

/// A value, or the reason why there is none.
template <typename T>
using Result = tl::expected<T, Error>;

/// All errors of one file, so that a reader can report them at once rather than only the first.
using Errors = std::vector<Error>;

/// Returns one `describe()` a line.
std::string describe(const Errors& errors);

/// Builds the error that a function with a Result returns: `return failure("file.io", "cannot open it",
/// {path})`.
inline tl::unexpected<Error> failure(std::string id, std::string text, FilePosition where = {},
                                     std::vector<std::string> arguments = {}) {
  return tl::unexpected<Error>(Error{std::move(id), std::move(text), std::move(arguments), std::move(where)});
}

}  // namespace robotlink
