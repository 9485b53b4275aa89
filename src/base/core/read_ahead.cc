#include "base/core/read_ahead.h"

namespace somato {

void ReadAhead::fetch() {
  coming_ = std::async(std::launch::async, [this] { return source_.next(); });
}

// No read may be in progress when the source is used directly, or destroyed.
void ReadAhead::forget() {
  if (coming_.valid()) coming_.wait();
  coming_ = {};
}

Result<void> ReadAhead::rewind() {
  forget();
  return source_.rewind();
}

Result<SamplePart> ReadAhead::next() {
  if (!coming_.valid()) fetch();
  Result<SamplePart> part = coming_.get();
  if (part && *part) fetch();
  return part;
}

}  // namespace somato
