"""Types of the compiled part of microslip; written by python/binding/make_stub.py, which also says what has which type."""

import enum
import os
from collections.abc import Callable, Iterator
from concurrent.futures import Executor
from typing import Any, Literal, overload

import numpy
from numpy.typing import ArrayLike, NDArray

class AccurateContact:
    """Steady rolling on two nested grids and its limit."""
    @property
    def forces(self) -> ContactForces:
        """The limit, extrapolated; areas and status of the finer grid."""
    @property
    def creepage(self) -> Creepage:
        """The limit, where a force is prescribed [-], [-], [1/m]."""
    @property
    def error(self) -> float:
        """Estimated error of the limit, in mu Fn for forces and mu Fn sqrt(a b) for the moment [-]."""
    @property
    def elements(self) -> int:
        """Elements across the ellipse, of the finer grid [-]."""
    @property
    def finest(self) -> ContactSolution:
        """The solution on the finer grid, as ContactSolution."""
    @property
    def coarser(self) -> ContactForces:
        """The totals on half the elements, as ContactForces."""
    @property
    def products(self) -> int:
        """Products on all grids [-]."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class Bodies:
    """Two bodies in contact, as the exact theory needs them: elastic ones, or those that viscoelastic() makes."""
    def __init__(self, material: CombinedMaterial, layer: InterfaceLayer | None = None) -> None:
        """Elastic bodies from their CombinedMaterial, with an InterfaceLayer between them or none [-]."""
    @property
    def material(self) -> CombinedMaterial:
        """Of the instantaneous deformation, as CombinedMaterial."""
    @property
    def layer(self) -> InterfaceLayer:
        """The InterfaceLayer; its flexibility is 0 without one."""
    @property
    def are_elastic(self) -> bool:
        """Whether no part of the deformation is retarded."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class Body:
    """One of the two bodies of a case file."""
    @property
    def rolling_radius(self) -> float:
        """Radius in the plane of rolling [m]."""
    @property
    def transverse_radius(self) -> float:
        """Radius in the lateral plane [m]."""
    @property
    def material(self) -> Material:
        """Its Material."""
    @property
    def creep(self) -> MaterialCreep:
        """Its MaterialCreep; the ratio is 0 for an elastic body."""
    @property
    def layers(self) -> list[BodyLayer]:
        """List of BodyLayer, from the surface inwards."""
    @property
    def thermal(self) -> ThermalBody | None:
        """Its ThermalBody, or None."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class BodyLayer:
    """A layer of constant thickness, bonded to what is below it."""
    def __init__(self, thickness: float, material: ViscoelasticMaterial) -> None:
        """Made from the thickness h [m], > 0, and a Material or ViscoelasticMaterial."""
    @property
    def thickness(self) -> float:
        """h [m]."""
    @property
    def material(self) -> ViscoelasticMaterial:
        """Its ViscoelasticMaterial."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class CaseContact(EllipticContact):
    """The EllipticContact of a case, to be read, not changed; copy.copy() gives one that can be changed."""
    @property
    def creepage(self) -> CaseCreepage:
        """Creepages [-], [-] and spin [1/m]."""

class CaseCreepage(Creepage):
    """The Creepage of a case, to be read, not changed."""

class CellState(enum.IntEnum):
    """State of a cell [-]: 0 exterior, outside the contact; 1 adhesion; 2 slip. An IntEnum: arrays
    of codes compare with it."""
    exterior = 0
    adhesion = 1
    slip = 2

class CombinedMaterial:
    """The constants of two bodies in contact, as half-space theory needs them; combine() makes them."""
    def __init__(self, shear_modulus: float, poisson_ratio: float, dissimilarity: float = 0.0) -> None:
        """Made from combined constants: G [Pa], nu [-], K [-]."""
    @property
    def shear_modulus(self) -> float:
        """Combined shear modulus G [Pa]."""
    @property
    def poisson_ratio(self) -> float:
        """Combined Poisson's ratio nu [-]."""
    @property
    def dissimilarity(self) -> float:
        """K [-]; 0 for elastically similar bodies."""
    @property
    def contact_modulus(self) -> float:
        """E* = G/(1 - nu) [Pa]."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class ContactCase:
    """A case of a CONTACT input file and what became of it."""
    @property
    def number(self) -> int:
        """In the file, from 1 [-]."""
    @property
    def line(self) -> int:
        """Where it begins in the file, from 1 [-]."""
    @property
    def outcome(self) -> str:
        """solved, skipped (as the file says) or refused."""
    @property
    def reasons(self) -> list[str]:
        """Why it was refused."""
    @property
    def notes(self) -> list[str]:
        """What was left out or done differently."""
    @property
    def status(self) -> Status:
        """Outcome of the calculation, a Status [-]."""
    @property
    def totals(self) -> ContactTotals | None:
        """ContactTotals, CONTACT's units [N], [mm]; None unless solved, and for a wheel."""
    @property
    def grid(self) -> ElementGrid | None:
        """The ElementGrid, SI units; None unless solved, and for a wheel."""
    @property
    def normal(self) -> NormalSolution | None:
        """The NormalSolution, SI units; None unless solved, and for a wheel."""
    @property
    def tangential(self) -> TangentialSolution | None:
        """The TangentialSolution, SI units; None unless solved, and for a wheel."""
    @property
    def force_on_rail(self) -> list[float] | None:
        """FX(TR), FY(TR), FZ(TR) of a wheel [N], shape (3,); None for an independent contact."""
    @property
    def moment_on_rail(self) -> list[float] | None:
        """About the rail's marker in the track's axes [N mm], shape (3,); None for an independent contact."""
    @property
    def patches(self) -> list[ContactPatch]:
        """ContactPatch of each patch of a wheel [-]; empty for an independent contact."""
    @property
    def wheel_height(self) -> float | None:
        """Z_WS of a wheel, as given or found [mm]; None for an independent contact."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class ContactDamage:
    """What a contact does to the surface whose strength its case has, in [material]; None where
    a number needs a strength that is not given, or fields that the theory does not have."""
    @property
    def t_gamma(self) -> object:
        """|Fx xi| + |Fy eta| [N]; or None."""
    @property
    def t_gamma_with_spin(self) -> object:
        """|Fx xi| + |Fy eta| + |Mz phi| [N]; or None."""
    @property
    def t_gamma_per_area(self) -> object:
        """T-gamma over the area of the contact [N/m^2]; or None."""
    @property
    def worn_mass_r8t(self) -> object:
        """wear of wheel steel R8T by T-gamma per area, per metre rolled [kg/m]; or None."""
    @property
    def worn_area(self) -> object:
        """Archard's wear: cross-section that a passage wears off, or volume per metre [m^2]; or None."""
    @property
    def wear_depth(self) -> object:
        """Archard's wear: largest depth of a passage [m]; or None."""
    @property
    def traction_coefficient(self) -> object:
        """sqrt(Fx^2 + Fy^2)/Fn [-]; or None."""
    @property
    def fatigue_index(self) -> object:
        """surface fatigue index: traction coefficient less k over the largest pressure [-]; or None."""
    @property
    def shakedown_load(self) -> object:
        """largest pressure over the yield strength in shear: ordinate of the shakedown map [-]; or None."""
    @property
    def shakedown_limit(self) -> object:
        """limit of that load at the traction coefficient, of a point or line contact [-]; or None."""
    @property
    def fields(self) -> dict[str, str]:
        """The fields friction_work [N/m^2], wear_depth [m] and shear_excess [Pa] as a dict, each of shape (my, mx), as
        far as the strength that they need is given."""

class ContactDerivatives:
    """Totals and their derivatives."""
    @property
    def forces(self) -> ContactForces:
        """The totals, as ContactForces."""
    @property
    def jacobian(self) -> NDArray[numpy.float64]:
        """Derivatives of fx [N], fy [N], mz [N m] with respect to xi [-], eta [-], phi [1/m] and Fn [N],
        shape (3, 4); that with respect to Fn keeps the ellipse as it is."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class ContactForces:
    """Totals, acting on body 1, the wheel. Positive creepage gives negative force."""
    @property
    def fx(self) -> float:
        """Longitudinal force on body 1 [N]."""
    @property
    def fy(self) -> float:
        """Lateral force on body 1 [N]."""
    @property
    def mz(self) -> float:
        """Moment about z on body 1, integral of x py - y px [N m]."""
    @property
    def adhesion_area(self) -> float:
        """Area in adhesion [m^2]."""
    @property
    def slip_area(self) -> float:
        """Area in slip [m^2]."""
    @property
    def status(self) -> Status:
        """How the calculation ended, a Status [-]."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class ContactPatch:
    """A contact patch of a wheel on a rail (module 1), with CONTACT's signs and units."""
    @property
    def track(self) -> list[float]:
        """XCP, YCP, ZCP in the track's axes [mm], shape (3,)."""
    @property
    def rail(self) -> list[float]:
        """XCP, YCP, ZCP in the axes of the rail's profile [mm], shape (3,)."""
    @property
    def wheel(self) -> list[float]:
        """XCP, YCP, ZCP in the axes of the wheel's profile [mm], shape (3,)."""
    @property
    def angle(self) -> float:
        """DELTCP in the track's axes [rad]."""
    @property
    def velocity(self) -> float:
        """VELOC [mm/s]."""
    @property
    def cksi(self) -> float:
        """CKSI [-], in a shift [mm]."""
    @property
    def ceta(self) -> float:
        """CETA [-], in a shift [mm]."""
    @property
    def cphi(self) -> float:
        """CPHI [rad/mm], in a shift [rad]."""
    @property
    def previous(self) -> list[int]:
        """Numbers, from 1, of the patches of the case before that it goes on from [-]."""
    @property
    def totals(self) -> ContactTotals:
        """ContactTotals, CONTACT's units [N], [mm]; fy is FS."""
    @property
    def status(self) -> Status:
        """Outcome of the calculation, a Status [-]."""
    @property
    def grid(self) -> ElementGrid:
        """The ElementGrid, SI units."""
    @property
    def normal(self) -> NormalSolution:
        """The NormalSolution, SI units."""
    @property
    def tangential(self) -> TangentialSolution:
        """The TangentialSolution, SI units."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class ContactRun:
    """The cases of a CONTACT input file, solved one after the other as they are iterated over."""
    def __iter__(self) -> ContactRun: ...
    def __next__(self) -> ContactCase: ...

class ContactSolution:
    """Solution of a contact by any solver; in transient rolling after the last step. Forces act on body 1."""
    @property
    def fx(self) -> object:
        """Longitudinal force on body 1 [N]; None if the solution does not have it."""
    @property
    def fy(self) -> object:
        """Lateral force on body 1 [N]; None if the solution does not have it."""
    @property
    def mz(self) -> object:
        """Spin moment on body 1, about the normal [N m]; None if the solution does not have it."""
    @property
    def my(self) -> object:
        """Moment of the pressure about y on body 1: rolling resistance [N m]; None if the solution does not have it."""
    @property
    def creepage_longitudinal(self) -> object:
        """Longitudinal creepage: as given, or as found where the force is prescribed [-], of a shift [m]; None if the solution does not have it."""
    @property
    def creepage_lateral(self) -> object:
        """Lateral creepage: as given, or as found where the force is prescribed [-], of a shift [m]; None if the solution does not have it."""
    @property
    def spin(self) -> object:
        """Spin [1/m], of a shift [rad]; None if the solution does not have it."""
    @property
    def adhesion_area(self) -> object:
        """Area of adhesion [m^2]; None if the solution does not have it."""
    @property
    def slip_area(self) -> object:
        """Area of slip [m^2]; None if the solution does not have it."""
    @property
    def frictional_power(self) -> object:
        """Power lost to friction [W], of a shift [J]; None if the solution does not have it."""
    @property
    def power_by_creepage(self) -> object:
        """Frictional power by forces and creepages [W], of a shift [J]; None if the solution does not have it."""
    @property
    def elastic_energy(self) -> object:
        """Elastic energy of the tangential tractions [J]; None if the solution does not have it."""
    @property
    def approach(self) -> object:
        """Relative approach of distant points [m]; None if the solution does not have it."""
    @property
    def peak_pressure(self) -> object:
        """Largest pressure of an element [Pa]; None if the solution does not have it."""
    @property
    def peak_traction(self) -> object:
        """Largest traction of an element [Pa]; None if the solution does not have it."""
    @property
    def highest_temperature(self) -> object:
        """Highest temperature of the surfaces in contact [deg C]; None if the solution does not have it."""
    @property
    def residual(self) -> object:
        """Relative residual of the equations of friction [-]; None if the solution does not have it."""
    @property
    def newton_steps(self) -> object:
        """Iterations of Newton's method [-]; None if the solution does not have it."""
    @property
    def products(self) -> object:
        """Products with the matrix of influence coefficients [-]; None if the solution does not have it."""
    @property
    def estimated_error(self) -> object:
        """Estimated error of forces in mu Fn, of the moment in mu Fn sqrt(a b) [-]; None if the solution does not have it."""
    @property
    def fields(self) -> SurfaceFields:
        """Tractions, slip and more, as SurfaceFields."""
    @property
    def grid(self) -> ElementGrid:
        """The ElementGrid that the elements belong to; fields have the shape (grid.my, grid.mx)."""
    @property
    def motion(self) -> str:
        """'steady', 'transient' or 'shift'."""
    @property
    def forces(self) -> ContactForces:
        """Forces and areas, as ContactForces."""
    @property
    def creepage(self) -> Creepage:
        """Creepages as given, or as found where a force is prescribed [-], [-], [1/m]."""
    @property
    def status(self) -> Status:
        """Outcome of the calculation, a Status [-]."""
    @property
    def reason(self) -> str:
        """Why the status is not ok; empty if it is."""
    @property
    def history(self) -> list[SolutionStep]:
        """Transient rolling: a list of SolutionStep, in their order."""
    def sampled(self, field: str, grid: ElementGrid) -> NDArray[numpy.float64]:
        """A field at the centres of any ElementGrid, by its name in `fields`, shape (my, mx) of that grid,
        in the field's unit [SI]: the value of the element that a centre lies in, zero where there is
        none. Error for a field that the solution does not have."""
    @overload
    def interior_states(self, body1: Material, body2: Material, x: ArrayLike, y: ArrayLike, z: ArrayLike) -> InteriorStates:
        """Displacements [m] and stresses [Pa] inside the bodies at all combinations of the coordinates x,
        y, z [m], numbers or lists; z >= 0 lies in body 1, z < 0 in body 2, whose Material are given.
        Returns InteriorStates of shape (len(z), len(y), len(x)). Error for a solution without
        pressures, as those of the simplified theory."""
    @overload
    def interior_states(self, bodies: LayeredBodies, x: ArrayLike, y: ArrayLike, z: ArrayLike) -> InteriorStates:
        """The same of LayeredBodies; on the interface of two layers points lie in the one nearer to the
        surface [m]. Error for points in a rigid core, too."""
    def to_dataframe(self) -> Any:
        """All arrays, and inputs that vary, as a pandas.DataFrame, a row for each element; in attrs the units [SI], the
        numbers that all rows share, what result it is, and the version; needs pandas."""
    def to_xarray(self) -> Any:
        """All arrays and inputs as an xarray.Dataset with their units [SI], numbers that all share without dimensions; in
        attrs what result it is, and the version; needs xarray."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class ContactTotals:
    """The quantities that CONTACT prints for a case, with its signs and units: mm and N, on body 1."""
    @property
    def fn(self) -> float:
        """FN [N]."""
    @property
    def fx(self) -> float:
        """FX [N]."""
    @property
    def fy(self) -> float:
        """FY [N]."""
    @property
    def mz(self) -> float:
        """MZ [N mm]."""
    @property
    def elastic_energy(self) -> float:
        """ELAST.EN. [J]."""
    @property
    def friction(self) -> float:
        """FRIC.POWER [W], for shifts FRIC.WORK [J]; negative where energy is lost."""
    @property
    def fn_over_g(self) -> float:
        """FN/G [mm^2]."""
    @property
    def x_name(self) -> str:
        """What x is: FX/FSTAT/FN, or CREEP X, SHIFT X where the force is prescribed."""
    @property
    def x(self) -> float:
        """[-], for a shift [mm]."""
    @property
    def y_name(self) -> str:
        """What y is: FY/FSTAT/FN, or CREEP Y, SHIFT Y where the force is prescribed."""
    @property
    def y(self) -> float:
        """[-], for a shift [mm]."""
    @property
    def approach(self) -> float:
        """APPROACH [mm]."""
    @property
    def peak_pressure(self) -> float:
        """PMAX [N/mm^2]."""
    @property
    def potential(self) -> int:
        """NPOT, elements of the potential contact [-]."""
    @property
    def contact(self) -> int:
        """NCON, elements in contact [-]."""
    @property
    def adhesion(self) -> int:
        """NADH, elements in adhesion [-]."""
    @property
    def slip(self) -> int:
        """NSLIP, elements in slip [-]."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class CreepCurve:
    """Forces along one creepage while the other two are held."""
    @property
    def variable(self) -> str:
        """creepage_longitudinal, creepage_lateral or spin."""
    @property
    def unit(self) -> str:
        """Unit of the variable."""
    @property
    def value(self) -> NDArray[numpy.float64]:
        """Values of the variable, shape (n), [-] or [1/m]."""
    @property
    def fx(self) -> NDArray[numpy.float64]:
        """Shape (n) [N]."""
    @property
    def fy(self) -> NDArray[numpy.float64]:
        """Shape (n) [N]."""
    @property
    def mz(self) -> NDArray[numpy.float64]:
        """Shape (n) [N m]."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""
    def to_dataframe(self) -> Any:
        """All arrays, and inputs that vary, as a pandas.DataFrame, a row for each element; in attrs the units [SI], the
        numbers that all rows share, what result it is, and the version; needs pandas."""
    def to_xarray(self) -> Any:
        """All arrays and inputs as an xarray.Dataset with their units [SI], numbers that all share without dimensions; in
        attrs what result it is, and the version; needs xarray."""

class CreepForceTable:
    """Forces of Hertzian contacts in steady rolling by interpolation between results of the exact
    theory: of its accuracy, at about 1 us a contact. Forces are continuous with their first
    derivatives, those of linear theory for vanishing creepages, and never beyond mu Fn. Beyond the
    table's axis ratios and Poisson's ratios forces are those of limits, with Status.out_of_range."""
    def __init__(self, file: ArrayLike | None = None, poisson_ratio: float | None = None, *, direction: Literal["forward", "backward"] = 'forward') -> None:
        """Reads a table made by `microslip table make`, str or os.PathLike; None: the one that comes with
        microslip. poisson_ratio [-]: for that one alone, at a fraction of the memory. direction of
        rolling 'forward' (along +x) or 'backward'. Error for a file that is no table, of another version
        or byte order, cut short or corrupted."""
    def solve(self, contact: EllipticContact) -> ContactForces:
        """Forces [N], [N m] and areas [m^2] of a contact, as ContactForces."""
    def differentiate(self, contact: EllipticContact) -> ContactDerivatives:
        """Forces [N], [N m] and their derivatives with respect to xi [-], eta [-], phi [1/m] and Fn [N],
        as ContactDerivatives: those of the interpolation itself."""
    @property
    def axis_ratios(self) -> tuple:
        """Least and largest a/b [-]."""
    @property
    def poisson_ratios(self) -> tuple:
        """Poisson's ratios of the nodes [-]."""
    def solve_batch(self, like: EllipticContact, longitudinal: ArrayLike | None = None, lateral: ArrayLike | None = None, spin: ArrayLike | None = None, *, a: ArrayLike | None = None, b: ArrayLike | None = None, shear_modulus: ArrayLike | None = None, poisson_ratio: ArrayLike | None = None, normal_force: ArrayLike | None = None, friction: ArrayLike | None = None, rolling_speed: ArrayLike | None = None, dissimilarity: ArrayLike | None = None, threads: int = 0) -> ForceArrays:
        """Many contacts in one call, on all processors (threads = 0) or as many threads as given. `like`
        is a contact; fields that are given replace those of it, as numbers or arrays that broadcast:
        longitudinal [-], lateral [-], spin [1/m], a [m], b [m], shear_modulus [Pa], poisson_ratio [-],
        normal_force [N], friction [-], rolling_speed [m/s], dissimilarity [-]. Results have the
        broadcast shape (...) and do not depend on the number of threads. Ctrl-C ends the call with
        KeyboardInterrupt. Error for arrays that are no real numbers or do not match; contacts out
        of range have Status.invalid_input and NaN. Returns ForceArrays."""
    def differentiate_batch(self, like: EllipticContact, longitudinal: ArrayLike | None = None, lateral: ArrayLike | None = None, spin: ArrayLike | None = None, *, a: ArrayLike | None = None, b: ArrayLike | None = None, shear_modulus: ArrayLike | None = None, poisson_ratio: ArrayLike | None = None, normal_force: ArrayLike | None = None, friction: ArrayLike | None = None, rolling_speed: ArrayLike | None = None, dissimilarity: ArrayLike | None = None, threads: int = 0) -> DerivativeArrays:
        """Many contacts in one call, on all processors (threads = 0) or as many threads as given. `like`
        is a contact; fields that are given replace those of it, as numbers or arrays that broadcast:
        longitudinal [-], lateral [-], spin [1/m], a [m], b [m], shear_modulus [Pa], poisson_ratio [-],
        normal_force [N], friction [-], rolling_speed [m/s], dissimilarity [-]. Results have the
        broadcast shape (...) and do not depend on the number of threads. Ctrl-C ends the call with
        KeyboardInterrupt. Error for arrays that are no real numbers or do not match; contacts out
        of range have Status.invalid_input and NaN. Returns DerivativeArrays."""

