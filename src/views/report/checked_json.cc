#include "views/report/checked_json.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "base/text/json_text.h"

namespace somato::detail {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kLongestPath = 200;

const Json& nothing() {
  static const Json null;
  return null;
}

// The length of a path is not limited by the format.
std::string shortened(const std::string& path) {
  const std::string from = path.starts_with(".") ? path.substr(1) : path;
  return from.size() <= kLongestPath ? from : from.substr(0, kLongestPath) + "...";
}

}  // namespace

Result<Json> parse_results_json(std::string_view text, const std::string& where) {
  return parse_json<Json>(text, where,
                          "use a results.json written by 'somato run' or 'somato reproduce'");
}

void CheckedJson::refuse(const std::string& what) const {
  if (trouble_) return;
  const std::string place = path_.empty() ? "the whole" : "'" + shortened(path_) + "'";
  trouble_ = Error{ErrorKind::kData, place + " " + what, {}, {}};
}

bool CheckedJson::expect(bool is, const char* what) const {
  if (!is) refuse(fmt::format("is {}, but must be {}", value_.type_name(), what));
  return is;
}

CheckedJson CheckedJson::at(const std::string& key) const {
  if (!expect(value_.is_object(), "an object")) return {nothing(), path_, trouble_};
  const auto found = value_.find(key);
  if (found == value_.end()) {
    CheckedJson(nothing(), path_ + "." + key, trouble_).refuse("is missing");
    return {nothing(), path_, trouble_};
  }
  return {*found, path_ + "." + key, trouble_};
}

std::string CheckedJson::text() const {
  return expect(value_.is_string(), "a text") ? value_.get<std::string>() : std::string();
}

bool CheckedJson::truth() const {
  return expect(value_.is_boolean(), "true or false") && value_.get<bool>();
}

double CheckedJson::number() const {
  if (!expect(value_.is_number(), "a number")) return 0.0;
  const auto number = value_.get<double>();
  if (!std::isfinite(number)) refuse("is not finite");
  return number;
}

double CheckedJson::number_or_nan() const {
  return value_.is_null() ? std::numeric_limits<double>::quiet_NaN() : number();
}

std::optional<double> CheckedJson::number_or_nothing() const {
  if (value_.is_null()) return {};
  return number();
}

std::uint64_t CheckedJson::whole(std::uint64_t most) const {
  if (!expect(value_.is_number_unsigned(), "a whole number of at least 0")) return 0;
  const auto number = value_.get<std::uint64_t>();
  if (number <= most) return number;
  refuse(fmt::format("is {}, but must be at most {}", number, most));
  return 0;
}

}  // namespace somato::detail
