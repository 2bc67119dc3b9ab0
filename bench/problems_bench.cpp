// What each kind of problem costs beside steady rolling of a Hertzian contact with as many elements in contact, one
// thread (OMP_NUM_THREADS=1). Prints a Markdown table of processor time, which other work on the machine changes less
// than elapsed time; what counts are ratios within one run, steps, products and exponents.
//   problems_bench [WORD] [most elements across; default 254]   only problems whose name has WORD

#include "bench/four_patches.hpp"
#include "microslip/elasticity/hertz.hpp"
#include "microslip/exact/classical/contact_sequence.hpp"
#include "microslip/exact/fitted/hertzian_rolling.hpp"
#include "microslip/exact/fitted/patch_rolling.hpp"
#include "microslip/interior/interior_grid.hpp"
#include "validation/clock.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace microslip;
using validation::processor_time;

/// What a problem takes. Where nothing is kept from one problem to the next the time of setting up is 0.
struct Figures {
  std::size_t elements = 0; ///< in contact
  double set_up = 0;        ///< what depends on the contact only: coefficients, transforms, pressures, edges [s]
  double solve = 0;         ///< what is left when that is known [s]
  int newton_steps = 0;
  long products = 0;
  bool solved = false;

  double total() const { return set_up + solve; }
  void take(std::size_t in_contact, int steps, long of_matrix, bool is_solved) {
    elements = in_contact, newton_steps = steps, products = of_matrix, solved = is_solved;
  }
};

struct Problem {
  const char* name;
  std::vector<int> sizes;                ///< elements across the contact
  std::function<Figures(int)> solve_one; ///< with so many
};

/// Seconds for what `make` does and then for `use` of what it has made: the shortest of some runs of each.
template <class Make, class Use> void measure(Figures& figures, const Make& make, const Use& use) {
  constexpr double enough = 0.3; // seconds in which to find the shortest run
  figures.set_up = figures.solve = HUGE_VAL;
  const double begin = processor_time();
  do {
    const double start = processor_time();
    auto made = make();
    const double ready = processor_time();
    use(made);
    figures.set_up = std::min(figures.set_up, ready - start);
    figures.solve = std::min(figures.solve, processor_time() - ready);
  } while (processor_time() - begin < enough);
}

/// A contact of steel that slides in part, with creepages in all directions.
constexpr CombinedMaterial steel{82e9, 0.28, 0};
constexpr double semi_axis_x = 5e-3, semi_axis_y = 7e-3, load = 50e3, friction = 0.3;
constexpr Creepage creepage{-6e-4, 4e-4, 0.1};

const HertzContact& hertz() {
  static const HertzContact contact = hertz_from_ellipse(semi_axis_x, semi_axis_y, steel, load);
  return contact;
}

/// n elements across the ellipse in each direction, and a margin for what the skewness adds.
ElementGrid grid_of(int n, double skewness) {
  return ElementGrid::across_ellipse(semi_axis_x, semi_axis_y, n, 4 + static_cast<int>(skewness * n));
}

/// The ellipse's gap, or one with an egg-shaped contact of about the same size.
std::vector<double> gap_on(const ElementGrid& grid, double skewness) {
  std::vector<double> gap;
  for (int j = 0; j < grid.my; ++j)
    for (int i = 0; i < grid.mx; ++i) {
      const double x = grid.x(i), y = grid.y(j);
      gap.push_back(hertz().gap.x * x * x * (1 + skewness * (x / semi_axis_x + y / semi_axis_y)) +
                    hertz().gap.y * y * y);
    }
  return gap;
}
constexpr double egg = 0.15;

Figures ellipse(int n) {
  const EllipticContact contact{.a = semi_axis_x,
                                .b = semi_axis_y,
                                .shear_modulus = steel.shear_modulus,
                                .poisson_ratio = steel.poisson_ratio,
                                .normal_force = load,
                                .friction = FrictionLaw::coulomb(friction),
                                .creepage = creepage};
  Figures figures;
  measure(
      figures, [&] { return HertzianRolling(semi_axis_x, semi_axis_y, steel, n, n); },
      [&](HertzianRolling& rolling) {
        const SecondOrderSolution s = rolling.solve(contact, {}, {}, 1e-6);
        figures.take(rolling.contact().elements.size(), s.friction.report.newton_steps, s.friction.report.products,
                     s.friction.report.status == Status::ok);
      });
  return figures;
}

