#include "recordings/ros/protobuf_messages.h"

#ifdef SOMATO_WITH_PROTOBUF

#include <fmt/format.h>
#include <google/protobuf/descriptor.h>
#include <google/protobuf/descriptor.pb.h>
#include <google/protobuf/dynamic_message.h>
#include <google/protobuf/message.h>
#include <google/protobuf/stubs/logging.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <span>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "base/text/text.h"
#include "recordings/ros/cdr.h"

namespace somato {

namespace pb = google::protobuf;

// The factory refers to the pool.
struct ProtobufDescriptors {
  pb::DescriptorPool pool;
  pb::DynamicMessageFactory factory;
  const pb::Message* prototype = nullptr;
  std::vector<std::vector<const pb::FieldDescriptor*>> fields;  // By structure of the type.
};

namespace {

constexpr const char* kItemsOfBytes = "items";
constexpr int kMostFiles = 1000;             // The library of protobuf loads imports recursively.
constexpr std::size_t kDeepestMessage = 32;  // As in definitions of ROS.
constexpr std::size_t kMostBytes = std::size_t{256} << 20;  // Above any image or point cloud.

tl::unexpected<Error> bad_descriptors(std::string what) {
  return fail(ErrorKind::kData, std::move(what), "protobuf descriptors");
}

class FirstError : public pb::DescriptorPool::ErrorCollector {
 public:
  void AddError(const std::string& file, const std::string& element,
                const pb::Message* /*descriptor*/, ErrorLocation /*location*/,
                const std::string& message) override {
    if (text.empty()) text = fmt::format("{}, {}: {}", shown(file), shown(element), message);
  }
  std::string text;
};

// Loads the files of a set, each after those that it imports.
class FileLoader {
 public:
  FileLoader(const pb::FileDescriptorSet& set, pb::DescriptorPool& pool) : pool_(&pool) {
    for (const pb::FileDescriptorProto& file : set.file()) files_.try_emplace(file.name(), &file);
  }

  Result<void> run() {
    for (const auto& [name, file] : files_) load(*file);
    if (error_.text.empty()) return {};
    return bad_descriptors(error_.text);
  }

 private:
  // An import that is missing, or leads back to the file, is an error that the pool reports.
  void load(const pb::FileDescriptorProto& file) {
    if (!begun_.insert(file.name()).second) return;
    for (const std::string& imported : file.dependency()) {
      const auto found = files_.find(imported);
      if (found != files_.end()) load(*found->second);
    }
    pool_->BuildFileCollectingErrors(file, &error_);
  }

  pb::DescriptorPool* pool_;
  std::map<std::string, const pb::FileDescriptorProto*> files_;
  std::set<std::string> begun_;
  FirstError error_;
};

Result<void> load_descriptors(std::string_view descriptor_set, pb::DescriptorPool& pool) {
  constexpr std::size_t kMost = std::numeric_limits<int>::max();
  pb::FileDescriptorSet set;
  if (descriptor_set.empty() || descriptor_set.size() > kMost ||
      !set.ParseFromArray(descriptor_set.data(), static_cast<int>(descriptor_set.size()))) {
    return bad_descriptors(
        fmt::format("the {} bytes are no google.protobuf.FileDescriptorSet, or are cut off",
                    descriptor_set.size()));
  }
  if (set.file_size() > kMostFiles) {
    return bad_descriptors(fmt::format("they are of more than {} files", kMostFiles));
  }
  return FileLoader(set, pool).run();
}

RosPrimitive primitive_of(pb::FieldDescriptor::CppType type) {
  switch (type) {
    case pb::FieldDescriptor::CPPTYPE_INT32:
    case pb::FieldDescriptor::CPPTYPE_ENUM:
      return RosPrimitive::kInt32;
    case pb::FieldDescriptor::CPPTYPE_UINT32:
      return RosPrimitive::kUint32;
    case pb::FieldDescriptor::CPPTYPE_INT64:
      return RosPrimitive::kInt64;
    case pb::FieldDescriptor::CPPTYPE_UINT64:
      return RosPrimitive::kUint64;
    case pb::FieldDescriptor::CPPTYPE_FLOAT:
      return RosPrimitive::kFloat32;
    case pb::FieldDescriptor::CPPTYPE_DOUBLE:
      return RosPrimitive::kFloat64;
    case pb::FieldDescriptor::CPPTYPE_BOOL:
      return RosPrimitive::kBool;
    case pb::FieldDescriptor::CPPTYPE_STRING:
    case pb::FieldDescriptor::CPPTYPE_MESSAGE:
      break;
  }
  return RosPrimitive::kString;
}

// A type of numbers in which one can be missing.
RosPrimitive primitive_with_nan(RosPrimitive type) {
  const bool is_other = is_text(type) || type == RosPrimitive::kFloat32;
  return is_other ? type : RosPrimitive::kFloat64;
}

class DescriptorCompiler {
 public:
  explicit DescriptorCompiler(ProtobufDescriptors& descriptors) : descriptors_(&descriptors) {}

