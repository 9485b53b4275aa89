#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "somato/recording/recording.h"

namespace somato::live {

/// A name, and a number of explorations that have it.
struct NameCount {
  std::string name;
  std::size_t explorations = 0;

  bool operator==(const NameCount&) const = default;
};

/// The names of the explorations of a session, for each label: those that are planned, then the
/// others in the order of their first use, so that a name keeps its place. Explorations without a
/// name have the value "unknown", which is not counted.
class NameCounts {
 public:
  /// With so many explorations of each name; 0: any number.
  explicit NameCounts(std::vector<std::string> planned = {}, std::size_t each = 0)
      : planned_(std::move(planned)), each_(each) {}

  /// One more exploration has this label.
  void add(const Label& label);

  /// One exploration less has this label. Its name keeps its place, unless it is the last one, is
  /// not planned and has no exploration.
  void remove(const Label& label);

  /// The names of a label in their order.
  std::vector<NameCount> of(const std::string& label) const;

  void plan(std::size_t each) { each_ = each; }
  std::size_t each() const { return each_; }

  /// The first name of which fewer explorations exist than are planned, and the number that its
  /// next exploration has; nothing without a plan, or when it is fulfilled. All names are planned
  /// if none was at the beginning.
  std::optional<NameCount> next(const std::string& label) const;

 private:
  std::vector<NameCount> planned() const;
  std::vector<NameCount>& counts(const std::string& label);

  std::vector<std::string> planned_;
  std::size_t each_;
  std::map<std::string, std::vector<NameCount>> counts_;
};

}  // namespace somato::live
