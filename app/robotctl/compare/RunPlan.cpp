// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/compare/RunPlan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>

#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/bytes/Fnv.h"

namespace app {
namespace {

/// The maximum length of a part, in bytes: names of files have two of them, and suffixes, within 255 bytes.
constexpr std::size_t kMaxPart = 100;

/// A part of a file's name: letters, digits, and '-' for everything else. Names that differ only in something
/// else, such as those of two logs, or that are too long, end in different numbers; words with spaces between
/// them have none.
std::string fileNameOf(const std::string& text) {
  const auto isPlain = [](unsigned char c) { return std::isalnum(c) != 0 || c == '.' || c == '_'; };
  std::string name = text;
  std::ranges::replace_if(
      name, [&](unsigned char c) { return !isPlain(c); }, '-');
  const bool areWords =
      std::ranges::all_of(text, [](unsigned char c) { return std::isalnum(c) != 0 || c == ' '; });
  if (name.size() <= kMaxPart && (areWords || name == text)) return name;
  // The end says more than the folder at the begin.
  constexpr std::size_t kNumber = 17;
  if (name.size() > kMaxPart - kNumber) name = name.substr(name.size() - (kMaxPart - kNumber));
  return fmt::format("{}-{:016x}", name, robotlink::fnv1a(text));
}

std::string commandOf(const PlannedRun& run) {
  return shellLine(run.arguments) + "\n" + run.inputs + (run.inputs.empty() ? "" : "\n");
}

robotlink::Error cannot(const std::string& what, const std::filesystem::path& file,
                        const std::error_code& why) {
  return {"file.io", what + " " + file.string() + ": " + why.message(), {file.string(), why.message()}, {}};
}

}  // namespace

std::string wholePath(const std::string& name) {
  std::error_code ignored;
  return std::filesystem::exists(name, ignored) ? std::filesystem::absolute(name).string() : name;
}

std::string shellLine(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) {
    if (!line.empty()) line += ' ';
    const bool isPlain = !word.empty() && std::ranges::all_of(word, [](unsigned char c) {
      return std::isalnum(c) != 0 ||
             std::string_view("-_./=,:+@%").find(static_cast<char>(c)) != std::string_view::npos;
    });
    if (isPlain) {
      line += word;
      continue;
    }
    line += '\'';
    for (const char c : word) line += c == '\'' ? std::string("'\\''") : std::string(1, c);
    line += '\'';
  }
  return line;
}

robotlink::Result<RunFiles> RunFiles::in(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return tl::unexpected(cannot("cannot make folder", folder, error));
  return RunFiles(std::filesystem::absolute(folder));
}

std::filesystem::path RunFiles::fileOf(const PlannedRun& run, const char* suffix) const {
  return folder_ / (fileNameOf(run.variant) + "--" + fileNameOf(run.subject) + suffix);
}

bool RunFiles::isDone(const PlannedRun& run) const {
  std::error_code ignored;
  if (!std::filesystem::exists(result(run), ignored)) return false;
  const auto command = robotlink::readFile(fileOf(run, ".command"));
  return command && *command == commandOf(run);
}

robotlink::Result<void> RunFiles::prepare(const PlannedRun& run) const {
  std::error_code ignored;
  std::filesystem::remove(result(run), ignored);
  return robotlink::writeFileAtomically(fileOf(run, ".command"), commandOf(run));
}

robotlink::Result<void> RunFiles::finish(const PlannedRun& run) const {
  std::error_code error;
  std::filesystem::rename(unfinished(run), result(run), error);
  if (error) return tl::unexpected(cannot("cannot write", result(run), error));
  return {};
}

}  // namespace app
