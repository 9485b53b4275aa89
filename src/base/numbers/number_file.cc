#include "base/numbers/number_file.h"

#include <utility>

#include "base/files/whole_file.h"
#include "base/numbers/whole_table.h"

namespace somato {
Result<NumberTable> read_numbers(const std::string& path, const CsvOptions& options,
                                 std::size_t limit) {
  return read_whole(path, limit).and_then([&](const std::string& bytes) {
    return whole_table(bytes, path, options).map([](WholeTable&& whole) {
      return std::move(whole.table);
    });
  });
}

}  // namespace somato
