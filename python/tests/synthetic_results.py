"""Result files to draw, made with a small FASTSIM (backward Euler, parabolic bound) and closed forms."""

import h5py
import numpy as np

SPEED = 2.0
G, CIRCLE_COEFFICIENTS = 82e9, (4.12, 3.67, 1.47)


def fastsim(a, b, mx, my, creepage, limit, backward=False):
    """Fields and totals on the ellipse's grid; `limit` is mu Fn. The coefficients are those of a circle."""
    xi, eta, phi = creepage
    c11, c22, c23 = CIRCLE_COEFFICIENTS
    l1, l2, l3 = 8 * a / (3 * c11 * G), 8 * a / (3 * c22 * G), np.pi * a * np.sqrt(a / b) / (4 * c23 * G)
    dy = 2 * b / my
    y = np.repeat((-b + (np.arange(my) + 0.5) * dy)[:, None], mx, axis=1)
    edge = a * np.sqrt(1 - (y[:, :1] / b) ** 2)
    dx = 2 * edge / mx
    x = (edge - (np.arange(mx) + 0.5) * dx) * (-1 if backward else 1)
    bound = 2 * limit / (np.pi * a * b) * (1 - (x / a) ** 2 - (y / b) ** 2)
    rate = np.array([xi / l1 - phi * y / l3, eta / l2 + phi * x / l3])
    p, slip, state = np.zeros((2, my, mx)), np.zeros((2, my, mx)), np.ones((my, mx), dtype=np.uint8)
    before = np.zeros((2, my))
    for i in range(mx):
        trial = before - rate[:, :, i] * dx[:, 0]
        size = np.hypot(*trial)
        sliding = size > bound[:, i]
        p[:, :, i] = trial * np.where(sliding, bound[:, i] / np.where(sliding, size, 1), 1)
        slip[:, :, i] = l1 * (p[:, :, i] - trial) / dx[:, 0]
        state[:, i] += sliding
        before = p[:, :, i]
    area = np.repeat(dx * dy, mx, axis=1)
    area *= limit / np.sum(area * bound)
    return {"x": x, "y": y, "area": area, "bound": bound, "px": p[0], "py": p[1], "sx": slip[0], "sy": slip[1],
            "state": state}


def totals(fields):
    """Forces, moment and areas of fields."""
    area, slipping = fields["area"], fields["state"] == 2
    return {"fx": np.sum(area * fields["px"]), "fy": np.sum(area * fields["py"]),
            "mz": np.sum(area * (fields["x"] * fields["py"] - fields["y"] * fields["px"])),
            "adhesion_area": np.sum(area[~slipping]), "slip_area": np.sum(area[slipping]),
            "frictional_power": -SPEED * np.sum(area * (fields["px"] * fields["sx"] + fields["py"] * fields["sy"]))}


def write_rolling_contact(path, a=6e-3, b=4e-3, mx=10, my=10, creepage=(0.001, 0.0005, 0.2), theories=("fastsim2",),
                          backward=False, varied="creepage_longitudinal", load=80e3, friction=0.3):
    """A file of kind rolling_contact. Later theories get a finer grid, so that they differ a little."""
    names = ["creepage_longitudinal", "creepage_lateral", "spin"]
    limit = friction * load
    with h5py.File(path, "w") as file:
        file.attrs.update({"kind": "rolling_contact", "title": "wheel on rail", "version": "0.1.0", "commit": "abc"})
        inputs = {"load/normal_force": load, "friction/coefficient": friction,
                  **{f"motion/{name}": value for name, value in zip(names, creepage)},
                  "motion/direction": "backward" if backward else "forward", "solution/theory": theories[0],
                  "motion/rolling_speed": SPEED}
        for name, value in inputs.items():
            file[f"/inputs/{name}"] = value
        file["/hertz/a"], file["/hertz/b"] = a, b
        for finer, theory in enumerate(theories, start=1):
            fields = fastsim(a, b, finer * mx, finer * my, creepage, limit, backward)
            for name, value in fields.items():
                file[f"/{theory}/fields/{name}"] = value
            for name, value in totals(fields).items():
                file[f"/{theory}/{name}"] = value
        file.create_group("creep_curve").attrs["variable"] = varied
        file["/creep_curve/limit"] = limit
        for name, value in zip(names, creepage):
            file[f"/creep_curve/{name}"] = value
        for finer, theory in enumerate(theories, start=1):
            grid = (a, b, finer * mx, finer * my)
            write_creep_curve(file, theory, names.index(varied), grid, creepage, limit, backward)


def write_creep_curve(file, theory, index, grid, creepage, limit, backward):
    """The curve through the case, twice as far as the case and on both sides."""
    def force(value):
        point = [value if i == index else other for i, other in enumerate(creepage)]
        return totals(fastsim(*grid, point, limit, backward))

    far = 4 * abs(creepage[index]) or 0.005
    value = np.linspace(-far / 4, far, 21)
    curve = [force(one) for one in value]
    file[f"/creep_curve/{theory}/value"] = value
    for name in ("fx", "fy", "mz"):
        file[f"/creep_curve/{theory}/{name}"] = [point[name] for point in curve]


def write_history(file, steps=12):
    """Forces that grow towards a steady state, for a transient case."""
    distance = 1e-3 * np.arange(1, steps + 1)
    for name, end in (("distance", None), ("fx", -2e4), ("fy", 1e4), ("creepage_longitudinal", 1e-3), ("creepage_lateral", 0.0)):
        file[f"/exact/history/{name}"] = distance if end is None else end * (1 - np.exp(-distance / 4e-3))


