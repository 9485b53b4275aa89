#pragma once

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace somato::testing {

/// Checks JSON by schemas in the subset of JSON Schema (draft 2020-12) that scripts/page_types.py
/// makes types from: `$ref`, `type`, `const`, `enum`, `anyOf`, `minimum`, `maximum`, `items`,
/// `minItems`, `maxItems`, `properties`, `required` and `additionalProperties`, which an object
/// must state; `$schema`, `$defs` and `description` constrain nothing.
class JsonSchemas {
 public:
  /// Files of schemas by their names. Throws std::invalid_argument, which names the place, for any
  /// other keyword, a value that a keyword does not take, and a reference to nothing.
  explicit JsonSchemas(std::map<std::string, nlohmann::json> files);

  /// A sentence for each violation, with its place in `value` as a JSON pointer; empty for a valid
  /// value. `reference` is a file or a part of one, such as "view.json#/$defs/State". Throws
  /// std::invalid_argument for a reference to nothing.
  std::vector<std::string> problems(const nlohmann::json& value,
                                    const std::string& reference) const;

 private:
  std::map<std::string, nlohmann::json> files_;
};

/// Whether `value` is valid by a schema of the pages, which are in web/schema; `reference` as for
/// JsonSchemas::problems().
::testing::AssertionResult fits_schema(const nlohmann::json& value, const std::string& reference);

/// The same for a text in JSON.
::testing::AssertionResult text_fits_schema(std::string_view text, const std::string& reference);

}  // namespace somato::testing
