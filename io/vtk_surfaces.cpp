#include "io/vtk_surfaces.hpp"

#include "io/output_file.hpp"
#include "io/result_reader.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

namespace microslip::io {
namespace {

namespace fs = std::filesystem;
using Point = std::array<double, 3>;
using Group = std::vector<const StoredDataset*>;

/// A group of the file: "left/fields/0" and ("left/patches", 0), or "exact/fields" and "".
struct PlaceOfGroup {
  std::string patches;
  std::size_t number = 0;
};

PlaceOfGroup place_of(const std::string& group) {
  const auto last = group.rfind('/');
  const std::string_view before = std::string_view(group).substr(0, last == std::string::npos ? 0 : last);
  if (!before.ends_with("fields")) return {};
  return {std::string(before.substr(0, before.size() - std::string_view("fields").size())) + "patches",
          std::stoul(group.substr(last + 1))};
}

/// Where a contact lies, and its axis across the rolling direction turned by an angle about x.
struct Frame {
  Point origin = {};
  double cosine = 1, sine = 0;

  Point turned(double x, double y, double z) const { return {x, cosine * y - sine * z, sine * y + cosine * z}; }
  Point at(double x, double y) const {
    const Point p = turned(x, y, 0);
    return {origin[0] + p[0], origin[1] + p[1], origin[2] + p[2]};
  }
};

class Writer {
public:
  Writer(const fs::path& result_file, fs::path vtp) : reader_(result_file), vtp_(std::move(vtp)) {
    for (const StoredDataset& d : reader_.datasets()) {
      by_path_[d.path()] = &d;
      if (d.shape.size() == 2 && d.group.find("fields") != std::string::npos) groups_[d.group].push_back(&d);
    }
    if (groups_.empty())
      throw Error(result_file.string() + ": has no fields; a case of one state, without [sweep] and by another theory "
                                         "than a creep-force table, writes them");
  }

  std::vector<fs::path> write() {
    std::vector<fs::path> names;
    for (const auto& [group, fields] : groups_) {
      std::string ending = group;
      std::ranges::replace(ending, '/', '.');
      names.push_back(fs::path(vtp_).replace_extension(ending + ".vtp"));
      files_.push_back(std::make_unique<OutputFile>(names.back()));
      files_.back()->write(document(group, fields));
    }
    for (const auto& file : files_) file->commit();
    return names;
  }

private:
  std::vector<double> numbers(const StoredDataset& dataset) const {
    return std::visit(
        [](const auto& values) -> std::vector<double> {
          if constexpr (std::is_same_v<std::decay_t<decltype(values)>, std::vector<std::string>>)
            return {};
          else
            return {values.begin(), values.end()};
        },
        reader_.read(dataset));
  }

  double number_of_patch(const PlaceOfGroup& place, const std::string& name) const {
    return numbers(*by_path_.at(place.patches + "/" + name)).at(place.number);
  }

  Frame frame_of(const std::string& group) const {
    const PlaceOfGroup place = place_of(group);
    if (!by_path_.contains(place.patches + "/angle")) return {};
    const double angle = number_of_patch(place, "angle");
    return {{number_of_patch(place, "place_x"), number_of_patch(place, "place_y"), number_of_patch(place, "place_z")},
            std::cos(angle),
            std::sin(angle)};
  }

  std::string document(const std::string& group, const Group& fields) const {
    std::map<std::string, std::vector<double>> values;
    for (const StoredDataset* field : fields) values[field->name] = numbers(*field);
    const Frame frame = frame_of(group);
    const std::size_t count = values.at("x").size();
    std::string text = fmt::format("<?xml version=\"1.0\"?>\n"
                                   "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
                                   "<PolyData><Piece NumberOfPoints=\"{}\" NumberOfPolys=\"{}\">\n",
                                   4 * count, count);
    append_rectangles(text, values, frame);
    text += "<CellData Scalars=\"state\">\n";
    for (const StoredDataset* field : fields) append_array(text, heading(*field), values.at(field->name), 1);
    append_vectors(text, values, frame);
    return text + "</CellData>\n</Piece></PolyData>\n</VTKFile>\n";
  }

  static std::string heading(const StoredDataset& field) {
    return field.unit == "-" ? field.name : fmt::format("{} [{}]", field.name, field.unit);
  }

  static void append_array(std::string& text, const std::string& name, const std::vector<double>& values, int parts) {
    text += fmt::format("<DataArray type=\"Float64\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">\n", name,
                        parts);
    for (const double value : values) fmt::format_to(std::back_inserter(text), "{} ", value);
    text += "\n</DataArray>\n";
  }

  /// Four corners of each element, which are no others' since rows need not have elements of one length.
  static void append_rectangles(std::string& text, const std::map<std::string, std::vector<double>>& values,
                                const Frame& frame) {
    const auto &x = values.at("x"), &y = values.at("y"), &area = values.at("area"), &width = values.at("width");
    std::vector<double> corners;
    corners.reserve(12 * x.size());
    for (std::size_t k = 0; k < x.size(); ++k) {
      const double half_x = width[k] / 2, half_y = width[k] > 0 ? area[k] / width[k] / 2 : 0;
      for (const auto& [i, j] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
        const Point corner = frame.at(x[k] + i * half_x, y[k] + j * half_y);
        corners.insert(corners.end(), corner.begin(), corner.end());
      }
    }
    text += "<Points>\n";
    append_array(text, "corners [m]", corners, 3);
    text += "</Points>\n<Polys>\n<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n";
    for (std::size_t k = 0; k < 4 * x.size(); ++k) fmt::format_to(std::back_inserter(text), "{} ", k);
    text += "\n</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n";
    for (std::size_t k = 1; k <= x.size(); ++k) fmt::format_to(std::back_inserter(text), "{} ", 4 * k);
    text += "\n</DataArray>\n</Polys>\n";
  }

  static void append_vectors(std::string& text, const std::map<std::string, std::vector<double>>& values,
                             const Frame& frame) {
    const auto &px = values.at("px"), &py = values.at("py"), &sx = values.at("sx"), &sy = values.at("sy");
    const auto pressure = values.find("pressure"); // which simplified theories do not have
    std::vector<double> traction, slip;
    for (std::size_t k = 0; k < px.size(); ++k) {
      const Point p = frame.turned(px[k], py[k], pressure == values.end() ? 0 : pressure->second[k]);
      const Point s = frame.turned(sx[k], sy[k], 0);
      traction.insert(traction.end(), p.begin(), p.end());
      slip.insert(slip.end(), s.begin(), s.end());
    }
    append_array(text, "traction on body 1 [Pa]", traction, 3);
    append_array(text, "slip of body 1", slip, 3);
  }

  ResultReader reader_;
  fs::path vtp_;
  std::map<std::string, const StoredDataset*> by_path_;
  std::map<std::string, Group> groups_;
  std::vector<std::unique_ptr<OutputFile>> files_;
};

} // namespace

std::vector<fs::path> write_vtk_surfaces(const fs::path& result_file, const fs::path& vtp) {
  return Writer(result_file, vtp).write();
}

bool is_vtk(const fs::path& name) {
  return name.extension() == ".vtp";
}

} // namespace microslip::io
