#include "files/whole_table.h"

#include <limits>
#include <utility>

#include "files/csv_records.h"
#include "files/csv_table_reader.h"
#include "files/npy_layout.h"
#include "files/text.h"
#include "somato/files/npy.h"

namespace somato {
namespace {

Result<WholeTable> npy_table(const std::string& bytes, const std::string& where,
                             const CsvOptions& options) {
  SOMATO_TRY(const NpyLayout layout, npy_layout(bytes, bytes.size(), where));
  return npy_reading(layout, options, where).and_then([&](NpyReading&& reading) {
    return npy_matrix(bytes, layout, reading, where).map([&](Matrix<float>&& values) {
      return WholeTable{{{}, std::move(values), {}}, std::move(reading.columns)};
    });
  });
}

}  // namespace

Result<WholeTable> csv_table(std::string_view text, std::string_view where,
                             const CsvOptions& options) {
  return text_of(text, where).and_then([&](std::string_view clean) {
    CsvTableReader reader(CsvRecords(clean, where), where, options);
    return reader.begin()
        .and_then([&] { return reader.rows(std::numeric_limits<std::size_t>::max()); })
        .map([&](NumberTable&& table) {
          table.names = reader.columns().feature_names();
          return WholeTable{std::move(table), reader.columns()};
        });
  });
}

Result<WholeTable> whole_table(const std::string& bytes, const std::string& where,
                               const CsvOptions& options) {
  return is_npy(bytes) ? npy_table(bytes, where, options) : csv_table(bytes, where, options);
}

}  // namespace somato
