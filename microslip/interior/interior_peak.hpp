#pragma once

#include "microslip/interior/interior_field.hpp"

#include <span>

namespace microslip {

/// One number from a stress, such as von_mises.
using StressMeasure = double (*)(const Stress&);

struct InteriorPeak {
  double value = 0;
  InteriorPoint point;
  InteriorState state;
};

/// The largest value of a measure and where it is: the best point of the planes `depths` [m], ascending, from which a
/// compass search goes on, with steps of half an element and half the distance to the next plane, down to a thousandth
/// of these, within the depths and the grid of the layers. The value is then right to about 1e-6, the point to a
/// thousandth of an element. It is a local maximum, the largest one if the planes are close enough. With depths.front()
/// below an element's size it may be one of the steps between elements. Throws Error if there are no depths, and
/// Stopped where `progress` returns false.
InteriorPeak find_largest(InteriorLayers& layers, std::span<const double> depths, StressMeasure measure,
                          const Progress& progress = {});

} // namespace microslip
