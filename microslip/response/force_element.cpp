#include "microslip/response/force_element.hpp"

#include "microslip/decimal.hpp"
#include "microslip/error.hpp"
#include "microslip/numerics/rational_fit.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace microslip {

using Complex = std::complex<double>;

namespace {

constexpr std::size_t functions = element_inputs * element_outputs;

Complex response_of(const ForceResponse& r, std::size_t force, std::size_t input) {
  return input < 3 ? r.by_creepage[force][input] : r.by_load[force];
}

std::array<double, element_inputs> numbers_of(const ElementInput& input) {
  return {input.creepage.longitudinal, input.creepage.lateral, input.creepage.spin, input.normal_force};
}

/// (e^z - 1)/z and (e^z - 1 - z)/z^2
std::pair<Complex, Complex> exponential_means(Complex z) {
  if (std::abs(z) > 0.5) {
    const Complex first = (std::exp(z) - 1.0) / z;
    return {first, (first - 1.0) / z};
  }
  Complex second = 0;
  for (int k = 18; k >= 2; --k) second = (second * z + 1.0) / static_cast<double>(k); // 1/2 + z/6 + z^2/24 + ...
  return {1.0 + z * second, second};
}

} // namespace

Complex ForceElementFit::response(std::size_t force, std::size_t input, double wavenumber) const {
  const Complex s(0, wavenumber);
  const std::size_t f = force * element_inputs + input;
  Complex sum = constants[f];
  for (std::size_t n = 0; n < poles.size(); ++n) {
    sum += residues[n][f] / (s - poles[n]);
    if (poles[n].imag() > 0) sum += std::conj(residues[n][f]) / (s - std::conj(poles[n]));
  }
  return sum;
}

int ForceElementFit::count() const {
  int order = 0;
  for (const Complex pole : poles) order += pole.imag() > 0 ? 2 : 1;
  return order;
}

double ForceElementFit::largest_error() const {
  return *std::max_element(errors.begin(), errors.end());
}

ForceElementFit fit_force_element(const FrequencyResponse& response, double normal_force, int order) {
  constexpr double nothing = 1e-6; // of a response, over the force's largest by inputs of a like size
  require_positive("normal_force", normal_force, "N");
  if (response.at.empty()) throw Error("fit: there are no responses, as the steady state is not solved");
  ForceElementFit fit{
      .steady = {response.solution.creepage, normal_force},
      .forces = {response.solution.totals.fx, response.solution.totals.fy, response.solution.totals.mz}};
  std::vector<double> wavenumbers;
  for (const ForceResponse& r : response.at) wavenumbers.push_back(r.wavenumber);
  // Inputs of a like size: creepages of 1, the load by itself, spin by the contact's length.
  const double length = std::sqrt(response.solution.totals.adhesion_area + response.solution.totals.slip_area);
  const std::array<double, element_inputs> unit = {1, 1, length > 0 ? 1 / length : 1, normal_force};
  std::vector<std::vector<Complex>> values(functions);
  std::vector<std::size_t> fitted;
  for (std::size_t force = 0; force < element_outputs; ++force) {
    std::array<double, element_inputs> size = {};
    for (std::size_t input = 0; input < element_inputs; ++input)
      for (const ForceResponse& r : response.at)
        size[input] = std::max(size[input], unit[input] * std::abs(response_of(r, force, input)));
    const double most = *std::max_element(size.begin(), size.end());
    for (std::size_t input = 0; input < element_inputs; ++input) {
      if (!(size[input] > nothing * most)) continue;
      const std::size_t f = force * element_inputs + input;
      for (const ForceResponse& r : response.at) values[f].push_back(response_of(r, force, input));
      fitted.push_back(f);
    }
  }
  std::vector<std::vector<Complex>> chosen;
  chosen.reserve(fitted.size());
  for (const std::size_t f : fitted) chosen.push_back(values[f]);
  const RationalFit found = fit_rational(wavenumbers, chosen, order);
  fit.poles = found.poles;
  fit.residues.resize(found.poles.size());
  for (std::size_t i = 0; i < fitted.size(); ++i) {
    const std::size_t f = fitted[i];
    fit.constants[f] = found.constants[i], fit.errors[f] = found.errors[i];
    for (std::size_t n = 0; n < found.poles.size(); ++n) fit.residues[n][f] = found.residues[i][n];
  }
  return fit;
}

