#pragma once

#include "binding/grid.hpp"
#include "microslip/contact/contact_solution.hpp"
#include "microslip/elasticity/hertz.hpp"
#include "microslip/elasticity/viscoelastic.hpp"
#include "microslip/friction/temperature_effect.hpp"
#include "microslip/interior/interior_peak.hpp"
#include "microslip/rolling/accurate_contact.hpp"
#include "microslip/simplified/creepage_coefficients.hpp"
#include "microslip/thermal/surface_temperature.hpp"

#include <tuple>

namespace microslip::python {

/// A member of a class with its name.
template <class Member> struct Field {
  const char* name;
  Member member;
};
template <class Member> Field(const char*, Member) -> Field<Member>;

/// The members that make up a value of a class: what copies, pickles and comparisons know of it.
template <class T> inline constexpr int fields = 0;
template <class T>
concept has_fields = !std::is_same_v<decltype(fields<T>), const int>;

template <>
inline constexpr auto fields<Material> =
    std::tuple{Field{"shear_modulus", &Material::shear_modulus}, Field{"poisson_ratio", &Material::poisson_ratio}};
template <>
inline constexpr auto fields<CombinedMaterial> = std::tuple{Field{"shear_modulus", &CombinedMaterial::shear_modulus},
                                                            Field{"poisson_ratio", &CombinedMaterial::poisson_ratio},
                                                            Field{"dissimilarity", &CombinedMaterial::dissimilarity}};
template <>
inline constexpr auto fields<GapCurvatures> = std::tuple{Field{"x", &GapCurvatures::x}, Field{"y", &GapCurvatures::y}};
template <>
inline constexpr auto fields<HertzContact> = std::tuple{Field{"a", &HertzContact::a},
                                                        Field{"b", &HertzContact::b},
                                                        Field{"normal_force", &HertzContact::normal_force},
                                                        Field{"approach", &HertzContact::approach},
                                                        Field{"peak_pressure", &HertzContact::peak_pressure},
                                                        Field{"stiffness", &HertzContact::stiffness},
                                                        Field{"gap", &HertzContact::gap}};
template <>
inline constexpr auto fields<LineContact> =
    std::tuple{Field{"half_width", &LineContact::half_width}, Field{"force_per_length", &LineContact::force_per_length},
               Field{"peak_pressure", &LineContact::peak_pressure}, Field{"curvature", &LineContact::curvature}};

template <>
inline constexpr auto fields<InterfaceLayer> =
    std::tuple{Field{"flexibility", &InterfaceLayer::flexibility}, Field{"yield_stress", &InterfaceLayer::yield_stress},
               Field{"hardening", &InterfaceLayer::hardening}};
template <>
inline constexpr auto fields<MaterialCreep> =
    std::tuple{Field{"ratio", &MaterialCreep::ratio}, Field{"time", &MaterialCreep::time}};
template <>
inline constexpr auto fields<Retardation> =
    std::tuple{Field{"ratio", &Retardation::ratio}, Field{"distance", &Retardation::distance}};
template <>
inline constexpr auto fields<RetardedPart> =
    std::tuple{Field{"material", &RetardedPart::material}, Field{"retardation", &RetardedPart::retardation}};
template <>
inline constexpr auto fields<Bodies> = std::tuple{Field{"material", &Bodies::material},
                                                  Field{"retarded", &Bodies::retarded}, Field{"layer", &Bodies::layer}};
template <>
inline constexpr auto fields<ThermalBody> =
    std::tuple{Field{"bulk_temperature", &ThermalBody::bulk_temperature},
               Field{"conductivity", &ThermalBody::conductivity}, Field{"density", &ThermalBody::density},
               Field{"heat_capacity", &ThermalBody::heat_capacity}};
template <>
inline constexpr auto fields<TemperatureEffect> =
    std::tuple{Field{"change", &TemperatureEffect::change}, Field{"begin", &TemperatureEffect::begin},
               Field{"range", &TemperatureEffect::range}};

template <>
inline constexpr auto fields<Creepage> =
    std::tuple{Field{"longitudinal", &Creepage::longitudinal}, Field{"lateral", &Creepage::lateral},
               Field{"spin", &Creepage::spin}};
template <>
inline constexpr auto fields<CreepageCoefficients> =
    std::tuple{Field{"c11", &CreepageCoefficients::c11}, Field{"c22", &CreepageCoefficients::c22},
               Field{"c23", &CreepageCoefficients::c23}, Field{"c33", &CreepageCoefficients::c33}};
template <>
inline constexpr auto fields<EllipticContact> = std::tuple{Field{"a", &EllipticContact::a},
                                                           Field{"b", &EllipticContact::b},
                                                           Field{"shear_modulus", &EllipticContact::shear_modulus},
                                                           Field{"poisson_ratio", &EllipticContact::poisson_ratio},
                                                           Field{"normal_force", &EllipticContact::normal_force},
                                                           Field{"friction", &EllipticContact::friction},
                                                           Field{"creepage", &EllipticContact::creepage},
                                                           Field{"rolling_speed", &EllipticContact::rolling_speed},
                                                           Field{"dissimilarity", &EllipticContact::dissimilarity}};
template <>
inline constexpr auto fields<ContactForces> = std::tuple{Field{"fx", &ContactForces::fx},
                                                         Field{"fy", &ContactForces::fy},
                                                         Field{"mz", &ContactForces::mz},
                                                         Field{"adhesion_area", &ContactForces::adhesion_area},
                                                         Field{"slip_area", &ContactForces::slip_area},
                                                         Field{"status", &ContactForces::status}};
template <>
inline constexpr auto fields<ContactDerivatives> =
    std::tuple{Field{"forces", &ContactDerivatives::forces}, Field{"jacobian", &ContactDerivatives::jacobian}};

template <>
inline constexpr auto fields<ElementGrid> =
    std::tuple{Field{"mx", &ElementGrid::mx},     Field{"my", &ElementGrid::my},      Field{"x0", &ElementGrid::x0},
               Field{"y0", &ElementGrid::y0},     Field{"dx", &ElementGrid::dx},      Field{"dy", &ElementGrid::dy},
               Field{"line", &ElementGrid::line}, Field{"shape", &ElementGrid::shape}};
template <>
inline constexpr auto fields<Elements> =
    std::tuple{Field{"grid", &Elements::grid}, Field{"x", &Elements::x}, Field{"y", &Elements::y},
               Field{"width", &Elements::width}, Field{"area", &Elements::area}};
template <>
inline constexpr auto fields<VectorField> = std::tuple{Field{"x", &VectorField::x}, Field{"y", &VectorField::y}};
template <>
inline constexpr auto fields<SurfaceFields> = std::tuple{Field{"traction", &SurfaceFields::traction},
                                                         Field{"slip", &SurfaceFields::slip},
                                                         Field{"displacement", &SurfaceFields::displacement},
                                                         Field{"bound", &SurfaceFields::bound},
                                                         Field{"state", &SurfaceFields::state},
                                                         Field{"pressure", &SurfaceFields::pressure},
                                                         Field{"gap", &SurfaceFields::gap},
                                                         Field{"friction", &SurfaceFields::friction},
                                                         Field{"temperature1", &SurfaceFields::temperature1},
                                                         Field{"temperature2", &SurfaceFields::temperature2}};
template <>
inline constexpr auto fields<Totals> = std::tuple{Field{"fx", &Totals::fx},
                                                  Field{"fy", &Totals::fy},
                                                  Field{"mz", &Totals::mz},
                                                  Field{"my", &Totals::my},
                                                  Field{"adhesion_area", &Totals::adhesion_area},
                                                  Field{"slip_area", &Totals::slip_area},
                                                  Field{"frictional_power", &Totals::frictional_power},
                                                  Field{"power_by_creepage", &Totals::power_by_creepage},
                                                  Field{"elastic_energy", &Totals::elastic_energy},
                                                  Field{"peak_pressure", &Totals::peak_pressure},
                                                  Field{"peak_traction", &Totals::peak_traction}};
template <>
inline constexpr auto fields<SolverReport> =
    std::tuple{Field{"status", &SolverReport::status},     Field{"reason", &SolverReport::reason},
               Field{"residual", &SolverReport::residual}, Field{"newton_steps", &SolverReport::newton_steps},
               Field{"products", &SolverReport::products}, Field{"estimated_error", &SolverReport::estimated_error}};
template <>
inline constexpr auto fields<SolutionStep> =
    std::tuple{Field{"creepage", &SolutionStep::creepage}, Field{"totals", &SolutionStep::totals},
               Field{"report", &SolutionStep::report}};
template <>
inline constexpr auto fields<ContactSolution> = std::tuple{
    Field{"motion", &ContactSolution::motion},     Field{"elements", &ContactSolution::elements},
    Field{"fields", &ContactSolution::fields},     Field{"creepage", &ContactSolution::creepage},
    Field{"approach", &ContactSolution::approach}, Field{"highest_temperature", &ContactSolution::highest_temperature},
    Field{"totals", &ContactSolution::totals},     Field{"report", &ContactSolution::report},
    Field{"history", &ContactSolution::history}};

template <>
inline constexpr auto fields<BorderSides> =
    std::tuple{Field{"low_x", &BorderSides::low_x}, Field{"high_x", &BorderSides::high_x},
               Field{"low_y", &BorderSides::low_y}, Field{"high_y", &BorderSides::high_y}};
template <>
inline constexpr auto fields<NormalSolution> = std::tuple{Field{"pressure", &NormalSolution::pressure},
                                                          Field{"displacement", &NormalSolution::displacement},
                                                          Field{"gap", &NormalSolution::gap},
                                                          Field{"approach", &NormalSolution::approach},
                                                          Field{"normal_force", &NormalSolution::normal_force},
                                                          Field{"elastic_energy", &NormalSolution::elastic_energy},
                                                          Field{"peak_pressure", &NormalSolution::peak_pressure},
                                                          Field{"contact_elements", &NormalSolution::contact_elements},
                                                          Field{"touches_border", &NormalSolution::touches_border},
                                                          Field{"border", &NormalSolution::border},
                                                          Field{"residual", &NormalSolution::residual},
                                                          Field{"iterations", &NormalSolution::iterations},
                                                          Field{"products", &NormalSolution::products},
                                                          Field{"status", &NormalSolution::status}};
template <>
inline constexpr auto fields<TangentialState> =
    std::tuple{Field{"px", &TangentialState::px},
               Field{"py", &TangentialState::py},
               Field{"pressure", &TangentialState::pressure},
               Field{"friction_drop", &TangentialState::friction_drop},
               Field{"slip_velocity", &TangentialState::slip_velocity},
               Field{"plastic_deformation", &TangentialState::plastic_deformation}};
template <>
inline constexpr auto fields<TangentialSolution> =
    std::tuple{Field{"tractions", &TangentialSolution::tractions},
               Field{"bound", &TangentialSolution::bound},
               Field{"ux", &TangentialSolution::ux},
               Field{"uy", &TangentialSolution::uy},
               Field{"sx", &TangentialSolution::sx},
               Field{"sy", &TangentialSolution::sy},
               Field{"slip_direction", &TangentialSolution::slip_direction},
               Field{"state", &TangentialSolution::state},
               Field{"forces", &TangentialSolution::forces},
               Field{"creepage", &TangentialSolution::creepage},
               Field{"elastic_energy", &TangentialSolution::elastic_energy},
               Field{"frictional_power", &TangentialSolution::frictional_power},
               Field{"power_by_creepage", &TangentialSolution::power_by_creepage},
               Field{"peak_traction", &TangentialSolution::peak_traction},
               Field{"residual", &TangentialSolution::residual},
               Field{"newton_steps", &TangentialSolution::newton_steps},
               Field{"products", &TangentialSolution::products}};
template <>
inline constexpr auto fields<NormalResult> =
    std::tuple{Field{"solution", &NormalResult::solution}, Field{"shape", &NormalResult::shape}};
template <>
inline constexpr auto fields<TangentialResult> =
    std::tuple{Field{"solution", &TangentialResult::solution}, Field{"shape", &TangentialResult::shape}};

template <>
inline constexpr auto fields<ExactDerivatives> =
    std::tuple{Field{"solution", &ExactDerivatives::solution}, Field{"jacobian", &ExactDerivatives::jacobian},
               Field{"products", &ExactDerivatives::products}};
template <>
inline constexpr auto fields<AccurateContact> =
    std::tuple{Field{"finest", &AccurateContact::finest},    Field{"coarser", &AccurateContact::coarser},
               Field{"forces", &AccurateContact::forces},    Field{"creepage", &AccurateContact::creepage},
               Field{"error", &AccurateContact::error},      Field{"elements", &AccurateContact::elements},
               Field{"products", &AccurateContact::products}};

template <>
inline constexpr auto fields<Stress> =
    std::tuple{Field{"xx", &Stress::xx}, Field{"yy", &Stress::yy}, Field{"zz", &Stress::zz},
               Field{"xy", &Stress::xy}, Field{"xz", &Stress::xz}, Field{"yz", &Stress::yz}};
template <>
inline constexpr auto fields<InteriorState> =
    std::tuple{Field{"ux", &InteriorState::ux}, Field{"uy", &InteriorState::uy}, Field{"uz", &InteriorState::uz},
               Field{"stress", &InteriorState::stress}};
template <>
inline constexpr auto fields<InteriorPoint> =
    std::tuple{Field{"x", &InteriorPoint::x}, Field{"y", &InteriorPoint::y}, Field{"depth", &InteriorPoint::depth}};
template <>
inline constexpr auto fields<InteriorPeak> = std::tuple{
    Field{"value", &InteriorPeak::value}, Field{"point", &InteriorPeak::point}, Field{"state", &InteriorPeak::state}};

} // namespace microslip::python
