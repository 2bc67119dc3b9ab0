#include "compat/libcontact/arguments.hpp"
#include "compat/libcontact/call.hpp"

#include <algorithm>

// Displacements and stresses inside the bodies.

namespace microslip::libcontact {
namespace {

using namespace contact_program;

constexpr int most_blocks = 10, most_points = 9999, any_element = 999999, most_columns = 1000;

bool is_kind(int isubs) {
  return isubs >= 1 && isubs <= 9 && isubs != 4 && isubs != 8;
}

std::vector<double> lengths(std::span<const double> values, double unit) {
  std::vector<double> found(values.begin(), values.end());
  for (double& value : found) value *= unit;
  return found;
}

std::vector<double> indices(const char* name, std::span<const double> values) {
  std::vector<double> found;
  for (const double value : values) found.push_back(as_integer(name, value, 1, any_element));
  return found;
}

/// IXL, IXINC, IXH.
void add_range(std::vector<int>& range, const char* name, std::span<const double> v) {
  require_count(name, v.size(), 3, 3);
  const int low = as_integer(name, std::max(1.0, v[0]), 1, any_element);
  const int step = as_integer(name, std::max(1.0, v[1]), 1, any_element);
  range.insert(range.end(), {low, step, as_integer(name, std::min<double>(any_element, v[2]), low, any_element)});
}

PointBlock block(int isubs, std::span<const double> x, std::span<const double> y, std::span<const double> z,
                 double unit) {
  PointBlock b;
  b.kind = static_cast<Points>(isubs);
  if (b.kind == Points::range || b.kind == Points::range_at) {
    add_range(b.range, "xparam", x);
    add_range(b.range, "yparam", y);
  }
  const bool is_listed = b.kind == Points::listed || b.kind == Points::listed_at;
  if (is_listed || b.kind == Points::anywhere) {
    require_count("xparam", x.size(), 1, most_points);
    require_count("yparam", y.size(), 1, most_points);
    b.x = is_listed ? indices("xparam", x) : lengths(x, unit);
    b.y = is_listed ? indices("yparam", y) : lengths(y, unit);
  }
  if (b.has_equal_depths()) {
    constexpr double least = 1e-12; // [m]
    require_count("zparam", z.size(), 3, 3);
    b.z = {static_cast<double>(as_integer("NZ", z[0], 1, most_points)), z[1] * unit, std::max(least, z[2] * unit)};
  } else {
    require_count("zparam", z.size(), 1, most_points);
    b.z = lengths(z, unit);
  }
  return b;
}

/// Stores a block at its number; those behind it go. Number 0 lets all go.
void add_block(ContactProblem& p, int icp, int number, const PointBlock* b) {
  auto& blocks = p.points(icp);
  const int count = static_cast<int>(blocks.size());
  if (number < 0 || number > std::min(most_blocks, count + 1))
    throw Refusal(CNTC_err_other, "iblk = " + std::to_string(number) + ": must be in 0 to " +
                                      std::to_string(std::min(most_blocks, count + 1)));
  blocks.resize(static_cast<std::size_t>(std::max(0, number - 1)));
  if (b) blocks.push_back(*b);
}

const InteriorBlock& found_block(const ContactProblem& p, int icp, int number) {
  const auto& blocks = p.interior(icp);
  if (number < 1 || number > static_cast<int>(blocks.size()))
    throw Refusal(CNTC_err_other, "there is no block " + std::to_string(number));
  return blocks[static_cast<std::size_t>(number) - 1];
}

/// A column of the table; nothing for one that does not exist. by `length` and `stress` in
/// the units of the call.
std::optional<double> value(const InteriorBlock& b, std::size_t k, int column, double length, double stress) {
  const InteriorState& state = b.states[k];
  const auto& s = state.stress;
  const double places[] = {b.points.x_of(k), b.points.y_of(k), b.points.z_of(k), state.ux, state.uy, state.uz};
  if (column >= 1 && column <= 6) return places[column - 1] * length;
  const auto principal = principal_stresses(s);
  const double stresses[] = {hydrostatic(s), von_mises(s), tresca(s), principal[0], principal[1],
                             principal[2],   s.xx,         s.xy,      s.xz,         s.xy,
                             s.yy,           s.yz,         s.xz,      s.yz,         s.zz};
  if (column >= 7 && column <= 21) return stresses[column - 7] * stress;
  return {};
}

} // namespace

extern "C" {

// NOLINTNEXTLINE(readability-function-size): as CONTACT's callers have it
int subs_addblock(int* ire, int* icp, int* iblk, int* isubs, int* nx, int* ny, int* nz, double* xparam, double* yparam,
                  double* zparam) {
  return guarded(either_call(__func__, ire, icp), [&](ContactProblem& p) {
    const int number = integer("iblk", iblk), kind = integer("isubs", isubs);
    if (number == 0) return add_block(p, *icp, 0, nullptr);
    if (!is_kind(kind)) throw Refusal(CNTC_err_other, "isubs = " + std::to_string(kind) + " does not exist");
    const bool has_places = kind != 1 && kind != 5; // else CONTACT's callers may give anything
    const auto x = has_places ? reals("xparam", nx, xparam) : std::span<const double>();
    const auto y = has_places ? reals("yparam", ny, yparam) : std::span<const double>();
    const PointBlock b = block(kind, x, y, reals("zparam", nz, zparam), p.units.length());
    add_block(p, *icp, number, &b);
  });
}

int subs_getblocksize(int* ire, int* icp, int* iblk, int* nx, int* ny, int* nz) {
  return get_numbers<int>(
      either_call(__func__, ire, icp), {{"nx", nx, -1}, {"ny", ny, -1}, {"nz", nz, -1}}, [&](ContactProblem& p) {
        const int patch = *icp < 0 ? 1 : *icp; // the points of all patches are the same, unless a patch has others
        const auto& points = found_block(p, patch, integer("iblk", iblk)).points;
        return std::array{int(points.x.size()), int(points.y.size()), int(points.z.size())};
      });
}

int subs_getresults(int* ire, int* icp, int* iblk, int* lenarr, int* ncol, int* icol, double* values) {
  return answered(patch_call(__func__, ire, icp), into(results(lenarr, ncol, values)), [&](ContactProblem& p) {
    const InteriorBlock& b = found_block(p, *icp, integer("iblk", iblk));
    const auto columns = integers("icol", ncol, icol);
    const int rows = integer("lenarr", lenarr);
    if (rows < 0 || columns.size() > most_columns) throw Refusal(CNTC_err_other, "lenarr or ncol is out of range");
    if (rows > 0 && !columns.empty()) given("values", values);
    const auto length = static_cast<std::size_t>(rows);
    constexpr double none = -999;
    for (std::size_t c = 0; c < columns.size(); ++c)
      for (std::size_t k = 0; k < length; ++k) {
        const bool exists = columns[c] >= 1 && columns[c] <= 21;
        double& place = values[c * length + k];
        if (!exists)
          place = none;
        else if (k < b.states.size())
          place = *value(b, k, columns[c], p.units.per_length(), p.units.per_pressure());
      }
  });
}

} // extern "C"
} // namespace microslip::libcontact
