#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "somato/core/result.h"
#include "somato/recording/recording.h"

namespace somato {

/// A pattern of file names with labels in braces, such as `{material}/{object}_{trial:number}.csv`.
///
/// A label matches one or more bytes without a slash; `:number` restricts it to a decimal number
/// such as 3, -50 or 0.25. The parts between slashes are matched with the same number of last parts
/// of a file's path.
class NamePattern {
 public:
  /// Errors (kUsage): no labels where it `needs_labels`, a label without name or named twice, a
  /// brace without its counterpart, two labels that touch, a name with another narrowing than
  /// `number`.
  static Result<NamePattern> parse(std::string_view text, bool needs_labels = true);

  const std::string& text() const { return text_; }

  /// The names of the labels, in their order.
  std::vector<std::string> labels() const;

  /// The part of the pattern after its last dot, with the dot, such as ".csv"; empty when there is
  /// none behind the last label.
  std::string extension() const;

  /// The labels of the file at `path` (its parts between slashes), or nothing when the pattern does
  /// not fit. Errors (kData): it fits in more than one way.
  Result<std::optional<std::vector<Label>>> match(std::string_view path) const;

 private:
  struct Part {
    std::string name;
    bool number = false;
    std::string behind;  // The plain text up to the next label or the end.

    bool takes(std::string_view value) const;
  };

  using Values = std::vector<std::string_view>;

  Result<void> add_label(std::string_view inside);
  std::vector<Values> ways_to_read(std::string_view path) const;
  std::string_view last_parts(std::string_view path) const;

  std::string text_;
  std::string before_;  // The plain text in front of the first label.
  std::vector<Part> parts_;
};

}  // namespace somato
