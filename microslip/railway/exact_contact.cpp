#include "microslip/railway/exact_contact.hpp"

#include "microslip/numerics/bracketed_root.hpp"
#include "microslip/numerics/elimination.hpp"
#include "microslip/railway/exact_patch.hpp"
#include "microslip/railway/patch_group.hpp"
#include "microslip/railway/wheel_status.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace microslip {
namespace {

constexpr double normal_tolerance = 1e-8;

/// Sums over the rows of patches at the coarse level, and what else differs from patch to patch.
struct Rows {
  double load = 0;      ///< q
  double squares = 0;   ///< q^2 over the row's width
  double lengths = 0;   ///< q times the half-length
  double least_gap = 0; ///< [m]
  double speed = 0;     ///< V times the outline's weight
  double weight = 0;    ///< of the outline

  static Rows of(const ContactPatch& patch) {
    Rows sum;
    for (const LoadedRow& row : patch.loaded)
      sum.load += row.load, sum.squares += row.load * row.load / row.width, sum.lengths += row.load * row.half_length;
    sum.least_gap = patch.least_gap;
    sum.weight = patch.outline.weight, sum.speed = sum.weight * patch.speed;
    return sum;
  }

  /// Adds another patch by its share. Its least gap counts where it is less.
  void add(const Rows& other, double share) {
    load += share * other.load, squares += share * other.squares, lengths += share * other.lengths;
    least_gap = std::min(least_gap, least_gap + share * (other.least_gap - least_gap));
    speed += share * other.speed, weight += share * other.weight;
  }

  /// Lengths of the contact along x and s [m], which are those of the ellipse if it is one: loads of rows are parabolic
  /// across a Hertzian ellipse.
  Vec2 extent() const {
    if (!(load > 0)) return {};
    return {2 * lengths / load * 32 / (9 * std::numbers::pi), load * load / squares * 6 / 5};
  }
};

/// A group of patches of the coarse level and its elements for the exact theory.
struct Loaded {
  PatchGroup group;
  Rows rows;
  std::vector<PointLoad> start; ///< loads of the coarse level's rows
  ExactPatch exact;
  double force;                            ///< normal, with which it lifts the others [N]
  double share;                            ///< vertical force for each newton of it
  double pressed = 0;                      ///< the normal force that the others' lift leaves it [N]
  double stiffness = 0;                    ///< its change with the approach [N/m]
  std::optional<double> force_before = {}; ///< what it was in the last step
  double approach_before = 0;              ///< [m], likewise
  ContactSolution solution = {};
  bool covers_overlap = false; ///< the elements cover all of the group's overlap

