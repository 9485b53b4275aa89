#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "somato/graph/system_model.h"
#include "somato/recording/recording.h"
#include "views/session/reading_sink.h"

namespace somato::live {

/// A system that learns the names that explorations are given in a session. Used by one thread; the
/// models do not change, so that other threads may read them.
class Teacher {
 public:
  /// `model` has an answer.
  explicit Teacher(std::shared_ptr<const SystemModel> model)
      : untaught_(model), model_(std::move(model)) {}

  /// The model with all names that it was taught.
  const std::shared_ptr<const SystemModel>& model() const { return model_; }

  /// The names in the order in which they were learned, each of another exploration.
  const std::vector<TaughtName>& names() const { return names_; }

  /// Teaches the name of an exploration of `recording`, whose first one has the index `first`.
  /// Another name for the same exploration replaces the earlier one, as if that had never been
  /// given.
  const TaughtName& teach(const Recording& recording, std::size_t exploration,
                          const std::string& name, std::size_t first = 0);

  /// Forgets the name of one exploration of `recording`, as if it had never been given.
  void take_back(const Recording& recording, std::size_t exploration, std::size_t first = 0);

  /// The explorations before `kept` will no longer be in `recording`: their names, and those that
  /// were learned before them, become a part of the model that is not replaced or forgotten.
  void settle_before(std::size_t kept, const Recording& recording, std::size_t first);

  /// Returns to the model without these names.
  void forget();

 private:
  void learn_again(const Recording& recording, std::size_t first);

  std::shared_ptr<const SystemModel> untaught_;
  std::shared_ptr<const SystemModel> model_;
  std::vector<TaughtName> names_;
};

}  // namespace somato::live
