#include "compat/contact/input_text.hpp"

#include "compat/contact/records.hpp"
#include "compat/contact/wheel_rail/record_numbers.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <iterator>
#include <span>

#include <fmt/format.h>

namespace microslip::contact_program {
namespace {

double number_of(const Vertical& vertical) {
  const auto* force = std::get_if<VerticalForce>(&vertical);
  return force ? force->fz : in_file(std::get<VerticalPosition>(vertical).z, mm);
}

double number_of(const PitchDrive& drive) {
  if (const auto* force = std::get_if<LongitudinalForce>(&drive)) return force->fx;
  if (const auto* moment = std::get_if<PitchMoment>(&drive)) return in_file(moment->my, mm);
  return std::get<PitchVelocity>(drive).rate;
}

bool is_used(const WheelDeflection& d) {
  return std::any_of(std::begin(wheel_deflection_numbers), std::end(wheel_deflection_numbers),
                     [&](const auto& number) { return d.*number.member != 0; });
}

/// Writes the records of a case in their order.
class CaseText {
public:
  explicit CaseText(const Case& c) : case_(c) {}

  std::string text() {
    const auto& [element, problem] = case_.sequence;
    text_ = fmt::format("{:2} {} {}  MODULE, RE, CP  % case {}\n", case_.wheel_rail ? 1 : 3, element, problem,
                        case_.number_in_element);
    if (case_.wheel_rail)
      add_wheel(*case_.wheel_rail);
    else
      add_contact();
    return std::move(text_);
  }

private:
  void add_contact() {
    const Digits& d = case_.digits;
    add_control({number(d.pvtime), number(d.bound), number(d.tang), number(d.norm), number(d.force), points_digit()},
                "P-B-T-N-F-S");
    const int sets = number(case_.friction.by_row ? FrictionSets::by_row : FrictionSets::one);
    add_control({sets, number(case_.friction.law), number(GridSource::read), coefficients(), number(d.mater),
                 number(DistanceSource::read), number(case_.extra)},
                "V-L-D-C-M-Z-E", damping_digit());
    add_third_control();
    add_solver();
    const bool of_force = d.norm == Normal::force;
    add({of_force ? case_.load.value : in_file(case_.load.value, mm), in_file(case_.x, d), in_file(case_.y, d),
         in_file(case_.phi, unit_of_spin(d)), in_file(case_.spin_x, mm), in_file(case_.spin_y, mm)},
        of_force ? "FN, KSI, ETA, PHI, SPINXO, SPINYO" : "PEN, KSI, ETA, PHI, SPINXO, SPINYO");
    if (!case_.friction.by_row) add_friction_set(case_.friction.sets.at(0));
    if (d.rolls()) {
      const RollingData& r = *case_.rolling;
      add({r.chi, in_file(r.dq, mm), in_file(r.veloc, mm), r.facphi}, "CHI, DQ, VELOC, FACPHI");
    }
    add_correction();
    add_material();
    add_potential();
    if (!case_.potential->is_hertzian()) add_geometry();
    if (case_.friction.by_row)
      for (const auto& set : case_.friction.sets) add_friction_set(set);
    if (case_.extra == ExtraSlip::by_element) add_list(case_.extra_slip);
    add_points();
  }

  void add_wheel(const WheelRailData& w) {
    const Digits& d = case_.digits;
    const WheelRailDigits& own = w.digits;
    const bool bends = own.reads_flexibility() || is_used(w.deflection);
    add_control({number(own.config), number(d.pvtime), number(d.bound), number(d.tang), number(d.norm),
                 number(own.force), points_digit()},
                "C-P-B-T-N-F-S");
    add_control({number(friction_stations()), number(case_.friction.law), number(w.search), coefficients(),
                 number(d.mater), number(TrackSource::all),
                 number(bends ? WheelsetSource::all_flexible : WheelsetSource::all)},
                "V-L-D-C-M-Z-E", damping_digit());
    add_third_control();
    add_solver();
    add_friction();
    add_correction();
    add_material();
    const PatchRules& g = w.grid;
    const auto length = [](double value) { return in_file(value, mm); };
    add({length(g.dx), length(g.ds), g.dqrel, g.a_sep, length(g.d_sep), length(g.d_comb), length(g.d_turn),
         length(g.g_miss)},
        "DX, DS, DQREL, A_SEP, D_SEP, D_COMB, D_TURN, G_MISS");
    add_track(w);
    add_wheelset(w, bends);
    add_points();
  }