/// Ellipses, one after another, that have nothing to do with one another, as the contacts of a vehicle: means of all.
Figures new_ellipses(int n) {
  constexpr int count = 300;
  std::mt19937 engine(1);
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(engine()) * 0x1p-32;
  };
  HertzianRolling rolling(n, n);
  Figures figures;
  figures.solved = true;
  for (int i = 0; i < count; ++i) {
    const EllipticContact contact{.a = between(1e-3, 8e-3),
                                  .b = between(1e-3, 8e-3),
                                  .shear_modulus = steel.shear_modulus,
                                  .poisson_ratio = steel.poisson_ratio,
                                  .normal_force = between(20e3, 120e3),
                                  .friction = FrictionLaw::coulomb(between(0.2, 0.4)),
                                  .creepage = {between(-3e-3, 3e-3), between(-3e-3, 3e-3), between(-0.5, 0.5)}};
    const double start = processor_time();
    rolling.prepare(contact.a, contact.b, steel);
    const double ready = processor_time();
    const SecondOrderSolution s = rolling.solve(contact, {}, {}, 1e-6);
    figures.set_up += (ready - start) / count;
    figures.solve += (processor_time() - ready) / count;
    figures.newton_steps += s.friction.report.newton_steps;
    figures.products += s.friction.report.products;
    figures.solved = figures.solved && s.friction.report.status == Status::ok;
  }
  figures.elements = rolling.contact().elements.size();
  figures.newton_steps /= count;
  figures.products /= count;
  return figures;
}

Figures normal_problem(int n) {
  const ElementGrid grid = grid_of(n, 0);
  const std::vector<double> gap = gap_on(grid, 0);
  Figures figures;
  measure(
      figures, [&] { return NormalProblem(steel, grid); },
      [&](NormalProblem& problem) {
        const NormalSolution s = problem.solve(gap, {NormalLoad::Given::force, load});
        figures.take(static_cast<std::size_t>(s.contact_elements), s.iterations, s.products, s.status == Status::ok);
      });
  return figures;
}

/// A ball with waves of many lengths on n x n elements: less than half of its contact touches, in many spots.
Figures rough_normal_problem(int n) {
  const double a = semi_axis_x;
  const ElementGrid grid = {.mx = n, .my = n, .x0 = -1.2 * a, .y0 = -1.2 * a, .dx = 2.4 * a / n, .dy = 2.4 * a / n};
  struct Wave {
    double kx, ky, phase, height;
  };
  std::mt19937 engine(1);
  const auto angle = [&] { return 2 * std::numbers::pi * static_cast<double>(engine()) * 0x1p-32; };
  std::vector<Wave> waves;
  for (int k = 0; k < 30; ++k) {
    const double length = a * std::pow(0.85, k), direction = angle(), number = 2 * std::numbers::pi / length;
    waves.push_back(
        {number * std::cos(direction), number * std::sin(direction), angle(), 1e-6 * std::pow(length / a, 0.8)});
  }
  std::vector<double> gap;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const double x = grid.x(i), y = grid.y(j);
      double h = (x * x + y * y) / 2;
      for (const Wave& w : waves) h += w.height * std::sin(w.kx * x + w.ky * y + w.phase);
      gap.push_back(h);
    }
  Figures figures;
  measure(
      figures, [&] { return NormalProblem(steel, grid); },
      [&](NormalProblem& problem) {
        const NormalSolution s = problem.solve(gap, {NormalLoad::Given::force, 10e3});
        figures.take(grid.count(), s.iterations, s.products, s.status == Status::ok);
      });
  return figures;
}

Figures patch(int n, double skewness) {
  const ElementGrid grid = grid_of(n, skewness);
  const std::vector<double> gap = gap_on(grid, skewness);
  Figures figures;
  measure(
      figures,
      [&] {
        return PatchRolling(steel, grid, gap, {NormalLoad::Given::force, load});
      },
      [&](PatchRolling& rolling) {
        const ContactSolution s = rolling.solve({.friction = friction, .creepage = creepage});
        figures.take(rolling.contact()->elements.size(), s.report.newton_steps, s.report.products,
                     s.report.status == Status::ok);
      });
  return figures;
}

