#include "io/case_origin.hpp"

#include "io/case_file.hpp"
#include "io/file_beside.hpp"
#include "io/slices_file.hpp"
#include "io/toml_section.hpp"

#include <algorithm>
#include <system_error>

namespace microslip::io {
namespace {

namespace fs = std::filesystem;

/// Calls `use` with the path of each value that is no table and no list of tables.
template <class Use> void for_each_value(const toml::node& node, const std::string& path, const Use& use) {
  const std::string start = path.empty() ? "" : path + ".";
  if (const auto* table = node.as_table()) {
    for (const auto& [key, value] : *table) for_each_value(value, start + std::string(key.str()), use);
  } else if (node.is_array_of_tables()) {
    for (std::size_t k = 0; k < node.as_array()->size(); ++k)
      for_each_value(*node.as_array()->get(k), start + std::to_string(k + 1), use);
  } else {
    use(path, node);
  }
}

class NamedFiles {
public:
  void add(const fs::path& file) {
    if (std::find(found.begin(), found.end(), file) != found.end()) return;
    found.push_back(file);
    if (file.extension() == ".toml") add_those_of_toml(file);
    if (names_slices(file))
      for (const SliceEntry& slice : read_slices(file).slices) add_if_there(slice.file);
  }

  std::vector<fs::path> found;

private:
  void add_those_of_toml(const fs::path& file) {
    const toml::table root = parse_toml(read_case_text(file), file.string());
    const auto add_text = [&](const toml::node& node) {
      if (const auto text = node.value<std::string>()) add_if_there(file_beside(file.parent_path(), *text));
    };
    for_each_value(root, "", [&](const std::string& path, const toml::node& node) {
      if (path == "title") return;
      add_text(node);
      if (const auto* list = node.as_array())
        for (const toml::node& one : *list) add_text(one);
    });
  }

  void add_if_there(const fs::path& file) {
    std::error_code ignored;
    if (fs::is_regular_file(file, ignored)) add(file);
  }
};

} // namespace

std::map<std::string, int, std::less<>> value_lines(std::string_view text, const std::string& name) {
  std::map<std::string, int, std::less<>> lines;
  for_each_value(parse_toml(text, name), "", [&](const std::string& path, const toml::node& node) {
    lines[path] = static_cast<int>(node.source().begin.line);
  });
  return lines;
}

std::vector<fs::path> files_of_case(const fs::path& file) {
  NamedFiles files;
  files.add(file);
  return files.found;
}

bool is_sweep(std::string_view text, const std::string& name) {
  const toml::table root = parse_toml(text, name);
  return root.contains("grid") || root.contains("list") || root.contains("sample");
}

} // namespace microslip::io
