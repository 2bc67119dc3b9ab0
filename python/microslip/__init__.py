"""microslip: frictional rolling contact of two bodies. All in SI units, all forces on body 1 (the wheel).

The names of the compiled module (`help(microslip.Fastsim2)`) and the pictures (`microslip.plot`) are loaded when they are
first used, so that the pictures work without the module and the module without matplotlib.
"""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from microslip._core import *


def __getattr__(name):
    """Loads the pictures, or the compiled module, on the first use of a name that is not here."""
    if name == "plot":
        import importlib
        return importlib.import_module("microslip.plot")
    if name.startswith("_") and name != "__version__":
        raise AttributeError(f"module 'microslip' has no attribute '{name}'")
    try:
        from microslip import _core
    except ImportError as error:
        raise AttributeError(f"microslip.{name} needs the compiled module, which is missing: {error}") from error
    names = [public for public in vars(_core) if not public.startswith("_")]
    globals().update({public: getattr(_core, public) for public in names}, __all__=names, __version__=_core.__version__)
    if name not in globals():
        raise AttributeError(f"module 'microslip' has no attribute '{name}'")
    return globals()[name]


def __dir__():
    """All public names."""
    try:
        __getattr__("Error")
    except AttributeError:
        pass
    return sorted(name for name in globals() if not name.startswith("_"))
