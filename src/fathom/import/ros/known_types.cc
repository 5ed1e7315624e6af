// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/ros/known_types.h"

#include <cstddef>

#include <fmt/format.h>

namespace fathom {
namespace {

// Each type behind a line of "=" and "MSG: ", as in a bag. From the .msg files of ROS 2's
// common_interfaces, geometry2 and rcl_interfaces: names and types only.
constexpr std::string_view kKnownTypes = R"(
===
MSG: builtin_interfaces/Time
int32 sec
uint32 nanosec
===
MSG: builtin_interfaces/Duration
int32 sec
uint32 nanosec
===
MSG: std_msgs/Header
builtin_interfaces/Time stamp
string frame_id
===
MSG: std_msgs/Bool
bool data
===
MSG: std_msgs/Float32
float32 data
===
MSG: std_msgs/Float64
float64 data
===
MSG: std_msgs/Int16
int16 data
===
MSG: std_msgs/Int32
int32 data
===
MSG: std_msgs/Int64
int64 data
===
MSG: std_msgs/UInt8
uint8 data
===
MSG: std_msgs/UInt16
uint16 data
===
MSG: std_msgs/UInt32
uint32 data
===
MSG: std_msgs/MultiArrayDimension
string label
uint32 size
uint32 stride
===
MSG: std_msgs/MultiArrayLayout
MultiArrayDimension[] dim
uint32 data_offset
===
MSG: std_msgs/Float32MultiArray
MultiArrayLayout layout
float32[] data
===
MSG: std_msgs/Float64MultiArray
MultiArrayLayout layout
float64[] data
===
MSG: std_msgs/Int32MultiArray
MultiArrayLayout layout
int32[] data
===
MSG: std_msgs/UInt16MultiArray
MultiArrayLayout layout
uint16[] data
===
MSG: geometry_msgs/Vector3
float64 x
float64 y
float64 z
===
MSG: geometry_msgs/Vector3Stamped
std_msgs/Header header
Vector3 vector
===
MSG: geometry_msgs/Point
float64 x
float64 y
float64 z
===
MSG: geometry_msgs/PointStamped
std_msgs/Header header
Point point
===
MSG: geometry_msgs/Quaternion
float64 x
float64 y
float64 z
float64 w
===
MSG: geometry_msgs/QuaternionStamped
std_msgs/Header header
Quaternion quaternion
===
MSG: geometry_msgs/Pose
Point position
Quaternion orientation
===
MSG: geometry_msgs/Pose2D
float64 x
float64 y
float64 theta
===
MSG: geometry_msgs/PoseStamped
std_msgs/Header header
Pose pose
===
MSG: geometry_msgs/PoseWithCovariance
Pose pose
float64[36] covariance
===
MSG: geometry_msgs/PoseWithCovarianceStamped
std_msgs/Header header
PoseWithCovariance pose
===
MSG: geometry_msgs/Twist
Vector3 linear
Vector3 angular
===
MSG: geometry_msgs/TwistStamped
std_msgs/Header header
Twist twist
===
MSG: geometry_msgs/TwistWithCovariance
Twist twist
float64[36] covariance
===
MSG: geometry_msgs/TwistWithCovarianceStamped
std_msgs/Header header
TwistWithCovariance twist
===
MSG: geometry_msgs/Accel
Vector3 linear
Vector3 angular
===
MSG: geometry_msgs/AccelStamped
std_msgs/Header header
Accel accel
===
MSG: geometry_msgs/Wrench
Vector3 force
Vector3 torque
===
MSG: geometry_msgs/WrenchStamped
std_msgs/Header header
Wrench wrench
===
MSG: geometry_msgs/Transform
Vector3 translation
Quaternion rotation
===
MSG: geometry_msgs/TransformStamped
std_msgs/Header header
string child_frame_id
Transform transform
===
MSG: nav_msgs/Odometry
std_msgs/Header header
string child_frame_id
geometry_msgs/PoseWithCovariance pose
geometry_msgs/TwistWithCovariance twist
===
MSG: sensor_msgs/Imu
std_msgs/Header header
geometry_msgs/Quaternion orientation
float64[9] orientation_covariance
geometry_msgs/Vector3 angular_velocity
float64[9] angular_velocity_covariance
geometry_msgs/Vector3 linear_acceleration
float64[9] linear_acceleration_covariance
===
MSG: sensor_msgs/FluidPressure
std_msgs/Header header
float64 fluid_pressure
float64 variance
===
MSG: sensor_msgs/MagneticField
std_msgs/Header header
geometry_msgs/Vector3 magnetic_field
float64[9] magnetic_field_covariance
===
MSG: sensor_msgs/JointState
std_msgs/Header header
string[] name
float64[] position
float64[] velocity
float64[] effort
===
MSG: sensor_msgs/Range
std_msgs/Header header
uint8 radiation_type
float32 field_of_view
float32 min_range
float32 max_range
float32 range
===
MSG: tf2_msgs/TFMessage
geometry_msgs/TransformStamped[] transforms
)";

}  // namespace

std::string KnownDefinition(std::string_view type) {
  const std::string head = fmt::format("MSG: {}\n", WithoutMsg(type));
  const std::size_t begin = kKnownTypes.find(head);
  if (begin == std::string_view::npos) return {};
  const std::string_view text = kKnownTypes.substr(begin + head.size());
  return std::string(text.substr(0, text.find("===\n"))) + std::string(kKnownTypes);
}

std::string WithoutMsg(std::string_view type) {
  std::string name(type);
  const std::size_t middle = name.find("/msg/");
  if (middle != std::string::npos) name.erase(middle, 4);
  return name;
}

}  // namespace fathom
