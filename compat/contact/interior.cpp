#include "compat/contact/interior.hpp"

#include "compat/contact/set_up.hpp"
#include "microslip/contact/limits.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>

#include <fmt/format.h>

namespace microslip::contact_program {
namespace {

/// The columns, or rows, of elements that a block names, from 0, as far as the grid has them; `part` is 0 for x, 1 for
/// y.
std::vector<int> elements_of(const PointBlock& block, std::size_t part, int count) {
  std::vector<int> indices;
  if (block.kind == Points::all || block.kind == Points::all_at) {
    indices.resize(static_cast<std::size_t>(count));
    std::iota(indices.begin(), indices.end(), 0);
  } else if (block.kind == Points::range || block.kind == Points::range_at) {
    const int first = block.range[3 * part], step = block.range[3 * part + 1], last = block.range[3 * part + 2];
    for (int k = first; k <= std::min(last, count); k += step) indices.push_back(k - 1);
  } else {
    for (const double k : part == 0 ? block.x : block.y) indices.push_back(static_cast<int>(k) - 1);
  }
  std::erase_if(indices, [&](int k) { return k >= count; });
  std::sort(indices.begin(), indices.end());
  indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
  if (indices.empty()) throw Error(std::string("ISUBS: ") + (part == 0 ? "IX" : "IY") + ": no element of the grid");
  return indices;
}

std::vector<double> coordinates(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values;
}

InteriorGrid points_of(const PointBlock& block, const ElementGrid& grid) {
  InteriorGrid points;
  if (block.kind == Points::anywhere) {
    points.x = coordinates(block.x);
    points.y = coordinates(block.y);
  } else {
    for (const int i : elements_of(block, 0, grid.mx)) points.x.push_back(grid.x(i));
    for (const int j : elements_of(block, 1, grid.my)) points.y.push_back(grid.y(j));
  }
  if (block.has_equal_depths())
    for (int k = 0; k < static_cast<int>(block.z[0]); ++k) points.z.push_back(block.z[1] + k * block.z[2]);
  else
    points.z = coordinates(block.z);
  if (points.x.size() * points.y.size() > most_interior_points / points.z.size())
    throw Error("ISUBS: more than two million points in a block");
  return points;
}

/// FG and TC of a viscoelastic body: a part of its displacements is retarded.
InteriorBody body_of(const Case& c, std::size_t body) {
  const MaterialData& m = *c.material;
  const Material material = {body == 0 ? m.shear1 : m.shear2, body == 0 ? m.poisson1 : m.poisson2};
  if (c.digits.mater != Bulk::viscoelastic) return material;
  return {material, retardation_of(creep_of(c, body), rolling_velocity(c))};
}

std::string row(const std::vector<double>& values) {
  std::string line;
  for (const double value : values) fmt::format_to(std::back_inserter(line), " {:13.6g}", value);
  return line + "\n";
}

} // namespace

std::vector<InteriorBlock> interior_blocks(const Case& c, const ContactStep& step, const ContactStepSolution& solution,
                                           InteriorSequence& sequence, const Progress& progress) {
  std::vector<InteriorBlock> fields;
  if (c.digits.stress == InteriorPoints::none) return fields;
  const auto& [px, py] = solution.fields.traction;
  for (const PointBlock& block : c.points) {
    const InteriorGrid points = points_of(block, step.grid);
    auto states =
        sequence.states(body_of(c, 0), body_of(c, 1), step.grid, {px, py, solution.fields.pressure}, points, progress);
    fields.push_back({points, std::move(states)});
  }
  return fields;
}

std::string subs_text(const Case& c, const std::vector<InteriorBlock>& blocks) {
  const bool all = c.subs_file == SubsFile::components;
  std::string text;
  for (const auto& [points, states] : blocks) {
    std::vector<double> sizes(all ? 14 : 8, 0);
    sizes[0] = static_cast<double>(points.x.size());
    sizes[1] = static_cast<double>(points.y.size());
    sizes[2] = static_cast<double>(points.z.size());
    text += "%  NX  NY  NZ\n" + row(sizes) + "%  X  Y  Z  UX  UY  UZ  SIGHYD  SIGVM" +
            (all ? "  SIGXX  SIGXY  SIGXZ  SIGYY  SIGYZ  SIGZZ\n" : "\n");
    for (std::size_t k = 0; k < states.size(); ++k) {
      const auto& [ux, uy, uz, s] = states[k];
      std::vector<double> values = {
          points.x_of(k) * per_m,  points.y_of(k) * per_m, points.z_of(k) * per_m, ux * per_m, uy * per_m, uz * per_m,
          hydrostatic(s) * per_pa, von_mises(s) * per_pa};
      if (all)
        for (const double component : {s.xx, s.xy, s.xz, s.yy, s.yz, s.zz}) values.push_back(component * per_pa);
      text += row(values);
    }
  }
  return text;
}

} // namespace microslip::contact_program
