"""Draws the pictures of docs/images with what the programs make today.

    images.py --list               prints the pictures with their commands
    images.py [WORD...]            draws into docs/images those with one of the words in name or command (none: all)
    images.py --check [WORD...]    draws them elsewhere and names those of docs/images that look otherwise; exit code 1
                                   if there are any, 77 if matplotlib is another one than theirs
    images.py --quick ...          leaves out what takes more than half a minute

Pictures are compared by what is seen from afar: the root mean square of differences of grey levels of blocks of pixels.
"""

import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

import matplotlib
import matplotlib.image
import numpy as np

ROOT = Path(__file__).resolve().parents[2]
IMAGES = ROOT / "docs" / "images"
# The pictures that are there were drawn by it; others break lines and set letters otherwise.
MATPLOTLIB = "3.6"
# Grey levels are 0 to 1; blocks of so many pixels.
TOLERANCE, BLOCK = 0.012, 4


@dataclass(frozen=True, eq=False)
class Source:
    """Source of pictures: a command that writes them to {folder}, and which picture of docs/images is which of these."""

    command: str
    pictures: dict
    slow: bool = False


def study(name, *pictures, slow=False):
    """A study of `microslip validate`."""
    return Source(f"microslip validate {name} -o {{folder}}", {picture: picture for picture in pictures}, slow)


def gallery():
    """All that the page of the gallery shows, by the commands that it names, one after the other in a folder with the examples."""
    page = (ROOT / "docs" / "gallery.md").read_text()
    commands = "\n".join(re.findall(r"(?<!-->\n)```sh\n(.*?)\n```", page, re.DOTALL))
    pictures = {image: path for path, image in re.findall(r"<!-- picture: (\S+) -->\n!\[[^]]*\]\(images/(\S+)\)", page)}
    return Source(f"cp -r examples {{folder}} && cd {{folder}} && set -e\n{commands}", pictures, slow=True)


SOURCES = (
    Source("microslip solve examples/hertzian_contact.toml -o {folder} && "
           "microslip plot {folder}/result.h5 --cut 0 --creep-curves 0,0.4,0.8 --stresses 0",
           {name: name for name in ("tractions.png", "areas.png", "creep_curve.png", "cut.png", "creep_curves.png", "stresses.png")}),
    Source("microslip solve examples/rubber_roller.toml -o {folder}", {"nip.png": "nip.png"}),
    Source("microslip solve examples/wheel_on_rail.toml -o {folder}",
           {name: name for name in ("gap.png", "patches.png", "rail_head.png", "tractions_on_profiles.png")}),
    Source("microslip solve examples/lateral_sweep.toml -o {folder}",
           {"contact_points.png": "contact_points.png", "wheel_forces.png": "forces.png"}),
    Source("microslip fit examples/creep_curve.csv --case examples/creep_curve.toml -o {folder}",
           {"creep_curve_fit.png": "creep_curve_fit.png"}),
    Source("microslip conicity examples/profiles/s1002.prw examples/profiles/60e1.prr --cant 0.025 -o {folder}",
           {"conicity.png": "conicity.png", "wheelset_contact_points.png": "contact_points.png"}),
    Source("build/release/bin/wheelset {folder} && /usr/bin/python3 examples/wheelset/plot.py {folder}",
           {"wheelset.png": "wheelset.png"}),
    Source("build/release/bin/wheelset_on_profiles examples/profiles {folder} && /usr/bin/python3 examples/wheelset/plot.py {folder}",
           {"wheelset_on_profiles.png": "wheelset.png"}, slow=True),
    Source("build/release/bin/vehicle examples/profiles {folder} && /usr/bin/python3 examples/vehicle/plot.py {folder}",
           {"vehicle.png": "vehicle.png"}, slow=True),
    Source("/usr/bin/python3 examples/wear/wear.py {folder} && /usr/bin/python3 examples/wear/plot.py {folder}",
           {"wear.png": "wear.png"}, slow=True),
    Source("cmake --install build/release --prefix {folder}/microslip --component libraries && "
           "MICROSLIP_CREEP_TABLE=$PWD/python/microslip/hertz.creep "
           "sh examples/adapters/dytsi/critical_speeds.sh ../shared/peers/dytsi {folder}/microslip {folder}",
           {"critical_speed.png": "critical_speed.png"}, slow=True),
    Source("tools/explorer && tools/screens {folder}", {"explorer.png": "wheel_on_rail_1400.png"}, slow=True),
    study("model-problem", "model_problem.png"),
    study("fastsim2-table1", "fastsim2_figure3.png", slow=True),
    study("fastsim2-table2", "fastsim2_figure4.png", "fastsim2_figure5.png"),
    study("models", "models.png", slow=True),
    study("normal-models", "normal_models.png", slow=True),
    study("subsurface", "subsurface.png", slow=True),
    study("refinement", "refinement_figure1.png", "refinement_figures_2_6.png", "refinement_figures_3_4.png",
          "refinement_figure5.png", "refinement_figures_7_8.png", slow=True),
    gallery(),
)