  Result<RosType> run(const pb::Descriptor& message) {
    SOMATO_TRY_VOID(compile(message, false));
    return std::move(type_);
  }

 private:
  // The index of a structure; the numbers of a message that can be missing can be missing as well.
  Result<std::size_t> compile(const pb::Descriptor& message, bool can_be_missing) {
    const auto known = compiled_.find({&message, can_be_missing});
    if (known != compiled_.end()) return known->second;
    if (std::find(open_.begin(), open_.end(), &message) != open_.end()) {
      return bad_descriptors(fmt::format("messages of {} contain themselves", message.full_name()));
    }
    if (open_.size() == kDeepestMessage) return too_deep(message.full_name());
    open_.push_back(&message);
    RosStructure structure{message.full_name(), {}, 0};
    std::vector<const pb::FieldDescriptor*> from;
    for (int i = 0; i < message.field_count(); ++i) {
      from.push_back(message.field(i));
      SOMATO_TRY(RosField field, field_of(*from.back(), can_be_missing));
      structure.fields.push_back(std::move(field));
    }
    open_.pop_back();
    SOMATO_TRY(const std::size_t index, added(std::move(structure), std::move(from)));
    return compiled_.emplace(std::pair(&message, can_be_missing), index).first->second;
  }

  Result<RosField> field_of(const pb::FieldDescriptor& from, bool in_missing) {
    const bool is_optional = from.has_presence() && !from.is_required();
    const bool can_be_missing = !from.is_repeated() && (in_missing || is_optional);
    RosField field;
    if (from.cpp_type() == pb::FieldDescriptor::CPPTYPE_MESSAGE) {
      SOMATO_TRY(field.structure, compile(*from.message_type(), can_be_missing));
    } else if (from.type() == pb::FieldDescriptor::TYPE_BYTES) {
      SOMATO_TRY(field, bytes_of(from));
    } else {
      field.primitive = primitive_of(from.cpp_type());
      if (can_be_missing) field.primitive = primitive_with_nan(field.primitive);
    }
    field.name = from.name();
    if (from.is_repeated()) make_sequence(field);
    return field;
  }

  // A sequence of uint8, or a structure with one for the elements of a repeated field.
  Result<RosField> bytes_of(const pb::FieldDescriptor& from) {
    RosField bytes;
    bytes.name = kItemsOfBytes;
    make_sequence(bytes);
    if (!from.is_repeated()) return bytes;
    RosField field;
    SOMATO_TRY(field.structure, added({"", {std::move(bytes)}, 0}, {&from}));
    return field;
  }

  static void make_sequence(RosField& field) {
    field.kind = RosField::Kind::kSequence;
    field.length = kUnbounded;
  }

  Result<std::size_t> added(RosStructure structure, std::vector<const pb::FieldDescriptor*> from) {
    std::size_t levels = 1;
    for (const RosField& field : structure.fields) {
      if (field.structure) levels = std::max(levels, levels_[*field.structure] + 1);
      structure.least_bytes += least_bytes_of(type_, field);
      if (structure.least_bytes > kMostBytes) {
        return bad_descriptors(fmt::format("messages of {} are too large", structure.name));
      }
    }
    if (levels > kDeepestMessage) return too_deep(structure.name);
    structure.least_bytes = std::max<std::size_t>(structure.least_bytes, 1);
    levels_.push_back(levels);
    descriptors_->fields.push_back(std::move(from));
    type_.structures.push_back(std::move(structure));
    return type_.structures.size() - 1;
  }

  static tl::unexpected<Error> too_deep(const std::string& name) {
    return bad_descriptors(
        fmt::format("messages of {} have more than {} levels of others", name, kDeepestMessage));
  }