class Creepage:
    """Rigid relative motion of the bodies per metre rolled: relative rigid slip w = (xi - phi y, eta + phi x)."""
    def __init__(self, longitudinal: float = 0.0, lateral: float = 0.0, spin: float = 0.0) -> None:
        """Made from xi [-], eta [-] and phi [1/m]."""
    @property
    def longitudinal(self) -> float:
        """xi [-]; of a braked wheel positive. For a shift [m]."""
    @longitudinal.setter
    def longitudinal(self, value: float) -> None: ...
    @property
    def lateral(self) -> float:
        """eta [-]. For a shift [m]."""
    @lateral.setter
    def lateral(self, value: float) -> None: ...
    @property
    def spin(self) -> float:
        """phi [1/m]. For a shift [rad]."""
    @spin.setter
    def spin(self, value: float) -> None: ...
    def __iter__(self) -> Iterator[float]: ...
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class CreepageCoefficients:
    """Kalker's creepage coefficients: for vanishing creepages, with c = sqrt(a b), Fx = -G c^2 C11 xi,
    Fy = -G c^2 (C22 eta + c C23 phi), Mz = -G c^3 (C32 eta + c C33 phi), C32 = -C23."""
    @property
    def c11(self) -> float:
        """C11 [-]."""
    @property
    def c22(self) -> float:
        """C22 [-]."""
    @property
    def c23(self) -> float:
        """C23 [-]."""
    @property
    def c33(self) -> float:
        """C33 [-]."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class DerivativeArrays:
    """Forces of many contacts and their derivatives."""
    @property
    def forces(self) -> ForceArrays:
        """The forces."""
    @property
    def jacobian(self) -> NDArray[numpy.float64]:
        """Derivatives of fx [N], fy [N], mz [N m] with respect to longitudinal and lateral creepage [-],
        spin [1/m] and normal force [N], shape (..., 3, 4); that with respect to the normal force keeps
        the ellipse as it is."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""
    def to_dataframe(self) -> Any:
        """All arrays, and inputs that vary, as a pandas.DataFrame, a row for each element; in attrs the units [SI], the
        numbers that all rows share, what result it is, and the version; needs pandas."""
    def to_xarray(self) -> Any:
        """All arrays and inputs as an xarray.Dataset with their units [SI], numbers that all share without dimensions; in
        attrs what result it is, and the version; needs xarray."""

class DiscretisationError:
    """Differences of totals from those on another grid."""
    @property
    def fx(self) -> float:
        """In units of mu Fn [-]."""
    @property
    def fy(self) -> float:
        """In units of mu Fn [-]."""
    @property
    def mz(self) -> float:
        """In units of mu Fn sqrt(a b) [-]."""
    @property
    def frictional_power(self) -> float:
        """[W]; for a shift of the work [J]."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class ElementGrid:
    """The potential contact: mx x my equal rectangles, x and y ascending. Fields on it have shape (my, mx)."""
    def __init__(self, mx: int, my: int, x0: float, y0: float, dx: float, dy: float) -> None:
        """mx, my elements [-] with sides dx, dy [m], the first one's centre at x0, y0 [m]. Error for sizes out of range."""
    @staticmethod
    def across_ellipse(a: float, b: float, mx: int, my: int, margin: int = 0) -> ElementGrid:
        """mx x my elements [-] across an ellipse with semi-axes a, b [m], its centre at the origin, and
        `margin` more on each side [-]."""
    @staticmethod
    def across_line(a: float, mx: int, margin: int = 0, length: float = 1.0) -> ElementGrid:
        """A line contact: one row, endless in y, mx elements [-] across the half-width a [m], `margin`
        more on each side [-]; forces are those of `length` [m]."""
    @property
    def mx(self) -> int:
        """Columns [-]."""
    @property
    def my(self) -> int:
        """Rows [-]."""
    @property
    def x0(self) -> float:
        """Centre of the first element [m]."""
    @property
    def y0(self) -> float:
        """Centre of the first element [m]."""
    @property
    def dx(self) -> float:
        """Length of an element [m]."""
    @property
    def dy(self) -> float:
        """Width of an element [m]."""
    @property
    def line(self) -> bool:
        """Whether it is a line contact."""
    @property
    def x(self) -> NDArray[numpy.float64]:
        """Centres of the columns, shape (mx) [m]."""
    @property
    def y(self) -> NDArray[numpy.float64]:
        """Centres of the rows, shape (my) [m]."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class EllipticContact:
    """A Hertzian ellipse with material, load, friction and creepages: what the solvers of either
    theory take. Fields may be changed between calls; solvers check them, and what is out of range
    gives Status.invalid_input and NaN."""
    def __init__(self, a: float, b: float, shear_modulus: float, poisson_ratio: float, normal_force: float, friction: FrictionLaw | float, creepage: Creepage | tuple[float, float, float] = ..., rolling_speed: float | None = None, dissimilarity: float = 0.0) -> None:
        """Made from the semi-axes a along x and b along y [m], the combined shear modulus [Pa] and Poisson's
        ratio [-], the normal force [N], a friction coefficient [-] or FrictionLaw, a Creepage or
        (xi [-], eta [-], phi [1/m]), the speed V [m/s] and the combined K [-] of dissimilar bodies. Without a
        speed it is 1 m/s; Error if friction depends on it."""
    @staticmethod
    def from_hertz(hertz: HertzContact, material: CombinedMaterial, friction: FrictionLaw | float, creepage: Creepage | tuple[float, float, float] = ..., rolling_speed: float | None = None) -> EllipticContact:
        """From a HertzContact and the CombinedMaterial of its bodies, with G, nu and K [-]; the others as above."""
    def check(self) -> None:
        """Raises Error, which names field, value and range, if a field is out of range: solvers answer such a
        contact with Status.invalid_input and NaN."""
    def check_simplified(self) -> None:
        """Checks for the simplified theory, in which dissimilarity must be 0."""
    @property
    def warnings(self) -> list[str]:
        """Reasons to doubt the contact, as texts with its numbers: the peak pressure beside Young's modulus, a
        modulus that may be in MPa; empty where check() raises."""
    @property
    def a(self) -> float:
        """Semi-axis along the rolling direction [m], > 0."""
    @a.setter
    def a(self, value: float) -> None: ...
    @property
    def b(self) -> float:
        """Lateral semi-axis [m], > 0."""
    @b.setter
    def b(self, value: float) -> None: ...
    @property
    def shear_modulus(self) -> float:
        """Combined G [Pa], > 0."""
    @shear_modulus.setter
    def shear_modulus(self, value: float) -> None: ...
    @property
    def poisson_ratio(self) -> float:
        """Combined nu [-], in [0, 0.5]."""
    @poisson_ratio.setter
    def poisson_ratio(self, value: float) -> None: ...
    @property
    def normal_force(self) -> float:
        """Fn [N], > 0."""
    @normal_force.setter
    def normal_force(self, value: float) -> None: ...
    @property
    def friction(self) -> FrictionLaw:
        """The friction law, mu [-] of the slip velocity [m/s]; a number is taken for Coulomb's."""
    @friction.setter
    def friction(self, value: FrictionLaw | float) -> None: ...
    @property
    def creepage(self) -> Creepage:
        """Creepages [-], [-] and spin [1/m]; three numbers may be assigned."""
    @creepage.setter
    def creepage(self, value: Creepage | tuple[float, float, float]) -> None: ...
    @property
    def rolling_speed(self) -> float:
        """V [m/s], > 0; matters for falling friction and for the frictional power."""
    @rolling_speed.setter
    def rolling_speed(self, value: float) -> None: ...
    @property
    def dissimilarity(self) -> float:
        """Combined K [-], in [-0.5, 0.5], which couples pressure and tractions of dissimilar bodies; the
        simplified theory refuses it."""
    @dissimilarity.setter
    def dissimilarity(self, value: float) -> None: ...
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class Error(ValueError):
    """An invalid set-up: the text names the field, its value, its unit and the allowed range."""

class ExactDerivatives:
    """Forces in steady rolling and their derivatives."""
    @property
    def solution(self) -> ContactSolution:
        """The solution, as ContactSolution."""
    @property
    def jacobian(self) -> NDArray[numpy.float64]:
        """Derivatives of fx [N], fy [N], mz [N m] with respect to xi [-], eta [-] and phi [1/m], shape (3, 3)."""
    @property
    def by_load(self) -> NDArray[numpy.float64]:
        """Derivatives of these with respect to the normal force [N], or to the approach [m] where that is given; the
        bodies' distance without load stays. Shape (3)."""
    @property
    def products(self) -> int:
        """Products that the derivatives took [-]."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class ExactResult:
    """What the exact theory makes of a case."""
    @property
    def solution(self) -> ContactSolution:
        """The ContactSolution, its gap among the fields."""
    @property
    def forces(self) -> ContactForces:
        """The totals, as ContactForces."""
    @property
    def discretisation_error(self) -> DiscretisationError:
        """To the grid with half the elements [-], [W]."""
    @property
    def limit(self) -> AccurateContact | None:
        """AccurateContact if the case asks for an accuracy, else None."""
    @property
    def nip(self) -> Nip | None:
        """The Nip of bodies with layers in steady rolling, else None."""
    @property
    def free_roller1(self) -> FreeRoller | None:
        """The FreeRoller that body 1 is without torque, under a given force; else None."""
    @property
    def free_roller2(self) -> FreeRoller | None:
        """The same of body 2."""
    @property
    def peaks(self) -> LayeredPeaks | None:
        """LayeredPeaks, like the Nip, else None."""
    @property
    def curve(self) -> CreepCurve | None:
        """The CreepCurve through the case, None if it is not steady rolling."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class Fastsim(RowSolver):
    """FASTSIM (Kalker 1982): the simplified theory by backward Euler, first order in the cell length."""
    def __init__(self, mx: int = 10, my: int = 10, *, half_first_step: bool = False, direction: Literal["forward", "backward"] = 'forward', precision: Literal["double", "single"] = 'double', bound: Literal["parabolic", "elliptic"] | None = ..., flexibility: Literal["three", "one", "blended"] | None = ..., coefficients: Literal["kalker", "computed"] | None = 'kalker', slope_reduction: tuple[float, float, float] | None = ...) -> None:
        """mx cells in each of my rows [-], 1 to 10,000; direction 'forward' (along +x) or 'backward'; precision
        'double' or 'single', of forces of Coulomb friction only: about half the time, accurate to 1e-5 of mu Fn;
        bound, flexibility, coefficients and slope_reduction as in Method. Error if an option is out of range.
        half_first_step: half a cell with the rigid slip in the step's middle, half the error; else as
        in (F16)."""

class Fastsim2(RowSolver):
    """FASTSIM2 (Vollebregt & Wilders 2010): the simplified theory by the trapezoidal rule with tracked
    boundaries between adhesion and slip, second order in the cell length. 10 x 10 cells are enough
    for forces."""
    def __init__(self, mx: int = 10, my: int = 10, *, direction: Literal["forward", "backward"] = 'forward', precision: Literal["double", "single"] = 'double', bound: Literal["parabolic", "elliptic"] | None = ..., flexibility: Literal["three", "one", "blended"] | None = ..., coefficients: Literal["kalker", "computed"] | None = 'kalker', slope_reduction: tuple[float, float, float] | None = ...) -> None:
        """mx cells in each of my rows [-], 1 to 10,000; direction 'forward' (along +x) or 'backward'; precision
        'double' or 'single', of forces of Coulomb friction only: about half the time, accurate to 1e-5 of mu Fn;
        bound, flexibility, coefficients and slope_reduction as in Method. Error if an option is out of range."""

class ForceArrays:
    """Forces of many contacts: arrays with the shape that the inputs broadcast to; read-only views."""
    @property
    def fx(self) -> NDArray[numpy.float64]:
        """Longitudinal forces on body 1, shape (...) [N]."""
    @property
    def fy(self) -> NDArray[numpy.float64]:
        """Lateral forces on body 1, shape (...) [N]."""
    @property
    def mz(self) -> NDArray[numpy.float64]:
        """Moments about z on body 1, shape (...) [N m]."""
    @property
    def adhesion_area(self) -> NDArray[numpy.float64]:
        """Areas in adhesion, shape (...) [m^2]."""
    @property
    def slip_area(self) -> NDArray[numpy.float64]:
        """Areas in slip, shape (...) [m^2]."""
    @property
    def status(self) -> NDArray[numpy.uint8]:
        """Codes of Status as uint8, shape (...) [-]; compare with Status.ok."""
    @property
    def warning_code(self) -> NDArray[numpy.uint32]:
        """Reasons to doubt contacts as uint32, shape (...) [-]: sum of 2^k of the warnings k of warning_texts()."""
    @property
    def inputs(self) -> dict[str, Any]:
        """Inputs as given: creepage_longitudinal [-], creepage_lateral [-], spin [1/m], a [m], b [m],
        shear_modulus [Pa], poisson_ratio [-], normal_force [N], friction [-] at rest, rolling_speed [m/s],
        dissimilarity [-]; by name numbers, or arrays of shape (...) of what varies."""
    def __len__(self) -> int: ...
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""
    def to_dataframe(self) -> Any:
        """All arrays, and inputs that vary, as a pandas.DataFrame, a row for each element; in attrs the units [SI], the
        numbers that all rows share, what result it is, and the version; needs pandas."""
    def to_xarray(self) -> Any:
        """All arrays and inputs as an xarray.Dataset with their units [SI], numbers that all share without dimensions; in
        attrs what result it is, and the version; needs xarray."""

class ForceElement:
    """Forces of a contact that remember the creepages and loads before: a rational fit of its responses over the
    wavenumber with common stable poles, by vector fitting. Linear, about the steady state; copy.copy keeps a state."""
    def __init__(self, response: FrequencyResponse, normal_force: float, poles: int = 12) -> None:
        """Fits a FrequencyResponse at ascending wavenumbers, about a normal force [N], to so many poles, pairs
        counting twice. Error for fewer than poles + 1 wavenumbers."""
    @staticmethod
    def from_text(text: str) -> ForceElement:
        """The element of a fit that `microslip respond --poles` has written, or text()."""
    def text(self) -> str:
        """The fit as text, for a file."""
    @property
    def poles(self) -> list[complex]:
        """The poles [1/m]; those with a positive imaginary part stand for their conjugates, too."""
    @property
    def error(self) -> float:
        """Largest error of the fit, over the largest size of the response [-]."""
    def response(self, wavenumber: float) -> NDArray[numpy.float64]:
        """The fit's response of fx, fy [N], mz [N m] to xi, eta [-], phi [1/m], Fn [N] at a wavenumber [1/m], shape (3, 4)."""
    def step(self, distance: float, longitudinal: float, lateral: float, spin: float, normal_force: float) -> tuple:
        """Goes on by a distance rolled [m], over which creepages [-], spin [1/m] and normal force [N] become these,
        linearly. Returns (fx, fy, mz) [N], [N], [N m]."""
    def reset(self) -> None:
        """Back to the steady state."""

class FreeRoller:
    """Steady rolling in which one roller has no torque."""
    @property
    def speed_ratio(self) -> float:
        """Its surface speed over that of the other one [-]; above 1 it is overdriven."""
    @property
    def creepage(self) -> float:
        """Longitudinal creepage [-]."""
    @property
    def fx(self) -> float:
        """Longitudinal force on body 1 [N]."""
    @property
    def solution(self) -> ContactSolution:
        """The ContactSolution."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class FrequencyResponse:
    """Responses of the forces to oscillations about steady rolling, over the wavenumber."""
    @property
    def solution(self) -> ContactSolution:
        """The steady solution, as ContactSolution."""
    @property
    def wavenumber(self) -> NDArray[numpy.float64]:
        """k = omega/V = 2 pi/wavelength, shape (n) [1/m]; none where the steady state is not solved."""
    @property
    def by_creepage(self) -> NDArray[numpy.float64]:
        """Complex amplitudes of fx [N], fy [N], mz [N m] by those of xi [-], eta [-], phi [1/m], e^(i omega t),
        shape (n, 3, 3); at k = 0 the Jacobian of ExactDerivatives."""
    @property
    def by_load(self) -> NDArray[numpy.float64]:
        """The same by that of the normal force [N], shape (n, 3)."""
    @property
    def by_roughness(self) -> NDArray[numpy.float64]:
        """The same by that of roughness [m] at a given approach, shape (n, 3); zero unless asked for."""
    @property
    def load_by_roughness(self) -> NDArray[numpy.float64]:
        """Complex amplitude of the normal force by that of roughness [N/m], shape (n)."""
    @property
    def work_by_creepage(self) -> NDArray[numpy.float64]:
        """Complex amplitudes of the frictional work per metre of the surface by those of creepages
        [N], [N] and spin [N m], shape (n, 3); with roughness."""
    @property
    def work_by_load(self) -> NDArray[numpy.float64]:
        """The same by that of the normal force [-], shape (n)."""
    @property
    def work_by_roughness(self) -> NDArray[numpy.float64]:
        """The same by that of roughness [N/m], shape (n)."""
    @property
    def normal_stiffness(self) -> float:
        """dFn by the approach [N/m]."""
    @property
    def products(self) -> int:
        """Products that the responses took [-]."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class FrictionLaw:
    """The friction coefficient mu as a function of the slip velocity v [m/s]:
    coulomb: mu_k;
    linear: mu_k + sum d_i max(0, 1 - v/(2 v_i));
    rational: mu_k + d_1/(1 + v/v_1) + d_2/(1 + (v/v_2)^2);
    exponential: mu_k + sum d_i 2^(-v/v_i);
    table: monotone cubics between coefficients at slip velocities;
    polach: mu_s ((1 - A) exp(-B v) + A). A term is a pair (drop d [-], half_velocity v_i [m/s]).
    Makers raise Error for a coefficient outside [0, 10] or a velocity that is not positive.
    FrictionLaw() is frictionless."""
    def __init__(self) -> None:
        """Frictionless, mu = 0 [-]."""
    @staticmethod
    def coulomb(coefficient: float) -> FrictionLaw:
        """Coulomb friction, coefficient [-] in [0, 10]."""
    @staticmethod
    def linear(kinetic: float, first: tuple[float, float], second: tuple[float, float] = (0.0, 1.0)) -> FrictionLaw:
        """Made from the kinetic coefficient [-] and one or two terms (drop [-], half_velocity [m/s])."""
    @staticmethod
    def rational(kinetic: float, first: tuple[float, float], second: tuple[float, float] = (0.0, 1.0)) -> FrictionLaw:
        """Made from the kinetic coefficient [-] and one or two terms (drop [-], half_velocity [m/s])."""
    @staticmethod
    def exponential(kinetic: float, first: tuple[float, float], second: tuple[float, float] = (0.0, 1.0)) -> FrictionLaw:
        """Made from the kinetic coefficient [-] and one or two terms (drop [-], half_velocity [m/s])."""
    @staticmethod
    def table(slip_velocities: ArrayLike, coefficients: ArrayLike, pressures: ArrayLike | None = None, temperatures: ArrayLike | None = None) -> FrictionLaw:
        """Coefficients [-] at slip velocities [m/s], at least two, ascending from 0 or more on; between them by
        monotone cubics (scipy's PchipInterpolator), beyond them constant. With pressures [Pa] or temperatures [deg C] of
        the surfaces, between which mu is linear, coefficients have the shape (temperatures, pressures, velocities)
        without the axes that are left out; such laws need the exact theory."""
    @staticmethod
    def sampled(coefficient: Callable[[float], float], fastest: float, accuracy: float = 1e-06) -> FrictionLaw:
        """A table of any mu(v) [-], a function of the slip velocity [m/s] that is called here and never again, so
        that threads and pickles do with the law as with any other. Samples from 0 to `fastest` [m/s], beyond
        which mu is constant, lie so close that the table is within `accuracy` [-] of the function. Its
        exceptions are passed on. Error for coefficients out of range and where the function jumps."""
    @staticmethod
    def polach(static_coefficient: float, ratio: float, decay: float) -> FrictionLaw:
        """Polach's law from mu_s [-], A [-] in [0, 1] and B [s/m] > 0. Kept as an exponential law."""
    @property
    def kind(self) -> str:
        """The name of its maker; Polach's law is an exponential one."""
    @property
    def kinetic_coefficient(self) -> float:
        """mu_k [-]."""
    @property
    def static_coefficient(self) -> float:
        """mu(0) [-]."""
    @property
    def peak_coefficient(self) -> float:
        """The largest mu(v) [-]: mu(0), unless a table rises."""
    @property
    def terms(self) -> tuple[tuple[float, float], tuple[float, float]]:
        """Both terms as (drop [-], half_velocity [m/s])."""
    @property
    def slip_velocities(self) -> list[float] | None:
        """Those of a table [m/s], else None."""
    @property
    def coefficients(self) -> list[float] | None:
        """Those of a table [-], else None: of all velocities at the first pressure and temperature, then at the next
        pressure, and so on."""
    @property
    def pressures(self) -> list[float] | None:
        """Those of a table [Pa], else None."""
    @property
    def temperatures(self) -> list[float] | None:
        """Those of a table [deg C], else None."""
    def coefficient(self, slip_velocity: ArrayLike) -> Any:
        """mu(v) [-] for v >= 0 [m/s], a number or an array, shape (...)."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class GapCurvatures:
    """Shape of the gap between two bodies in first contact: h(x, y) = A x^2 + B y^2."""
    def __init__(self, x: float, y: float) -> None:
        """From A and B [1/m]."""
    @property
    def x(self) -> float:
        """A [1/m], along the rolling direction."""
    @property
    def y(self) -> float:
        """B [1/m], lateral."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class GaugePoint:
    """Where a rail's gauge is measured."""
    @property
    def y(self) -> float:
        """[m], to the field side."""
    @property
    def z(self) -> float:
        """[m], up."""
    @property
    def top(self) -> tuple[float, float]:
        """y and z of the highest point [m]."""
    @property
    def s(self) -> float:
        """Length along the curve [m]."""
    @property
    def reaches_height(self) -> bool:
        """True if the profile reaches down to the gauge's height."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class HertzContact:
    """A Hertzian contact: what follows from shape, material and load."""
    @property
    def a(self) -> float:
        """Semi-axis along x, the rolling direction [m]."""
    @property
    def b(self) -> float:
        """Semi-axis along y [m]."""
    @property
    def normal_force(self) -> float:
        """Fn [N]."""
    @property
    def approach(self) -> float:
        """Relative approach of distant points delta [m]."""
    @property
    def peak_pressure(self) -> float:
        """p0 = 3 Fn/(2 pi a b) [Pa]."""
    @property
    def stiffness(self) -> float:
        """dFn/d(approach) = 3 Fn/(2 delta) [N/m]."""
    @property
    def gap(self) -> GapCurvatures:
        """Curvatures of the gap [1/m]."""
    def pressure(self, x: ArrayLike, y: ArrayLike) -> Any:
        """p_n(x, y) = p0 sqrt(1 - (x/a)^2 - (y/b)^2), 0 outside the ellipse [Pa]; x, y [m] are numbers or
        arrays that broadcast, shape (...)."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class InterfaceLayer:
    """A thin layer between two bodies, rigid in the normal direction: tractions p shear it by p h/G;
    beyond the yield stress tau_c0 + k u_pl, with the plastic deformation u_pl, it deforms
    plastically."""
    def __init__(self, flexibility: float, yield_stress: float = ..., hardening: float = 0.0) -> None:
        """Made from h/G [m/Pa] >= 0, tau_c0 [Pa] > 0, infinite: it stays elastic, and k [Pa/m], negative: it
        gets softer. Error for numbers out of range."""
    @property
    def flexibility(self) -> float:
        """h/G [m/Pa]."""
    @property
    def yield_stress(self) -> float:
        """tau_c0 [Pa]."""
    @property
    def hardening(self) -> float:
        """k [Pa/m]."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class InterfacePeak:
    """The largest stresses between a layer and what is below."""
    @property
    def body(self) -> int:
        """1 or 2 [-]."""
    @property
    def layer(self) -> int:
        """The one above, from 0 [-]."""
    @property
    def shear(self) -> float:
        """[Pa]."""
    @property
    def shear_place(self) -> tuple:
        """x, y and depth [m]."""
    @property
    def tension(self) -> float:
        """[Pa]; 0 if they are pressed together all over."""
    @property
    def tension_place(self) -> tuple:
        """x, y and depth [m], of tension above 0."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class InteriorField:
    """Displacements and stresses in a body from the tractions on its surface, as sums over the
    elements of a grid. Elastic half-space; a line contact gives the plane field of endless strips.
    Exact for tractions that are constant in each element; those of a contact are not, which is felt
    nearer to the surface than about an element."""
    def __init__(self, material: Material, body: Literal[1, 2], grid: ElementGrid, *, px: ArrayLike | None = None, py: ArrayLike | None = None, pn: ArrayLike | None = None) -> None:
        """body 1 (wheel, z > 0) or 2 (rail) [-]; px, py, pn [Pa] are the tractions **on body 1** of the
        grid's elements, shape (my, mx), none: zero. Error for what is out of range or not finite."""
    def at(self, x: ArrayLike, y: ArrayLike, depth: ArrayLike) -> Any:
        """At points x, y [m], depth >= 0 below the surface [m]: numbers or arrays that broadcast to
        shape (...). Returns InteriorStates. Cost 0.3 us for every point and element with tractions;
        Ctrl-C ends it."""
    @property
    def grid(self) -> ElementGrid:
        """The elements, as ElementGrid."""

