// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of the catalog about the window and about color tables.
#include "robotlink/commands/CommandCatalog.h"

namespace robotlink {
namespace {

using Command = CommandTable::Command;
using Type = CommandTable::Type;
using Rows = std::vector<Command>;

Rows colorFileRows() {
  return {
      {"color.new", "Starts new samples of a color table"},
      {"color.open", "Opens the samples of a color table", {{"file", Type::kFile, "a .samples file"}}},
      {"color.save", "Saves the samples of the color table to their file"},
      {"color.save-as", "Saves the samples of the color table", {{"file", Type::kFile, "a .samples file"}}},
      {"color.discard", "Discards unsaved changes of the samples"},
      {"color.merge", "Adds the samples of another file", {{"file", Type::kFile, "a .samples file"}}},
      {"color.open-pictures",
       "Adds pictures to the strip and shows the first",
       {{"path", Type::kFile, "a picture (.png, .jpg, .jpeg, .yuyv) or a folder of them"}}},
      {"color.export", "Writes the color table to a file", {{"file", Type::kFile, "a .c64 file"}}},
      {"color.compare",
       "Compares the table with another one",
       {{"table", Type::kText, "a file, now (its present state), or none"}}},
  };
}

Rows colorStrokeRows() {
  return {
      {"color.class",
       "Chooses the class of the next stroke",
       {{"name", Type::kText, "of a class, or background"}}},
      {"color.must-not",
       "Chooses whether the next strokes mark colors that must not be of the class",
       {{"on", Type::kBool}}},
      {"color.weight", "Sets how much the next strokes count", {{"weight", Type::kNumber, "0.1 to 10"}}},
      {"color.stroke",
       "Adds a disc of the color view's image to the samples",
       {{"x", Type::kNumber, "pixels"}, {"y", Type::kNumber, "pixels"}, {"radius", Type::kNumber, "pixels"}}},
      {"color.undo", "Undoes the last change of the samples"},
      {"color.redo", "Redoes what was undone"},
  };
}

Rows colorTableRows() {
  return {
      {"color.preset",
       "Sets the classes; strokes keep the class of their name",
       {{"name", Type::kText, "2002 or bhuman2009"}}},
      {"color.method",
       "Chooses the method that makes the table",
       {{"name", Type::kText, "votes, gaussians or support-vectors"}}},
      {"color.option",
       "Sets an option of that method",
       {{"name", Type::kText, "such as radius"}, {"value", Type::kNumber, "switches: 0 or 1"}}},
      {"color.send", "Sends the table to the selected robot's program"},
      {"color.auto-send",
       "Chooses whether each new table is sent to the robot at once",
       {{"on", Type::kBool}}},
      {"color.find-frames", "Searches for the images where the table looks most suspicious"},
  };
}

/// Returns the arguments of both kinds of exports after view and target.
std::vector<CommandTable::Argument> exportArguments(const CommandTable::Argument& target) {
  return {
      {"view", Type::kText, "its name: image, field, plots, ...; the second view is image#2"},
      target,
      {"from", Type::kText, "seconds; negative: before now (live robots); or start", std::string("start")},
      {"to", Type::kText, "the same; or end", std::string("end")},
      {"rate", Type::kNumber, "pictures a second", 25.0},
      {"size", Type::kText, "size of the pictures, such as 1280x720; '': as shown", std::string()}};
}

Rows exportRows() {
  return {
      {"export.video", "Writes a view over time as a video, from the open logs or the history of live robots",
       exportArguments({"file", Type::kFile, "a .mp4 or .avi file"})},
      {"export.images", "Writes a view over time as numbered PNG files into a folder",
       exportArguments({"folder", Type::kFile, "a new or empty one"})},
      {"export.cancel", "Cancels the export of a view; an unfinished video is deleted, written images stay"},
  };
}

Rows pictureRows() {
  const CommandTable::Argument image{"view", Type::kText, "image; the second view is image#2"};
  const char* const kStream = "its path: red1/camera/image; */camera/image is that of the selected robot";
  return {
      {"image.stream",
       "Chooses the images that an Image view shows",
       {image, {"stream", Type::kText, kStream}}},
      {"image.compare",
       "Compares the images of an Image view with second ones",
       {image,
        {"stream", Type::kText, "the same; or none"},
        {.name = "mode",
         .help = "how both are shown",
         .initial = std::string("side-by-side"),
         .choices = {"side-by-side", "blend", "difference"}}}},
      {"image.show",
       "Chooses how an Image view shows its images",
       {image,
        {"mode", Type::kText, "stereogram: for depth images only", {}, {"color", "gray", "stereogram"}}}},
      {"view.drawing",
       "Checks or unchecks a drawing in the list of a view; checking one that is off on the robot switches "
       "it on there",
       {{"view", Type::kText, "image, field, scene or radar; the second view is image#2"},
        {"drawing", Type::kText, "its name, as in the list"},
        {"on", Type::kBool, "off hides it; the robot continues to draw it", true}}},
      {"view.pose",
       "Chooses at which pose of a robot a view places its drawings",
       {{"view", Type::kText, "field or scene; the second view is field#2"},
        {"pose", Type::kText, "default (the true one if known), true, or an estimate: models/pose"}}},
  };
}

Rows sceneViewRows() {
  const CommandTable::Argument view{"view", Type::kText,
                                    "scene; the second view is scene#2; '': all open ones", std::string()};
  const CommandTable::Argument object{"object", Type::kText, "its path: red1, or red1/link:head"};
  return {
      {"scene.view",
       "Chooses how the surfaces of a view of the scene are drawn",
       {{"mode",
         Type::kText,
         "for all objects without their own mode",
         {},
         {"shaded", "flat", "hidden-lines", "wire"}},
        view}},
      {"scene.draw",
       "Chooses how an object and everything in it is drawn",
       {object,
        {"mode",
         Type::kText,
         "view: like the rest of the view",
         {},
         {"view", "shaded", "flat", "hidden-lines", "wire"}},
        view}},
      {"scene.opacity",
       "Makes an object transparent",
       {object, {"opacity", Type::kNumber, "0 (almost invisible) to 1"}, view}},
      {"scene.hide", "Hides an object of the scene and everything in it", {object, view}},
      {"scene.show",
       "Shows a hidden object again",
       {{"object", Type::kText, "its path; '': all", std::string()}, view}},
      {"scene.layer",
       "Shows or hides something in views of the scene",
       {{"layer",
         Type::kText,
         "solids: what collides; visuals: what cameras see",
         {},
         {"visuals", "solids", "forces", "joints", "frames", "centers", "sensors", "names", "shadows"}},
        {"on", Type::kBool, "", true},
        view}},
      {"scene.follow",
       "Makes the camera of a view follow an object",
       {{"object", Type::kText, "its path; '': the robot of the view", std::string()},
        {"how",
         Type::kText,
         "first-person: from its camera, or from the object itself",
         std::string("position"),
         {"position", "heading", "first-person", "off"}},
        view}},
      {"scene.only",
       "Limits a view to an object and everything in it",
       {{"object", Type::kText, "its path; '': the whole scene", std::string()}, view}},
      {"scene.open",
       "Opens a view of an object of the scene",
       {object,
        {"surroundings",
         Type::kText,
         "whether the rest of the scene is shown as well",
         std::string("alone"),
         {"alone", "around"}}}},
  };
}

Rows dataRows() {
  return {
      {"columns.show",
       "Shows the values of a list as columns",
       {{"list", Type::kText, "a sensor of the scene, such as p3at1/laser, or 'red1/range/laser: ranges'"},
        {"view", Type::kText, "columns; the second view is columns#2", std::string("columns")}}},
      {"data.compare",
       "Compares the values in a Data view with others",
       {{"with", Type::kText, "none, now (these values, from now on), remembered, logged, or a robot"},
        {"view", Type::kText, "data; the second view is data#2", std::string("data")}}},
      {"data.publish",
       "Sends a message to a robot once, as the view Data does",
       {{"message", Type::kText, "set-goal, place-model, ... as in the list of the view"},
        {"json", Type::kText, "its fields: '{\"cancelled\": true}'; '': as by default", std::string()},
        {"robot", Type::kText, "its name; '': the selected one", std::string()}}},
      {"messages.filter",
       "Shows only messages whose text or source contains a text",
       {{"text", Type::kText, "'': all messages", std::string()},
        {"regex", Type::kBool, "on: it is a regular expression", false},
        {"view", Type::kText, "messages; the second view is messages#2", std::string("messages")}}},
  };
}

/// The commands of views as such.
Rows shownViewRows() {
  return {
      {"view.show",
       "Brings a view to the front and opens it if needed",
       {{"view", Type::kText, "its name: image, field, packets, ..."}}},
      {"view.screenshot",
       "Saves a picture of a view, which is opened if needed, or of the whole window",
       {{"view", Type::kText, "its name, or window"},
        {"file", Type::kFile, ".png, .svg, or its numbers as .csv or .txt; of the window .png"}}},
      {"view.copy",
       "Copies what a view shows to the clipboard",
       {{"view", Type::kText, "its name: plots, joints, ...; the second view is plots#2"},
        {"as",
         Type::kText,
         "numbers: its table, with tabs between the columns",
         {},
         {"picture", "numbers"}}}},
  };
}

/// The commands of the scene editor.
Rows sceneEditRows() {
  return {
      {"scene.edit",
       "Shows an object of the simulated scene in the scene editor, or a scene file",
       {{"object", Type::kText, "red1/head/camera, or a file; '': what is selected in the scene",
         std::string()}}},
      {"scene.save",
       "Saves the file in the scene editor",
       {{"file", Type::kFile, "another one; '': its own", std::string()}}},
      {"scene.apply", "Applies the texts of the scene editor to the running simulation without saving them"},
      {"scene.insert",
       "Adds an object to the text of the simulated scene, and applies it; nothing is saved",
       {{"kind", Type::kText, "box, ball, cylinder, wall, lamp, camera, or the name of a model"},
        {"x", Type::kNumber, "m, in the field's frame"},
        {"y", Type::kNumber, "m"}}},
      {"scene.copy",
       "Adds a copy of an object to the text of the simulated scene, half a meter away",
       {{"object", Type::kText, "its name in the scene; '': what is selected", std::string()}}},
      {"scene.erase",
       "Removes an object from the text of the simulated scene, and applies it; nothing is saved",
       {{"object", Type::kText, "its name in the scene; '': what is selected", std::string()}}},
      {"scene.rename",
       "Renames an object in the text of the simulated scene",
       {{"object", Type::kText, "its name in the scene"}, {"name", Type::kText, "the new one"}}},
      {"scene.write",
       "Makes the present pose of an object its initial one in the text of the simulated scene; nothing is "
       "saved",
       {{"object", Type::kText, "its name in the scene; '': what is selected", std::string()}}},
      {"scene.undo-edit", "Undoes the last change of the scene, made by hand or by these commands"},
      {"scene.redo-edit", "Redoes the last change undone"},
  };
}

/// The commands that change bookmarks.
Rows bookmarkRows() {
  return {
      {"log.bookmark",
       "Adds a bookmark to the log",
       {{"seconds", Type::kNumber, "since the start"}, {"text", Type::kText, "text of the bookmark"}}},
      {"log.remove-bookmark",
       "Removes a bookmark of the open logs; if several have this text, the first",
       {{"text", Type::kText, "text of the bookmark"}}},
      {"log.rename-bookmark",
       "Changes the text of a bookmark of the open logs; if several have this text, the first",
       {{"text", Type::kText, "text of the bookmark"}, {"new-text", Type::kText, "instead"}}},
  };
}

}  // namespace

Rows windowCatalog() {
  Rows rows = exportRows();
  for (Rows& more : std::vector<Rows>{pictureRows(), sceneViewRows(), dataRows(), shownViewRows(),
                                      sceneEditRows(), bookmarkRows()})
    rows.insert(rows.end(), more.begin(), more.end());
  return rows;
}

Rows colorCatalog() {
  Rows all = colorFileRows();
  for (Rows& rows : std::vector<Rows>{colorStrokeRows(), colorTableRows()})
    all.insert(all.end(), rows.begin(), rows.end());
  return all;
}

}  // namespace robotlink
