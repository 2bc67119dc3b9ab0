#include "microslip/railway/exact/exact_contact.hpp"

#include "microslip/numerics/bracketed_root.hpp"
#include "microslip/numerics/fade.hpp"
#include "microslip/railway/exact/contact_groups.hpp"
#include "microslip/railway/exact/load_sharing.hpp"
#include "microslip/railway/problem/wheel_status.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace microslip {
namespace {

/// Of the tractions' residual.
constexpr double tolerance_of_tractions = 1e-6;

/// Vertical force of the tractions on a patch, each along the axes of its row.
double vertical_force_of(const ContactGroup& one) {
  const ContactSolution& s = one.solution;
  double sum = 0;
  for (std::size_t i = 0; i < s.elements.size(); ++i) {
    const double angle = one.exact.row(static_cast<int>(i) / one.exact.grid().mx).angle;
    sum += (s.fields.pressure[i] * std::cos(angle) + s.fields.traction.y[i] * std::sin(angle)) * s.elements.area[i];
  }
  return sum;
}

void sum(const RowContact& coarse, std::vector<ContactGroup>& loaded, WheelRailSolution& out) {
  const Vec3<double> centre = coarse.surface().placement().wheel.frame.origin;
  WheelForces wheel;
  out.patches.clear();
  for (ContactGroup& one : loaded) {
    if (!(one.exact.normal_force() > 0)) continue;
    ContactSolution& solution = one.solution;
    const PatchOutline& outline = one.group.outline;
    WheelRailPatch patch = coarse.describe(outline, one.rows.least_gap, one.rows.speed / one.rows.weight);
    patch.approach += one.exact.approach(), patch.conformity = one.exact.conformity();
    const Elements& e = solution.elements;
    const SurfaceFields& f = solution.fields;
    for (std::size_t i = 0; i < e.size(); ++i) {
      if (!(f.pressure[i] > 0)) continue;
      const Vec3<double> force = e.area[i] * Vec3<double>{f.traction.x[i], f.traction.y[i], f.pressure[i]};
      const PatchRow& row = one.exact.row(static_cast<int>(i) / one.exact.grid().mx);
      wheel.add(force, row, e.x[i], centre);
      add_to_patch(force, row, e.x[i], outline.frame, patch);
    }
    patch.contact_area = solution.totals.adhesion_area + solution.totals.slip_area;
    patch.slip_area = solution.totals.slip_area;
    patch.peak_pressure = solution.totals.peak_pressure;
    patch.frictional_power = solution.totals.frictional_power;
    patch.status = one.exact.status() == Status::ok ? solution.report.status : one.exact.status();
    if (patch.status != Status::ok) out.status = patch.status;
    out.patches.push_back(patch);
    out.fields.push_back(std::move(solution));
  }
  if (out.patches.empty()) out.status = Status::no_contact;
  out.force = wheel.force, out.moment = wheel.moment;
}

/// Share of a further lowering of the wheel [m] to go before patches are found anew: none where it is
/// small beside the greatest overlap times the squared cosine of the inclination, since they hold then, all where it is
/// large, and a share in between, so that nothing changes at once. Frames on steep flanks turn the more with the
/// height.
double share_to_go(const std::vector<ContactGroup>& loaded, double lowering) {
  constexpr double small = 0.01, large = 0.02;
  const double depth = greatest_overlap(loaded);
  double cosine = 1;
  for (const ContactGroup& one : loaded)
    if (one.exact.normal_force() > 0) cosine = std::min(cosine, std::abs(one.cosine()));
  return 1 - fade(std::abs(lowering), small * depth * cosine * cosine, large * depth * cosine * cosine);
}

bool hold_contacts(const std::vector<ContactGroup>& loaded) {
  return std::all_of(loaded.begin(), loaded.end(), [](const ContactGroup& one) { return one.exact.holds_contact(); });
}

/// Returns true if elements further out are useless: there are none in the overlap.
bool cover_overlap(const std::vector<ContactGroup>& loaded) {
  return std::all_of(loaded.begin(), loaded.end(), [](const ContactGroup& one) { return one.covers_overlap(); });
}

/// No load of these patches carries the vertical force: that is for other heights to find.
void no_balance(WheelRailSolution& out, Unsolved reason) {
  out.patches.clear(), out.fields.clear();
  out.force = out.moment = {};
  out.status = Status::not_converged, out.residual = 1, out.reason = reason;
}

/// The patches that the fast theory has in its height, pressed together. Elements cover what is given of the overlap,
/// or all of it where they do not hold the contact. Returns by how much the wheel is lowered [m]; nothing where no load
/// of the patches carries the vertical force.
std::optional<double> press_patches(RowContact& coarse, const WheelRailBodies& bodies, const WheelRailMethod& method,
                                    std::optional<double> vertical_force, std::span<const ContactExtent> extents,
                                    Purpose purpose, std::vector<ContactGroup>& loaded, const Progress& progress) {
  const Round round = purpose == Purpose::forecast ? Round::forecast : Round::first;
  std::optional<double> lowering;
  for (const auto& covered : {extents, std::span<const ContactExtent>{}}) {
    loaded = contact_groups(coarse, bodies, method, covered, purpose, progress);
    if (loaded.empty()) return {};
    if (loaded.size() > 1) press_first(loaded);
    lowering = share_load(loaded, vertical_force, 0, round);
    if (!lowering || cover_overlap(loaded) || hold_contacts(loaded)) break;
  }
  return lowering;
}

/// Forecast by few elements over all of the overlap.
struct Forecast {
  std::vector<ContactExtent> extents; ///< of the contact, also where the fast theory's rows carry nothing
  std::optional<double> lowering;     ///< of the wheel until the patches carry the vertical force [m]
  double share_to_go = 0;             ///< of a further lowering of that size
};

Forecast forecast(RowContact& coarse, const WheelRailBodies& bodies, WheelRailMethod method,
                  std::optional<double> vertical_force, const Progress& progress) {
  constexpr int few = 12; // elements across a patch
  method.elements = std::min(method.elements, few);
  std::vector<ContactGroup> loaded;
  Forecast found;
  found.lowering = press_patches(coarse, bodies, method, vertical_force, {}, Purpose::forecast, loaded, progress);
  const double depth = greatest_overlap(loaded);
  for (const ContactGroup& one : loaded)
    if (const auto extent = one.extent(depth)) found.extents.push_back(*extent);
  if (found.lowering) found.share_to_go = share_to_go(loaded, *found.lowering);
  return found;
}

/// Lowers the wheel to the height in which few elements carry the vertical force, in one step of Newton's method, or in
/// two where the first one is large: frames and elements are then those of nearly the right height, and smooth
/// functions of the state.
Forecast go_to_height(RowContact& coarse, WheelState<double> state, const WheelRailBodies& bodies,
                      const WheelRailMethod& method, double vertical_force, WheelRailSolution& out,
                      const Progress& progress) {
  Forecast found = forecast(coarse, bodies, method, vertical_force, progress);
  double share = 1;
  for (const bool is_last : {false, true}) {
    if (!found.lowering || !(share > 0)) break;
    state.vertical = out.vertical - share * *found.lowering;
    coarse.height().solve(state, {}, out);
    share = found.share_to_go;
    if (is_last || !(share > 0) || out.status == Status::no_contact) break;
    found = forecast(coarse, bodies, method, vertical_force, progress);
  }
  return found;
}

/// Solves with the patches that the fast theory has in its height, and returns them. Nothing if `others` may be found
/// and these do not hold in the height that carries the vertical force, towards which the wheel has gone then.
std::optional<std::vector<ContactGroup>> solve_with_patches(RowContact& coarse, const WheelRailBodies& bodies,
                                                            const WheelRailMethod& method,
                                                            std::optional<double> vertical_force,
                                                            std::span<const ContactExtent> extents, bool others,
                                                            WheelRailSolution& out, const Progress& progress) {
  constexpr int most_rounds = 12;
  std::vector<ContactGroup> loaded;
  const auto without_balance = [&](Unsolved reason) {
    no_balance(out, reason);
    return std::move(loaded);
  };
  const std::optional<double> first =
      press_patches(coarse, bodies, method, vertical_force, extents, Purpose::forces, loaded, progress);
  if (loaded.empty()) {
    out.status = coarse.patches().empty() ? Status::no_contact : Status::not_converged;
    return loaded;
  }
  if (!first) return without_balance(Unsolved::residual);
  double lowering = *first;
  const auto friction = [&coarse](double angle) { return coarse.friction(angle); };
  for (int round = 0; round < most_rounds; ++round) {
    if (round > 0) {
      const std::optional<double> found = share_load(loaded, vertical_force, lowering, Round::later);
      if (!found) return without_balance(Unsolved::residual);
      lowering = *found;
    }
    const double share = round == 0 && others && vertical_force ? share_to_go(loaded, lowering) : 0;
    if (share > 0) {
      out.vertical -= share * lowering;
      return {};
    }
    const bool held = hold_contacts(loaded);
    if (!held && round == 0) return without_balance(Unsolved::beyond_elements);
    out.status = Status::not_converged;
    if (!held) break;
    // Where elements come and go with the load no load may have the vertical force, so in the end they stay.
    const double same_elements = round < 2 ? 5e-4 : 1e-2;
    // The first round is to tell how much of the weight the tangential forces carry.
    const double tolerance = round == 0 && vertical_force ? 1e-3 : tolerance_of_tractions;
    double vertical = 0;
    for (ContactGroup& one : loaded) {
      if (!(one.exact.normal_force() > 0)) continue;
      one.solution = one.exact.roll(friction, same_elements, tolerance);
      const double borne = vertical_force_of(one);
      one.share = borne / one.exact.normal_force();
      vertical += borne;
    }
    out.residual = vertical_force ? std::abs(vertical / *vertical_force - 1) : 0;
    for (const ContactGroup& one : loaded) out.residual = std::max(out.residual, one.exact.unsettled());
    if (out.residual <= method.solved_tolerance() && tolerance <= tolerance_of_tractions) {
      out.status = Status::ok;
      break;
    }
  }
  if (vertical_force) out.vertical -= lowering;
  sum(coarse, loaded, out);
  return loaded;
}

/// Solves a state from the patches of the fast theory there.
void solve_from_coarse(RowContact& coarse, WheelState<double> state, const WheelRailBodies& bodies,
                       const WheelRailMethod& method, std::optional<double> vertical_force, WheelRailSolution& out,
                       const Progress& progress) {
  constexpr int most_heights = 4; // the fast theory may have missed the height, or found it with other patches
  for (int k = 1; k <= most_heights; ++k) {
    const Forecast found = k == 1 && vertical_force
                               ? go_to_height(coarse, state, bodies, method, *vertical_force, out, progress)
                               : forecast(coarse, bodies, method, vertical_force, progress);
    if (out.status == Status::no_contact) break;
    out.fields.clear();
    if (solve_with_patches(coarse, bodies, method, vertical_force, found.extents, k < most_heights, out, progress))
      break;
    state.vertical = out.vertical;
    coarse.height().solve(state, {}, out);
    if (out.status == Status::no_contact) break;
  }
}

/// Forces of a wheel at given heights.
class ExactHeight {
public:
  ExactHeight(RowContact& coarse, const WheelState<double>& state, const WheelRailBodies& bodies,
              const WheelRailMethod& method, double vertical_force, WheelRailSolution& out, const Progress& progress)
      : coarse_(coarse), state_(state), bodies_(bodies), method_(method), vertical_force_(vertical_force), out_(out),
        progress_(progress) {}

