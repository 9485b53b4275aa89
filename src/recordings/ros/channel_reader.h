#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "recordings/explorations/element_order.h"
#include "recordings/ros/field_reader.h"
#include "recordings/ros/message_names.h"
#include "recordings/ros/message_type.h"
#include "somato/core/result.h"

namespace somato {

/// Reads the frames of a channel from the messages of a topic: the numbers at one or more paths.
class ChannelReader {
 public:
  /// `names` are the paths of texts with the names of the elements, with `+` between; empty: those
  /// of usual_names(), if there are any. Errors: as FieldReader::compile(); kUsage for no path, and
  /// for elements selected by name if only some paths do so, or messages have no names.
  static Result<ChannelReader> compile(const std::shared_ptr<const RosType>& type,
                                       const std::vector<std::string>& paths,
                                       const std::string& names = {});

  /// The order of the elements of a channel, before the first message.
  ElementOrder order() const;

  /// Replaces `values` by those in `message`, path after path, in the order of the message. Of a
  /// std_msgs array, those before its data_offset are left out. Errors: as FieldReader::read().
  Result<void> read(std::string_view message, std::vector<double>& values) const;

  /// The same in the order of the elements. Returns whether `message` has all elements that are
  /// selected by name; otherwise `values` is empty. Errors: as FieldReader::read() and
  /// ElementOrder::learn().
  Result<bool> read(std::string_view message, ElementOrder& order,
                    std::vector<double>& values) const;

  /// The names of the elements in the order of the message: as MessageNames; if there are none, the
  /// places of the values, such as "sensors[0].taxels[3].z", or nothing for a std_msgs array.
  /// Errors: as FieldReader::read().
  Result<std::vector<std::string>> element_names(std::string_view message) const;

  /// The shape in the layout of a std_msgs array, or the numbers of rows and columns beside a list
  /// of values (fields `rows` and `cols` or `columns`, or `height` and `width`), if it has two or
  /// more axes that the values fill; otherwise empty. Errors: as FieldReader::read().
  Result<std::vector<std::size_t>> shape(std::string_view message) const;

 private:
  Result<void> take_names(const std::shared_ptr<const RosType>& type, const std::string& names);
  Result<void> check_selection() const;
  Result<void> read(std::string_view message, std::vector<double>& values, std::string& key) const;
  Result<void> leave_out_before_offset(std::string_view message, std::vector<double>& values) const;
  Result<void> learn(std::string_view message, const std::string& key, ElementOrder& order) const;

  std::vector<FieldReader> values_;
  std::optional<MessageNames> names_;
  std::vector<FieldReader> lengths_;   // of the axes
  std::optional<FieldReader> offset_;  // of a std_msgs array
};

}  // namespace somato
