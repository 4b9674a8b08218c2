# SPDX-License-Identifier: GPL-3.0-or-later
# The libraries that programs share with their plug-ins, with their headers and a CMake package: find_package(RobotControl).
include_guard()
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# All lie beside the programs' folder, wherever that is.
get_property(internal GLOBAL PROPERTY ROBOTCONTROL_INTERNAL_LIBRARIES)
install(TARGETS ${internal} LIBRARY DESTINATION lib/robotcontrol)
get_property(libraries GLOBAL PROPERTY ROBOTCONTROL_PUBLIC_LIBRARIES)
install(TARGETS ${libraries} EXPORT RobotControlTargets
        LIBRARY DESTINATION lib/robotcontrol
        INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/robotcontrol)

foreach(folder robotlink colortool logplayer simcore widgets app/core app/platforms)
  if(EXISTS ${PROJECT_BINARY_DIR}/${folder})
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/robotcontrol/${folder}
            FILES_MATCHING PATTERN "*.h")
  endif()
endforeach()
# Generated headers of packages, as they are included: "robotcontrol/Perception.pb.h". The .proto files are for messages that have
# others in them.
foreach(folder foxglove robotcontrol)
  install(DIRECTORY ${PROJECT_BINARY_DIR}/robotlink/packages/${folder} ${PROJECT_SOURCE_DIR}/robotlink/packages/${folder}
          DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/robotcontrol FILES_MATCHING PATTERN "*.pb.h" PATTERN "*.proto")
endforeach()

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/RobotControl)
install(EXPORT RobotControlTargets NAMESPACE RobotControl:: DESTINATION ${package_folder})
configure_file(${CMAKE_CURRENT_LIST_DIR}/RobotControlConfig.cmake.in ${CMAKE_BINARY_DIR}/RobotControlConfig.cmake @ONLY)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/RobotControlConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/RobotControlConfig.cmake ${CMAKE_BINARY_DIR}/RobotControlConfigVersion.cmake
        DESTINATION ${package_folder})