class InteriorLayers:
    """States at the centres of all elements in planes of constant depth, by fast transforms: 4 to 8 us a point."""
    def __init__(self, field: InteriorField, margin: int = 0) -> None:
        """Points at the centres of the field's elements and of `margin` more columns and rows on each side [-]."""
    @property
    def grid(self) -> ElementGrid:
        """Grid of the points, an ElementGrid."""
    def at_depth(self, depth: float) -> InteriorStates:
        """States at the points in the depth [m] >= 0, shape (my, mx), as InteriorStates."""
    def find_largest(self, depths: ArrayLike, measure: Literal["von_mises", "tresca", "hydrostatic"] = 'von_mises') -> InteriorPeak:
        """The largest value [Pa] of 'von_mises', 'tresca' or 'hydrostatic' and where it is, as
        InteriorPeak: the best point of the planes `depths` [m], ascending, shape (n), and from there a
        search. The largest one if the planes are close enough."""

class InteriorPeak:
    """The largest value of a measure of stress, and where it is."""
    @property
    def value(self) -> float:
        """The value [Pa]."""
    @property
    def x(self) -> float:
        """Where it is [m]."""
    @property
    def y(self) -> float:
        """Where it is [m]."""
    @property
    def depth(self) -> float:
        """Below the surface [m]."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class InteriorStates:
    """Displacements and stresses at points of a body: arrays with the points' shape (...)."""
    @property
    def ux(self) -> NDArray[numpy.float64]:
        """Displacement of this body, shape (...) [m]."""
    @property
    def uy(self) -> NDArray[numpy.float64]:
        """Displacement of this body, shape (...) [m]."""
    @property
    def uz(self) -> NDArray[numpy.float64]:
        """Displacement of this body, shape (...) [m]."""
    @property
    def xx(self) -> NDArray[numpy.float64]:
        """sigma_xx, tension positive, shape (...) [Pa]."""
    @property
    def yy(self) -> NDArray[numpy.float64]:
        """sigma_yy, tension positive, shape (...) [Pa]."""
    @property
    def zz(self) -> NDArray[numpy.float64]:
        """sigma_zz, tension positive, shape (...) [Pa]."""
    @property
    def xy(self) -> NDArray[numpy.float64]:
        """sigma_xy, shape (...) [Pa]."""
    @property
    def xz(self) -> NDArray[numpy.float64]:
        """sigma_xz, shape (...) [Pa]."""
    @property
    def yz(self) -> NDArray[numpy.float64]:
        """sigma_yz, shape (...) [Pa]."""
    @property
    def hydrostatic(self) -> NDArray[numpy.float64]:
        """(xx + yy + zz)/3, shape (...) [Pa]."""
    @property
    def von_mises(self) -> NDArray[numpy.float64]:
        """Von Mises' stress, the root of 3 J2, shape (...) [Pa]."""
    @property
    def tresca(self) -> NDArray[numpy.float64]:
        """sigma1 - sigma3, twice the largest shear stress, shape (...) [Pa]."""
    @property
    def principal(self) -> NDArray[numpy.float64]:
        """sigma1 >= sigma2 >= sigma3, shape (..., 3) [Pa]."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""
    def to_dataframe(self) -> Any:
        """All arrays, and inputs that vary, as a pandas.DataFrame, a row for each element; in attrs the units [SI], the
        numbers that all rows share, what result it is, and the version; needs pandas."""
    def to_xarray(self) -> Any:
        """All arrays and inputs as an xarray.Dataset with their units [SI], numbers that all share without dimensions; in
        attrs what result it is, and the version; needs xarray."""

class LayerPeak:
    """The largest von Mises stress in a layer or what is below all."""
    @property
    def body(self) -> int:
        """1 or 2 [-]."""
    @property
    def layer(self) -> int:
        """From the surface inwards, from 0 [-]; the number of layers: below all."""
    @property
    def von_mises(self) -> float:
        """[Pa]."""
    @property
    def place(self) -> tuple:
        """x, y and depth [m]."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class LayeredBodies:
    """Two bodies with layers in contact, in place of half-spaces, for the exact theory on classical elements."""
    def __init__(self, body1: LayeredBody, body2: LayeredBody, rolling_velocity: float = 0.0) -> None:
        """Made from two LayeredBody and the velocity V [m/s] of steady rolling, which viscoelastic ones
        need: positive along +x, negative with direction 'backward'."""
    @property
    def body1(self) -> LayeredBody:
        """The LayeredBody that forces act on."""
    @property
    def body2(self) -> LayeredBody:
        """The other LayeredBody."""
    @property
    def rolling_velocity(self) -> float:
        """V [m/s]."""
    @property
    def are_elastic(self) -> bool:
        """Whether no material of them relaxes."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class LayeredBody:
    """A half-space or rigid core below layers."""
    def __init__(self, substrate: ViscoelasticMaterial, layers: list[BodyLayer] = []) -> None:
        """Made from what is below, a Material or ViscoelasticMaterial, of infinite modulus a rigid core, and
        up to 20 BodyLayer [m] from the surface inwards. Error for values out of range."""
    @property
    def layers(self) -> list[BodyLayer]:
        """List of BodyLayer, from the surface inwards."""
    @property
    def substrate(self) -> ViscoelasticMaterial:
        """The ViscoelasticMaterial below them."""
    @property
    def is_elastic(self) -> bool:
        """Whether no material of it relaxes."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class LayeredPeaks:
    """What loads layers and the bonds between them."""
    @property
    def layers(self) -> list[LayerPeak]:
        """List of LayerPeak."""
    @property
    def interfaces(self) -> list[InterfacePeak]:
        """List of InterfacePeak."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class LineContact:
    """Two cylinders with parallel axes, per unit length."""
    @property
    def half_width(self) -> float:
        """a [m], along the rolling direction."""
    @property
    def force_per_length(self) -> float:
        """fn [N/m]."""
    @property
    def peak_pressure(self) -> float:
        """p0 = 2 fn/(pi a) [Pa]."""
    @property
    def curvature(self) -> float:
        """A = 1/(2R) of the gap h = A x^2 [1/m]."""
    def pressure(self, x: ArrayLike) -> Any:
        """p_n(x) = p0 sqrt(1 - (x/a)^2), 0 outside [Pa]; x [m] is a number or an array, shape (...)."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class Material:
    """A linearly elastic, isotropic body."""
    def __init__(self, shear_modulus: float, poisson_ratio: float) -> None:
        """Made from the shear modulus G [Pa], > 0, infinite for a rigid body, and Poisson's ratio [-],
        in [0, 0.5]. Values are checked where they are used."""
    @staticmethod
    def from_young(young_modulus: float, poisson_ratio: float) -> Material:
        """Made from Young's modulus E [Pa], > 0, infinite for a rigid body: G = E/(2 (1 + nu)). Poisson's
        ratio [-] in [0, 0.5]. Error if out of range."""
    @property
    def shear_modulus(self) -> float:
        """Shear modulus G [Pa]."""
    @property
    def poisson_ratio(self) -> float:
        """Poisson's ratio nu [-]."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class MaterialCreep:
    """Constants of a Material as a standard linear solid: under a constant stress its elastic deformation grows by the share f (1 - exp(-t/tau))."""
    def __init__(self, ratio: float, time: float) -> None:
        """Made from f [-] >= 0, 0 for an elastic body, and tau [s] >= 0."""
    @property
    def ratio(self) -> float:
        """f [-]."""
    @property
    def time(self) -> float:
        """tau [s]."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class Method:
    """Solution method of a RollingProblem; options left out take the best value for it."""
    def __init__(self, *, theory: Literal["fastsim", "fastsim_half_step", "fastsim2", "exact", "fastrip", "table"] | None = 'fastsim2', grid: int | tuple[int, int] | None = 20, accuracy: float | None = ..., discretisation: Literal["second_order", "classical"] | None = ..., elements: Literal["constant", "bilinear"] | None = ..., tolerance: float | None = 1e-06, coupling: Literal["newton", "alternating"] | None = ..., slip_start: Literal["below", "above"] | None = ..., bound: Literal["parabolic", "elliptic"] | None = ..., flexibility: Literal["three", "one", "blended"] | None = ..., coefficients: Literal["kalker", "computed"] | None = 'kalker', slope_reduction: tuple[float, float, float] | None = ..., table: CreepForceTable | None = ...) -> None:
        """By keywords. Error for values out of range.
            theory [-]: the exact theory of half-spaces, an algorithm of the simplified theory, or a creep-force table; fastsim, fastsim_half_step, fastsim2, exact, fastrip or table; default 'fastsim2'
            grid [-]: elements or cells across the contact along x and y; in [1, 2000]; default 20
            accuracy [-]: exact: accuracy of the forces in mu Fn, for which grids are chosen; in [1e-05, 0.1]
            discretisation [-]: exact: of steady rolling; second_order or classical; default 'second_order'
            elements [-]: exact: tractions of an element, of the classical discretisation; constant or bilinear; default 'constant'
            tolerance [-]: exact: relative residual at which a solution counts as converged; in [1e-14, 0.1]; default 1e-06
            coupling [-]: exact: of the normal and the tangential problem of dissimilar materials; newton or alternating; default 'newton'
            slip_start [-]: exact: which solution is taken where falling friction has several; below or above; default 'below'
            bound [-]: simplified: traction bound; FaStrip's is elliptic; parabolic or elliptic; default 'parabolic'
            flexibility [-]: simplified: flexibilities; FaStrip's default is blended; three, one or blended; default 'three'
            coefficients [-]: simplified: creepage coefficients, Kalker's table or computed ones; kalker or computed; default 'kalker'
            slope_reduction [-]: initial, at_infinity and decay, which lessen the creep curve's slope
            table [-]: the CreepForceTable of theory 'table'; left out: the one that microslip has"""
    def replace(self, *, theory: Literal["fastsim", "fastsim_half_step", "fastsim2", "exact", "fastrip", "table"] | None = ..., grid: int | tuple[int, int] | None = ..., accuracy: float | None = ..., discretisation: Literal["second_order", "classical"] | None = ..., elements: Literal["constant", "bilinear"] | None = ..., tolerance: float | None = ..., coupling: Literal["newton", "alternating"] | None = ..., slip_start: Literal["below", "above"] | None = ..., bound: Literal["parabolic", "elliptic"] | None = ..., flexibility: Literal["three", "one", "blended"] | None = ..., coefficients: Literal["kalker", "computed"] | None = ..., slope_reduction: tuple[float, float, float] | None = ..., table: CreepForceTable | None = ...) -> Method:
        """Copy with other keywords [SI units]; None removes one."""
    @property
    def theory(self) -> Literal["fastsim", "fastsim_half_step", "fastsim2", "exact", "fastrip", "table"]:
        """theory [-]: the exact theory of half-spaces, an algorithm of the simplified theory, or a creep-force table; fastsim, fastsim_half_step, fastsim2, exact, fastrip or table; default 'fastsim2'"""
    @property
    def grid(self) -> int | tuple[int, int]:
        """grid [-]: elements or cells across the contact along x and y; in [1, 2000]; default 20"""
    @property
    def accuracy(self) -> float | None:
        """accuracy [-]: exact: accuracy of the forces in mu Fn, for which grids are chosen; in [1e-05, 0.1]"""
    @property
    def discretisation(self) -> Literal["second_order", "classical"] | None:
        """discretisation [-]: exact: of steady rolling; second_order or classical; default 'second_order'"""
    @property
    def elements(self) -> Literal["constant", "bilinear"] | None:
        """elements [-]: exact: tractions of an element, of the classical discretisation; constant or bilinear; default 'constant'"""
    @property
    def tolerance(self) -> float:
        """tolerance [-]: exact: relative residual at which a solution counts as converged; in [1e-14, 0.1]; default 1e-06"""
    @property
    def coupling(self) -> Literal["newton", "alternating"] | None:
        """coupling [-]: exact: of the normal and the tangential problem of dissimilar materials; newton or alternating; default 'newton'"""
    @property
    def slip_start(self) -> Literal["below", "above"] | None:
        """slip_start [-]: exact: which solution is taken where falling friction has several; below or above; default 'below'"""
    @property
    def bound(self) -> Literal["parabolic", "elliptic"] | None:
        """bound [-]: simplified: traction bound; FaStrip's is elliptic; parabolic or elliptic; default 'parabolic'"""
    @property
    def flexibility(self) -> Literal["three", "one", "blended"] | None:
        """flexibility [-]: simplified: flexibilities; FaStrip's default is blended; three, one or blended; default 'three'"""
    @property
    def coefficients(self) -> Literal["kalker", "computed"]:
        """coefficients [-]: simplified: creepage coefficients, Kalker's table or computed ones; kalker or computed; default 'kalker'"""
    @property
    def slope_reduction(self) -> tuple[float, float, float] | None:
        """slope_reduction [-]: initial, at_infinity and decay, which lessen the creep curve's slope"""
    @property
    def table(self) -> CreepForceTable | None:
        """table [-]: the CreepForceTable of theory 'table'; left out: the one that microslip has"""
    def to_dict(self) -> dict[str, Any]:
        """All keywords [SI units] as a dict, None for what is not given; arrays are copies."""

