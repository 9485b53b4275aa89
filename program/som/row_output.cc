#include "som/row_output.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <utility>
#include <vector>

namespace somato::program {

Result<RowOutput> RowOutput::begin(const std::string& path, ProcessGroup* processes) {
  RowOutput output(processes);
  Result<void> begun;
  if (!path.empty() && (!processes || processes->is_first())) {
    begun = FileWriter::begin(path).map([&](FileWriter&& file) { output.file_ = std::move(file); });
  }
  SOMATO_TRY_VOID(agreed(std::move(begun), processes));
  return output;
}

Result<void> RowOutput::write(std::string_view bytes) {
  if (processes_ && !processes_->is_first()) return part_.write(bytes);
  if (file_) return file_->write(bytes);
  std::fwrite(bytes.data(), 1, bytes.size(), stdout);
  return {};
}

// All bytes are fetched, even after a failure: the process waits until they are.
Result<void> RowOutput::fetch(std::size_t process, std::size_t count) {
  constexpr std::size_t kAtOnce = std::size_t{1} << 20;
  std::vector<char> bytes;
  Result<void> done;
  for (std::size_t left = count; left > 0; left -= bytes.size()) {
    bytes.resize(std::min(left, kAtOnce));
    const bool sends = process == processes_->rank();
    if (sends && done) done = part_.read(bytes.data(), bytes.size());
    processes_->bring_to_first(process, bytes);
    if (processes_->is_first() && done) done = write({bytes.data(), bytes.size()});
  }
  return done;
}

Result<void> RowOutput::commit(Result<void> written) {
  SOMATO_TRY_VOID(agreed(std::move(written), processes_));
  Result<void> fetched;
  if (processes_) {
    const auto counts = processes_->gather(static_cast<std::int64_t>(part_.unread()));
    for (std::size_t process = 1; process < counts.size(); ++process) {
      Result<void> done = fetch(process, static_cast<std::size_t>(counts[process]));
      if (fetched) fetched = std::move(done);
    }
  }
  SOMATO_TRY_VOID(agreed(std::move(fetched), processes_));
  return agreed(file_ ? file_->commit() : Result<void>(), processes_);
}

}  // namespace somato::program
