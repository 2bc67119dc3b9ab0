"""How a contact's forces follow creepages and a load that oscillate: sizes and lags over the wavelength along the track."""

import numpy as np

from microslip.picture_style import (ACROSS, ALONG, INK2, INK3, RED, heading, new_figure, open_axes,
                                     put_title)

# Response: what it is in the legend, colour, dashes.
CREEP_FORCES = {
    "fx_by_creepage_longitudinal": (r"$F_x$ by longitudinal creepage $\xi$", ALONG, "-"),
    "fy_by_creepage_lateral": (r"$F_y$ by lateral creepage $\eta$", ACROSS, "-"),
    "fy_by_spin": (r"$F_y$ by spin $\phi$", RED, "--"),
}
BY_LOAD = {
    "fx_by_normal_force": (r"$F_x$ by normal force $F_n$", ALONG, ":"),
    "fy_by_normal_force": (r"$F_y$ by normal force $F_n$", ACROSS, ":"),
}
NOTHING = 1e-6  # of the largest response of a force: no response


def frequency_response_pictures(result):
    """The pictures of a result file of kind frequency_response, by file name: of each patch of a wheel, or of the one contact."""
    if "/contact_filter" in result:
        return {"frequency_response.png": frequency_response_picture(result)}
    pictures, patch = {}, 1
    while f"/patch{patch}/contact_filter" in result:
        pictures[f"frequency_response_patch{patch}.png"] = frequency_response_picture(result, f"/patch{patch}")
        patch += 1
    return pictures


def frequency_response_picture(result, group=""):
    """Sizes in parts of those of endless waves, with the contact filter, and lags below."""
    wavelength, frequency = 1e3 * result.array("/wavelength"), result.array(f"{group}/frequency")
    figure = new_figure(7.0, 6.6)
    put_title(figure, heading("Response to oscillations", result))
    size, lag = figure.subplots(2, 1, sharex=True, height_ratios=(1.3, 1))
    shown = {**CREEP_FORCES, **BY_LOAD}
    for name, (label, colour, dashes) in shown.items():
        ratio = relative_response(result, group, name, shown)
        if ratio is None:
            continue
        size.plot(wavelength, np.abs(ratio), dashes, color=colour, linewidth=1.8, label=label)
        lag.plot(wavelength, np.degrees(-np.unwrap(np.angle(ratio)[::-1])[::-1]), dashes, color=colour, linewidth=1.8)
    size.plot(wavelength, np.abs(result.array(f"{group}/contact_filter")), color=INK3, linewidth=1.2, label="contact filter of roughness")
    if f"{group}/remington_filter" in result:
        size.plot(wavelength, result.array(f"{group}/remington_filter"), "--", color=INK3, linewidth=1.2, label=r"Remington's, $\alpha = 1$")
    for axes in (size, lag):
        open_axes(axes)
        axes.set_xscale("log")
        axes.axhline(0, color=INK2, linewidth=0.8)
    size.set_ylim(bottom=0)
    size.set_ylabel("size, of that of endless waves [-]")
    lag.set_ylabel("lag [deg]")
    lag.set_xlabel("wavelength along the track [mm]")
    lag.legend(*size.get_legend_handles_labels(), loc="upper left", bbox_to_anchor=(-0.01, -0.24), ncols=2, fontsize="small", handlelength=2.6)
    put_frequencies(size, wavelength, frequency)
    return figure


def relative_response(result, group, name, all_names):
    """The complex response over that of endless waves; none where it is nothing beside the force's others by the same cause."""
    still = result.number(f"{group}/quasistatic/{name}")
    cause = name.split("_by_")[1]
    largest = max(abs(result.number(f"{group}/quasistatic/{other}")) for other in all_names if other.endswith(cause))
    if not abs(still) > NOTHING * largest:
        return None
    real, imaginary = result.arrays([f"{group}/{name}_real", f"{group}/{name}_imaginary"])
    return (real + 1j * imaginary) / still


def put_frequencies(axes, wavelength, frequency):
    """A second axis on top."""
    speed = float(frequency[0] * wavelength[0])
    over = axes.secondary_xaxis("top", functions=(lambda x: speed / np.maximum(x, 1e-12), lambda f: speed / np.maximum(f, 1e-12)))
    over.set_xlabel(f"frequency [Hz] at {3.6e-3 * speed:.4g} km/h")
