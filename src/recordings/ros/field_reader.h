#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "recordings/ros/message_type.h"
#include "recordings/ros/path_elements.h"
#include "somato/core/result.h"

namespace somato {

/// The value of a primitive field. `text` refers to the message.
struct RosScalar {
  RosPrimitive type = RosPrimitive::kUint8;
  std::uint64_t bits = 0;  ///< The number as in the message; 0 for a text.
  std::string_view text;

  /// The number; exact, except for integers above 2^53. 0 for a text.
  double number() const;
};

/// A value in words: a number as short as it reads back, or the text.
std::string to_string(const RosScalar& scalar);

/// A field on the way from a message to a value, and the element of it; 0 unless it has several.
struct FieldStep {
  const RosField* field = nullptr;
  std::size_t element = 0;
};

/// The place of a value in a message: a field for each level, from the message inwards.
using FieldPlace = std::span<const FieldStep>;

/// A place in words, such as "sensors[0].taxels[3].z".
std::string to_string(FieldPlace place);

/// Takes the values that a FieldReader reads, in order.
class FieldSink {
 public:
  FieldSink() = default;
  FieldSink(const FieldSink&) = delete;
  FieldSink(FieldSink&&) = delete;
  FieldSink& operator=(const FieldSink&) = delete;
  FieldSink& operator=(FieldSink&&) = delete;
  virtual ~FieldSink() = default;

  /// `place` is valid during the call.
  virtual void take(const RosScalar& scalar, FieldPlace place) = 0;
};

/// Which values a path selects if it ends at a structure.
enum class FieldKind { kNumbers, kTexts };

/// Reads the values at a path from messages of a type: the core of every import of ROS messages,
/// from bags and live.
///
/// A path names fields with dots between: `wrench.force.x`. After the name of an array or sequence,
/// `[2]` selects an element, `[2..5]` several, and `[*]` or nothing all: `sensors[*].taxels[*].z`.
/// `[*:32]` selects 32 elements of a sequence of any length: further ones are cut off, and those
/// that a message lacks are missing numbers (NaN). In the last brackets of a path, names select the
/// elements that a message gives these names: `position[shoulder,elbow]`; the reader reads all
/// elements, and selected() states the names. A path that ends at a structure selects all numbers
/// (or texts) in it, in order: `wrench.force`.
///
/// Reading takes time proportional to the length of the message and no memory, apart from that of
/// the sink.
class FieldReader {
 public:
  /// Errors (kUsage, with the path): a path that is not one, a field that does not exist (with the
  /// nearest one that does), an index for a field without elements or beyond an array, a path to no
  /// values of that kind, a number of elements of which some have no fixed length.
  static Result<FieldReader> compile(std::shared_ptr<const RosType> type, std::string_view path,
                                     FieldKind kind = FieldKind::kNumbers);

  /// Hands the values in `message` to `sink`. Errors (kData): a message that is not in CDR of
  /// version 1, or ends within a field (with field and byte), a sequence that is longer than its
  /// type permits or shorter than the path demands, a non-empty wstring in front of the values: its
  /// encoding depends on the middleware. Values may have been handed over before.
  Result<void> read(std::string_view message, FieldSink& sink) const;

  /// The places of these values, such as "sensors[0].taxels[3].z". Errors as read().
  Result<std::vector<std::string>> names(std::string_view message) const;

  const std::string& path() const { return path_; }

  /// The path without its last brackets.
  std::string path_to_elements() const { return path_.substr(0, last_bracket_); }

  /// The number of fields in the path.
  std::size_t depth() const { return steps_.size(); }

  /// The names in the last brackets of the path, or none.
  const std::vector<std::string>& selected() const { return steps_.back().elements.names; }

  /// Whether the path selects all elements of all fields.
  bool has_all_elements() const;

  /// Whether the path selects a number of elements that messages may lack.
  bool is_padded() const;

  /// Whether messages with the same number of values can have them at different places.
  bool has_varying_places() const;

 private:
  struct Step {
    std::size_t field = 0;  // In its structure.
    PathElements elements;
  };
  class Walk;

  FieldReader(std::shared_ptr<const RosType> type, std::string path, FieldKind kind)
      : type_(std::move(type)), path_(std::move(path)), kind_(kind) {}

  Result<Step> parse_step(const RosStructure& structure, std::string_view& rest);
  Result<void> parse_brackets(std::string_view part, std::size_t bracket, bool is_last, Step& step);
  Result<void> check_target(const RosField& target) const;
  Result<void> check_padding() const;
  const RosField& field_at(std::size_t depth) const;
  bool has_fixed_length(std::size_t depth) const;

  std::shared_ptr<const RosType> type_;
  std::string path_;
  FieldKind kind_;
  std::vector<Step> steps_;
  std::size_t last_bracket_ = std::string::npos;
};

/// The paths of the primitive fields of that kind, up to `most`, such as "sensors[*].taxels[*].z".
std::vector<std::string> field_paths(const RosType& type, FieldKind kind, std::size_t most);

}  // namespace somato