  /// Solves at a height [m]. By how much the vertical force is too large, relative; not a number once patches have been
  /// beyond their elements in too many heights.
  double excess_at(double height) {
    if (beyond_elements_ >= most_beyond_elements) return std::numeric_limits<double>::quiet_NaN();
    state_.vertical = height;
    out_.patches.clear(), out_.fields.clear();
    out_.force = out_.moment = {}, out_.reason = Unsolved::none;
    coarse_.height().solve(state_, {}, out_);
    if (out_.status != Status::no_contact) solve_from_coarse(coarse_, state_, bodies_, method_, {}, out_, progress_);
    if (out_.reason == Unsolved::beyond_elements) ++beyond_elements_;
    return out_.force.z / vertical_force_ - 1;
  }

  /// Brackets the height that carries the vertical force in steps that grow, from `start` on and not below `least` [m].
  void find(double start, double least) {
    constexpr double first_step = 4e-6, growth = 3, precision = 1e-9, finest = 1e-12; // [m], [-], [m]
    constexpr int most_steps = 7;                                                     // up to 4 mm away
    const auto excess = [this](double height) { return excess_at(height); };
    RootSide before{std::max(start, least), 0};
    before.value = excess(before.at);
    RootSide nearest = before;
    const bool rises = before.value > 0;
    double step = rises ? first_step : -first_step;
    for (int k = 0; k < most_steps && (rises || before.at > least); ++k, step *= growth) {
      const double height = std::max(before.at + step, least);
      const RootSide here{height, excess(height)};
      if ((here.value > 0) != (before.value > 0)) {
        const double tolerance = method_.solved_tolerance();
        BracketedRoot root = find_bracketed_root(before, here, tolerance, precision, excess);
        if (!root.found && beyond_elements_ == 0 && !is_jump(root))
          root = find_bracketed_root(root.side, root.other, tolerance, finest, excess);
        out_.residual = std::max(out_.residual, std::abs(root.side.value));
        if (root.found) return;
        if (beyond_elements_ > 0) break;
        mark_jump(out_);
        return;
      }
      before = here;
      if (std::abs(here.value) < std::abs(nearest.value)) nearest = here;
    }
    if (beyond_elements_ > 0) { // one of these heights may carry the force
      no_balance(out_, Unsolved::beyond_elements);
      return;
    }
    out_.residual = std::abs(excess(nearest.at));
    out_.status = Status::no_solution, out_.reason = Unsolved::no_height;
  }

private:
  static constexpr int most_beyond_elements = 6; ///< fewer lose states that `validate random-wheels` has solved

