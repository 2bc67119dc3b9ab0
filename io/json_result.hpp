#pragma once

#include "io/json.hpp"
#include "io/result_writer.hpp"

namespace microslip::io {

/// Fields (is_field) and arrays of several dimensions in a document: left out, or kept as flat arrays, the last index
/// fastest, with `shapes` by their paths.
enum class JsonFields { left_out, kept };

/// A result as the JSON document that result_json makes of its file, without a file.
class JsonResult : public ResultWriter {
public:
  explicit JsonResult(const Provenance& provenance, JsonFields fields = JsonFields::left_out);

  void scalar(const std::string& path, double value, const std::string& unit, const std::string& description) override;
  void text(const std::string& path, const std::string& value, const std::string& description) override;
  void array(const std::string& path, const Values& values, const std::string& unit, const std::string& description,
             const Shape& shape = {}) override;
  void attribute(const std::string& path, const std::string& name, const std::string& value) override;

  /// All of it, `units` last, and after it `shapes` with fields.
  Json document() const;

private:
  bool leaves_out(const std::string& path) const;

  JsonFields fields_;
  Json members_ = Json::object(), units_ = Json::object(), shapes_ = Json::object();
};

/// Returns true if a path leads into one of the groups `fields`, `elements`, `interior`, `profiles` and `outlines`,
/// which documents leave out unless they are asked for.
bool is_field(const std::string& path);

} // namespace microslip::io