namespace {

constexpr std::string_view first_line = "microslip force element 1";

void add_line(std::string& text, std::string_view name, std::span<const double> numbers) {
  text += name;
  for (const double number : numbers) text += ' ' + shortest_text(number);
  text += '\n';
}

/// Reads lines of a name and numbers.
class Lines {
public:
  explicit Lines(std::string_view text) : rest_(text) {}

  std::string_view next() {
    if (rest_.empty()) fail("must go on");
    ++line_;
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
  }
  /// Of the next line, which begins with a name.
  std::vector<double> numbers(std::string_view name, std::size_t count) {
    std::string_view line = next();
    if (!line.starts_with(name)) fail("must begin with " + std::string(name));
    line.remove_prefix(name.size());
    std::vector<double> out;
    const char* const last = line.data() + line.size();
    for (const char* at = line.data(); at != last;) {
      if (*at == ' ') {
        ++at;
        continue;
      }
      double value = 0;
      const auto read = read_number(at, last, value);
      if (read.ec != std::errc{} || !std::isfinite(value)) fail("has something else than numbers");
      out.push_back(value);
      at = read.ptr;
    }
    if (out.size() != count) fail("must have " + std::to_string(count) + " numbers");
    return out;
  }
  /// There is nothing more.
  void end() {
    while (!rest_.empty())
      if (!next().empty()) fail("is after the last pole");
  }
  [[noreturn]] void fail(const std::string& text) const {
    throw Error("force element, line " + std::to_string(line_) + ": " + text);
  }

private:
  std::string_view rest_;
  int line_ = 0;
};

} // namespace

std::string text_of(const ForceElementFit& fit) {
  std::string text = std::string(first_line) + '\n';
  add_line(text, "steady", numbers_of(fit.steady));
  add_line(text, "forces", std::array{fit.forces.fx, fit.forces.fy, fit.forces.mz});
  add_line(text, "constants", fit.constants);
  add_line(text, "errors", fit.errors);
  add_line(text, "poles", std::array{static_cast<double>(fit.poles.size())});
  for (std::size_t n = 0; n < fit.poles.size(); ++n) {
    std::vector<double> numbers = {fit.poles[n].real(), fit.poles[n].imag()};
    for (const Complex r : fit.residues[n]) numbers.push_back(r.real()), numbers.push_back(r.imag());
    add_line(text, "pole", numbers);
  }
  return text;
}

ForceElementFit force_element_from(std::string_view text) {
  constexpr double most_poles = 1000;
  Lines lines(text);
  if (lines.next() != first_line) lines.fail("must be \"" + std::string(first_line) + "\"");
  ForceElementFit fit;
  const auto steady = lines.numbers("steady", element_inputs);
  fit.steady = {{steady[0], steady[1], steady[2]}, steady[3]};
  const auto forces = lines.numbers("forces", element_outputs);
  fit.forces = {forces[0], forces[1], forces[2]};
  const auto constants = lines.numbers("constants", functions), errors = lines.numbers("errors", functions);
  std::copy(constants.begin(), constants.end(), fit.constants.begin());
  std::copy(errors.begin(), errors.end(), fit.errors.begin());
  const double count = lines.numbers("poles", 1)[0];
  if (!(count >= 0 && count <= most_poles) || count != std::floor(count)) lines.fail("must be 0 to 1000 poles");
  for (int n = 0; n < static_cast<int>(count); ++n) {
    const auto numbers = lines.numbers("pole", 2 + 2 * functions);
    if (!(numbers[0] < 0) || numbers[1] < 0) lines.fail("must be a stable pole, of no negative imaginary part");
    fit.poles.emplace_back(numbers[0], numbers[1]);
    auto& residues = fit.residues.emplace_back();
    for (std::size_t f = 0; f < functions; ++f) {
      residues[f] = {numbers[2 + 2 * f], numbers[3 + 2 * f]};
      if (numbers[1] == 0 && residues[f].imag() != 0) lines.fail("must have real residues, as its pole is");
    }
  }
  lines.end();
  return fit;
}

