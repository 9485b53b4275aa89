#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "recordings/ros/message_type.h"
#include "somato/core/result.h"

// Messages in protobuf, which MCAP files and the protocol of Foxglove permit, are read as those of
// ROS: their descriptors are compiled to a type, and each message is written in CDR of that type.

namespace somato {

/// The descriptors of a message type, as the library of protobuf holds them.
struct ProtobufDescriptors;

/// A type of messages in protobuf.
struct ProtobufType {
  RosType type;
  std::shared_ptr<const ProtobufDescriptors> descriptors;
};

/// The message type of that full name, such as "foxglove.PoseInFrame", in a serialized
/// google.protobuf.FileDescriptorSet. Messages and groups are structures; repeated fields are
/// sequences; maps are sequences of structures of `key` and `value`, sorted by their keys; bytes
/// are sequences of uint8 (repeated ones have a field `items` between); enumerations are int32.
///
/// A number that can be missing is float64 or float32, so that it can be NaN: one of an optional
/// field (in proto2 all that are not required), of a oneof, and any number of a message that can be
/// missing. Integers beyond 2^53 are rounded there.
///
/// Errors (kData): bytes that are no such set, or lack a file; a name that is not in it; a type
/// that contains itself or more than 32 levels of others; in a build without the library
/// (SOMATO_BUILD_PROTOBUF), always.
Result<ProtobufType> compile_protobuf_schema(std::string_view name,
                                             std::string_view descriptor_set);

/// The message in CDR of the type. A number that is missing is its declared default value, or else
/// NaN; other missing values are empty. A number of proto3 that cannot be missing and is not in the
/// message is 0, because the encoding leaves out zeros. Errors (kData): bytes that are no message
/// of that type or lack required fields; more than 256 MiB in CDR.
Result<std::string> cdr_of_protobuf(const ProtobufType& type, std::string_view message);

}  // namespace somato
