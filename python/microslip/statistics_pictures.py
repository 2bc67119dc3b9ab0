"""Pictures of the statistics of a sweep: quantiles, over a parameter as bands, and which parameters results scatter by."""

import numpy as np

from microslip.picture_style import INK, INK2, INK3, LINE, heading, new_figure, open_axes, put_title, unit_for
from microslip.sweep_picture import FORCES

MOST_QUANTITIES = 4


def statistics_pictures(result):
    """Return `quantiles.png`, and `sensitivities.png` of cases that were made for Sobol's indices."""
    quantities = chosen_quantities(result)
    figures = {"quantiles.png": quantiles_picture(result, quantities)}
    if any(f"{name}/sobol_first" in result for name in quantities):
        figures["sensitivities.png"] = sensitivities_picture(result, quantities)
    return figures


def chosen_quantities(result):
    """The forces of the file, or else its first quantities."""
    names = result.attribute("quantities").split("\n")
    forces = [name for name in FORCES if name in names]
    return (forces + [name for name in names if name not in forces])[:MOST_QUANTITIES]


def bands(result, name):
    """Quantiles of a quantity by group and probability, with the probabilities."""
    return result.array(f"{name}/quantiles", dimensions=2, finite=False), result.array("probabilities")


def quantiles_picture(result, quantities):
    """A panel for each quantity: bands over the numbers of a parameter that groups the cases, bars for its words, or the
    quantiles of all cases."""
    has_bands = "groups" in result and result.is_number("groups")
    height = 2.2 if has_bands else 0.9 + 0.35 * result.shape("cases")[0]
    figure = new_figure(7.0, 0.8 + height * len(quantities))
    panels = np.atleast_1d(figure.subplots(len(quantities), sharex=has_bands))
    for axes, name in zip(panels, quantities):
        open_axes(axes)
        (draw_bands if has_bands else draw_bars)(axes, result, name)
    if has_bands:
        unit = result.unit("groups")
        panels[-1].set_xlabel(result.attribute("group_by") + (f" [{unit}]" if unit != "-" else ""))
    put_title(figure, heading("Quantiles", result))
    return figure


def draw_bands(axes, result, name):
    """Shade between the quantiles of p and 1 - p, darker inwards."""
    at = result.array("groups")
    values, probabilities = bands(result, name)
    factor, unit = unit_for(np.nanmax(np.abs(values), initial=0), result.unit(f"{name}/quantiles"))
    low = [k for k, p in enumerate(probabilities) if p < 0.5 and np.isclose(1 - p, probabilities).any()]
    for rank, k in enumerate(sorted(low, key=lambda k: probabilities[k])):
        other = int(np.argmin(np.abs(probabilities - (1 - probabilities[k]))))
        axes.fill_between(at, factor * values[:, k], factor * values[:, other], color=INK3, alpha=0.2 + 0.2 * rank, linewidth=0,
                          label=f"{100 * probabilities[k]:.3g} to {100 * probabilities[other]:.3g} %")
    for k, p in enumerate(probabilities):
        if np.isclose(p, 0.5):
            axes.plot(at, factor * values[:, k], color=INK, linewidth=2, label="median")
    axes.plot(at, factor * result.array(f"{name}/mean", finite=False), color=INK, linewidth=1.2, linestyle="--", label="mean")
    axes.set_ylabel(f"{name} [{unit}]")
    axes.legend(loc="center left", bbox_to_anchor=(1.01, 0.5), fontsize="small")


def draw_bars(axes, result, name):
    """A line from the first to the last quantile of each group, with a mark at each one and its interval of 95 %."""
    values, probabilities = bands(result, name)
    low, high = (result.array(f"{name}/quantiles_{end}", dimensions=2, finite=False) for end in ("low", "high"))
    factor, unit = unit_for(np.nanmax(np.abs(values), initial=0), result.unit(f"{name}/quantiles"))
    words = result.text("groups").split("\n") if "groups" in result else ["all cases"]
    for group, word in enumerate(words):
        axes.plot(factor * values[group, [0, -1]], [group, group], color=LINE, linewidth=6, solid_capstyle="butt")
        for k, p in enumerate(probabilities):
            axes.plot(factor * np.array([low[group, k], high[group, k]]), [group, group], color=INK2, linewidth=6,
                      solid_capstyle="butt")
            axes.annotate(f"{100 * p:.3g} %", (factor * values[group, k], group), textcoords="offset points", xytext=(0, 9),
                          ha="center", fontsize="small")
        axes.plot(factor * result.array(f"{name}/mean", finite=False)[group], group, marker="D", color=INK, markerfacecolor="white", linestyle="none",
                  label="mean" if group == 0 else None)
    axes.set_yticks(range(len(words)), words)
    axes.set_ylim(-0.7, len(words) - 0.3)
    axes.set_xlabel(f"{name} [{unit}], the intervals of 95 % dark")
    axes.legend(loc="center left", bbox_to_anchor=(1.01, 0.5), fontsize="small")


def sensitivities_picture(result, quantities):
    """A tornado for each quantity: the shares of its variance that each parameter has alone and with all others, the
    largest above."""
    names = result.attribute("parameters").split("\n")
    figure = new_figure(7.0, 1.2 + len(quantities) * (0.6 + 0.32 * len(names)))
    panels = np.atleast_1d(figure.subplots(len(quantities), sharex=True))
    for axes, quantity in zip(panels, quantities):
        open_axes(axes)
        first, first_error, total, total_error = (result.array(f"{quantity}/sobol_{one}", dimensions=2, finite=False)[0]
                                                  for one in ("first", "first_error", "total", "total_error"))
        order = np.argsort(np.nan_to_num(total))
        at = np.arange(len(names))
        axes.barh(at + 0.2, first[order], 0.36, xerr=1.96 * first_error[order], color=INK2, label="alone", error_kw={"ecolor": INK})
        axes.barh(at - 0.2, total[order], 0.36, xerr=1.96 * total_error[order], color=LINE, label="with all others",
                  error_kw={"ecolor": INK})
        axes.set_yticks(at, [names[k] for k in order])
        axes.set_title(quantity)
    panels[-1].set_xlabel("share of the variance, with intervals of 95 %")
    panels[0].legend(loc="lower right", fontsize="small")
    put_title(figure, heading("What the scatter comes from", result))
    return figure
