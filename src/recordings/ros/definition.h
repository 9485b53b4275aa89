#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

#include "recordings/ros/message_type.h"
#include "somato/core/result.h"

namespace somato {

/// "std_msgs/Header" for "std_msgs/msg/Header"; other names are unchanged.
std::string ros_type_name(std::string_view name);

/// Definitions of message types in the language of .msg files, by name.
class RosDefinitions {
 public:
  /// Adds the definition of a type; the first one of a name is used. `line` is that of its first
  /// line in `where`.
  void add(std::string_view name, std::string_view text, std::string where, std::size_t line = 1);

  /// Adds a definition in the encoding ros2msg: the type `name`, followed by those that it
  /// contains, each after a line of equal signs and a line `MSG: package/Name`.
  void add_all(std::string_view name, std::string_view text);

  bool has(std::string_view name) const { return texts_.contains(ros_type_name(name)); }

  /// The type with all types that it contains. builtin_interfaces/Time and Duration, in old
  /// definitions `time` and `duration`, need no definition. Constants and default values are
  /// passed over. Errors (kData, with the place): a missing definition, a line that is no field, an
  /// array without elements, two fields of the same name, a type that contains itself or more than
  /// 32 levels of others.
  Result<RosType> compile(std::string_view name) const;

  /// The definition of the type and of those that it contains, as for add_all(). Errors: as
  /// compile().
  Result<std::string> all_of(std::string_view name) const;

  /// A definition and its place.
  struct Text {
    std::string text;
    std::string where;
    std::size_t line = 1;
  };

 private:
  std::map<std::string, Text> texts_;
};

/// The type `name` with a definition of that encoding. Errors (kData): those of
/// RosDefinitions::compile(); another encoding than ros2msg.
Result<RosType> compile_ros_definition(std::string_view name, std::string_view encoding,
                                       std::string_view definition);

}  // namespace somato
