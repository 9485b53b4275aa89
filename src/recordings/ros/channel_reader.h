#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "recordings/ros/field_reader.h"
#include "recordings/ros/message_type.h"
#include "somato/core/result.h"

namespace somato {

/// Reads the frames of a channel from the messages of a topic: the numbers at one or more paths.
class ChannelReader {
 public:
  /// `names` is the path of texts with the names of the elements, or empty. Errors: as
  /// FieldReader::compile(); kUsage for no path.
  static Result<ChannelReader> compile(const std::shared_ptr<const RosType>& type,
                                       const std::vector<std::string>& paths,
                                       const std::string& names = {});

  /// Replaces `values` by those in `message`, path after path. Of a std_msgs array, those before
  /// its data_offset are left out. Errors: as FieldReader::read().
  Result<void> read(std::string_view message, std::vector<double>& values) const;

  /// The names of the elements: the texts of that path, if there are as many; otherwise the places
  /// of the values, such as "sensors[0].taxels[3].z", or nothing for a std_msgs array. Errors: as
  /// FieldReader::read().
  Result<std::vector<std::string>> element_names(std::string_view message) const;

  /// The shape in the layout of a std_msgs array, if it has two or more axes that the values fill;
  /// otherwise empty. Errors: as FieldReader::read().
  Result<std::vector<std::size_t>> shape(std::string_view message) const;

 private:
  std::vector<FieldReader> values_;
  std::optional<FieldReader> names_;
  std::optional<FieldReader> lengths_;  // With offset_, for a std_msgs array.
  std::optional<FieldReader> offset_;
};

}  // namespace somato
