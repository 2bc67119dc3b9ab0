#pragma once

#include "io/option_words.hpp"
#include "microslip/railway/wheelset_contact.hpp"

#include <pybind11/pybind11.h>

namespace microslip::python {

/// Name of an option in messages.
template <class Option> constexpr const char* field_of = "option";
template <> inline constexpr const char* field_of<TractionBound> = "bound";
template <> inline constexpr const char* field_of<FlexibilityModel> = "flexibility";
template <> inline constexpr const char* field_of<CreepageTable> = "coefficients";
template <> inline constexpr const char* field_of<Precision> = "precision";
template <> inline constexpr const char* field_of<RollingDirection> = "direction";
template <> inline constexpr const char* field_of<ContactMotion> = "motion";
template <> inline constexpr const char* field_of<Discretisation> = "discretisation";
template <> inline constexpr const char* field_of<ElementShape> = "elements";
template <> inline constexpr const char* field_of<Coupling> = "coupling";
template <> inline constexpr const char* field_of<SlipStart> = "slip_start";
template <> inline constexpr const char* field_of<Theory> = "theory";
template <> inline constexpr const char* field_of<ProfileRole> = "kind";
template <> inline constexpr const char* field_of<io::ProfileFormat> = "format";
template <> inline constexpr const char* field_of<io::LateralSense> = "y_axis";
template <> inline constexpr const char* field_of<io::VerticalSense> = "z_axis";
template <> inline constexpr const char* field_of<RollRule> = "roll";

/// Options are words in Python, those of the case files.
template <class Option> class WordCaster {
public:
  PYBIND11_TYPE_CASTER(Option, pybind11::detail::const_name("str"));

  bool load(pybind11::handle source, bool) {
    if (!PyUnicode_Check(source.ptr())) return false;
    value = io::from_word<Option>(field_of<Option>, source.cast<std::string>());
    return true;
  }
  static pybind11::handle cast(Option option, pybind11::return_value_policy, pybind11::handle) {
    return pybind11::str(std::string(io::to_word(option))).release();
  }
};

} // namespace microslip::python

namespace pybind11::detail {

template <>
class type_caster<microslip::TractionBound> : public microslip::python::WordCaster<microslip::TractionBound> {};
template <>
class type_caster<microslip::FlexibilityModel> : public microslip::python::WordCaster<microslip::FlexibilityModel> {};
template <>
class type_caster<microslip::CreepageTable> : public microslip::python::WordCaster<microslip::CreepageTable> {};
template <> class type_caster<microslip::Precision> : public microslip::python::WordCaster<microslip::Precision> {};
template <>
class type_caster<microslip::RollingDirection> : public microslip::python::WordCaster<microslip::RollingDirection> {};
template <>
class type_caster<microslip::ContactMotion> : public microslip::python::WordCaster<microslip::ContactMotion> {};
template <>
class type_caster<microslip::Discretisation> : public microslip::python::WordCaster<microslip::Discretisation> {};
template <>
class type_caster<microslip::ElementShape> : public microslip::python::WordCaster<microslip::ElementShape> {};
template <> class type_caster<microslip::Coupling> : public microslip::python::WordCaster<microslip::Coupling> {};
template <> class type_caster<microslip::SlipStart> : public microslip::python::WordCaster<microslip::SlipStart> {};
template <> class type_caster<microslip::Theory> : public microslip::python::WordCaster<microslip::Theory> {};
template <> class type_caster<microslip::ProfileRole> : public microslip::python::WordCaster<microslip::ProfileRole> {};
template <>
class type_caster<microslip::io::ProfileFormat> : public microslip::python::WordCaster<microslip::io::ProfileFormat> {};
template <>
class type_caster<microslip::io::LateralSense> : public microslip::python::WordCaster<microslip::io::LateralSense> {};
template <>
class type_caster<microslip::io::VerticalSense> : public microslip::python::WordCaster<microslip::io::VerticalSense> {};
template <> class type_caster<microslip::RollRule> : public microslip::python::WordCaster<microslip::RollRule> {};

} // namespace pybind11::detail