class Nip:
    """Results of steady rolling as users of rollers name them."""
    @property
    def width(self) -> float:
        """Length of the contact along x [m]."""
    @property
    def peak_pressure(self) -> float:
        """[Pa]."""
    @property
    def indentation(self) -> float:
        """Approach of both rollers [m]."""
    @property
    def traction(self) -> float:
        """Tangential force [N]."""
    @property
    def traction_capacity(self) -> float:
        """mu Fn [N]."""
    @property
    def utilisation(self) -> float:
        """Traction over its capacity [-]."""
    @property
    def hysteresis_power(self) -> float:
        """Power lost inside the rollers [W]."""
    @property
    def slip_power(self) -> float:
        """Power lost in slip [W]."""
    @property
    def rolling_resistance(self) -> float:
        """Hysteresis over the speed [N]."""
    @property
    def body1(self) -> RollerState:
        """RollerState of body 1."""
    @property
    def body2(self) -> RollerState:
        """RollerState of body 2."""
    @property
    def warnings(self) -> list[str]:
        """Texts: strains beyond small ones, a cover or nip beside the radii."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class NormalProblem:
    """The normal contact problem of any gap on a grid of elements with constant pressure: p_n >= 0, e
    = h - delta + u_n >= 0, p_n e = 0, by conjugate gradients, without friction: any K."""
    def __init__(self, material: CombinedMaterial, grid: ElementGrid) -> None:
        """Error for a grid that needs more memory than the machine has; some 190 bytes for an element."""
    def solve(self, gap: ArrayLike, *, normal_force: float | None = None, approach: float | None = None, tolerance: float = 1e-08) -> NormalSolution:
        """Solves for the undeformed distance h [m] at the elements' centres, shape (my, mx), with either
        the normal force [N] or the approach [m] given. Returns NormalSolution. Error for a gap with NaN
        or a load out of range. Cost O(N log N)."""

class NormalSolution:
    """The contact area and the pressure on it; read-only views of shape (my, mx)."""
    @property
    def pressure(self) -> NDArray[numpy.float64]:
        """p_n >= 0, shape (my, mx) [Pa]."""
    @property
    def displacement(self) -> NDArray[numpy.float64]:
        """u_n, shape (my, mx) [m]."""
    @property
    def gap(self) -> NDArray[numpy.float64]:
        """Deformed distance h - delta + u_n, zero in contact, shape (my, mx) [m]."""
    @property
    def approach(self) -> float:
        """delta [m]."""
    @property
    def normal_force(self) -> float:
        """Fn [N]."""
    @property
    def elastic_energy(self) -> float:
        """Of the pressure [J]."""
    @property
    def peak_pressure(self) -> float:
        """Largest pressure of an element [Pa]."""
    @property
    def contact_elements(self) -> int:
        """Elements in contact [-]."""
    @property
    def touches_border(self) -> bool:
        """True if contact reaches the rim of the grid, which then is too small."""
    @property
    def residual(self) -> float:
        """Relative to the largest displacement [-]."""
    @property
    def products(self) -> int:
        """Products with the matrix [-]."""
    @property
    def status(self) -> Status:
        """How the calculation ended, a Status [-]."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class Profile:
    """The cross-section of a rail, or of a wheel through its axle: cubic splines between kinks, y to the field side,
    z up, from the gauge side to the field side, or from the back of the flange to the outer face."""
    def __init__(self, y: ArrayLike, z: ArrayLike, kind: Literal["rail", "wheel"], *, smoothing_length: float | None = None, trim: tuple[float, float] | None = None) -> None:
        """Points y, z [m], shape (n), in any order along the curve; smoothing_length [m], 0: none, None: by the points'
        noise, if they scatter; trim drops the ends with y outside (y_min, y_max) [m]. Error for fewer than 4 points,
        for a length outside 5 mm to 500 mm, and for a curve that crosses itself; the report says what was done and
        what looks wrong."""
    @property
    def kind(self) -> str:
        """rail or wheel."""
    @property
    def length(self) -> float:
        """Length of the polygon through the points [m], the largest s."""
    @property
    def extent(self) -> tuple[float, float] | None:
        """Positions of the first and the last slice of a varying profile, along the track [m] or around the
        wheel [rad]; else None. Its points are those of the first one."""
    @property
    def y(self) -> NDArray[numpy.float64]:
        """y of the points that the spline is laid through [m], shape (n)."""
    @property
    def z(self) -> NDArray[numpy.float64]:
        """z of these points [m], shape (n)."""
    @property
    def measured_y(self) -> NDArray[numpy.float64]:
        """y of the points before smoothing [m], shape (n)."""
    @property
    def measured_z(self) -> NDArray[numpy.float64]:
        """z of these points [m], shape (n)."""
    @property
    def report(self) -> ProfileReport:
        """The ProfileReport."""
    def point(self, s: ArrayLike) -> tuple[Any, Any]:
        """y and z [m] of the curve at s [m], a number or an array, shape (...); straight lines beyond its ends."""
    def angle(self, s: ArrayLike) -> Any:
        """Inclination [rad] of the curve at s [m], from y towards z."""
    def curvature(self, s: ArrayLike) -> Any:
        """Curvature [1/m] at s [m], positive where the curve turns from y towards z."""
    def wheel_dimensions(self, tape_line: float | None = None) -> WheelDimensions:
        """WheelDimensions by EN 15313 from the tape line's y [m]; None: 0 if the profile begins about 70 mm on the
        flange's side of its origin, else 70 mm from its first point."""
    def gauge_point(self, height: float = 0.014) -> GaugePoint:
        """The GaugePoint, at most `height` [m] below the top, > 0."""
    def write(self, path: str | os.PathLike[str]) -> None:
        """Writes the points [mm] as the file's ending says: .prr, .prw, .ban, .whl, columns for others."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class ProfileKink:
    """A corner of a profile, at which its spline is cut."""
    @property
    def y(self) -> float:
        """[m], to the field side."""
    @property
    def z(self) -> float:
        """[m], up."""
    @property
    def s(self) -> float:
        """Length along the polygon through the points [m]."""
    @property
    def angle(self) -> float:
        """By which the direction turns [rad], positive from y to z."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class ProfileReport:
    """What was done to a profile's points and what is conspicuous about them; print it."""
    @property
    def source(self) -> str:
        """The file's name; empty without one."""
    @property
    def format(self) -> str:
        """Simpack, MiniProf or columns; empty without a file."""
    @property
    def comment(self) -> str:
        """From the file."""
    @property
    def unit(self) -> float:
        """Length of the file's unit with the scale [m]."""
    @property
    def points_read(self) -> int:
        """Points in the file or arrays [-]."""
    @property
    def points(self) -> int:
        """Points that the spline is laid through [-]."""
    @property
    def steps(self) -> list[str]:
        """What was done to the points, in order."""
    @property
    def assumptions(self) -> list[str]:
        """What neither the file nor an argument says."""
    @property
    def warnings(self) -> list[str]:
        """What is probably wrong."""
    @property
    def kinks(self) -> list[ProfileKink]:
        """Corners, as ProfileKink."""
    @property
    def noise(self) -> float:
        """Standard deviation of the points across the curve [m]."""
    @property
    def curvature_noise(self) -> float:
        """Standard deviation of the curvature that follows from the noise [1/m]."""
    @property
    def recommended_smoothing_length(self) -> float:
        """Wavelength of smoothing with the best peak pressures [m]; 0: the points do not scatter."""
    @property
    def smoothing_length(self) -> float:
        """Wavelength of smoothing that was asked for [m]; 0: none."""
    @property
    def smoothed_by_noise(self) -> bool:
        """Whether the points were smoothed by their noise, since they scatter and smoothing_length was None."""
    @property
    def mean_move(self) -> float:
        """Root mean square of what smoothing moved the points by [m]."""
    @property
    def largest_move(self) -> float:
        """Largest move of a point by smoothing [m]."""
    @property
    def curvature_change(self) -> float:
        """Root mean square of what smoothing changed the polygon's curvature by [1/m]."""
    @property
    def curvature_left(self) -> float:
        """Standard deviation of the curvature of 6 mm that smoothing by noise leaves [1/m], median of the profile."""
    @property
    def pressure_left(self) -> float:
        """The same of the peak pressure of a straight tread on a head of radius 300 mm, relative [-]."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class PronyTerm:
    """A term of a Prony series: a share of the modulus at short times relaxes as exp(-t/tau)."""
    @overload
    def __init__(self, share: float, time: float) -> None:
        """Made from the share g [-], > 0, and tau [s], > 0; a tuple of both stands for it. The sum of a
        series' shares is below 1. Values are checked where they are used."""
    @overload
    def __init__(self, of: tuple[float, float]) -> None:
        """The same from (g [-], tau [s])."""
    @property
    def share(self) -> float:
        """g [-]."""
    @property
    def time(self) -> float:
        """tau [s]."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class RollerState:
    """What a nip asks of one roller."""
    @property
    def pressure_power(self) -> float:
        """Power that pressure takes from it [W]."""
    @property
    def drive(self) -> float:
        """Torque over the radius that its drive must supply [N]; negative: it is driven."""
    @property
    def indentation(self) -> float:
        """Largest displacement inwards [m]."""
    @property
    def cover(self) -> float:
        """Thickness of its cover [m]."""
    @property
    def strain(self) -> float:
        """Indentation over the cover's thickness [-], 0 without a cover."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class RollingCase:
    """What a case file says; read_case and parse_case make them."""
    @property
    def title(self) -> str:
        """Its title."""
    @property
    def body1(self) -> Body:
        """The body that forces act on, e.g. the wheel."""
    @property
    def body2(self) -> Body:
        """The other body, e.g. the rail."""
    @property
    def problem(self) -> RollingProblem:
        """The RollingProblem of its bodies."""
    @property
    def method(self) -> Method:
        """The Method that it asks for."""
    @property
    def strength(self) -> SurfaceStrength | None:
        """SurfaceStrength of the surface whose wear and fatigue are asked for, or None."""
    @property
    def hertz(self) -> HertzContact:
        """The HertzContact."""
    @property
    def contact(self) -> CaseContact:
        """The EllipticContact for the solvers of either theory, with the K of dissimilar bodies; to be
        read, not changed: copy.copy(case.contact) gives one that can be."""
    @property
    def text(self) -> str:
        """The text of the file."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class RollingContactResult:
    """All that `microslip solve` computes of a case."""
    @property
    def case(self) -> RollingCase:
        """The RollingCase."""
    @property
    def hertz(self) -> HertzContact:
        """The HertzContact."""
    @property
    def contact(self) -> EllipticContact:
        """The EllipticContact, with creepages as found where a force is prescribed."""
    @property
    def exact(self) -> ExactResult | None:
        """ExactResult, None if the case does not ask for it."""
    @property
    def table(self) -> TableResult | None:
        """TableResult, None if the case does not ask for it."""
    @property
    def simplified(self) -> SimplifiedResult | None:
        """SimplifiedResult, also beside the exact theory in steady rolling and a table; else None."""
    @property
    def damage(self) -> ContactDamage | None:
        """ContactDamage by the theory that the case asks for; None without [material]."""
    @property
    def interior(self) -> InteriorStates | None:
        """InteriorStates at the case's points, shape (z, y, x) as their lists; None without any."""
    @property
    def status(self) -> Status:
        """Status of the theory that the case asks for [-]."""
    @property
    def warnings(self) -> list[str]:
        """Reasons why the contact is implausible for half-spaces, as texts; solve_case warns of it. Often a
        length in mm or a modulus in MPa."""
    def write(self, path: str | os.PathLike[str]) -> None:
        """Writes the HDF5 file that `microslip solve` writes, SI units [-]: whole or not at all. Error if it cannot be written."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class RollingProblem:
    """Two bodies that roll or are shifted over each other: all that is given, by the keys of case files."""
    @overload
    def __init__(self, contact: EllipticContact, /, *, bodies: Bodies | CombinedMaterial | LayeredBodies = ..., a: float | None = ..., b: float | None = ..., gap: GapCurvatures | ArrayLike | None = ..., grid: ElementGrid | None = ..., normal_force: float | None = ..., approach: float | None = ..., friction: FrictionLaw | float = ..., memory_distance: float | None = ..., memory_speed: float | None = ..., temperature_effect: TemperatureEffect | None = ..., thermal: tuple[ThermalBody, ThermalBody] | None = ..., kind: Literal["shift", "transient", "steady"] | None = ..., creepage_longitudinal: float | None = ..., force_longitudinal: float | None = ..., creepage_lateral: float | None = ..., force_lateral: float | None = ..., spin: float | None = ..., shift_longitudinal: float | None = ..., shift_lateral: float | None = ..., rotation: float | None = ..., rolling_speed: float | None = ..., direction: Literal["forward", "backward"] | None = ..., step: float | None = ..., steps: int | None = ...) -> None:
        """That of an EllipticContact, whose numbers solvers check, with keywords beyond it or in place of its
        own ones [SI units]."""
    @overload
    def __init__(self, *, bodies: Bodies | CombinedMaterial | LayeredBodies, a: float | None = ..., b: float | None = ..., gap: GapCurvatures | ArrayLike | None = ..., grid: ElementGrid | None = ..., normal_force: float | None = ..., approach: float | None = ..., friction: FrictionLaw | float, memory_distance: float | None = 0.0, memory_speed: float | None = 0.0, temperature_effect: TemperatureEffect | None = ..., thermal: tuple[ThermalBody, ThermalBody] | None = ..., kind: Literal["shift", "transient", "steady"] | None = 'steady', creepage_longitudinal: float | None = 0.0, force_longitudinal: float | None = ..., creepage_lateral: float | None = 0.0, force_lateral: float | None = ..., spin: float | None = 0.0, shift_longitudinal: float | None = 0.0, shift_lateral: float | None = 0.0, rotation: float | None = 0.0, rolling_speed: float | None = ..., direction: Literal["forward", "backward"] | None = 'forward', step: float | None = ..., steps: int | None = 1) -> None:
        """By keywords. Error for numbers out of range and what is missing.
            bodies [-]: the CombinedMaterial of two bodies, or Bodies with a layer between them or viscoelastic ones, or LayeredBodies
            a [m]: semi-axis of the ellipse of contact along the rolling direction, in place of all radii; positive
            b [m]: its lateral semi-axis; positive
            gap [m]: in place of a and b, GapCurvatures or the distance h of the bodies at the centres of the grid's elements, shape (my, mx)
            grid [m]: the ElementGrid of such a distance
            normal_force [N]: force that presses the bodies together; or approach. Of cylinders with layers, all transverse radii inf, this and all forces are those of a metre; positive
            approach [m]: relative approach of distant points, in place of normal_force; positive
            friction [-]: a FrictionLaw, or a coefficient for Coulomb's
            memory_distance [m]: distance of slip over which friction follows the slip velocity; in [0, 1e+06]; default 0.0
            memory_speed [m/s]: slip velocity with which it follows at least; in [0, 1e+06]; default 0.0
            temperature_effect [K]: the TemperatureEffect, what temperatures add to the friction
            thermal [K]: the ThermalBody of both bodies, whose surfaces have temperatures then
            kind [-]: steady rolling, transient rolling from no tractions on, or a shift; shift, transient or steady; default 'steady'
            creepage_longitudinal [-]: longitudinal creepage; positive gives a negative force; default 0.0
            force_longitudinal [N]: prescribed longitudinal force on body 1, in place of the creepage
            creepage_lateral [-]: lateral creepage; default 0.0
            force_lateral [N]: prescribed lateral force on body 1, in place of the creepage
            spin [1/m]: spin about the normal; default 0.0
            shift_longitudinal [m]: shift: rigid displacement of body 1 over body 2 along x; default 0.0
            shift_lateral [m]: the same along y; default 0.0
            rotation [rad]: shift: rotation about the normal; default 0.0
            rolling_speed [m/s]: speed with which the contact moves over the bodies; positive
            direction [-]: rolling along +x or along -x; forward or backward; default 'forward'
            step [m]: distance rolled in a step; left out: the elements' length; positive
            steps [-]: number of steps of transient rolling; in [1, 1e+06]; default 1"""
    def replace(self, *, bodies: Bodies | CombinedMaterial | LayeredBodies = ..., a: float | None = ..., b: float | None = ..., gap: GapCurvatures | ArrayLike | None = ..., grid: ElementGrid | None = ..., normal_force: float | None = ..., approach: float | None = ..., friction: FrictionLaw | float = ..., memory_distance: float | None = ..., memory_speed: float | None = ..., temperature_effect: TemperatureEffect | None = ..., thermal: tuple[ThermalBody, ThermalBody] | None = ..., kind: Literal["shift", "transient", "steady"] | None = ..., creepage_longitudinal: float | None = ..., force_longitudinal: float | None = ..., creepage_lateral: float | None = ..., force_lateral: float | None = ..., spin: float | None = ..., shift_longitudinal: float | None = ..., shift_lateral: float | None = ..., rotation: float | None = ..., rolling_speed: float | None = ..., direction: Literal["forward", "backward"] | None = ..., step: float | None = ..., steps: int | None = ...) -> RollingProblem:
        """Copy with other keywords [SI units]; None removes one. A force replaces a creepage, an
        approach in place of the force, and so on."""
    @property
    def bodies(self) -> Bodies | LayeredBodies:
        """bodies [-]: the CombinedMaterial of two bodies, or Bodies with a layer between them or viscoelastic ones, or LayeredBodies"""
    @property
    def a(self) -> float | None:
        """a [m]: semi-axis of the ellipse of contact along the rolling direction, in place of all radii; positive"""
    @property
    def b(self) -> float | None:
        """b [m]: its lateral semi-axis; positive"""
    @property
    def gap(self) -> GapCurvatures | NDArray[numpy.float64] | None:
        """gap [m]: in place of a and b, GapCurvatures or the distance h of the bodies at the centres of the grid's elements, shape (my, mx)"""
    @property
    def grid(self) -> ElementGrid | None:
        """grid [m]: the ElementGrid of such a distance"""
    @property
    def normal_force(self) -> float | None:
        """normal_force [N]: force that presses the bodies together; or approach. Of cylinders with layers, all transverse radii inf, this and all forces are those of a metre; positive"""
    @property
    def approach(self) -> float | None:
        """approach [m]: relative approach of distant points, in place of normal_force; positive"""
    @property
    def friction(self) -> FrictionLaw:
        """friction [-]: a FrictionLaw, or a coefficient for Coulomb's"""
    @property
    def memory_distance(self) -> float:
        """memory_distance [m]: distance of slip over which friction follows the slip velocity; in [0, 1e+06]; default 0.0"""
    @property
    def memory_speed(self) -> float:
        """memory_speed [m/s]: slip velocity with which it follows at least; in [0, 1e+06]; default 0.0"""
    @property
    def temperature_effect(self) -> TemperatureEffect | None:
        """temperature_effect [K]: the TemperatureEffect, what temperatures add to the friction"""
    @property
    def thermal(self) -> tuple[ThermalBody, ThermalBody] | None:
        """thermal [K]: the ThermalBody of both bodies, whose surfaces have temperatures then"""
    @property
    def kind(self) -> Literal["shift", "transient", "steady"]:
        """kind [-]: steady rolling, transient rolling from no tractions on, or a shift; shift, transient or steady; default 'steady'"""
    @property
    def creepage_longitudinal(self) -> float | None:
        """creepage_longitudinal [-]: longitudinal creepage; positive gives a negative force; default 0.0"""
    @property
    def force_longitudinal(self) -> float | None:
        """force_longitudinal [N]: prescribed longitudinal force on body 1, in place of the creepage"""
    @property
    def creepage_lateral(self) -> float | None:
        """creepage_lateral [-]: lateral creepage; default 0.0"""
    @property
    def force_lateral(self) -> float | None:
        """force_lateral [N]: prescribed lateral force on body 1, in place of the creepage"""
    @property
    def spin(self) -> float | None:
        """spin [1/m]: spin about the normal; default 0.0"""
    @property
    def shift_longitudinal(self) -> float | None:
        """shift_longitudinal [m]: shift: rigid displacement of body 1 over body 2 along x; default 0.0"""
    @property
    def shift_lateral(self) -> float | None:
        """shift_lateral [m]: the same along y; default 0.0"""
    @property
    def rotation(self) -> float | None:
        """rotation [rad]: shift: rotation about the normal; default 0.0"""
    @property
    def rolling_speed(self) -> float | None:
        """rolling_speed [m/s]: speed with which the contact moves over the bodies; positive"""
    @property
    def direction(self) -> Literal["forward", "backward"]:
        """direction [-]: rolling along +x or along -x; forward or backward; default 'forward'"""
    @property
    def step(self) -> float | None:
        """step [m]: distance rolled in a step; left out: the elements' length; positive"""
    @property
    def steps(self) -> int | None:
        """steps [-]: number of steps of transient rolling; in [1, 1e+06]; default 1"""
    def to_dict(self) -> dict[str, Any]:
        """All keywords [SI units] as a dict, None for what is not given; arrays are copies."""

class RollingRadiusDifference:
    """The rolling radius difference of a wheelset over its lateral displacement, linear between values; what EN 15302 finds from it."""
    def __init__(self, lateral: ArrayLike, difference: ArrayLike) -> None:
        """Left less right rolling radius [m], shape (n), at ascending lateral displacements [m], shape (n); two
        equal ones are a jump. Error for fewer than two."""
    def at(self, lateral: ArrayLike) -> Any:
        """The difference [m] at lateral displacements [m], shape (...); NaN beyond the ends."""
    def equivalent_conicity(self, amplitude: ArrayLike, contact_distance: float = 1.5, nominal_radius: float = 0.46) -> Any:
        """Equivalent conicity [-] by EN 15302 at amplitudes [m], shape (...): that of conical wheels with the same
        kinematic wavelength; NaN where no such motion exists. contact_distance e [m] of both contacts."""
    def wavelength(self, amplitude: ArrayLike, contact_distance: float = 1.5, nominal_radius: float = 0.46) -> Any:
        """Wavelength [m] of the motion of a free wheelset with these amplitudes [m], shape (...), that rolls without
        slip."""
    def nonlinearity_parameter(self, contact_distance: float = 1.5, nominal_radius: float = 0.46) -> Any:
        """Change of the equivalent conicity from 2 to 4 mm of amplitude, per metre [1/m]; the standard's is per mm."""
    def radial_steering_index(self, lateral: ArrayLike, curve_radius: ArrayLike, contact_distance: float = 1.5, nominal_radius: float = 0.46) -> Any:
        """The difference at lateral displacements [m] over the one that rolls without slip through a curve of that
        radius [m], shape (...) [-]: from 1 on the wheelset can steer itself radially."""

