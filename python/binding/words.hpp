#pragma once

#include "io/option_words.hpp"
#include "microslip/railway/geometry/wheelset_contact.hpp"

#include <pybind11/pybind11.h>

namespace microslip::python {

/// Name of an option in messages; none of what is no option.
template <class Option> constexpr const char* field_of = nullptr;
template <> inline constexpr const char* field_of<TractionBound> = "bound";
template <> inline constexpr const char* field_of<FlexibilityModel> = "flexibility";
template <> inline constexpr const char* field_of<CreepageTable> = "coefficients";
template <> inline constexpr const char* field_of<Precision> = "precision";
template <> inline constexpr const char* field_of<RollingDirection> = "direction";
template <> inline constexpr const char* field_of<ContactMotion> = "kind";
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
template <> inline constexpr const char* field_of<TrackSide> = "side";

template <class Option> constexpr bool is_word = field_of<Option> != nullptr;

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

template <class Option>
class type_caster<Option, std::enable_if_t<microslip::python::is_word<Option>>>
    : public microslip::python::WordCaster<Option> {};

} // namespace pybind11::detail
