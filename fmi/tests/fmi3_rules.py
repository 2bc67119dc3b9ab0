"""The rules of FMI 3.0, section 2.4 (description), 2.5 (archive) and 4.3 (co-simulation), that concern units like ours: scalars
of type Float64, Int32 and String, no states, no clocks."""

import re
import sys

ORDER = ["ModelExchange", "CoSimulation", "ScheduledExecution", "UnitDefinitions", "TypeDefinitions", "LogCategories",
         "DefaultExperiment", "ModelVariables", "ModelStructure", "Annotations"]
VARIABLE = {"name", "valueReference", "description", "causality", "variability", "initial", "canHandleMultipleSetPerTimeInstant",
            "intermediateUpdate", "previous", "clocks", "declaredType", "min", "max", "start"}
ATTRIBUTES = {
    "fmiModelDescription": {"fmiVersion", "modelName", "instantiationToken", "description", "author", "version", "copyright",
                            "license", "generationTool", "generationDateAndTime", "variableNamingConvention"},
    "CoSimulation": {"modelIdentifier", "needsExecutionTool", "canBeInstantiatedOnlyOncePerProcess", "canGetAndSetFMUState",
                     "canSerializeFMUState", "providesDirectionalDerivatives", "providesAdjointDerivatives",
                     "providesPerElementDependencies", "canHandleVariableCommunicationStepSize", "fixedInternalStepSize",
                     "maxOutputDerivativeOrder", "recommendedIntermediateInputSmoothness", "providesIntermediateUpdate",
                     "mightReturnEarlyFromDoStep", "canReturnEarlyAfterIntermediateUpdate", "hasEventMode",
                     "providesEvaluateDiscreteStates"},
    "ModelExchange": {"modelIdentifier", "needsExecutionTool", "canBeInstantiatedOnlyOncePerProcess", "canGetAndSetFMUState",
                      "canSerializeFMUState", "providesDirectionalDerivatives", "providesAdjointDerivatives",
                      "providesPerElementDependencies", "needsCompletedIntegratorStep", "providesEvaluateDiscreteStates"},
    "Float64": VARIABLE | {"quantity", "unit", "displayUnit", "relativeQuantity", "unbounded", "nominal", "derivative", "reinit"},
    "Int32": VARIABLE | {"quantity"},
    "String": VARIABLE - {"min", "max", "start"},
    "Start": {"value"},
    "BaseUnit": {"kg", "m", "s", "A", "K", "mol", "cd", "rad", "factor", "offset"},
    "Output": {"valueReference", "dependencies", "dependenciesKind"},
    "InitialUnknown": {"valueReference", "dependencies", "dependenciesKind"},
}
REQUIRED = {
    "fmiModelDescription": {"fmiVersion", "modelName", "instantiationToken"},
    "CoSimulation": {"modelIdentifier"}, "ModelExchange": {"modelIdentifier"},
    "Float64": {"name", "valueReference"}, "Int32": {"name", "valueReference"}, "String": {"name", "valueReference"},
    "Start": {"value"},
    "Category": {"name"}, "Unit": {"name"},
    "Output": {"valueReference"}, "InitialUnknown": {"valueReference"},
}
# The `initial` of a causality and a variability; None: must not be given.
INITIAL = {
    ("parameter", "fixed"): {"exact"}, ("parameter", "tunable"): {"exact"},
    ("input", "discrete"): {None, "exact"}, ("input", "continuous"): {None, "exact"},
    ("output", "constant"): {"exact"}, ("local", "constant"): {"exact"},
    ("output", "discrete"): {"exact", "calculated"}, ("output", "continuous"): {"exact", "approx", "calculated"},
    ("local", "discrete"): {"exact", "calculated"}, ("local", "continuous"): {"exact", "approx", "calculated"},
    ("independent", "continuous"): {None},
}
# Of whole numbers; exponents and points are no part of them.
WHOLE = re.compile(r"[+-]?\d+")
# Ends of the names of binaries by platform tuple; first that which every unit has.
BINARIES = {"x86_64-linux": ".so", "x86_64-windows": ".dll", "aarch64-linux": ".so", "aarch64-darwin": ".dylib",
            "x86_64-darwin": ".dylib"}


def number(text):
    """The number, or None."""
    try:
        return float(text)
    except (TypeError, ValueError):
        return None


def check_attributes(root, report):
    """Report elements that lack a required attribute or have an unknown one."""
    for element in root.iter():
        for name in REQUIRED.get(element.tag, set()) - set(element.attrib):
            report(f"{element.tag} lacks the attribute {name}")
        for name in set(element.attrib) - ATTRIBUTES.get(element.tag, set(element.attrib)):
            report(f"{element.tag} has the unknown attribute {name}")