class RowSolver:
    """Base of Fastsim and Fastsim2: all memory is taken when one is made, then it is used again and again."""
    @overload
    def solve(self, contact: EllipticContact) -> ContactForces:
        """Forces [N], [N m] and areas [m^2] of a contact, as ContactForces. Input out of range gives
        Status.invalid_input and NaN. Full sliding gives mu Fn to rounding on every grid. Cost O(mx my)."""
    @overload
    def solve(self, contact: EllipticContact, longitudinal: float, lateral: float, spin: float) -> ContactForces:
        """Solves with other creepages [-], [-] and spin [1/m] than those of the contact."""
    @overload
    def differentiate(self, contact: EllipticContact) -> ContactDerivatives:
        """Forces [N], [N m] and their derivatives with respect to xi [-], eta [-], phi [1/m] and Fn [N],
        as ContactDerivatives: forward differentiation of the same code."""
    @overload
    def differentiate(self, contact: EllipticContact, longitudinal: float, lateral: float, spin: float) -> ContactDerivatives:
        """Solves with other creepages [-], [-] and spin [1/m] than those of the contact."""
    def fields(self, contact: EllipticContact) -> ContactSolution:
        """Forces [N] with tractions [Pa], slip [-] and state of every cell, as ContactSolution."""
    def patch_fields(self, y: ArrayLike, leading: ArrayLike, trailing: ArrayLike, pressure: ArrayLike, *, row_width: float, flexibilities: tuple[float, float, float], friction: FrictionLaw | float, creepage: Creepage | tuple[float, float, float], rolling_speed: float = 1.0) -> ContactSolution:
        """The fields of a patch of any outline, as ContactSolution: rows at y [m], shape (my), from their
        leading to their trailing edges x [m], shape (my), with the pressure p_n [Pa] at the centres of
        mx cells each, shape (my, mx), x ascending; row_width [m], flexibilities L [m/Pa] for
        longitudinal creepage, lateral creepage and spin, friction [-] or a law,
        creepages [-], [-], [1/m] and the speed V [m/s]. Error for an invalid patch."""
    @property
    def mx(self) -> int:
        """Cells of a row [-]."""
    @property
    def my(self) -> int:
        """Rows [-]."""
    def solve_batch(self, like: EllipticContact, longitudinal: ArrayLike | None = None, lateral: ArrayLike | None = None, spin: ArrayLike | None = None, *, a: ArrayLike | None = None, b: ArrayLike | None = None, shear_modulus: ArrayLike | None = None, poisson_ratio: ArrayLike | None = None, normal_force: ArrayLike | None = None, friction: ArrayLike | None = None, rolling_speed: ArrayLike | None = None, dissimilarity: ArrayLike | None = None, threads: int = 0) -> ForceArrays:
        """Many contacts in one call, on all processors (threads = 0) or as many threads as given. `like`
        is a contact; fields that are given replace those of it, as numbers or arrays that broadcast:
        longitudinal [-], lateral [-], spin [1/m], a [m], b [m], shear_modulus [Pa], poisson_ratio [-],
        normal_force [N], friction [-], rolling_speed [m/s], dissimilarity [-]. Results have the
        broadcast shape (...) and do not depend on the number of threads. Ctrl-C ends the call with
        KeyboardInterrupt. Error for arrays that are no real numbers or do not match; contacts out
        of range have Status.invalid_input and NaN. Returns ForceArrays."""
    def differentiate_batch(self, like: EllipticContact, longitudinal: ArrayLike | None = None, lateral: ArrayLike | None = None, spin: ArrayLike | None = None, *, a: ArrayLike | None = None, b: ArrayLike | None = None, shear_modulus: ArrayLike | None = None, poisson_ratio: ArrayLike | None = None, normal_force: ArrayLike | None = None, friction: ArrayLike | None = None, rolling_speed: ArrayLike | None = None, dissimilarity: ArrayLike | None = None, threads: int = 0) -> DerivativeArrays:
        """Many contacts in one call, on all processors (threads = 0) or as many threads as given. `like`
        is a contact; fields that are given replace those of it, as numbers or arrays that broadcast:
        longitudinal [-], lateral [-], spin [1/m], a [m], b [m], shear_modulus [Pa], poisson_ratio [-],
        normal_force [N], friction [-], rolling_speed [m/s], dissimilarity [-]. Results have the
        broadcast shape (...) and do not depend on the number of threads. Ctrl-C ends the call with
        KeyboardInterrupt. Error for arrays that are no real numbers or do not match; contacts out
        of range have Status.invalid_input and NaN. Returns DerivativeArrays."""

class SimplifiedResult:
    """Result of the simplified theory for a case."""
    @property
    def solution(self) -> ContactSolution:
        """The ContactSolution."""
    @property
    def forces(self) -> ContactForces:
        """The totals, as ContactForces."""
    @property
    def discretisation_error(self) -> DiscretisationError:
        """To the grid with twice the cells [-], [W]."""
    @property
    def curve(self) -> CreepCurve:
        """The CreepCurve through the case."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class SolutionArrays:
    """Forces of many contacts with what the solver reports."""
    @property
    def forces(self) -> ForceArrays:
        """The forces."""
    @property
    def residual(self) -> NDArray[numpy.float64]:
        """Relative residuals at the end of the iteration, shape (...) [-]."""
    @property
    def newton_steps(self) -> NDArray[numpy.int32]:
        """Steps of Newton's method, shape (...) [-]."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""
    def to_dataframe(self) -> Any:
        """All arrays, and inputs that vary, as a pandas.DataFrame, a row for each element; in attrs the units [SI], the
        numbers that all rows share, what result it is, and the version; needs pandas."""
    def to_xarray(self) -> Any:
        """All arrays and inputs as an xarray.Dataset with their units [SI], numbers that all share without dimensions; in
        attrs what result it is, and the version; needs xarray."""

class SolutionStep:
    """One of the steps of transient rolling."""
    @property
    def creepage(self) -> Creepage:
        """Creepages as given, or found where a force is prescribed [-], [-], [1/m]."""
    @property
    def forces(self) -> ContactForces:
        """The totals, as ContactForces."""
    @property
    def residual(self) -> float:
        """Relative residual [-]."""
    @property
    def newton_steps(self) -> int:
        """Iterations of Newton's method [-]."""
    @property
    def products(self) -> int:
        """Products with the matrix [-]."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class Solver:
    """Solves any RollingProblem by one Method, and keeps for the next one what does not change: influence
    coefficients, transforms, pressures. An EllipticContact stands for the problem that it makes. Calls from
    several Python threads wait for each other; Ctrl-C ends them."""
    @overload
    def __init__(self, method: Method, /) -> None:
        """Error if the grid needs more memory than the machine has [-]."""
    @overload
    def __init__(self, *, theory: Literal["fastsim", "fastsim_half_step", "fastsim2", "exact", "fastrip", "table"] | None = 'fastsim2', grid: int | tuple[int, int] | None = 20, accuracy: float | None = ..., discretisation: Literal["second_order", "classical"] | None = ..., elements: Literal["constant", "bilinear"] | None = ..., tolerance: float | None = 1e-06, coupling: Literal["newton", "alternating"] | None = ..., slip_start: Literal["below", "above"] | None = ..., bound: Literal["parabolic", "elliptic"] | None = ..., flexibility: Literal["three", "one", "blended"] | None = ..., coefficients: Literal["kalker", "computed"] | None = 'kalker', slope_reduction: tuple[float, float, float] | None = ..., table: CreepForceTable | None = ...) -> None:
        """Made with the keywords of a Method [-] instead of one."""
    @property
    def method(self) -> Method:
        """The Method."""
    def solve(self, problem: RollingProblem | EllipticContact) -> ContactSolution:
        """The ContactSolution of a problem [SI units]. Input out of range, not converging, no contact and a force
        beyond friction are a status with its reason, and NaN. Error for a problem that the method cannot
        honour, and of a gap on a grid for any input out of range. Cost of the exact theory O(N log N) in the
        number of elements, 2 ms at 24 x 24."""
    def differentiate(self, problem: RollingProblem | EllipticContact) -> ExactDerivatives:
        """Steady rolling by the exact theory with creepages given and Coulomb friction: forces [N], [N m] and their
        derivatives with respect to xi [-], eta [-], phi [1/m] and the load, as ExactDerivatives, by the implicit
        function theorem, accurate to 1e-5 away from kinks."""
    def respond(self, problem: RollingProblem | EllipticContact, wavenumber: list[float], *, roughness: bool = False) -> FrequencyResponse:
        """Complex responses of the forces [N], [N m] to oscillations of creepages [-], spin [1/m] and normal force [N]
        about steady rolling at wavenumbers omega/V [1/m], as FrequencyResponse; with roughness also to that [m],
        and those of frictional work. Elastically similar bodies with Coulomb friction, by the exact theory at
        second order; else Error. Cost: 5 ms for each at 24 x 24, 15 ms with roughness."""
    def deformed_gap(self, problem: RollingProblem | EllipticContact) -> NDArray[numpy.float64]:
        """Deformed distance of the bodies h - delta + u_n by the exact theory at the elements of the solution,
        shape (my, mx) [m]; zero in contact."""
    def solve_batch(self, like: RollingProblem | EllipticContact, longitudinal: ArrayLike | None = None, lateral: ArrayLike | None = None, spin: ArrayLike | None = None, *, a: ArrayLike | None = None, b: ArrayLike | None = None, shear_modulus: ArrayLike | None = None, poisson_ratio: ArrayLike | None = None, normal_force: ArrayLike | None = None, friction: ArrayLike | None = None, rolling_speed: ArrayLike | None = None, dissimilarity: ArrayLike | None = None, threads: int = 0) -> SolutionArrays:
        """Many contacts in one call, on all processors (threads = 0) or as many threads as given. `like`
        is a contact; fields that are given replace those of it, as numbers or arrays that broadcast:
        longitudinal [-], lateral [-], spin [1/m], a [m], b [m], shear_modulus [Pa], poisson_ratio [-],
        normal_force [N], friction [-], rolling_speed [m/s], dissimilarity [-]. Results have the
        broadcast shape (...) and do not depend on the number of threads. Ctrl-C ends the call with
        KeyboardInterrupt. Error for arrays that are no real numbers or do not match; contacts out
        of range have Status.invalid_input and NaN. A problem may stand for it. Returns SolutionArrays. Of the simplified theory
        Fastsim2.solve_batch is much faster."""

class Status(enum.IntEnum):
    """Outcome of a calculation [-]: ok; invalid_input, an input is out of range and the numbers are
    NaN; not_converged, the result is the best one found; no_contact, the bodies do not touch;
    no_solution, the force given is beyond friction and the result slides fully; out_of_range, beyond
    the range of a creep-force table, the forces are those of limits; implausible, solved, but it
    cannot be meant, as its warnings say. An IntEnum: arrays of codes compare with it."""
    ok = 0
    invalid_input = 1
    not_converged = 2
    no_contact = 3
    no_solution = 4
    out_of_range = 5
    implausible = 6

class SurfaceFields:
    """The fields of a ContactSolution: read-only views of shape (my, mx), y ascending with the rows, x
    within a row; None for one that the solution does not have. Zero outside the contact."""
    @property
    def x(self) -> object:
        """Centre of the element along the rolling direction, shape (my, mx) [m]; None if the solution does not have it."""
    @property
    def y(self) -> object:
        """Lateral centre of the element, shape (my, mx) [m]; None if the solution does not have it."""
    @property
    def width(self) -> object:
        """Length of the element along x, shape (my, mx) [m]; None if the solution does not have it."""
    @property
    def area(self) -> object:
        """What the element counts for in the forces, shape (my, mx) [m^2]; None if the solution does not have it."""
    @property
    def pressure(self) -> object:
        """Pressure, shape (my, mx) [Pa]; None if the solution does not have it."""
    @property
    def bound(self) -> object:
        """Traction bound, shape (my, mx) [Pa]; None if the solution does not have it."""
    @property
    def px(self) -> object:
        """Longitudinal traction on body 1, shape (my, mx) [Pa]; None if the solution does not have it."""
    @property
    def py(self) -> object:
        """Lateral traction on body 1, shape (my, mx) [Pa]; None if the solution does not have it."""
    @property
    def sx(self) -> object:
        """Relative slip of body 1 over body 2, longitudinal, shape (my, mx) [-], of a shift [m]; None if the solution does not have it."""
    @property
    def sy(self) -> object:
        """Relative slip of body 1 over body 2, lateral, shape (my, mx) [-], of a shift [m]; None if the solution does not have it."""
    @property
    def ux(self) -> object:
        """Displacement difference u1 - u2, longitudinal, shape (my, mx) [m]; None if the solution does not have it."""
    @property
    def uy(self) -> object:
        """Displacement difference u1 - u2, lateral, shape (my, mx) [m]; None if the solution does not have it."""
    @property
    def gap(self) -> object:
        """Distance of the deformed bodies, shape (my, mx) [m]; None if the solution does not have it."""
    @property
    def friction(self) -> object:
        """Coefficient of friction, where it depends on slip or temperature, shape (my, mx) [-]; None if the solution does not have it."""
    @property
    def temperature1(self) -> object:
        """Temperature of body 1's surface, shape (my, mx) [deg C]; None if the solution does not have it."""
    @property
    def temperature2(self) -> object:
        """Temperature of body 2's surface, shape (my, mx) [deg C]; None if the solution does not have it."""
    @property
    def state(self) -> NDArray[numpy.uint8]:
        """Codes of CellState as uint8, shape (my, mx) [-]."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""
    def to_dataframe(self) -> Any:
        """All arrays, and inputs that vary, as a pandas.DataFrame, a row for each element; in attrs the units [SI], the
        numbers that all rows share, what result it is, and the version; needs pandas."""
    def to_xarray(self) -> Any:
        """All arrays and inputs as an xarray.Dataset with their units [SI], numbers that all share without dimensions; in
        attrs what result it is, and the version; needs xarray."""

class SurfaceStrength:
    """Strength of surfaces against wear and yield; None: not known."""
    def __init__(self, *, hardness: float | None = None, shear_yield_strength: float | None = None, wear_map: WearMap = WearMap(slow=0.00055, medium=0.0035, fast=0.00055, seizure=0.035, medium_from=0.2, medium_to=0.7, seizure_above=0.8)) -> None:
        """Hardness H [Pa] of the surface that wears, yield strength k [Pa] in shear of the work-hardened surface,
        and the WearMap. Values are checked where they are used."""
    @property
    def hardness(self) -> float | None:
        """H [Pa], or None."""
    @property
    def shear_yield_strength(self) -> float | None:
        """k [Pa], or None."""
    @property
    def wear_map(self) -> WearMap:
        """The WearMap."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class SweepReport:
    """How the cases of a sweep ended."""
    @property
    def cases(self) -> int:
        """All of them [-]."""
    @property
    def failed(self) -> int:
        """Those with another status than ok [-]."""
    @property
    def from_checkpoint(self) -> int:
        """Those that an earlier run had computed [-]."""

