#include "somato/core/sample_source.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "somato/core/check.h"

namespace somato {

Result<void> for_each_part(SampleSource& source,
                           const std::function<Result<void>(const Samples&)>& visit) {
  if (auto rewound = source.rewind(); !rewound) return rewound;
  for (;;) {
    const Result<SamplePart> part = source.next();
    if (!part) return fail(part.error());
    if (!*part) return {};
    if (auto visited = visit(**part); !visited) return visited;
  }
}

SamplesInMemory::SamplesInMemory(const Samples& samples, std::size_t most)
    : samples_(samples), most_(most) {
  require(most > 0, "a part of samples holds at least one");
}

Result<void> SamplesInMemory::rewind() {
  done_ = 0;
  return {};
}

Result<SamplePart> SamplesInMemory::next() {
  const std::size_t first = done_;
  const std::size_t count = std::min(most_, samples_.count() - first);
  done_ += count;
  if (count == 0) return SamplePart();
  if (count == samples_.count()) return SamplePart(SamplePart(), &samples_);
  std::vector<std::size_t> indices(count);
  std::iota(indices.begin(), indices.end(), first);
  return std::make_shared<const Samples>(samples_.subset(indices));
}

Result<SamplePart> ChangedSamples::next() {
  return source_.next().map([&](const SamplePart& part) {
    return part ? std::make_shared<const Samples>(change_(*part)) : part;
  });
}

}  // namespace somato