def check_start(variable, report):
    """Start value and range."""
    name, initial, causality = (variable.get(key) for key in ("name", "initial", "causality"))
    start = variable.get("start") if variable.tag != "String" else next((one.get("value") for one in variable.iter("Start")), None)
    needs_start = causality in ("input", "parameter") or initial in ("exact", "approx")
    if needs_start and (start is None or (variable.tag != "String" and number(start) is None)):
        report(f"{name} needs a start value")
    if (initial == "calculated" or causality == "independent") and start is not None:
        report(f"{name} must not have a start value")
    if variable.tag == "Int32" and any(not WHOLE.fullmatch(variable.get(key, "0")) for key in ("min", "max", "start")):
        report(f"{name} is an Int32 with a number that is not whole")
    low, high = number(variable.get("min")), number(variable.get("max"))
    if low is not None and high is not None and low > high:
        report(f"{name} has min > max")
    if number(start) is not None and ((low is not None and number(start) < low) or (high is not None and number(start) > high)):
        report(f"{name} starts outside its range")


def check_variables(variables, units, report):
    """Names, references, causalities; exactly one variable is independent."""
    for key, what in (("name", "name"), ("valueReference", "value reference")):
        all_of_them = [variable.get(key) for variable in variables]
        for one in sorted({one for one in all_of_them if all_of_them.count(one) > 1}, key=str):
            report(f"the {what} {one} is used twice")
    if [variable.get("causality") for variable in variables].count("independent") != 1:
        report("there must be one independent variable")
    for variable in variables:
        name, causality = variable.get("name"), variable.get("causality", "local")
        variability = variable.get("variability", "continuous" if variable.tag == "Float64" else "discrete")
        if variable.tag not in ("Float64", "Int32", "String"):
            report(f"{name} has the type {variable.tag}, which our units do not have")
        if variable.tag != "Float64" and variability == "continuous":
            report(f"{name} is continuous, but no floating-point number")
        if variable.get("initial") not in INITIAL.get((causality, variability), set()):
            report(f"{name}: causality {causality}, variability {variability} and initial {variable.get('initial')} do not go together")
        if not (variable.get("valueReference") or "").isdigit():
            report(f"{name} has no whole value reference")
        if variable.get("unit") is not None and variable.get("unit") not in units:
            report(f"{name} has the undefined unit {variable.get('unit')}")
        check_start(variable, report)


def check_structure(structure, variables, report):
    """Outputs first, then what is calculated at the start; dependencies are value references."""
    causality = {variable.get("valueReference"): variable.get("causality") for variable in variables}
    tags = [element.tag for element in structure]
    if tags != sorted(tags, key=["Output", "ContinuousStateDerivative", "ClockedState", "InitialUnknown", "EventIndicator"].index):
        report("ModelStructure: Output must come before InitialUnknown")
    outputs = {reference for reference, one in causality.items() if one == "output"}
    for tag, what in (("Output", outputs), ("InitialUnknown", outputs)):
        listed = [element.get("valueReference") for element in structure if element.tag == tag]
        if set(listed) != what or len(listed) != len(what):
            report(f"ModelStructure must list all outputs as {tag} once and nothing else")
    for element in structure:
        for reference in element.get("dependencies", "").split():
            if reference not in causality:
                report(f"{element.tag}: there is no variable {reference}")
            elif element.tag == "Output" and causality[reference] not in ("input", "independent"):
                report(f"{element.tag}: variable {reference} is no input")


def check_description(root, report):
    """Returns the model identifier."""
    if root.tag != "fmiModelDescription":
        report("is no description of FMI 3.0")
    return check_elements(root, sys.modules[__name__], report)


def check_elements(root, rules, report):
    """The elements of a description by the rules of its version, a module. Returns the model identifier."""
    tags = [child.tag for child in root]
    if tags != [tag for tag in rules.ORDER if tag in tags]:
        report(f"elements must come once and in the order {', '.join(rules.ORDER)}")
    for needed in ("CoSimulation", "ModelVariables", "ModelStructure"):
        if needed not in tags:
            report(f"{needed} is missing")
            return None
    rules.check_attributes(root, report)
    units = {unit.get("name") for unit in root.iterfind("UnitDefinitions/Unit")}
    variables = list(root.find("ModelVariables"))
    rules.check_variables(variables, units, report)
    rules.check_structure(root.find("ModelStructure"), variables, report)
    return root.find("CoSimulation").get("modelIdentifier")
