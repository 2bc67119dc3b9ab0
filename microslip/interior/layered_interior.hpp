#pragma once

#include "microslip/contact/contact_solution.hpp"
#include "microslip/elasticity/layered_body.hpp"
#include "microslip/interior/interior_field.hpp"
#include "microslip/progress.hpp"

#include <vector>

namespace microslip {

/// The largest von Mises stress in a layer or a substrate.
struct LayerPeak {
  Body body;
  int layer;           ///< 0 at the surface; the number of layers: the substrate
  double von_mises;    ///< [Pa]
  InteriorPoint place; ///< within the layer; on its top 1e-9 deeper than the interface
};

/// The largest stresses between a layer and what is below.
struct InterfacePeak {
  Body body;
  int layer;    ///< the one above the interface
  double shear; ///< the root of sigma_xz^2 + sigma_yz^2 [Pa]
  InteriorPoint shear_place;
  double tension;              ///< sigma_zz [Pa]; 0 if the layers are pressed together all over
  InteriorPoint tension_place; ///< where there is tension
};

struct LayeredPeaks {
  std::vector<LayerPeak> layers;         ///< of body 1 from its surface inwards, then of body 2; not of rigid ones
  std::vector<InterfacePeak> interfaces; ///< likewise
};

/// What loads the layers of two bodies and the bonds between them. States are those of InteriorField at elements'
/// centres and beyond the elements, as far as it is deep, at interfaces three times that and half the contact's width.
/// Planes of a layer have distances of an eighth of the contact's half-width or a third of the depth; parabolas in and
/// across them tell where to look next, down to 3 % of that. Deeper than 12 elements elements are joined, as many as
/// are a twelfth of the depth, to find the place, at which the value is then that of all. Accuracy some 0.1 % of the
/// value, nearer than two elements to the surface 0.5 %; nearer than one it is that of the tractions there.
///
/// Cost some 15 planes for each layer (InteriorLayers), 10 ms each on 1000 elements and 0.3 s of viscoelastic
/// layers. Throws Error as InteriorField does, Stopped where `progress` returns false.
LayeredPeaks layered_peaks(const LayeredBodies& bodies, const ElementGrid& elements, const SurfaceTractions& tractions,
                           const Progress& progress = {});

/// The same of a solution on constant elements. Throws Error for one without pressures.
LayeredPeaks layered_peaks(const LayeredBodies& bodies, const ContactSolution& solution, const Progress& progress = {});

} // namespace microslip
