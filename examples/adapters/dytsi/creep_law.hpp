/// Creep laws for DYTSI's wheels, called through microslip's C interface. Needs no more than C++11, as DYTSI does.

#ifndef MICROSLIP_DYTSI_CREEP_LAW_HPP
#define MICROSLIP_DYTSI_CREEP_LAW_HPP

#include <memory>
#include <string>
#include <vector>

/// Contact of a wheel as DYTSI knows it, in SI units. Signs are those of microslip: positive creepages give negative
/// forces.
struct WheelContact {
  double a, b;                        ///< semi-axes of the ellipse, along the rolling direction and lateral [m]
  double c11, c22, c23;               ///< Kalker's coefficients from the table of contact geometry [-]
  double shear_modulus;               ///< G [Pa]
  double friction;                    ///< coefficient of friction [-]
  double normal_force;                ///< [N]
  double longitudinal, lateral, spin; ///< creepages [-], [-], [1/m]
};

/// Forces on a wheel in its contact plane [N].
struct CreepForces {
  double longitudinal, lateral;
};

/// Law by which creepages give forces. A call may throw std::runtime_error, with the reason in words.
class CreepLaw {
public:
  virtual ~CreepLaw() = default;
  virtual CreepForces forces(const WheelContact& contact) = 0;
};

/// Names of the laws that make_creep_law knows.
std::vector<std::string> creep_law_names();

/// Makes a law by its name. Throws std::invalid_argument for an unknown name, with those that there are, and
/// std::runtime_error where a table cannot be read.
/// - `shen_hedrick_elkins`: Kalker's linear forces with the coefficients of the contact, bent to the bound (Shen,
///   Hedrick & Elkins, 1983): DYTSI's law, written here from its formula
/// - `fastsim2`: simplified theory, 10 x 10 cells
/// - `table`: creep-force table, whose file the environment variable MICROSLIP_CREEP_TABLE names
/// - `exact`: exact theory of elastic half-spaces, 24 x 24 elements, solved at every call
std::unique_ptr<CreepLaw> make_creep_law(const std::string& name);

/// Law that replace_creep_forces applies from now on, and the shear modulus [Pa] that it is given in place of DYTSI's,
/// unless that is 0. Without a law, which is nullptr, forces stay DYTSI's. Not while a simulation runs in another
/// thread.
void use_creep_law(std::unique_ptr<CreepLaw> law, double shear_modulus);

/// Replaces the two forces that DYTSI has found for a contact by those of the law in use: that of use_creep_law or, if
/// it was not called, of the environment variables MICROSLIP_CREEP_LAW and MICROSLIP_SHEAR_MODULUS.
void replace_creep_forces(const WheelContact& contact, double forces[2]);

#endif
