"""Checks a unit against the rules of FMI for archive and modelDescription.xml: check_fmu.py FILE.fmu

Prints each broken rule and exits with 1 if there is one. The rules are those of FMI 2.0, sections 2.2 (description), 2.3
(archive) and 4.3 (co-simulation), that concern units like ours: no Boolean variables, no states; fmi3_rules has those of 3.0.
"""

import re
import sys
import xml.etree.ElementTree as ElementTree
import zipfile

import fmi3_rules

ORDER = ["ModelExchange", "CoSimulation", "UnitDefinitions", "TypeDefinitions", "LogCategories", "DefaultExperiment",
         "VendorAnnotations", "ModelVariables", "ModelStructure"]
ATTRIBUTES = {
    "fmiModelDescription": {"fmiVersion", "modelName", "guid", "description", "author", "version", "copyright", "license",
                            "generationTool", "generationDateAndTime", "variableNamingConvention",
                            "numberOfEventIndicators"},
    "CoSimulation": {"modelIdentifier", "needsExecutionTool", "canHandleVariableCommunicationStepSize",
                     "canInterpolateInputs", "maxOutputDerivativeOrder", "canRunAsynchronuously",
                     "canBeInstantiatedOnlyOncePerProcess", "canNotUseMemoryManagementFunctions",
                     "canGetAndSetFMUstate", "canSerializeFMUstate", "providesDirectionalDerivative"},
    "ModelExchange": {"modelIdentifier", "needsExecutionTool", "completedIntegratorStepNotNeeded",
                      "canBeInstantiatedOnlyOncePerProcess", "canNotUseMemoryManagementFunctions", "canGetAndSetFMUstate",
                      "canSerializeFMUstate", "providesDirectionalDerivative"},
    "ScalarVariable": {"name", "valueReference", "description", "causality", "variability", "initial",
                       "canHandleMultipleSetPerTimeInstant"},
    "Real": {"declaredType", "quantity", "unit", "displayUnit", "relativeQuantity", "min", "max", "nominal", "unbounded",
             "start", "derivative", "reinit"},
    "Integer": {"declaredType", "quantity", "min", "max", "start"},
    "String": {"declaredType", "start"},
    "BaseUnit": {"kg", "m", "s", "A", "K", "mol", "cd", "rad", "factor", "offset"},
    "Unit": {"name", "index", "dependencies", "dependenciesKind"},
}
REQUIRED = {
    "fmiModelDescription": {"fmiVersion", "modelName", "guid"},
    "CoSimulation": {"modelIdentifier"}, "ModelExchange": {"modelIdentifier"},
    "ScalarVariable": {"name", "valueReference"},
    "Category": {"name"},
    "Unknown": {"index"},
}
# Which variabilities go with a causality, and which `initial` with both; None: must not be given.
INITIAL = {
    ("parameter", "fixed"): {"exact"}, ("parameter", "tunable"): {"exact"},
    ("input", "discrete"): {None}, ("input", "continuous"): {None},
    ("output", "constant"): {"exact"},
    ("output", "discrete"): {"exact", "approx", "calculated"},
    ("output", "continuous"): {"exact", "approx", "calculated"},
    ("local", "constant"): {"exact"},
    ("local", "discrete"): {"exact", "approx", "calculated"},
    ("local", "continuous"): {"exact", "approx", "calculated"},
}


def check_attributes(root, report):
    for element in root.iter():
        missing = REQUIRED.get(element.tag, set()) - set(element.attrib)
        unknown = set(element.attrib) - ATTRIBUTES.get(element.tag, set(element.attrib))
        for name in missing:
            report(f"{element.tag} lacks the attribute {name}")
        for name in unknown:
            report(f"{element.tag} has the unknown attribute {name}")


def number(text):
    """The number, or None."""
    try:
        return float(text)
    except (TypeError, ValueError):
        return None


def check_value(name, value, initial, causality, units, report):
    start = value.get("start")
    needs_start = causality in ("input", "parameter") or initial in ("exact", "approx")
    if needs_start and (start is None if value.tag == "String" else number(start) is None):
        report(f"{name} needs a start value")
    if initial == "calculated" and start is not None:
        report(f"{name} is calculated and must not have a start value")
    if value.get("unit") is not None and value.get("unit") not in units:
        report(f"{name} has the undefined unit {value.get('unit')}")
    low, high = number(value.get("min")), number(value.get("max"))
    if low is not None and high is not None and low > high:
        report(f"{name} has min > max")
    if start is not None and ((low is not None and number(start) < low) or (high is not None and number(start) > high)):
        report(f"{name} starts outside its range")


