// What examples/ros2_node uses of rclcpp, declared as in ROS 2 Humble to Jazzy and without effect:
// it shows that the example compiles where ROS 2 is not installed.
#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>

constexpr int RCL_ROS_TIME = 1;
#define RCLCPP_ERROR(logger, ...) ((void)(logger), (void)std::fprintf(stderr, __VA_ARGS__))

namespace rclcpp {

class Duration {
 public:
  Duration(std::int32_t seconds, std::uint32_t nanoseconds)
      : all_(seconds * 1000000000LL + nanoseconds) {}
  static Duration from_seconds(double seconds) { return {static_cast<std::int32_t>(seconds), 0}; }
  bool operator>(const Duration& other) const { return all_ > other.all_; }

 private:
  std::int64_t all_;
};

class Time {
 public:
  Time(std::int32_t /*seconds*/, std::uint32_t /*nanoseconds*/, int /*clock*/) {}
  Duration operator-(const Time& /*other*/) const { return {0, 0}; }
};

struct SensorDataQoS {};
struct Logger {};

template <typename Message>
struct Publisher {
  using SharedPtr = std::shared_ptr<Publisher>;
  void publish(const Message& /*message*/) {}
};

template <typename Message>
struct Subscription {
  using SharedPtr = std::shared_ptr<Subscription>;
};

class Node {
 public:
  explicit Node(const std::string& /*name*/) {}
  virtual ~Node() = default;

  template <typename Value>
  Value declare_parameter(const std::string& /*name*/, const Value& value) {
    return value;
  }

  template <typename Message>
  std::shared_ptr<Publisher<Message>> create_publisher(const std::string& /*topic*/,
                                                       int /*depth*/) {
    return std::make_shared<Publisher<Message>>();
  }

  template <typename Message, typename Callback>
  std::shared_ptr<Subscription<Message>> create_subscription(const std::string& /*topic*/,
                                                             const SensorDataQoS& /*quality*/,
                                                             Callback callback) {
    callback(Message{});
    return std::make_shared<Subscription<Message>>();
  }

  Time now() const { return {0, 0, RCL_ROS_TIME}; }
  Logger get_logger() const { return {}; }
};

inline void init(int /*count*/, char** /*arguments*/) {}
inline void spin(const std::shared_ptr<Node>& /*node*/) {}
inline void shutdown() {}

}  // namespace rclcpp