  void add(std::initializer_list<double> values, const char* names) {
    for (const double value : values) add_number(value);
    text_ += fmt::format("  % {}\n", names);
  }
  /// The numbers of a record that has a table.
  template <class Table, class Record> void add_numbers(const Table& numbers, const Record& record) {
    for (const auto& number : numbers) add_number(in_file(record.*number.member, number.unit.value()));
  }
  /// Many numbers on several lines.
  void add_list(std::span<const double> values, double unit = 1) {
    constexpr std::size_t on_a_line = 8;
    for (std::size_t k = 0; k < values.size(); ++k) {
      if (k > 0 && k % on_a_line == 0) text_ += "\n";
      add_number(in_file(values[k], unit));
    }
    text_ += "\n";
  }
  void add_number(double value) {
    if (!std::isfinite(value)) throw Error("an input file cannot have a number that is not finite");
    text_ += fmt::format(" {}", value);
  }
  void add_integers(std::initializer_list<int> values, const char* names) {
    for (const int value : values) text_ += fmt::format(" {}", value);
    text_ += fmt::format("  % {}\n", names);
  }
  void add_control(std::initializer_list<int> digits, const char* names, const char* more = "") {
    text_ += " ";
    for (const int digit : digits) text_ += fmt::format("{}", digit);
    text_ += fmt::format("{}  % {}\n", more, names);
  }

  void add_third_control() {
    const Digits& d = case_.digits;
    const Heat heat = d.heat == Heat::none ? Heat::none : Heat::read;
    const Treatment solve = d.is_skipped() ? Treatment::skip : Treatment::solve;
    add_control({number(Trace::none), number(heat), number(solver()), number(d.iestim), number(d.matfil),
                 number(d.output), number(d.flow), number(solve)},
                "X-H-G-I-A-O-W-R");
  }

  SolverChoice solver() const {
    const SolverChoice method = case_.solver.method;
    return method == SolverChoice::gd_steady ? SolverChoice::standard : method;
  }
  int coefficients() const {
    const Coefficients c = case_.material->coefficients;
    if (c == Coefficients::from_file) throw Error("C = 9: the name of the file of coefficients is not kept");
    return number(c);
  }
  int points_digit() const {
    const bool has_points = case_.digits.stress != InteriorPoints::none && !case_.points.empty();
    return number(has_points ? InteriorPoints::read : InteriorPoints::none);
  }
  const char* damping_digit() const { return case_.damping ? " 2" : ""; }
  FrictionStations friction_stations() const {
    return case_.friction.stations.empty() ? FrictionStations::one : case_.wheel_rail->digits.varfrc;
  }

  void add_solver() {
    const SolverData& s = case_.solver;
    text_ += fmt::format(" {} {} {} {}", s.maxgs, s.maxin, s.maxnr, s.maxout);
    add_number(s.eps);
    text_ += fmt::format(" {}  % MAXGS, MAXIN, MAXNR, MAXOUT, EPS, NPOT_MAX\n", s.npot_max);
    if (!s.starts_from_slip()) return;
    if (s.method == SolverChoice::slip_iteration) return add({s.inislp, s.omgslp}, "INISLP, OMGSLP");
    add({s.omegah, s.omegas, s.inislp, s.omgslp}, "OMEGAH, OMEGAS, INISLP, OMGSLP");
  }

  /// The numbers of a law but for its memory, which are the last two of all laws but Coulomb's.
  std::span<const double> without_memory(const std::vector<double>& set) const {
    return std::span(set).first(set.size() - (case_.friction.law == Law::coulomb ? 0 : 2));
  }
  void add_memory(const std::vector<double>& set) {
    if (case_.friction.law != Law::coulomb) add_list(std::span(set).last(2));
  }
  void add_friction_set(std::vector<double> set) {
    set = in_file(std::move(set), units_of_friction(case_.friction.law));
    add_list(without_memory(set));
    add_memory(set);
  }
  /// Of module 1: one set, or several with one memory.
  void add_friction() {
    const FrictionData& f = case_.friction;
    if (friction_stations() == FrictionStations::one) {
      add_friction_set(f.sets.at(0));
      return;
    }
    add_integers({static_cast<int>(f.sets.size())}, "NVF");
    std::vector<double> set;
    for (std::size_t k = 0; k < f.sets.size(); ++k) {
      add_number(in_file(f.stations[k], friction_stations() == FrictionStations::along_track ? mm : 1));
      set = in_file(f.sets[k], units_of_friction(f.law));
      add_list(without_memory(set));
    }
    add_memory(set);
  }