ContactStep pressed(int n, double skewness) {
  ContactStep step;
  step.grid = grid_of(n, skewness);
  step.bodies = steel;
  step.gap = gap_on(step.grid, skewness);
  step.load = {NormalLoad::Given::force, load};
  step.friction = {FrictionLaw::coulomb(friction)};
  return step;
}

/// The classical discretisation. Solved twice, the second time with what the first has left.
Figures classical(int n, double skewness) {
  ContactStep step = pressed(n, skewness);
  step.motion.creepage = creepage;
  step.motion.tolerance = 1e-8;
  Figures figures;
  measure(
      figures,
      [&] {
        ContactSequence sequence;
        sequence.solve(step);
        return sequence;
      },
      [&](ContactSequence& sequence) {
        const ContactStepSolution s = sequence.solve(step);
        figures.take(static_cast<std::size_t>(s.contact_elements), s.report.newton_steps, s.report.products,
                     s.report.status == Status::ok);
      });
  figures.set_up -= figures.solve;
  return figures;
}

/// Four patches with waves on them, by steps of so many elements. All of it from nothing.
Figures four_patches(int n, int step_elements) {
  ContactStep step = microslip::four_patches(n);
  step.motion.step = step_elements * step.grid.dx;
  step.motion.tolerance = 1e-7;
  Figures figures;
  measure(
      figures, [] { return ContactSequence(); },
      [&](ContactSequence& sequence) {
        const ContactStepSolution s = sequence.solve(step);
        figures.take(static_cast<std::size_t>(s.contact_elements), s.report.newton_steps, s.report.products,
                     s.report.status == Status::ok);
      });
  return figures;
}

/// A first shift, by 0.6 of the sliding force.
Figures shift(int n) {
  const ElementGrid grid = grid_of(n, 0);
  const NormalSolution normal = NormalProblem(steel, grid).solve(gap_on(grid, 0), {NormalLoad::Given::force, load});
  std::vector<double> bound = normal.pressure;
  for (double& g : bound) g *= friction;
  TangentialInput input;
  input.motion = ContactMotion::shift;
  input.force_x = -0.6 * friction * load;
  input.creepage.lateral = 2e-6;
  input.tolerance = 1e-8;
  Figures figures;
  measure(
      figures, [&] { return TangentialProblem(steel, grid); },
      [&](TangentialProblem& problem) {
        const ContactSolution s = problem.solve(bound, input);
        figures.take(static_cast<std::size_t>(normal.contact_elements), s.report.newton_steps, s.report.products,
                     s.report.status == Status::ok);
      });
  return figures;
}

/// Steps of a sequence, each of which goes on from the one before; time, Newton steps and products are the mean.
template <class Change> Figures sequence(ContactStep step, int steps, const Change& change) {
  Figures figures;
  figures.solved = true;
  measure(
      figures, [] { return ContactSequence(); },
      [&](ContactSequence& contact) {
        int newton_steps = 0;
        long products = 0;
        for (int k = 0; k < steps; ++k) {
          change(step, k);
          const ContactStepSolution s = contact.solve(step);
          figures.elements = static_cast<std::size_t>(s.contact_elements);
          newton_steps += s.report.newton_steps;
          products += s.report.products;
          figures.solved = figures.solved && s.report.status == Status::ok;
        }
        figures.newton_steps = newton_steps / steps;
        figures.products = products / steps;
      });
  figures.solve /= steps;
  return figures;
}

/// From Cattaneo's shift to Carter's rolling: 57 steps of an element with the force given.
Figures onset_of_rolling(int n) {
  ContactStep step = pressed(n, 0);
  step.force_x = -0.657 * friction;
  step.motion.tolerance = 1e-7;
  return sequence(step, 57, [](ContactStep& s, int k) {
    s.motion.motion = k == 0 ? ContactMotion::shift : ContactMotion::transient;
    s.start = k == 0 ? StepStart::fresh : StepStart::previous;
  });
}

