#include "somato/recording/csv_import.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>
#include <string_view>

#include "recording/name_pattern.h"

namespace somato {
namespace {

constexpr std::string_view kDots = "..";
constexpr std::uint64_t kMostColumns = 100000;

tl::unexpected<Error> wrong(std::string what, std::string advice) {
  return fail(ErrorKind::kUsage, std::move(what), {}, std::move(advice));
}

// A name that ends in a number, such as "channel12".
struct Numbered {
  std::string_view stem;
  std::size_t digits;
  std::uint64_t number;
};

std::optional<Numbered> numbered_name(std::string_view name) {
  const std::size_t last = name.find_last_not_of("0123456789");
  const std::size_t stem = last == std::string_view::npos ? 0 : last + 1;
  Numbered parts{name.substr(0, stem), name.size() - stem, 0};
  const auto [stop, status] =
      std::from_chars(name.data() + stem, name.data() + name.size(), parts.number);
  return status == std::errc{} ? std::optional(parts) : std::nullopt;
}

Result<void> add_range(std::string_view range, std::size_t dots, std::vector<std::string>& names) {
  const auto first = numbered_name(range.substr(0, dots));
  const auto last = numbered_name(range.substr(dots + kDots.size()));
  if (!first || !last || first->stem != last->stem || first->number > last->number) {
    return wrong(fmt::format("'{}' is no range of columns", range),
                 "write such as \"taxel1..taxel16\"");
  }
  if (last->number - first->number >= kMostColumns || names.size() >= kMostColumns) {
    return wrong(fmt::format("'{}' makes more than {} columns", range, kMostColumns), {});
  }
  for (std::uint64_t number = first->number; number <= last->number; ++number) {
    names.push_back(fmt::format("{}{:0{}}", first->stem, number, first->digits));
  }
  return {};
}

Result<void> check_trials(const CsvTrials& trials) {
  if (trials.files.empty()) {
    return wrong("'files' is missing", "write files = \"{object}_{trial:number}.csv\" or the like");
  }
  const auto pattern = NamePattern::parse(trials.files);
  if (!pattern) return wrong("'files': " + pattern.error().what, pattern.error().advice);
  if (!std::isfinite(trials.rate) || trials.rate < 0.0) {
    return wrong(fmt::format("the rate is {} Hz", trials.rate), "give a rate above 0, or none");
  }
  if (trials.time.empty() || trials.rate == 0.0) return {};
  return wrong("there are both 'time' and 'rate'", "keep the one that tells the truth");
}

Result<void> check_source(const CsvChannel& channel) {
  if (channel.name.empty()) return wrong("the channel has no name", "write name = \"touch\"");
  if (channel.columns.empty() == channel.from_label.empty()) {
    return wrong(fmt::format("channel '{}' has {}", channel.name,
                             channel.columns.empty() ? "neither columns nor a label"
                                                     : "both columns and a label"),
                 "write columns = [...] or from_label = \"...\"");
  }
  return {};
}

Result<void> check_shape(const CsvChannel& channel, std::size_t elements) {
  if (channel.shape.empty()) return {};
  std::size_t filled = 1;
  for (const std::size_t length : channel.shape) {
    filled = length > elements ? 0 : filled * length;
    if (filled == 0 || filled > elements) break;
  }
  if (filled == elements) return {};
  return wrong(fmt::format("channel '{}' has {} elements, which do not fill its shape {}",
                           channel.name, elements, fmt::join(channel.shape, " x ")),
               "correct the columns or the shape");
}

Result<void> check_label(const CsvChannel& channel, const std::vector<std::string>& labels) {
  const bool known = std::find(labels.begin(), labels.end(), channel.from_label) != labels.end();
  if (known || channel.from_label.empty()) return {};
  return fail(unknown_name("label", channel.from_label, {}, labels));
}

// One channel beside those before it, whose names and columns are in `taken`.
Result<void> check_channel(const CsvChannel& channel, const std::vector<std::string>& labels,
                           std::set<std::string>& names, std::set<std::string>& taken) {
  if (auto checked = check_source(channel); !checked) return checked;
  if (!names.insert(channel.name).second) {
    return wrong(fmt::format("there are two channels '{}'", channel.name), "rename one of them");
  }
  const auto columns = expand_columns(channel.columns);
  if (!columns) return fail(columns.error());
  for (const std::string& column : *columns) {
    if (column.empty()) return wrong("a column has no name", "name it, or leave it out");
    if (taken.insert(column).second) continue;
    return wrong(fmt::format("column '{}' is used twice", column), "name each column once");
  }
  const std::size_t elements = channel.columns.empty() ? 1 : columns->size();
  return check_label(channel, labels).and_then([&] { return check_shape(channel, elements); });
}

Result<void> check_ignored(const CsvTrials& trials, const std::set<std::string>& taken) {
  const auto ignored = expand_columns(trials.ignore);
  if (!ignored) return wrong("'ignore': " + ignored.error().what, ignored.error().advice);
  for (const std::string& column : *ignored) {
    if (!taken.contains(column)) continue;
    return wrong(fmt::format("column '{}' is both used and ignored", column), "decide");
  }
  return {};
}

// Checks all parts; an error's place is what `place` says of the part that it lies in, 0 for
// [import] and then the channels.
template <typename Place>
Result<void> check_parts(const CsvImport& description, const Place& place) {
  Result<void> checked = check_trials(description.trials);
  if (checked && description.channels.empty()) {
    checked = wrong("there are no channels", "add [[channel]] with name, unit and columns");
  }
  if (!checked) {
    checked.error().where = place(0);
    return checked;
  }
  const std::vector<std::string> labels =
      NamePattern::parse(description.trials.files).value().labels();
  std::set<std::string> names;
  std::set<std::string> taken{description.trials.time};
  for (std::size_t i = 0; checked && i < description.channels.size(); ++i) {
    checked = check_channel(description.channels[i], labels, names, taken);
    if (!checked) checked.error().where = place(i + 1);
  }
  if (!checked) return checked;
  checked = check_ignored(description.trials, taken);
  if (!checked) checked.error().where = place(0);
  return checked;
}

struct Places {
  std::string import;
  std::vector<std::string> channels;