  /// C = 4; module 1 knows the angles from its profiles.
  void add_correction() {
    const MaterialData& m = *case_.material;
    if (m.coefficients != Coefficients::angle_corrected) return;
    const AngleCorrection& a = m.correction;
    if (case_.wheel_rail) return add_integers({a.method, a.variant}, "IF_METH, VARIANT");
    add_integers({a.method, a.variant, static_cast<int>(a.angles.size())}, "IF_METH, VARIANT, NN");
    for (const auto& [y, alpha] : a.angles) add({in_file(y, mm), alpha}, "Y, ALPHA");
  }

  /// Elasticity, what B and M add to it, damping and heat.
  void add_material() {
    const MaterialData& m = *case_.material;
    add({m.poisson1, m.poisson2, in_file(m.shear1, newton_per_mm2), in_file(m.shear2, newton_per_mm2)},
        "POISS 1, 2, GG 1, 2");
    if (case_.digits.bound == PressureModel::thin_sheet) add({in_file(m.sheet_flexibility, mm3_per_newton)}, "FLXZ");
    if (case_.digits.mater != Bulk::elastic && !m.model_data.empty())
      add_list(in_file(m.model_data, units_of_model(case_.digits.mater)));
    if (const auto& d = case_.damping)
      add({d->normal, d->tangential, d->normal_limit, d->tangential_limit}, "CDAMPN, CDAMPT, DFNMAX, DFTMAX");
    if (case_.digits.heat != Heat::none) add_heat(*case_.heat);
  }
  void add_heat(const HeatData& h) {
    for (const auto& body : {h.body1, h.body2}) add_list(in_file({body.begin(), body.end()}, units_of_heat));
    if (case_.digits.mater == Bulk::layer) add({h.plastic_share}, "BETAPL");
  }

  void add_potential() {
    const PotentialContact& p = *case_.potential;
    if (p.is_hertzian() && (case_.formed.given != case_.load.given || case_.formed.value != case_.load.value))
      throw Error("an input file cannot have Hertz's grid of one case and the force of another in one case");
    add_integers({number(p.kind)}, "IPOTCN");
    text_ += fmt::format(" {} {}", p.mx, p.my);
    const std::size_t count = !p.is_hertzian() ? 4 : p.kind == Potential::half_ellipses ? 3 : 2;
    for (std::size_t k = 0; k < count; ++k)
      add_number(in_file(p.values[k], p.is_hertzian() ? unit_of_hertz(p.kind, k).value() : mm));
    if (p.is_hertzian()) add_number(p.scale);
    text_ += "  % MX, MY, ...\n";
  }

  void add_geometry() {
    const Geometry& g = case_.geometry;
    add_integers({number(g.base), number(g.planform)}, "IBASE, IPLAN");
    const std::span<const double> values = g.values;
    if (g.base == Base::circle) {
      constexpr std::size_t of_circle = 4;
      text_ += fmt::format(" {}", values.size() - of_circle);
      add_list(values.first(of_circle), mm);
      add_list(values.subspan(of_circle), mm);
    } else if (g.base == Base::by_element) {
      add_list(values, mm);
    } else {
      add_list(in_file(g.values, g.base == Base::waves ? units_of_waves : units_of_quadratic));
    }
    if (g.planform == Planform::quadratic) add_list(in_file(g.plan_values, units_of_quadratic));
    if (g.planform == Planform::rectangles) add_list(g.plan_values, mm);
    if (g.planform != Planform::sub_patches) return;
    const std::span<const double> plan = g.plan_values;
    const auto separators = static_cast<std::size_t>(plan[0]) - 1;
    add_list(plan.first(1));
    if (separators == 0) return;
    add_list(plan.subspan(1, separators), mm);
    add_list(plan.subspan(1 + separators));
  }

  void add_profile(const ProfileRecord& p) {
    const std::string file = std::filesystem::absolute(p.file).string();
    if (file.find('\'') != std::string::npos) throw Error(file + ": an input file cannot have quotes in names");
    text_ += fmt::format(" '{}' {}", file, p.mirror_y);
    add_number(p.scale);
    add_number(p.smooth);
    text_ += fmt::format(" {} 2  % NAME, MIRRORY, SCALE, SMOOTH, MIRRORZ, PRFOPT\n {}", p.mirror_z, p.smoothing);
    add({p.zigzag, p.kink_high, p.kink_low, p.kink_width}, "ISMOOTH, ZIGTHRS, KINKHIGH, KINKLOW, KINKWID");
    text_ += fmt::format(" {}", p.error_handling);
    add({p.most_omitted}, "ERRHND, MAXOMIT");
  }

