"""Makes the report of a case: python3 -m microslip.report DOCUMENT.json --output FILE, which microslip report runs."""

import argparse
import importlib.util
import signal
import sys

# What a report needs besides this package, and where Debian has it.
PACKAGES = {"jinja2": "python3-jinja2", "h5py": "python3-h5py", "matplotlib": "python3-matplotlib", "numpy": "python3-numpy",
            "weasyprint": "weasyprint"}


def parse(arguments):
    """The command line."""
    parser = argparse.ArgumentParser(prog="python3 -m microslip.report", description="Makes the report of a case from the document that "
                                     "microslip report writes.")
    parser.add_argument("document", metavar="DOCUMENT.json", nargs="?", help="inputs, tables and the result file's name")
    parser.add_argument("--output", metavar="FILE", help="the report")
    parser.add_argument("--format", choices=("html", "pdf"), default="html", help="of the report")
    parser.add_argument("--template", metavar="FILE.html", default="", help="extends report.html")
    parser.add_argument("--check", action="store_true", help="only say whether a report can be made")
    return parser.parse_args(arguments)


def require_modules(form):
    """Refuses a report for which a module is not there."""
    for name in PACKAGES:
        if (name != "weasyprint" or form == "pdf") and importlib.util.find_spec(name) is None:
            raise ModuleNotFoundError(name, name=name)


def missing(error):
    """Says what to install for a module that is not there."""
    name = (error.name or str(error)).split(".")[0]
    advice = f"install the Debian package {PACKAGES[name]}" if name in PACKAGES else "install it"
    other = ", or name a file that ends with .html" if name == "weasyprint" else ""
    return f"a report needs the Python module {name}, which is not there: {advice}{other}"


def make(options):
    """Makes the report, or checks whether it can be made."""
    require_modules(options.format)
    from microslip.report_template import check_template
    check_template(options.template)
    if not options.check:
        from microslip.report_page import write
        write(options.document, options.output, options.format, options.template)


def refusal(error):
    """What is wrong in one line, or nothing for an error of this program."""
    if isinstance(error, ImportError):
        return missing(error)
    import jinja2
    return " ".join(str(error).split()) if isinstance(error, (jinja2.TemplateError, OSError, ValueError)) else ""


def main(arguments=None):
    """The command line; returns the exit code: 0, or 2 with what is wrong in one line."""
    try:
        make(parse(arguments))
    except Exception as error:
        said = refusal(error)
        if not said:
            raise
        print(f"microslip.report: {said}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    for each in (signal.SIGINT, signal.SIGTERM):
        signal.signal(each, signal.SIG_DFL)
    sys.exit(main())
