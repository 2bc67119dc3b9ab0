// Loads the unpacked unit as an importer would: names and value references come from modelDescription.xml, functions
// from the binary. MICROSLIP_UNPACKED_FMU is the unit's folder.
#pragma once

#include "fmi/fmi2.h"

#include <cstdarg>
#include <cstdio>
#include <fstream>
#include <limits>
#include <map>
#include <regex>
#include <sstream>
#include <string>

#include <dlfcn.h>

#include <gtest/gtest.h>

namespace microslip::fmi {
namespace {

std::string attribute(const std::string& element, const std::string& name) {
  std::smatch match;
  return std::regex_search(element, match, std::regex("\\b" + name + "=\"([^\"]*)\"")) ? match[1].str() : "";
}

/// Data of modelDescription.xml for the tests.
struct Description {
  std::string guid, identifier;
  std::map<std::string, fmi2ValueReference> references;
  std::map<std::string, std::string> starts; ///< of inputs and parameters
  std::map<std::string, std::string> types;  ///< Real, Integer, String
  std::map<std::string, std::string> causalities;

  Description() {
    std::ifstream file(MICROSLIP_UNPACKED_FMU "/modelDescription.xml");
    std::stringstream contents;
    contents << file.rdbuf();
    const std::string text = contents.str();
    guid = attribute(text, "guid");
    identifier = attribute(text, "modelIdentifier");
    static const std::regex variable("<ScalarVariable[^]*?</ScalarVariable>");
    for (std::sregex_iterator i(text.begin(), text.end(), variable), end; i != end; ++i) {
      const std::string element = i->str(), name = attribute(element, "name"), start = attribute(element, "start");
      references[name] = static_cast<fmi2ValueReference>(std::stoul(attribute(element, "valueReference")));
      causalities[name] = attribute(element, "causality");
      if (element.find(" start=") != std::string::npos) starts[name] = start;
      for (const std::string type : {"Real", "Integer", "String"})
        if (element.find("<" + type) != std::string::npos) types[name] = type;
    }
  }
};

const Description& description() {
  static const Description read;
  return read;
}

/// The binary; functions by name.
class Binary {
public:
  Binary()
      : handle_(dlopen((MICROSLIP_UNPACKED_FMU "/binaries/linux64/" + description().identifier + ".so").c_str(),
                       RTLD_NOW | RTLD_LOCAL)) {}
  bool loaded() const { return handle_ != nullptr; }
  template <class Function> Function* find(const char* name) const {
    return reinterpret_cast<Function*>(dlsym(handle_, name));
  }

private:
  void* handle_; // stays loaded: sanitizers want its symbols at the end
};

const Binary& binary() {
  static const Binary loaded;
  return loaded;
}

#define FMI(name) (*binary().find<decltype(name)>(#name))

struct Messages {
  int count = 0;
  fmi2Status status = fmi2OK;
  std::string last, instance;
  std::string category;
};

void log_message(fmi2ComponentEnvironment environment, fmi2String instance, fmi2Status status, fmi2String category,
                 fmi2String message, ...) {
  auto& messages = *static_cast<Messages*>(environment);
  ++messages.count;
  messages.status = status;
  messages.instance = instance;
  messages.category = category;
  va_list arguments;
  va_start(arguments, message);
  char text[1024];
  std::vsnprintf(text, sizeof text, message, arguments);
  va_end(arguments);
  messages.last = text;
}

/// Folder of resources as an importer passes it on.
const std::string resource_folder = "file://" MICROSLIP_UNPACKED_FMU "/resources";

/// An instance as an importer holds it.
class Instance {
public:
  explicit Instance(const std::string& name = "law", const std::string& guid = description().guid,
                    fmi2Type type = fmi2CoSimulation, const std::string& resources = resource_folder)
      : functions_{log_message, nullptr, nullptr, nullptr, &messages},
        unit(FMI(fmi2Instantiate)(name.c_str(), type, guid.c_str(), resources.c_str(), &functions_, fmi2False,
                                  fmi2True)) {}
  ~Instance() { FMI(fmi2FreeInstance)(unit); }
  Instance(const Instance&) = delete;

  Messages messages;

private:
  fmi2CallbackFunctions functions_;

public:
  fmi2Component unit;

  fmi2Status set(const std::string& name, double value) {
    const fmi2ValueReference vr = description().references.at(name);
    return FMI(fmi2SetReal)(unit, &vr, 1, &value);
  }
  fmi2Status set_integer(const std::string& name, int value) {
    const fmi2ValueReference vr = description().references.at(name);
    return FMI(fmi2SetInteger)(unit, &vr, 1, &value);
  }
  fmi2Status set_text(const std::string& name, const std::string& value) {
    const fmi2ValueReference vr = description().references.at(name);
    const char* const text = value.c_str();
    return FMI(fmi2SetString)(unit, &vr, 1, &text);
  }
  double get(const std::string& name) {
    const fmi2ValueReference vr = description().references.at(name);
    double value = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(FMI(fmi2GetReal)(unit, &vr, 1, &value), fmi2OK) << name << ": " << messages.last;
    return value;
  }
  int get_integer(const std::string& name) {
    const fmi2ValueReference vr = description().references.at(name);
    int value = -1;
    EXPECT_EQ(FMI(fmi2GetInteger)(unit, &vr, 1, &value), fmi2OK);
    return value;
  }
  std::string get_text(const std::string& name) {
    const fmi2ValueReference vr = description().references.at(name);
    const char* value = nullptr;
    EXPECT_EQ(FMI(fmi2GetString)(unit, &vr, 1, &value), fmi2OK);
    return value ? value : "";
  }
  void initialize() {
    EXPECT_EQ(FMI(fmi2SetupExperiment)(unit, fmi2False, 0, 0, fmi2False, 0), fmi2OK);
    EXPECT_EQ(FMI(fmi2EnterInitializationMode)(unit), fmi2OK);
    EXPECT_EQ(FMI(fmi2ExitInitializationMode)(unit), fmi2OK);
  }
  fmi2Status step(double time, double length = 1e-3) { return FMI(fmi2DoStep)(unit, time, length, fmi2True); }
};

} // namespace
} // namespace microslip::fmi
