"""S1002 on 60E1, for tests."""

from pathlib import Path

import microslip

PROFILES = Path(__file__).resolve().parents[2] / "examples" / "profiles"


def s1002_on_60e1(made, **options):
    """A WheelRail or WheelsetOnTrack of these profiles, with other options."""
    given = {"track": microslip.Track(gauge=1.435, cant=0.05), "rail": microslip.read_profile(PROFILES / "60e1.prr"),
             "wheelset": microslip.Wheelset(nominal_radius=0.46, flange_back_distance=1.36),
             "wheel": microslip.read_profile(PROFILES / "s1002.prw")}
    return made(**{**given, **options})
