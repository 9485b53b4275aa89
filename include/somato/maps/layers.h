#pragma once

#include <cstddef>
#include <string>

#include "somato/core/result.h"
#include "somato/core/samples.h"
#include "somato/maps/som.h"
#include "somato/maps/som_parameters.h"

namespace somato {

// A map with layers compares each group of elements with a distance of its own. The distance of
// input x from weights w is
//
//     d(x, w) = sum over layers l of weight_l d_l(x_l, w_l) / scale_l
//
// with the distance d_l of the layer's similarity over its elements. Everything else is as for
// other maps: the distance chooses winners, and weights learn as one vector. The super-organized
// maps of Wehrens and Buydens, "Self- and super-organizing maps in R: the kohonen package", Journal
// of Statistical Software 21(5), 2007, which also describes maps of classes (XYF).

/// weight / scale; the scale counts as 1 until it is known.
double factor_of(const Layer& layer);

/// Whether the layers fit inputs of so many elements: names are different and not empty, layers
/// follow one another without a gap, distances, weights and scales are possible. Errors (kUsage);
/// also for parameters that have no effect with layers.
Result<void> check_layers(const SomParameters& parameters, std::size_t elements);

/// Refuses (kUsage) layers without a scale, and (kData) those in which all samples are alike.
Result<void> check_scales(const SomParameters& parameters);

/// The parameters with automatic scales of layers set to the mean distance between training samples
/// in the layer, so that layers of weight 1 contribute alike: over all pairs of samples, or of 300
/// that are evenly spaced in their order.
SomParameters with_scales(SomParameters parameters, const Samples& samples);

/// The layer with this name, which the others predict. Errors (kUsage): there is none, or no other.
Result<Layer> layer_named(const SomParameters& parameters, const std::string& name);

/// The prediction of a layer from the others: for each sample the weights that its winner has for
/// the layer, samples x layer.count, where the winner is the neuron at the least distance by the
/// other layers. The elements of the layer in `samples` have no effect; the others must be known.
/// Throws InvalidArgument if the sizes differ.
Matrix<float> predict_layer(const Som& som, const Layer& layer, const Samples& samples,
                            std::size_t threads = 1);

}  // namespace somato
