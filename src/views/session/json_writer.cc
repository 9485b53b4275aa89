#include "views/session/json_writer.h"

#include "views/session/view_json.h"

namespace somato::live {

JsonWriter& JsonWriter::key(const std::string& name) {
  separate();
  return add("{}:", json_text(Json(name)));
}

JsonWriter& JsonWriter::numbers(std::span<const float> values) {
  open('[');
  for (const float value : values) {
    separate();
    if (value == 0.0F) {
      text_.push_back('0');
    } else {
      finite("{:.5g}", value);
    }
  }
  return close(']');
}

JsonWriter& JsonWriter::exact_numbers(std::span<const float> values) {
  open('[');
  for (const float value : values) separate().finite("{}", value);
  return close(']');
}

}  // namespace somato::live
