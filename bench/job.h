#pragma once

#include <memory>

#include "somato/core/matrix.h"
#include "workload_data.h"

namespace somato::bench {

/// A case made ready: its samples are there, and it can be run any number of times.
class Job {
 public:
  Job() = default;
  Job(const Job&) = delete;
  Job(Job&&) = delete;
  Job& operator=(const Job&) = delete;
  Job& operator=(Job&&) = delete;
  virtual ~Job() = default;

  /// Does the work. Returns the seconds of that part of it which counts, 0 where all of it does.
  virtual double run() = 0;

  /// Neurons x features, of the map of the last run; empty where there is none.
  virtual Matrix<float> weights() const = 0;
};

/// The weights that the map of a case starts from, neurons x features.
Matrix<float> initial_weights(const Workload& workload, const Samples& samples);

/// Seconds since some point in time.
double now();

/// The job of a case, on so many threads where it can use them.
std::unique_ptr<Job> make_job(const Workload& workload, std::size_t threads);

}  // namespace somato::bench