/// Spence's compression of a soft body and a rigid one whose contact grows by an element in each step.
Figures compression(int n) {
  ContactStep step;
  step.grid = {.mx = n + 20, .my = n + 20, .x0 = -0.05e-3 * (n + 19), .y0 = 0, .dx = 0.1e-3, .dy = 0.1e-3};
  step.grid.y0 = step.grid.x0;
  step.bodies = combine(Material{0.5e6, 0}, Material{1e11, 0});
  for (int j = 0; j < step.grid.my; ++j)
    for (int i = 0; i < step.grid.mx; ++i) {
      const double x = step.grid.x(i), y = step.grid.y(j);
      step.gap.push_back(4.116 * (x * x + y * y));
    }
  step.friction = {FrictionLaw::coulomb(0.2986)};
  step.motion.motion = ContactMotion::shift;
  step.motion.tolerance = 1e-6;
  return sequence(step, n, [](ContactStep& s, int k) {
    s.load = {NormalLoad::Given::force, std::pow((k + 1) / 90.0, 3)};
    s.start = k == 0 ? StepStart::fresh : StepStart::previous;
  });
}

/// Stresses below n x n loaded elements at so many depths, in all rows of elements or in one, for one set of tractions
/// after another: set-up is what the first one takes more than the next.
Figures stresses_inside(int n, int depths, bool all_rows) {
  const ElementGrid grid = ElementGrid::across_ellipse(semi_axis_x, semi_axis_y, n);
  InteriorGrid points;
  for (int i = 0; i < n; ++i) points.x.push_back(grid.x(i));
  for (int j = 0; j < n; ++j)
    if (all_rows || j == n / 2) points.y.push_back(grid.y(j));
  for (int k = 0; k < depths; ++k) points.z.push_back((0.5 + k) * grid.dx);
  std::vector<double> pressure(grid.count(), 1e9), traction(grid.count(), 2e8);
  const auto states = [&](InteriorSequence& sequence) {
    sequence.states(Material{82e9, 0.28}, Material{82e9, 0.28}, grid, {traction, traction, pressure}, points);
  };
  Figures figures;
  measure(
      figures,
      [&] {
        InteriorSequence sequence;
        states(sequence);
        return sequence;
      },
      states);
  figures.set_up -= figures.solve;
  figures.elements = grid.count();
  figures.solved = true;
  return figures;
}

/// The ellipse with a layer that hardens, from a tenth of the friction's peak on.
ContactStep on_a_layer(int n) {
  ContactStep step = pressed(n, 0);
  step.bodies.layer = {
      .flexibility = 2.5e-14, .yield_stress = 0.1 * friction * hertz().peak_pressure, .hardening = 5e12};
  step.motion.tolerance = 1e-8;
  return step;
}

/// 63 steps of transient rolling under a growing creepage.
Figures yielding_transient(int n) {
  return sequence(on_a_layer(n), 63, [](ContactStep& s, int k) {
    s.motion.motion = ContactMotion::transient;
    s.motion.creepage = {1e-4 * (k + 1), -2e-5 * (k + 1), 0.1};
    s.start = k == 0 ? StepStart::fresh : StepStart::previous;
  });
}

/// 24 creepages of steady rolling from adhesion to sliding.
Figures yielding_steady(int n) {
  return sequence(on_a_layer(n), 24, [](ContactStep& s, int k) {
    const double size = 1e-4 * std::pow(1.25, k);
    s.motion.creepage = {size, -0.3 * size, 0.1};
  });
}

/// A cylinder whose friction falls with the slip: 51 steps of a tenth of a millimetre after the steady state, as those
/// of Vollebregt & Schuttelaars (2012).
Figures falling_transient(int n) {
  const double a = 4e-3, curvature = 1 / 0.92;
  ContactStep step;
  step.grid = ElementGrid::across_line(a, n, 5);
  step.bodies = steel;
  for (int i = 0; i < step.grid.mx; ++i) step.gap.push_back(curvature * step.grid.x(i) * step.grid.x(i));
  step.load = {NormalLoad::Given::force, line_contact_from_half_width(curvature, steel, a).force_per_length};
  step.friction = {FrictionLaw::exponential(0.18, {.drop = 0.12, .half_velocity = 0.1})};
  step.motion.creepage = {-1e-3, 0, 0};
  step.motion.rolling_speed = 45;
  step.motion.step = 1e-4;
  step.motion.tolerance = 1e-8;
  return sequence(step, 52, [](ContactStep& s, int k) {
    s.motion.motion = k == 0 ? ContactMotion::steady : ContactMotion::transient;
    s.start = k == 0 ? StepStart::fresh : StepStart::previous;
  });
}

