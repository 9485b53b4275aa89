#include "views/teaching/teacher.h"

#include <algorithm>
#include <utility>

#include "somato/graph/further_learning.h"
#include "views/session/viewed_system.h"

namespace somato::live {
namespace {

void learn(SystemModel& model, const Recording& recording, std::size_t first, TaughtName& name) {
  auto taught = somato::teach(model, recording, name.exploration - first, name.name);
  name.problem = taught ? std::string() : sentence_of(taught.error());
  name.taught = taught ? std::move(*taught) : Taught{};
}

}  // namespace

const TaughtName& Teacher::teach(const Recording& recording, std::size_t exploration,
                                 const std::string& name, std::size_t first) {
  const auto known = std::find_if(names_.begin(), names_.end(), [&](const TaughtName& one) {
    return one.exploration == exploration;
  });
  const bool is_new = known == names_.end();
  TaughtName& given = is_new ? names_.emplace_back() : *known;
  given.exploration = exploration;
  given.name = name;
  if (!is_new) {
    learn_again(recording, first);
    return given;
  }
  SystemModel model = copy_of(*model_);
  learn(model, recording, first, given);
  model_ = std::make_shared<const SystemModel>(std::move(model));
  return given;
}

void Teacher::learn_again(const Recording& recording, std::size_t first) {
  SystemModel model = copy_of(*untaught_);
  for (TaughtName& one : names_) learn(model, recording, first, one);
  model_ = std::make_shared<const SystemModel>(std::move(model));
}

void Teacher::take_back(const Recording& recording, std::size_t exploration, std::size_t first) {
  std::erase_if(names_, [&](const TaughtName& one) { return one.exploration == exploration; });
  if (names_.empty()) return forget();
  learn_again(recording, first);
}

void Teacher::settle_before(std::size_t kept, const Recording& recording, std::size_t first) {
  const auto last = std::find_if(names_.rbegin(), names_.rend(),
                                 [&](const TaughtName& one) { return one.exploration < kept; });
  const auto settled = last.base();
  if (settled == names_.end()) {
    untaught_ = model_;
  } else if (settled != names_.begin()) {
    SystemModel model = copy_of(*untaught_);
    for (auto one = names_.begin(); one != settled; ++one) learn(model, recording, first, *one);
    untaught_ = std::make_shared<const SystemModel>(std::move(model));
  }
  names_.erase(names_.begin(), settled);
}

void Teacher::forget() {
  model_ = untaught_;
  names_.clear();
}

}  // namespace somato::live
