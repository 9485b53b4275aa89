#include "base/numbers/whole_table.h"

#include <limits>
#include <utility>

#include "base/archives/zip_reader.h"
#include "base/arrays/mat_array.h"
#include "base/arrays/npy_layout.h"
#include "base/arrays/npz_array.h"
#include "base/tables/csv_records.h"
#include "base/tables/csv_table_reader.h"
#include "base/text/text.h"
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

bool holds_variables(std::string_view start) {
  return is_zip(start) || is_mat(start);
}

Result<WholeTable> whole_table(const std::string& bytes, const std::string& where,
                               const CsvOptions& options) {
  if (!holds_variables(bytes) && !options.variable.empty()) {
    return fail(ErrorKind::kUsage, "a variable is named, but the file has only one table", where,
                "leave out the variable");
  }
  if (is_npy(bytes)) return npy_table(bytes, where, options);
  if (!holds_variables(bytes)) return csv_table(bytes, where, options);
  SOMATO_TRY(const std::string npy, is_zip(bytes) ? npy_in_npz(bytes, where, options.variable)
                                                  : npy_in_mat(bytes, where, options.variable));
  return npy_table(npy, where, options);
}

}  // namespace somato
