#include <cmath>
#include <cstdint>
#include <memory>
#include <string_view>

#include "recordings/ros/channel_reader.h"
#include "recordings/ros/protobuf_messages.h"
#include "somato/core/check.h"

namespace {

// Bytes of a length that two bytes in front of them state, least significant first.
std::string_view take_bytes(std::string_view& from) {
  if (from.size() < 2) return {};
  const auto low = static_cast<unsigned char>(from[0]);
  const auto high = static_cast<unsigned char>(from[1]);
  const std::string_view taken = from.substr(2, std::size_t{high} << 8 | low);
  from.remove_prefix(2 + taken.size());
  return taken;
}

}  // namespace

// Name, descriptors and message: a message that is read in CDR has a value at each path of one.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string_view rest(reinterpret_cast<const char*>(data), size);
  const std::string_view name = take_bytes(rest);
  const auto compiled = somato::compile_protobuf_schema(name, take_bytes(rest));
  if (!compiled) return 0;
  const auto cdr = somato::cdr_of_protobuf(*compiled, rest);
  if (!cdr) return 0;
  constexpr std::size_t kMostPaths = 10;
  const auto type = std::make_shared<const somato::RosType>(compiled->type);
  for (const std::string& path :
       somato::field_paths(*type, somato::FieldKind::kNumbers, kMostPaths)) {
    const auto reader = somato::ChannelReader::compile(type, {path});
    std::vector<double> values;
    SOMATO_ASSERT(reader && reader->read(*cdr, values));
  }
  return 0;
}