ForceElement::ForceElement(ForceElementFit fit)
    : fit_(std::move(fit)), memory_(fit_.poles.size() * element_inputs), weights_(fit_.poles.size()) {}

ForceElement::Changes ForceElement::changes_of(const ElementInput& input) const {
  Changes out = numbers_of(input);
  const Changes steady = numbers_of(fit_.steady);
  for (std::size_t i = 0; i < out.size(); ++i) out[i] -= steady[i];
  return out;
}

/// z' = p z + u over the distance, with u linear in it: exact.
void ForceElement::advance(double distance, const Changes& from, const Changes& to) {
  if (distance != distance_) {
    for (std::size_t n = 0; n < weights_.size(); ++n) {
      const Complex z = fit_.poles[n] * distance;
      const auto [first, second] = exponential_means(z);
      weights_[n] = {std::exp(z), distance * (first - second), distance * second};
    }
    distance_ = distance;
  }
  Complex* memory = memory_.data();
  for (const Weights& w : weights_)
    for (std::size_t i = 0; i < element_inputs; ++i, ++memory)
      *memory = w.kept * *memory + w.before * from[i] + w.after * to[i];
}

ElementForces ForceElement::step(double distance, const ElementInput& input) {
  const Changes to = changes_of(input);
  advance(distance, last_, to);
  last_ = to;
  return forces(input);
}

ElementForces ForceElement::step_held(double distance, const ElementInput& input) {
  last_ = changes_of(input);
  advance(distance, last_, last_);
  return forces(input);
}

ElementForces ForceElement::forces(const ElementInput& input) const {
  const Changes u = changes_of(input);
  std::array<double, element_outputs> out = {fit_.forces.fx, fit_.forces.fy, fit_.forces.mz};
  for (std::size_t force = 0; force < element_outputs; ++force)
    for (std::size_t i = 0; i < element_inputs; ++i) out[force] += fit_.constants[force * element_inputs + i] * u[i];
  for (std::size_t n = 0; n < fit_.poles.size(); ++n) {
    const double pair = fit_.poles[n].imag() > 0 ? 2 : 1;
    for (std::size_t f = 0; f < functions; ++f)
      out[f / element_inputs] += pair * (fit_.residues[n][f] * memory_[n * element_inputs + f % element_inputs]).real();
  }
  return {out[0], out[1], out[2]};
}

void ForceElement::reset(const ElementInput& input) {
  last_ = changes_of(input);
  for (std::size_t n = 0; n < fit_.poles.size(); ++n)
    for (std::size_t i = 0; i < element_inputs; ++i) memory_[n * element_inputs + i] = -last_[i] / fit_.poles[n];
}

std::vector<double> ForceElement::state() const {
  std::vector<double> out(state_size());
  copy_state(out);
  return out;
}

void ForceElement::copy_state(std::span<double> state) const {
  for (std::size_t k = 0; k < memory_.size(); ++k)
    state[2 * k] = memory_[k].real(), state[2 * k + 1] = memory_[k].imag();
  std::copy(last_.begin(), last_.end(), state.end() - element_inputs);
}

void ForceElement::set_state(std::span<const double> state) {
  if (state.size() != state_size())
    throw Error("state: must have " + std::to_string(state_size()) + " numbers, not " + std::to_string(state.size()));
  for (std::size_t k = 0; k < memory_.size(); ++k) memory_[k] = {state[2 * k], state[2 * k + 1]};
  std::copy_n(state.end() - element_inputs, element_inputs, last_.begin());
}

} // namespace microslip