const std::vector<Problem>& problems() {
  static const std::vector<int> growing = {64, 128, 254, 506};
  static const std::vector<Problem> all = {
      {"steady, ellipse, second order", growing, ellipse},
      {"steady, gap of the ellipse, classical", growing, [](int n) { return classical(n, 0); }},
      {"steady, egg, classical", growing, [](int n) { return classical(n, egg); }},
      {"steady, a new ellipse each time, second order", {12, 24}, new_ellipses},
      {"normal problem, gap of the ellipse", {63}, normal_problem},
      {"normal problem of a rough ball, all elements", {128, 256, 506, 1024, 2048, 4096}, rough_normal_problem},
      {"steady, gap of the ellipse, second order", {12, 20, 96}, [](int n) { return patch(n, 0); }},
      {"steady, egg, second order", {20, 96, 254}, [](int n) { return patch(n, egg); }},
      {"steady, four patches, two forces, cold", {128, 254, 506}, [](int n) { return four_patches(n, 1); }},
      {"steady, four patches, steps of two elements, cold", {128, 254, 506}, [](int n) { return four_patches(n, 2); }},
      {"shift, classical", growing, shift},
      {"onset of rolling, each of 57 steps, classical", {28, 56}, onset_of_rolling},
      {"layer that yields, each of 63 transient steps", {24, 48, 96}, yielding_transient},
      {"layer that yields, each of 24 steady contacts", {24, 48, 96, 192, 400}, yielding_steady},
      {"cylinder with falling friction, each of 51 transient steps", {82}, falling_transient},
      {"Spence's compression, each of as many steps as elements across", {35, 69}, compression},
      {"stresses inside at 3 depths, a row of points", {91}, [](int n) { return stresses_inside(n, 3, false); }},
      {"stresses inside at 11 depths, all points", {45, 91, 181}, [](int n) { return stresses_inside(n, 11, true); }},
  };
  return all;
}

/// How the time grows with the elements, between the smallest size and the largest.
double growth_exponent(const Figures& small, const Figures& large) {
  return std::log(large.total() / small.total()) /
         std::log(static_cast<double>(large.elements) / static_cast<double>(small.elements));
}

constexpr int largest_ellipse = 600; ///< elements across, with which problems are compared

/// Of as many elements across.
const Figures& hertzian(int n) {
  static std::map<int, Figures> known;
  const auto found = known.find(n);
  return found != known.end() ? found->second : known[n] = ellipse(n);
}

void print(const Problem& problem, int most_across) {
  Figures first, last;
  for (const int n : problem.sizes) {
    if (n > most_across) break;
    last = problem.solve_one(n);
    if (first.elements == 0) first = last;
    std::printf("| %s | %zu | %.4f | %.4f | %d | %ld | ", problem.name, last.elements, last.set_up, last.solve,
                last.newton_steps, last.products);
    if (n <= largest_ellipse)
      std::printf("%.1f | %.1f |", last.solve / hertzian(n).solve, last.total() / hertzian(n).total());
    else
      std::printf("| |");
    std::printf("%s\n", last.solved ? "" : " not solved");
    std::fflush(stdout);
  }
  if (last.elements > first.elements)
    std::printf("| %s | growth: N^%.2f | | | | | | |\n", problem.name, growth_exponent(first, last));
}

} // namespace

int main(int argc, char** argv) {
  const std::string word = argc > 1 ? argv[1] : "";
  const int most_across = argc > 2 ? std::atoi(argv[2]) : 254;
  std::printf(
      "| problem | elements in contact | set-up [s] | solve [s] | Newton steps | products | solve / ellipse's | "
      "all / ellipse's |\n|---|---|---|---|---|---|---|---|\n");
  for (const Problem& problem : problems())
    if (std::string(problem.name).find(word) != std::string::npos) print(problem, most_across);
}
