// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of the catalog about manual control, parameters, views and plots.
#include "robotlink/commands/CommandCatalog.h"

namespace robotlink {
namespace {

using Command = CommandTable::Command;
using Type = CommandTable::Type;
using Rows = std::vector<Command>;

Rows manualRows() {
  return {
      {"robot.take-over",
       "Takes manual control of the selected robot, or gives it back",
       {{"on", Type::kBool, "off gives it back to its program", true}}},
      {"robot.walk",
       "Makes the robot that was taken over walk or drive until another command",
       {{"x", Type::kNumber, "m/s forward"},
        {"y", Type::kNumber, "m/s to the left; robots on wheels ignore it", 0.0},
        {"rotation", Type::kNumber, "rad/s counterclockwise", 0.0}}},
      {"robot.stand", "Makes the robot that was taken over stand still"},
      {"robot.head",
       "Chooses how the robot that was taken over moves its head",
       {{"mode", Type::kText, "", {}, {"look-ahead", "search-ball", "track-ball", "look-around"}}}},
      {"robot.head-joint",
       "Moves a joint of the head of the robot that was taken over",
       {{"joint",
         Type::kText,
         "one of the joints that the robot's head has",
         {},
         {"tilt", "pan", "roll", "mouth"}},
        {"angle", Type::kNumber, "rad"}}},
      {"robot.motion",
       "Plays a key-frame motion of the robot that was taken over",
       {{"name", Type::kText, "as on the buttons of the view Motion, or get-up"}}},
  };
}

Rows jointRows() {
  return {
      {"joints.set",
       "Turns a joint of the robot that was taken over; it holds the others where they are until it walks, "
       "plays "
       "or stands",
       {{"joint", Type::kText, "its name, as in the view Joints: legFL1"},
        {"angle", Type::kNumber, "rad, while the view shows degrees"}}},
      {"joints.limp",
       "Releases all joints of the robot that was taken over, so that you can pose it by hand, or makes them "
       "hold",
       {{"on", Type::kBool, "off: they hold their angles", true}}},
      {"joints.capture",
       "Adds the pose of the selected robot to the motion in the editor, as a key frame",
       {{"duration", Type::kNumber, "ms it takes to reach this pose", 500.0},
        {"source", Type::kText, "which angles", std::string("measured"), {"measured", "requested"}}}},
  };
}

Rows motionRows() {
  return {
      {"motion.new",
       "Starts a motion in the editor with the joints of the selected robot",
       {{"name", Type::kText, "letters, digits, - and _"}}},
      {"motion.open",
       "Opens a motion in the editor, or imports another team's",
       {{"file", Type::kFile, "a .mof, .pos or .mot file"}}},
      {"motion.open-from-robot",
       "Opens a motion of the selected robot's program in the editor",
       {{"name", Type::kText, "its motion_id"}}},
      {"motion.save", "Saves the motion in the editor to its file"},
      {"motion.save-as", "Saves the motion in the editor to a file", {{"file", Type::kFile, "a .mof file"}}},
      {"motion.discard", "Reloads the motion in the editor from its file; unsaved changes are lost"},
      {"motion.undo", "Undoes the last edit of the motion"},
      {"motion.redo", "Redoes what was undone"},
      {"motion.select", "Selects a key frame of the motion", {{"number", Type::kNumber, "from 1"}}},
      {"motion.set",
       "Sets the angle of a joint in the selected key frame",
       {{"joint", Type::kText, "its column"},
        {"value", Type::kText, "in the units of the text, or * (stays as it is), or - (released)"}}},
      {"motion.duration",
       "Sets how long the selected key frame takes",
       {{"ms", Type::kNumber, "rounded to the unit of the text"}}},
      {"motion.interpolation",
       "Sets how the selected key frame is reached",
       {{"kind", Type::kNumber, "0 jumps, 1 is linear, 2 and 3 are soft"}}},
      {"motion.duplicate", "Adds a key frame like the selected one behind it"},
      {"motion.remove", "Removes the selected key frame"},
      {"motion.move",
       "Swaps the selected key frame with another one",
       {{"count", Type::kNumber, "so many places later; negative: earlier"}}},
      {"motion.mirror",
       "Mirrors the motion: what the left side did, the right side does",
       {{"part", Type::kText, "", std::string("all"), {"all", "key-frame"}}}},
      {"motion.send", "Sends the motion to the selected robot, whose program plays it from then on"},
      {"motion.auto-send",
       "Sends each change of the motion that has no errors",
       {{"on", Type::kBool, "off: only motion.send", true}}},
      {"motion.take-back", "Makes the selected robot play the motion from its own files again"},
      {"motion.play", "Plays the motion once on the robot that was taken over"},
      {"motion.step",
       "Selects another key frame; a robot that was taken over moves to its pose",
       {{"count", Type::kNumber, "so many places later; negative: earlier", 1.0}}},
  };
}

Rows parameterRows() {
  return {
      {"robot.parameter",
       "Sets a parameter of a solution of the selected robot's program",
       {{"task", Type::kText, "walking, for its active solution, or walking/gait for another one"},
        {"path", Type::kText, "as in the view of solutions: step.height"},
        {"value", Type::kText, "a number, on or off, a choice or a text"}}},
      {"robot.reset-parameter",
       "Resets a parameter of the selected robot's program to its default",
       {{"task", Type::kText, "walking, for its active solution, or walking/gait for another one"},
        {"path", Type::kText, "a parameter or a group of them; all if it is left out", std::string()}}},
      {"parameters.reset",
       "Resets all parameters of the selected robot's program to their defaults",
       {{"task", Type::kText, "only those of walking or walking/gait; all if it is left out",
         std::string()}}},
      {"parameters.save",
       "Saves changed parameters to the files that the program reads when it starts; their "
       "comments stay",
       {{"task", Type::kText, "only those of walking or walking/gait; all if it is left out", std::string()},
        {"file", Type::kFile, "another .textproto file, for remote robots", std::string()}}},
      {"parameters.undo", "Undoes the last edit in the panel of parameters of the view Solutions"},
      {"parameters.redo", "Redoes the last edit undone there"},
      {"parameters.sweep",
       "Sets a parameter to one value after another and measures a quantity at each",
       {{"task", Type::kText, "walking, for its active solution, or walking/gait for another one"},
        {"path", Type::kText, "as in the view of solutions: step.height"},
        {"values", Type::kText, "a list 1,2,5 or a range from:to:step"},
        {"figure", Type::kText, "an expression over streams: models/ball.position.x"},
        {"seconds", Type::kNumber, "seconds of session time at each value"},
        {"file", Type::kFile, "a .csv file with the result", std::string()}}},
      {"parameters.stop-sweep", "Ends the sweep of a parameter and restores its previous value"},
  };
}

Rows presetRows() {
  const CommandTable::Argument preset{"name", Type::kText, "of a preset, or the path of its file"};
  return {
      {"preset.save",
       "Saves the current choices as a preset: debug keys, "
       "solutions, parameters, views and camera settings",
       {{"name", Type::kText, "a new one or one to replace; a path is a file"},
        {"parts", Type::kText, "some of keys,solutions,parameters,views,camera, or all",
         std::string("all")}}},
      {"preset.load", "Switches the selected robot and the window to a preset", {preset}},
      {"preset.diff", "Lists how the current choices differ from a preset, and fails if they do", {preset}},
      {"preset.delete", "Deletes a preset", {{"name", Type::kText, "of the preset"}}},
      {"preset.rename",
       "Renames a preset",
       {{"name", Type::kText, "of the preset"},
        {"new-name", Type::kText, "letters, digits, spaces, - and _"}}},
  };
}

Rows viewRows() {
  const CommandTable::Argument view{"view", Type::kText, "its name: image, field, packets, ..."};
  return {
      {"view.another", "Opens another view of a kind", {view}},
      {"view.close", "Closes all views of a kind; their positions are remembered", {view}},
      {"view.maximize", "Gives a view all the space", {view}},
      {"view.restore", "Shows all views again after one was maximized"},
      {"view.save",
       "Saves what a view shows: its picture, table or text, points of plots, packets",
       {view,
        {"file", Type::kFile,
         ".png; .csv, .tsv: its table; .txt: its text; plots also .svg, packets .wire, motions .mof"}}},
      {"view.perspective", "Shows a perspective", {{"name", Type::kText, "Play, Log, or one of your own"}}},
      {"view.save-perspective",
       "Saves the arrangement of the views as a perspective",
       {{"name", Type::kText, "a new one, or one to replace"}}},
      {"view.delete-perspective",
       "Deletes a perspective of your own",
       {{"name", Type::kText, "of the perspective"}}},
      {"view.export-perspective",
       "Writes the shown perspective to a file",
       {{"file", Type::kFile, "a .perspective.json file"}}},
      {"view.import-perspective",
       "Imports an exported perspective and shows it",
       {{"file", Type::kFile, "a .perspective.json file"}}},
      {"view.reset", "Resets the current perspective to its shipped layout"},
      {"view.undo", "Undoes the last change of the arrangement of the views"},
      {"view.redo", "Redoes what was undone"},
      {"view.appearance",
       "Chooses the colors of the window",
       {{"name", Type::kText, "", {}, {"system", "light", "dark", "high-contrast"}}}},
      {"view.language",
       "Chooses the language of the window, used from its next start on",
       {{"name", Type::kText, "", {}, {"system", "en", "de"}}}},
      {"view.text-size",
       "Sets the size of all texts",
       {{"percent", Type::kNumber, "70 to 250; 100: the system's size"}}},
  };
}

Rows plotRows() {
  const CommandTable::Argument value{"value", Type::kText,
                                     "\"red1/models/ball: position_in_robot.x | average 0.5\", or \"= \" and "
                                     "an expression, each perhaps with "
                                     "\" over \" and another one"};
  return {
      {"plots.add", "Adds a curve to the plots", {value}},
      {"plots.states",
       "Shows a curve of the plots as a strip of states, or as a curve",
       {value, {"on", Type::kBool, "off: as a curve", true}}},
      {"plots.spectrum",
       "Shows spectra of the curves in the plots, of the shown times or between the cursors",
       {{"on", Type::kBool, "off hides them", true},
        {.name = "window",
         .help = "the window function applied to the values first",
         .initial = std::string("hann"),
         .choices = {"hann", "rectangle", "hamming", "blackman", "flat-top"}}}},
      {"plots.equal-axes",
       "Uses the same scale on both axes of plots of one value over another",
       {{"on", Type::kBool, "off: each axis fills the view", true}}},
      {"plots.remove", "Removes a curve from the plots", {value}},
      {"plots.clear", "Removes all curves from the plots"},
  };
}

Rows searchRows() {
  return {
      {"search.start",
       "Searches the open logs in the view Search, without playing them",
       {{"wanted", Type::kText, "a condition, or what texts contain"},
        {.name = "kind", .initial = std::string("condition"), .choices = {"condition", "texts"}}}},
      {"search.cancel", "Ends the search; what was found stays"},
      {"search.next", "Jumps to the next hit of the search"},
      {"search.previous", "Jumps to the hit before the shown time"},
      {"timeline.track",
       "Shows a value as a curve in the timeline",
       {{"value", Type::kText, "\"red1/models/ball: position_in_robot.x\", or \"= \" and an expression"}}},
      {"timeline.remove-track",
       "Removes a curve from the timeline",
       {{"value", Type::kText, "as it was added, with its robot"}}},
      {"timeline.mark-texts",
       "Marks the times of matching text messages in the timeline and in plots",
       {{"pattern", Type::kText, "a regular expression; '': no marks"}}},
  };
}

}  // namespace

Rows controlCatalog() {
  Rows all = manualRows();
  for (Rows& rows : std::vector<Rows>{jointRows(), motionRows(), parameterRows(), presetRows(), viewRows(),
                                      plotRows(), searchRows()})
    all.insert(all.end(), rows.begin(), rows.end());
  return all;
}

}  // namespace robotlink
