// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/arcos/codec/Configuration.h"

// The fields of CONFIGpac for readers, writers and descriptions, in the order of the wire; see WireFields.h.
// Internal to this folder.
namespace robotlink::arcos {

/// The names of the baud rates' codes, in the form of WireFields.h.
inline constexpr const char* kBauds =
    "; 0 9600 baud; 1 19200 baud; 2 38400 baud; 3 57600 baud; 4 115200 baud";

/// The first half of visitConfigurationFields().
template <typename C, typename V>
void visitIdentityAndLines(C& c, V& v) {
  // Identity.
  v("type", c.type);
  v("subtype", c.subtype);
  v("serial number", c.serialNumber);
  v("four motors", c.fourMotors);
  // Limits that can never be exceeded.
  v("rotation speed, top", c.rotVelTopDegS, "deg/s");
  v("translation speed, top", c.transVelTopMmS, "mm/s");
  v("rotation acceleration, top", c.rotAccTopDegS2, "deg/s2");
  v("translation acceleration, top", c.transAccTopMmS2, "mm/s2");
  v("pwm max", c.pwmMax);
  // Lines and devices.
  v("name", c.name);
  v("sip cycle", c.sipCycleMs, "ms");
  v("host baud", c.hostBaud, kBauds);
  v("aux baud 1", c.auxBaud1, kBauds);
  v("gripper", c.gripper);
  v("front sonar", c.frontSonar);
  v("rear sonar", c.rearSonar);
  v("low battery", c.lowBatteryDecivolts, "0.1 V");
  v("rev count", c.revCount);
  v("watchdog", c.watchdogMs, "ms");
  v("P2MPACS", c.p2Mpacs);
  v("stall value", c.stallValue);
  v("stall count", c.stallCountMs, "ms");
  v("joy speed", c.joyVelMmS, "mm/s");
  v("joy rot speed", c.joyRotVelDegS, "deg/s");
}

/// The second half of visitConfigurationFields().
template <typename C, typename V>
void visitLimitsAndDevices(C& c, V& v) {
  // Present limits, accelerations and gains.
  v("rotation speed, limit", c.rotVelMaxDegS, "deg/s");
  v("translation speed, limit", c.transVelMaxMmS, "mm/s");
  v("rotation acceleration", c.rotAccDegS2, "deg/s2");
  v("rotation deceleration", c.rotDecelDegS2, "deg/s2");
  v("rotation gain P", c.rotKp);
  v("rotation gain V", c.rotKv);
  v("rotation gain I", c.rotKi);
  v("translation acceleration", c.transAccMmS2, "mm/s2");
  v("translation deceleration", c.transDecelMmS2, "mm/s2");
  v("translation gain P", c.transKp);
  v("translation gain V", c.transKv);
  v("translation gain I", c.transKi);
  // Sensors and electronics.
  v("front bumpers", c.frontBumpers);
  v("rear bumpers", c.rearBumpers);
  v("charger", c.charger);
  v("sonar cycle", c.sonarCycleMs, "ms");
  v("auto baud", c.autoBaud);
  v("has gyro", c.hasGyro, "; 0 none; 1 for the client; 2 for the robot");
  v("drift factor", c.driftFactor, "1/8192");
  v("aux baud 2", c.auxBaud2, kBauds);
  v("aux baud 3", c.auxBaud3, kBauds);
  v("encoder ticks", c.ticksMm, "ticks/mm");
  v("shutdown", c.shutdownDecivolts, "0.1 V");
  v("version", c.version);
  v("gyro cw", c.gyroCw);
  v("gyro ccw", c.gyroCcw);
  v("kinematics delay", c.kinematicsDelayMs, "ms");
  // Robots that can drive sideways.
  v("lateral speed, top", c.latVelTopMmS, "mm/s");
  v("lateral acceleration, top", c.latAccTopMmS2, "mm/s2");
  v("lateral speed, limit", c.latVelMaxMmS, "mm/s");
  v("lateral acceleration", c.latAccMmS2, "mm/s2");
  v("lateral deceleration", c.latDecelMmS2, "mm/s2");
  v("charge threshold", c.chargeThreshold);
  // Fields of newer firmware.
  v("pdb port", c.pdbPort);
  v("gyro rate limit", c.gyroRateLimitDegS, "deg/s");
  v("high temperature", c.highTemperatureDegC, "degC");
  v("power bits", c.powerBits, "bits");
  v("battery type", c.batteryType);
  v("state of charge low", c.stateOfChargeLow);
  v("state of charge shutdown", c.stateOfChargeShutdown);
  v("boot version", c.bootVersion);
  v("config flags", c.configFlags, "bits");
  v("gyro firmware version", c.gyroFirmwareVersion);
}

/// Calls v(name, member, unit) for each field, in the order of the packet. `C` is Configuration, const or
/// not. `rest` and `fieldCount` are handled by the visitor's owner.
template <typename C, typename V>
void visitConfigurationFields(C& c, V& v) {
  visitIdentityAndLines(c, v);
  visitLimitsAndDevices(c, v);
}

}  // namespace robotlink::arcos
