#include "base/tables/table_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "base/core/values_at.h"
#include "base/tables/csv_header.h"
#include "base/text/flag_hint.h"
#include "base/text/name_glob.h"
#include "base/text/number_of_text.h"
#include "base/text/text.h"
#include "somato/core/value.h"

namespace somato {
namespace {

using Columns = std::vector<std::size_t>;

tl::unexpected<Error> unusable_choice(std::string what, std::string_view where,
                                      std::string advice) {
  return fail(ErrorKind::kUsage, std::move(what), std::string(where), std::move(advice));
}

// Numbers from 1, both included.
struct NumberRange {
  std::size_t first;
  std::size_t last;

  bool contains(std::size_t column) const { return first <= column + 1 && column + 1 <= last; }
};

std::optional<NumberRange> number_range(std::string_view item) {
  constexpr std::string_view kDots = "..";
  const std::size_t dots = item.find(kDots);
  const auto first = number_of_text<std::size_t>(item.substr(0, dots));
  const auto last = dots == std::string_view::npos
                        ? first
                        : number_of_text<std::size_t>(item.substr(dots + kDots.size()));
  if (!first || !last || *first == 0 || *last < *first) return std::nullopt;
  return NumberRange{*first, *last};
}

// The columns selected by an item, and whether it names a single one.
struct Named {
  Columns columns;
  bool exactly = true;
};

Result<Named> by_number(const std::string& item, std::size_t width, std::string_view where) {
  const auto range = number_range(item);
  const std::string advice =
      fmt::format("its columns have no names: write numbers from 1 to {}, or 2..4", width);
  if (!range || range->last > width) {
    return unusable_choice(fmt::format("there is no column {}", shown(item)), where, advice);
  }
  Named named{Columns(range->last - range->first + 1),
              number_of_text<std::size_t>(item).has_value()};
  std::iota(named.columns.begin(), named.columns.end(), range->first - 1);
  return named;
}

// Whether the name of a column does not select it, and its number does.
bool needs_number(const std::vector<std::string>& names, std::size_t column) {
  return is_nameless(names[column], column) ||
         std::count(names.begin(), names.end(), names[column]) > 1;
}

// The columns in a range of numbers, if none of them can be selected by name.
std::optional<Named> by_number_among(const std::string& item,
                                     const std::vector<std::string>& names) {
  const auto range = number_range(item);
  if (!range || range->last > names.size()) return std::nullopt;
  Named named;
  for (std::size_t i = range->first - 1; i < range->last; ++i) {
    if (!needs_number(names, i)) return std::nullopt;
    named.columns.push_back(i);
  }
  return named;
}

Result<Named> by_name(const std::string& item, const std::vector<std::string>& names,
                      std::string_view where) {
  Named named;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == item) named.columns.push_back(i);
  }
  if (named.columns.size() == 1) return named;
  if (named.columns.size() > 1) {
    return unusable_choice(fmt::format("two columns are named {}", shown(item)), where,
                           "rename one of them, or use the number of the column");
  }
  if (auto numbered = by_number_among(item, names)) return *numbered;
  named.exactly = false;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (matches_glob(item, names[i])) named.columns.push_back(i);
  }
  if (!named.columns.empty()) return named;
  const bool number = number_range(item).has_value();
  return unusable_choice(
      fmt::format("there is no column {}", shown(item)), where,
      number ? "its columns have names: select them by name" : name_advice(item, names));
}

// Takes items one after the other into a choice of columns.
class Chooser {
 public:
  Chooser(const TableColumns& table, std::string_view where)
      : table_(table), where_(where), chosen_(table.width, false), named_(table.width, false) {}

  void take_all() { chosen_.assign(chosen_.size(), true); }

  Result<void> use(const std::string& item) {
    return find(item).and_then([&](const Named& named) -> Result<void> {
      for (const std::size_t column : named.columns) {
        if (named.exactly && named_[column]) {
          return unusable_choice(fmt::format("column {} is selected twice", shown(item)), where_,
                                 "name it once");
        }
        if (named.exactly && column == table_.label) {
          return unusable_choice(
              fmt::format("column {} contains the labels and cannot be used as a feature",
                          shown(item)),
              where_,
              fmt::format("remove it from the columns to use{}, or use another label column",
                          flag_hint("columns-to-use")));
        }
        chosen_[column] = true;
        if (named.exactly) named_[column] = true;
      }
      return {};
    });
  }

  Result<void> skip(const std::string& item) {
    return find(item).and_then([&](const Named& named) -> Result<void> {
      for (const std::size_t column : named.columns) {
        if (named_[column]) {
          return unusable_choice(
              fmt::format("column {} is both selected and skipped", name(column)), where_,
              "either use it or skip it");
        }
        if (named.exactly && column == table_.label) {
          return unusable_choice(
              fmt::format("column {} contains the labels and cannot be skipped", shown(item)),
              where_, "do not skip it; labels are not used for training");
        }
        chosen_[column] = false;
      }
      return {};
    });
  }

  // Whether an item names the column, and no other, to be used.
  bool is_named(std::size_t column) const { return named_[column]; }

  Columns chosen() const {
    Columns columns;
    for (std::size_t i = 0; i < chosen_.size(); ++i) {
      if (chosen_[i] && i != table_.label) columns.push_back(i);
    }
    return columns;
  }

 private:
  std::string name(std::size_t column) const {
    return table_.names.empty() ? std::to_string(column + 1) : shown(table_.names[column]);
  }

