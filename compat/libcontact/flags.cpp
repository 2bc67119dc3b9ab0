#include "compat/libcontact/arguments.hpp"
#include "compat/libcontact/call.hpp"
#include "compat/libcontact/defaults.hpp"

#include <algorithm>
#include <iterator>

// Control digits and data for the heads of files.

namespace microslip::libcontact {
namespace {

using namespace contact_program;

/// A flag: how its value is set and read. Those without a member change no result here; their values are kept.
struct Flag {
  int code;
  void (*set)(ContactProblem& p, int value);
  int (*get)(const ContactProblem& p);
};

/// The value as one of those that a choice has. CONTACT takes the nearest one of a range; here others are refused.
template <class Choice> Choice chosen(int value) {
  const auto& values = values_of<Choice>;
  const auto end = values.list.begin() + values.count;
  if (std::find(values.list.begin(), end, value) == end)
    throw Refusal(CNTC_err_other, std::string(values.name) + " = " + std::to_string(value) + " does not exist");
  return static_cast<Choice>(value);
}

template <auto member> void set_digit(ContactProblem& p, int value) {
  auto& digit = p.data.digits.*member;
  digit = chosen<std::remove_reference_t<decltype(digit)>>(value);
}
template <auto member> int get_digit(const ContactProblem& p) {
  return number(p.data.digits.*member);
}

WheelRailData& wheel_of(ContactProblem& p) {
  if (!p.is_wheel()) throw Refusal(CNTC_err_other, "a flag that is not for module 3");
  return p.wheel();
}

const WheelRailData& wheel_of(const ContactProblem& p) {
  if (!p.is_wheel()) throw Refusal(CNTC_err_other, "a flag that is not for module 3");
  return p.wheel();
}

void set_search(ContactProblem& p, int value) {
  const auto search = chosen<ContactSearch>(value);
  WheelRailData& d = wheel_of(p);
  if (search != ContactSearch::keep && search != ContactSearch::form) d.search = search;
}

void set_coefficients(ContactProblem& p, int value) {
  const auto coefficients = chosen<Coefficients>(value);
  if (coefficients == Coefficients::from_file)
    throw Refusal(CNTC_err_other, "C = 9 is not available in the library, as in CONTACT");
  if (coefficients == Coefficients::keep || coefficients == Coefficients::form) return;
  p.data.material->coefficients = p.data.digits.inflcf = coefficients;
}

void set_force(ContactProblem& p, int value) {
  if (p.is_wheel())
    p.wheel().digits.force = chosen<TotalForce>(value);
  else
    p.data.digits.force = chosen<Prescribed>(value);
}

void set_pressure(ContactProblem& p, int value) {
  const auto model = chosen<PressureModel>(value);
  if (model == PressureModel::thin_sheet)
    throw Refusal(CNTC_err_other, "B = 1 is not available in the library, as in CONTACT");
  p.data.digits.bound = model;
}

void set_extra_slip(ContactProblem& p, int value) {
  const auto choice = chosen<ExtraSlip>(value);
  if (choice == ExtraSlip::keep)
    p.data.extra = p.data.extra_slip.empty() ? ExtraSlip::none : ExtraSlip::by_element;
  else
    p.data.extra = choice;
}

AngleCorrection& angles_of(ContactProblem& p) {
  wheel_of(p);
  return p.data.material->correction;
}

void set_most_elements(ContactProblem& p, int value) {
  wheel_of(p);
  p.data.solver.npot_max = std::clamp(value, 100, 1000000);
}

/// O_s: CONTACT takes 3 for 2.
void set_interior_level(ContactProblem& p, int value) {
  if (value < 0 || value > 4) throw Refusal(CNTC_err_other, "O_s = " + std::to_string(value) + " does not exist");
  p.data.interior_level = value == 3 ? 2 : value;
}

void set_units(ContactProblem& p, int value) {
  if (value != CNTC_un_cntc && value != CNTC_un_spck && value != CNTC_un_si)
    throw Refusal(CNTC_err_other, "units " + std::to_string(value) + " are not supported");
  p.units = units_of(value);
  p.other_flags[CNTC_if_units] = value;
}

[[noreturn]] void refuse_read_only(ContactProblem&, int) {
  throw Refusal(CNTC_err_other, "a flag that has a separate function: L, M and H are set with their data");
}

constexpr Flag flags[] = {
    {CNTC_ic_config, [](ContactProblem& p, int v) { wheel_of(p).digits.config = chosen<Config>(v); },
     [](const ContactProblem& p) { return number(wheel_of(p).digits.config); }},
    {CNTC_ic_pvtime, set_digit<&Digits::pvtime>, get_digit<&Digits::pvtime>},
    {CNTC_ic_bound, set_pressure, get_digit<&Digits::bound>},
    {CNTC_ic_tang, set_digit<&Digits::tang>, get_digit<&Digits::tang>},
    {CNTC_ic_norm, set_digit<&Digits::norm>, get_digit<&Digits::norm>},
    {CNTC_ic_force, set_force,
     [](const ContactProblem& p) {
       return p.is_wheel() ? number(p.wheel().digits.force) : number(p.data.digits.force);
     }},
    {CNTC_ic_frclaw, refuse_read_only, [](const ContactProblem& p) { return number(p.data.friction.law); }},
    {CNTC_ic_discns, set_search, [](const ContactProblem& p) { return number(wheel_of(p).search); }},
    {CNTC_ic_inflcf, set_coefficients, get_digit<&Digits::inflcf>},
    {CNTC_ic_mater, refuse_read_only, get_digit<&Digits::mater>},
    {CNTC_ic_exrhs, set_extra_slip, [](const ContactProblem& p) { return number(p.data.extra); }},
    {CNTC_ic_heat, refuse_read_only, get_digit<&Digits::heat>},
    {CNTC_ic_iestim, set_digit<&Digits::iestim>, get_digit<&Digits::iestim>},
    {CNTC_ic_return, set_digit<&Digits::solve>, get_digit<&Digits::solve>},
    {CNTC_ic_matfil, set_digit<&Digits::matfil>, get_digit<&Digits::matfil>},
    {CNTC_ic_output, set_digit<&Digits::output>, get_digit<&Digits::output>},
    {CNTC_ic_flow, set_digit<&Digits::flow>, get_digit<&Digits::flow>},
    {CNTC_ic_sbsfil, [](ContactProblem& p, int v) { p.data.subs_file = chosen<SubsFile>(v); },
     [](const ContactProblem& p) { return number(p.data.subs_file); }},
    {CNTC_ic_sbsout, set_interior_level, [](const ContactProblem& p) { return p.data.interior_level; }},
    {CNTC_ic_sens, [](ContactProblem& p, int v) { p.sensitivity.of = std::clamp(v, 0, 3); },
     [](const ContactProblem& p) { return p.sensitivity.of; }},
    {CNTC_ic_ifmeth, [](ContactProblem& p, int v) { angles_of(p).method = std::clamp(v, 0, 1); },
     [](const ContactProblem& p) { return p.data.material->correction.method; }},
    {CNTC_ic_ifvari, [](ContactProblem& p, int v) { angles_of(p).variant = std::clamp(v, 1, 4); },
     [](const ContactProblem& p) { return p.data.material->correction.variant; }},
    {CNTC_ic_npomax, set_most_elements, [](const ContactProblem& p) { return p.data.solver.npot_max; }},
    {CNTC_if_units, set_units,
     [](const ContactProblem& p) {
       const auto found = p.other_flags.find(CNTC_if_units);
       return found == p.other_flags.end() ? default_flag(CNTC_if_units) : found->second;
     }},
    {CNTC_if_ncase, refuse_read_only, [](const ContactProblem& p) { return p.calculations(); }},
};

/// Flags without effect on results: whether a case is written as input, and what CONTACT traces.
constexpr int other_flags[] = {CNTC_if_wrtinp, CNTC_ic_xflow,  CNTC_if_idebug,
                               CNTC_if_licdbg, CNTC_if_openmp, CNTC_if_timers};

bool has(std::span<const int> list, int code) {
  return std::find(list.begin(), list.end(), code) != list.end();
}

const Flag* find(int code) {
  const auto* const found =
      std::find_if(std::begin(flags), std::end(flags), [&](const Flag& f) { return f.code == code; });
  return found == std::end(flags) ? nullptr : found;
}

void set_flag(ContactProblem& p, int code, int value) {
  if (const Flag* flag = find(code)) {
    flag->set(p, value);
    return;
  }
  if (!has(other_flags, code)) throw Refusal(CNTC_err_other, "there is no flag " + std::to_string(code));
  p.other_flags[code] = value;
}

int flag_of(const ContactProblem& p, int code) {
  if (const Flag* flag = find(code)) return flag->get(p);
  if (!has(other_flags, code)) throw Refusal(CNTC_err_other, "there is no flag " + std::to_string(code));
  const auto found = p.other_flags.find(code);
  return found == p.other_flags.end() ? default_flag(code) : found->second;
}

/// Deals with each flag that it can; the code is that of the first one that it cannot.
template <class Deal> int each_flag(const Call& call, std::span<const int> codes, Deal deal) {
  int first = 0;
  for (std::size_t k = 0; k < codes.size(); ++k) {
    if (codes[k] == 0) continue;
    const int code = guarded_body(call, [&] { deal(k); });
    if (first == 0) first = code;
  }
  return first;
}

} // namespace

extern "C" {

int cntc_setflags(int* ire, int* icp, int* lenflg, int* params, int* values) {
  const Call call = problem_call(__func__, ire, icp);
  return guarded(call, [&](ContactProblem& p) {
    const auto codes = integers("params", lenflg, params), settings = integers("values", lenflg, values);
    return each_flag(call, codes, [&](std::size_t k) { set_flag(p, codes[k], settings[k]); });
  });
}

int cntc_getflags(int* ire, int* icp, int* lenflg, int* params, int* values) {
  int of_flags = 0;
  const Call call = either_call(__func__, ire, icp);
  const int code = answered(call, into(results(lenflg, values)), [&](ContactProblem& p) {
    const auto codes = integers("params", lenflg, params);
    const auto found = room("values", lenflg, values);
    of_flags = each_flag(call, codes, [&](std::size_t k) {
      found[k] = 0;
      found[k] = flag_of(p, codes[k]);
    });
  });
  return code != 0 ? code : of_flags;
}

int cntc_setmetadata(int* ire, int* icp, int* lenmta, int* params, double* values) {
  return guarded(problem_call(__func__, ire, icp), [&](ContactProblem&) {
    reals("values", lenmta, values);
    constexpr int known[] = {CNTC_mt_tim, CNTC_mt_xr,  CNTC_mt_yr,   CNTC_mt_xw,  CNTC_mt_yw,
                             CNTC_mt_sw,  CNTC_mt_run, CNTC_mt_axle, CNTC_mt_side};
    for (const int code : integers("params", lenmta, params))
      if (code != 0 && !has(known, code)) throw Refusal(CNTC_err_other, "there are no data " + std::to_string(code));
  });
}

} // extern "C"
} // namespace microslip::libcontact
