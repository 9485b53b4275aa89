#include "somato/recording/csv_import.h"

#include <fmt/format.h>

#include <utility>

#include "recordings/tables/csv_import_check.h"

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
                "write [[channel]] on a separate line, followed by its keys");
  }
  for (const Table& table : *tables) {
    SOMATO_TRY(CsvChannel channel, read_parameters<CsvChannel>(table));
    description.channels.push_back(std::move(channel));
    places.channels.push_back(table.where);
  }
  return {};
}

Result<void> read_files(const Table::Entry& entry, CsvImport& description, Places& places) {
  const auto* table = std::get_if<Table>(&entry.content);
  if (!table) {
    return fail(ErrorKind::kUsage, "'import' must be a table", entry.where,
                "write [import] on a separate line, followed by its keys");
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
      {TimeUnit::kNanoseconds, "ns"},
      {TimeUnit::kIso, "iso"}};
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

const std::vector<std::pair<IncompleteWindow, std::string>>& Choices<IncompleteWindow>::all() {
  static const std::vector<std::pair<IncompleteWindow, std::string>> choices{
      {IncompleteWindow::kLeaveOut, "leave_out"}, {IncompleteWindow::kKeep, "keep"}};
  return choices;
}

const Declarations<CsvTrials>& CsvTrials::declarations() {
  using P = CsvTrials;
  static const auto declared =
      Declarations<P>()
          .add("files", &P::files, "", Range::any(),
               "Pattern of the file names, with labels in braces: "
               "{material}/{object}_{trial:number}.csv. It may include folders. Required, unless "
               "a single file with other labels is imported.")
          .add("rows", &P::rows, "", Range::any(),
               "Meaning of a row: a frame of the file's exploration, or an exploration with one "
               "frame.")
          .add("labels", &P::labels, "", Range::any(),
               "Names of columns with labels of the row's exploration, text or numbers.")
          .add("exploration", &P::exploration, "", Range::any(),
               "Column whose value is the same in consecutive rows of an exploration, such as its "
               "number: a file is divided where it changes. It is a label only if 'labels' lists "
               "it; empty: files are not divided.")
          .add(
              "window", &P::window, "", Range::at_least(1),
              "Number of rows of the explorations into which a file is cut. automatic: all rows of "
              "a file form one exploration.")
          .add("overlap", &P::overlap, "", Range::at_least(0),
               "Number of rows that a window shares with the preceding one.")
          .add("incomplete", &P::incomplete, "", Range::any(),
               "Whether the rows at the end that do not fill a window are left out and counted, or "
               "kept as a shorter exploration.")
          .add("header", &P::header, "", Range::any(),
               "Whether the first line contains the names of the columns; otherwise they are named "
               "1, 2, 3 and so on.")
          .add("decimal", &P::decimal, "", Range::any(),
               "Decimal separator of numbers: a point, or a comma as in many spreadsheets.")
          .add(
              "time", &P::time, "", Range::any(),
              "Column with the time of each row, or with time_unit = \"iso\" two columns, with the "
              "date and the time of day; empty: none.")
          .add("time_unit", &P::time_unit, "", Range::any(),
               "Unit of that column; iso: dates and times in ISO 8601, such as "
               "2025-04-17T17:00:08.25+02:00.")
          .add("rate", &P::rate, "Hz", Range::at_least(0),
               "Rows per second if no column contains the time; 0: unknown.")
          .add("missing", &P::missing, "", Range::any(),
               "Whether a field that is empty, NaN, NA or null is an error or marked as invalid.")
          .add("ignore", &P::ignore, "", Range::any(),
               "Columns to leave out, by name, as ranges such as aux1..aux8 or as patterns "
               "such as aux_*; columns without names by number.")
          .add("other_columns", &P::other_columns, "", Range::any(),
               "Treatment of columns that are not mentioned.")
          .add("other_files", &P::other_files, "", Range::any(),
               "Treatment of files with the same extension whose names do not match.");
  return declared;
}

const Declarations<CsvChannel>& CsvChannel::declarations() {
  using P = CsvChannel;
  static const auto declared =
      Declarations<P>()
          .add("name", &P::name, "", Range::any(), "Name of the channel, such as touch. Required.")
          .add("unit", &P::unit, "", Range::any(),
               "Unit of its values after multiplication by the factor; empty for none.")
          .add("columns", &P::columns, "", Range::any(),
               "Its columns, by name, as ranges such as taxel1..taxel16 or thumb..pinky (from one "
               "column to the other), or as patterns such as taxel_*. A pattern matches columns "
               "that are neither named elsewhere nor ignored.")
          .add("shape", &P::shape, "", Range::between(1, 1e9),
               "Arrangement of the columns, row by row, such as [4, 4]; empty: a flat list.")
          .add("from_label", &P::from_label, "", Range::any(),
               "Instead of columns: a label whose number is the channel's only value.")
          .add("factor", &P::factor, "", Range::any(), "Factor by which every value is multiplied.")
          .add("absolute", &P::absolute, "", Range::any(),
               "Whether to use absolute values, for example of a speed with a sign for its "
               "direction.");
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
  SOMATO_TRY_VOID(check_csv_parts(description, places));
  return description;
}

}  // namespace somato