  std::string operator()(std::size_t part) const { return part == 0 ? import : channels[part - 1]; }
};

Result<void> read_channels(const Table::Entry& entry, CsvImport& description, Places& places) {
  const auto* tables = std::get_if<std::vector<Table>>(&entry.content);
  if (!tables) {
    return fail(ErrorKind::kUsage, "'channel' must be a list of tables", entry.where,
                "write [[channel]] on a line of its own, its keys below");
  }
  for (const Table& table : *tables) {
    Result<CsvChannel> channel = read_parameters<CsvChannel>(table);
    if (!channel) return fail(std::move(channel.error()));
    description.channels.push_back(std::move(*channel));
    places.channels.push_back(table.where);
  }
  return {};
}

Result<void> read_files(const Table::Entry& entry, CsvImport& description, Places& places) {
  const auto* table = std::get_if<Table>(&entry.content);
  if (!table) {
    return fail(ErrorKind::kUsage, "'import' must be a table", entry.where,
                "write [import] on a line of its own, its keys below");
  }
  places.import = table->where;
  return read_parameters<CsvTrials>(*table).map(
      [&](CsvTrials trials) { description.trials = std::move(trials); });
}

}  // namespace

const std::vector<std::pair<TimeUnit, std::string>>& Choices<TimeUnit>::all() {
  static const std::vector<std::pair<TimeUnit, std::string>> choices{
      {TimeUnit::kSeconds, "s"},
      {TimeUnit::kMilliseconds, "ms"},
      {TimeUnit::kMicroseconds, "us"},
      {TimeUnit::kNanoseconds, "ns"}};
  return choices;
}

const std::vector<std::pair<MissingValues, std::string>>& Choices<MissingValues>::all() {
  static const std::vector<std::pair<MissingValues, std::string>> choices{
      {MissingValues::kRefuse, "refuse"}, {MissingValues::kMask, "mask"}};
  return choices;
}

const std::vector<std::pair<Unmentioned, std::string>>& Choices<Unmentioned>::all() {
  static const std::vector<std::pair<Unmentioned, std::string>> choices{
      {Unmentioned::kRefuse, "refuse"}, {Unmentioned::kIgnore, "ignore"}};
  return choices;
}

const Declarations<CsvTrials>& CsvTrials::declarations() {
  using P = CsvTrials;
  static const auto declared =
      Declarations<P>()
          .add("files", &P::files, "", Range::any(),
               "What the names of the files look like, labels between braces: "
               "{material}/{object}_{trial:number}.csv. Folders in it are labels too. Has to be "
               "given.")
          .add("header", &P::header, "", Range::any(),
               "The first line holds the names of the columns; otherwise they are called 1, 2, 3 "
               "and so on.")
          .add("time", &P::time, "", Range::any(), "Column with the time of each row; empty: none.")
          .add("time_unit", &P::time_unit, "", Range::any(), "Unit of that column.")
          .add("rate", &P::rate, "Hz", Range::at_least(0),
               "Rows a second where no column tells the time; 0: nobody knows.")
          .add("missing", &P::missing, "", Range::any(),
               "A field that is empty, NaN, NA or null is an error, or marked as not valid.")
          .add("ignore", &P::ignore, "", Range::any(),
               "Columns that are left out, also as ranges such as aux1..aux8.")
          .add("other_columns", &P::other_columns, "", Range::any(),
               "What is done with columns that are not mentioned anywhere.")
          .add("other_files", &P::other_files, "", Range::any(),
               "What is done with files of the same ending whose names do not fit.");
  return declared;
}

const Declarations<CsvChannel>& CsvChannel::declarations() {
  using P = CsvChannel;
  static const auto declared =
      Declarations<P>()
          .add("name", &P::name, "", Range::any(),
               "Name of the channel, such as touch. Has to be given.")
          .add("unit", &P::unit, "", Range::any(),
               "Unit of its values, after the factor; empty where there is none.")
          .add("columns", &P::columns, "", Range::any(),
               "Its columns, by name or as ranges such as taxel1..taxel16.")
          .add("shape", &P::shape, "", Range::between(1, 1e9),
               "How the columns lie, row by row, such as [4, 4]; empty: one after the other.")
          .add("from_label", &P::from_label, "", Range::any(),
               "Instead of columns: the label whose number is the channel's only value.")
          .add("factor", &P::factor, "", Range::any(), "Every value is multiplied by it.")
          .add("absolute", &P::absolute, "", Range::any(),
               "Drop the signs, as of a speed that tells its direction by a sign.");
  return declared;
}

Result<std::vector<std::string>> expand_columns(const std::vector<std::string>& columns) {
  std::vector<std::string> names;
  for (const std::string& column : columns) {
    const std::size_t dots = column.find(kDots);
    if (dots == std::string::npos) {
      names.push_back(column);
    } else if (auto added = add_range(column, dots, names); !added) {
      return fail(std::move(added.error()));
    }
  }
  return names;
}

Result<void> check_csv_import(const CsvImport& description) {
  return check_parts(description, [&](std::size_t part) -> std::string {
    if (part == 0) return "[import]";
    return fmt::format("[[channel]] {}", part);
  });
}

Result<CsvImport> read_csv_import(const Table& file) {
  CsvImport description;
  Places places{file.where, {}};
  for (const Table::Entry& entry : file.entries) {
    Result<void> read =
        entry.name == "import" ? read_files(entry, description, places)
        : entry.name == "channel"
            ? read_channels(entry, description, places)
            : fail(unknown_name("table", entry.name, entry.where, {"import", "channel"}));
    if (!read) return fail(std::move(read.error()));
  }
  if (auto checked = check_parts(description, places); !checked) {
    return fail(std::move(checked.error()));
  }
  return description;
}

}  // namespace somato