  ProtobufDescriptors* descriptors_;
  RosType type_;
  std::vector<std::size_t> levels_;  // By structure of the type.
  std::map<std::pair<const pb::Descriptor*, bool>, std::size_t> compiled_;
  std::vector<const pb::Descriptor*> open_;
};

constexpr int kNoElement = -1;  // The value of a field that is not repeated.

// Hands the number of a field, or of an element of it, to `take`.
template <typename Take>
void take_number(const pb::Message& message, const pb::FieldDescriptor& field, int element,
                 const Take& take) {
  const pb::Reflection& from = *message.GetReflection();
  const bool is_one = element == kNoElement;
  switch (field.cpp_type()) {
    case pb::FieldDescriptor::CPPTYPE_INT32:
      return take(is_one ? from.GetInt32(message, &field)
                         : from.GetRepeatedInt32(message, &field, element));
    case pb::FieldDescriptor::CPPTYPE_ENUM:
      return take(is_one ? from.GetEnumValue(message, &field)
                         : from.GetRepeatedEnumValue(message, &field, element));
    case pb::FieldDescriptor::CPPTYPE_UINT32:
      return take(is_one ? from.GetUInt32(message, &field)
                         : from.GetRepeatedUInt32(message, &field, element));
    case pb::FieldDescriptor::CPPTYPE_INT64:
      return take(is_one ? from.GetInt64(message, &field)
                         : from.GetRepeatedInt64(message, &field, element));
    case pb::FieldDescriptor::CPPTYPE_UINT64:
      return take(is_one ? from.GetUInt64(message, &field)
                         : from.GetRepeatedUInt64(message, &field, element));
    case pb::FieldDescriptor::CPPTYPE_FLOAT:
      return take(is_one ? from.GetFloat(message, &field)
                         : from.GetRepeatedFloat(message, &field, element));
    case pb::FieldDescriptor::CPPTYPE_DOUBLE:
      return take(is_one ? from.GetDouble(message, &field)
                         : from.GetRepeatedDouble(message, &field, element));
    case pb::FieldDescriptor::CPPTYPE_BOOL:
      return take(static_cast<std::uint8_t>(
          is_one ? from.GetBool(message, &field) : from.GetRepeatedBool(message, &field, element)));
    case pb::FieldDescriptor::CPPTYPE_STRING:
    case pb::FieldDescriptor::CPPTYPE_MESSAGE:
      break;
  }
}

// The entries of a map in the order of their keys; protobuf gives them none.
std::vector<const pb::Message*> sorted_entries(const pb::Message& message,
                                               const pb::FieldDescriptor& map) {
  using Key = std::variant<std::string, std::int64_t, std::uint64_t>;
  const pb::FieldDescriptor& key = *map.message_type()->map_key();
  const pb::Reflection& from = *message.GetReflection();
  std::vector<std::pair<Key, const pb::Message*>> entries;
  for (int i = 0; i < from.FieldSize(message, &map); ++i) {
    const pb::Message& entry = from.GetRepeatedMessage(message, &map, i);
    Key value;
    if (key.cpp_type() == pb::FieldDescriptor::CPPTYPE_STRING) {
      value = entry.GetReflection()->GetString(entry, &key);
    }
    take_number(entry, key, kNoElement, [&](auto number) {
      using Widest =
          std::conditional_t<std::is_unsigned_v<decltype(number)>, std::uint64_t, std::int64_t>;
      value = static_cast<Widest>(number);
    });
    entries.emplace_back(std::move(value), &entry);
  }
  std::sort(entries.begin(), entries.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<const pb::Message*> sorted;
  sorted.reserve(entries.size());
  for (const auto& [value, entry] : entries) sorted.push_back(entry);
  return sorted;
}

class ProtobufToCdr {
 public:
  explicit ProtobufToCdr(const ProtobufType& type) : type_(&type) {}

  // `message` may be null, for one that is missing.
  void write_structure(std::size_t index, const pb::Message* message) {
    const std::vector<RosField>& fields = type_->type.structures[index].fields;
    if (fields.empty()) writer_.number(std::uint8_t{0});
    for (std::size_t i = 0; i < fields.size() && !is_too_long(); ++i) {
      if (message) {
        write_field(fields[i], *type_->descriptors->fields[index][i], *message);
      } else {
        write_missing(fields[i]);
      }
    }
  }

  bool is_too_long() const { return writer_.bytes().size() > kMostBytes; }
  const std::string& bytes() const { return writer_.bytes(); }

 private:
  void write_field(const RosField& field, const pb::FieldDescriptor& from,
                   const pb::Message& message) {
    if (from.is_repeated()) return write_elements(field, from, message);
    const bool has_value = !from.has_presence() || from.has_default_value() ||
                           message.GetReflection()->HasField(message, &from);
    if (!has_value) return write_missing(field);
    write_value(field, from, message, kNoElement);
  }

  void write_elements(const RosField& field, const pb::FieldDescriptor& from,
                      const pb::Message& message) {
    const int count = message.GetReflection()->FieldSize(message, &from);
    writer_.number(static_cast<std::uint32_t>(count));
    if (from.is_map()) {
      for (const pb::Message* entry : sorted_entries(message, from)) {
        write_structure(*field.structure, entry);
      }
      return;
    }
    for (int i = 0; i < count && !is_too_long(); ++i) write_value(field, from, message, i);
  }

  void write_value(const RosField& field, const pb::FieldDescriptor& from,
                   const pb::Message& message, int element) {
    if (from.cpp_type() == pb::FieldDescriptor::CPPTYPE_MESSAGE) {
      const pb::Reflection& values = *message.GetReflection();
      write_structure(*field.structure, element == kNoElement
                                            ? &values.GetMessage(message, &from)
                                            : &values.GetRepeatedMessage(message, &from, element));
    } else if (from.cpp_type() == pb::FieldDescriptor::CPPTYPE_STRING) {
      write_text(from, message, element);
    } else {
      take_number(message, from, element, [&](auto number) {
        if (field.primitive == RosPrimitive::kFloat64) {
          writer_.number(static_cast<double>(number));
        } else {
          writer_.number(number);
        }
      });
    }
  }

  void write_text(const pb::FieldDescriptor& from, const pb::Message& message, int element) {
    const pb::Reflection& values = *message.GetReflection();
    std::string copy;
    const std::string& text =
        element == kNoElement ? values.GetStringReference(message, &from, &copy)
                              : values.GetRepeatedStringReference(message, &from, element, &copy);
    if (from.type() == pb::FieldDescriptor::TYPE_BYTES) {
      writer_.numbers(std::span<const char>(text));
    } else {
      writer_.text(text);
    }
  }

  void write_missing(const RosField& field) {
    if (field.kind == RosField::Kind::kSequence) {
      writer_.number(std::uint32_t{0});
    } else if (field.structure) {
      write_structure(*field.structure, nullptr);
    } else if (is_text(field.primitive)) {
      writer_.text("");
    } else if (field.primitive == RosPrimitive::kFloat32) {
      writer_.number(std::numeric_limits<float>::quiet_NaN());
    } else {
      writer_.number(std::numeric_limits<double>::quiet_NaN());
    }
  }

  const ProtobufType* type_;
  CdrWriter writer_;
};

// A message with all of its required fields.
Result<void> parse_message(std::string_view bytes, pb::Message& message) {
  constexpr std::size_t kMost = std::numeric_limits<int>::max();
  const std::string name = message.GetDescriptor()->full_name();
  if (bytes.size() > kMost ||
      !message.ParsePartialFromArray(bytes.data(), static_cast<int>(bytes.size()))) {
    return fail(ErrorKind::kData,
                fmt::format("the message of {} bytes is no {} in protobuf, or is cut off",
                            bytes.size(), name));
  }
  if (message.IsInitialized()) return {};
  std::vector<std::string> missing;
  message.FindInitializationErrors(&missing);
  return fail(ErrorKind::kData, fmt::format("the message lacks {}, which a {} requires",
                                            shown(missing.front()), name));
}

}  // namespace

Result<ProtobufType> compile_protobuf_schema(std::string_view name,
                                             std::string_view descriptor_set) {
  const pb::LogSilencer silence;
  const auto descriptors = std::make_shared<ProtobufDescriptors>();
  SOMATO_TRY_VOID(load_descriptors(descriptor_set, descriptors->pool));
  const pb::Descriptor* message = descriptors->pool.FindMessageTypeByName(std::string(name));
  if (!message) return bad_descriptors(fmt::format("they have no message {}", shown(name)));
  ProtobufType type;
  SOMATO_TRY(type.type, DescriptorCompiler(*descriptors).run(*message));
  descriptors->prototype = descriptors->factory.GetPrototype(message);
  type.descriptors = descriptors;
  return type;
}

Result<std::string> cdr_of_protobuf(const ProtobufType& type, std::string_view message) {
  const pb::LogSilencer silence;
  const std::unique_ptr<pb::Message> decoded(type.descriptors->prototype->New());
  SOMATO_TRY_VOID(parse_message(message, *decoded));
  ProtobufToCdr writer(type);
  writer.write_structure(type.type.structures.size() - 1, decoded.get());
  if (!writer.is_too_long()) return writer.bytes();
  return fail(ErrorKind::kData, fmt::format("the message of {} bytes has more than {} MiB in CDR",
                                            message.size(), kMostBytes >> 20));
}

}  // namespace somato

#else

namespace somato {
namespace {

tl::unexpected<Error> without_protobuf() {
  return fail(ErrorKind::kData, "its messages are in protobuf, which this build does not read", {},
              "install libprotobuf-dev and build Somato again, with SOMATO_BUILD_PROTOBUF=ON");
}

}  // namespace

struct ProtobufDescriptors {};

Result<ProtobufType> compile_protobuf_schema(std::string_view /*name*/,
                                             std::string_view /*descriptor_set*/) {
  return without_protobuf();
}

Result<std::string> cdr_of_protobuf(const ProtobufType& /*type*/, std::string_view /*message*/) {
  return without_protobuf();
}

}  // namespace somato

#endif
