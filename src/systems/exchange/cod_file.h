#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "somato/core/result.h"
#include "somato/graph/som_model.h"

namespace somato {

/// A map that another program has trained.
struct ImportedMap {
  SomModel model;
  /// Sentences without a full stop about content of the file that the model does not contain.
  std::vector<std::string> notes = {};
};

/// Whether `bytes` begin like a codebook of SOM_PAK: with a line of a number, `rect` or `hexa`.
bool is_cod(std::string_view bytes);

/// The map in the bytes of a codebook of SOM_PAK or SOM Toolbox (`.cod`), from the source `where`.
///
/// The first line has the number of components, the lattice (`rect` or `hexa`), the sizes in x and
/// y, and the neighbourhood. Each further line has the components of a unit, separated by blanks,
/// and its labels; units with y = 0 come first, x from 0. A line that begins with `#n` has the
/// names of the components; other lines that begins with `#` are comments. A unit's first label
/// becomes its class; names that are not one for each component, further labels, and a
/// neighbourhood that is not known are left out with a note. Errors (kData, with the line): other
/// content, a number that is not a finite float32, another number of units. Source: som_read_cod in
/// the documentation of SOM Toolbox 2.0 (Vesanto, Himberg, Alhoniemi and Parhankangas, 2000), and
/// section 4.1 of the documentation of SOM_PAK 3.1 (Kohonen, Hynninen, Kangas and Laaksonen, 1995).
///
/// `parameters` has what the file does not contain, such as the topology.
Result<ImportedMap> map_in_cod(std::string_view bytes, const std::string& where,
                               const SomParameters& parameters = {});

}  // namespace somato