def check_variables(variables, units, report):
    names = [variable.get("name") for variable in variables]
    for name in {name for name in names if names.count(name) > 1}:
        report(f"the name {name} is used twice")
    references = set()
    for variable in variables:
        name, initial = variable.get("name"), variable.get("initial")
        causality, variability = variable.get("causality", "local"), variable.get("variability", "continuous")
        values = [child for child in variable if child.tag in ("Real", "Integer", "Boolean", "String", "Enumeration")]
        if len(values) != 1:
            report(f"{name} must have one type")
            continue
        if values[0].tag != "Real" and variability == "continuous":
            report(f"{name} is continuous, but not real")
        if initial not in INITIAL.get((causality, variability), set()):
            report(f"{name}: causality {causality}, variability {variability} and initial {initial} do not go together")
        reference = (values[0].tag, variable.get("valueReference"))
        if reference in references:
            report(f"{name} shares its value reference with another {values[0].tag}")
        references.add(reference)
        if not (variable.get("valueReference") or "").isdigit():
            report(f"{name} has no whole value reference")
        check_value(name, values[0], initial, causality, units, report)


# Names by the variable naming convention "structured" (FMI 2.0, section 2.2.9; the same in 3.0): a.b[1].c
STRUCTURED = re.compile(r"[A-Za-z_]\w*(\[\d+(,\d+)*\])?(\.[A-Za-z_]\w*(\[\d+(,\d+)*\])?)*")


def check_names(variables, report):
    for variable in variables:
        name = variable.get("name") or ""
        if not STRUCTURED.fullmatch(name):
            report(f"{name} is no structured name")


def check_structure(structure, variables, report):
    def listed(group):
        found = structure.find(group)
        return [] if found is None else [int(unknown.get("index", 0)) for unknown in found]

    calculated = {index for index, variable in enumerate(variables, 1)
                  if variable.get("causality") == "output" and variable.get("initial") in ("approx", "calculated")}
    outputs = {index for index, variable in enumerate(variables, 1) if variable.get("causality") == "output"}
    if set(listed("Outputs")) != outputs:
        report("ModelStructure/Outputs must list all outputs and nothing else")
    if set(listed("InitialUnknowns")) != calculated:
        report("ModelStructure/InitialUnknowns must list all outputs that are calculated and nothing else")
    for group in structure:
        indices = [int(unknown.get("index", 0)) for unknown in group]
        if indices != sorted(set(indices)):
            report(f"{group.tag} must be in ascending order without repetition")
        for unknown in group:
            for index in map(int, unknown.get("dependencies", "").split()):
                if not 1 <= index <= len(variables):
                    report(f"{group.tag}: there is no variable {index}")
                elif group.tag == "Outputs" and variables[index - 1].get("causality") != "input":
                    report(f"{group.tag}: variable {index} is no input")


def check_description(text, report):
    """Returns the model identifier."""
    root = ElementTree.fromstring(text)
    if root.get("variableNamingConvention") == "structured":
        check_names(root.iterfind("ModelVariables/*"), report)
    if root.get("fmiVersion") == "3.0":
        return fmi3_rules.check_description(root, report)
    if root.tag != "fmiModelDescription" or root.get("fmiVersion") != "2.0":
        report("is no description of FMI 2.0")
    return fmi3_rules.check_elements(root, sys.modules[__name__], report)


# Ends of the names of binaries (section 2.3).
BINARIES = {"linux64": ".so", "win64": ".dll", "darwin64": ".dylib"}


def check_binaries(names, identifier, binaries=None):
    """Each platform's folder must have the binary of the model identifier, and one of Linux must be there."""
    binaries = binaries or BINARIES
    broken = []
    platforms = {name.split("/")[1] for name in names if name.startswith("binaries/") and name != "binaries/"}
    for platform in sorted(platforms | {next(iter(binaries))}):
        binary = f"binaries/{platform}/{identifier}{binaries.get(platform, '')}"
        if platform not in binaries:
            broken.append(f"binaries/{platform} is no platform")
        elif binary not in names:
            broken.append(f"{binary} is missing")
    return broken


def check_fmu(path):
    """The broken rules, in words."""
    broken = []
    with zipfile.ZipFile(path) as archive:
        if archive.testzip() is not None:
            broken.append("the archive is damaged")
        if "modelDescription.xml" not in archive.namelist():
            return broken + ["modelDescription.xml is missing"]
        text = archive.read("modelDescription.xml")
        identifier = check_description(text, broken.append)
        is_fmi3 = b'fmiVersion="3.0"' in text
        if not (identifier or "").isidentifier():
            broken.append("modelIdentifier must be a name of C")
        broken += check_binaries(archive.namelist(), identifier, fmi3_rules.BINARIES if is_fmi3 else BINARIES)
        if "documentation/index.html" not in archive.namelist():
            broken.append("documentation/index.html is missing")
        for name in archive.namelist():
            if name.split("/")[0] not in ("modelDescription.xml", "binaries", "sources", "resources", "documentation"):
                broken.append(f"{name} has no place in the archive")
    return broken


if __name__ == "__main__":
    faults = check_fmu(sys.argv[1])
    print("\n".join(faults) or "no broken rule")
    sys.exit(1 if faults else 0)
