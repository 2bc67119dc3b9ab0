#include "compat/contact/influence_file.hpp"

#include "compat/contact/units.hpp"
#include "compat/contact/words.hpp"
#include "microslip/contact/limits.hpp"

#include <utility>

namespace microslip::contact_program {
namespace {

/// The coefficients in the file's order.
constexpr std::pair<const char*, double FullInfluence::*> columns[] = {
    {"Czz", &FullInfluence::zz}, {"Czx", &FullInfluence::zx}, {"Czy", &FullInfluence::zy},
    {"Cxz", &FullInfluence::xz}, {"Cxx", &FullInfluence::xx}, {"Cxy", &FullInfluence::xy},
    {"Cyz", &FullInfluence::yz}, {"Cyx", &FullInfluence::yx}, {"Cyy", &FullInfluence::yy}};

void read_header(Words& words) {
  words.integer("NMATRIX", 1, 1);
  words.integer("IACONVEX", 0, 2);
  words.end_record();
  words.integer("LQUASID", 0, 0);
  words.integer("XYZORDER", 312, 312);
  words.end_record();
  words.integer("LSYMMX", 1, 1);
  words.integer("LSYMMY", 0, 0);
  words.end_record();
}

} // namespace

InfluenceFile read_influence_file(std::istream& stream, const std::string& name) {
  Words words(stream, name);
  read_header(words);
  const int mx = words.integer("MX", 1, most_cells), my = words.integer("MY", 1, most_cells);
  const double dx = words.positive("DX"), dy = words.positive("DY");
  words.end_record();
  InfluenceFile file{name, InfluenceTable(mx, my, dx, dy)};
  for (int j = 1 - my; j < my; ++j) {
    words.skip_lines(2);
    for (int i = 0; i < mx; ++i) {
      words.integer("IX", i, i);
      words.real("X");
      for (const auto& [field, column] : columns) file.table.at(i, j).*column = words.real(field);
      words.end_record();
    }
  }
  return file;
}

std::shared_ptr<const InfluenceTable> InfluenceFile::in_si(double shear_modulus) const {
  const InfluenceTable& from = table;
  auto to = std::make_shared<InfluenceTable>(from.mx(), from.my(), from.dx() * mm, from.dy() * mm);
  for (int j = 1 - from.my(); j < from.my(); ++j)
    for (int i = 0; i < from.mx(); ++i) {
      const FullInfluence a = from.find(i, j);
      for (const auto& [field, column] : columns) to->at(i, j).*column = a.*column * mm / shear_modulus;
    }
  return to;
}

} // namespace microslip::contact_program