def draw(source, folder):
    """The pictures of a source in a folder, by their names in docs/images."""
    environment = {**os.environ, "PATH": f"{ROOT}/build/release/bin:/usr/bin:{os.environ['PATH']}"}
    done = subprocess.run(["bash", "-c", source.command.format(folder=folder)], cwd=ROOT, env=environment, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    if done.returncode not in (0, 1):
        raise SystemExit(f"{source.command}: exit code {done.returncode}\n{done.stdout}")
    return {image: folder / name for image, name in source.pictures.items()}


def grey_blocks(path):
    """Grey levels of blocks of pixels."""
    pixels = matplotlib.image.imread(path)[..., :3].mean(axis=2)
    rows, columns = (size // BLOCK for size in pixels.shape)
    return pixels[:rows * BLOCK, :columns * BLOCK].reshape(rows, BLOCK, columns, BLOCK).mean(axis=(1, 3))


def difference(one, other):
    """The root mean square of differences of grey levels; infinite if the sizes differ by more than a block."""
    first, second = grey_blocks(one), grey_blocks(other)
    if max(abs(a - b) for a, b in zip(first.shape, second.shape)) > 1:
        return np.inf
    rows, columns = (min(sizes) for sizes in zip(first.shape, second.shape))
    return float(np.sqrt(np.mean((first[:rows, :columns] - second[:rows, :columns]) ** 2)))


def is_as_drawn(image, path):
    """Returns whether a picture of docs/images looks as one that is drawn today; says so if not."""
    if not (IMAGES / image).exists():
        print(f"docs/images/{image}: missing")
        return False
    away = difference(IMAGES / image, path)
    if away > TOLERANCE:
        print(f"docs/images/{image}: looks otherwise today, by {away:.3f}")
    return away <= TOLERANCE


def main(arguments):
    """The command line."""
    parser = argparse.ArgumentParser(description="Draws the pictures of docs/images with what the programs make today.")
    parser.add_argument("words", nargs="*", metavar="WORD", help="only pictures or commands with one of these in them")
    parser.add_argument("--list", action="store_true", help="print the pictures with their commands")
    parser.add_argument("--check", action="store_true", help="compare and write nothing")
    parser.add_argument("--quick", action="store_true", help="leave out what takes more than half a minute")
    asked = parser.parse_args(arguments)
    texts = {source: " ".join([source.command, *source.pictures]) for source in SOURCES}
    chosen = [source for source in SOURCES if (not asked.words or any(word in texts[source] for word in asked.words))
              and not (asked.quick and source.slow)]
    if asked.list:
        for source in chosen:
            print(f"{', '.join(source.pictures)}: {source.command.format(folder='FOLDER')}")
        return 0
    if asked.check and not matplotlib.__version__.startswith(f"{MATPLOTLIB}."):
        print(f"skipped: docs/images is drawn by matplotlib {MATPLOTLIB}, this is {matplotlib.__version__}")
        return 77
    right = True
    for source in chosen:
        print(f"{source.command.format(folder='FOLDER')} ...", flush=True)
        with tempfile.TemporaryDirectory() as folder:
            for image, path in draw(source, Path(folder)).items():
                if asked.check:
                    right &= is_as_drawn(image, path)
                else:
                    shutil.copyfile(path, IMAGES / image)
    return 0 if right else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