class TableResult:
    """What a creep-force table makes of a case."""
    @property
    def solution(self) -> ContactSolution:
        """The ContactSolution, without fields."""
    @property
    def forces(self) -> ContactForces:
        """The totals, as ContactForces."""
    @property
    def curve(self) -> CreepCurve:
        """The CreepCurve through the case."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class TangentialProblem:
    """The tangential contact problem of the exact theory on a grid of elements with constant
    tractions, classical discretisation, elastically similar bodies: shifts, steps of transient
    rolling, steady rolling."""
    def __init__(self, material: CombinedMaterial, grid: ElementGrid) -> None:
        """Error for bodies with K != 0 and for a grid that needs more memory than the machine has; some
        5,900 bytes for an element at most."""
    def solve(self, bound: ArrayLike, creepage: Creepage | tuple[float, float, float], *, kind: Literal["steady", "transient", "shift"] = 'steady', force_longitudinal: float | None = None, force_lateral: float | None = None, step: float = 0.0, direction: Literal["forward", "backward"] = 'forward', rolling_speed: float = 1.0, previous: TangentialSolution | None = None, tolerance: float = 1e-06) -> TangentialSolution:
        """Solves one problem, or one step: bound g = mu p_n [Pa], shape (my, mx), zero outside the contact;
        creepages [-], [-], [1/m], for a shift [m], [m], [rad]; force_longitudinal, force_lateral [N]
        on body 1 instead of the creepage in that direction; step dq [m], 0 the elements' length; rolling_speed V [m/s];
        previous: the TangentialSolution that a shift or a step of transient rolling starts from, none:
        no tractions; tolerance of the relative residual [-]. Returns TangentialSolution. Error for
        input out of range."""

class TangentialSolution:
    """Tractions and slip on a regular grid; read-only views of shape (my, mx), x and y ascending."""
    @property
    def px(self) -> NDArray[numpy.float64]:
        """Tractions on body 1, shape (my, mx) [Pa]."""
    @property
    def py(self) -> NDArray[numpy.float64]:
        """Tractions on body 1, shape (my, mx) [Pa]."""
    @property
    def bound(self) -> NDArray[numpy.float64]:
        """g, shape (my, mx) [Pa]."""
    @property
    def ux(self) -> NDArray[numpy.float64]:
        """u1 - u2, shape (my, mx) [m]."""
    @property
    def uy(self) -> NDArray[numpy.float64]:
        """u1 - u2, shape (my, mx) [m]."""
    @property
    def sx(self) -> NDArray[numpy.float64]:
        """Relative slip, shape (my, mx) [-]; for a shift [m]."""
    @property
    def sy(self) -> NDArray[numpy.float64]:
        """Relative slip, shape (my, mx) [-]; for a shift [m]."""
    @property
    def state(self) -> NDArray[numpy.uint8]:
        """Codes of CellState as uint8, shape (my, mx) [-]."""
    @property
    def forces(self) -> ContactForces:
        """The totals, as ContactForces."""
    @property
    def creepage(self) -> Creepage:
        """Creepages as given, or as found where a force is prescribed [-], [-], [1/m]."""
    @property
    def elastic_energy(self) -> float:
        """Of the tractions [J]."""
    @property
    def frictional_power(self) -> float:
        """[W]; for a shift the work [J]."""
    @property
    def residual(self) -> float:
        """Relative residual [-]."""
    @property
    def newton_steps(self) -> int:
        """Steps of Newton's method [-]."""
    @property
    def products(self) -> int:
        """Products with the matrix [-]."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class TemperatureEffect:
    """Change of a friction coefficient with the surfaces' temperature T: change min(1, max(0, (T - begin)/range))."""
    def __init__(self, change: float, begin: float, range: float) -> None:
        """Made from the whole change [-], the temperature [deg C] up to which there is none, and the range [K]
        > 0 over which it grows. Error for numbers out of range."""
    @property
    def change(self) -> float:
        """The whole change [-]."""
    @property
    def begin(self) -> float:
        """Up to this temperature there is none [deg C]."""
    @property
    def range(self) -> float:
        """Over which it grows [K]."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class ThermalBody:
    """What a body is for heat."""
    def __init__(self, bulk_temperature: float, conductivity: float, density: float, heat_capacity: float) -> None:
        """Made from the temperature [deg C] with which it enters the contact, lambda [W/(m K)], rho [kg/m^3]
        and c [J/(kg K)], all three > 0. Error for numbers out of range."""
    @property
    def bulk_temperature(self) -> float:
        """Where it enters the contact [deg C]."""
    @property
    def conductivity(self) -> float:
        """lambda [W/(m K)]."""
    @property
    def density(self) -> float:
        """rho [kg/m^3]."""
    @property
    def heat_capacity(self) -> float:
        """c [J/(kg K)]."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class Track:
    """A track in its nominal position, both rails alike."""
    def __init__(self, *, gauge: float = 1.435, gauge_height: float = 0.014, cant: float = 0.0, rail_origin: tuple[float, float] | None = None, roller_radius: float = 0.0) -> None:
        """gauge [m] between the gauge points, which lie at most gauge_height [m] below the tops of the
        rails; cant [rad], positive towards the track's centre; rail_origin (y, z) [m] of the left rail's
        profile in track axes, instead of the gauge; roller_radius [m], nominal one of rollers instead of rails,
        negative of raceways, or 0. Values are checked where they are used."""
    @property
    def roller_radius(self) -> float:
        """Of rollers instead of rails [m], or 0."""
    @property
    def gauge(self) -> float:
        """Between the gauge points of both rails [m]."""
    @property
    def gauge_height(self) -> float:
        """Of the gauge points below the rails' tops [m]."""
    @property
    def cant(self) -> float:
        """Inclination of the rails [rad], positive towards the track's centre."""
    @property
    def rail_origin(self) -> object:
        """y and z [m] of the left rail's profile in track axes, or None: by the gauge."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class ViscoelasticMaterial:
    """A linearly viscoelastic, isotropic material, or an elastic one."""
    @overload
    def __init__(self, instantaneous: Material, shear_relaxation: list[PronyTerm] = [], bulk_relaxation: list[PronyTerm] | None = None) -> None:
        """Made from the Material of short times, with G [Pa] and nu [-], and the PronyTerm lists [-, s] of
        its shear and bulk modulus, of any length. Without one for the bulk modulus that relaxes as the
        shear modulus does, and Poisson's ratio is constant; with an empty one it is elastic. A Material
        stands for an elastic one."""
    @overload
    def __init__(self, elastic: Material) -> None:
        """An elastic one."""
    @property
    def instantaneous(self) -> Material:
        """The Material at t = 0 of a relaxation."""
    @property
    def shear_relaxation(self) -> list[PronyTerm]:
        """List of PronyTerm of the shear modulus."""
    @property
    def bulk_relaxation(self) -> list[PronyTerm] | None:
        """The same of the bulk modulus, or None."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class WearMap:
    """Wear coefficients of Archard's law over sliding speed and pressure, by default the middles of the ranges that
    KTH measured for dry wheel and rail steels (Jendel 2002)."""
    def __init__(self, *, slow: float = 0.00055, medium: float = 0.0035, fast: float = 0.00055, seizure: float = 0.035, medium_from: float = 0.2, medium_to: float = 0.7, seizure_above: float = 0.8) -> None:
        """k [-] below the sliding speed medium_from [m/s], up to medium_to [m/s], beyond, and where the pressure is
        above seizure_above [-] times the hardness."""
    @property
    def slow(self) -> float:
        """k below medium_from [-]: mild."""
    @property
    def medium(self) -> float:
        """k from medium_from to medium_to [-]: severe."""
    @property
    def fast(self) -> float:
        """k beyond medium_to [-]."""
    @property
    def seizure(self) -> float:
        """k at high pressure [-]."""
    @property
    def medium_from(self) -> float:
        """Sliding speed [m/s]."""
    @property
    def medium_to(self) -> float:
        """Sliding speed [m/s]."""
    @property
    def seizure_above(self) -> float:
        """Pressure over hardness [-]."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class WheelDimensions:
    """A flange's dimensions by EN 15313; None where the profile does not reach."""
    @property
    def tape_line(self) -> float:
        """y of the tape line [m], 70 mm from the flange's back."""
    @property
    def flange_height(self) -> float | None:
        """Sh [m], from the tape line to the tip."""
    @property
    def flange_thickness(self) -> float | None:
        """Sd [m], from the back, at 10 mm from the tape line towards the tip."""
    @property
    def flange_gradient(self) -> float | None:
        """qR [m], width from there to the flank 2 mm short of the tip."""
    @property
    def flange_angle(self) -> float | None:
        """Largest inclination of the flank between tip and tape line [rad]."""
    @property
    def tape_circle(self) -> float | None:
        """z of the tread at the tape line [m]."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class WheelRail:
    """A wheel on a rail by their profiles: finds the patches and solves them. May be used from many threads, one call at a time."""
    def __init__(self, *, track: Track, rail: Profile, wheelset: Wheelset, wheel: Profile, side: Literal["left", "right"] = 'left', material: Material = Material(shear_modulus=82031250000.0, poisson_ratio=0.28), friction: FrictionLaw | float | tuple[ArrayLike, ArrayLike] = 0.3, theory: Literal["fastsim2", "exact", "table"] = 'fastsim2', shape: Literal["flat", "curved", "conformal"] | None = None, grid: int = 24, tolerance: float = 1e-06, strength: SurfaceStrength = SurfaceStrength(hardness=None, shear_yield_strength=None, wear_map=WearMap(slow=0.00055, medium=0.0035, fast=0.00055, seizure=0.035, medium_from=0.2, medium_to=0.7, seizure_above=0.8)), fields: bool = False, table: CreepForceTable | None = None, wheel_layers: list[BodyLayer] = [], rail_layers: list[BodyLayer] = []) -> None:
        """The profiles of rail and wheel, as read_profile gives them; the side of the track; the Material of both
        bodies, by default steel with E = 210 GPa and nu = 0.28; friction [-], a number or a pair of arrays
        (angles [rad], coefficients) of surfaces that rise to the field side; theory "exact" with grid
        elements across each patch [-] and its patches' shape: the true surfaces (None), or flat, curved,
        conformal; rows of fastsim2 and table always follow the surface; tolerance [-] of the vertical force; the
        SurfaceStrength, for wear and fatigue; whether solutions of fastsim2 have fields; of theory "table" the CreepForceTable,
        by default the one of microslip for the bodies' Poisson's ratio; elastic BodyLayer of wheel and rail from
        the surface inwards, on the material, for theory "exact" and the shape flat or curved. Error for values
        out of range and profiles that do not fit the track or the wheelset."""
    def solve(self, *, lateral: float = 0.0, vertical: float = ..., roll: float = 0.0, yaw: float = 0.0, forward_velocity: float, lateral_velocity: float = 0.0, vertical_velocity: float = 0.0, roll_velocity: float = 0.0, pitch_velocity: float = ..., yaw_velocity: float = 0.0, curvature: float = 0.0, deflection_longitudinal: float = 0.0, deflection_lateral: float = 0.0, deflection_vertical: float = 0.0, deflection_roll: float = 0.0, deflection_yaw: float = 0.0, deflection_longitudinal_velocity: float = 0.0, deflection_lateral_velocity: float = 0.0, deflection_vertical_velocity: float = 0.0, deflection_roll_velocity: float = 0.0, deflection_pitch_velocity: float = 0.0, deflection_yaw_velocity: float = 0.0, deviation_lateral: float = 0.0, deviation_vertical: float = 0.0, deviation_roll: float = 0.0, deviation_lateral_velocity: float = 0.0, deviation_vertical_velocity: float = 0.0, deviation_roll_velocity: float = 0.0, longitudinal: float = 0.0, pitch: float = 0.0, vertical_force: float = ...) -> WheelRailSolution:
        """The WheelRailSolution in a state, given by keywords, 0 where they are left out:
            lateral [m]: position of the wheelset's centre, to the left positive
            vertical [m]: height of the wheelset's centre above the nominal radius, upwards positive
            roll [rad]: roll of the wheelset; positive raises the left wheel
            yaw [rad]: yaw of the wheelset; positive turns to the left
            forward_velocity [m/s]: velocity of the wheelset's centre along the track
            lateral_velocity [m/s]: velocity of the wheelset's centre to the left
            vertical_velocity [m/s]: velocity of the wheelset's centre upwards
            roll_velocity [rad/s]: angular velocity of the wheelset about its x
            pitch_velocity [rad/s]: angular velocity of the wheelset about its axle; positive rolls forward
            yaw_velocity [rad/s]: angular velocity of the wheelset about its z
            curvature [1/m]: curvature of the track; positive in a curve to the left
            deflection_longitudinal [m]: motion of the wheel's centre against the axle, forward
            deflection_lateral [m]: the same to the left
            deflection_vertical [m]: the same upwards
            deflection_roll [rad]: rotation of the wheel against the axle about x
            deflection_yaw [rad]: the same about z
            deflection_longitudinal_velocity [m/s]: velocity of that motion, forward
            deflection_lateral_velocity [m/s]: the same to the left
            deflection_vertical_velocity [m/s]: the same upwards
            deflection_roll_velocity [rad/s]: angular velocity of that rotation about x
            deflection_pitch_velocity [rad/s]: the same about the axle
            deflection_yaw_velocity [rad/s]: the same about z
            deviation_lateral [m]: of the rail from its nominal position, to the left positive
            deviation_vertical [m]: the same upwards
            deviation_roll [rad]: rotation of the rail about x, right-handed
            deviation_lateral_velocity [m/s]: velocity of that deviation to the left
            deviation_vertical_velocity [m/s]: the same upwards
            deviation_roll_velocity [rad/s]: angular velocity of that rotation
            longitudinal [m]: position of the wheelset's centre along the track, or from a roller's top
            pitch [rad]: angle by which the wheelset has turned; positive rolls forward
            vertical_force [N]: on the wheel, > 0; either this or vertical must be given
        pitch_velocity is forward_velocity over the nominal radius unless given. No contact and not converging are
        statuses; NaN gives invalid_input. Error for unknown names."""
    def solve_batch(self, threads: int = 0, *, lateral: ArrayLike = 0.0, vertical: ArrayLike = ..., roll: ArrayLike = 0.0, yaw: ArrayLike = 0.0, forward_velocity: ArrayLike, lateral_velocity: ArrayLike = 0.0, vertical_velocity: ArrayLike = 0.0, roll_velocity: ArrayLike = 0.0, pitch_velocity: ArrayLike = ..., yaw_velocity: ArrayLike = 0.0, curvature: ArrayLike = 0.0, deflection_longitudinal: ArrayLike = 0.0, deflection_lateral: ArrayLike = 0.0, deflection_vertical: ArrayLike = 0.0, deflection_roll: ArrayLike = 0.0, deflection_yaw: ArrayLike = 0.0, deflection_longitudinal_velocity: ArrayLike = 0.0, deflection_lateral_velocity: ArrayLike = 0.0, deflection_vertical_velocity: ArrayLike = 0.0, deflection_roll_velocity: ArrayLike = 0.0, deflection_pitch_velocity: ArrayLike = 0.0, deflection_yaw_velocity: ArrayLike = 0.0, deviation_lateral: ArrayLike = 0.0, deviation_vertical: ArrayLike = 0.0, deviation_roll: ArrayLike = 0.0, deviation_lateral_velocity: ArrayLike = 0.0, deviation_vertical_velocity: ArrayLike = 0.0, deviation_roll_velocity: ArrayLike = 0.0, longitudinal: ArrayLike = 0.0, pitch: ArrayLike = 0.0, vertical_force: ArrayLike = ...) -> WheelRailArrays:
        """The WheelRailArrays of many states, given as for solve [SI units], numbers or arrays that broadcast, on
        so many threads; 0: one for each processor. Ctrl-C ends it."""
    def differentiate(self, *, lateral: float = 0.0, vertical: float = ..., roll: float = 0.0, yaw: float = 0.0, forward_velocity: float, lateral_velocity: float = 0.0, vertical_velocity: float = 0.0, roll_velocity: float = 0.0, pitch_velocity: float = ..., yaw_velocity: float = 0.0, curvature: float = 0.0, deflection_longitudinal: float = 0.0, deflection_lateral: float = 0.0, deflection_vertical: float = 0.0, deflection_roll: float = 0.0, deflection_yaw: float = 0.0, deflection_longitudinal_velocity: float = 0.0, deflection_lateral_velocity: float = 0.0, deflection_vertical_velocity: float = 0.0, deflection_roll_velocity: float = 0.0, deflection_pitch_velocity: float = 0.0, deflection_yaw_velocity: float = 0.0, deviation_lateral: float = 0.0, deviation_vertical: float = 0.0, deviation_roll: float = 0.0, deviation_lateral_velocity: float = 0.0, deviation_vertical_velocity: float = 0.0, deviation_roll_velocity: float = 0.0, longitudinal: float = 0.0, pitch: float = 0.0, vertical_force: float = ...) -> WheelRailDerivatives:
        """The WheelRailDerivatives in a state given as for solve [SI units]: of forces and moments, and of the
        height that a vertical force finds. They hold where no patch comes or goes; those of a state that is not
        ok are zero. With theory "exact" those by velocities are accurate to 1e-4, by positions to some percent."""
    def differentiate_batch(self, threads: int = 0, *, lateral: ArrayLike = 0.0, vertical: ArrayLike = ..., roll: ArrayLike = 0.0, yaw: ArrayLike = 0.0, forward_velocity: ArrayLike, lateral_velocity: ArrayLike = 0.0, vertical_velocity: ArrayLike = 0.0, roll_velocity: ArrayLike = 0.0, pitch_velocity: ArrayLike = ..., yaw_velocity: ArrayLike = 0.0, curvature: ArrayLike = 0.0, deflection_longitudinal: ArrayLike = 0.0, deflection_lateral: ArrayLike = 0.0, deflection_vertical: ArrayLike = 0.0, deflection_roll: ArrayLike = 0.0, deflection_yaw: ArrayLike = 0.0, deflection_longitudinal_velocity: ArrayLike = 0.0, deflection_lateral_velocity: ArrayLike = 0.0, deflection_vertical_velocity: ArrayLike = 0.0, deflection_roll_velocity: ArrayLike = 0.0, deflection_pitch_velocity: ArrayLike = 0.0, deflection_yaw_velocity: ArrayLike = 0.0, deviation_lateral: ArrayLike = 0.0, deviation_vertical: ArrayLike = 0.0, deviation_roll: ArrayLike = 0.0, deviation_lateral_velocity: ArrayLike = 0.0, deviation_vertical_velocity: ArrayLike = 0.0, deviation_roll_velocity: ArrayLike = 0.0, longitudinal: ArrayLike = 0.0, pitch: ArrayLike = 0.0, vertical_force: ArrayLike = ...) -> WheelRailDerivativeArrays:
        """The WheelRailDerivativeArrays of many states, given as for solve_batch [SI units]."""

class WheelRailArrays:
    """Forces on a wheel in many states: arrays of the shape that the inputs broadcast to. Those of patches have one
    more dimension, for the k-th patch of a state, and are NaN where a state has fewer."""
    @property
    def force_x(self) -> NDArray[numpy.float64]:
        """Force on the wheel along the track, shape (...) [N]."""
    @property
    def force_y(self) -> NDArray[numpy.float64]:
        """Force on the wheel to the left, shape (...) [N]."""
    @property
    def force_z(self) -> NDArray[numpy.float64]:
        """Force on the wheel upwards, shape (...) [N]."""
    @property
    def moment_x(self) -> NDArray[numpy.float64]:
        """Moment on the wheel about its centre, about the track's x, shape (...) [N m]."""
    @property
    def moment_y(self) -> NDArray[numpy.float64]:
        """The same about y: positive drives the wheel forward, shape (...) [N m]."""
    @property
    def moment_z(self) -> NDArray[numpy.float64]:
        """The same about z, shape (...) [N m]."""
    @property
    def vertical(self) -> NDArray[numpy.float64]:
        """Height of the wheelset's centre above the nominal radius: given, or found for the force, shape (...) [m]."""
    @property
    def frictional_power(self) -> NDArray[numpy.float64]:
        """Power lost to friction in all patches, shape (...) [W]."""
    @property
    def t_gamma(self) -> NDArray[numpy.float64]:
        """|Fx xi| + |Fy eta|, summed over the patches, shape (...) [N]."""
    @property
    def t_gamma_with_spin(self) -> NDArray[numpy.float64]:
        """|Fx xi| + |Fy eta| + |Mz phi|, summed over the patches, shape (...) [N]."""
    @property
    def residual(self) -> NDArray[numpy.float64]:
        """Residual of the vertical force, relative, shape (...) [-]."""
    @property
    def iterations(self) -> NDArray[numpy.float64]:
        """Iterations over the wheel's height, shape (...) [-]."""
    @property
    def patch_count(self) -> NDArray[numpy.float64]:
        """Number of patches in contact, shape (...) [-]."""
    @property
    def y_over_q(self) -> NDArray[numpy.float64]:
        """Y/Q: force on the wheel towards the track's centre over the vertical one, shape (...) [-]."""
    @property
    def nadal_limit(self) -> NDArray[numpy.float64]:
        """Nadal's limit of Y/Q at the flange's steepest point, shape (...) [-]."""
    @property
    def worn_mass_r8t(self) -> NDArray[numpy.float64]:
        """Wear of wheel steel R8T by T-gamma per area, per metre rolled, all patches, shape (...) [kg/m]."""
    @property
    def worn_area(self) -> NDArray[numpy.float64]:
        """Archard's wear: cross-section that a passage wears off, or volume per metre; all patches, shape (...) [m^2]."""
    @property
    def patch_place_x(self) -> NDArray[numpy.float64]:
        """Of each patch: origin of the patch's frame on the rail, along the track, shape (..., k) [m]."""
    @property
    def patch_place_y(self) -> NDArray[numpy.float64]:
        """Of each patch: the same to the left of the track's centre, shape (..., k) [m]."""
    @property
    def patch_place_z(self) -> NDArray[numpy.float64]:
        """Of each patch: the same above the tops of the rails, shape (..., k) [m]."""
    @property
    def patch_angle(self) -> NDArray[numpy.float64]:
        """Of each patch: of the contact plane against the track plane; positive rises to the left, shape (..., k) [rad]."""
    @property
    def patch_rail_y(self) -> NDArray[numpy.float64]:
        """Of each patch: of the rail's profile there, in its axes: to the field side positive, shape (..., k) [m]."""
    @property
    def patch_wheel_y(self) -> NDArray[numpy.float64]:
        """Of each patch: of the wheel's profile there, in its axes, shape (..., k) [m]."""
    @property
    def patch_rolling_radius(self) -> NDArray[numpy.float64]:
        """Of each patch: of the wheel there, shape (..., k) [m]."""
    @property
    def patch_turn(self) -> NDArray[numpy.float64]:
        """Of each patch: by how much the rail's surface turns across the patch, shape (..., k) [rad]."""
    @property
    def patch_conformity(self) -> NDArray[numpy.float64]:
        """Of each patch: how it was solved: 0 as a curved (or flat) patch, 1 as a conformal one, in between where it turns by 10 to 18 degrees, shape (..., k) [-]."""
    @property
    def patch_approach(self) -> NDArray[numpy.float64]:
        """Of each patch: greatest overlap of the undeformed bodies along the normal, shape (..., k) [m]."""
    @property
    def patch_rolling_speed(self) -> NDArray[numpy.float64]:
        """Of each patch: rolling speed V, shape (..., k) [m/s]."""
    @property
    def patch_creepage_longitudinal(self) -> NDArray[numpy.float64]:
        """Of each patch: longitudinal creepage; positive for a braked wheel, shape (..., k) [-]."""
    @property
    def patch_creepage_lateral(self) -> NDArray[numpy.float64]:
        """Of each patch: lateral creepage, along the surface to the left, shape (..., k) [-]."""
    @property
    def patch_spin(self) -> NDArray[numpy.float64]:
        """Of each patch: spin about the normal, shape (..., k) [1/m]."""
    @property
    def patch_normal_force(self) -> NDArray[numpy.float64]:
        """Of each patch: force on the wheel along the normal, shape (..., k) [N]."""
    @property
    def patch_fx(self) -> NDArray[numpy.float64]:
        """Of each patch: force on the wheel along the track, shape (..., k) [N]."""
    @property
    def patch_fy(self) -> NDArray[numpy.float64]:
        """Of each patch: force on the wheel along the surface, to the left, shape (..., k) [N]."""
    @property
    def patch_mz(self) -> NDArray[numpy.float64]:
        """Of each patch: moment on the wheel about the normal through the patch's origin, shape (..., k) [N m]."""
    @property
    def patch_contact_area(self) -> NDArray[numpy.float64]:
        """Of each patch: area of the contact, shape (..., k) [m^2]."""
    @property
    def patch_slip_area(self) -> NDArray[numpy.float64]:
        """Of each patch: area of slip, shape (..., k) [m^2]."""
    @property
    def patch_peak_pressure(self) -> NDArray[numpy.float64]:
        """Of each patch: largest pressure, shape (..., k) [Pa]."""
    @property
    def patch_frictional_power(self) -> NDArray[numpy.float64]:
        """Of each patch: power lost to friction, shape (..., k) [W]."""
    @property
    def patch_t_gamma(self) -> NDArray[numpy.float64]:
        """Of each patch: |Fx xi| + |Fy eta|, shape (..., k) [N]."""
    @property
    def patch_t_gamma_with_spin(self) -> NDArray[numpy.float64]:
        """Of each patch: |Fx xi| + |Fy eta| + |Mz phi|, shape (..., k) [N]."""
    @property
    def patch_friction(self) -> NDArray[numpy.float64]:
        """Of each patch: friction coefficient at the patch's inclination, shape (..., k) [-]."""
    @property
    def patch_traction_coefficient(self) -> NDArray[numpy.float64]:
        """Of each patch: sqrt(Fx^2 + Fy^2)/Fn, shape (..., k) [-]."""
    @property
    def patch_t_gamma_per_area(self) -> NDArray[numpy.float64]:
        """Of each patch: T-gamma over the area of the contact, shape (..., k) [N/m^2]."""
    @property
    def patch_worn_mass_r8t(self) -> NDArray[numpy.float64]:
        """Of each patch: wear of wheel steel R8T by T-gamma per area, per metre rolled, shape (..., k) [kg/m]."""
    @property
    def patch_worn_area(self) -> NDArray[numpy.float64]:
        """Of each patch: Archard's wear: cross-section that a passage wears off, or volume per metre, shape (..., k) [m^2]."""
    @property
    def patch_wear_depth(self) -> NDArray[numpy.float64]:
        """Of each patch: Archard's wear: largest depth of a passage, shape (..., k) [m]."""
    @property
    def patch_fatigue_index(self) -> NDArray[numpy.float64]:
        """Of each patch: surface fatigue index: traction coefficient less k over the largest pressure, shape (..., k) [-]."""
    @property
    def patch_shakedown_load(self) -> NDArray[numpy.float64]:
        """Of each patch: largest pressure over the yield strength in shear: ordinate of the shakedown map, shape (..., k) [-]."""
    @property
    def patch_shakedown_limit(self) -> NDArray[numpy.float64]:
        """Of each patch: limit of that load at the traction coefficient, of a point contact, shape (..., k) [-]."""
    @property
    def patch_nadal_limit(self) -> NDArray[numpy.float64]:
        """Of each patch: Nadal's limit of Y/Q at the patch's contact angle, shape (..., k) [-]."""
    @property
    def status(self) -> NDArray[numpy.uint8]:
        """Codes of Status as uint8, shape (...) [-]; compare with Status.ok."""
    @property
    def warning_code(self) -> NDArray[numpy.uint32]:
        """Reasons to doubt results as uint32, shape (...) [-]: sum of 2^k of the warnings k of warning_texts()."""
    @property
    def inputs(self) -> dict[str, Any]:
        """The states that were given, by keyword:
        lateral [m],
        vertical [m],
        roll [rad],
        yaw [rad],
        forward_velocity [m/s],
        lateral_velocity [m/s],
        vertical_velocity [m/s],
        roll_velocity [rad/s],
        pitch_velocity [rad/s],
        yaw_velocity [rad/s],
        curvature [1/m],
        deflection_longitudinal [m],
        deflection_lateral [m],
        deflection_vertical [m],
        deflection_roll [rad],
        deflection_yaw [rad],
        deflection_longitudinal_velocity [m/s],
        deflection_lateral_velocity [m/s],
        deflection_vertical_velocity [m/s],
        deflection_roll_velocity [rad/s],
        deflection_pitch_velocity [rad/s],
        deflection_yaw_velocity [rad/s],
        deviation_lateral [m],
        deviation_vertical [m],
        deviation_roll [rad],
        deviation_lateral_velocity [m/s],
        deviation_vertical_velocity [m/s],
        deviation_roll_velocity [rad/s],
        longitudinal [m],
        pitch [rad],
        vertical_force [N]; by name numbers, or arrays of shape (...) of what varies."""
    def __len__(self) -> int: ...
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""
    def to_dataframe(self) -> Any:
        """All arrays, and inputs that vary, as a pandas.DataFrame, a row for each element; in attrs the units [SI], the
        numbers that all rows share, what result it is, and the version; needs pandas."""
    def to_xarray(self) -> Any:
        """All arrays and inputs as an xarray.Dataset with their units [SI], numbers that all share without dimensions; in
        attrs what result it is, and the version; needs xarray."""

