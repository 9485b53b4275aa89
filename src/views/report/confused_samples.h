#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "views/report/evidence.h"

namespace somato::detail {

/// How the tests of the main result named a sample.
struct TestedSample {
  std::size_t sample = 0;    ///< Its number, as in Evidence::explorations.
  std::size_t tests = 0;     ///< The runs that tested it.
  std::string predicted;     ///< A wrong class that tests named; empty: none did.
  std::size_t confused = 0;  ///< The runs that named this class.
};

/// The tests of a sample with the wrong class that most runs named, of equals the first in
/// alphabetical order. Runs of other recordings do not count.
TestedSample tests_of(const Evidence& evidence, std::size_t sample);

/// For each of the most frequent confusions, at most `most`, the sample that most runs confused in
/// this way, of equals the first. A sample is listed once. Empty without tests of all samples.
std::vector<TestedSample> confused_samples(const Evidence& evidence, std::size_t most);

}  // namespace somato::detail
