#include "t_mpsom_job.h"

#include <algorithm>
#include <vector>

#include "maps/t_mpsom/t_mpsom_learner.h"
#include "somato/core/random.h"
#include "somato/maps/t_mpsom.h"

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
std::vector<Signal> frame(Random& random) {
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
    for (std::size_t i = 0; i < kFrames; ++i) frames_.push_back(frame(random));
  }

  // The map is made anew each time; that does not count.
  double run() override {
    TMpsom map(parameters_);
    const double begin = now();
    learn(map);
    return now() - begin;
  }
  Matrix<float> weights() const override { return {}; }

 private:
  void learn(TMpsom& map) const {
    Random draws(parameters_.seed, Stream::kDraws);
    TMpsomLearner learner(map);
    for (std::uint64_t t = 0; t < parameters_.iterations; ++t) {
      const std::vector<Signal>& drawn = frames_[draws.below(frames_.size())];
      const SignalView inputs[] = {drawn[0].view(), drawn[1].view()};
      learner.learn(inputs, parameters_.learning_rate().at(t));
    }
  }

  TMpsomParameters parameters_;
  std::vector<std::vector<Signal>> frames_;
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
