#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "recordings/ros/field_reader.h"
#include "recordings/ros/message_type.h"
#include "somato/core/result.h"

namespace somato {

/// Names the values at a path of a message by texts that the message holds.
///
/// A value has the text whose elements begin its own: `name[2]` names `position[2]`, and
/// `sensors[1].name` names `sensors[1].values[0]` and the further ones, as `thumb[0]` and so on.
/// Texts of several paths are joined by a slash, as interfaces of ros2_control are:
/// `elbow/position`.
class MessageNames {
 public:
  /// `names` are paths of texts with `+` between. Errors: as FieldReader::compile().
  static Result<MessageNames> compile(const std::shared_ptr<const RosType>& type,
                                      const std::string& names);

  /// The names of the values of each of `paths`, one path after the other; empty unless there is a
  /// text for every value and, where a path selects all elements, a value for every text. Elements
  /// without a text at a path with padding have their places as names: `position[3]`. With several
  /// paths, a name contains its path: `position[elbow]`. Errors: as FieldReader::read().
  Result<std::vector<std::string>> of(const std::vector<FieldReader>& paths,
                                      std::string_view message) const;

  /// Appends the texts and their places to a key, so that messages with equal keys have the same
  /// texts at the same places. Errors: as FieldReader::read().
  Result<void> add_to_key(std::string_view message, std::string& key) const;

 private:
  std::vector<FieldReader> texts_;
};

/// The paths of the names of the values at `path`, by the known types and by convention: texts in a
/// field `name`, `names` or `joint_names` beside the field with the values or around it. Empty if
/// there are none.
std::string usual_names(const RosType& type, const FieldReader& path);

/// The name of an element of a channel with several paths, such as "position[elbow]".
std::string element_of_path(const FieldReader& path, std::string_view name);

/// Appends a place to a key.
void add_to_key(FieldPlace place, std::string& key);

}  // namespace somato