  /// Returns whether the force changes more steeply than any contact would let it.
  bool is_jump(const BracketedRoot& root) const {
    const double stiffest = bodies_.material.shear_modulus * bodies_.wheelset.nominal_radius; // [N/m]
    return vertical_force_ * std::abs(root.side.value - root.other.value) >
           stiffest * std::abs(root.side.at - root.other.at);
  }

  RowContact& coarse_;
  WheelState<double> state_;
  const WheelRailBodies& bodies_;
  const WheelRailMethod& method_;
  double vertical_force_;
  WheelRailSolution& out_;
  const Progress& progress_;
  int beyond_elements_ = 0; ///< heights in which patches were beyond their elements
};

} // namespace

void solve_exact(RowContact& coarse, const WheelState<double>& state, const WheelRailBodies& bodies,
                 const WheelRailMethod& method, std::optional<double> vertical_force, WheelRailSolution& out,
                 const Progress& progress) {
  const int iterations = out.iterations;
  const double height = out.vertical, least = coarse.height().least_height(state.vertical);
  const bool coarse_failed = vertical_force && out.status != Status::ok;
  if (!coarse_failed) solve_from_coarse(coarse, state, bodies, method, vertical_force, out, progress);
  const bool is_rolling = std::all_of(out.patches.begin(), out.patches.end(),
                                      [](const WheelRailPatch& patch) { return patch.status == Status::ok; });
  if (coarse_failed || (vertical_force && out.status != Status::ok && is_rolling))
    ExactHeight(coarse, state, bodies, method, *vertical_force, out, progress).find(height, least);
  out.iterations = iterations;
}

std::vector<FrequencyResponse> respond_exact(RowContact& coarse, const WheelState<double>& state,
                                             const WheelRailBodies& bodies, const WheelRailMethod& method,
                                             std::span<const double> wavenumbers, WheelRailSolution& out,
                                             const Progress& progress) {
  std::vector<FrequencyResponse> responses;
  coarse.height().solve(state, {}, out);
  if (out.status == Status::no_contact) return responses;
  const Forecast found = forecast(coarse, bodies, method, {}, progress);
  out.fields.clear();
  auto loaded = solve_with_patches(coarse, bodies, method, {}, found.extents, false, out, progress);
  if (out.status != Status::ok) return responses;
  const auto friction = [&coarse](double angle) { return coarse.friction(angle); };
  for (ContactGroup& one : *loaded)
    if (one.exact.normal_force() > 0)
      responses.push_back(one.exact.respond(friction, wavenumbers, tolerance_of_tractions));
  return responses;
}

} // namespace microslip
