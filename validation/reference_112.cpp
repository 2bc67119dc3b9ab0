#include "validation/reference_112.hpp"

#include "microslip/error.hpp"
#include "validation/test_set.hpp"

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

constexpr const char* reference_file = MICROSLIP_REFERENCE_DATA "/exact_theory_112.csv";

/// A line of numbers; Error if there are not `count`.
std::vector<double> numbers(const std::string& line, std::size_t count) {
  std::vector<double> values;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');) {
    std::istringstream text(cell);
    double value = 0;
    if (!(text >> value)) throw Error(std::string(reference_file) + ": '" + cell + "' is not a number");
    values.push_back(value);
  }
  if (values.size() != count) throw Error(std::string(reference_file) + ": a line has not the columns expected");
  return values;
}

/// The case of our test set with that number, after a check that it has these creepages (phi in 1/mm).
EllipticContact contact_of(const std::vector<EllipticContact>& all, int number, double xi, double eta, double phi) {
  const auto index = static_cast<std::size_t>(number - 1);
  if (index >= all.size()) throw Error(fmt::format("{}: there is no case {}", reference_file, number));
  const Creepage& c = all[index].creepage;
  const double scale = std::abs(xi) + std::abs(eta) + 1e-6;
  const bool same = std::abs(c.longitudinal - xi) <= 1e-5 * scale && std::abs(c.lateral - eta) <= 1e-5 * scale &&
                    std::abs(c.spin * 1e-3 - phi) <= 1e-5 * (phi + 1e-9);
  if (!same) throw Error(fmt::format("{}: case {} has other creepages", reference_file, number));
  return all[index];
}

} // namespace

std::vector<Reference112> read_reference_112() {
  const auto all = test_set_contacts();
  std::vector<Reference112> cases;
  std::ifstream in(reference_file);
  bool head = true;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    if (head) { // the names of the columns
      head = false;
      continue;
    }
    const auto v = numbers(line, 21);
    cases.push_back(
        {contact_of(all, static_cast<int>(v[0]), v[5], v[6], v[7]), {v[11], v[12], v[13]}, {v[17], v[18], v[19]}});
  }
  return cases;
}

} // namespace microslip::validation
