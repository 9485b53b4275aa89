#include "somato/core/read_ahead.h"

namespace somato {

void ReadAhead::fetch() {
  coming_ = std::async(std::launch::async, [this] { return source_.next(); });
}

// Nothing may be under way when the source is used otherwise, or gone.
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
