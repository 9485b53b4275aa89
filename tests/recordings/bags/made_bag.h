#pragma once

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include "recordings/mcap/mcap_writer.h"
#include "recordings/ros/cdr.h"

namespace somato {

/// A bag in MCAP as ROS 2 writes it, for tests: topics of one type each, messages at times in
/// milliseconds.
class MadeBag {
 public:
  explicit MadeBag(const std::string& path)
      : out_(path, std::ios::binary),
        file_(
            [this](std::string_view bytes) {
              out_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
              return Result<void>();
            },
            Compression::kNone, std::size_t{1} << 20) {
    (void)file_.begin({"ros2", "test"});
  }

  std::uint16_t topic(const std::string& name, const std::string& type,
                      const std::string& definition) {
    return topic(name, {0, type, "ros2msg", definition}, "cdr");
  }

  std::uint16_t topic(const std::string& name, const McapSchema& schema,
                      const std::string& message_encoding) {
    return file_.channel(&schema, {0, 0, name, message_encoding, {}}).value();
  }

  MadeBag& add(std::uint16_t topic, std::int64_t milliseconds, const std::string& message) {
    const auto time = static_cast<std::uint64_t>(milliseconds * 1'000'000);
    (void)file_.add({topic, 0, time, time, message});
    return *this;
  }

  void finish() {
    (void)file_.finish();
    out_.close();
  }

 private:
  std::ofstream out_;
  McapWriter file_;
};

inline std::string text_message(const std::string& text) {
  return CdrWriter().text(text).bytes();
}

/// A message of `float64[] x`.
inline std::string numbers_message(const std::vector<double>& values) {
  return CdrWriter().numbers(std::span<const double>(values)).bytes();
}

/// A message of `std_msgs/Header header` and `float64[] x`.
inline std::string stamped_message(std::int32_t second, const std::vector<double>& values) {
  CdrWriter writer;
  writer.number(second).number(std::uint32_t{0}).text("");
  return writer.numbers(std::span<const double>(values)).bytes();
}

}  // namespace somato