  double cosine() const { return std::cos(group.outline.frame.angle); }
};

/// Elements of the coarse level's contact; where that is small within the overlap they are not smaller than a third of
/// those across the overlap.
Vec2 element_of(const Rows& rows, const PatchOutline& outline, int elements) {
  const Vec2 extent = rows.extent();
  return {std::max(extent.x, (outline.x_high - outline.x_low) / 3) / elements,
          std::max(extent.y, (outline.s_high - outline.s_low) / 3) / elements};
}

/// An outline limited to where rows bear load, a tenth of that further to each side: the contact is some two thirds of
/// the overlap. The same outline if that leaves nothing, as where frames are far from their rows.
PatchOutline limited_to_load(const PatchOutline& whole, std::span<const ContactPatch> patches,
                             std::span<const double> shares) {
  constexpr double infinity = std::numeric_limits<double>::infinity(), further = 0.1;
  const PatchFrame& frame = whole.frame;
  double x_low = infinity, x_high = -infinity, s_low = infinity, s_high = -infinity;
  for (std::size_t k = 0; k < patches.size(); ++k)
    for (const LoadedRow& row : patches[k].loaded) {
      if (shares[k] != 1 || !(row.load > 0)) continue;
      const double x = row.centre - frame.origin.x, s = row.y - frame.rail_s;
      x_low = std::min(x_low, x - row.half_length), x_high = std::max(x_high, x + row.half_length);
      s_low = std::min(s_low, s - row.width / 2), s_high = std::max(s_high, s + row.width / 2);
    }
  const double x_more = further * (x_high - x_low), s_more = further * (s_high - s_low);
  PatchOutline limited = whole;
  limited.x_low = std::max(whole.x_low, x_low - x_more), limited.x_high = std::min(whole.x_high, x_high + x_more);
  limited.s_low = std::max(whole.s_low, s_low - s_more), limited.s_high = std::min(whole.s_high, s_high + s_more);
  return limited.x_low < limited.x_high && limited.s_low < limited.s_high ? limited : whole;
}

/// The rows of the coarse level as loads.
void add_rows(const ContactPatch& patch, std::vector<PointLoad>& loads) {
  for (std::size_t j = 0; j < patch.loaded.size(); ++j) {
    const LoadedRow& row = patch.loaded[j];
    if (row.load > 0)
      loads.push_back({patch.rows[j].at.point + Vec3<double>{row.centre, 0, 0}, row.load, patch.rows[j].at.angle});
  }
}

/// With elements over all of the overlap or where the coarse level's rows bear load.
std::vector<Loaded> loaded_groups(CoarseContact& coarse, const WheelRailBodies& bodies, const WheelRailMethod& method,
                                  bool all_of_overlap, const Progress& progress) {
  const std::span<const ContactPatch> patches = coarse.patches();
  std::vector<PatchOutline> outlines;
  double depth = 0;
  for (const ContactPatch& patch : patches) {
    outlines.push_back(patch.outline);
    depth = std::max(depth, -patch.least_gap);
  }
  const PatchSurface surface = coarse.surface();
  const RollingDirection direction = coarse.rolls_forward() ? RollingDirection::forward : RollingDirection::backward;
  std::vector<Loaded> loaded;
  for (PatchGroup& group :
       group_patches(surface.placement(), bodies.rail, bodies.wheel, outlines, method.surface(), depth)) {
    double force = 0, vertical = 0;
    std::vector<PointLoad> loads;
    std::optional<Rows> rows; // of its patches first
    for (const bool own : {true, false})
      for (std::size_t k = 0; k < patches.size(); ++k) {
        if ((group.shares[k] == 1) != own) continue;
        const Rows sums = Rows::of(patches[k]);
        if (!rows)
          rows = sums;
        else
          rows->add(sums, group.shares[k]);
        if (!own || !(sums.load > 0)) continue;
        force += sums.load, vertical += sums.load * patches[k].vertical_share;
        add_rows(patches[k], loads);
      }
    const Vec2 element = element_of(*rows, group.outline, method.elements);
    if (!(element.x > 0 && element.y > 0 && std::isfinite(element.x + element.y))) continue; // the coarse level failed
    const ExactPatch::Motion motion{rows->least_gap, rows->speed / rows->weight, direction};
    const PatchOutline covered = all_of_overlap ? group.outline : limited_to_load(group.outline, patches, group.shares);
    const ExactPatch::Shape shape{method.surface(), method.conformity(group.outline.turn)};
    ExactPatch exact(bodies.material, surface, covered, shape, element, motion, progress);
    double share = std::cos(group.outline.frame.angle);
    if (force > 0) share = vertical / force;
    // Rows of the coarse level have separate planes.
    if (force > 0 && method.surface() == PatchShape::flat)
      for (const PointLoad& row : loads)
        share += row.force / force * (std::cos(group.outline.frame.angle) - std::cos(row.angle));
    const PatchOutline& overlap = group.outline;
    const bool covers = covered.x_low == overlap.x_low && covered.x_high == overlap.x_high &&
                        covered.s_low == overlap.s_low && covered.s_high == overlap.s_high;
    loaded.push_back({std::move(group), *rows, std::move(loads), std::move(exact), force, share});
    loaded.back().covers_overlap = covers;
  }
  return loaded;
}

/// The pressures of all patches but one as loads.
std::vector<PointLoad> loads_on(const std::vector<Loaded>& loaded, const Loaded& one) {
  std::vector<PointLoad> all;
  for (const Loaded& other : loaded) {
    if (&other == &one || !(other.exact.normal_force() > 0)) continue;
    for (PointLoad load : other.exact.loads()) {
      load.force *= other.force / other.exact.normal_force();
      all.push_back(load);
    }
  }
  return all;
}

/// Approach [m] of a patch with the wheel lowered by `zeta` [m] and others that lift it.
double approach_of(const Loaded& one, std::span<const PointLoad> loads, double zeta) {
  double approach = zeta * one.cosine();
  for (const PointLoad& load : loads) approach -= one.exact.lift_by(load);
  return approach;
}

/// Changes of the normal forces [N] that were those of each patch on its own, when each lifts the others off; as they
/// were where together they have none.
void couple(const std::vector<Loaded>& loaded, std::vector<double>& direct, std::vector<double>& lowered) {
  std::vector<double> matrix;
  for (std::size_t k = 0; k < loaded.size(); ++k)
    for (std::size_t l = 0; l < loaded.size(); ++l) {
      PointLoad unit = loaded[l].exact.load();
      unit.force = 1;
      matrix.push_back(k == l ? 1 : loaded[k].stiffness * loaded[k].exact.lift_by(unit));
    }
  std::vector<double> coupled = direct, coupled_lowered = lowered;
  if (eliminate(matrix, {coupled, coupled_lowered})) direct = coupled, lowered = coupled_lowered;
}

/// A step of Newton's method for normal forces F_i = N_i(zeta cos(angle_i) - sum C_ij F_j) that bear a vertical force
/// [N] where one is given. Returns the change of zeta [m], nothing where lowering the wheel would lift it less.
std::optional<double> correct(std::vector<Loaded>& loaded, std::optional<double> vertical_force) {
  std::vector<double> direct, lowered;
  for (const Loaded& one : loaded) {
    direct.push_back(one.pressed - one.force);
    lowered.push_back(one.stiffness * one.cosine());
  }
  couple(loaded, direct, lowered);
  double more = 0;
  if (vertical_force) {
    double short_of = *vertical_force, vertical_by_zeta = 0;
    for (std::size_t k = 0; k < loaded.size(); ++k) {
      short_of -= (loaded[k].force + direct[k]) * loaded[k].share;
      vertical_by_zeta += lowered[k] * loaded[k].share;
    }
    if (!(vertical_by_zeta > 0)) return {};
    more = short_of / vertical_by_zeta;
  }
  if (!std::isfinite(more)) return {};
  for (std::size_t k = 0; k < loaded.size(); ++k)
    loaded[k].force = std::max(loaded[k].force + direct[k] + more * lowered[k], 0.0);
  return more;
}

/// Change of a patch's normal force with the approach as it is after Hertz: from the approach beyond the first touch.
double hertzian_stiffness(const Loaded& one, std::span<const PointLoad> loads) {
  if (!(one.exact.normal_force() > 0)) return 0;
  const double touching = one.exact.approach() - one.exact.least_gap();
  return 1.5 * one.exact.normal_force() / std::max(touching + approach_of(one, loads, 0), 0.1 * touching);
}

/// Presses all patches with the forces of the coarse level, which tells how stiff they are, and what they would bear in
/// the coarse level's height.
void press_first(std::vector<Loaded>& loaded) {
  constexpr double tolerance = 1e-4;
  for (Loaded& one : loaded) {
    std::vector<PointLoad> rows;
    for (const Loaded& other : loaded)
      if (&other != &one) rows.insert(rows.end(), other.start.begin(), other.start.end());
    one.exact.lift(rows);
    if (one.force > 0) {
      one.exact.press_with(one.force, tolerance);
      one.pressed = one.force - hertzian_stiffness(one, rows) * one.exact.approach();
    } else {
      one.exact.press(0, tolerance);
      one.pressed = one.force = one.exact.normal_force();
    }
    one.stiffness = hertzian_stiffness(one, rows);
  }
}

/// Presses a patch with the wheel lowered by `zeta`, the others lifting it; a secant improves its stiffness.
void press(std::vector<Loaded>& loaded, Loaded& one, double zeta, double tolerance) {
  constexpr double least_change = 5e-4; // of the force, beyond what tolerances leave
  const std::vector<PointLoad> loads = loads_on(loaded, one);
  one.exact.lift(loads);
  one.exact.press(zeta * one.cosine(), tolerance);
  one.pressed = one.exact.normal_force();
  const double approach = approach_of(one, loads, zeta);
  if (one.force_before && std::abs(one.pressed - *one.force_before) > least_change * one.pressed) {
    const double secant = (one.pressed - *one.force_before) / (approach - one.approach_before);
    if (secant > 0.5 * one.stiffness && secant < 2 * one.stiffness) one.stiffness = secant;
  }
  if (!(one.stiffness > 0)) one.stiffness = hertzian_stiffness(one, loads);
  one.force_before = one.pressed, one.approach_before = approach;
}

/// Scales pressures to the forces wanted if these differ by little: of a change, that leaves a third in the approach.
bool scale(std::vector<Loaded>& loaded) {
  constexpr double little = 1e-4, settled = 1e-6;
  for (const Loaded& one : loaded)
    if (std::abs(one.force - one.exact.normal_force()) > little * one.force || one.exact.unsettled() > settled)
      return false;
  for (Loaded& one : loaded)
    if (one.force > 0) one.exact.scale_to(one.force), one.pressed = one.force;
  return true;
}

/// Finds the normal forces and, where a vertical force [N] is given, the lowering zeta [m] with which they bear it:
/// Newton's method from `zeta` and what the patches bore there, in the first round to less accuracy. Returns zeta,
/// nothing where no load of the patches bears the force.
std::optional<double> share_load(std::vector<Loaded>& loaded, std::optional<double> vertical_force, double zeta,
                                 bool first) {
  constexpr int most_steps = 12;
  if (loaded.size() == 1) {
    constexpr double tolerance = 1e-6;
    Loaded& only = loaded.front();
    if (vertical_force && !(only.share > 0)) return {};
    if (vertical_force) only.force = *vertical_force / only.share;
    if (!vertical_force)
      only.exact.press(0, tolerance);
    else if (!scale(loaded))
      only.exact.press_with(only.force, tolerance);
    return only.exact.approach() / only.cosine();
  }
  const double tolerance = first ? 1e-4 : 2e-7;
  double of_pressures = 0.1 * tolerance;
  for (int step = 0; step < most_steps; ++step) {
    const std::optional<double> more = correct(loaded, vertical_force);
    if (!more) return {};
    zeta += *more;
    if (!first && step == 0 && scale(loaded)) break;
    double largest = 0, error = 0;
    for (Loaded& one : loaded) {
      press(loaded, one, zeta, of_pressures);
      largest = std::max(largest, one.pressed), error = std::max(error, std::abs(one.pressed - one.force));
    }
    if (error <= tolerance * largest && of_pressures <= tolerance) break;
    of_pressures = std::clamp(0.01 * error / largest, normal_tolerance, 0.1 * tolerance);
  }
  return zeta;
}

/// Of the tractions on a patch, each along the axes of its row.
double vertical_force_of(const Loaded& one) {
  const ContactSolution& s = one.solution;
  double sum = 0;
  for (std::size_t i = 0; i < s.elements.size(); ++i) {
    const double angle = one.exact.row(static_cast<int>(i) / one.exact.grid().mx).angle;
    sum += (s.fields.pressure[i] * std::cos(angle) + s.fields.traction.y[i] * std::sin(angle)) * s.elements.area[i];
  }
  return sum;
}

void sum(const CoarseContact& coarse, std::vector<Loaded>& loaded, WheelRailSolution& out) {
  const Vec3<double> centre = coarse.surface().placement().wheel.frame.origin;
  WheelForces wheel;
  out.patches.clear();
  for (Loaded& one : loaded) {
    if (!(one.exact.normal_force() > 0)) continue;
    ContactSolution& solution = one.solution;
    const PatchOutline& outline = one.group.outline;
    WheelRailPatch patch = coarse.describe(outline, one.rows.least_gap, one.rows.speed / one.rows.weight);
    patch.approach += one.exact.approach(), patch.conformity = one.exact.conformity();
    const Elements& e = solution.elements;
    const SurfaceFields& f = solution.fields;
    for (std::size_t i = 0; i < e.size(); ++i) {
      if (!(f.pressure[i] > 0)) continue;
      const Vec3<double> traction{f.traction.x[i], f.traction.y[i], f.pressure[i]};
      wheel.add(e.area[i] * traction, one.exact.row(static_cast<int>(i) / one.exact.grid().mx), e.x[i], outline.frame,
                centre, patch);
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

/// Whether patches found in a height hold when the wheel is lowered further by `lowering` [m]: it is small beside the
/// greatest overlap times the squared cosine of the inclination. Frames on steep flanks turn the more with the height.
bool hold(const std::vector<Loaded>& loaded, double lowering) {
  constexpr double small = 0.01;
  double depth = 0, cosine = 1;
  for (const Loaded& one : loaded) {
    depth = std::max(depth, -one.exact.least_gap());
    if (one.exact.normal_force() > 0) cosine = std::min(cosine, std::abs(one.cosine()));
  }
  return std::abs(lowering) <= small * depth * cosine * cosine;
}

bool hold_contacts(const std::vector<Loaded>& loaded) {
  return std::all_of(loaded.begin(), loaded.end(), [](const Loaded& one) { return one.exact.holds_contact(); });
}

/// Returns whether elements further out are of no use: there are none in the overlap.
bool cover_overlap(const std::vector<Loaded>& loaded) {
  return std::all_of(loaded.begin(), loaded.end(), [](const Loaded& one) { return one.covers_overlap; });
}

/// No load of these patches bears the vertical force: that is for other heights to find.
bool no_balance(WheelRailSolution& out, Unsolved reason = Unsolved::residual) {
  out.patches.clear(), out.fields.clear();
  out.force = out.moment = {};
  out.status = Status::not_converged, out.residual = 1, out.reason = reason;
  return true;
}

/// Solves with the patches that the coarse level has in its height. False if `others` may be found and these do not
/// hold in the height that bears the vertical force, in which the wheel is then.
bool solve_with_patches(CoarseContact& coarse, const WheelRailBodies& bodies, const WheelRailMethod& method,
                        std::optional<double> vertical_force, bool others, WheelRailSolution& out,
                        const Progress& progress) {
  constexpr int most_rounds = 12;
  std::vector<Loaded> loaded;
  double lowering = 0;
  for (const bool all_of_overlap : {false, true}) {
    loaded = loaded_groups(coarse, bodies, method, all_of_overlap, progress);
    if (loaded.empty()) {
      out.status = coarse.patches().empty() ? Status::no_contact : Status::not_converged;
      return true;
    }
    if (loaded.size() > 1) press_first(loaded);
    const std::optional<double> found = share_load(loaded, vertical_force, 0, true);
    if (!found) return no_balance(out);
    lowering = *found;
    if (hold_contacts(loaded) || cover_overlap(loaded)) break;
  }
  const auto friction = [&coarse](double angle) { return coarse.friction(angle); };
  for (int round = 0; round < most_rounds; ++round) {
    if (round > 0) {
      const std::optional<double> found = share_load(loaded, vertical_force, lowering, false);
      if (!found) return no_balance(out);
      lowering = *found;
    }
    if (round == 0 && others && vertical_force && !hold(loaded, lowering)) {
      out.vertical -= lowering;
      return false;
    }
    const bool held = hold_contacts(loaded);
    if (!held && round == 0) return no_balance(out, Unsolved::beyond_elements);
    out.status = Status::not_converged;
    if (!held) break;
    // Where elements come and go with the load no load may have the vertical force, so in the end they stay.
    const double same_elements = round < 2 ? 5e-4 : 1e-2;
    // The first round is to tell how much of the weight the tangential forces bear.
    const double tolerance = round == 0 && vertical_force ? 1e-3 : 1e-6;
    double vertical = 0;
    for (Loaded& one : loaded) {
      if (!(one.exact.normal_force() > 0)) continue;
      one.solution = one.exact.roll(friction, same_elements, tolerance);
      const double borne = vertical_force_of(one);
      one.share = borne / one.exact.normal_force();
      vertical += borne;
    }
    out.residual = vertical_force ? std::abs(vertical / *vertical_force - 1) : 0;
    for (const Loaded& one : loaded) out.residual = std::max(out.residual, one.exact.unsettled());
    if (out.residual <= method.solved_tolerance() && tolerance <= 1e-6) {
      out.status = Status::ok;
      break;
    }
  }
  if (vertical_force) out.vertical -= lowering;
  sum(coarse, loaded, out);
  return true;
}

/// In a state, from the patches of the coarse level there.
void solve_from_coarse(CoarseContact& coarse, WheelState<double> state, const WheelRailBodies& bodies,
                       const WheelRailMethod& method, std::optional<double> vertical_force, WheelRailSolution& out,
                       const Progress& progress) {
  constexpr int most_heights = 4; // the coarse level may have missed the height, or found it with other patches
  for (int k = 1; k <= most_heights; ++k) {
    out.fields.clear();
    if (solve_with_patches(coarse, bodies, method, vertical_force, k < most_heights, out, progress)) break;
    state.vertical = out.vertical;
    coarse.solve(state, {}, out);
    if (out.status == Status::no_contact) break;
  }
}

/// Forces of a wheel at given heights.
class ExactHeight {
public:
  ExactHeight(CoarseContact& coarse, const WheelState<double>& state, const WheelRailBodies& bodies,
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
    coarse_.solve(state_, {}, out_);
    if (out_.status != Status::no_contact) solve_from_coarse(coarse_, state_, bodies_, method_, {}, out_, progress_);
    if (out_.reason == Unsolved::beyond_elements) ++beyond_elements_;
    return out_.force.z / vertical_force_ - 1;
  }

  /// Brackets the height that bears the vertical force in steps that grow, from `start` on and not below `least` [m].
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
    if (beyond_elements_ > 0) { // one of these heights may bear the force
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

  CoarseContact& coarse_;
  WheelState<double> state_;
  const WheelRailBodies& bodies_;
  const WheelRailMethod& method_;
  double vertical_force_;
  WheelRailSolution& out_;
  const Progress& progress_;
  int beyond_elements_ = 0; ///< heights in which patches were beyond their elements
};

} // namespace

void solve_exact(CoarseContact& coarse, const WheelState<double>& state, const WheelRailBodies& bodies,
                 const WheelRailMethod& method, std::optional<double> vertical_force, WheelRailSolution& out,
                 const Progress& progress) {
  const int iterations = out.iterations;
  const double height = out.vertical, least = coarse.least_height(state.vertical);
  const bool coarse_failed = vertical_force && out.status != Status::ok;
  if (!coarse_failed) solve_from_coarse(coarse, state, bodies, method, vertical_force, out, progress);
  const bool is_rolling = std::all_of(out.patches.begin(), out.patches.end(),
                                      [](const WheelRailPatch& patch) { return patch.status == Status::ok; });
  if (coarse_failed || (vertical_force && out.status != Status::ok && is_rolling))
    ExactHeight(coarse, state, bodies, method, *vertical_force, out, progress).find(height, least);
  out.iterations = iterations;
}

} // namespace microslip
