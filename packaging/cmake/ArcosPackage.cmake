# SPDX-License-Identifier: GPL-3.0-or-later
# The client library for Pioneers alone, without Qt and Protocol Buffers, for projects of others:
#   cmake --install build/release --component arcos --prefix /where/it/shall/be
include_guard()
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# One archive of all that a client needs; what is needed to build this project itself (warnings, sanitizers) stays here.
add_library(robotcontrol_arcos STATIC $<TARGET_OBJECTS:robotlink_arcos> $<TARGET_OBJECTS:robotlink_base>)
set_target_properties(robotcontrol_arcos PROPERTIES LINKER_LANGUAGE CXX EXPORT_NAME arcos)
target_compile_features(robotcontrol_arcos INTERFACE cxx_std_20)
target_link_libraries(robotcontrol_arcos INTERFACE Eigen3::Eigen tl::expected Threads::Threads)
target_include_directories(robotcontrol_arcos INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/robotcontrol>)

# Where there are programs, too, it is installed when it is asked for by its name.
set(arcos_component COMPONENT arcos)
if(NOT ROBOTCONTROL_ARCOS_ONLY)
  list(APPEND arcos_component EXCLUDE_FROM_ALL)
endif()
set(arcos_package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/RobotControlArcos)
install(TARGETS robotcontrol_arcos EXPORT RobotControlArcosTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} ${arcos_component})
install(EXPORT RobotControlArcosTargets NAMESPACE RobotControl:: DESTINATION ${arcos_package_folder} ${arcos_component})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/RobotControlArcosConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_LIST_DIR}/RobotControlArcosConfig.cmake ${CMAKE_BINARY_DIR}/RobotControlArcosConfigVersion.cmake
        DESTINATION ${arcos_package_folder} ${arcos_component})

foreach(header
    arcos/ClientSession.h arcos/GripperState.h arcos/MotionGoal.h arcos/PioneerClient.h arcos/PioneerRobot.h arcos/RobotState.h arcos/RobotType.h
    arcos/StateDecoder.h arcos/WireUnits.h arcos/codec/Command.h arcos/codec/ArcosCommandCatalog.h arcos/codec/CommandId.h
    arcos/codec/Configuration.h arcos/codec/Conversation.h arcos/codec/Identity.h arcos/codec/LaserPacket.h
    arcos/codec/LaserScan.h arcos/codec/Packet.h arcos/codec/PacketDescription.h arcos/codec/PacketParser.h
    arcos/codec/RangeScan.h arcos/codec/SensorPackets.h arcos/codec/ServerPackets.h arcos/codec/SimulatorCommands.h
    arcos/codec/SimulatorPackets.h arcos/codec/StandardInformation.h arcos/stream/ByteStream.h
    arcos/stream/OpenStream.h arcos/stream/SerialPorts.h arcos/stream/StreamUrl.h
    base/Clock.h base/Error.h base/Geometry.h base/GlobalPosition.h base/GroundMap.h)
  cmake_path(GET header PARENT_PATH folder)
  # Here, and not only when somebody installs.
  if(NOT EXISTS ${PROJECT_SOURCE_DIR}/robotlink/${header})
    message(FATAL_ERROR "there is no robotlink/${header} to install")
  endif()
  install(FILES ${PROJECT_SOURCE_DIR}/robotlink/${header}
          DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/robotcontrol/robotlink/${folder} ${arcos_component})
endforeach()
