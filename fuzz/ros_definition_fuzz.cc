#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "recordings/ros/definition.h"
#include "recordings/ros/field_reader.h"
#include "somato/core/check.h"

// A type has no more fields than its definition has bytes; each listed path can be read.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kMostPaths = 50;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  auto compiled = somato::compile_ros_definition("a/Top", "ros2msg", text);
  if (!compiled) {
    SOMATO_ASSERT(!compiled.error().where.empty());
    return 0;
  }
  const auto type = std::make_shared<const somato::RosType>(std::move(*compiled));
  std::size_t fields = 0;
  for (const auto& structure : type->structures) fields += structure.fields.size();
  SOMATO_ASSERT(fields <= size + 4);  // A time and a duration need no text.
  for (const auto kind : {somato::FieldKind::kNumbers, somato::FieldKind::kTexts}) {
    for (const std::string& path : somato::field_paths(*type, kind, kMostPaths)) {
      SOMATO_ASSERT(somato::FieldReader::compile(type, path, kind));
    }
  }
  return 0;
}
