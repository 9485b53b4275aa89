#include "somato/recording/csv_import.h"

#include <fmt/format.h>

#include <utility>

#include "recording/csv_import_check.h"

namespace somato {
namespace {

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

const std::vector<std::pair<CsvRows, std::string>>& Choices<CsvRows>::all() {
  static const std::vector<std::pair<CsvRows, std::string>> choices{
      {CsvRows::kFrames, "frames"}, {CsvRows::kExplorations, "explorations"}};
  return choices;
}

const Declarations<CsvTrials>& CsvTrials::declarations() {
  using P = CsvTrials;
  static const auto declared =
      Declarations<P>()
          .add("files", &P::files, "", Range::any(),
               "What the names of the files look like, labels between braces: "
               "{material}/{object}_{trial:number}.csv. Folders in it are labels too. Has to be "
               "given, unless one file is imported whose labels come from elsewhere.")
          .add("rows", &P::rows, "", Range::any(),
               "What a row is: a frame of the file's exploration, or an exploration of one frame.")
          .add("labels", &P::labels, "", Range::any(),
               "Columns whose text or number is a label of the row's exploration, by name.")
          .add("window", &P::window, "", Range::at_least(1),
               "Rows of each exploration that a file is cut into; rows that fill none are left out "
               "and counted. automatic: all rows of a file are one.")
          .add("overlap", &P::overlap, "", Range::at_least(0),
               "Rows that a window shares with the one before it.")
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
               "Columns that are left out, by name, as ranges such as aux1..aux8 or as patterns "
               "such as "
               "aux_*.")
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
               "Its columns, by name, as ranges such as taxel1..taxel16 or as patterns such as "
               "taxel_*. A pattern takes what is neither named elsewhere nor ignored.")
          .add("shape", &P::shape, "", Range::between(1, 1e9),
               "How the columns lie, row by row, such as [4, 4]; empty: one after the other.")
          .add("from_label", &P::from_label, "", Range::any(),
               "Instead of columns: the label whose number is the channel's only value.")
          .add("factor", &P::factor, "", Range::any(), "Every value is multiplied by it.")
          .add("absolute", &P::absolute, "", Range::any(),
               "Drop the signs, as of a speed that tells its direction by a sign.");
  return declared;
}

Result<void> check_csv_import(const CsvImport& description) {
  return check_csv_parts(description, [](std::size_t part) -> std::string {
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
  if (auto checked = check_csv_parts(description, places); !checked) {
    return fail(std::move(checked.error()));
  }
  return description;
}

}  // namespace somato
