// SPDX-License-Identifier: GPL-3.0-or-later
// `robotctl log` bookmark and attachment.
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/core/platform/JsonOutput.h"
#include "app/robotctl/log/LogInput.h"
#include "app/robotctl/log/LogSubcommands.h"
#include "logplayer/base/LogDates.h"
#include "logplayer/bookmarks/Bookmarks.h"
#include "logplayer/edit/LogAttachments.h"
#include "robotlink/base/Printable.h"

namespace app {
namespace {

using logplayer::Bookmark;
using logplayer::Bookmarks;
using nlohmann::json;
using robotlink::Result;

// ---- Bookmarks

struct BookmarkArguments {
  std::string file;
  std::string add, remove;
  TimeRangeOptions range;
  bool asJson = false;
};

void printBookmarks(const Bookmarks& bookmarks, bool asJson) {
  json all = json::array();
  for (const Bookmark& bookmark : bookmarks.all()) {
    if (!asJson) {
      std::cout << logplayer::dateOrSeconds(bookmark.from)
                << (bookmark.to == bookmark.from ? "" : " to " + logplayer::dateOrSeconds(bookmark.to))
                << "  " << robotlink::printableLines(bookmark.text, "    ") << "\n";
    }
    all.push_back({{"id", bookmark.id},
                   {"from", robotlink::seconds(bookmark.from)},
                   {"to", robotlink::seconds(bookmark.to)},
                   {"text", bookmark.text}});
  }
  if (asJson) std::cout << jsonOutput(all);
}

/// Adds the requested bookmark; "usage" if the times make no sense.
Result<void> addBookmark(Bookmarks& bookmarks, const BookmarkArguments& arguments,
                         const TimeRangeOptions::Instants& range) {
  if (!range.from) return robotlink::failure("usage", "--add needs --from, and for a range --to");
  bookmarks.add(*range.from, range.to.value_or(*range.from), arguments.add);
  return {};
}

Result<void> remove(Bookmarks& bookmarks, const BookmarkArguments& arguments) {
  std::vector<std::uint64_t> ids;
  for (const Bookmark& bookmark : bookmarks.all()) {
    if (bookmark.text == arguments.remove) ids.push_back(bookmark.id);
  }
  if (ids.empty()) {
    return robotlink::failure("bookmark.none", "there is no bookmark '" + arguments.remove + "'",
                              {arguments.file, 0, 0});
  }
  for (const std::uint64_t id : ids) bookmarks.remove(id);
  return {};
}

int bookmark(const BookmarkArguments& arguments) {
  const bool changes = !arguments.add.empty() || !arguments.remove.empty();
  if (changes && arguments.file == "-") {
    std::cerr << "robotctl log bookmark: standard input cannot be changed; name a file\n";
    return kUsage;
  }
  const auto input = LogInput::of(arguments.file);
  if (!input) return printErrors({input.error()});
  Result<TimeRangeOptions::Instants> range;
  if (!arguments.add.empty()) range = arguments.range.of(arguments.file);
  if (!range) return printRangeError(range.error());
  auto bookmarks = Bookmarks::open(input->path());
  if (!bookmarks) return printErrors({bookmarks.error()});
  Result<void> done;
  if (!arguments.add.empty()) done = addBookmark(*bookmarks, arguments, *range);
  if (done && !arguments.remove.empty()) done = remove(*bookmarks, arguments);
  if (done && changes) done = bookmarks->save();
  if (!done) return printRangeError(done.error());
  printBookmarks(*bookmarks, arguments.asJson);
  if (changes && bookmarks->savedIn() != arguments.file) {
    std::cerr << "the log cannot be changed; its bookmarks are in " << bookmarks->savedIn().string() << "\n";
  }
  return bookmarks->problem() ? printLosses({bookmarks->problem()->describe()}) : kDone;
}

// ---- Attachments

struct AttachmentArguments {
  std::string file;
  std::string add, extract, output;
  logplayer::AttachmentOptions options;
  bool force = false;
  bool asJson = false;
};

int list(const std::filesystem::path& log, bool asJson) {
  const auto all = logplayer::attachmentsOf(log);
  if (!all) return printErrors({all.error()});
  json objects = json::array();
  for (const auto& attachment : *all) {
    if (!asJson)
      std::cout << robotlink::printable(attachment.name + "  " + attachment.mediaType) << "  "
                << attachment.bytes << " bytes\n";
    objects.push_back(
        {{"name", attachment.name}, {"media_type", attachment.mediaType}, {"bytes", attachment.bytes}});
  }
  if (asJson) std::cout << jsonOutput(objects);
  return kDone;
}

int attachment(const AttachmentArguments& arguments) {
  if (!arguments.add.empty()) {
    if (const auto added = logplayer::attach(arguments.file, arguments.add, arguments.options); !added) {
      return printErrors({added.error()});
    }
    return list(arguments.file, arguments.asJson);
  }
  const auto input = LogInput::of(arguments.file);
  if (!input) return printErrors({input.error()});
  if (arguments.extract.empty()) return list(input->path(), arguments.asJson);
  const std::filesystem::path to = arguments.output.empty()
                                       ? std::filesystem::path(arguments.extract).filename()
                                       : std::filesystem::path(arguments.output);
  if (const auto done = logplayer::extractAttachment(input->path(), arguments.extract, to, arguments.force);
      !done) {
    return printErrors({done.error()});
  }
  std::cout << to.string() << "\n";
  return kDone;
}

}  // namespace

void addLogNoteCommands(CLI::App& log, int& status) {
  auto marks = std::make_shared<BookmarkArguments>();
  CLI::App* command = log.add_subcommand("bookmark", "Lists the bookmarks of a log, adds and removes them");
  command->add_option("file", marks->file, "A log file; for listing also -, standard input")->required();
  auto* added =
      command->add_option("--add", marks->add, "The text of a new bookmark at --from, or from there --to");
  command->add_option("--remove", marks->remove, "The text of the bookmarks to remove")->excludes(added);
  marks->range.addTo(*command);
  command->add_flag("--json", marks->asJson, "Prints them as JSON");
  command->callback([marks, &status] { status = bookmark(*marks); });

  auto arguments = std::make_shared<AttachmentArguments>();
  command =
      log.add_subcommand("attachment", "Lists the attachments of a log, adds a file to it, or takes one out");
  command->add_option("file", arguments->file, "A log file; unless it is changed also -, standard input")
      ->required();
  auto* add = command->add_option("--add", arguments->add, "A file to attach")->check(CLI::ExistingFile);
  command->add_option("--name", arguments->options.name, "Its name in the log; default: the file's")
      ->needs(add);
  command
      ->add_option("--media-type", arguments->options.mediaType,
                   "Such as text/plain; default: by the file's extension")
      ->needs(add);
  auto* extract =
      command->add_option("--extract", arguments->extract, "The name of an attachment to write to a file")
          ->excludes(add);
  command->add_option("--output", arguments->output, "The file to write; default: the attachment's name")
      ->needs(extract);
  command->add_flag("--force", arguments->force, "Overwrites an existing file");
  command->add_flag("--json", arguments->asJson, "Prints them as JSON");
  command->callback([arguments, &status] { status = attachment(*arguments); });
}

}  // namespace app
