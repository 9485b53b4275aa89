#pragma once

#include <cstddef>

#include "somato/bodies/object.h"
#include "somato/core/result.h"
#include "somato/recording/recording.h"

namespace somato {

/// An exploration with true values of an object, as one of a table of objects in which the object
/// has this number, from 0, and this name: its labels are those of the table's object, and sense()
/// gives it the noise that an exploration of the table has. Errors: kUsage without true values;
/// kData for true values that `explore` does not write.
Result<Exploration> as_thing(const Exploration& explored, const Object& object, std::size_t thing);

}  // namespace somato
