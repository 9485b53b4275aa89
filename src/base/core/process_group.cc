#include "somato/core/process_group.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <utility>

namespace somato {

std::vector<std::int64_t> ProcessGroup::gather(std::int64_t own) {
  std::vector<std::int64_t> all(size());
  all[rank()] = own;
  sum(all);
  return all;
}

std::int64_t ProcessGroup::sum_before(std::int64_t own) {
  const std::vector<std::int64_t> all = gather(own);
  return std::accumulate(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(rank()),
                         std::int64_t{0});
}

std::string ProcessGroup::from(std::size_t process, const std::string& text) {
  std::vector<std::int64_t> letters(
      static_cast<std::size_t>(gather(static_cast<std::int64_t>(text.size()))[process]));
  if (rank() == process) std::copy(text.begin(), text.end(), letters.begin());
  sum(letters);
  std::string received;
  for (const std::int64_t letter : letters) received += static_cast<char>(letter);
  return received;
}

Result<void> ProcessGroup::agree(const Result<void>& own) {
  const std::vector<std::int64_t> failed = gather(own ? 0 : 1);
  const auto first = std::find(failed.begin(), failed.end(), 1);
  if (first == failed.end()) return {};
  has_failed_ = true;
  const auto process = static_cast<std::size_t>(first - failed.begin());
  Error error = own ? Error{} : own.error();
  error.kind = static_cast<ErrorKind>(gather(static_cast<std::int64_t>(error.kind))[process]);
  error.what = from(process, error.what);
  error.where = from(process, error.where);
  error.advice = from(process, error.advice);
  return fail(std::move(error));
}

double ProcessGroup::in_turn(double value, const std::function<double(double)>& next) {
  for (std::size_t process = 0; process < size(); ++process) {
    const double own = process == rank() ? next(value) : 0.0;
    value = std::bit_cast<double>(gather(std::bit_cast<std::int64_t>(own))[process]);
  }
  return value;
}

}  // namespace somato