class WheelRailDerivativeArrays:
    """Forces on a wheel in many states and their derivatives."""
    @property
    def jacobian(self) -> NDArray[numpy.float64]:
        """All derivatives of [N], [N m] and [m] by SI units, shape (..., 7, 31),
        as `results` and `variables` say; zero by what was not given, vertical or vertical_force."""
    @property
    def results(self) -> tuple[str, ...]:
        """Names of the Jacobian's rows: forces [N], moments [N m] and the height [m]."""
    @property
    def variables(self) -> tuple[str, ...]:
        """Names of its columns: the numbers of a state and vertical_force [SI units]."""
    def derivative(self, of: tuple[float, float], by: str) -> Any:
        """One column of one row by their names [SI units]: derivative("force_y", "lateral")."""
    @property
    def solution(self) -> WheelRailArrays:
        """The WheelRailArrays."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class WheelRailDerivatives:
    """Forces on a wheel and their derivatives."""
    @property
    def jacobian(self) -> NDArray[numpy.float64]:
        """All derivatives of [N], [N m] and [m] by SI units, shape (7, 31),
        as `results` and `variables` say; zero by what was not given, vertical or vertical_force."""
    @property
    def results(self) -> tuple[str, ...]:
        """Names of the Jacobian's rows: forces [N], moments [N m] and the height [m]."""
    @property
    def variables(self) -> tuple[str, ...]:
        """Names of its columns: the numbers of a state and vertical_force [SI units]."""
    def derivative(self, of: tuple[float, float], by: str) -> Any:
        """One column of one row by their names [SI units]: derivative("force_y", "lateral")."""
    @property
    def solution(self) -> WheelRailSolution:
        """The WheelRailSolution."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class WheelRailPatch:
    """A patch in which a wheel touches its rail. Forces act on the wheel. What needs a number of
    the SurfaceStrength is None without it."""
    @property
    def place_x(self) -> float | None:
        """Origin of the patch's frame on the rail, along the track [m]."""
    @property
    def place_y(self) -> float | None:
        """The same to the left of the track's centre [m]."""
    @property
    def place_z(self) -> float | None:
        """The same above the tops of the rails [m]."""
    @property
    def angle(self) -> float | None:
        """Of the contact plane against the track plane; positive rises to the left [rad]."""
    @property
    def rail_y(self) -> float | None:
        """Of the rail's profile there, in its axes: to the field side positive [m]."""
    @property
    def wheel_y(self) -> float | None:
        """Of the wheel's profile there, in its axes [m]."""
    @property
    def rolling_radius(self) -> float | None:
        """Of the wheel there [m]."""
    @property
    def turn(self) -> float | None:
        """By how much the rail's surface turns across the patch [rad]."""
    @property
    def conformity(self) -> float | None:
        """How it was solved: 0 as a curved (or flat) patch, 1 as a conformal one, in between where it turns by 10 to 18 degrees [-]."""
    @property
    def approach(self) -> float | None:
        """Greatest overlap of the undeformed bodies along the normal [m]."""
    @property
    def rolling_speed(self) -> float | None:
        """Rolling speed V [m/s]."""
    @property
    def creepage_longitudinal(self) -> float | None:
        """Longitudinal creepage; positive for a braked wheel [-]."""
    @property
    def creepage_lateral(self) -> float | None:
        """Lateral creepage, along the surface to the left [-]."""
    @property
    def spin(self) -> float | None:
        """Spin about the normal [1/m]."""
    @property
    def normal_force(self) -> float | None:
        """Force on the wheel along the normal [N]."""
    @property
    def fx(self) -> float | None:
        """Force on the wheel along the track [N]."""
    @property
    def fy(self) -> float | None:
        """Force on the wheel along the surface, to the left [N]."""
    @property
    def mz(self) -> float | None:
        """Moment on the wheel about the normal through the patch's origin [N m]."""
    @property
    def contact_area(self) -> float | None:
        """Area of the contact [m^2]."""
    @property
    def slip_area(self) -> float | None:
        """Area of slip [m^2]."""
    @property
    def peak_pressure(self) -> float | None:
        """Largest pressure [Pa]."""
    @property
    def frictional_power(self) -> float | None:
        """Power lost to friction [W]."""
    @property
    def t_gamma(self) -> float | None:
        """|Fx xi| + |Fy eta| [N]."""
    @property
    def t_gamma_with_spin(self) -> float | None:
        """|Fx xi| + |Fy eta| + |Mz phi| [N]."""
    @property
    def friction(self) -> float | None:
        """Friction coefficient at the patch's inclination [-]."""
    @property
    def traction_coefficient(self) -> float | None:
        """Sqrt(Fx^2 + Fy^2)/Fn [-]."""
    @property
    def t_gamma_per_area(self) -> float | None:
        """T-gamma over the area of the contact [N/m^2]."""
    @property
    def worn_mass_r8t(self) -> float | None:
        """Wear of wheel steel R8T by T-gamma per area, per metre rolled [kg/m]."""
    @property
    def worn_area(self) -> float | None:
        """Archard's wear: cross-section that a passage wears off, or volume per metre [m^2]."""
    @property
    def wear_depth(self) -> float | None:
        """Archard's wear: largest depth of a passage [m]."""
    @property
    def fatigue_index(self) -> float | None:
        """Surface fatigue index: traction coefficient less k over the largest pressure [-]."""
    @property
    def shakedown_load(self) -> float | None:
        """Largest pressure over the yield strength in shear: ordinate of the shakedown map [-]."""
    @property
    def shakedown_limit(self) -> float | None:
        """Limit of that load at the traction coefficient, of a point contact [-]."""
    @property
    def nadal_limit(self) -> float | None:
        """Nadal's limit of Y/Q at the patch's contact angle [-]."""
    @property
    def creepage(self) -> Creepage:
        """Creepages [-], [-] and spin [1/m], as one."""
    @property
    def status(self) -> Status:
        """How its calculation ended."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class WheelRailSolution:
    """Forces on a wheel in track axes: x forward, y to the left, z up; and its patches.
    A quantity that needs a number of the SurfaceStrength, or a flange, is None without it."""
    @property
    def force_x(self) -> float | None:
        """Force on the wheel along the track [N]."""
    @property
    def force_y(self) -> float | None:
        """Force on the wheel to the left [N]."""
    @property
    def force_z(self) -> float | None:
        """Force on the wheel upwards [N]."""
    @property
    def moment_x(self) -> float | None:
        """Moment on the wheel about its centre, about the track's x [N m]."""
    @property
    def moment_y(self) -> float | None:
        """The same about y: positive drives the wheel forward [N m]."""
    @property
    def moment_z(self) -> float | None:
        """The same about z [N m]."""
    @property
    def vertical(self) -> float | None:
        """Height of the wheelset's centre above the nominal radius: given, or found for the force [m]."""
    @property
    def frictional_power(self) -> float | None:
        """Power lost to friction in all patches [W]."""
    @property
    def t_gamma(self) -> float | None:
        """|Fx xi| + |Fy eta|, summed over the patches [N]."""
    @property
    def t_gamma_with_spin(self) -> float | None:
        """|Fx xi| + |Fy eta| + |Mz phi|, summed over the patches [N]."""
    @property
    def residual(self) -> float | None:
        """Residual of the vertical force, relative [-]."""
    @property
    def iterations(self) -> float | None:
        """Iterations over the wheel's height [-]."""
    @property
    def patch_count(self) -> float | None:
        """Number of patches in contact [-]."""
    @property
    def y_over_q(self) -> float | None:
        """Y/Q: force on the wheel towards the track's centre over the vertical one [-]."""
    @property
    def nadal_limit(self) -> float | None:
        """Nadal's limit of Y/Q at the flange's steepest point [-]."""
    @property
    def worn_mass_r8t(self) -> float | None:
        """Wear of wheel steel R8T by T-gamma per area, per metre rolled, all patches [kg/m]."""
    @property
    def worn_area(self) -> float | None:
        """Archard's wear: cross-section that a passage wears off, or volume per metre; all patches [m^2]."""
    @property
    def patches(self) -> list[WheelRailPatch]:
        """The patches as WheelRailPatch, from the gauge to the field side of a left wheel."""
    @property
    def fields(self) -> list[ContactSolution]:
        """The ContactSolution of each patch, in its frame, with theory "exact" or where fields are asked
        for; else empty."""
    @property
    def at_profile_end(self) -> bool:
        """True if a patch ends where a profile ends: its forces are too small."""
    @property
    def warnings(self) -> list[str]:
        """Reasons to doubt the result, as texts: pressures beyond elasticity, a profile's end, a flange that
        climbs, numbers that look like other units."""
    @property
    def reason(self) -> str:
        """Why the status is not ok; else empty."""
    @property
    def status(self) -> Status:
        """How the calculation ended."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class Wheelset:
    """A wheelset, both wheels alike."""
    def __init__(self, *, nominal_radius: float = 0.46, flange_back_distance: float = 1.36, flange_back_position: float = -0.07, tape_circle: float | None = None) -> None:
        """nominal_radius [m] where z = 0 in the profile, or at y = tape_circle [m] of it;
        flange_back_distance [m] between the backs of both flanges, which lie at y =
        flange_back_position [m] of the profile. Values are checked where they are used."""
    @property
    def nominal_radius(self) -> float:
        """Radius [m]."""
    @property
    def flange_back_distance(self) -> float:
        """Between the backs of both flanges [m]."""
    @property
    def flange_back_position(self) -> float:
        """y of the flange's back [m]."""
    @property
    def tape_circle(self) -> float | None:
        """y in the profile where the radius is the nominal one [m]."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class WheelsetContacts:
    """Contact points of both wheels of a rigid wheelset: arrays of the input's shape, NaN where there is no contact."""
    @property
    def lateral(self) -> NDArray[numpy.float64]:
        """Displacement of the wheelset's centre, to the left positive, shape (...) [m]."""
    @property
    def roll(self) -> NDArray[numpy.float64]:
        """Roll of the wheelset; positive raises the left wheel, shape (...) [rad]."""
    @property
    def vertical(self) -> NDArray[numpy.float64]:
        """Height of the wheelset's centre above the nominal radius where the wheels touch, shape (...) [m]."""
    @property
    def rolling_radius_difference(self) -> NDArray[numpy.float64]:
        """Left less right rolling radius, shape (...) [m]."""
    @property
    def contact_angle_difference(self) -> NDArray[numpy.float64]:
        """Left less right inclination, each positive where it rises to the field side, shape (...) [rad]."""
    @property
    def left_rail_y(self) -> NDArray[numpy.float64]:
        """Of the left wheel: on the rail's profile, in its own axes: to the field side positive, shape (...) [m]."""
    @property
    def right_rail_y(self) -> NDArray[numpy.float64]:
        """Of the right wheel: on the rail's profile, in its own axes: to the field side positive, shape (...) [m]."""
    @property
    def left_wheel_y(self) -> NDArray[numpy.float64]:
        """Of the left wheel: on the wheel's profile, in its own axes, shape (...) [m]."""
    @property
    def right_wheel_y(self) -> NDArray[numpy.float64]:
        """Of the right wheel: on the wheel's profile, in its own axes, shape (...) [m]."""
    @property
    def left_rolling_radius(self) -> NDArray[numpy.float64]:
        """Of the left wheel: of the wheel there, shape (...) [m]."""
    @property
    def right_rolling_radius(self) -> NDArray[numpy.float64]:
        """Of the right wheel: of the wheel there, shape (...) [m]."""
    @property
    def left_contact_angle(self) -> NDArray[numpy.float64]:
        """Of the left wheel: inclination of the surfaces against the track plane; positive rises to the left, shape (...) [rad]."""
    @property
    def right_contact_angle(self) -> NDArray[numpy.float64]:
        """Of the right wheel: inclination of the surfaces against the track plane; positive rises to the left, shape (...) [rad]."""
    @property
    def left_place_x(self) -> NDArray[numpy.float64]:
        """Of the left wheel: along the track, ahead of the wheelset's centre, shape (...) [m]."""
    @property
    def right_place_x(self) -> NDArray[numpy.float64]:
        """Of the right wheel: along the track, ahead of the wheelset's centre, shape (...) [m]."""
    @property
    def left_place_y(self) -> NDArray[numpy.float64]:
        """Of the left wheel: to the left of the track's centre, shape (...) [m]."""
    @property
    def right_place_y(self) -> NDArray[numpy.float64]:
        """Of the right wheel: to the left of the track's centre, shape (...) [m]."""
    @property
    def status(self) -> NDArray[numpy.uint8]:
        """Codes of Status as uint8, shape (...) [-]; compare with Status.ok."""
    def __len__(self) -> int: ...
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""
    def to_dataframe(self) -> Any:
        """All arrays, and inputs that vary, as a pandas.DataFrame, a row for each element; in attrs the units [SI], the
        numbers that all rows share, what result it is, and the version; needs pandas."""
    def to_xarray(self) -> Any:
        """All arrays and inputs as an xarray.Dataset with their units [SI], numbers that all share without dimensions; in
        attrs what result it is, and the version; needs xarray."""

