#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace somato {

/// The primitive types of ROS 2 messages; `byte` and `char` are kUint8.
enum class RosPrimitive {
  kBool,
  kInt8,
  kUint8,
  kInt16,
  kUint16,
  kInt32,
  kUint32,
  kInt64,
  kUint64,
  kFloat32,
  kFloat64,
  kString,
  kWstring,
};

/// The bytes of a number of that type in CDR; 0 for texts.
std::size_t size_of(RosPrimitive type);

inline bool is_text(RosPrimitive type) {
  return type == RosPrimitive::kString || type == RosPrimitive::kWstring;
}

inline constexpr std::size_t kUnbounded = std::numeric_limits<std::size_t>::max();

/// A field of a structure: one value, an array of fixed length or a sequence of any length.
struct RosField {
  enum class Kind { kOne, kArray, kSequence };

  std::string name;
  RosPrimitive primitive = RosPrimitive::kUint8;
  std::optional<std::size_t> structure;  ///< Index in RosType::structures; nothing: a primitive.
  Kind kind = Kind::kOne;
  std::size_t length =
      1;  ///< The length of an array, or the greatest of a sequence, or kUnbounded.
};

struct RosStructure {
  std::string name;  ///< Such as "std_msgs/Header".
  std::vector<RosField> fields;
  std::size_t least_bytes = 0;  ///< The least size of a value, without padding; at least 1.
};

/// A message type with all types that it contains.
struct RosType {
  std::vector<RosStructure> structures;  ///< Each after those that it contains; the last: the type.

  const RosStructure& root() const { return structures.back(); }
};

/// The least number of bytes of one element of `field` in CDR, without padding; at least 1.
std::size_t least_bytes_of_element(const RosType& type, const RosField& field);

/// The same for the complete field.
std::size_t least_bytes_of(const RosType& type, const RosField& field);

}  // namespace somato
