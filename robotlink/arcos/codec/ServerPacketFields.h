// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <type_traits>

#include "robotlink/arcos/codec/Identity.h"
#include "robotlink/arcos/codec/LaserPacket.h"
#include "robotlink/arcos/codec/SensorPackets.h"
#include "robotlink/arcos/codec/SimulatorPackets.h"
#include "robotlink/arcos/codec/StandardInformation.h"

// The fields of all server packets for readers, writers and descriptions, in the order of the wire; see
// WireFields.h. In each visitFields(), `P` is the packet's struct, const for writers and descriptions, and
// `V` the visitor. Internal to this folder.
namespace robotlink::arcos {

/// T is Of, const or not.
template <typename T, typename Of>
concept Is = std::same_as<std::remove_const_t<T>, Of>;

/// The last reply of the handshake: three strings.
template <Is<Identity> P, typename V>
void visitFields(P& p, V& v) {
  v("name", p.name);
  v("class", p.robotClass);
  v("subclass", p.subclass);
  v.rest(p.rest);
}

/// SIP: fixed fields, the list of sonars, then optional fields that older robots lack.
template <Is<StandardInformation> P, typename V>
void visitFields(P& p, V& v) {
  v("x", p.xMm, "mm");
  v("y", p.yMm, "mm");
  v("heading", p.heading4096, "1/4096 turn");
  v("left speed", p.leftSpeedMmS, "mm/s");
  v("right speed", p.rightSpeedMmS, "mm/s");
  // Two bytes of flags each; names of bits begin at bit 0.
  v("battery", p.batteryDecivolts, "0.1 V");
  v("stall and bumpers", p.stallAndBumpers,
    "bits: left stall, rear 1, rear 2, rear 3, rear 4, rear 5, rear 6, rear 7, "
    "right stall, front 1, front 2, front 3, front 4, front 5, front 6, front 7");
  v("heading setpoint", p.headingSetpoint4096, "1/4096 turn");
  v("flags", p.flags,
    "bits: motors on, sonar array 1, sonar array 2, sonar array 3, sonar array 4, stop button, "
    "emergency stall, far infrared, near infrared, joystick button, charger power");
  v("compass", p.compass2Deg, "2 deg");
  // A sonar is its number and its range.
  v.template size<std::uint8_t>("sonars", p.sonars);
  for (std::size_t i = 0; i < p.sonars.size(); ++i) {
    v.enter("sonar", i);
    v.key("number", p.sonars[i].number);
    v("", p.sonars[i].rangeMm, "mm");
    v.leave();
  }
  // Optional from here on.
  v("gripper state", p.gripState, "bits: open, closed, moving, , lift up, lift down, lift moving");
  v("analog port", p.analogPort);
  v("analog", p.analog, "5/255 V");
  v("digital in", p.digitalIn, "bits");
  v("digital out", p.digitalOut, "bits");
  v("battery, fine", p.batteryDecivolts16, "0.1 V");
  v("charge state", p.chargeState, "; 0 not charging; 1 bulk; 2 over; 3 float; 4 balance; 255 unknown");
  v("rotation rate", p.rotationRateDeciDegS, "0.1 deg/s");
  v("fault flags", p.faultFlags, "bits: , temperature, , low battery, gyroscope");
  v("lateral speed", p.lateralSpeedMmS, "mm/s");
  v("temperature", p.temperatureDegC, "degC; -127 unknown; -128 unknown");
  v("state of charge", p.stateOfChargePercent, "%; 0 unknown");
  v("controller time", p.controllerTimeUs, "us");
  v("more flags", p.moreFlags, "bits");
  v.rest(p.rest);
}

/// ENCODERpac.
template <Is<EncoderPacket> P, typename V>
void visitFields(P& p, V& v) {
  v("left", p.leftTicks, "ticks");
  v("right", p.rightTicks, "ticks");
  v.rest(p.rest);
}

/// Visits a list of plain numbers, preceded by a byte with their count.
template <typename L, typename V>
void visitNumbers(const char* lengthName, const char* name, L& list, V& v, const char* unit) {
  v.template size<std::uint8_t>(lengthName, list);
  for (std::size_t i = 0; i < list.size(); ++i) {
    v.enter(name, i);
    v("", list[i], unit);
    v.leave();
  }
}

/// IOpac: three lists.
template <Is<IoPacket> P, typename V>
void visitFields(P& p, V& v) {
  visitNumbers("digital inputs", "digital in", p.digitalIn, v, "bits");
  visitNumbers("digital outputs", "digital out", p.digitalOut, v, "bits");
  visitNumbers("analog inputs", "analog in", p.analog, v, "5/1023 V");
  v.rest(p.rest);
}

/// GYROpac: a list of rate and temperature.
template <Is<GyroPacket> P, typename V>
void visitFields(P& p, V& v) {
  v.template size<std::uint8_t>("readings", p.readings);
  for (std::size_t i = 0; i < p.readings.size(); ++i) {
    v.enter("reading", i);
    v("rate", p.readings[i].rate);
    v("temperature", p.readings[i].temperature);
    v.leave();
  }
  v.rest(p.rest);
}

/// IMUpac: a list of readings, each with lists of axes.
template <Is<ImuPacket> P, typename V>
void visitFields(P& p, V& v) {
  v("since information packet", p.sinceInformationMs, "ms");
  v.template size<std::uint8_t>("readings", p.readings);
  for (std::size_t i = 0; i < p.readings.size(); ++i) {
    auto& reading = p.readings[i];
    v.enter("reading", i);
    // The number of axes comes before the range.
    v.template size<std::uint8_t>("gyro axes", reading.gyro);
    v("gyro range", reading.gyroRange);
    for (auto& value : reading.gyro) v("gyro", value);
    v.template size<std::uint8_t>("acceleration axes", reading.acceleration);
    for (auto& value : reading.acceleration) v("acceleration", value, "0.002522 g");
    v.template size<std::uint8_t>("temperatures", reading.temperature);
    for (auto& value : reading.temperature) v("temperature", value);
    v.leave();
  }
  v.rest(p.rest);
}

/// SERAUXpac: only bytes.
template <Is<AuxSerialPacket> P, typename V>
void visitFields(P& p, V& v) {
  v.rest(p.bytes);
}

/// TCM2pac.
template <Is<CompassPacket> P, typename V>
void visitFields(P& p, V& v) {
  v("heading", p.headingDecidegrees, "0.1 deg");
  v("pitch", p.pitchDecidegrees, "0.1 deg");
  v("roll", p.rollDecidegrees, "0.1 deg");
  v("magnetic x", p.magneticHundredthsUt[0], "0.01 uT");
  v("magnetic y", p.magneticHundredthsUt[1], "0.01 uT");
  v("magnetic z", p.magneticHundredthsUt[2], "0.01 uT");
  v("temperature", p.temperatureDecidegC, "0.1 degC");
  v("error", p.error, "bits");
  v("horizontal score", p.horizontalScore);
  v("vertical score", p.verticalScore);
  v("magnetic score", p.magneticScoreHundredths, "0.01 ");
  v.rest(p.rest);
}

/// GRIPPERpac.
template <Is<GripperPacket> P, typename V>
void visitFields(P& p, V& v) {
  v("has gripper", p.hasGripper);
  v("state", p.state, "bits");
  v("grasp time", p.graspTime);
  v.rest(p.rest);
}

/// JOYSTICKpac.
template <Is<JoystickPacket> P, typename V>
void visitFields(P& p, V& v) {
  v("button 1", p.button1);
  v("button 2", p.button2);
  v("x", p.x);
  v("y", p.y);
  v("throttle", p.throttle);
  v.rest(p.rest);
}

/// A battery of BATTERYpac, without the bytes that depend on its type; the list is handled in
/// ServerPackets.cpp.
template <Is<BatteryPacket::Battery> P, typename V>
void visitFields(P& p, V& v) {
  v("flags 1", p.flags1, "bits");
  v("flags 2", p.flags2, "bits");
  v("flags 3", p.flags3, "bits");
  v("relative charge", p.relativeChargePercent, "%");
  v("absolute charge", p.absoluteChargePercent, "%");
}

/// A part of a laser scan. Plain packets begin with the pose, extended ones end with device and flags.
template <Is<LaserPacket> P, typename V>
void visitFields(P& p, V& v) {
  if (!p.extended) {
    v("x", p.xMm, "mm");
    v("y", p.yMm, "mm");
    v("heading", p.headingDeg, "deg");
  }
  v("total", p.total, "readings");
  v("first", p.first);
  v.template size<std::uint8_t>("readings", p.readings);
  for (std::size_t i = 0; i < p.readings.size(); ++i) {
    v.enter("reading", i);
    v("", p.readings[i].rangeMm, "mm");
    if (p.extended) {
      v("reflectance", p.readings[i].reflectance);
      v("reserved", p.readings[i].reserved[0]);
      v("reserved", p.readings[i].reserved[1]);
    }
    v.leave();
  }
  if (p.extended) {
    v("device", p.device);
    v("flags", p.flags, "bits: robot moved");
  }
  v.rest(p.rest);
}

/// The reply to SIM_STAT.
template <Is<SimulatorStatus> P, typename V>
void visitFields(P& p, V& v) {
  v("reserved", p.reserved1);
  v("reserved", p.reserved2);
  v("flags", p.flags, "bits: , global position, odometry error");
  v("simulated interval", p.simulatedIntervalMs, "ms");
  v("real interval", p.realIntervalMs, "ms");
  v("last interval", p.lastIntervalMs, "ms");
  v("true x", p.xMm, "mm");
  v("true y", p.yMm, "mm");
  v("true z", p.zMm, "mm");
  v("true heading", p.headingDeg, "deg");
  v("latitude", p.latitude1e7, "1e-7 deg");
  v("longitude", p.longitude1e7, "1e-7 deg");
  v("altitude", p.altitudeCm, "cm");
  v("position quality", p.positionQuality);
  v("odometry error x", p.odometryErrorX1e7, "1e-7");
  v("odometry error y", p.odometryErrorY1e7, "1e-7");
  v("odometry error heading", p.odometryErrorHeading1e7, "1e-7");
  v.rest(p.rest);
}

/// The reply to SIM_CTRL 6; the count of devices has four bytes.
template <Is<SimulatorInfo> P, typename V>
void visitFields(P& p, V& v) {
  v("application", p.application);
  v("version", p.version);
  v("flags", p.flags, "bits");
  v.template size<std::uint32_t>("devices", p.devices);
  for (std::size_t i = 0; i < p.devices.size(); ++i) {
    v.enter("device", i);
    v("name", p.devices[i].name);
    v("type", p.devices[i].type);
    v("number", p.devices[i].number);
    v("status", p.devices[i].status, "bits");
    v.leave();
  }
  v.rest(p.rest);
}

/// The notice that the map has changed.
template <Is<MapChanged> P, typename V>
void visitFields(P& p, V& v) {
  v("by user", p.byUser);
  v("loaded", p.loaded);
  v("file", p.file);
  v.rest(p.rest);
}

}  // namespace robotlink::arcos
