#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "somato/core/result.h"

namespace somato::detail {

/// The JSON of a results.json. Errors: those of parse_json().
Result<nlohmann::ordered_json> parse_results_json(std::string_view text, const std::string& where);

/// A checked access to a value of such a text. The first value of a wrong type is recorded with its
/// path, and reading continues with zeros and empty texts: call ok() before using values.
class CheckedJson {
 public:
  /// Reads the whole text, which must outlive it and all its parts, as must `trouble`.
  CheckedJson(const nlohmann::ordered_json& whole, std::optional<Error>& trouble)
      : CheckedJson(whole, {}, trouble) {}

  bool ok() const { return !trouble_.has_value(); }
  bool is_object() const { return value_.is_object(); }
  bool is_null() const { return value_.is_null(); }
  bool is_number() const { return value_.is_number(); }
  bool is_truth() const { return value_.is_boolean(); }
  bool has(const std::string& key) const { return value_.is_object() && value_.contains(key); }

  /// The part of that name, which must be there.
  CheckedJson at(const std::string& key) const;

  std::string text() const;
  bool truth() const;
  /// A number that is finite.
  double number() const;
  /// The same, with null for NaN.
  double number_or_nan() const;
  std::optional<double> number_or_nothing() const;
  /// A whole number from 0 to `most`.
  std::uint64_t whole(std::uint64_t most) const;

  std::size_t size() const { return value_.size(); }

  /// Calls `use` with each part of a list, or with the name and part of each entry of an object.
  template <typename Use>
  void each(const Use& use) const {
    if (!expect(value_.is_array(), "a list")) return;
    for (std::size_t i = 0; ok() && i < value_.size(); ++i) {
      use(CheckedJson(value_[i], path_ + "[" + std::to_string(i) + "]", trouble_));
    }
  }
  template <typename Use>
  void entries(const Use& use) const {
    if (!expect(value_.is_object(), "an object")) return;
    for (const auto& [name, part] : value_.items()) {
      if (ok()) use(name, CheckedJson(part, path_ + "." + name, trouble_));
    }
  }

  /// Keeps it as the trouble there is, unless there is one.
  void refuse(const std::string& what) const;

 private:
  CheckedJson(const nlohmann::ordered_json& value, std::string path, std::optional<Error>& trouble)
      : value_(value), path_(std::move(path)), trouble_(trouble) {}
  bool expect(bool is, const char* what) const;

  const nlohmann::ordered_json& value_;
  std::string path_;
  std::optional<Error>& trouble_;
};

}  // namespace somato::detail
