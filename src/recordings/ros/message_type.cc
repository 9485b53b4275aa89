#include "recordings/ros/message_type.h"

namespace somato {
namespace {

constexpr std::size_t kLengthPrefix = 4;  // The number of bytes or elements.

std::size_t product_or_most(std::size_t a, std::size_t b) {
  return b > kUnbounded / a ? kUnbounded : a * b;
}

}  // namespace

std::size_t size_of(RosPrimitive type) {
  switch (type) {
    case RosPrimitive::kBool:
    case RosPrimitive::kInt8:
    case RosPrimitive::kUint8:
      return 1;
    case RosPrimitive::kInt16:
    case RosPrimitive::kUint16:
      return 2;
    case RosPrimitive::kInt32:
    case RosPrimitive::kUint32:
    case RosPrimitive::kFloat32:
      return 4;
    case RosPrimitive::kInt64:
    case RosPrimitive::kUint64:
    case RosPrimitive::kFloat64:
      return 8;
    case RosPrimitive::kString:
    case RosPrimitive::kWstring:
      break;
  }
  return 0;
}

std::size_t least_bytes_of_element(const RosType& type, const RosField& field) {
  if (field.structure) return type.structures[*field.structure].least_bytes;
  return is_text(field.primitive) ? kLengthPrefix : size_of(field.primitive);
}

std::size_t least_bytes_of(const RosType& type, const RosField& field) {
  if (field.kind == RosField::Kind::kSequence) return kLengthPrefix;
  return product_or_most(least_bytes_of_element(type, field), field.length);
}

}  // namespace somato
