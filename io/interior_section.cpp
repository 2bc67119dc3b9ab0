#include "io/interior_section.hpp"

#include "microslip/contact/limits.hpp"
#include "microslip/error.hpp"

namespace microslip::io {

InteriorGrid read_interior(const TomlSection& interior, std::size_t solutions) {
  interior.allow_described();
  InteriorGrid points{interior.numbers("x"), interior.numbers("y"), interior.numbers("z")};
  interior.at("z", [&] {
    if (points.x.size() * points.y.size() > most_interior_points / points.z.size() / solutions)
      throw Error("[interior]: more than two million points");
  });
  return points;
}

} // namespace microslip::io
