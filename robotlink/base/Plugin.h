// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The declaration that each plug-in has in one of its sources; PLUGINS.md has an example of each kind.
//
//     ROBOTCONTROL_PLUGIN("ball-counter", "1.0", "Counts the images in which a ball was seen.") {
//       widgets::ViewRegistration({...});
//     }
//
// The body is called once, in the thread of main(), before anything is opened; exceptions and registrations
// that are refused fail the plug-in, and what it has registered so far is undone. Registrations are copied;
// names and texts that are passed as pointers must have static storage, as literals do. A plug-in is never
// unloaded.

namespace robotlink {

/// The description of a plug-in by itself, with the function that registers its parts. A plain value.
struct PluginDescription {
  /// Unique among plug-ins: "ball-counter".
  const char* name;
  const char* version;
  /// A sentence for users.
  const char* help;
  void (*registerAll)();
};

}  // namespace robotlink

#define ROBOTCONTROL_TEXT_OF_(value) #value
#define ROBOTCONTROL_TEXT_OF(value) ROBOTCONTROL_TEXT_OF_(value)

/// The version of the interface that plug-ins are built for: the classes in the installed headers. It grows
/// whenever a plug-in that was built before would no longer run.
#define ROBOTCONTROL_PLUGIN_VERSION 3
/// A string in the file of a plug-in that is compared before any of its code runs.
#define ROBOTCONTROL_PLUGIN_MARK "RobotControl plug-in interface "
#ifdef __clang__
#define ROBOTCONTROL_PLUGIN_COMPILER "clang " ROBOTCONTROL_TEXT_OF(__clang_major__)
#else
#define ROBOTCONTROL_PLUGIN_COMPILER "g++ " ROBOTCONTROL_TEXT_OF(__GNUC__)
#endif
#define ROBOTCONTROL_PLUGIN_INTERFACE            \
  ROBOTCONTROL_PLUGIN_MARK ROBOTCONTROL_TEXT_OF( \
      ROBOTCONTROL_PLUGIN_VERSION) " (" ROBOTCONTROL_PLUGIN_COMPILER ")"

#define ROBOTCONTROL_PLUGIN(name, version, help)                                                           \
  static void robotcontrolRegisterAll();                                                                   \
  extern "C" __attribute__((visibility("default"))) const char robotcontrolPluginInterface[];              \
  const char robotcontrolPluginInterface[] = ROBOTCONTROL_PLUGIN_INTERFACE;                                \
  extern "C" __attribute__((visibility("default"))) const robotlink::PluginDescription robotcontrolPlugin; \
  const robotlink::PluginDescription robotcontrolPlugin{name, version, help, robotcontrolRegisterAll};     \
  static void robotcontrolRegisterAll()
