#include "t_mpsom_job.h"

#include <algorithm>
#include <vector>

#include "somato/core/random.h"
#include "somato/maps/t_mpsom.h"
#include "somato/maps/t_mpsom_training.h"

namespace somato::bench {
namespace {

constexpr std::size_t kPosture = 90;
constexpr std::size_t kTouch = 45;
constexpr std::size_t kFrames = 32;

TMpsomParameters parameters_of(std::size_t enlargement, std::size_t iterations) {
  TMpsomParameters parameters;
  parameters.shape = {46 * enlargement, 23 * enlargement};
  parameters.input_sizes = {kPosture, kTouch};
  parameters.iterations = iterations;
  return parameters;
}

// One joint angle of each ten elements, as one-hot codes are, and every sensor of touch.
TMpsomFrame frame(Random& random) {
  std::vector<float> posture(kPosture);
  for (std::size_t joint = 0; joint < kPosture / 10; ++joint) {
    posture[10 * joint + random.below(10)] = 1.0F;
  }
  std::vector<float> touch(kTouch);
  for (float& value : touch) value = static_cast<float>(random.uniform());
  return {Signal::dense(std::move(posture)), Signal::dense(std::move(touch))};
}

class LearnFrames : public Job {
 public:
  explicit LearnFrames(const TMpsomParameters& parameters) : parameters_(parameters) {
    Random random(1);
    for (std::size_t i = 0; i < kFrames; ++i) explorations_.push_back({frame(random)});
  }

  // The map is made anew each time; that does not count.
  double run() override {
    TMpsom map(parameters_);
    const double begin = now();
    train_t_mpsom(map, explorations_).value();
    return now() - begin;
  }
  Matrix<float> weights() const override { return {}; }

 private:
  TMpsomParameters parameters_;
  std::vector<TMpsomExploration> explorations_;
};

}  // namespace

std::optional<TMpsomParameters> t_mpsom_parameters(const std::string& name, std::size_t scale) {
  if (name == "t_mpsom") return parameters_of(1, std::max<std::size_t>(2000 / scale, 1));
  if (name == "t_mpsom_large") return parameters_of(10, std::max<std::size_t>(40 / scale, 1));
  return std::nullopt;
}

std::unique_ptr<Job> make_t_mpsom_job(const TMpsomParameters& parameters) {
  return std::make_unique<LearnFrames>(parameters);
}

}  // namespace somato::bench