  void add_track(const WheelRailData& w) {
    const TrackDimensions& t = w.track;
    for (const double length : {t.gauge_height, t.by_gauge() ? 0 : t.rail_y0, t.by_gauge() ? t.gauge_width : t.rail_z0})
      add_number(in_file(length, mm));
    if (w.digits.is_roller())
      add({in_file(t.roller_radius, mm)}, "GAUGHT, ..., NOMRADR");
    else
      add({t.cant, in_file(t.curvature, per_mm)}, "GAUGHT, ..., CANT, CURV");
    add_profile(w.rail);
    add_numbers(rail_position_numbers, w.rail_position);
    add({}, "DYRAIL, DZRAIL, DROLLR, VYRAIL, VZRAIL, VROLLR");
    if (w.digits.force != TotalForce::rail_deflection) return;
    add_numbers(rail_support_numbers, w.support);
    add({in_file(w.support.first_step, mm)}, "KYRAIL, FYRAIL, KZRAIL, FZRAIL, DYSTEP0");
  }

  void add_wheelset(const WheelRailData& w, bool bends) {
    const WheelsetDimensions& s = w.wheelset;
    for (const double length : {s.flange_back_distance, s.flange_back_position, s.nominal_radius, s.tape_circle})
      add_number(in_file(length, mm));
    add({}, "FBDIST, FBPOS, NOMRADW, YTAPE");
    add_profile(w.wheel);
    const std::span<const RecordNumber<WheelsetPosition>> position(wheelset_position_numbers);
    add_numbers(position.first(before_vertical), w.position);
    add_number(number_of(w.position.vertical));
    add_numbers(position.subspan(before_vertical), w.position);
    add({}, case_.digits.norm == Normal::force ? "S, Y, FZ, ROLL, YAW, PITCH" : "S, Y, Z, ROLL, YAW, PITCH");
    const WheelsetVelocity& v = w.velocity;
    add_number(w.digits.is_roller() ? v.vs : in_file(v.vs, mm));
    add_numbers(wheelset_velocity_numbers, v);
    add({number_of(v.pitch)}, w.digits.force == TotalForce::force_x    ? "VS, VY, VZ, VROLL, VYAW, FX"
                              : w.digits.force == TotalForce::moment_y ? "VS, VY, VZ, VROLL, VYAW, MY"
                                                                       : "VS, VY, VZ, VROLL, VYAW, VPITCH");
    if (!bends) return;
    const std::span<const RecordNumber<WheelDeflection>> deflection(wheel_deflection_numbers);
    add_numbers(deflection.first(6), w.deflection);
    add({}, "DXWHL, DYWHL, DZWHL, DROLLW, DYAWW, DPITCHW");
    add_numbers(deflection.subspan(6), w.deflection);
    add({}, "VXWHL, VYWHL, VZWHL, VROLLW, VYAWW, VPITCHW");
  }

  void add_points() {
    if (points_digit() == number(InteriorPoints::none)) return;
    add_integers({number(case_.subs_file), case_.interior_level}, "A_s, O_s");
    for (const PointBlock& block : case_.points) add_block(block);
    add_integers({number(Points::end)}, "ISUBS");
  }
  void add_block(const PointBlock& b) {
    const auto counts = [this](std::initializer_list<std::size_t> sizes) {
      for (const std::size_t size : sizes) text_ += fmt::format(" {}", size);
      text_ += "\n";
    };
    add_integers({number(b.kind)}, "ISUBS");
    for (std::size_t k = 0; k < b.range.size(); ++k) text_ += fmt::format(" {}{}", b.range[k], k % 3 == 2 ? "\n" : "");
    if (b.kind == Points::anywhere)
      counts({b.x.size(), b.y.size(), b.z.size()});
    else if (!b.x.empty())
      counts({b.x.size(), b.y.size()});
    for (const auto* places : {&b.x, &b.y})
      if (!places->empty()) add_list(*places, b.kind == Points::anywhere ? mm : 1);
    if (b.kind != Points::anywhere && !b.has_equal_depths()) counts({b.z.size()});
    if (b.has_equal_depths())
      add_list(in_file(b.z, {0, 1, 1}));
    else
      add_list(b.z, mm);
  }

  const Case& case_;
  std::string text_;
};

} // namespace

std::string input_text(const Case& c) {
  return CaseText(c).text();
}

std::string input_end() {
  return " 0  MODULE\n";
}

} // namespace microslip::contact_program
