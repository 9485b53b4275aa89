#include <cmath>
#include <cstdint>
#include <memory>
#include <string_view>
#include <utility>

#include "recordings/ros/definition.h"
#include "recordings/ros/field_reader.h"
#include "somato/core/check.h"

namespace {

// A text up to a zero, which is cut off.
std::string_view take_text(std::string_view& bytes) {
  const std::string_view text = bytes.substr(0, bytes.find('\0'));
  bytes.remove_prefix(text.size() < bytes.size() ? text.size() + 1 : text.size());
  return text;
}

class Counter : public somato::FieldSink {
 public:
  void take(const somato::RosScalar& scalar, somato::FieldPlace /*place*/) override {
    ++values;
    const bool is_missing = std::isnan(scalar.number());  // Perhaps one that the path pads.
    if (!is_missing) ++numbers;
    if (!is_missing) bytes += somato::is_text(scalar.type) ? scalar.text.size() : 1;
  }
  std::size_t values = 0;
  std::size_t numbers = 0;
  std::size_t bytes = 0;
};

}  // namespace

// Definition, path and message: no more values than bytes, but for those that are missing, and as
// many as names.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string_view rest(reinterpret_cast<const char*>(data), size);
  auto compiled = somato::compile_ros_definition("a/Top", "ros2msg", take_text(rest));
  if (!compiled) return 0;
  const auto type = std::make_shared<const somato::RosType>(std::move(*compiled));
  const std::string_view path = take_text(rest);
  for (const auto kind : {somato::FieldKind::kNumbers, somato::FieldKind::kTexts}) {
    const auto reader = somato::FieldReader::compile(type, path, kind);
    if (!reader) continue;
    Counter counter;
    const bool is_read = reader->read(rest, counter).has_value();
    SOMATO_ASSERT(counter.numbers <= rest.size() && counter.bytes <= rest.size());
    const auto names = reader->names(rest);
    SOMATO_ASSERT(names.has_value() == is_read);
    SOMATO_ASSERT(!names || names->size() == counter.values);
  }
  return 0;
}
