#pragma once

namespace microslip {

/// A linearly elastic, isotropic body.
struct Material {
  double shear_modulus; ///< G [Pa], > 0; infinite for a rigid body
  double poisson_ratio; ///< nu [-], in [0, 0.5]

  /// Material of Young's modulus E [Pa], > 0, infinite if rigid: G = E/(2 (1 + nu)). Throws Error if out of range.
  static Material from_young(double young_modulus, double poisson_ratio);

  friend bool operator==(const Material&, const Material&) = default;
};

/// The constants of two bodies in contact, as half-space theory needs them (Kalker 1990, section 1.6; (E4)):
/// 1/G = (1/G1 + 1/G2)/2, nu/G = (nu1/G1 + nu2/G2)/2, K/G = ((1 - 2 nu1)/G1 - (1 - 2 nu2)/G2)/4.
struct CombinedMaterial {
  double shear_modulus; ///< G [Pa]
  double poisson_ratio; ///< nu [-]
  double dissimilarity; ///< K [-]; 0 for elastically similar bodies, whose normal and tangential problems are uncoupled

  /// E* = G/(1 - nu) [Pa], with 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2.
  double contact_modulus() const { return shear_modulus / (1 - poisson_ratio); }

  friend bool operator==(const CombinedMaterial&, const CombinedMaterial&) = default;
};

/// Combines two bodies; with w1 = G2/(G1 + G2), w2 = G1/(G1 + G2) the three read G = 2 w1 G1, nu = w1 nu1 + w2 nu2,
/// K = (w1 (1 - 2 nu1) - w2 (1 - 2 nu2))/2. Two equal bodies give their constants and K = 0 exactly. Throws Error
/// if a modulus or Poisson's ratio is out of range or both bodies are rigid.
CombinedMaterial combine(const Material& body1, const Material& body2);

} // namespace microslip