class WheelsetDerivatives:
    """Forces on a wheelset and their derivatives."""
    @property
    def solution(self) -> WheelsetSolution:
        """The WheelsetSolution."""
    @property
    def jacobian(self) -> NDArray[numpy.float64]:
        """All derivatives of [N], [N m], [m], [rad] and [rad/s] by SI units, shape (9, 15),
        as `results` and `variables` say; zero by what was not given."""
    @property
    def results(self) -> tuple[str, ...]:
        """Names of the Jacobian's rows: forces [N], moments [N m], and height [m], roll [rad] and
        pitch velocity [rad/s] where they are found."""
    @property
    def variables(self) -> tuple[str, ...]:
        """Names of its columns: numbers of the state and prescribed forces [SI units]."""
    def derivative(self, of: tuple[float, float], by: str) -> Any:
        """One column of one row by their names [SI units]: derivative("force_y", "lateral")."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

class WheelsetGeometry:
    """A rigid wheelset on a track by their profiles: where both wheels touch, and its conicity."""
    def __init__(self, *, track: Track, rail: Profile, wheelset: Wheelset, wheel: Profile, right_rail: Profile | None = None, right_wheel: Profile | None = None, contact_distance: float = 1.5) -> None:
        """The profiles of rail and wheel, as read_profile gives them, of both sides or of the left one;
        contact_distance e [m] between the contacts of both wheels. Error for values out of range and profiles
        that do not fit the track or the wheelset."""
    def contact(self, lateral: ArrayLike, yaw: ArrayLike = 0.0, *, roll: Literal["equilibrium", "none"] = 'equilibrium', threads: int = 0) -> WheelsetContacts:
        """The WheelsetContacts at lateral displacements [m] and yaw angles [rad] that broadcast. With roll
        "equilibrium" both wheels touch, with "none" the roll angle is zero as in EN 15302. Ctrl-C ends it."""
    def curve(self, lateral_from: float, lateral_to: float, *, roll: Literal["equilibrium", "none"] = 'equilibrium', yaw: float = 0.0) -> WheelsetContacts:
        """The WheelsetContacts over lateral displacements [m], 0 between or at an end: 0.1 mm apart and as fine as the
        rolling radius difference needs to be linear in between within 1e-7 m. Jumps are two positions closer than
        1e-9 m. Ends early where a wheel leaves its rail; Error if there is no contact at 0."""
    def equivalent_conicity(self, amplitude: ArrayLike, *, gauge: ArrayLike | None = None, roll: Literal["equilibrium", "none"] = 'equilibrium', threads: int = 0) -> Any:
        """Equivalent conicity [-] by EN 15302 at amplitudes [m] and gauges [m], by default the track's, that
        broadcast: gauge[:, None] makes a map, shape (...). NaN where no periodic motion exists. Ctrl-C ends it."""
    def wavelength(self, amplitude: ArrayLike, *, gauge: ArrayLike | None = None, roll: Literal["equilibrium", "none"] = 'equilibrium', threads: int = 0) -> Any:
        """Wavelength [m] of the motion that rolls without slip, as equivalent_conicity, shape (...)."""
    def nonlinearity_parameter(self, *, gauge: ArrayLike | None = None, roll: Literal["equilibrium", "none"] = 'equilibrium', threads: int = 0) -> Any:
        """Change of the equivalent conicity from 2 to 4 mm of amplitude, per metre [1/m], shape (...)."""
    def radial_steering_index(self, lateral: ArrayLike, curve_radius: float, *, gauge: ArrayLike | None = None, roll: Literal["equilibrium", "none"] = 'equilibrium', threads: int = 0) -> Any:
        """The rolling radius difference at lateral displacements [m] over the one that rolls without slip through a
        curve of that radius [m], shape (...) [-]."""

class WheelsetOnTrack:
    """Both wheels of a wheelset on their rails: finds height and roll for a load, the rolling speed for a torque. May be used from many threads, one call at a time."""
    def __init__(self, *, track: Track, rail: Profile, wheelset: Wheelset, wheel: Profile, right_rail: Profile | None = None, right_wheel: Profile | None = None, material: Material = Material(shear_modulus=82031250000.0, poisson_ratio=0.28), friction: FrictionLaw | float | tuple[ArrayLike, ArrayLike] = 0.3, theory: Literal["fastsim2", "exact", "table"] = 'fastsim2', shape: Literal["flat", "curved", "conformal"] | None = None, grid: int = 24, tolerance: float = 1e-06, strength: SurfaceStrength = SurfaceStrength(hardness=None, shear_yield_strength=None, wear_map=WearMap(slow=0.00055, medium=0.0035, fast=0.00055, seizure=0.035, medium_from=0.2, medium_to=0.7, seizure_above=0.8)), fields: bool = False, table: CreepForceTable | None = None, wheel_layers: list[BodyLayer] = [], rail_layers: list[BodyLayer] = []) -> None:
        """The arguments of WheelRail, of both sides alike; right_rail and right_wheel are for a right side with
        different profiles, given as those of a left one. tolerance [-] is that of forces and moments over the
        load. Error for values out of range and profiles that do not fit the track or the wheelset."""
    def solve(self, *, vertical: float = ..., roll: float = ..., lateral: float = 0.0, yaw: float = 0.0, forward_velocity: float, lateral_velocity: float = 0.0, vertical_velocity: float = 0.0, roll_velocity: float = 0.0, pitch_velocity: float = ..., yaw_velocity: float = 0.0, curvature: float = 0.0, longitudinal: float = 0.0, pitch: float = 0.0, left_deflection_longitudinal: float = 0.0, left_deflection_lateral: float = 0.0, left_deflection_vertical: float = 0.0, left_deflection_roll: float = 0.0, left_deflection_yaw: float = 0.0, left_deflection_longitudinal_velocity: float = 0.0, left_deflection_lateral_velocity: float = 0.0, left_deflection_vertical_velocity: float = 0.0, left_deflection_roll_velocity: float = 0.0, left_deflection_pitch_velocity: float = 0.0, left_deflection_yaw_velocity: float = 0.0, left_deviation_lateral: float = 0.0, left_deviation_vertical: float = 0.0, left_deviation_roll: float = 0.0, left_deviation_lateral_velocity: float = 0.0, left_deviation_vertical_velocity: float = 0.0, left_deviation_roll_velocity: float = 0.0, right_deflection_longitudinal: float = 0.0, right_deflection_lateral: float = 0.0, right_deflection_vertical: float = 0.0, right_deflection_roll: float = 0.0, right_deflection_yaw: float = 0.0, right_deflection_longitudinal_velocity: float = 0.0, right_deflection_lateral_velocity: float = 0.0, right_deflection_vertical_velocity: float = 0.0, right_deflection_roll_velocity: float = 0.0, right_deflection_pitch_velocity: float = 0.0, right_deflection_yaw_velocity: float = 0.0, right_deviation_lateral: float = 0.0, right_deviation_vertical: float = 0.0, right_deviation_roll: float = 0.0, right_deviation_lateral_velocity: float = 0.0, right_deviation_vertical_velocity: float = 0.0, right_deviation_roll_velocity: float = 0.0, vertical_force: float = ..., roll_moment: float = ..., vertical_force_left: float = ..., vertical_force_right: float = ..., axle_torque: float = ...) -> WheelsetSolution:
        """The WheelsetSolution in a state, given by keywords, 0 where they are left out:
            lateral [m]: position of the wheelset's centre, to the left positive
            vertical [m]: height of the wheelset's centre above the nominal radius, upwards positive
            roll [rad]: roll of the wheelset; positive raises the left wheel
            yaw [rad]: yaw of the wheelset; positive turns to the left
            forward_velocity [m/s]: velocity of the wheelset's centre along the track
            lateral_velocity [m/s]: velocity of the wheelset's centre to the left
            vertical_velocity [m/s]: velocity of the wheelset's centre upwards
            roll_velocity [rad/s]: angular velocity of the wheelset about its x
            pitch_velocity [rad/s]: angular velocity of the wheelset about its axle; positive rolls forward
            yaw_velocity [rad/s]: angular velocity of the wheelset about its z
            curvature [1/m]: curvature of the track; positive in a curve to the left
            longitudinal [m]: position of the wheelset's centre along the track, or from a roller's top
            pitch [rad]: angle by which the wheelset has turned; positive rolls forward
            left_deflection_longitudinal [m]: motion of the wheel's centre against the axle, forward
            left_deflection_lateral [m]: the same to the left
            left_deflection_vertical [m]: the same upwards
            left_deflection_roll [rad]: rotation of the wheel against the axle about x
            left_deflection_yaw [rad]: the same about z
            left_deflection_longitudinal_velocity [m/s]: velocity of that motion, forward
            left_deflection_lateral_velocity [m/s]: the same to the left
            left_deflection_vertical_velocity [m/s]: the same upwards
            left_deflection_roll_velocity [rad/s]: angular velocity of that rotation about x
            left_deflection_pitch_velocity [rad/s]: the same about the axle
            left_deflection_yaw_velocity [rad/s]: the same about z
            left_deviation_lateral [m]: of the rail from its nominal position, to the left positive
            left_deviation_vertical [m]: the same upwards
            left_deviation_roll [rad]: rotation of the rail about x, right-handed
            left_deviation_lateral_velocity [m/s]: velocity of that deviation to the left
            left_deviation_vertical_velocity [m/s]: the same upwards
            left_deviation_roll_velocity [rad/s]: angular velocity of that rotation
            right_deflection_longitudinal [m]: motion of the wheel's centre against the axle, forward
            right_deflection_lateral [m]: the same to the left
            right_deflection_vertical [m]: the same upwards
            right_deflection_roll [rad]: rotation of the wheel against the axle about x
            right_deflection_yaw [rad]: the same about z
            right_deflection_longitudinal_velocity [m/s]: velocity of that motion, forward
            right_deflection_lateral_velocity [m/s]: the same to the left
            right_deflection_vertical_velocity [m/s]: the same upwards
            right_deflection_roll_velocity [rad/s]: angular velocity of that rotation about x
            right_deflection_pitch_velocity [rad/s]: the same about the axle
            right_deflection_yaw_velocity [rad/s]: the same about z
            right_deviation_lateral [m]: of the rail from its nominal position, to the left positive
            right_deviation_vertical [m]: the same upwards
            right_deviation_roll [rad]: rotation of the rail about x, right-handed
            right_deviation_lateral_velocity [m/s]: velocity of that deviation to the left
            right_deviation_vertical_velocity [m/s]: the same upwards
            right_deviation_roll_velocity [rad/s]: angular velocity of that rotation
        and the forces that are prescribed:
            vertical_force [N]: on both wheels together, upwards
            roll_moment [N m]: of the rails' forces on the wheelset about its centre, about the track's x
            vertical_force_left [N]: on the left wheel, upwards
            vertical_force_right [N]: on the right wheel, upwards
            axle_torque [N m]: that drives the wheelset forward; 0: it rolls freely
        Height and roll are found for vertical_force with roll_moment, or for both wheels' forces; without any,
        vertical must be given. The wheelset rolls freely unless pitch_velocity or axle_torque is given. No
        contact, forces that nothing gives and not converging are statuses. Error for unknown names."""
    def differentiate(self, *, vertical: float = ..., roll: float = ..., lateral: float = 0.0, yaw: float = 0.0, forward_velocity: float, lateral_velocity: float = 0.0, vertical_velocity: float = 0.0, roll_velocity: float = 0.0, pitch_velocity: float = ..., yaw_velocity: float = 0.0, curvature: float = 0.0, longitudinal: float = 0.0, pitch: float = 0.0, left_deflection_longitudinal: float = 0.0, left_deflection_lateral: float = 0.0, left_deflection_vertical: float = 0.0, left_deflection_roll: float = 0.0, left_deflection_yaw: float = 0.0, left_deflection_longitudinal_velocity: float = 0.0, left_deflection_lateral_velocity: float = 0.0, left_deflection_vertical_velocity: float = 0.0, left_deflection_roll_velocity: float = 0.0, left_deflection_pitch_velocity: float = 0.0, left_deflection_yaw_velocity: float = 0.0, left_deviation_lateral: float = 0.0, left_deviation_vertical: float = 0.0, left_deviation_roll: float = 0.0, left_deviation_lateral_velocity: float = 0.0, left_deviation_vertical_velocity: float = 0.0, left_deviation_roll_velocity: float = 0.0, right_deflection_longitudinal: float = 0.0, right_deflection_lateral: float = 0.0, right_deflection_vertical: float = 0.0, right_deflection_roll: float = 0.0, right_deflection_yaw: float = 0.0, right_deflection_longitudinal_velocity: float = 0.0, right_deflection_lateral_velocity: float = 0.0, right_deflection_vertical_velocity: float = 0.0, right_deflection_roll_velocity: float = 0.0, right_deflection_pitch_velocity: float = 0.0, right_deflection_yaw_velocity: float = 0.0, right_deviation_lateral: float = 0.0, right_deviation_vertical: float = 0.0, right_deviation_roll: float = 0.0, right_deviation_lateral_velocity: float = 0.0, right_deviation_vertical_velocity: float = 0.0, right_deviation_roll_velocity: float = 0.0, vertical_force: float = ..., roll_moment: float = ..., vertical_force_left: float = ..., vertical_force_right: float = ..., axle_torque: float = ...) -> WheelsetDerivatives:
        """The WheelsetDerivatives in a state given as for solve [SI units], with what is prescribed held. They hold
        where no patch comes or goes; those of what is not solved are zero."""

class WheelsetSolution:
    """Forces on a wheelset in track axes: x forward, y to the left, z up; and its wheels."""
    @property
    def force_x(self) -> float:
        """Force on the wheelset along the track [N]."""
    @property
    def force_y(self) -> float:
        """Force on the wheelset to the left [N]."""
    @property
    def force_z(self) -> float:
        """Force on the wheelset upwards [N]."""
    @property
    def moment_x(self) -> float:
        """Moment on the wheelset about its centre, about the track's x [N m]."""
    @property
    def moment_y(self) -> float:
        """The same about y [N m]."""
    @property
    def moment_z(self) -> float:
        """The same about z: positive turns it to the left [N m]."""
    @property
    def vertical(self) -> float:
        """Height of the wheelset's centre above the nominal radius: given, or found for the load [m]."""
    @property
    def roll(self) -> float:
        """Roll of the wheelset: given, or found for the load [rad]."""
    @property
    def pitch_velocity(self) -> float:
        """Angular velocity about the axle: given, or found for the torque [rad/s]."""
    @property
    def frictional_power(self) -> float:
        """Power lost to friction at both wheels [W]."""
    @property
    def residual(self) -> float:
        """Largest residual of load, roll moment and torque, relative [-]."""
    @property
    def iterations(self) -> float:
        """Iterations over height, roll and pitch velocity [-]."""
    @property
    def left(self) -> WheelRailSolution:
        """The left wheel's WheelRailSolution."""
    @property
    def right(self) -> WheelRailSolution:
        """The right wheel's WheelRailSolution."""
    @property
    def status(self) -> Status:
        """How the calculation ended."""
    @property
    def warnings(self) -> list[str]:
        """Reasons to doubt the result, as texts; those of both wheels, and a wheel that has lifted off."""
    @property
    def reason(self) -> str:
        """Why the status is not ok; else empty."""
    def to_dict(self) -> dict[str, Any]:
        """All fields [SI units] as a dict; arrays are copies."""

def build_info() -> dict[str, str]:
    """Identification of the library's build: a dict of version, commit, compiler and build_type [-]."""

def combine(body1: Material, body2: Material) -> CombinedMaterial:
    """Combines two bodies: 1/G = (1/G1 + 1/G2)/2 [1/Pa], nu/G = (nu1/G1 + nu2/G2)/2 [1/Pa], K/G =
    ((1 - 2 nu1)/G1 - (1 - 2 nu2)/G2)/4 [1/Pa] (Kalker 1990, section 1.6). Error if a modulus or
    Poisson's ratio is out of range or both bodies are rigid."""

def contact_filter(a: float, b: float, wavenumber_x: float, wavenumber_y: float = 0.0) -> float:
    """Normal force that a wave of roughness makes in a Hertzian contact at a given approach, over that of an endless
    one: sin(q)/q, q^2 = (k_x a)^2 + (k_y b)^2, with semi-axes [m] and wavenumbers [1/m]."""

def creepage_coefficients(a_over_b: float, poisson_ratio: float, coefficients: Literal["kalker", "computed"] = 'kalker') -> CreepageCoefficients:
    """The coefficients [-] for a/b [-] and Poisson's ratio [-] in [0, 0.5], from the table 'kalker'
    (Kalker 1990, table E.3) or 'computed' (accurate to 1e-4 from a/b = 0.05 to 20). Beyond a table
    they tend to the limits of slender ellipses."""

def fit_creep_curve(measured: str | os.PathLike[str], case_file: str | os.PathLike[str], model: str = '', start: str = '', huber: bool = False) -> dict[str, Any]:
    """Fits friction and layers to the measured creep curves of a CSV by the theory of a case file, both given by
    their paths, as `microslip fit` does [-]. Without `model` the simplest of the best is taken. Returns its
    document as a dict: rms, parameters with value and interval, curves, models; and case, the text of the
    fitted case file. Error for wrong files, unknown names, and points that no model can be fitted to."""

def friction_work(solution: ContactSolution) -> NDArray[numpy.float64]:
    """T-gamma per area of each element, the work of friction per metre rolled [N/m^2], shape (my, mx)."""

def gap_curvatures(rolling1: float, rolling2: float, transverse1: float, transverse2: float) -> GapCurvatures:
    """A = (1/rolling1 + 1/rolling2)/2, B = (1/transverse1 + 1/transverse2)/2 [1/m] from the radii [m]
    of bodies 1 and 2 in the plane of rolling and in the lateral plane: positive convex, negative
    concave, math.inf flat. Error for a radius that is zero or not a number, and unless A and B are
    positive."""

def hertz_from_approach(gap: GapCurvatures, material: CombinedMaterial, approach: float) -> HertzContact:
    """Contact from the approach [m] instead of the load."""

def hertz_from_ellipse(a: float, b: float, material: CombinedMaterial, normal_force: float) -> HertzContact:
    """Contact from the semi-axes [m] and the load [N]: finds the curvatures. Error for a/b outside [1e-5, 1e5]."""

def hertz_from_load(gap: GapCurvatures, material: CombinedMaterial, normal_force: float) -> HertzContact:
    """Ellipse, approach and pressure from curvatures [1/m] and load [N] (Johnson 1985, section 4.2).
    Relative error below 1e-12 for a/b from 1e-4 to 1e4. Error for load or material out of range and
    for A/B outside [1e-9, 1e9]."""

def hertzian_gap(gap: GapCurvatures, grid: ElementGrid) -> NDArray[numpy.float64]:
    """The undeformed distance h = A x^2 + B y^2 at the elements' centres, shape (my, mx) [m]."""

def inputs(kind: Literal["rail", "wheel"]) -> list:
    """The keys of case files of a kind, bodies, wheel or wheelset, those of files of sweeps, sweep, or the options of
    microslip conicity or table make, conicity or table: for each a dict of its section and key, unit,
    default (None: none; without a unit [-]), whether a case without it is refused, range and words that may stand there, whether
    it is a number of a wheel's state, and a text. The section body is that of body1 and body2, profile that
    of all sections with a profile."""

def layered_peaks(bodies: LayeredBodies, solution: ContactSolution) -> LayeredPeaks:
    """The LayeredPeaks [Pa] of LayeredBodies and a ContactSolution of them, to some 0.2 %. Error for a
    solution without pressures. Ctrl-C ends it."""

def line_contact_from_half_width(curvature: float, material: CombinedMaterial, half_width: float) -> LineContact:
    """Line contact from the half-width a [m]."""

def line_contact_from_load(curvature: float, material: CombinedMaterial, force_per_length: float) -> LineContact:
    """a = sqrt(4 R fn/(pi E*)), R = 1/(2A), from the curvature A [1/m] and fn [N/m] (Johnson 1985, section 4.2c)."""

def line_shakedown_limit(traction_coefficient: float) -> float:
    """Largest pressure over the yield strength in shear [-] up to which a line contact shakes down, with the
    traction coefficient [-]."""

def nadal_limit(angle: float, friction: float) -> float:
    """Nadal's limit of Y/Q [-] at the contact angle [rad] with friction [-]."""

def nip_of(problem: RollingProblem | EllipticContact, solution: ContactSolution, radius1: float, radius2: float) -> Nip:
    """The Nip of a solved RollingProblem of LayeredBodies, from its ContactSolution in steady rolling and
    the rollers' radii [m], positive convex, infinite flat. Error for others and without contact."""

def parse_case(text: str, name: str = 'case') -> RollingCase:
    """Reads TOML text, SI units; `name` is the file's name for messages [-]."""

def point_shakedown_limit(traction_coefficient: float) -> float:
    """Shakedown limit of a circular point contact [-]."""

def read_case(path: str | os.PathLike[str]) -> RollingCase:
    """Reads a case file in TOML: numbers in SI units, texts with a unit. Returns RollingCase. Error with
    file, line, key, value and allowed range for what is wrong, and with the nearest key for unknown
    ones [-]."""

def read_profile(path: str | os.PathLike[str], *, kind: Literal["rail", "wheel"] | None = None, format: Literal["simpack", "miniprof", "columns"] | None = None, unit: float | None = None, scale: float = 1.0, y_axis: Literal["field", "gauge"] | None = None, z_axis: Literal["up", "down"] | None = None, side: Literal["left", "right"] | None = None, columns: str = '', flange_thickness: float | None = None, section: int = 1, smoothing_length: float | None = None, trim: tuple[float, float] | None = None) -> Profile:
    """The Profile in a file: Simpack .prr .prw, MiniProf .ban .whl .mpt, columns of y and z, or slices .slcs .slcw of
    a rail that varies along the track and of a wheel that is not round. What the file does not
    say can be given: kind, format, unit (its length [m], e.g. 1e-3), the side to which y runs (y_axis), where z is
    positive (z_axis); what neither says is assumed, and the report names it. scale [-] enlarges, section chooses one
    of several profiles of a .mpt file, smoothing_length [m] and trim [m] are as in Profile. side, left or right, says
    on which side of the track a file lies whose y runs to the left on both; columns names those of a file, "z,y".
    S1002, 60E1, 54E1, cone-1:20 and cone-1:40 in place of a path, if there is no such file, are profiles of standards,
    wheels with a flange_thickness [m]."""

def remington_filter(radius: float, alpha: float, wavenumber: float) -> float:
    """Remington's contact filter of roughness [-]: radius of the contact [m], alpha [-], wavenumber [1/m]."""

def run_contact_input(path: str | os.PathLike[str]) -> ContactRun:
    """Runs the cases of an input file of the program CONTACT, modules 1 and 3, in their order, each with what
    the ones before it have left: `for case in run_contact_input(path)` gives ContactCase, totals in
    CONTACT's units [N], [mm], fields in SI units. Memory does not grow with the number of cases. A
    case that asks for something unsupported is refused with its reasons, and the others run. Error
    with file, line and field for what is against the grammar, when the case is reached."""

def shear_excess(solution: ContactSolution, shear_yield_strength: float) -> NDArray[numpy.float64]:
    """Traction of each element less the yield strength in shear [Pa], shape (my, mx)."""

def shore_a_of_young_modulus(young_modulus: float) -> float:
    """Shore A hardness [-] of rubber of a Young's modulus [Pa], the inverse of young_modulus_of_shore_a.
    Error for one whose hardness is not in [20, 90]."""

def solve_case(case: RollingCase) -> RollingContactResult:
    """Solves a RollingCase by the theory it asks for, and beside exact theory or table by FASTSIM2, SI
    units [-]. Ctrl-C ends it. Returns RollingContactResult; not converging is a status."""

def standard_solid(instantaneous: Material, creep: MaterialCreep) -> ViscoelasticMaterial:
    """The ViscoelasticMaterial [Pa] of a standard linear solid, from its Material and MaterialCreep.
    Error for constants out of range."""

def surface_fatigue_index(traction_coefficient: float, peak_pressure: float, shear_yield_strength: float) -> float:
    """Traction coefficient [-] less shear_yield_strength [Pa] over peak_pressure [Pa] (Ekberg et al. 2002)."""

def sweep(path: str | os.PathLike[str], output: str | os.PathLike[str], threads: int = 0, executor: Executor | None = None) -> SweepReport:
    """Solves the cases of a specification file, as `microslip sweep` does, and writes them to an HDF5 file, SI
    units [-]. What is finished is kept in OUTPUT.checkpoint: after an interruption the same call goes on with what
    is missing, and ends at once if nothing is. On threads, 0: one for each processor, or by a concurrent.futures.Executor, whose workers import
    microslip and read the files of the specification. The results are the same to the last bit. Returns
    SweepReport; Error for a wrong specification, another sweep's checkpoint, or an output that cannot be written."""

def sweep_statistics(path: str | os.PathLike[str], quantities: list[str] = [], quantiles: list[float] = [0.05, 0.5, 0.95], group_by: str = '') -> object:
    """What the cases in the result file of a sweep say of the distributions of their quantities, all or those that
    are named: a dict as `microslip statistics --json` prints it, SI units [-]. Below each quantity's path, ["contact"]["fx"], there are
    mean, mean_error, standard_deviation, least, largest, quantiles with the ends of their intervals of 95 %, and of cases for
    Sobol's indices sobol_first and sobol_total with their errors: a list with an entry for each group, the values of the key
    group_by, or one. Cases whose status is not ok are left out. Error for another file and names that it lacks."""

def traction_bound(bound: Literal["parabolic", "elliptic"], a: float, b: float, normal_force: float, friction: float, x: ArrayLike, y: ArrayLike) -> Any:
    """g(x, y) [Pa] for semi-axes a, b [m], normal force [N] and friction coefficient [-]; 0 outside
    the ellipse. 'parabolic': mu 2 Fn/(pi a b) (1 - (x/a)^2 - (y/b)^2); 'elliptic': mu 3
    Fn/(2 pi a b) times the root of the same. Both integrate to mu Fn. x, y [m] are numbers or
    arrays that broadcast, shape (...)."""

def viscoelastic(body1: Material, creep1: MaterialCreep, body2: Material, creep2: MaterialCreep, rolling_velocity: float, layer: InterfaceLayer | None = None) -> Bodies:
    """Two standard linear solids that roll steadily, as Bodies: their Material of instantaneous
    deformation and MaterialCreep, the velocity V [m/s], positive along +x, negative with direction
    'backward', and an InterfaceLayer between them or none. Error for constants out of range."""

def warning_texts() -> dict[str, str]:
    """Reasons to doubt results [-]: name and text of each warning, in the order of the bits of `warning_code`."""

def wear_depth(solution: ContactSolution, *, hardness: float, rolling_speed: float, wear_map: WearMap = WearMap(slow=0.00055, medium=0.0035, fast=0.00055, seizure=0.035, medium_from=0.2, medium_to=0.7, seizure_above=0.8)) -> NDArray[numpy.float64]:
    """Depth [m] that each element of a contact wears off a surface that runs through it once, by Archard's law,
    shape (my, mx); the sum over a row is what a passage leaves there. hardness [Pa], rolling_speed V [m/s]. Error
    for a solution without pressures."""

def wear_rate_r8t(t_gamma_per_area: float) -> float:
    """Mass that wheel steel R8T loses per metre rolled and square metre of contact [kg/m^3] with T-gamma per
    area [N/m^2] (Braghin et al. 2006)."""

def worn_area_british_rail(t_gamma: float, diameter: float) -> float:
    """Cross-section that a wheel of the diameter [m] loses per metre rolled [m], with T-gamma [N]
    (Pearce & Sherratt 1991)."""

def young_modulus_of_shore_a(hardness: float) -> float:
    """Young's modulus [Pa] of rubber of a Shore A hardness [-], 20 to 90, by Gent's relation (1958):
    an estimate, by which others are up to twice as stiff. Error out of that range."""
