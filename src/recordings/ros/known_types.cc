#include "recordings/ros/known_types.h"

#include <algorithm>
#include <string>

#include "recordings/ros/definition.h"

namespace somato {
namespace {

// ROS 2's own types; units by REP 103.
constexpr KnownChannel kJointState[] = {{"", "position", "rad", "name"},
                                        {"/velocity", "velocity", "rad/s", "name"},
                                        {"/effort", "effort", "N*m", "name"}};
constexpr KnownChannel kData[] = {{"", "data", ""}};
constexpr KnownChannel kWrench[] = {{"/force", "force", "N"}, {"/torque", "torque", "N*m"}};
constexpr KnownChannel kWrenchStamped[] = {{"/force", "wrench.force", "N"},
                                           {"/torque", "wrench.torque", "N*m"}};
constexpr KnownChannel kImu[] = {{"/orientation", "orientation", ""},
                                 {"/angular_velocity", "angular_velocity", "rad/s"},
                                 {"/linear_acceleration", "linear_acceleration", "m/s^2"}};
constexpr KnownChannel kMagneticField[] = {{"", "magnetic_field", "T"}};
constexpr KnownChannel kFluidPressure[] = {{"", "fluid_pressure", "Pa"}};
constexpr KnownChannel kTemperature[] = {{"", "temperature", "degC"}};
constexpr KnownChannel kRange[] = {{"", "range", "m"}};
constexpr KnownChannel kTwistStamped[] = {{"/linear", "twist.linear", "m/s"},
                                          {"/angular", "twist.angular", "rad/s"}};
constexpr KnownChannel kPoseStamped[] = {{"/position", "pose.position", "m"},
                                         {"/orientation", "pose.orientation", ""}};
constexpr KnownChannel kVector3Stamped[] = {{"", "vector", ""}};

// ros2_control (control_msgs): the values that its interfaces name.
constexpr KnownChannel kDynamicJointState[] = {
    {"", "interface_values[*].values", "", "joint_names+interface_values[*].interface_names"}};

// tactile_msgs of Bielefeld University: raw values of each sensor array.
constexpr KnownChannel kTactileState[] = {{"", "sensors[*].values", "", "sensors[*].name"}};

// XELA uSkin (xela_server_ros2): displacements in counts, and forces of calibrated sensors.
constexpr KnownChannel kSensStream[] = {{"", "sensors[*].taxels", "counts"},
                                        {"/force", "sensors[*].forces", "N"}};

// Contactile PapillArray (papillarray_ros_v2): forces of the pillars and of the sensor, torques in
// N*mm, displacements in mm by the maker's manual.
constexpr KnownChannel kPapillArrayState[] = {{"/displacement_x", "pillars[*].dX", "mm"},
                                              {"/displacement_y", "pillars[*].dY", "mm"},
                                              {"/displacement_z", "pillars[*].dZ", "mm"},
                                              {"/force_x", "pillars[*].fX", "N"},
                                              {"/force_y", "pillars[*].fY", "N"},
                                              {"/force_z", "pillars[*].fZ", "N"},
                                              {"/global_force_x", "gfX", "N"},
                                              {"/global_force_y", "gfY", "N"},
                                              {"/global_force_z", "gfZ", "N"},
                                              {"/global_torque_x", "gtX", "N*mm"},
                                              {"/global_torque_y", "gtY", "N*mm"},
                                              {"/global_torque_z", "gtZ", "N*mm"}};

// The same sensors by the community's driver (papillarray_interfaces): filtered forces and torques.
constexpr KnownChannel kPapillArrayTactile[] = {{"/force_x", "force_x_n", "N"},
                                                {"/force_y", "force_y_n", "N"},
                                                {"/force_z", "force_z_n", "N"},
                                                {"/normal_force", "normal_force_n", "N"},
                                                {"/tangential_force", "tangential_force_n", "N"},
                                                {"/torque_x", "torque_x_nm", "N*m"},
                                                {"/torque_y", "torque_y_nm", "N*m"},
                                                {"/torque_z", "torque_z_nm", "N*m"}};

// Shadow Robot (sr_robot_msgs): BioTac, pressure sensors, UBI fingertips, magnetic sensors.
constexpr KnownChannel kBiotacAll[] = {{"/electrodes", "tactiles[*].electrodes", "counts"},
                                       {"/pac0", "tactiles[*].pac0", "counts"},
                                       {"/pac1", "tactiles[*].pac1", "counts"},
                                       {"/pdc", "tactiles[*].pdc", "counts"},
                                       {"/tac", "tactiles[*].tac", "counts"},
                                       {"/tdc", "tactiles[*].tdc", "counts"}};
constexpr KnownChannel kShadowPst[] = {{"/pressure", "pressure", "counts"},
                                       {"/temperature", "temperature", "counts"}};
constexpr KnownChannel kUbi0All[] = {{"", "tactiles[*].distal", "counts"}};
constexpr KnownChannel kMstAll[] = {{"/magnetic", "tactiles[*].magnetic_data", ""},
                                    {"/temperature", "tactiles[*].temperature_data", ""}};

constexpr KnownType kTypes[] = {
    {"sensor_msgs/JointState", kJointState},
    {"std_msgs/Float32MultiArray", kData},
    {"std_msgs/Float64MultiArray", kData},
    {"std_msgs/Int8MultiArray", kData},
    {"std_msgs/Int16MultiArray", kData},
    {"std_msgs/Int32MultiArray", kData},
    {"std_msgs/Int64MultiArray", kData},
    {"std_msgs/UInt8MultiArray", kData},
    {"std_msgs/UInt16MultiArray", kData},
    {"std_msgs/UInt32MultiArray", kData},
    {"std_msgs/UInt64MultiArray", kData},
    {"std_msgs/Float32", kData},
    {"std_msgs/Float64", kData},
    {"geometry_msgs/Wrench", kWrench},
    {"geometry_msgs/WrenchStamped", kWrenchStamped},
    {"geometry_msgs/TwistStamped", kTwistStamped},
    {"geometry_msgs/PoseStamped", kPoseStamped},
    {"geometry_msgs/Vector3Stamped", kVector3Stamped},
    {"sensor_msgs/Imu", kImu},
    {"sensor_msgs/MagneticField", kMagneticField},
    {"sensor_msgs/FluidPressure", kFluidPressure},
    {"sensor_msgs/Temperature", kTemperature},
    {"sensor_msgs/Range", kRange},
    {"control_msgs/DynamicJointState", kDynamicJointState},
    {"tactile_msgs/TactileState", kTactileState},
    {"xela_server_ros2/SensStream", kSensStream},
    {"papillarray_ros_v2/SensorState", kPapillArrayState},
    {"papillarray_interfaces/TactileState", kPapillArrayTactile},
    {"sr_robot_msgs/BiotacAll", kBiotacAll},
    {"sr_robot_msgs/ShadowPST", kShadowPst},
    {"sr_robot_msgs/UBI0All", kUbi0All},
    {"sr_robot_msgs/MSTAll", kMstAll},
};

}  // namespace

std::span<const KnownType> known_types() {
  return kTypes;
}

const KnownType* known_type(std::string_view name) {
  const std::string plain = ros_type_name(name);
  const auto* found = std::find_if(std::begin(kTypes), std::end(kTypes),
                                   [&](const KnownType& type) { return type.name == plain; });
  return found == std::end(kTypes) ? nullptr : found;
}

}  // namespace somato