def write_contact_run(path):
    """A file of kind contact_run: a case without elements and one with two patches, of 5 x 4 elements in contact."""
    mx, my = 7, 6
    numbers, patches, stored = [1, 2, 2], [0, 1, 2], [0, 20, 20]
    with h5py.File(path, "w") as file:
        file.attrs.update({"kind": "contact_run", "title": "A run", "version": "0.1.0", "commit": "abc"})
        cases = {"number": numbers, "patch": patches, "stored_elements": stored, "first_element": [0, 0, 20], "mx": [mx] * 3,
                 "my": [my] * 3, "x0": [-3e-3] * 3, "y0": [-2.5e-3] * 3, "dx": [1e-3] * 3, "dy": [1e-3] * 3,
                 "normal_force": [np.nan, 1e4, 2e4], "fx": [np.nan, -1e3, 2e3], "fy": [np.nan, 0.0, 5e2]}
        for name, values in cases.items():
            file[f"/cases/{name}"] = values
        rows, columns = np.meshgrid(np.arange(1, 5), np.arange(1, 6), indexing="ij")
        file["/elements/index"] = np.tile((rows * mx + columns).ravel(), 2)
        file["/elements/state"] = np.tile(np.where(columns > 3, 1, 2).ravel(), 2)
        for name, scale in (("pressure", 1e9), ("bound", 3e8), ("px", -2e8), ("py", 1e8), ("sx", 1e-3), ("sy", 0.0)):
            file[f"/elements/{name}"] = scale * np.concatenate([np.ones(20), 2 * np.ones(20)])


def write_fastsim2_table1(path, cases=400):
    """A file of kind fastsim2-table1; the errors grow linearly from 0, those of each variant to another largest one."""
    with h5py.File(path, "w") as file:
        file.attrs.update({"kind": "fastsim2-table1", "title": "Table 1", "version": "0.1.0", "commit": "abc"})
        for part, flexibility in enumerate(("three", "one", "blended"), start=1):
            for bound in ("parabolic", "elliptic"):
                for force, largest in (("fx", 0.05 * part), ("fy", 0.08 * part)):
                    variant = f"{flexibility}_{bound}"
                    file[f"/{variant}/error_{force}"] = largest * np.arange(1, cases + 1) / cases
                    for percent in (80, 95):
                        file[f"/{variant}/p{percent}_{force}"] = largest * percent / 100
                        if flexibility != "blended":
                            file[f"/published/{variant}/p{percent}_{force}"] = largest * percent / 100


def write_models(path):
    """A file of kind models: two panels, six models, two of them without the second error."""
    with h5py.File(path, "w") as file:
        file.attrs.update({"kind": "models", "title": "Models", "version": "0.1.0", "commit": "abc"})
        for panel in (1, 2):
            file[f"/panels/{panel}/title"] = f"error {panel}"
            file[f"/panels/{panel}/series"] = "rms\nlargest"
            file[f"/panels/{panel}/models"] = "one\ntwo\nthree\nfour\nfive\nsix"
            file[f"/panels/{panel}/errors"] = 2 * [[1e-3, 2e-3], [1e-2, np.nan], [0.1, 0.5]]


GRIDS = (5, 10, 20, 40, 80, 160)
RMS = {"fastsim": (0.4, 1), "fastsim_half_step": (0.2, 1), "fastsim2": (0.13, 2)}


def write_fastsim2_table2(path, cases=400):
    """A file of kind fastsim2-table2 with errors that fall exactly as C/n (FASTSIM) and C/n^2 (FASTSIM2)."""
    with h5py.File(path, "w") as file:
        file.attrs.update({"kind": "fastsim2-table2", "title": "Table 2", "version": "0.1.0", "commit": "abc"})
        file["grids"] = np.array(GRIDS, dtype=np.int32)
        shape = np.clip(np.linspace(-1, 2.2, cases), 0, None) ** 2
        for name, (constant, order) in RMS.items():
            scale = constant / np.array(GRIDS, dtype=float) ** order
            errors = scale[:, None] * shape / np.sqrt(np.mean(shape**2))
            file[f"/{name}/error_fy"] = errors
            for force, part in (("fx", 0.5), ("fy", 1.0)):
                file[f"/{name}/rms_{force}"] = part * scale
                for percent in (80, 95):
                    file[f"/{name}/p{percent}_{force}"] = part * np.quantile(errors, percent / 100, axis=1)
                if name != "fastsim_half_step":
                    file[f"/published/{name}/rms_{force}"] = 1.1 * part * scale


def write_model_problem(path, mx=10):
    """A file of kind model-problem: case 1 of FASTSIM2's paper in all three groups, each strategy a little off."""
    with h5py.File(path, "w") as file:
        file.attrs.update({"kind": "model-problem", "title": "model problem", "version": "0.1.0", "commit": "abc"})
        x = np.linspace(0, 1, 401)
        coarse = np.linspace(0, 1, mx + 1)
        for case in ("case1", "case2", "case3"):
            file[f"/{case}/x_exact"], file[f"/{case}/u_max"] = x, 4 * x * (1 - x)
            file[f"/{case}/u_exact"], file[f"/{case}/s_exact"] = model_problem(x)
            for off, strategy in ((0.1, "backward_euler"), (0.05, "theta_method"), (0, "tracked")):
                u, s = model_problem(coarse)
                file[f"/{case}/{strategy}/x"] = coarse
                file[f"/{case}/{strategy}/u"], file[f"/{case}/{strategy}/s"] = u * (1 - off), s + 3 * off


def model_problem(x):
    """Displacement and slip of case 1 (F22)."""
    adhesion = x <= 0.39
    return np.where(adhesion, 0.1 * x + 6 * x**2, 4 * x * (1 - x)), np.where(adhesion, 0, 3.9 - 20 * x)
