#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <vector>

#include "recordings/bags/bag_files.h"
#include "recordings/ros/field_reader.h"
#include "recordings/ros/topic_type.h"

namespace {

// Values as their type's letter and bytes with the bits, texts in hexadecimal.
class Printed : public somato::FieldSink {
 public:
  void take(const somato::RosScalar& scalar, somato::FieldPlace /*place*/) override {
    if (somato::is_text(scalar.type)) {
      text += " s";
      for (const char c : scalar.text) text += fmt::format("{:02x}", static_cast<unsigned char>(c));
    } else {
      text += fmt::format(" {}:{:x}", somato::size_of(scalar.type), scalar.bits);
    }
  }
  std::string text;
};

somato::Result<void> print_message(const somato::BagTopic& topic,
                                   const somato::BagMessage& message) {
  constexpr std::size_t kMostPaths = 1000;
  SOMATO_TRY(const auto messages, somato::compile_topic_messages(topic.encoding));
  for (const auto kind : {somato::FieldKind::kNumbers, somato::FieldKind::kTexts}) {
    for (const std::string& path : somato::field_paths(*messages.type, kind, kMostPaths)) {
      SOMATO_TRY(const auto reader, somato::FieldReader::compile(messages.type, path, kind));
      Printed printed;
      SOMATO_TRY_VOID(reader.read(message.data, printed));
      fmt::print("{} {} {}{}\n", topic.name, message.time, path, printed.text);
    }
  }
  return {};
}

somato::Result<void> print_bag(const char* path) {
  SOMATO_TRY(const auto bags, somato::find_bags(path));
  SOMATO_TRY(const auto bag, somato::open_bag(bags.front()));
  for (;;) {
    SOMATO_TRY(const auto message, bag->next());
    if (!message) return {};
    SOMATO_TRY_VOID(print_message(bag->topics()[message->topic], *message));
  }
}

}  // namespace

// Prints every field of every message of a bag: topic, time, path and values.
int main(int count, char** arguments) {
  if (count != 2) return 2;
  const somato::Result<void> done = print_bag(arguments[1]);
  if (!done) fmt::print(stderr, "{}\n", somato::to_string(done.error()));
  return done ? 0 : 1;
}
