// A node of ROS 2 that names what a robot touches: it subscribes to a topic of numbers, which are
// the elements of the system's channels one after the other, and publishes the name after each
// frame.
//
// usage: touch_node --ros-args -p model:=out/system.somato -p pause:=0.5
#include <somato/c/c_system.h>

#include <memory>
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/float32_multi_array.hpp>
#include <std_msgs/msg/string.hpp>
#include <stdexcept>
#include <string>
#include <vector>

using std_msgs::msg::Float32MultiArray;
using std_msgs::msg::String;

class TouchNode : public rclcpp::Node {
 public:
  TouchNode()
      : Node("touch"), system_(load(declare_parameter("model", std::string())), somato_free) {
    // A frame that comes later than this after the last one begins an exploration.
    pause_ = rclcpp::Duration::from_seconds(declare_parameter("pause", 0.5));
    names_ = create_publisher<String>("touch/name", 10);
    frames_ = create_subscription<Float32MultiArray>(
        "touch/frame", rclcpp::SensorDataQoS(),
        [this](const Float32MultiArray& message) { receive(message.data); });
  }

 private:
  static somato_system* load(const std::string& path) {
    std::vector<char> message(500);
    somato_system* system = somato_load(path.c_str(), message.data(), message.size());
    if (system == nullptr) throw std::runtime_error(message.data());
    return system;
  }

  void receive(const std::vector<float>& numbers) {
    const rclcpp::Time now = this->now();
    if (now - last_ > pause_) somato_start(system_.get(), 0.0);
    last_ = now;
    frame_.clear();
    std::size_t count = 0;
    for (std::size_t i = 0; i < somato_channels(system_.get()); ++i) {
      frame_.push_back(numbers.data() + count);
      count += somato_channel_elements(system_.get(), i);
    }
    somato_answer answer;
    if (numbers.size() != count) {
      RCLCPP_ERROR(get_logger(), "a frame has %zu numbers instead of %zu", numbers.size(), count);
    } else if (somato_step(system_.get(), frame_.data()) != SOMATO_OK ||
               somato_read(system_.get(), &answer) != SOMATO_OK) {
      RCLCPP_ERROR(get_logger(), "%s", somato_message(system_.get()));
    } else {
      String name;
      name.data = answer.is_unknown ? "unknown" : somato_class_name(system_.get(), answer.nearest);
      names_->publish(name);
    }
  }

  std::unique_ptr<somato_system, decltype(&somato_free)> system_;
  std::vector<const float*> frame_;
  rclcpp::Time last_{0, 0, RCL_ROS_TIME};
  rclcpp::Duration pause_{0, 0};
  rclcpp::Publisher<String>::SharedPtr names_;
  rclcpp::Subscription<Float32MultiArray>::SharedPtr frames_;
};

int main(int count, char** arguments) {
  rclcpp::init(count, arguments);
  rclcpp::spin(std::make_shared<TouchNode>());
  rclcpp::shutdown();
  return 0;
}