  Result<Named> find(const std::string& item) const {
    return table_.names.empty() ? by_number(item, table_.width, where_)
                                : by_name(item, table_.names, where_);
  }

  const TableColumns& table_;
  std::string_view where_;
  std::vector<bool> chosen_;
  std::vector<bool> named_;  // by an item that names a single column to be used
};

std::string skip_columns(const std::string& columns) {
  return fmt::format("skip {}{}", columns, flag_hint("skip", columns));
}

// Columns that nothing but their place identifies are features only where they are chosen.
Result<void> check_identified(const TableColumns& table, const Chooser& chooser,
                              std::string_view where) {
  if (table.names.empty()) return {};
  Columns nameless;
  std::map<std::string, std::size_t> first;
  for (const std::size_t column : table.features) {
    if (chooser.is_named(column)) continue;
    const std::string& name = table.names[column];
    if (is_nameless(name, column)) {
      nameless.push_back(column);
      continue;
    }
    const auto [twin, is_new] = first.emplace(name, column);
    if (is_new) continue;
    return fail(ErrorKind::kData,
                fmt::format("columns {} and {} are both named {}", twin->second + 1, column + 1,
                            shown(name)),
                std::string(where),
                "rename one of them, or " + skip_columns(columns_by_number(table.names, {column})));
  }
  if (nameless.empty()) return {};
  return fail(nameless_columns(nameless, table.width, where,
                               skip_columns(columns_by_number(table.names, nameless))));
}

tl::unexpected<Error> missing_feature(const std::string& name, const TableColumns& table,
                                      std::string_view where) {
  const bool there = std::count(table.names.begin(), table.names.end(), name) > 0;
  return fail(ErrorKind::kData,
              fmt::format("column {} is required, but {}", shown(name),
                          there ? "is left out or contains the labels" : "is missing"),
              std::string(where), there ? "select it too" : name_advice(name, table.names));
}

// The columns of the features among those that are left.
Result<Columns> pick(const std::vector<std::string>& features, const TableColumns& table,
                     std::string_view where) {
  if (table.feature_names() == features) return table.features;
  Columns picked;
  for (const std::string& name : features) {
    Columns fitting;
    for (const std::size_t column : table.features) {
      if (table.names[column] == name) fitting.push_back(column);
    }
    if (fitting.empty()) return missing_feature(name, table, where);
    if (fitting.size() > 1) {
      return fail(ErrorKind::kData, fmt::format("two columns are named {}", shown(name)),
                  std::string(where), "rename or skip one of them");
    }
    picked.push_back(fitting[0]);
  }
  return picked;
}

std::vector<ColumnScale> scales_by_column(const std::vector<ColumnScale>& scales,
                                          const Columns& features) {
  std::vector<ColumnScale> by_column;
  if (scales.size() != 1 && scales.size() != features.size()) return by_column;
  by_column.resize(*std::max_element(features.begin(), features.end()) + 1);
  for (std::size_t i = 0; i < features.size(); ++i) {
    by_column[features[i]] = scales[scales.size() == 1 ? 0 : i];
  }
  return by_column;
}

}  // namespace

std::vector<std::string> TableColumns::feature_names() const {
  if (names.empty()) return {};
  return values_at(names, features);
}

std::vector<std::size_t> TableColumns::left_out() const {
  std::vector<bool> taken(width, false);
  for (const std::size_t column : features) taken[column] = true;
  if (label) taken[*label] = true;
  Columns left;
  for (std::size_t i = 0; i < width; ++i) {
    if (!taken[i]) left.push_back(i);
  }
  return left;
}

Result<TableColumns> choose_columns(const ColumnChoice& choice, TableColumns table,
                                    std::string_view where) {
  Chooser chooser(table, where);
  if (choice.use.empty()) chooser.take_all();
  for (const std::string& item : choice.use) {
    SOMATO_TRY_VOID(chooser.use(item));
  }
  for (const std::string& item : choice.skip) {
    SOMATO_TRY_VOID(chooser.skip(item));
  }
  table.features = chooser.chosen();
  if (table.features.empty()) {
    const bool chosen = !choice.use.empty() || !choice.skip.empty();
    return fail(
        chosen ? ErrorKind::kUsage : ErrorKind::kData, "no numeric column is left",
        std::string(where),
        chosen ? "use more columns, or skip fewer" : "check the separator and the label column");
  }
  if (choice.features.empty() || table.names.empty()) {
    SOMATO_TRY_VOID(check_identified(table, chooser, where));
  } else {
    SOMATO_TRY(table.features, pick(choice.features, table, where));
  }
  table.scales = scales_by_column(choice.scales, table.features);
  return table;
}

double without_offset(const TableColumns& table, std::size_t column, double number) {
  return column < table.scales.size() ? number - table.scales[column].offset : number;
}

bool has_offsets(const TableColumns& table) {
  return std::any_of(table.scales.begin(), table.scales.end(),
                     [](const ColumnScale& scale) { return scale.offset != 0.0; });
}

bool leaves_out_number(const ColumnChoice& choice, std::size_t column) {
  const auto contained = [&](const std::vector<std::string>& items) {
    return std::any_of(items.begin(), items.end(), [&](const std::string& item) {
      const auto range = number_range(item);
      return range && range->contains(column);
    });
  };
  const bool numbers =
      std::all_of(choice.use.begin(), choice.use.end(),
                  [](const std::string& item) { return number_range(item).has_value(); });
  return contained(choice.skip) || (!choice.use.empty() && numbers && !contained(choice.use));
}

}  // namespace somato
