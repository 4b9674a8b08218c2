// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "robotlink/commands/CommandTable.h"

namespace app {

/// The value of a field of a form.
using FormValue = robotlink::CommandTable::Value;
/// Values by the names of their fields.
using FormValues = std::map<std::string, FormValue>;

// The value of a field as its type; the fallback if it is missing or of another type.
bool flagOf(const FormValues& values, const std::string& field, bool fallback = false);
double numberOf(const FormValues& values, const std::string& field, double fallback = 0);
std::string textOf(const FormValues& values, const std::string& field, const std::string& fallback = {});

/// A value that a user enters before a platform is opened: in a dialog, as an argument of a command,
/// or as an option of the command line. A plain value; texts are in English, as in the source.
struct PlatformField {
  enum class Kind : std::uint8_t {
    kText,
    kNumber,
    kFlag,
    /// A choice of `items`; any other text, too, if `editable`.
    kChoice,
    /// A file, which can be chosen in a dialog.
    kFile
  };
  /// An item of a choice.
  struct Item {
    std::string title, value;
    /// The tooltip; may be empty.
    std::string help = {};
  };
  using Items = std::vector<Item>;

  /// Unique in its form: "port".
  std::string name = {};
  Kind kind = Kind::kText;
  /// The label, "First &port:"; that of a flag is the text next to its box.
  std::string label = {};
  /// The tooltip, and the help of argument and option.
  std::string help = {};
  /// Also decides the type of the values: a number for kNumber, a bool for kFlag, otherwise a text.
  FormValue initial = std::string();
  /// The name of the field in a sentence about a wrong value: "number of robots".
  std::string noun = {};

  // The range of a number, the places that are shown behind its point, and its unit.
  double min = 0, max = 0;
  int decimals = 0;
  std::string unit = {};
  /// The text for the lowest number or an empty text: "none"; empty: as it is.
  std::string emptyText = {};

  /// Returns the choices; called whenever they are listed.
  std::function<Items()> items = {};
  /// Whether another text than that of a choice can be entered.
  bool editable = false;
  /// Whether the choices are shown as a row of buttons rather than as a list.
  bool buttons = false;
  /// Whether the choices may change while the form is shown: there is a button that lists them again, whose
  /// tooltip this is.
  std::string listAgain = {};
  /// The kinds of files that the file dialog lists: "Maps (*.map)".
  std::string files = {};

  /// The title of the box in which it is shown together with its neighbors of the same group; may be empty.
  std::string group = {};
  /// Whether it is shown to the right of the field before it.
  bool sameRow = false;
  /// The text of a check box that has to be ticked for the field to count; otherwise its value is 0 or empty.
  std::string toggle = {};

  /// Whether it is what is opened: a file or an address.
  bool isSource = false;
  /// Whether it is an argument of the form's command, in the order of the fields.
  bool isArgument = true;
  /// Whether the dialog shows it.
  bool isShown = true;
  /// The option of the command line: "--robots"; empty: none.
  std::string option = {};
  /// Whether that option can be given several times.
  bool several = false;
  /// Returns the problem with a text, as a sentence; empty if it is valid. Unset: every text is valid.
  std::function<std::string(const std::string& text)> check = {};
  /// The place in the window's file where the last value is kept: "robot_map", or, in a list, "setup/2".
  /// Empty: it is not kept.
  std::string remembered = {};
  /// Whether that place is a list of the last values, the newest first, which are offered as choices.
  bool recent = false;
};

/// The state of a form while a user fills it in.
struct FormState {
  /// A text below a field.
  struct Note {
    std::string text;
    /// Whether it says what is wrong.
    bool bad = false;
  };
  FormValues values;
  // Results of PlatformForm::follow, derived from the values; before each call these are reset to nothing.
  std::set<std::string> disabled, hidden;
  std::map<std::string, Note> notes;
  /// The meaning of the values, if it is not obvious.
  std::string hint;
  /// Whether the form can be accepted.
  bool complete = true;
};

/// The fields that users fill in before a platform of one kind is opened. Menu entry, dialog, command and
/// options are made from it. A plain value.
struct PlatformForm {
  /// Names of widgets begin with it: "connect". Empty: the adapter has no form.
  std::string name = {};
  /// The command that opens a platform: "robot.connect". Its arguments are those fields that are arguments.
  std::string command = {}, commandHelp = {};

  /// The menu of the entry: "file" or "robot".
  std::string menu = {};
  /// The entry, its name for scripts and tests, its icon, keys and tooltip.
  std::string entry = {}, action = {}, icon = {}, keys = {}, entryHelp = {};
  /// The dialog's title, and the text of its button.
  std::string title = {}, accept = {};
  /// Whether the dialog stays open until the robot is connected, as its stream link/status says.
  bool connects = false;
  std::vector<PlatformField> fields = {};
  /// Adapts the form to its values: which fields are shown and enabled, hints, and values that follow from
  /// the field that has just changed; `changed` is empty at first. May be empty.
  std::function<void(FormState& state, const std::string& changed)> follow = {};
  /// Brings values that the user has accepted into their usual form, such as an address with its scheme. May
  /// be empty.
  std::function<void(FormValues& values)> normalize = {};

  /// Null if there is no such field.
  const PlatformField* field(const std::string& name) const;
  /// The fields that are arguments of the command, in order.
  std::vector<const PlatformField*> arguments() const;
};

/// The field "own" of adapters whose programs can run in processes of their own: --own-process.
PlatformField ownProcessField();

/// The values of a form that nobody has filled in yet; a field with a toggle does not count.
FormValues initialValues(const PlatformForm& form);

/// The range of a number: "0 to 100"; empty if it has none.
std::string rangeOf(const PlatformField& field);
/// Returns the problem with a value of a field, as a sentence; empty if the value is valid.
std::string problemOf(const PlatformField& field, const FormValue& value);
/// Returns the problem with the first invalid value of a form, as a sentence; empty if all are valid.
std::string problemOf(const PlatformForm& form, const FormValues& values);

}  // namespace app
