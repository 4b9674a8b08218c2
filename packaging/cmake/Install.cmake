# SPDX-License-Identifier: GPL-3.0-or-later
# What `cmake --install build/release --prefix P` installs: the programs and all that they need. They find their resources
# beside their own folder, so P can be moved as a whole. The library for Pioneers is a component of its own: see ArcosPackage.cmake.
include_guard()
include(GNUInstallDirs)

include(PluginPackage)
install(TARGETS robotctl RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS robotcontrol_video robotcontrol_calibration LIBRARY DESTINATION lib/robotcontrol)  # beside the programs' folder, wherever that is
install(DIRECTORY ${PROJECT_SOURCE_DIR}/resources/ DESTINATION ${CMAKE_INSTALL_DATADIR}/robotcontrol PATTERN translations EXCLUDE)
if(ROBOTCONTROL_GUI)
  install(TARGETS robotcontrol RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  install(DIRECTORY ${PROJECT_BINARY_DIR}/translations DESTINATION ${CMAKE_INSTALL_DATADIR}/robotcontrol FILES_MATCHING PATTERN *.qm)
  install(FILES ${PROJECT_SOURCE_DIR}/packaging/robotcontrol.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
  install(FILES ${PROJECT_SOURCE_DIR}/resources/icons/app.svg
          DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps RENAME robotcontrol.svg)
endif()
