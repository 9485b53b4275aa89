#pragma once

#include <memory>
#include <optional>
#include <string>

#include "somato/core/result.h"
#include "somato/graph/system_model.h"
#include "somato/recording/layout.h"
#include "views/session/view_json.h"
#include "views/session/view_source.h"

namespace somato::live {

/// The map of a system that answers: the one that is named, or else its last.
Result<std::string> answering_map(const System& system, const std::string& named);

/// The description of a selected system for a page before any evaluation.
struct SystemPicture {
  Json graph;  ///< null where it cannot be built.
  Json maps = Json::array();
  std::string label;
  std::string problem;  ///< Why it cannot read what is viewed, a sentence; empty: it can.
};

/// `layout` is that of the viewed recording; without one (a body that has not explored yet) the
/// shapes that the systems declare are used.
SystemPicture picture_of(const ViewSystem& system, const std::optional<RecordingLayout>& layout);

/// An error as a sentence for a page.
std::string sentence_of(const Error& error);

}  // namespace somato::live
