// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/commands/CommandCatalog.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace robotlink {
namespace {

using Command = CommandTable::Command;
using Type = CommandTable::Type;
using Rows = std::vector<Command>;

/// A number that may be left out.
CommandTable::Argument maybe(const char* name, const char* help) {
  return {.name = name, .type = Type::kNumber, .help = help, .mayBeMissing = true};
}

Rows simulationRows() {
  return {
      {"simulation.start", "Runs the simulation"},
      {"simulation.pause", "Pauses the simulation"},
      {"simulation.step", "Steps the simulation by 8 ms"},
      {"simulation.reset", "Resets everything to its initial state"},
      {"simulation.snapshot",
       "Takes a snapshot of the simulation: in memory under a name or, if there is a slash or the "
       "suffix "
       ".snapshot, in a file",
       {{"name", Type::kText, "a name, or a file: before, /tmp/before.snapshot", std::string("snapshot")}}},
      {"simulation.restore",
       "Restores the world of the simulation from a snapshot. The robots' "
       "programs keep running; with --programs on they are replayed "
       "from the start, with all requests since then, up to the snapshot",
       {{"name", Type::kText, "the name or the file of the snapshot", std::string("snapshot")},
        {"programs", Type::kBool, "on: the programs as well", false}}},
      {"simulation.rewind",
       "Rewinds the paused simulation by some seconds; the robots' programs keep running",
       {{"seconds", Type::kNumber, "simulated seconds, at least one step of 0.008", 1.0}}},
      {"simulation.forget",
       "Deletes a snapshot in memory",
       {{"name", Type::kText, "its name; '': all", std::string()}}},
      {"simulation.cancel", "Cancels replaying the programs up to a snapshot, and pauses the simulation"},
      {"simulation.speed",
       "Sets the speed of the simulation relative to real time; 0 is as fast as possible",
       {{"speed", Type::kNumber, "a factor of real time, 0 to 100"}}},
      {"simulation.noise",
       "Chooses whether sensors, cameras and odometry have "
       "errors; the simulation restarts from the beginning",
       {{"on", Type::kBool, "off: they measure the true values"}}},
      {"simulation.sensor-errors",
       "Changes the errors of a simulated sensor from now on; omitted ones stay as they are. Given the "
       "sensor alone, it measures the true values. Numbers are in the unit of its readings; cameras use only "
       "noise, delay, rate and dropout",
       {{"sensor", Type::kText, "its port: red1/psd, red1/legFL1/position, red1/camera/image"},
        maybe("noise", "standard deviation of white noise"),
        maybe("bias", "added to each reading"),
        maybe("delay", "s until a reading arrives, 0 to 1"),
        maybe("rate", "readings per second; 0: in each step"),
        maybe("dropout", "fraction of readings that are lost, 0 to 1"),
        maybe("drift", "standard deviation that a drifting bias gains per second"),
        maybe("drift_time", "time constant of that drift, s; 0: unbounded"),
        maybe("precision", "readings are rounded to multiples of this; 0: not rounded")}},
      {"simulation.door",
       "Opens a door of the simulation for its set time, or closes it at once",
       {{"door", Type::kText, "its port: gate/hinge/door"},
        {.name = "action", .help = "open or close", .choices = {"open", "close"}}}},
      {"simulation.key",
       "Presses and releases a key for the controllers of the simulated scene, as in the Scene view",
       {{"key", Type::kText, "its label: 1, A, Space, Left"}}},
      {"simulation.click",
       "Clicks in the simulated scene, for its controllers: on whatever a ray hits first",
       {{"x", Type::kNumber, "where the ray begins, m"},
        {"y", Type::kNumber, "m"},
        {"z", Type::kNumber, "m"},
        {"to_x", Type::kNumber, "a point through which it goes, m"},
        {"to_y", Type::kNumber, "m"},
        {"to_z", Type::kNumber, "m"}}},
      {"simulation.light",
       "Changes the light that cameras see; 1 0 restores the scene's own",
       {{"brightness", Type::kNumber, "a factor of the scene's, 0 to 10"},
        {"warmth", Type::kNumber, "-1 (bluish) to 1 (reddish)", 0.0}}},
      {"layout.open",
       "Restarts the robots' programs in another process layout, given by its path or the name of a shipped "
       "one",
       {{"layout", Type::kText, "a layout file"},
        {"robot", Type::kText, "only that robot or team of a simulation; '': all", std::string()}}},
  };
}

Rows sceneRows() {
  return {
      {"scene.hold",
       "Holds an actuator of the simulation at a value, regardless of the robot's program; omitted values of "
       "an actuator with several are 0",
       {{"actuator", Type::kText, "its port, as in the view Scene tree: red1/headPan/request"},
        {"value", Type::kNumber, "rad, or m/s of the left wheels"},
        {"second", Type::kNumber, "for actuators with two values: m/s of the right wheels", 0.0},
        {"third", Type::kNumber, "for actuators with three values: rad/s", 0.0},
        {"fourth", Type::kNumber, "for actuators with six values, in m/s and rad/s", 0.0},
        {"fifth", Type::kNumber, "of actuators with six", 0.0},
        {"sixth", Type::kNumber, "of actuators with six", 0.0}}},
      {"scene.release",
       "Lets programs set an actuator again",
       {{"actuator", Type::kText, "its port; '': all", std::string()}}},
      {"scene.place",
       "Places a robot or the ball of the simulation; with a height, roll or pitch also tilted, or lying on "
       "its side",
       {{"model", Type::kText, "its name in the scene: red1, ball"},
        {"x", Type::kNumber, "m, in the field's frame"},
        {"y", Type::kNumber, "m"},
        {"heading", Type::kNumber, "rad, counterclockwise", 0.0},
        {"height", Type::kNumber, "m, of the center of its body; 0: unchanged", 0.0},
        {"roll", Type::kNumber, "rad, about its x axis, before pitch and heading", 0.0},
        {"pitch", Type::kNumber, "rad, about its y axis; if all three are 0, its tilt stays as it is", 0.0}}},
      {"scene.turn",
       "Turns a model of the simulation in place",
       {{"model", Type::kText, "its name in the scene: red1, ball"},
        {"heading", Type::kNumber, "rad, about the vertical, counterclockwise"},
        {"roll", Type::kNumber, "rad, about the world's x axis, before the others", 0.0},
        {"pitch", Type::kNumber, "rad, about the world's y axis", 0.0}}},
      {"scene.throw",
       "Sets a model of the simulation in motion",
       {{"model", Type::kText, "its name in the scene: ball"},
        {"x", Type::kNumber, "m/s, in the field's frame"},
        {"y", Type::kNumber, "m/s"},
        {"z", Type::kNumber, "m/s, upwards", 0.0},
        {"spin", Type::kNumber, "rad/s, about the vertical, counterclockwise", 0.0}}},
      {"scene.pin",
       "Pins an object of the simulation where it is, so that nothing can move it",
       {{"object", Type::kText, "a model, or a link as in the view Scene tree: red1/link:body"},
        {"on", Type::kBool, "off lets it go", true}}},
      {"scene.drag",
       "Pulls the center of an object of the simulation toward a point by a spring, until it is released",
       {{"object", Type::kText, "a model, or a link: ball, red1/link:body"},
        {"x", Type::kNumber, "m, in the field's frame"},
        {"y", Type::kNumber, "m"},
        {"z", Type::kNumber, "m, above the ground"},
        {"strength", Type::kNumber, "a factor of the usual spring, 0.01 to 100", 1.0}}},
      {"scene.drop",
       "Releases a dragged object of the simulation",
       {{"object", Type::kText, "as in scene.drag; '': all", std::string()}}},
      {"scene.push",
       "Pushes the center of an object of the simulation with a force",
       {{"object", Type::kText, "a model, or a link: ball, red1/link:body"},
        {"x", Type::kNumber, "N, in the field's frame"},
        {"y", Type::kNumber, "N"},
        {"z", Type::kNumber, "N, upwards", 0.0},
        {"seconds", Type::kNumber, "simulated seconds, 0 to 60; 0: one step", 0.1}}},
      {"scene.add",
       "Adds a model to the running scene; the program of an added robot starts",
       {{"model", Type::kSource, "model://NAME, the name of a model, a kind of robot, or a model's file"},
        {"x", Type::kNumber, "m, in the field's frame"},
        {"y", Type::kNumber, "m"},
        {"heading", Type::kNumber, "rad, counterclockwise", 0.0},
        {"name", Type::kText, "its name in the scene; '': that of the model, with a number if it is taken",
         std::string()},
        {.name = "height",
         .type = Type::kText,
         .help = "m, of the model's frame; '': it stands on the floor",
         .initial = std::string()},
        {"team", Type::kText, "the color of its team, such as red; '': none", std::string()}}},
      {"scene.remove",
       "Removes a model from the running scene; the program of a removed robot ends",
       {{"model", Type::kText, "its name in the scene, or the path of something in it: red1"}}},
      {"scene.duplicate",
       "Adds a copy of a model next to it",
       {{"model", Type::kText, "its name in the scene, or the path of something in it: red1"},
        {"name", Type::kText, "the name of the copy; '': the same with another number", std::string()}}},
      {"scene.undo",
       "Undoes the last scene.add, scene.remove or scene.duplicate: a removed model returns to its pose and "
       "motion"},
      {"scene.reload",
       "Reloads the scene's file after an edit, and continues in it: what has not changed stays as it is"},
  };
}

Rows robotRows() {
  const CommandTable::Argument whose{"robot", Type::kText,
                                     "its name, that of a team, or all; '': the selected one", std::string()};
  return {
      {"robot.connect-now",
       "Reconnects to the robot now instead of after a pause; its program keeps running"},
      {"robot.select",
       "Selects the robot that toolbars and views show",
       {{"robot", Type::kText, "its name"}}},
      {"robot.stop",
       "Engages or releases STOP for all robots: their platforms hold them, whatever the programs do",
       {{"engaged", Type::kBool, "true engages, false releases"}}},
      {"robot.steer",
       "Takes control of a robot that other clients can also steer, or releases it",
       {{"robot", Type::kText, "its name"},
        {"on", Type::kBool, "true: takes control, even from another client; false: releases it"}}},
      {"robot.key",
       "Sets a debug key of the program of the selected robot, of another one, or of all",
       {{"key", Type::kText, "its name, as in the view of debug keys"},
        {"mode", Type::kText, "off, always, 'n 3' (times), 'every 3' (frames) or 'every-ms 40'",
         std::string("always")},
        whose}},
      {"robot.solution",
       "Switches the solution of a task of the program of the selected robot, of another one, or of all",
       {{"task", Type::kText, "its name"}, {"solution", Type::kText, "its name"}, whose}},
      {"robot.shadow",
       "Runs a solution in the shadow of its task's active one, or stops it; what it publishes is under "
       "shadow/",
       {{"task", Type::kText, "its name"},
        {"solution", Type::kText, "its name"},
        {"on", Type::kBool, "true runs it, false stops it", true},
        whose}},
      {"robot.package",
       "Substitutes a value for a package in the program "
       "of the selected robot, of another one or of all",
       {{"package", Type::kText, "its name: models/ball"},
        {.name = "mode",
         .help = "once: in place of the next one; hold: of all, until release",
         .choices = {"once", "hold", "release"}},
        {"json", Type::kText, "its fields: '{\"known\": true}'; '': as by default", std::string()},
        whose}},
      {"robot.host",
       "Chooses where the program of the selected robot, of another one or of all runs, and how the "
       "processes "
       "of all programs are executed; the programs are restarted",
       {{.name = "where",
         .help = "in the workbench, or in its own process; threads: each process of all robots has a thread, "
                 "in real time; lockstep: they are executed one after another",
         .choices = {"inside", "own-process", "threads", "lockstep"}},
        whose}},
      {"robot.start-again",
       "Restarts the program of the selected robot, of another one or of all; keys, solutions and "
       "parameters stay",
       {whose}},
      {"robot.color-table",
       "Sends a color table to the selected robot's program, which uses it from its next image on",
       {{"file", Type::kFile, "a color table: .c64, or another team's"}}},
      {"robot.no-color-table", "Switches the selected robot's program back to its built-in color table"},
      {"robot.camera",
       "Changes a setting of the selected robot's camera, as in the view Camera",
       {{"setting", Type::kText, "its name, such as exposure"}, {"value", Type::kNumber, "in its range"}}},
      {"robot.goal",
       "Sends the selected robot to a place, if it has wheels",
       {{"x", Type::kNumber, "m, in the map's frame"}, {"y", Type::kNumber, "m"}}},
      {"robot.no-goal", "Cancels the selected robot's goal"},
      {"robot.save-map",
       "Saves what the selected robot has mapped as a map for localization and planning; its home is where "
       "the "
       "robot is",
       {{"file", Type::kFile, "ends in .map"}}},
      {"robot.gripper",
       "Moves the gripper of the selected robot, if it has one",
       {{.name = "action",
         .type = Type::kText,
         .help =
             "open, close, stop; lift-up, lift-down, lift-stop; store: closed and up, deploy: open and down; "
             "halt: stops all",
         .choices = {"open", "close", "stop", "lift-up", "lift-down", "lift-stop", "store", "deploy",
                     "halt"}}}},
      {"robot.output",
       "Switches a digital output of the selected robot, if it has any",
       {{"number", Type::kNumber, "0 to 7"}, {"on", Type::kBool, "true: on, false: off"}}},
      {"robot.motors",
       "Switches the motors of the selected robot on wheels",
       {{"on", Type::kBool, "true: on, false: off"}}},
      {"robot.sonars",
       "Switches the sonars of the selected robot on wheels",
       {{"on", Type::kBool, "true: on, false: off"}}},
  };
}

Rows remoteRows() {
  return {
      {"remote.connect",
       "Connects remote robots, in addition to those that are open here",
       {{"url", Type::kText, "ws://HOST[:PORT]"},
        {"token", Type::kText, "that the robot asks for, or ''", std::string()}}},
      {"remote.trust",
       "Trusts the certificate that a remote robot shows, from now on, and connects it",
       {{"url", Type::kText, "as it was connected"},
        {"fingerprint", Type::kText, "SHA256:..., as the robot printed it when it was started"}}},
      {"remote.show-token",
       "Sends a token to a remote robot that asks for one",
       {{"url", Type::kText, "as it was connected"},
        {"token", Type::kText, "one of the two that the robot has printed"}}},
      {"remote.remember-token",
       "Remembers the token of a connection on this computer, once the robot has accepted it",
       {{"url", Type::kText, "as it was connected"}}},
      {"remote.forget-token",
       "Forgets the token that is remembered for a remote robot",
       {{"url", Type::kText, "as it was connected"}}},
      {"remote.disconnect",
       "Disconnects remote robots, which disappear from the window",
       {{"url", Type::kText, "as it was connected"}}},
      {"remote.limit",
       "Limits the data rate of remote robots, for slow or shared links; the limits are remembered",
       {{"url", Type::kText, "ws://HOST[:PORT]"},
        {"bytes", Type::kNumber, "maximum bytes per second; 0: no limit"},
        {.name = "images",
         .help = "auto: raw as long as the link is fast enough",
         .initial = std::string("auto"),
         .choices = {"auto", "raw", "jpeg", "png"}},
        {"rate", Type::kNumber, "maximum images per second of each stream; 0: all", 0.0}}},
      {"session.offer",
       "Lets others watch and steer what is open here, as clients of the Foxglove WebSocket protocol",
       {{"address", Type::kText, "[ADDRESS:]PORT, or '' for 127.0.0.1:8765", std::string()}}},
      {"session.stop-offering", "Disconnects all clients and stops offering the session"},
  };
}

Rows openedLogRows() {
  return {
      {"log.add",
       "Adds a log file to the timeline",
       {{"file", Type::kFile, "a log file"},
        {"offset", Type::kNumber,
         "seconds to add to its times; 0: it starts with the first log unless their times overlap", 0.0}}},
      {"log.cancel", "Cancels opening a log, map or scene; what ran before continues"},
      {"log.close", "Closes the open logs"},
      {"log.offset",
       "Shifts one of the open logs on the timeline",
       {{"file", Type::kText, "an open log file"}, {"offset", Type::kNumber, "seconds to add to its times"}}},
      {"log.package",
       "Chooses whether a package is taken from the log or recomputed by the program that runs on it",
       {{"name", Type::kText, "models/ball, or with the robot red1/models/ball"},
        {.name = "source", .choices = {"logged", "recomputed", "automatic"}}}},
      {"log.search",
       "Finds where a condition is true in the open logs, without playing them; fails if it "
       "never is",
       {{"expression", Type::kText, "models/ball.position.x > 1, or log.message =~ \"lost\""},
        {"file", Type::kFile, "a .csv file for the times found", std::string()}}},
      {"log.layout",
       "Restarts the program on the log in another process layout, given by its path or the name of a "
       "shipped "
       "one",
       {{"layout", Type::kText, "a layout file"}}},
  };
}

Rows writtenLogRows() {
  const CommandTable::Argument from{"from", Type::kText, "seconds since the start; or start",
                                    std::string("start")};
  const CommandTable::Argument to{"to", Type::kText, "seconds since the start; or end", std::string("end")};
  return {
      {"log.cut",
       "Writes a part of the open logs into a new log",
       {{"file", Type::kFile, "a .mcap file that does not exist yet"},
        from,
        to,
        {"streams", Type::kText,
         "comma-separated paths; * matches any text, - excludes: red1/*,-*/log; '': all", std::string()}}},
      {"log.export",
       "Exports a part of an open log as images, a table (CSV), JSON lines or texts",
       {{.name = "kind", .choices = {"images", "csv", "json", "texts"}},
        {"streams", Type::kText, "comma-separated paths; * matches any text, - excludes: red1/*,-*/log"},
        {"file", Type::kFile, "that does not exist yet; for images a folder"},
        from,
        to,
        {"log", Type::kText, "an open log file; '': the first", std::string()}}},
  };
}

Rows playedLogRows() {
  return {
      {"log.play", "Plays the log; at its end, from the start"},
      {"log.pause", "Pauses the log"},
      {"log.stop", "Pauses the log at its start"},
      {"log.speed",
       "Sets the playback speed relative to real time",
       {{"speed", Type::kNumber, "a factor of real time, 0.05 to 50"}}},
      {"log.loop",
       "Loops the whole log or the selected range",
       {{"on", Type::kBool, "off pauses at the end"}}},
      {"log.skip-gaps",
       "Skips gaps of more than a second in the log",
       {{"on", Type::kBool, "off plays them at normal speed"}}},
      {"log.range",
       "Selects a range, for example to loop it; equal times clear the selection",
       {{"from", Type::kNumber, "seconds since the start"},
        {"to", Type::kNumber, "seconds since the start"}}},
      {"log.step",
       "Pauses the log and steps by frames of the chosen process",
       {{"count", Type::kNumber, "how many; negative: backward", 1.0}}},
      {"log.step-message",
       "Pauses the log and steps by messages of a stream",
       {{"stream", Type::kText, "its path: red1/camera/image"},
        {"count", Type::kNumber, "how many; negative: backward", 1.0}}},
      {"log.step-process",
       "Chooses the process whose frames are counted and stepped through",
       {{"process", Type::kText, "red1/cognition"}}},
      {"log.jump", "Jumps to a time of the log", {{"seconds", Type::kNumber, "since the start"}}},
      {"log.jump-frame",
       "Jumps to a frame of the chosen process",
       {{"number", Type::kNumber, "of the frame, as the process counted"}}},
  };
}

Rows timelineRows() {
  return {
      {"timeline.pause", "Pauses all views, while the robots continue"},
      {"timeline.live", "Returns all views to what the robots send now"},
      {"timeline.seek",
       "Shows an earlier instant in all views, while the robots continue",
       {{"time", Type::kNumber, "seconds; negative: before now"}}},
      {"timeline.step",
       "Steps what all views show by frames of the selected robot, while the robots continue",
       {{"count", Type::kNumber, "how many; negative: backward", 1.0}}},
      {"timeline.step-message",
       "Steps what all views show by messages of a stream, while the robots continue",
       {{"stream", Type::kText, "its path: red1/camera/image"},
        {"count", Type::kNumber, "how many; negative: backward", 1.0}}},
      {"timeline.step-change",
       "Steps to where a value changes, or crosses a "
       "threshold: in the open logs, without playing them, "
       "or in the history of live robots, while they continue",
       {{"expression", Type::kText, "models/ball.position.x, or any expression"},
        {.name = "direction", .initial = std::string("next"), .choices = {"next", "previous"}},
        {.name = "value",
         .type = Type::kNumber,
         .help = "only where the value rises to this, or falls below it",
         .mayBeMissing = true}}},
      {"timeline.memory",
       "Sets how much history of the robots is kept in memory; the setting is remembered",
       {{"mib", Type::kNumber, "MiB, 64 or more"}}},
      {"timeline.disk",
       "Sets how much older history of the robots is kept on disk; the setting is remembered",
       {{"mib", Type::kNumber, "MiB; 0: nothing"}}},
  };
}

Rows recordingRows() {
  return {
      {"recording.start", "Starts recording into a new file in the folder for recordings"},
      {"recording.start-file",
       "Starts recording into a file",
       {{"file", Type::kFile, "a log file that does not exist yet"}}},
      {"recording.stop", "Ends the recording"},
      {"recording.toggle", "Starts recording into a new file, or ends the recording"},
      {"recording.save-last", "Saves the last seconds, which are kept in memory, to a new file"},
      {"recording.save-last-file",
       "Saves the last seconds, which are kept in memory, to a file",
       {{"file", Type::kFile, "a log file that does not exist yet"}}},
      {"recording.bookmark",
       "Marks the shown instant in the recording; if none is running, saves the last seconds with the mark",
       {{"text", Type::kText, "what happens there"}}},
      {"recording.streams",
       "Chooses what is recorded; empty: all that a replay needs",
       {{"selection", Type::kText, "comma-separated paths; * matches any text, - excludes: red1/*,-*/log"}}},
      {"recording.images",
       "Chooses how images are recorded",
       {{.name = "coding", .choices = {"as-is", "jpeg", "png"}}}},
      {"recording.compression",
       "Chooses how new files are compressed",
       {{.name = "compression", .choices = {"none", "lz4", "zstd"}}}},
      {"recording.keep",
       "Keeps the last seconds in memory, to save them when something happens; 0 keeps nothing",
       {{"seconds", Type::kNumber, "0 to 3600"}}},
      {"recording.trigger",
       "Saves the last seconds when a message arrives on a stream; empty: never",
       {{"stream", Type::kText, "its path; * matches any text: red1/plots/ball-model/*"}}},
      {"recording.folder", "Chooses the folder for new recordings", {{"folder", Type::kFile, "its path"}}},
  };
}

}  // namespace

Rows commandCatalog() {
  Rows all;
  for (Rows& rows :
       std::vector<Rows>{simulationRows(), sceneRows(), robotRows(), remoteRows(), openedLogRows(),
                         writtenLogRows(), playedLogRows(), timelineRows(), recordingRows(), windowCatalog(),
                         controlCatalog(), colorCatalog(), gameCatalog()})
    std::ranges::move(rows, std::back_inserter(all));
  return all;
}

}  // namespace robotlink
