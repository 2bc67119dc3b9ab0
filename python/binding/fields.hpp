#pragma once

#include "binding/grid.hpp"
#include "microslip/contact/contact_solution.hpp"
#include "microslip/contact/warnings.hpp"
#include "microslip/elasticity/hertz.hpp"
#include "microslip/elasticity/layered_body.hpp"
#include "microslip/elasticity/viscoelastic.hpp"
#include "microslip/friction/temperature_effect.hpp"
#include "microslip/interior/interior_peak.hpp"
#include "microslip/rolling/accurate_contact.hpp"
#include "microslip/simplified/creepage_coefficients.hpp"
#include "microslip/thermal/surface_temperature.hpp"

#include <string_view>
#include <tuple>

namespace microslip::python {

/// A member of a class with its name.
template <class Member> struct Field {
  std::string_view name;
  Member member;
};
template <class Member> Field(std::string_view, Member) -> Field<Member>;

namespace detail {

/// The name of a member, as the compiler writes it.
template <auto member> constexpr std::string_view name_of() {
  const std::string_view text = __PRETTY_FUNCTION__; // "... member = &Class::name]", or a semicolon and more
  const auto begin = text.find("member = ");
  const auto name = text.substr(begin, text.find_first_of(";]", begin) - begin);
  return name.substr(name.rfind("::") + 2);
}

} // namespace detail

/// Members under their own names.
template <auto... member> inline constexpr auto members = std::tuple{Field{detail::name_of<member>(), member}...};

/// The members that make up a value of a class: what copies, pickles and comparisons know of it.
template <class T> inline constexpr int fields = 0;
template <class T>
concept has_fields = !std::is_same_v<decltype(fields<T>), const int>;

template <> inline constexpr auto fields<Material> = members<&Material::shear_modulus, &Material::poisson_ratio>;
template <>
inline constexpr auto fields<CombinedMaterial> =
    members<&CombinedMaterial::shear_modulus, &CombinedMaterial::poisson_ratio, &CombinedMaterial::dissimilarity>;
template <> inline constexpr auto fields<GapCurvatures> = members<&GapCurvatures::x, &GapCurvatures::y>;
template <>
inline constexpr auto fields<HertzContact> =
    members<&HertzContact::a, &HertzContact::b, &HertzContact::normal_force, &HertzContact::approach,
            &HertzContact::peak_pressure, &HertzContact::stiffness, &HertzContact::gap>;
template <>
inline constexpr auto fields<LineContact> = members<&LineContact::half_width, &LineContact::force_per_length,
                                                    &LineContact::peak_pressure, &LineContact::curvature>;

template <>
inline constexpr auto fields<InterfaceLayer> =
    members<&InterfaceLayer::flexibility, &InterfaceLayer::yield_stress, &InterfaceLayer::hardening>;
template <> inline constexpr auto fields<MaterialCreep> = members<&MaterialCreep::ratio, &MaterialCreep::time>;
template <> inline constexpr auto fields<Retardation> = members<&Retardation::ratio, &Retardation::distance>;
template <> inline constexpr auto fields<RetardedPart> = members<&RetardedPart::material, &RetardedPart::retardation>;
template <> inline constexpr auto fields<Bodies> = members<&Bodies::material, &Bodies::retarded, &Bodies::layer>;
template <> inline constexpr auto fields<PronyTerm> = members<&PronyTerm::share, &PronyTerm::time>;
template <>
inline constexpr auto fields<ViscoelasticMaterial> =
    members<&ViscoelasticMaterial::instantaneous, &ViscoelasticMaterial::shear_relaxation,
            &ViscoelasticMaterial::bulk_relaxation>;
template <> inline constexpr auto fields<BodyLayer> = members<&BodyLayer::thickness, &BodyLayer::material>;
template <> inline constexpr auto fields<LayeredBody> = members<&LayeredBody::layers, &LayeredBody::substrate>;
template <>
inline constexpr auto fields<LayeredBodies> =
    members<&LayeredBodies::body1, &LayeredBodies::body2, &LayeredBodies::speed>;
template <>
inline constexpr auto fields<ThermalBody> = members<&ThermalBody::bulk_temperature, &ThermalBody::conductivity,
                                                    &ThermalBody::density, &ThermalBody::heat_capacity>;
template <>
inline constexpr auto fields<TemperatureEffect> =
    members<&TemperatureEffect::change, &TemperatureEffect::begin, &TemperatureEffect::range>;

template <> inline constexpr auto fields<Warnings> = members<&Warnings::code>;

template <>
inline constexpr auto fields<Creepage> = members<&Creepage::longitudinal, &Creepage::lateral, &Creepage::spin>;
template <>
inline constexpr auto fields<CreepageCoefficients> = members<&CreepageCoefficients::c11, &CreepageCoefficients::c22,
                                                             &CreepageCoefficients::c23, &CreepageCoefficients::c33>;
template <>
inline constexpr auto fields<EllipticContact> =
    members<&EllipticContact::a, &EllipticContact::b, &EllipticContact::shear_modulus, &EllipticContact::poisson_ratio,
            &EllipticContact::normal_force, &EllipticContact::friction, &EllipticContact::creepage,
            &EllipticContact::rolling_speed, &EllipticContact::dissimilarity>;
template <>
inline constexpr auto fields<ContactForces> =
    members<&ContactForces::fx, &ContactForces::fy, &ContactForces::mz, &ContactForces::adhesion_area,
            &ContactForces::slip_area, &ContactForces::status>;
template <>
inline constexpr auto fields<ContactDerivatives> = members<&ContactDerivatives::forces, &ContactDerivatives::jacobian>;

template <>
inline constexpr auto fields<ElementGrid> =
    members<&ElementGrid::mx, &ElementGrid::my, &ElementGrid::x0, &ElementGrid::y0, &ElementGrid::dx, &ElementGrid::dy,
            &ElementGrid::line, &ElementGrid::shape>;
template <>
inline constexpr auto fields<Elements> =
    members<&Elements::grid, &Elements::x, &Elements::y, &Elements::width, &Elements::area>;
template <> inline constexpr auto fields<VectorField> = members<&VectorField::x, &VectorField::y>;
template <>
inline constexpr auto fields<SurfaceFields> =
    members<&SurfaceFields::traction, &SurfaceFields::slip, &SurfaceFields::displacement, &SurfaceFields::bound,
            &SurfaceFields::state, &SurfaceFields::pressure, &SurfaceFields::gap, &SurfaceFields::friction,
            &SurfaceFields::temperature1, &SurfaceFields::temperature2>;
template <>
inline constexpr auto fields<Totals> =
    members<&Totals::fx, &Totals::fy, &Totals::mz, &Totals::my, &Totals::adhesion_area, &Totals::slip_area,
            &Totals::frictional_power, &Totals::power_by_creepage, &Totals::elastic_energy, &Totals::peak_pressure,
            &Totals::peak_traction>;
template <>
inline constexpr auto fields<SolverReport> =
    members<&SolverReport::status, &SolverReport::reason, &SolverReport::residual, &SolverReport::newton_steps,
            &SolverReport::products, &SolverReport::estimated_error>;
template <>
inline constexpr auto fields<SolutionStep> =
    members<&SolutionStep::creepage, &SolutionStep::totals, &SolutionStep::report>;
template <>
inline constexpr auto fields<ContactSolution> =
    members<&ContactSolution::motion, &ContactSolution::elements, &ContactSolution::fields, &ContactSolution::creepage,
            &ContactSolution::approach, &ContactSolution::highest_temperature, &ContactSolution::totals,
            &ContactSolution::report, &ContactSolution::history>;

template <>
inline constexpr auto fields<BorderSides> =
    members<&BorderSides::low_x, &BorderSides::high_x, &BorderSides::low_y, &BorderSides::high_y>;
template <>
inline constexpr auto fields<NormalSolution> =
    members<&NormalSolution::pressure, &NormalSolution::displacement, &NormalSolution::gap, &NormalSolution::approach,
            &NormalSolution::normal_force, &NormalSolution::elastic_energy, &NormalSolution::peak_pressure,
            &NormalSolution::contact_elements, &NormalSolution::touches_border, &NormalSolution::border,
            &NormalSolution::residual, &NormalSolution::iterations, &NormalSolution::products, &NormalSolution::status>;
template <> inline constexpr auto fields<NormalResult> = members<&NormalResult::solution, &NormalResult::shape>;
template <> inline constexpr auto fields<TangentialResult> = members<&TangentialResult::solution>;

template <>
inline constexpr auto fields<ExactDerivatives> = members<&ExactDerivatives::solution, &ExactDerivatives::jacobian,
                                                         &ExactDerivatives::by_load, &ExactDerivatives::products>;
template <>
inline constexpr auto fields<ForceResponse> =
    members<&ForceResponse::wavenumber, &ForceResponse::by_creepage, &ForceResponse::by_load,
            &ForceResponse::by_roughness, &ForceResponse::load_by_roughness, &ForceResponse::work_by_creepage,
            &ForceResponse::work_by_load, &ForceResponse::work_by_roughness>;
template <>
inline constexpr auto fields<FrequencyResponse> =
    members<&FrequencyResponse::solution, &FrequencyResponse::at, &FrequencyResponse::normal_stiffness,
            &FrequencyResponse::products>;
template <>
inline constexpr auto fields<AccurateContact> =
    members<&AccurateContact::finest, &AccurateContact::coarser, &AccurateContact::forces, &AccurateContact::creepage,
            &AccurateContact::error, &AccurateContact::elements, &AccurateContact::products>;

template <>
inline constexpr auto fields<Stress> =
    members<&Stress::xx, &Stress::yy, &Stress::zz, &Stress::xy, &Stress::xz, &Stress::yz>;
template <>
inline constexpr auto fields<InteriorState> =
    members<&InteriorState::ux, &InteriorState::uy, &InteriorState::uz, &InteriorState::stress>;
template <>
inline constexpr auto fields<InteriorPoint> = members<&InteriorPoint::x, &InteriorPoint::y, &InteriorPoint::depth>;
template <>
inline constexpr auto fields<InteriorPeak> = members<&InteriorPeak::value, &InteriorPeak::point, &InteriorPeak::state>;

} // namespace microslip::python
