"""Templates of reports: report.html, and one of the user's own that extends it; numbers and units as people write them."""

import base64
import os
import re
from pathlib import Path

import jinja2
import jinja2.sandbox
from markupsafe import Markup, escape

FOLDER = Path(__file__).absolute().parent


def template_name(template):
    """Name of the template within its folder."""
    return os.path.basename(template) or "report.html"


def environment(template):
    """The templates: one of the user's own, and ours, which it extends."""
    folders = [os.path.dirname(template) or "."] if template else []
    made = jinja2.sandbox.SandboxedEnvironment(loader=jinja2.FileSystemLoader([*folders, FOLDER]), autoescape=True, trim_blocks=True,
                                               undefined=jinja2.StrictUndefined, keep_trailing_newline=True)
    made.filters.update(number=number, unit=unit, typeset=typeset)
    made.globals["picture"] = lambda name: address((Path(template).parent / name).read_bytes(), name)
    return made


def check_template(template):
    """Refuses a template that is not there or not well formed."""
    if template and not os.path.isfile(template):
        raise FileNotFoundError(f"{template}: no such template")
    try:
        environment(template).get_template(template_name(template))
    except jinja2.TemplateSyntaxError as error:
        raise ValueError(f"{error.filename or template}:{error.lineno}: {error.message}") from None


def address(data, name):
    """A picture's bytes as an address within the page."""
    kind = {".svg": "svg+xml", ".jpg": "jpeg", ".jpeg": "jpeg"}.get(Path(name).suffix.lower(), "png")
    return f"data:image/{kind};base64,{base64.b64encode(data).decode()}"


def number(text):
    """A number as people write it: a true minus sign, powers of ten; other texts as they are."""
    text = str(text)
    if text in ("inf", "-inf"):
        return text.replace("inf", "∞").replace("-", "−")
    power = re.fullmatch(r"(-?[\d.]+)e([-+]\d+)", text)
    if power:
        exponent = str(int(power[2])).replace("-", "−")
        return Markup(f"{power[1].replace('-', '−')}·10<sup>{exponent}</sup>")
    return text.replace("-", "−") if re.fullmatch(r"-?[\d.]+(, -?[\d.]+)*", text) else text


def unit(text):
    """A unit as people write it: m² for m^2, µm for um, nothing for pure numbers."""
    text = re.sub(r"\bu(?=[mgN])", "µ", str(text)).replace("^2", "²").replace("^3", "³").replace("sqrt(a b)", "√(ab)")
    text = "" if text == "-" else text.replace(" ", "\N{NO-BREAK SPACE}")
    return Markup(str(escape(text)).replace("mu\N{NO-BREAK SPACE}Fn", "µ<i>F</i><sub>n</sub>"))


def typeset(text):
    """A text with multiplication signs, and forces with their axes as subscripts."""
    text = re.sub(r"(?<=\d) x (?=\d)", " × ", str(text))
    return Markup(re.sub(r"\b([fFMm])([xyz])\b", r"<i>\1</i><sub>\2</sub>", str(escape(text))))


def is_number(text):
    """Returns whether a text begins as a number."""
    return re.match(r"[-+]?(\d|inf)", text) is not None
