// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/session/VersionedFile.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "robotlink/base/AtomicFile.h"

namespace robotlink {
namespace {

using nlohmann::json;

FilePosition positionOf(const std::filesystem::path& file, const std::string& text, std::size_t byte) {
  const std::string_view before(text.data(), std::min(byte > 0 ? byte - 1 : 0, text.size()));
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t lineStart = before.rfind('\n') + 1;  // npos + 1 is 0
  return {file.string(), static_cast<int>(line), static_cast<int>(before.size() - lineStart) + 1};
}

// None of these files nests deeper; more would only use up the stack.
Result<json> parse(const std::filesystem::path& file, const std::string& text) {
  constexpr int kMaxDepth = 32;
  bool tooDeep = false;
  const json::parser_callback_t limitDepth = [&](int depth, json::parse_event_t, json&) {
    tooDeep = tooDeep || depth > kMaxDepth;
    return !tooDeep;
  };
  try {
    json document = json::parse(text, limitDepth);
    if (!tooDeep) return document;
    return failure("settings.syntax", "the file is nested too deeply", {file.string(), 0, 0});
  } catch (const json::parse_error& error) {
    return failure("settings.syntax", "this is not valid JSON", positionOf(file, text, error.byte));
  } catch (const json::exception&) {
    return failure("settings.syntax", "a number in this file is too large", {file.string(), 0, 0});
  }
}

}  // namespace

Result<json> readVersioned(const std::filesystem::path& file, const VersionedFormat& format) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return json::object();
  const auto text = readFile(file, format.maxBytes);
  if (!text) return tl::unexpected(text.error());
  auto document = parse(file, *text);
  if (!document) return document;
  const FilePosition where{file.string(), 0, 0};
  if (!document->is_object() || document->value("format", json()) != format.format) {
    return failure("settings.format", "this is not a file of the format " + format.format, where,
                   {format.format});
  }
  const json version = document->value("version", json());
  if (!version.is_number_integer() || version < 1) {
    return failure("settings.version", "the file does not say which version of its format it has", where);
  }
  if (version > format.version) {
    return failure("settings.newer",
                   "the file was written by a newer version of the program; update this one to use it",
                   where);
  }
  json contents = document->value(format.member, json());
  if (contents.is_object()) return contents;
  return failure("settings.format", "the file has no object \"" + format.member + "\"", where,
                 {format.member});
}

Result<void> writeVersioned(const std::filesystem::path& file, const VersionedFormat& format,
                            const json& contents) {
  const nlohmann::ordered_json document{
      {"format", format.format}, {"version", format.version}, {format.member, contents}};
  // Invalid UTF-8 is replaced, so that the file can be written.
  return writeFileAtomically(file, document.dump(2, ' ', false, json::error_handler_t::replace) + "\n");
}

Error keepAside(const std::filesystem::path& file, Error error) {
  std::filesystem::path aside = file;
  aside += ".broken";
  std::error_code failed;
  std::filesystem::rename(file, aside, failed);
  error.text += failed ? "; defaults are used"
                       : "; it was kept as " + aside.filename().string() + ", defaults are used";
  return error;
}

}  // namespace robotlink
