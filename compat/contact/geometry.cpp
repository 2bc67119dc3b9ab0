#include "compat/contact/geometry.hpp"

#include "microslip/contact/limits.hpp"

#include <algorithm>
#include <string>
#include <tuple>

namespace microslip::contact_program {
namespace {

constexpr int most_points = 9999, most_heights = 10000, most_patches = 100;
constexpr int any_element = 999999; ///< indices of points may lie beyond the grid, which cuts them off

/// Names of the numbers behind MX and MY.
struct Names {
  const char* of[4];
};

constexpr Names hertzian_names[] = {{{"A1", "B1"}}, {{"A1", "AOB"}}, {{"AA", "BB"}},
                                    {{"A1", "BB"}}, {{"AA", "BB"}},  {{"AA", "BNEG", "BPOS"}}};
constexpr Names grid_names[] = {{{"XL", "YL", "DX", "DY"}},
                                {{"XL", "YL", "XH", "YH"}},
                                {{"XC1", "YC1", "DX", "DY"}},
                                {{"XC1", "YC1", "XCM", "YCM"}}};

void read_hertzian(Words& words, PotentialContact& p) {
  const Names& names = hertzian_names[-number(p.kind) - 1];
  for (std::size_t k = 0; k < 4 && names.of[k]; ++k)
    p.values[k] = words.positive(names.of[k], unit_of_hertz(p.kind, k).value());
  p.scale = words.positive("SCALE");
}

/// A point and a size, or two points.
void read_rectangle(Words& words, PotentialContact& p) {
  const Names& names = grid_names[number(p.kind) - 1];
  const bool has_sizes = p.kind == Potential::corner_and_size || p.kind == Potential::centre_and_size;
  for (std::size_t k = 0; k < 4; ++k) {
    const char* name = names.of[k];
    p.values[k] = has_sizes && k >= 2 ? words.positive(name, mm) : words.real(name, mm);
    if (has_sizes || k < 2) continue;
    const int elements = k == 2 ? p.mx : p.my;
    if (p.kind == Potential::centres && elements == 1)
      words.fail(name, p.values[k] * per_m, "gives no size to a single element; take IPOTCN = 3");
    if (!(p.values[k] > p.values[k - 2]))
      words.fail(name, p.values[k] * per_m, std::string("must be above ") + names.of[k - 2]);
  }
}

/// B1 x2 + B2 x y + B3 y2 + B4 x + B5 y + B6, or the same of a planform.
std::vector<double> read_quadratic(Words& words, const char* field) {
  return in_si(words.reals(field, 6), units_of_quadratic);
}

/// The circle along x and the heights along y.
std::vector<double> read_circle(Words& words) {
  const int count = words.integer("NN", 1, most_heights);
  const double xm = words.real("XM", mm), rm = words.real("RM", mm);
  if (rm == 0) words.fail("RM", 0, "must not be 0");
  const double y1 = words.real("Y1", mm), dy1 = count > 1 ? words.positive("DY1", mm) : words.real("DY1", mm);
  words.end_record();
  std::vector<double> values = {xm, rm, y1, dy1};
  const auto heights = words.reals("Z", static_cast<std::size_t>(count), mm);
  values.insert(values.end(), heights.begin(), heights.end());
  return values;
}

std::vector<double> read_waves(Words& words) {
  const auto values = words.reals("B", 8);
  for (const std::size_t k : {6u, 7u})
    if (values[k] == 0) words.fail("B(" + std::to_string(k + 1) + ")", 0, "must not be 0");
  return in_si(values, units_of_waves);
}

/// XL XH YL YH of two rectangles.
std::vector<double> read_rectangles(Words& words) {
  auto values = words.reals("PL", 8, mm);
  for (std::size_t k = 1; k < values.size(); k += 2)
    if (!(values[k] > values[k - 1]))
      words.fail("PL(" + std::to_string(k + 1) + ")", values[k] * per_m, "must be above PL(" + std::to_string(k) + ")");
  return values;
}

/// The number of sub-patches, y between them, and by how much each of a pair acts on the other.
std::vector<double> read_sub_patches(Words& words) {
  const int count = words.integer("NPATCH", 1, most_patches);
  words.end_record();
  const auto patches = static_cast<std::size_t>(count);
  std::vector<double> values = {static_cast<double>(count)};
  for (const auto& [field, number, unit] :
       {std::tuple{"YSEP", patches - 1, mm}, {"FAC", patches * (patches - 1) / 2, 1.0}}) {
    if (number == 0) continue;
    const auto part = words.reals(field, number, unit);
    const bool separates = values.size() == 1;
    for (std::size_t k = 1; separates && k < part.size(); ++k)
      if (!(part[k] > part[k - 1]))
        words.fail("YSEP(" + std::to_string(k + 1) + ")", part[k] * per_m,
                   "must be above YSEP(" + std::to_string(k) + ")");
    values.insert(values.end(), part.begin(), part.end());
  }
  return values;
}

std::vector<double> read_indices(Words& words, const char* axis, int count) {
  std::vector<double> indices;
  indices.reserve(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) indices.push_back(words.integer(axis, 1, any_element));
  words.end_record();
  return indices;
}

/// A block of points.
PointBlock read_block(Words& words) {
  PointBlock points;
  points.kind = read_choice<Points>(words);
  words.end_record();
  const auto count = [&](const char* field) { return words.integer(field, 1, most_points); };
  const auto coordinates = [&](const char* field, int number) {
    return words.reals(field, static_cast<std::size_t>(number), mm);
  };
  switch (points.kind) {
  case Points::end:
    return points;
  case Points::range:
  case Points::range_at:
    for (const char* axis : {"IX", "IY"}) {
      const std::string name = axis;
      const int low = words.integer(name + "L", 1, any_element), step = words.integer(name + "INC", 0, any_element);
      points.range.insert(points.range.end(), {low, std::max(step, 1), words.integer(name + "H", low, any_element)});
      words.end_record();
    }
    break;
  case Points::listed:
  case Points::listed_at: {
    const int nx = count("NX"), ny = count("NY");
    words.end_record();
    points.x = read_indices(words, "IX", nx);
    points.y = read_indices(words, "IY", ny);
    break;
  }
  case Points::anywhere: {
    const int nx = count("NX"), ny = count("NY"), nz = count("NZ");
    words.end_record();
    points.x = coordinates("X", nx);
    points.y = coordinates("Y", ny);
    points.z = coordinates("Z", nz);
    return points;
  }
  case Points::all:
  case Points::all_at:
    break;
  }
  const int nz = count("NZ");
  if (points.has_equal_depths()) {
    const double zl = words.real("ZL", mm), dz = words.real("DZ", mm);
    points.z = {static_cast<double>(nz), zl, dz};
    words.end_record();
  } else {
    words.end_record();
    points.z = coordinates("Z", nz);
  }
  return points;
}

} // namespace

Unit unit_of_hertz(Potential kind, std::size_t k) {
  if (kind == Potential::curvatures || (kind == Potential::line_curvature && k == 0)) return -1;
  if (kind == Potential::curvature_and_ratio) return k == 0 ? -1 : 0;
  return 1;
}

PotentialContact read_potential_contact(Words& words) {
  PotentialContact p;
  p.kind = read_choice<Potential>(words);
  words.end_record();
  p.mx = words.integer("MX", 1, most_cells);
  p.my = words.integer("MY", 1, most_cells);
  if (p.is_hertzian())
    read_hertzian(words, p);
  else
    read_rectangle(words, p);
  words.end_record();
  return p;
}

Geometry read_geometry(Words& words, const PotentialContact& potential) {
  Geometry g;
  g.base = read_choice<Base>(words);
  g.planform = read_choice<Planform>(words);
  words.end_record();
  if (g.base == Base::quadratic) g.values = read_quadratic(words, "B");
  if (g.base == Base::circle) g.values = read_circle(words);
  if (g.base == Base::waves) g.values = read_waves(words);
  if (g.base == Base::by_element) g.values = words.reals("H", potential.elements(), mm);
  if (g.planform == Planform::quadratic) g.plan_values = read_quadratic(words, "PL");
  if (g.planform == Planform::rectangles) g.plan_values = read_rectangles(words);
  if (g.planform == Planform::sub_patches) g.plan_values = read_sub_patches(words);
  return g;
}

std::vector<PointBlock> read_points(Words& words) {
  std::vector<PointBlock> blocks;
  for (;;) {
    PointBlock block = read_block(words);
    if (block.kind == Points::end) return blocks;
    blocks.push_back(std::move(block));
  }
}

} // namespace microslip::contact_program
